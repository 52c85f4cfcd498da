//! Closed loops against the same mechanisms with open loops, held together by multipliers.

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use super::{is_thorough, model, near, numbers};
use crate::dynamics::{Dynamics, derived};
use crate::expr::{Expr, Graph, Symbol, SymbolKind};
use crate::form::{Forms, drive_forces, loop_wrenches};
use crate::model::{Model, Poses};
use crate::screw::Vec3;

/// Scenes with an output `gaps` that lists the closure errors of their loops.
pub(super) const SCENES: [&str; 12] = [
    // forces of every kind on dependent bodies, in parameters
    "pub FourBar {
        params { a: m = 0.2, b: m = 0.5, c: m = 0.4, k: N m = 3 }
        gravity: [1, -9.81, 0],
        body crank on ground { mass: 0.5, com: [0.1, 0.02, 0], inertia: 0.002, joint: revolute(z), \
            coordinate: q1 near 0.8, friction: 0.3 }
        body coupler on crank { mass: 1.1, com: [0.2, 0.1, 0], inertia: 0.02,
            joint: revolute(z) at [a, 0, 0], coordinate: q2 depends near -0.3, spring: (k, 0.4), friction: 0.2 }
        body rocker on ground { mass: 0.9, com: [0.2, 0.1, 0], inertia: 0.01,
            joint: revolute(-z) at [0.6, 0.1, 0], coordinate: q3 depends near -1.6, torque: 0.4*sin(q) - 0.1*qd^3 }
        close coupler at [b, 0.05, 0] to rocker at [c, -0.03, 0]: revolute(z),
        point p on coupler at [b, 0.05, 0], point r on rocker at [c, -0.03, 0], point nail on ground at [0.3, 1, 0],
        force q2: 0.3*cos(q2 + q3), force on p: [0.2, q3, 0] in coupler,
        spring between p and nail: (20, 0.3), damper between r and nail: 0.7, potential: 0.2*(q2 - q3)^2,
        output gaps: [p.x - r.x, p.y - r.y],
    }",
    // an inclined slider beside the crank, angles from ground
    "pub SliderCrank {
        gravity: [0, -9.81, 0],
        body crank on ground { mass: 0.36, com: [0.08, 0, 0], inertia: 0.0007, joint: revolute(z), \
            coordinate: q1 near 0.8 }
        body rod on crank { mass: 0.15, com: [0.15, 0.01, 0], inertia: 0.0012, joint: revolute(z) at [0.15, 0, 0], \
            coordinate: q2 absolute depends near -0.4 }
        body piston on ground { mass: 0.07, com: [0.01, 0, 0], inertia: 0.01, \
            joint: prismatic([4, 1, 0]) at [0, -0.02, 0], coordinate: q3 depends near 0.4, friction: 1.5 }
        close rod at [0.3, 0, 0] to piston: revolute(z),
        point p on rod at [0.3, 0, 0], point r on piston,
        output gaps: [p.x - r.x, p.y - r.y],
    }",
    // the slider moves along a rotating arm
    "pub Whitworth {
        gravity: [0, -9.81, 0],
        body crank on ground { mass: 0.36, com: [0.08, 0, 0], inertia: 0.0007, joint: revolute(z), \
            coordinate: q1 near 0.8 }
        body arm on ground { mass: 1, com: [0.2, 0.1, 0], inertia: 0.03, joint: revolute(z) at [0, -0.5, 0], \
            coordinate: q2 depends near 1.4, friction: 0.1 }
        body block on arm { mass: 0.3, com: [0.01, 0.02, 0], inertia: 0.01, joint: prismatic(x) at [0.1, 0.03, 0], \
            coordinate: q3 depends near 0.4 }
        close crank at [0.2, 0, 0] to block at [0.02, 0.01, 0]: revolute(z),
        point p on crank at [0.2, 0, 0], point r on block at [0.02, 0.01, 0],
        output gaps: [p.x - r.x, p.y - r.y],
    }",
    // one crank is driven
    "pub FiveBar {
        gravity: [0, -9.81, 0],
        body left on ground { mass: 0.4, com: [0.12, 0, 0], inertia: 0.002, joint: revolute(z), \
            coordinate: q1 near 2.2 }
        body left_bar on left { mass: 0.3, com: [0.17, 0, 0], inertia: 0.003, joint: revolute(z) at [0.25, 0, 0], \
            coordinate: q2 depends near -1.7 }
        body right on ground { mass: 0.4, com: [0.12, 0, 0], inertia: 0.002, joint: revolute(z) at [0.3, 0, 0], \
            motion: 0.9 + 0.2*sin(3*t) }
        body right_bar on right { mass: 0.3, com: [0.17, 0, 0], inertia: 0.003, joint: revolute(z) at [0.25, 0, 0], \
            coordinate: q3 depends near 1.7 }
        close left_bar at [0.35, 0, 0] to right_bar at [0.35, 0, 0]: revolute(z),
        point p on left_bar at [0.35, 0, 0], point r on right_bar at [0.35, 0, 0],
        output gaps: [p.x - r.x, p.y - r.y],
    }",
    // on a carrier that turns about another axis, with a body that hangs on a dependent one
    "pub Carried {
        gravity: [0, 1, -9.81],
        body carrier on ground { mass: 2, com: [0.1, 0.2, 0.1], inertia: [0.3, 0.4, 0.5], joint: revolute(z), \
            coordinate: q1 }
        body thigh on carrier { mass: 0.5, com: [0.1, 0.02, 0], inertia: [0.002, 0.003, 0.004],
            joint: revolute(x) at [0.3, 0, 0], coordinate: q2 near 0.8, friction: 0.3 }
        body coupler on thigh { mass: 1.1, com: [0.2, 0.1, 0], inertia: [0.02, 0.01, 0.02], \
            joint: revolute(x) at [0, 0.2, 0], coordinate: q3 depends near -0.3 }
        body rocker on carrier { mass: 0.9, com: [0.2, 0.1, 0], inertia: [0.01, 0.02, 0.02], \
            joint: revolute(x) at [0.3, 0.6, 0], coordinate: q4 depends near 1.6 }
        body bell on coupler { mass: 0.4, com: [0, 0, -0.2], inertia: [0.01, 0.01, 0.003], \
            joint: revolute(x) at [0, 0.3, 0], coordinate: q5 }
        body tongue on bell { mass: 0.2, com: [0, 0, -0.2], inertia: [0.01, 0.01, 0.003], \
            joint: revolute(y) at [0, 0.1, 0], coordinate: q6 }
        close coupler at [0.02, 0.5, 0] to rocker at [0.02, 0.4, 0]: revolute(x),
        point p on coupler at [0, 0.5, 0], point r on rocker at [0, 0.4, 0],
        output gaps: [(p.x - r.x)*cos(q1) + (p.y - r.y)*sin(q1), (p.y - r.y)*cos(q1) - (p.x - r.x)*sin(q1), p.z - r.z],
    }",
    // a side with an independent part, in both directions
    "pub Telescope {
        gravity: [0, -9.81, 0],
        body crank on ground { mass: 0.5, com: [0.1, 0, 0], inertia: 0.002, joint: revolute(z), \
            coordinate: q1 near 0.8 }
        body tube on crank { mass: 1.1, com: [0.2, 0.1, 0], inertia: 0.02, joint: revolute(z) at [0.2, 0, 0], \
            coordinate: q2 depends near -0.3 }
        body stem on tube { mass: 0.3, com: [0.05, 0, 0], inertia: 0.003, joint: prismatic(x) at [0.2, 0, 0], \
            coordinate: q3 near 0.15 }
        body foot on stem { mass: 0.2, com: [0.05, 0.01, 0], inertia: 0.001, joint: revolute(z) at [0.05, 0, 0], \
            coordinate: q4 near 0.3 }
        body rocker on ground { mass: 0.9, com: [0.2, 0, 0], inertia: 0.01, joint: revolute(z) at [0.6, 0, 0], \
            coordinate: q5 depends near 1.6 }
        close foot at [0.1, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        point p on foot at [0.1, 0, 0], point r on rocker at [0.4, 0, 0],
        output gaps: [p.x - r.x, p.y - r.y],
    }",
    // neither loop is a triangle, but their difference is
    "pub Difference {
        gravity: [0, -9.81, 0],
        body crank on ground { mass: 0.5, com: [0.1, 0, 0], inertia: 0.002, joint: revolute(z), \
            coordinate: q1 near 0.8 }
        body coupler on crank { mass: 1.1, com: [0.2, 0, 0], inertia: 0.02, joint: revolute(z) at [0.2, 0, 0], \
            coordinate: q2 depends near -0.3 }
        body rocker on ground { mass: 0.9, com: [0.2, 0, 0], inertia: 0.01, joint: revolute(z) at [0.6, 0, 0], \
            coordinate: q3 depends near 1.6 }
        body arm on ground { mass: 0.4, com: [0.2, 0, 0], inertia: 0.01, joint: revolute(z) at [0.2, 0.9, 0], \
            coordinate: q4 depends near -1.5 }
        body hand on arm { mass: 0.3, com: [0.2, 0, 0], inertia: 0.01, joint: revolute(z) at [0.4, 0, 0], \
            coordinate: q5 depends near 1 }
        close coupler at [0.5, 0, 0] to hand at [0.4, 0, 0]: revolute(z),
        close rocker at [0.4, 0, 0] to hand at [0.4, 0, 0]: revolute(z),
        point p on coupler at [0.5, 0, 0], point r on rocker at [0.4, 0, 0], point s on hand at [0.4, 0, 0],
        output gaps: [p.x - s.x, p.y - s.y, r.x - s.x, r.y - s.y],
    }",
    // a loop that hangs on a loop
    "pub DoubleFourBar {
        gravity: [0, -9.81, 0],
        body first on ground { mass: 1, com: [0, 0.5, 0], inertia: 0.1, joint: revolute(z), coordinate: q1 near 0.2 }
        body beam on first { mass: 1, com: [0.5, 0, 0], inertia: 0.1, joint: revolute(z) at [0, 1, 0], \
            coordinate: q2 depends near -0.2 }
        body second on ground { mass: 1, com: [0, 0.5, 0], inertia: 0.1, joint: revolute(z) at [1, 0, 0], \
            coordinate: q3 depends near 0.2 }
        body other on second { mass: 1, com: [0.5, 0, 0], inertia: 0.1, joint: revolute(z) at [0, 1, 0], \
            coordinate: q4 depends near -0.2 }
        body third on ground { mass: 1, com: [0, 0.5, 0], inertia: 0.1, joint: revolute(z) at [2, 0, 0], \
            coordinate: q5 depends near 0.2 }
        close beam at [1, 0, 0] to second at [0, 1, 0]: revolute(z),
        close other at [1, 0.1, 0] to third at [0, 1.1, 0]: revolute(z),
        point p on beam at [1, 0, 0], point r on second at [0, 1, 0], point s on other at [1, 0.1, 0], \
            point u on third at [0, 1.1, 0],
        output gaps: [p.x - r.x, p.y - r.y, s.x - u.x, s.y - u.y],
    }",
    // three rods hold a plate, one of them on a crank: no loop is a triangle
    "pub Plate {
        gravity: [0, -9.81, 0],
        body crank on ground { mass: 0.5, com: [0.05, 0.01, 0], inertia: 0.002, joint: revolute(z), \
            coordinate: q1 near 0.8 }
        body rod on crank { mass: 0.3, com: [0.2, 0, 0], inertia: 0.004, joint: revolute(z) at [0.15, 0, 0], \
            coordinate: q2 depends near 0.2, friction: 0.3 }
        body left on ground { mass: 0.4, com: [0.2, 0, 0], inertia: 0.01, joint: revolute(z) at [-0.45, 0, 0], \
            coordinate: q3 depends near 1.8 }
        body plate on left { mass: 1.1, com: [0.2, 0.1, 0], inertia: 0.02, joint: revolute(z) at [0.5, 0, 0], \
            coordinate: q4 depends near -1.7, torque: 0.2*sin(q) }
        body right on ground { mass: 0.9, com: [0.2, 0, 0], inertia: 0.01, joint: revolute(z) at [0.7, 0.1, 0], \
            coordinate: q5 depends near 1.4 }
        close plate at [0.95, -0.15, 0] to rod at [0.4, 0, 0]: revolute(z),
        close plate at [1.45, -0.04, 0] to right at [0.5, 0, 0]: revolute(z),
        point p on plate at [0.95, -0.15, 0], point r on rod at [0.4, 0, 0], point s on plate at [1.45, -0.04, 0], \
            point u on right at [0.5, 0, 0],
        potential: 0.2*(q2 - q5)^2,
        output gaps: [p.x - r.x, p.y - r.y, s.x - u.x, s.y - u.y],
    }",
    // two cranks about axes at an angle, and a rod with ball joints, of which one is two hinges
    "pub Spatial {
        params { l: m = 0.65 }
        gravity: [0, 1, -9.81],
        body crank on ground { mass: 0.5, com: [0.05, 0.01, 0], inertia: [0.001, 0.002, 0.002], joint: revolute(z), \
            coordinate: q1 near 0.8 }
        body yoke on crank { mass: 0.1, com: [0, 0, 0.01], inertia: [0.001, 0.002, 0.002], \
            joint: revolute(z) at [0.15, 0, 0.02], coordinate: q2 depends near -0.5, friction: 0.1 }
        body rod on yoke { mass: 0.4, com: [0.3, 0, 0], inertia: [0.001, 0.01, 0.01], joint: revolute(y), \
            coordinate: q3 depends near -0.6 }
        body rocker on ground { mass: 0.9, com: [0, 0.2, 0.1], inertia: [0.02, 0.01, 0.01], \
            joint: revolute([1, 0, 0.2]) at [0.6, 0, 0.1], coordinate: q4 depends near 0.7, spring: (2, 0.4) }
        close rod at [l, 0, 0] to rocker at [0, 0.4, 0.1]: ball,
        point p on rod at [l, 0, 0], point r on rocker at [0, 0.4, 0.1],
        force on p: [0.2, 0.1, 0.3],
        output gaps: [p.x - r.x, p.y - r.y, p.z - r.z],
    }",
    // Bennett's linkage: of five equations two are sums of the others
    "pub Bennett {
        gravity: [0, 1, -9.81],
        body first on ground { mass: 0.5, com: [0.2, 0.01, 0], inertia: [0.001, 0.02, 0.02], \
            joint: revolute(z) at [0.8, 0, 0] rpy [0.8928089789005025, 0, 0], coordinate: q1 near 2 }
        body second on first { mass: 0.7, com: [0.4, 0.01, 0], inertia: [0.001, 0.03, 0.03], \
            joint: revolute(z) at [0.4, 0, 0] rpy [0.4, 0, 0], coordinate: q2 depends near 1.97, friction: 0.2 }
        body third on second { mass: 0.5, com: [0.2, 0.01, 0], inertia: [0.001, 0.02, 0.02], \
            joint: revolute(z) at [0.8, 0, 0] rpy [0.8928089789005025, 0, 0], coordinate: q3 depends near -2 }
        close third at [0.4, 0, 0] rpy [0.4, 0, 0] to ground: revolute(z),
        point p on third at [0.4, 0, 0], point r on third at [0.4, -sin(0.4), cos(0.4)],
        output gaps: [p.x, p.y, p.z, r.x, r.y],
    }",
    // a block that slides on the ground, beside a loop that is a triangle; both on a carrier, one crank driven
    "pub Sliding {
        gravity: [0, 1, -9.81],
        body carrier on ground { mass: 2, com: [0.1, 0.2, 0.1], inertia: [0.3, 0.4, 0.5], joint: revolute(z), \
            coordinate: q1 }
        body crank on carrier { mass: 0.5, com: [0.1, 0.02, 0], inertia: [0.002, 0.003, 0.004], \
            joint: revolute(z) at [0.3, 0, 0], motion: 0.8 + 0.3*sin(2*t) }
        body coupler on crank { mass: 1.1, com: [0.2, 0.1, 0], inertia: [0.02, 0.01, 0.02], \
            joint: revolute(z) at [0.2, 0, 0], coordinate: q2 depends near -0.3 }
        body rocker on carrier { mass: 0.9, com: [0.2, 0.1, 0], inertia: [0.01, 0.02, 0.02], \
            joint: revolute(z) at [0.9, 0, 0], coordinate: q3 depends near 1.6 }
        body rod on rocker { mass: 0.3, com: [0.2, 0, 0], inertia: [0.001, 0.01, 0.01], \
            joint: revolute(z) at [0.3, 0, 0], coordinate: q4 depends near -2 }
        body block on rod { mass: 0.2, com: [0, 0, 0], inertia: [0.001, 0.001, 0.002], \
            joint: revolute(z) at [0.5, 0, 0], coordinate: q5 depends near 0.4 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        close block to carrier at [0, 0.1, 0]: prismatic(x),
        point p on coupler at [0.5, 0, 0], point r on rocker at [0.4, 0, 0], point s on block, \
            point u on block at [1, 0, 0], point o on carrier at [0, 0.1, 0], point i on carrier at [0, 1.1, 0],
        output gaps: [p.x - r.x, p.y - r.y, (s.x - o.x)*(i.x - o.x) + (s.y - o.y)*(i.y - o.y), \
            (u.x - s.x)*(i.x - o.x) + (u.y - s.y)*(i.y - o.y)],
    }",
];

const TIME: f64 = 0.3;

/// Declaration of the same bodies without loops.
fn opened(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.trim().starts_with("close "));
    let without_guess = |line: &str| match line.split_once(" near ") {
        Some((before, after)) => {
            let end = after.find([',', ' ']).expect("something follows");
            format!("{before}{}", &after[end..])
        }
        None => line.to_owned(),
    };
    lines.map(without_guess).collect::<String>().replace(" depends", "")
}

/// Values of expressions, for values of coordinates and rates by name.
fn values<'g>(model: &Model<'g>, roots: &[Expr<'g>], state: &impl Fn(&str) -> f64) -> Vec<f64> {
    let roots = model.written_out(&model.with_drives(roots));
    let value = |symbol: &Symbol| match symbol.kind {
        SymbolKind::Parameter(n) => model.parameters[n].default.expect("a default"),
        SymbolKind::Time => TIME,
        _ => state(&symbol.name),
    };
    model.graph.evaluate(&roots, value)
}

/// State of a scene by name.
fn state_of<'a>(names: &'a [String], q: &'a [f64], qd: &'a [f64]) -> impl Fn(&str) -> f64 + 'a {
    move |name| {
        let place = |own: &str| names.iter().position(|known| known == own);
        let rate = name
            .strip_prefix("dot(")
            .and_then(|rest| place(rest.trim_end_matches(')')));
        match (place(name), rate) {
            (Some(k), _) => q[k],
            (_, Some(k)) => qd.get(k).copied().unwrap_or(f64::NAN),
            _ => f64::NAN,
        }
    }
}

fn names(model: &Model<'_>) -> Vec<String> {
    model.coordinates.iter().map(|c| c.name.clone()).collect()
}

/// Accelerations of an open tree whose gaps are held closed by multipliers, followed by the forces of the drives.
fn by_multipliers(open: &Model<'_>, q: &[f64], qd: &[f64]) -> (DVector<f64>, Vec<f64>) {
    let (names, n) = (names(open), q.len());
    let state = state_of(&names, q, qd);
    let dynamics = Dynamics::new(open);
    let gaps = &open.outputs[0].values;
    let mass = DMatrix::from_row_slice(n, n, &values(open, &dynamics.balance.mass_matrix.concat(), &state));
    let residual = DVector::from_vec(values(open, &dynamics.balance.residual, &state));
    let columns = derived(gaps, &open.positions()).concat();
    let jacobian = DMatrix::from_column_slice(gaps.len(), n, &values(open, &columns, &state));
    let mut along = open.along_motion();
    let rates: Vec<Expr<'_>> = gaps.iter().map(|&gap| along.of(gap)).collect();
    let mut along = crate::expr::Derivative::along(
        open.all_coordinates()
            .flat_map(|c| [(c.position, c.rate)])
            .chain(
                open.drives
                    .iter()
                    .map(|d| (d.coordinate.rate, d.coordinate.acceleration)),
            )
            .chain([(open.time, open.graph.one())]),
    );
    let bends: Vec<Expr<'_>> = rates.iter().map(|&rate| along.of(rate)).collect();
    let bend = DVector::from_vec(values(open, &bends, &state));
    let m = gaps.len();
    let mut whole = DMatrix::zeros(n + m, n + m);
    whole.view_mut((0, 0), (n, n)).copy_from(&mass);
    whole.view_mut((n, 0), (m, n)).copy_from(&jacobian);
    whole.view_mut((0, n), (n, m)).copy_from(&jacobian.transpose());
    let right = DVector::from_iterator(n + m, residual.iter().chain(&bend).map(|x| -x));
    // gaps in space may be redundant
    let solved = whole.svd(true, true).solve(&right, 1e-12).expect("singular values");
    let accelerations = solved.rows(0, n).into_owned();
    let symbols = open.coordinates.iter().map(|c| c.acceleration);
    let known = symbols.zip(accelerations.iter().map(|&x| number(open.graph, x)));
    let drive = open.graph.substitute(&dynamics.reactions.drive, known.collect());
    let mut forces = values(open, &drive, &state);
    for (force, drive) in forces.iter_mut().zip(&open.drives) {
        let slopes = derived(gaps, &[drive.coordinate.position]).concat();
        let slopes = values(open, &slopes, &state);
        *force += slopes
            .iter()
            .zip(solved.rows(n, m).iter())
            .map(|(a, b)| a * b)
            .sum::<f64>();
    }
    (accelerations, forces)
}

fn number(graph: &Graph, x: f64) -> Expr<'_> {
    graph.number(num_rational::BigRational::from_float(x).expect("finite"))
}

fn assert_near(what: &str, ours: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(ours.len(), expected.len(), "{what}");
    let size = expected.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    let error = ours
        .iter()
        .zip(expected)
        .fold(0.0, |error: f64, (a, b)| error.max((a - b).abs()));
    assert!(error <= tolerance * size, "{what}: {ours:?} instead of {expected:?}");
}

#[test]
fn loops_move_as_with_multipliers() {
    let every = if is_thorough() { 1 } else { 3 };
    for (seed, text) in SCENES.iter().enumerate().step_by(every) {
        let open_text = opened(text);
        let (graph, open_graph) = (Graph::new(), Graph::new());
        let text_with = text.replacen('{', "{ generate: [rhs, jacobian, energy, loop_wrenches],", 1);
        let (closed, open) = (model(&graph, &text_with), model(&open_graph, &open_text));
        let mut forms = Forms::new(&closed, &Dynamics::new(&closed));
        let chosen = forms.accelerations().roots;
        let drives = drive_forces(&mut forms, &closed).roots;
        let wrenches = loop_wrenches(&mut forms, &closed).roots;
        let dynamics = [
            Dynamics::new(&closed),
            Dynamics::recursive(&closed, Dynamics::new(&closed).lagrangian.potential, false),
            Dynamics::recursive(&closed, Dynamics::new(&closed).lagrangian.potential, true),
        ];
        let (free, all) = (names(&closed), names(&open));
        let in_state = closed.in_state().map(|(_, coordinate)| coordinate.name.clone());
        let of_state: Vec<String> = free.iter().cloned().chain(in_state).collect();
        let mut random = numbers(seed as u32);
        for _ in 0..4 {
            let mut q: Vec<f64> = of_state
                .iter()
                .map(|name| near(text, name).unwrap_or(0.0) + 0.1 * random())
                .collect();
            let qd: Vec<f64> = free.iter().map(|_| random()).collect();
            for _ in 0..20 {
                let corrections = values(&closed, &closed.loops.corrections, &state_of(&of_state, &q, &qd));
                let dependents = q[free.len()..].iter_mut();
                dependents.zip(corrections).for_each(|(q, correction)| *q += correction);
            }
            let state = state_of(&of_state, &q, &qd);
            // dependent coordinates, by their symbols
            let dependent = |name: &str| {
                let mut known = closed
                    .loops
                    .dependence
                    .definitions()
                    .filter(|(symbol, _)| symbol.as_symbol().is_some_and(|s| s.name == name));
                values(&closed, &[known.next().expect("it depends").0], &state)[0]
            };
            let whole = |name: String| {
                if state(&name).is_nan() {
                    dependent(&name)
                } else {
                    state(&name)
                }
            };
            let whole_q: Vec<f64> = all.iter().map(|name| whole(name.clone())).collect();
            let whole_qd: Vec<f64> = all.iter().map(|name| whole(format!("dot({name})"))).collect();
            let open_state = state_of(&all, &whole_q, &whole_qd);
            let gaps = values(&open, &open.outputs[0].values, &open_state);
            assert_near("gaps", &gaps, &vec![0.0; gaps.len()], 2e-15);
            let (expected, drive) = by_multipliers(&open, &whole_q, &whole_qd);
            let wrenches = values(&closed, &wrenches, &state);
            assert_supplied(&closed, &open, &wrenches, &expected, &open_state);
            let of_free: Vec<f64> = free
                .iter()
                .map(|name| expected[all.iter().position(|own| own == name).expect("in both")])
                .collect();
            let open_dynamics = Dynamics::new(&open);
            let energies = values(
                &open,
                &[open_dynamics.lagrangian.kinetic, open_dynamics.lagrangian.potential],
                &open_state,
            );
            for dynamics in &dynamics {
                let mass = values(&closed, &dynamics.balance.mass_matrix.concat(), &state);
                let mass = DMatrix::from_row_slice(free.len(), free.len(), &mass);
                let residual = DVector::from_vec(values(&closed, &dynamics.balance.residual, &state));
                let solved = mass.lu().solve(&-residual).expect("it has an inverse");
                assert_near("accelerations", solved.as_slice(), &of_free, 1e-11);
                let own = values(
                    &closed,
                    &[dynamics.lagrangian.kinetic, dynamics.lagrangian.potential],
                    &state,
                );
                assert_near("energies", &own, &energies, 1e-13);
            }
            assert_near("forces of drives", &values(&closed, &drives, &state), &drive, 1e-11);
            assert_near("chosen form", &values(&closed, &chosen, &state), &of_free, 1e-11);
            assert_derivatives(&closed, &mut forms, &of_state, &q, &qd);
        }
    }
}

/// Asserts that the wrenches between the ends of loops balance the open tree at accelerations that keep the loops
/// closed.
fn assert_supplied(
    closed: &Model<'_>,
    open: &Model<'_>,
    wrenches: &[f64],
    accelerations: &DVector<f64>,
    state: &impl Fn(&str) -> f64,
) {
    let (graph, poses) = (open.graph, Poses::new(open));
    let symbols = open.coordinates.iter().map(|c| c.acceleration);
    let known = symbols.zip(accelerations.iter().map(|&x| number(graph, x)));
    let lacking = graph.substitute(&Dynamics::new(open).balance.rows, known.collect());
    let mut supplied = vec![0.0; open.dof()];
    for (closure, wrench) in closed.closures.iter().zip(wrenches.chunks(6)) {
        let [moment, force] = [0, 3].map(|n| Vector3::from_column_slice(&wrench[n..n + 3]));
        let [first, second] = closure.ends.each_ref().map(|end| end.body);
        let at = values(closed, &closure.ends[1].at.0, state);
        let at = poses.point(second, Vec3([0, 1, 2].map(|n| number(graph, at[n]))));
        let at = values(open, &at.0, state);
        for (body, sign) in [(first, -1.0), (second, 1.0)] {
            let (axes, origin) = (poses.rotation(body), poses.point(body, Vec3::zero(graph)));
            let entries = [axes.0.map(|row| row.0).concat(), origin.0.to_vec()].concat();
            let pose = values(open, &entries, state);
            let turned = Matrix3::from_row_slice(&pose[..9]);
            let arm = Vector3::from_column_slice(&at) - Vector3::from_column_slice(&pose[9..]);
            let columns = derived(&entries, &open.positions());
            for (column, supplied) in columns.iter().zip(&mut supplied) {
                let column = values(open, column, state);
                let spin = Matrix3::from_row_slice(&column[..9]) * turned.transpose();
                let spin = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);
                let velocity = Vector3::from_column_slice(&column[9..]) + spin.cross(&arm);
                *supplied += sign * (force.dot(&velocity) + moment.dot(&spin));
            }
        }
    }
    assert_near("wrenches", &supplied, &values(open, &lacking, state), 1e-11);
}

/// Checks the Jacobian, and the rates of the momenta, against differences.
fn assert_derivatives<'g>(closed: &Model<'g>, forms: &mut Forms<'g>, free: &[String], q: &[f64], qd: &[f64]) {
    /// Step of the fourth-order differences, which lose some four of sixteen digits.
    const STEP: f64 = 1e-3;
    let roots = forms.accelerations().roots;
    let accelerations = |q: &[f64], qd: &[f64]| values(closed, &roots, &state_of(free, q, qd));
    let x = [q, qd].concat();
    let (n, m) = (q.len(), qd.len());
    let columns = forms.jacobian(closed, &closed.state(), false, &[]).roots;
    let columns = values(closed, &columns, &state_of(free, q, qd));
    type OfState<'a> = &'a dyn Fn(&[f64], &[f64]) -> Vec<f64>;
    let along = |direction: &[f64], of: OfState<'_>| -> Vec<f64> {
        let at = |steps: f64| {
            let moved: Vec<f64> = x.iter().zip(direction).map(|(x, d)| x + steps * STEP * d).collect();
            of(&moved[..n], &moved[n..])
        };
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(at);
        (0..a.len())
            .map(|k| (a[k] - 8.0 * b[k] + 8.0 * c[k] - d[k]) / (12.0 * STEP))
            .collect()
    };
    for k in 0..n + m {
        let mut direction = vec![0.0; n + m];
        direction[k] = 1.0;
        assert_near(
            "Jacobian",
            &columns[k * m..(k + 1) * m],
            &along(&direction, &accelerations),
            1e-7,
        );
    }
    if closed.drives.is_empty() && n == m {
        let canonical = forms.canonical(closed).roots;
        let momenta = |q: &[f64], qd: &[f64]| values(closed, &canonical[..n], &state_of(free, q, qd));
        let direction = [qd, &accelerations(q, qd)].concat();
        let rates = values(closed, &canonical[n..], &state_of(free, q, qd));
        assert_near("rates of momenta", &rates, &along(&direction, &momenta), 1e-7);
    }
}

//! Systems of the gallery against Lagrange's equations, written out in symbols from the positions of their bodies.

use super::{dynamics, formula, normal_text, numbers};
use crate::expr::{Derivative, Expr, Graph, ratio};
use crate::model::Model;

/// Mass, inertia, position and angle of a body in the plane.
type Body = [&'static str; 5];

/// A system: its file, its number in the file, its bodies, the potential beside gravity, and the forces along its
/// coordinates.
struct Case {
    source: &'static str,
    number: usize,
    bodies: &'static [Body],
    gravity: &'static str,
    potential: &'static str,
    forces: &'static [&'static str],
}

const CASES: &[Case] = &[
    Case {
        source: include_str!("../../../examples/gallery/src/point_masses.rs"),
        number: 0,
        bodies: &[
            ["m1", "0", "l1*sin(theta1)", "-l1*cos(theta1)", "theta1"],
            [
                "m2",
                "0",
                "l1*sin(theta1) + l2*sin(theta2)",
                "-l1*cos(theta1) - l2*cos(theta2)",
                "theta2",
            ],
        ],
        gravity: "g",
        potential: "0",
        forces: &["0", "0"],
    },
    Case {
        source: include_str!("../../../examples/gallery/src/asymmetric.rs"),
        number: 0,
        bodies: &[
            ["m1", "i1", "c1*sin(theta1)", "-c1*cos(theta1)", "theta1"],
            [
                "m2",
                "i2",
                "d*sin(theta1) + c2*sin(theta2)",
                "-d*cos(theta1) - c2*cos(theta2)",
                "theta2",
            ],
        ],
        gravity: "g",
        potential: "k1*theta1^2/2 + k2*(theta2 - theta1)^2/2",
        forces: &["0", "0"],
    },
    Case {
        source: include_str!("../../../examples/gallery/src/bars_and_squares.rs"),
        number: 0,
        bodies: &[
            ["m", "m*l^2/12", "l/2*sin(theta1)", "-l/2*cos(theta1)", "theta1"],
            [
                "m",
                "m*l^2/12",
                "l*sin(theta1) + l/2*sin(theta2)",
                "-l*cos(theta1) - l/2*cos(theta2)",
                "theta2",
            ],
        ],
        gravity: "g",
        potential: "0",
        forces: &["0", "0"],
    },
    Case {
        source: include_str!("../../../examples/gallery/src/bars_and_squares.rs"),
        number: 1,
        bodies: &[
            [
                "m",
                "m*a^2/6",
                "a*sqrt(2)/2*sin(theta1)",
                "-a*sqrt(2)/2*cos(theta1)",
                "theta1",
            ],
            [
                "m",
                "m*a^2/6",
                "a*sqrt(2)*sin(theta1) + a*sqrt(2)/2*sin(theta2)",
                "-a*sqrt(2)*cos(theta1) - a*sqrt(2)/2*cos(theta2)",
                "theta2",
            ],
        ],
        gravity: "g",
        potential: "0",
        forces: &["0", "0"],
    },
    Case {
        source: include_str!("../../../examples/gallery/src/two_bodies.rs"),
        number: 0,
        bodies: &[
            [
                "m1",
                "i1",
                "c1*sin(theta1) + side*cos(theta1)",
                "-c1*cos(theta1) + side*sin(theta1)",
                "theta1",
            ],
            [
                "m2",
                "i2",
                "d*sin(theta1) + c2*sin(theta2) - side*cos(theta2)",
                "-d*cos(theta1) - c2*cos(theta2) - side*sin(theta2)",
                "theta2",
            ],
        ],
        gravity: "g",
        potential: "0",
        forces: &[
            "-gamma1*dot(theta1) + gamma2*(dot(theta2) - dot(theta1))",
            "-gamma2*(dot(theta2) - dot(theta1))",
        ],
    },
    Case {
        source: include_str!("../../../examples/gallery/src/cubic.rs"),
        number: 0,
        bodies: &[["m1", "0", "x1", "0", "0"], ["m2", "0", "x2", "0", "0"]],
        gravity: "0",
        potential: "k/2*x1^2 + k3/4*x1^4 + k/2*(x2 - x1)^2 + k3/4*(x2 - x1)^4",
        forces: &["-c3*dot(x1)^3 + c3*(dot(x2) - dot(x1))^3", "-c3*(dot(x2) - dot(x1))^3"],
    },
    Case {
        source: include_str!("../../../examples/gallery/src/driven_pivot.rs"),
        number: 0,
        bodies: &[
            [
                "m1",
                "m1*l1^2/12",
                "a*cos(nx*w*t) + l1/2*sin(theta1)",
                "b*sin(ny*w*t) - l1/2*cos(theta1)",
                "theta1",
            ],
            [
                "m2",
                "m2*l2^2/12",
                "a*cos(nx*w*t) + l1*sin(theta1) + l2/2*sin(theta2)",
                "b*sin(ny*w*t) - l1*cos(theta1) - l2/2*cos(theta2)",
                "theta2",
            ],
        ],
        gravity: "9.81",
        potential: "0",
        forces: &[
            "-gamma*dot(theta1) + gamma*(dot(theta2) - dot(theta1))",
            "-gamma*(dot(theta2) - dot(theta1))",
        ],
    },
    Case {
        source: include_str!("../../../examples/gallery/src/kapitza.rs"),
        number: 0,
        bodies: &[["m", "0", "l*sin(theta)", "a*cos(w*t) - l*cos(theta)", "theta"]],
        gravity: "9.81",
        potential: "0",
        forces: &["-gamma*dot(theta)"],
    },
    Case {
        source: include_str!("../../../examples/gallery/src/spring_suspended.rs"),
        number: 0,
        bodies: &[["m", "m*(a^2 + b^2)/12", "x + a/2*sin(phi)", "y - a/2*cos(phi)", "phi"]],
        gravity: "9.81",
        potential: "k/2*(sqrt(x^2 + y^2) - rest)^2 - f*cos(w*t)*y",
        forces: &[
            "-c*x*(x*dot(x) + y*dot(y))/(x^2 + y^2)",
            "-c*y*(x*dot(x) + y*dot(y))/(x^2 + y^2)",
            "0",
        ],
    },
];

#[test]
fn declared_systems_obey_lagranges_equations() {
    for case in CASES {
        let graph = Graph::new();
        let declaration = case
            .source
            .split("mechanism! {")
            .nth(case.number + 1)
            .expect("a declaration");
        let declaration = &declaration[..declaration.find("\n}").expect("its end")];
        let (model, dynamics) = dynamics(&graph, declaration);
        let rows = lagrange(&model, case);
        for (row, &ours) in rows.into_iter().zip(&dynamics.balance.rows) {
            let left = normal_text(row - ours);
            if left.contains('/') {
                // the normal form keeps a quotient by a sum as it is
                let mut next = numbers(3);
                let values = graph.evaluate(&[row, ours], |_| 1.0 + next() / 2.0);
                assert!(
                    (values[0] - values[1]).abs() < 1e-13 * values[0].abs(),
                    "{}: {values:?}",
                    model.name
                );
            } else {
                assert_eq!(left, "0", "{}", model.name);
            }
        }
    }
}

/// Residual `d/dt dL/dqd - dL/dq - Q` for each coordinate.
fn lagrange<'g>(model: &Model<'g>, case: &Case) -> Vec<Expr<'g>> {
    let g = model.graph;
    let time = (model.time, g.one());
    let mut along = Derivative::along(model.coordinates.iter().map(|c| (c.position, c.rate)).chain([time]));
    let half = g.number(ratio(1, 2));
    let mut lagrangian = -formula(model, case.potential);
    for body in case.bodies {
        let [mass, inertia, x, y, angle] = body.map(|text| formula(model, text));
        let [vx, vy, w] = [x, y, angle].map(|place| along.of(place));
        let kinetic = half * (mass * (vx.powi(2) + vy.powi(2)) + inertia * w.powi(2));
        lagrangian += kinetic - mass * formula(model, case.gravity) * y;
    }
    let rates = model
        .coordinates
        .iter()
        .flat_map(|c| [(c.position, c.rate), (c.rate, c.acceleration)]);
    let mut along = Derivative::along(rates.chain([time]));
    let row = |(k, force): (usize, &&str)| {
        let coordinate = &model.coordinates[k];
        let momentum = Derivative::by(coordinate.rate).of(lagrangian);
        along.of(momentum) - Derivative::by(coordinate.position).of(lagrangian) - formula(model, force)
    };
    case.forces.iter().enumerate().map(row).collect()
}

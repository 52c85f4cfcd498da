//! Generated equations against hand-written ones, in symbols: the difference has normal form zero.

use rustc_hash::FxHashMap;

use super::{assert_formula, dynamics, formula, normal_text, symbol};
use crate::dynamics::Dynamics;
use crate::expr::{Derivative, Expr, Graph};
use crate::model::Model;

/// Williams (2023), Eq. 22: identical bodies and `c = d`.
const EQ22: &str = "pub Eq22 {
    params { m: kg, I: kg m^2, d: m, g: m/s^2, gamma1: N m s, gamma2: N m s }
    gravity: [0, -g, 0],
    shape plate { mass: m, com: [0, -d, 0], inertia: I }
    body upper on ground: plate { joint: revolute(z), coordinate: theta1, friction: gamma1 }
    body lower on upper: plate { joint: revolute(z) at [0, -d, 0], coordinate: theta2 absolute, friction: gamma2 }
}";

/// Different bodies and any `c` and `d`; `COORDINATE` is the second coordinate.
const GENERAL: &str = "pub General {
    params { m1: kg, m2: kg, I1: kg m^2, I2: kg m^2, c1: m, c2: m, d: m, g: m/s^2, gamma1: N m s, gamma2: N m s }
    gravity: [0, -g, 0],
    body upper on ground {
        mass: m1, com: [0, -c1, 0], inertia: I1,
        joint: revolute(z), coordinate: theta1, friction: gamma1,
    }
    body lower on upper {
        mass: m2, com: [0, -c2, 0], inertia: I2,
        joint: revolute(z) at [0, -d, 0], coordinate: COORDINATE, friction: gamma2,
    }
}";

fn general(coordinate: &str) -> String {
    GENERAL.replace("COORDINATE", coordinate)
}

#[test]
fn eq22_is_generated_with_its_slips_mended() {
    let graph = Graph::new();
    let (model, dynamics) = dynamics(&graph, EQ22);
    let a = &dynamics.balance.mass_matrix;
    assert_formula(&model, "A11", a[0][0], "I + 2*m*d^2");
    assert_formula(&model, "A12", a[0][1], "m*d^2*cos(theta1 - theta2)");
    assert_formula(&model, "A21", a[1][0], "m*d^2*cos(theta1 - theta2)");
    assert_formula(&model, "A22", a[1][1], "I + m*d^2");
    let first = "m*d^2*dot(theta2)^2*sin(theta1 - theta2) + 2*m*g*d*sin(theta1)";
    let second = "-m*d^2*dot(theta1)^2*sin(theta1 - theta2) + m*g*d*sin(theta2)";
    assert_formula(&model, "bias of theta1", dynamics.lagrangian.bias[0], first);
    assert_formula(&model, "bias of theta2", dynamics.lagrangian.bias[1], second);
    let first = "-gamma1*dot(theta1) - gamma2*(dot(theta1) - dot(theta2))";
    assert_formula(&model, "force of theta1", dynamics.lagrangian.force[0], first);
    assert_formula(
        &model,
        "force of theta2",
        dynamics.lagrangian.force[1],
        "gamma2*(dot(theta1) - dot(theta2))",
    );
}

#[test]
fn different_bodies_and_any_distances_are_generated() {
    let graph = Graph::new();
    let (model, dynamics) = dynamics(&graph, &general("theta2 absolute"));
    let a = &dynamics.balance.mass_matrix;
    assert_formula(&model, "A11", a[0][0], "I1 + m1*c1^2 + m2*d^2");
    assert_formula(&model, "A12", a[0][1], "m2*d*c2*cos(theta1 - theta2)");
    assert_formula(&model, "A22", a[1][1], "I2 + m2*c2^2");
    let first = "m2*d*c2*sin(theta1 - theta2)*dot(theta2)^2 + (m1*c1 + m2*d)*g*sin(theta1)";
    let second = "-m2*d*c2*sin(theta1 - theta2)*dot(theta1)^2 + m2*c2*g*sin(theta2)";
    assert_formula(&model, "bias of theta1", dynamics.lagrangian.bias[0], first);
    assert_formula(&model, "bias of theta2", dynamics.lagrangian.bias[1], second);
    let potential = "-(m1*c1 + m2*d)*g*cos(theta1) - m2*c2*g*cos(theta2)";
    assert_formula(&model, "potential energy", dynamics.lagrangian.potential, potential);
    let kinetic = "(I1 + m1*c1^2 + m2*d^2)*dot(theta1)^2/2 + (I2 + m2*c2^2)*dot(theta2)^2/2
        + m2*d*c2*cos(theta1 - theta2)*dot(theta1)*dot(theta2)";
    assert_formula(&model, "kinetic energy", dynamics.lagrangian.kinetic, kinetic);
}

/// The printed Eq. 22b has `theta2'^2` where `theta1'^2` belongs.
#[test]
fn the_printed_eq22b_differs_in_one_velocity_term() {
    let graph = Graph::new();
    let (model, dynamics) = dynamics(&graph, EQ22);
    let printed = formula(
        &model,
        "-m*d^2*dot(theta2)^2*sin(theta1 - theta2) + m*g*d*sin(theta2) - gamma2*(dot(theta1) - dot(theta2))",
    );
    let slip = printed - dynamics.balance.residual[1];
    assert_formula(
        &model,
        "the slip",
        slip,
        "m*d^2*(dot(theta1)^2 - dot(theta2)^2)*sin(theta1 - theta2)",
    );
}

/// Mass, damping and stiffness of small oscillations about the hanging equilibrium.
fn linearized<'g>(model: &Model<'g>, dynamics: &Dynamics<'g>) -> [[[Expr<'g>; 2]; 2]; 3] {
    let angles = ["theta1", "theta2"].map(|name| symbol(model, name));
    let rates = ["dot(theta1)", "dot(theta2)"].map(|name| symbol(model, name));
    let rest: FxHashMap<_, _> = angles
        .into_iter()
        .chain(rates)
        .map(|x| (x, model.graph.zero()))
        .collect();
    let hanging = |x| model.graph.substitute(&[x], rest.clone())[0];
    let matrix = |entry: &dyn Fn(usize, usize) -> Expr<'g>| [0, 1].map(|i| [0, 1].map(|j| hanging(entry(i, j))));
    let slope = |i: usize, by| Derivative::by(by).of(dynamics.lagrangian.bias[i] - dynamics.lagrangian.force[i]);
    [
        matrix(&|i, j| dynamics.balance.mass_matrix[i][j]),
        matrix(&|i, j| slope(i, rates[j])),
        matrix(&|i, j| slope(i, angles[j])),
    ]
}

/// Printed Eq. 24a has `+ gamma1 theta1'` among the torques. With `gamma1 theta1''` in its place, solving for the
/// accelerations gives all of the printed Eq. 25 except for some powers of `m`: friction in the denominator and in two
/// more entries, and no damping by `gamma1`. The denominator vanishes at `gamma1 = det M/(d^2 m + I)`, the `a` of
/// Section 5.
#[test]
fn the_printed_eq25_is_eq24a_with_an_acceleration_for_a_rate() {
    let graph = Graph::new();
    let (model, dynamics) = dynamics(&graph, EQ22);
    let [mut mass, mut damping, stiffness] = linearized(&model, &dynamics);
    let determinant = |mass: [[Expr<'_>; 2]; 2]| normal_text(mass[0][0] * mass[1][1] - mass[0][1] * mass[1][0]);
    let right = formula(&model, "d^4*m^2 + 3*d^2*m*I + I^2");
    assert_eq!(determinant(mass), normal_text(right));
    assert_formula(&model, "damping of theta1'", damping[0][0], "gamma1 + gamma2");

    let gamma1 = symbol(&model, "gamma1");
    damping[0][0] -= gamma1;
    mass[0][0] -= gamma1;
    let denominator = formula(&model, "d^4*m^2 - gamma1*(d^2*m + I) + 3*d^2*m*I + I^2");
    assert_eq!(determinant(mass), normal_text(denominator));

    // numerators of theta1'' and theta2'' in front of theta1, theta2, theta1' and theta2'
    let numerators = [
        [
            "-2*m*g*d*(d^2*m + I)",
            "m^2*g*d^3",
            "-gamma2*(2*d^2*m + I)",
            "gamma2*(2*d^2*m + I)",
        ],
        [
            "2*m^2*g*d^3",
            "-m*g*d*(2*d^2*m - gamma1 + I)",
            "gamma2*(3*d^2*m - gamma1 + I)",
            "-gamma2*(3*d^2*m - gamma1 + I)",
        ],
    ];
    let [[m11, m12], [m21, m22]] = mass;
    for (row, adjugate) in numerators.iter().zip([[m22, -m12], [-m21, m11]]) {
        for (column, text) in row.iter().enumerate() {
            let torque = if column < 2 { stiffness } else { damping };
            let numerator = -(adjugate[0] * torque[0][column % 2] + adjugate[1] * torque[1][column % 2]);
            assert_formula(&model, "a numerator", numerator, text);
        }
    }
}

/// With `q = T theta`, `A` becomes `T^T A T` and a force `T^T tau`.
#[test]
fn relative_and_absolute_coordinates_are_the_same_motion() {
    let graphs = [Graph::new(), Graph::new()];
    let (_, of_absolute) = dynamics(&graphs[0], &general("theta2 absolute"));
    let (relative, of_relative) = dynamics(&graphs[1], &general("theta2"));
    // the relative angle is theta2 - theta1, in the symbols of the absolute angles
    let mut new: FxHashMap<Expr<'_>, Expr<'_>> = FxHashMap::default();
    for (angle, before) in [("theta2", "theta1"), ("dot(theta2)", "dot(theta1)")] {
        let (angle, before) = (symbol(&relative, angle), symbol(&relative, before));
        new.insert(angle, angle - before);
    }
    let put = |x| relative.graph.substitute(&[x], new.clone())[0];
    let [[a11, a12], [_, a22]] = [0, 1].map(|i| [0, 1].map(|j| put(of_relative.balance.mass_matrix[i][j])));
    // T = [[1, 0], [-1, 1]]
    let pulled_back = [(0, 0, a11 - 2 * a12 + a22), (0, 1, a12 - a22), (1, 1, a22)];
    for (i, j, entry) in pulled_back {
        let expected = normal_text(of_absolute.balance.mass_matrix[i][j]);
        assert_eq!(normal_text(entry), expected, "A[{i}][{j}]");
    }
    for (of_relative, of_absolute) in [
        (&of_relative.lagrangian.bias, &of_absolute.lagrangian.bias),
        (&of_relative.lagrangian.force, &of_absolute.lagrangian.force),
    ] {
        let [first, second] = [0, 1].map(|k| put(of_relative[k]));
        for (ours, theirs) in [(first - second, of_absolute[0]), (second, of_absolute[1])] {
            // A and the acceleration are tensors: T is constant, so no other terms appear
            assert_eq!(normal_text(ours), normal_text(theirs));
        }
    }
    assert_eq!(
        normal_text(of_absolute.lagrangian.potential),
        normal_text(put(of_relative.lagrangian.potential))
    );
}

/// Parameters without influence on a planar motion do not appear, although all screws have six components.
#[test]
fn a_planar_scene_comes_out_planar() {
    let graphs = [Graph::new(), Graph::new()];
    let (_, of_flat) = dynamics(&graphs[0], &general("theta2"));
    let deep = general("theta2")
        .replace(
            "com: [0, -c1, 0], inertia: I1",
            "com: [0, -c1, 0.3], inertia: [2.5, 2.25, I1, 0, 0.125, -0.25]",
        )
        .replace(
            "com: [0, -c2, 0], inertia: I2",
            "com: [0, -c2, -0.7], inertia: [1.5, 1.25, I2, 0, -0.5, 0.0625]",
        )
        .replace("at [0, -d, 0]", "at [0, -d, 1.5]");
    let (_, of_deep) = dynamics(&graphs[1], &deep);
    let flat_entries = of_flat
        .balance
        .mass_matrix
        .concat()
        .into_iter()
        .chain(of_flat.lagrangian.bias);
    let deep_entries = of_deep
        .balance
        .mass_matrix
        .concat()
        .into_iter()
        .chain(of_deep.lagrangian.bias);
    for (flat_entry, deep_entry) in flat_entries.zip(deep_entries) {
        assert_eq!(normal_text(deep_entry), normal_text(flat_entry));
    }
}

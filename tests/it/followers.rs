//! Joints that follow others, against the same scene with independent joints.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{DMatrix, DVector};
use pendulum_codegen::program;

use testbed::random::share;

use crate::random_mechanisms::evaluate::{Evaluator, Place};

/// A scene in space. `{name}` stands for the motion of a joint.
const ARM: &str = "pub Arm {
    gravity: [1, -2, -9.81],
    generate: [rhs, jacobian, energy, mass_matrix, bias, momentum],
    point tip on d at [0.1, 0.2, 0.3],
    output tip: tip,
    force on tip: [0, 2, 1],
    body a on ground { mass: 2, com: [0.1, 0.2, 0.3], inertia: [0.3, 0.4, 0.5, 0.01, 0.02, 0.03],
        joint: revolute([1, 2, -1]) at [0.1, 0, 0.4], {a}, friction: 0.1 }
    body b on a { mass: 1.5, com: [0, -0.3, 0.1], inertia: [0.2, 0.3, 0.25, -0.02, 0.01, 0],
        joint: revolute([1, 2, -1]) at [0.3, 0.1, 0], {b}, spring: (3, 0.5) }
    body c on b { mass: 0.7, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1],
        joint: helical([0.3, 0, 1], 0.2) at [0, 0, 0.5] rpy [0.4, -0.7, 1.1], {c} }
    body d on c { mass: 0.5, com: [0, 0.1, 0.2], inertia: [0.05, 0.06, 0.07, 0.01, 0, 0.02],
        joint: prismatic([1, 1, 0]) rpy [0, 0.3, 0], {d}, torque: 1 - 2 N/m*q - 0.3 N s/m*qd }
    body e on b { mass: 0.3, com: [0, 0.1, 0.2], inertia: [0.05, 0.06, 0.07],
        joint: revolute(-y) at [0, 0.2, 0], {e}, friction: 0.2 }
}";

/// A scene in a plane, whose equations are written out.
const PLANE: &str = "pub Plane {
    gravity: [0, -9.81, 0],
    generate: [rhs, jacobian, energy, mass_matrix, bias, momentum],
    point tip on c at [0.4, 0.1, 0],
    output tip: tip,
    force on tip: [0, 2, 0],
    body a on ground { mass: 2, com: [0.3, 0.1, 0], inertia: 0.2, joint: revolute(z), {a}, friction: 0.1 }
    body b on a { mass: 1.5, com: [0.2, 0, 0], inertia: 0.1, joint: revolute(z) at [0.7, 0, 0], {b}, spring: (3, 0.5) }
    body c on b { mass: 0.7, com: [0.1, -0.2, 0], inertia: 0.1, joint: revolute(z) at [0.5, 0, 0], {c} }
    body d on ground { mass: 0.4, com: [0, 0.1, 0], joint: prismatic([1, 1, 0]), {d}, torque: -2 N/m*q }
}";

#[test]
fn joints_that_follow_move_by_the_equations_of_those_that_do_not() {
    equals_free(
        ARM,
        &[
            ("a", "coordinate: a", [1.0, 0.0], 0.0),
            ("b", "motion: 0.3 - 2*a", [-2.0, 0.0], 0.3),
            ("c", "coordinate: c", [0.0, 1.0], 0.0),
            ("d", "motion: c * 1 m - 0.1", [0.0, 1.0], -0.1),
            ("e", "motion: a + 3*c + 90 deg", [1.0, 3.0], FRAC_PI_2),
        ],
    );
}

#[test]
fn they_follow_by_parts_of_turns() {
    if share(2) == 2 {
        equals_free(
            ARM,
            &[
                ("a", "coordinate: a", [1.0, 0.0], 0.0),
                ("b", "motion: 0.3 - 0.5*a", [-0.5, 0.0], 0.3),
                ("c", "coordinate: c", [0.0, 1.0], 0.0),
                ("d", "motion: c * 0.25 m - 0.1", [0.0, 0.25], -0.1),
                ("e", "motion: 0.77384*a + 2*c/3", [0.77384, 2.0 / 3.0], 0.0),
            ],
        );
        // an angle that follows a length
        equals_free(
            ARM,
            &[
                ("a", "coordinate: a", [1.0, 0.0], 0.0),
                ("b", "motion: 1.5*d * 1 rad/m", [0.0, 1.5], 0.0),
                ("c", "motion: -a/4", [-0.25, 0.0], 0.0),
                ("d", "coordinate: d", [0.0, 1.0], 0.0),
                ("e", "motion: 2.5*d * 1 rad/m - 0.3", [0.0, 2.5], -0.3),
            ],
        );
    }
    let factors = [("0.5", 0.5), ("-1.5", -1.5), ("0.125", 0.125), ("0.333", 0.333)];
    for &(factor, turns) in &factors[..share(4)] {
        equals_free(
            PLANE,
            &[
                ("a", "coordinate: a", [1.0, 0.0], 0.0),
                ("b", &format!("motion: {factor}*a"), [turns, 0.0], 0.0),
                ("c", "coordinate: c", [0.0, 1.0], 0.0),
                ("d", &format!("motion: {factor} m*(a - c)"), [turns, -turns], 0.0),
            ],
        );
    }
}

#[test]
#[ignore = "takes long"]
fn they_follow_joints_above_them() {
    for (factor, turns) in [
        ("1", 1.0),
        ("-1", -1.0),
        ("2", 2.0),
        ("-3", -3.0),
        ("0.5", 0.5),
        ("-0.5", -0.5),
    ] {
        equals_free(
            PLANE,
            &[
                ("a", &format!("motion: {factor}*b + 0.2"), [turns, 0.0], 0.2),
                ("b", "coordinate: b", [1.0, 0.0], 0.0),
                ("c", "coordinate: c", [0.0, 1.0], 0.0),
                ("d", "motion: 0.1 m*c", [0.0, 0.1], 0.0),
            ],
        );
    }
}

/// A joint that follows by a half leads by two: cranks of a five-bar linkage, and wheels one on the other.
#[test]
fn what_follows_by_a_half_leads_by_two() {
    let five_bars = "pub FiveBars {
        gravity: [0, -9.81, 0],
        generate: [rhs, energy],
        shape bar { mass: 1, com: [0.15, 0, 0], inertia: 0.01 }
        body a on ground: bar { joint: revolute(z), {a} }
        body b on ground: bar { joint: revolute(z) at [0.5, 0, 0], {b}, friction: 0.1 }
        body c on a: bar { joint: revolute(z) at [0.3, 0, 0], coordinate: phi depends near 0.55 }
        body d on b: bar { joint: revolute(z) at [0.3, 0, 0], coordinate: psi depends near 0.86, spring: (2, 0.3) }
        close c at [0.4, 0, 0] to d at [0.4, 0, 0]: revolute(z),
    }";
    let half_first = five_bars
        .replace("{a}", "coordinate: p near 0.8")
        .replace("{b}", "motion: 0.5*p + 1");
    let whole_first = five_bars
        .replace("{a}", "motion: 2*p - 2")
        .replace("{b}", "coordinate: p near 1.4");
    let [half, whole] = [half_first, whole_first].map(|text| program(text.parse().expect("tokens")).expect("a scene"));
    let [half, whole] = [&half, &whole].map(|program| Evaluator::new(program, &[]));
    for (p, rate) in [(0.8, 0.3), (0.6, -1.2), (1.1, 2.0)] {
        let place = |state: Vec<f64>| Place {
            t: 0.0,
            state,
            accelerations: Vec::new(),
            inputs: Vec::new(),
        };
        let (first, second) = (place(vec![p, rate]), place(vec![0.5 * p + 1.0, 0.5 * rate]));
        let of =
            |model: &Evaluator<'_>, what: &str, place: &Place| model.routine(what, place).expect("a routine").concat();
        for what in ["kinetic", "potential"] {
            let [a, b] = [of(&half, what, &first)[0], of(&whole, what, &second)[0]];
            assert!((a - b).abs() < 1e-12 * b.abs(), "{what}: {a} {b}");
        }
        let [a, b] = [of(&half, "rhs", &first)[1], 2.0 * of(&whole, "rhs", &second)[1]];
        assert!((a - b).abs() < 1e-11 * b.abs(), "acceleration: {a} {b}");
    }
}

/// Asserts that a scene with the given motions of its joints obeys the equations of the scene with independent joints.
/// With `q = T p + q0` the mass matrix is `T^T A T`, and a force becomes `T^T tau`, since `T` is constant. `joints`
/// gives the row of `T` and the entry of `q0` for each joint.
fn equals_free(scene: &str, joints: &[(&str, &str, [f64; 2], f64)]) {
    let with = |moves: &dyn Fn(&str, &str) -> String| {
        joints.iter().fold(scene.to_owned(), |text, (name, own, ..)| {
            text.replace(&format!("{{{name}}}"), &moves(name, own))
        })
    };
    let free = with(&|name, _| format!("coordinate: {name}")).replace("jacobian, ", "");
    let following = with(&|_, own| own.to_owned());
    let [free, following] = [free, following].map(|text| program(text.parse().expect("tokens")).expect("a scene"));
    let [all, ours] = [&free, &following].map(|program| Evaluator::new(program, &[]));
    let m = joints.len();
    let t = DMatrix::from_fn(m, 2, |row, column| joints[row].2[column]);
    let start = DVector::from_fn(m, |row, _| joints[row].3);
    for n in 0..4 {
        let p = DVector::from_fn(2, |k, _| (f64::from(n) + 1.7 * k as f64).sin());
        let pd = DVector::from_fn(2, |k, _| (2.3 * f64::from(n) - k as f64).cos());
        let place = |positions: &DVector<f64>, rates: &DVector<f64>| Place {
            t: 0.0,
            state: positions.iter().chain(rates.iter()).copied().collect(),
            accelerations: Vec::new(),
            inputs: Vec::new(),
        };
        let (small, large) = (place(&p, &pd), place(&(&t * &p + &start), &(&t * &pd)));
        let of = |model: &Evaluator<'_>, routine: &str, place: &Place| {
            DVector::from_vec(model.routine(routine, place).expect("a routine").concat())
        };
        let close = |what: &str, a: &DMatrix<f64>, b: &DMatrix<f64>| {
            assert!((a - b).amax() < 1e-12 * b.amax(), "{joints:?} {what}: {a} {b}");
        };
        let square = |n: usize, entries: DVector<f64>| entries.reshape_generic(nalgebra::Dyn(n), nalgebra::Dyn(n));
        let matrix = square(m, of(&all, "mass_matrix", &large));
        let reduced = t.transpose() * &matrix * &t;
        close("mass matrix", &square(2, of(&ours, "mass_matrix", &small)), &reduced);
        let column = |v: DVector<f64>| DMatrix::from_column_slice(v.len(), 1, v.as_slice());
        let bias = of(&all, "bias", &large);
        let pulled = |v: &DVector<f64>| column(t.transpose() * v);
        close("bias", &column(of(&ours, "bias", &small)), &pulled(&bias));
        close(
            "momentum",
            &column(of(&ours, "momentum", &small)),
            &pulled(&of(&all, "momentum", &large)),
        );
        for what in ["kinetic", "potential", "tip"] {
            close(what, &column(of(&ours, what, &small)), &column(of(&all, what, &large)));
        }
        // forces along the joints from the accelerations
        let force = &matrix * of(&all, "rhs", &large).rows(m, m) + &bias;
        let rest = t.transpose() * (force - bias);
        let accelerations = reduced.lu().solve(&rest).expect("a regular matrix");
        let (_, jacobian) = split(&of(&ours, "jacobian", &small));
        let differences = DMatrix::from_fn(4, 4, |row, k| {
            let beside = |step: f64| {
                let mut beside = small.clone();
                beside.state[k] += step;
                of(&ours, "rhs", &beside)[row]
            };
            // differences of fourth order
            let slope = |step: f64| (beside(step) - beside(-step)) / (2.0 * step);
            (4.0 * slope(1e-3) - slope(2e-3)) / 3.0
        });
        assert!(
            (&jacobian - &differences).amax() < 1e-8 * jacobian.amax(),
            "{jacobian}{differences}"
        );
        close(
            "acceleration",
            &column(of(&ours, "rhs", &small).rows(2, 2).into_owned()),
            &column(accelerations),
        );
    }
}

/// Right-hand side, followed by the Jacobian.
fn split(both: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
    let n = 4;
    let jacobian = DMatrix::from_column_slice(n, n, &both.as_slice()[n..]);
    (both.rows(0, n).into_owned(), jacobian)
}

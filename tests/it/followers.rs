//! Joints that follow others, beside the same scene in which they move by themselves.

use nalgebra::{DMatrix, DVector};
use pendulum_codegen::program;

use crate::random_mechanisms::evaluate::{Evaluator, Place};

/// A scene in which some of the bodies follow. `{name}` stands for how a joint moves.
const SCENE: &str = "pub Arm {
    gravity: [1, -2, -9.81],
    generate: [rhs, jacobian, energy, mass_matrix, bias, momentum],
    point tip on d at [0.1, 0.2, 0.3],
    output tip: tip,
    force on tip: [0, 2, 1],
    body a on ground { mass: 2, com: [0.1, 0.2, 0.3], inertia: [0.3, 0.4, 0.5, 0.01, 0.02, 0.03],
        joint: revolute([1, 2, -1]) at [0.1, 0, 0.4], coordinate: a, friction: 0.1 }
    body b on a { mass: 1.5, com: [0, -0.3, 0.1], inertia: [0.2, 0.3, 0.25, -0.02, 0.01, 0],
        joint: revolute([1, 2, -1]) at [0.3, 0.1, 0], {b}, spring: (3, 0.5) }
    body c on b { mass: 0.7, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1],
        joint: helical([0.3, 0, 1], 0.2) at [0, 0, 0.5] rpy [0.4, -0.7, 1.1], coordinate: c }
    body d on c { mass: 0.5, com: [0, 0.1, 0.2], inertia: [0.05, 0.06, 0.07, 0.01, 0, 0.02],
        joint: prismatic([1, 1, 0]) rpy [0, 0.3, 0], {d}, torque: 1 - 2 N/m*q - 0.3 N s/m*qd }
    body e on b { mass: 0.3, com: [0, 0.1, 0.2], inertia: [0.05, 0.06, 0.07],
        joint: revolute(-y) at [0, 0.2, 0], {e}, friction: 0.2 }
}";

fn scene(b: &str, d: &str, e: &str) -> String {
    SCENE.replace("{b}", b).replace("{d}", d).replace("{e}", e)
}

/// With `q = T p + q0` the mass matrix is `T^T A T`, and a force `T^T tau`, since `T` is constant.
#[test]
fn joints_that_follow_move_by_the_equations_of_those_that_do_not() {
    let free = scene("coordinate: b", "coordinate: d", "coordinate: e");
    let following = scene("motion: 0.3 - 2*a", "motion: c * 1 m - 0.1", "motion: a + 3*c + 90 deg");
    let [free, following] = [free, following].map(|text| program(text.parse().expect("tokens")).expect("a scene"));
    let [all, ours] = [&free, &following].map(|program| Evaluator::new(program, &[]));
    #[rustfmt::skip]
    let t = DMatrix::from_row_slice(5, 2, &[
        1.0, 0.0,
        -2.0, 0.0,
        0.0, 1.0,
        0.0, 1.0,
        1.0, 3.0,
    ]);
    let start = DVector::from_vec(vec![0.0, 0.3, 0.0, -0.1, std::f64::consts::FRAC_PI_2]);
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
            assert!((a - b).amax() < 1e-12 * b.amax(), "{what}: {a} {b}");
        };
        let square = |n: usize, entries: DVector<f64>| entries.reshape_generic(nalgebra::Dyn(n), nalgebra::Dyn(n));
        let matrix = square(5, of(&all, "mass_matrix", &large));
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
        // the forces along the joints are what accelerates them
        let force = &matrix * of(&all, "rhs", &large).rows(5, 5) + &bias;
        let rest = t.transpose() * (force - bias);
        let accelerations = reduced.lu().solve(&rest).expect("a regular matrix");
        let (_, jacobian) = split(&of(&ours, "jacobian", &small));
        let differences = DMatrix::from_fn(4, 4, |row, k| {
            let beside = |step: f64| {
                let mut beside = small.clone();
                beside.state[k] += step;
                of(&ours, "rhs", &beside)[row]
            };
            // of fourth order
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

/// The right-hand side, and the Jacobian after it.
fn split(both: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
    let n = 4;
    let jacobian = DMatrix::from_column_slice(n, n, &both.as_slice()[n..]);
    (both.rows(0, n).into_owned(), jacobian)
}

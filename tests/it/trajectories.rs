//! Generated models against reference trajectories computed in 45 digits, at the times of the reference.
//!
//! The scene `stiff_axles` is not included: it takes some 270000 steps of an explicit method, and is tested with the
//! implicit methods.

use nalgebra::SVector;
use pendulum_core::prelude::*;
use testbed::mechanisms::{Chain5, Elbow3, Furuta, ScrewJoint, Tree};
use testbed::plates::{Plates, PlatesParams, TripleChain};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};
use testbed::trajectories::{Scene, scene};

const TOLERANCE: f64 = 1e-10;

/// Largest error at the times of a scene up to `last`, in units of the tolerance.
fn error<const N: usize>(model: &impl System<f64, N>, scene: &Scene, last: f64) -> f64 {
    let points = scene.points::<N>();
    let end = points
        .iter()
        .map(|(t, _)| *t)
        .filter(|t| *t <= last)
        .fold(0.0, f64::max);
    let method = Rk45::new().rtol(TOLERANCE).atol(TOLERANCE);
    let solution = method.solve(model, 0.0, end, scene.start()).expect("regular");
    let at = |t: f64| solution.at(t).expect("within the span");
    let compared = points.into_iter().filter(|(t, _)| *t <= end);
    compared
        .map(|(t, state)| (at(t) - SVector::from(state)).amax() / TOLERANCE)
        .fold(0.0, f64::max)
}

fn double_pendulum(scene: &Scene) -> DoublePendulum {
    let [upper, lower] = scene.bodies[..] else {
        panic!("two bodies")
    };
    let testbed::trajectories::Body {
        mass: m,
        inertia,
        c,
        d,
        friction: gamma1,
    } = upper;
    let params = DoublePendulumParams {
        m,
        inertia,
        c,
        d,
        g: scene.g,
        gamma1,
        gamma2: lower.friction,
    };
    DoublePendulum::new(params).expect("physical")
}

/// The tolerance bounds the error of a step. Over 20 s the errors of some hundred steps add up, while friction damps
/// the older ones.
#[test]
fn the_scenes_of_the_paper() {
    for name in ["paper_gamma_1", "paper_gamma_0.4", "paper_gamma_0.1"] {
        let scene = scene(name);
        let error = error(&double_pendulum(&scene), &scene, 20.0);
        assert!(error < 20.0, "{name}: {error} tolerances");
    }
}

/// Neighbouring motions diverge like `exp(1.45 t)`: until 10 s an error of 1e-10 grows by six powers of ten in the
/// worst direction.
#[test]
fn the_large_swing() {
    let scene = scene("large_swing");
    let model = double_pendulum(&scene);
    let early = error(&model, &scene, 2.0);
    assert!(early < 20.0, "to 2 s: {early} tolerances");
    let late = error(&model, &scene, 10.0);
    assert!(late < 1000.0, "to 10 s: {late} tolerances");
}

#[test]
fn different_plates() {
    let scene = scene("irregular_plates");
    let [upper, lower] = scene.bodies[..] else {
        panic!("two bodies")
    };
    let params = PlatesParams {
        m1: upper.mass,
        m2: lower.mass,
        inertia1: upper.inertia,
        inertia2: lower.inertia,
        c1: upper.c,
        c2: lower.c,
        d: upper.d,
        g: scene.g,
        gamma1: upper.friction,
        gamma2: lower.friction,
    };
    let error = error(&Plates::new(params).expect("physical"), &scene, 10.0);
    assert!(error < 40.0, "{error} tolerances");
}

#[test]
fn three_rods() {
    let scene = scene("triple_chain");
    let model = TripleChain::new(Default::default()).expect("physical");
    let error = error(&model, &scene, 5.0);
    assert!(error < 200.0, "{error} tolerances");
}

/// RK4 at half the step has a sixteenth of the error.
#[test]
fn rk4_converges_with_its_order() {
    let scene = scene("paper_gamma_0.1");
    let model = double_pendulum(&scene);
    let (t, state) = scene.points::<4>()[2];
    let error = |h: f64| {
        let solution = Rk4::new(h).solve(&model, 0.0, t, scene.start()).expect("regular");
        (solution.end() - SVector::from(state)).amax()
    };
    let order = (error(0.02) / error(0.01)).log2();
    assert!((order - 4.0).abs() < 0.1, "observed order {order}");
}

macro_rules! loses_energy_only_to_friction {
    ($($test:ident: $model:ident, $dof:literal;)*) => {$(
        /// Spatial motions have no reference trajectories, but their energy must never increase.
        #[test]
        fn $test() {
            let model = $model::new(Default::default()).expect("physical");
            let start = SVector::<f64, { 2 * $dof }>::from_fn(|n, _| 0.4 + 0.3 * n as f64);
            let solution = Rk45::new().rtol(TOLERANCE).atol(TOLERANCE).solve(&model, 0.0, 3.0, start).expect("regular");
            let energies: Vec<f64> = solution.x().iter().map(|x| model.energy(0.0, x)).collect();
            let scale = energies.iter().fold(0.0_f64, |most, e| most.max(e.abs()));
            assert!(energies.windows(2).all(|pair| pair[1] < pair[0] + 1e-8 * scale), "energy rises");
            let (first, last) = (energies[0], energies[energies.len() - 1]);
            assert!(last < first - 1e-4 * scale, "friction takes nothing: {first} J, {last} J");
        }
    )*};
}

loses_energy_only_to_friction! {
    chain5_loses_energy: Chain5, 5;
    furuta_loses_energy: Furuta, 2;
    screw_joint_loses_energy: ScrewJoint, 2;
    elbow3_loses_energy: Elbow3, 3;
    tree_loses_energy: Tree, 4;
}

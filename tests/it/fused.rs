//! Integrations in fused arithmetic: the engine on numbers of that type, with times, states and events in `f64`.

use nalgebra::SVector;
use pendulum_core::prelude::*;
use pendulum_core::real::Fused;
use pendulum_core::sensitivity::{self, Variable};
use pendulum_core::{EnsembleError, Reason};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

mechanism! {
    /// A rod with dry friction between stops.
    pub Door {
        gravity: [0, -9.81, 0],
        body leaf on ground {
            solids: [rod(1, [0, 0, 0], [0, -1, 0])],
            joint: revolute(z), coordinate: angle,
            dry_friction: 0.2, static_friction: 0.4, stop: [-0.5, 0.7] restitution(0.4),
        }
    }
}

const START: [f64; 4] = [1.0, 0.5, 0.0, 0.0];

fn pendulum() -> DoublePendulum {
    DoublePendulum::new(DoublePendulumParams::default()).expect("physical")
}

fn fused<const N: usize>(x: SVector<f64, N>) -> SVector<Fused<f64>, N> {
    x.map(Fused)
}

fn plain<const N: usize>(x: &SVector<Fused<f64>, N>) -> SVector<f64, N> {
    x.map(|x| x.0)
}

#[test]
fn trajectories_are_those_of_the_number_type() {
    let model = pendulum();
    let method = Vern9::new().rtol(1e-10).atol(1e-10);
    let own = method.fused().solve(&model, 0.0, 10.0, START).expect("regular");
    let cast = model.cast::<Fused<f64>>();
    let expected = method
        .solve(&cast, Fused(0.0), Fused(10.0), fused(SVector::from(START)))
        .expect("regular");
    assert!(
        own.t()
            .iter()
            .zip(expected.t())
            .all(|(own, expected)| *own == expected.0)
    );
    assert!(
        own.x()
            .iter()
            .zip(expected.x())
            .all(|(own, expected)| *own == plain(expected))
    );
    assert_eq!(own.statistics(), expected.statistics());
    let between = expected.at(Fused(3.3)).expect("within the span");
    assert_eq!(own.at(3.3).expect("within the span"), plain(&between));
    // other bits than those of `f64`, to the same accuracy
    let in_f64 = method.solve(&model, 0.0, 10.0, START).expect("regular");
    let difference = (own.end() - in_f64.end()).amax();
    assert!(difference > 0.0 && difference < 1e-8, "{difference:e}");
}

#[test]
fn events_reset_states_and_end_trajectories() {
    let model = pendulum();
    let events = || {
        [
            Event::new(|_, x: &SVector<f64, 4>| x[0]).reset(|_, x| SVector::from([x[0], x[1], -x[2], -x[3]])),
            Event::new(|t, _| t - 2.0).terminal(),
        ]
    };
    let method = Rk45::new().rtol(1e-10).atol(1e-10);
    let own = method
        .fused()
        .solve_with(&model, 0.0, 10.0, START, &events())
        .expect("regular");
    let in_f64 = method.solve_with(&model, 0.0, 10.0, START, &events()).expect("regular");
    assert_eq!(own.events().len(), in_f64.events().len());
    assert!(own.events().len() > 2, "several resets: {}", own.events().len());
    for (own, in_f64) in own.events().iter().zip(in_f64.events()) {
        assert_eq!(own.index, in_f64.index);
        assert!((own.t - in_f64.t).abs() < 1e-8 && (own.x - in_f64.x).amax() < 1e-7);
    }
    assert_eq!(own.last().0, 2.0);
    let mut recorded = Solution::start(0.0, SVector::from(START));
    let end = method
        .fused()
        .follow(&model, 0.0, 10.0, START, &events(), &mut recorded)
        .expect("regular");
    assert_eq!((end, recorded.x()), (own.end(), own.x()));
}

#[test]
fn hybrid_systems_switch_modes() {
    let model = Door::new(DoorParams::default()).expect("physical");
    let method = Tsit5::new().rtol(1e-9).atol(1e-9);
    let own = method.fused().solve(&model, 0.0, 3.0, [0.2, 4.0]).expect("regular");
    let in_f64 = method.solve(&model, 0.0, 3.0, [0.2, 4.0]).expect("regular");
    assert!(own.impacts().len() > 1);
    assert_eq!(own.impacts().len(), in_f64.impacts().len());
    let modes = |solution: &Solution<f64, 2>| -> Vec<_> { solution.modes().iter().map(|(_, mode)| *mode).collect() };
    assert_eq!(modes(&own), modes(&in_f64));
    assert!((own.end() - in_f64.end()).amax() < 1e-7);
}

#[test]
fn ensembles_end_as_trajectories_alone() {
    let model = pendulum();
    let starts: Vec<SVector<f64, 4>> = (0..11).map(|i| SVector::from(START) * (0.1 * f64::from(i))).collect();
    let method = Rk4::new(0.01).fused();
    let ends = method
        .ensemble(std::slice::from_ref(&model), 0.0, 1.0, &starts)
        .expect("regular");
    for (start, end) in starts.iter().zip(&ends) {
        assert_eq!(*end, method.solve(&model, 0.0, 1.0, *start).expect("regular").end());
    }
}

/// Compares derivatives in fused arithmetic with those in `f64`, and their values with the motion alone.
macro_rules! assert_derivatives {
    ($method:expr, $model:expr, $start:expr, $by:expr) => {
        let (method, model, start, by) = ($method, $model, $start, $by);
        let fused = method.fused();
        let (x, derivatives) = sensitivity::end(&fused, model, 0.0, 2.0, start, by).expect("regular");
        assert_eq!(x, fused.solve(model, 0.0, 2.0, start).expect("regular").end());
        let (_, expected) = sensitivity::end(&method, model, 0.0, 2.0, start, by).expect("regular");
        let error = (derivatives - expected).amax() / expected.amax();
        assert!(error > 0.0 && error < 1e-11, "{method:?}: {error:e}");
        let motion = sensitivity::solve(&fused, model, 0.0, 2.0, start, by).expect("regular");
        assert_eq!(motion.end(), (x, derivatives));
    };
}

#[test]
fn derivatives_are_those_of_motions_in_fused_arithmetic() {
    let (model, by) = (pendulum(), [Variable::Start(1), Variable::Parameter(2)]);
    assert_derivatives!(Vern9::new().rtol(1e-10).atol(1e-10), &model, START, by);
    assert_derivatives!(Taylor::new().rtol(1e-10).atol(1e-10), &model, START, by);
    assert_derivatives!(Rodas5P::new().rtol(1e-8).atol(1e-8), &model, START, by);
    assert_derivatives!(Rk4::new(0.01), &model, START, by);
    let door = Door::new(DoorParams::default()).expect("physical");
    let by = [Variable::Start(0), Variable::Start(1)];
    assert_derivatives!(Tsit5::new().rtol(1e-9).atol(1e-9), &door, [0.2, 4.0], by);
}

#[test]
fn derivatives_in_lanes_are_those_of_trajectories_alone() {
    let (model, by) = (pendulum(), [Variable::Start(0), Variable::Parameter(0)]);
    let starts: Vec<SVector<f64, 4>> = (1..12).map(|i| SVector::from(START) * (0.1 * f64::from(i))).collect();
    let method = Tsit5::new().fused();
    let ends = sensitivity::ensemble(&method, std::slice::from_ref(&model), 0.0, 1.0, &starts, by).expect("regular");
    for (start, end) in starts.iter().zip(&ends) {
        let alone = sensitivity::end(&method, &model, 0.0, 1.0, *start, by);
        assert_eq!(*end, alone.expect("regular"));
    }
}

#[test]
fn errors_hold_the_last_good_state() {
    let model = pendulum();
    let method = Vern7::new().max_steps(10).fused();
    let error = method.solve(&model, 0.0, 1e3, START).expect_err("too many steps");
    assert!(matches!(error.reason, Reason::TooManySteps { .. }), "{error}");
    assert_eq!(error.solution.t().len(), 11);
    let error = method.solve(&model, 0.0, f64::NAN, START).expect_err("no time");
    assert_eq!(error.solution.x(), [SVector::from(START)]);
    let starts = [SVector::from(START); 3];
    let error = method
        .ensemble(&[model], 0.0, 1e3, &starts)
        .expect_err("too many steps");
    let EnsembleError::Stopped { stopped, x } = error else {
        panic!("{error}");
    };
    assert!(stopped.iter().map(|stopped| stopped.index).eq(0..3));
    let alone = method.solve(&model, 0.0, 1e3, START).expect_err("too many steps");
    assert!(x.iter().all(|x| *x == alone.solution.end()));
}

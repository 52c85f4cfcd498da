//! Ensembles under sampled controllers have the bits of trajectories alone.

use nalgebra::SVector;
use pendulum_core::EnsembleError;
use pendulum_core::Reason;
use pendulum_core::control::{LinearLaw, Sampled};
use pendulum_core::prelude::*;
use testbed::random::Random;

use super::{HOLD, Robot, RobotParams, START};
use crate::control::{Quadrotor, QuadrotorParams};

const COUNT: usize = 37;

fn robots() -> Vec<Robot> {
    let lengths = (0..COUNT).map(|i| 0.3 + 0.01 * i as f64);
    lengths
        .map(|l2| {
            Robot::new(RobotParams {
                l2,
                ..Default::default()
            })
            .expect("physical")
        })
        .collect()
}

fn starts() -> Vec<SVector<f64, 4>> {
    let mut random = Random::new(5);
    (0..COUNT)
        .map(|_| SVector::from(START.map(|x| x + random.between(-0.5, 0.5))))
        .collect()
}

macro_rules! agree {
    ($($method:expr),* $(,)?) => { $({
        let (robots, starts) = (robots(), starts());
        // delays of a part of a period, of less than one, and of several
        for delay in [0.0, 0.0123, 0.05] {
            let sampled = Sampled::new(HOLD, 0.02)
                .delay(delay)
                .limits([-8.0; 2], [8.0; 2])
                .noise([0.01, 0.01, 0.1, 0.1])
                .input_noise([0.1; 2])
                .resolution([1e-3; 4])
                .seed(9)
                .member(100);
            let ends = sampled.ensemble(&$method, &robots, 0.5, 1.5, &starts).expect("motions");
            for i in 0..COUNT {
                let alone = sampled.member(100 + i as u64).end(&$method, &robots[i], 0.5, 1.5, starts[i]);
                assert_eq!(ends[i], alone.expect("a motion"), "{} {delay} {i}", stringify!($method));
            }
        }
    })* };
}

#[test]
fn lanes_have_the_bits_of_trajectories_alone() {
    agree!(
        Rk4::new(0.007),
        Tsit5::new().rtol(1e-8).atol(1e-8),
        Vern7::new(),
        Vern9::new().rtol(1e-11).atol(1e-11).h_max(0.006),
        Tsit5::new().h0(1e-4),
        Rodas5P::new(),
    );
}

#[test]
fn methods_that_do_not_run_in_lanes_have_them_too() {
    agree!(Auto::new(), Radau5::new());
}

#[test]
fn orientations_are_normalized_as_they_are_alone() {
    let models = [Quadrotor::new(QuadrotorParams::default()).expect("physical")];
    let hover = LinearLaw {
        gain: nalgebra::SMatrix::<f64, 4, 13>::from_fn(|m, n| 0.01 * ((m + 2 * n) % 5) as f64 - 0.02),
        x0: SVector::zeros(),
        u0: [2.0; 4],
    };
    let starts: Vec<_> = (0..9)
        .map(|i| {
            let mut x = SVector::<f64, 13>::zeros();
            let angle = 0.1 * f64::from(i);
            (x[Quadrotor::O], x[Quadrotor::O + 1]) = (angle.cos(), angle.sin());
            x[12] = 0.3;
            x
        })
        .collect();
    let sampled = Sampled::new(hover, 0.01).noise([1e-3; 13]);
    for method in [Vern7::new(), Vern7::new().h_max(0.004)] {
        let ends = sampled.ensemble(&method, &models, 0.0, 1.0, &starts).expect("motions");
        for (i, start) in starts.iter().enumerate() {
            let alone = sampled
                .member(i as u64)
                .end(&method, &models[0], 0.0, 1.0, *start)
                .expect("a motion");
            assert_eq!(ends[i], alone, "{i}");
        }
    }
}

/// Commands that are infinite from some angle on.
#[derive(Clone, Debug, PartialEq)]
struct Fails;

impl pendulum_core::InputLaw<4, 2> for Fails {
    fn inputs<T: pendulum_core::Real>(&self, _t: T, x: &SVector<T, 4>) -> [T; 2] {
        [(T::from_f64(1.5) - x[0]).ln(), T::default()]
    }
}

#[test]
fn trajectories_stop_by_themselves() {
    let (robots, mut starts) = (robots(), starts());
    for start in &mut starts {
        start[2] = 0.0;
    }
    starts[3][0] = f64::NAN;
    for i in [7, 30] {
        (starts[i][0], starts[i][2]) = (1.4, 5.0);
    }
    let sampled = Sampled::new(Fails, 0.01);
    let error = sampled
        .ensemble(&Tsit5::new(), &robots, 0.0, 0.3, &starts)
        .expect_err("stops");
    let EnsembleError::Stopped { stopped, x } = error else {
        panic!("{error}");
    };
    assert_eq!(
        stopped.iter().map(|stopped| stopped.index).collect::<Vec<_>>(),
        [3, 7, 30]
    );
    assert_eq!(stopped[0].t, 0.0);
    assert!(matches!(stopped[0].reason, Reason::InvalidInput { what: "x0", .. }));
    for stopped in &stopped[1..] {
        assert!(matches!(stopped.reason, Reason::CommandNotFinite { input: 0, t } if t == stopped.t && t > 0.0));
        let before = sampled.end(
            &Tsit5::new(),
            &robots[stopped.index],
            0.0,
            stopped.t,
            starts[stopped.index],
        );
        assert_eq!(before, Ok(x[stopped.index]));
    }
    for i in [0, 20, 36] {
        assert_eq!(sampled.end(&Tsit5::new(), &robots[i], 0.0, 0.3, starts[i]), Ok(x[i]));
    }
}

#[test]
fn steps_that_end_early_stop_a_trajectory_as_alone() {
    let few = Tsit5::new().max_steps(3).rtol(1e-10).atol(1e-10);
    let sampled = Sampled::new(HOLD, 0.05);
    let error = sampled
        .ensemble(&few, &robots(), 0.0, 1.0, &starts())
        .expect_err("stops");
    let EnsembleError::Stopped { stopped, x } = error else {
        panic!("{error}");
    };
    assert!(!stopped.is_empty());
    for stopped in stopped {
        let i = stopped.index;
        let alone = sampled
            .solve(&few, &robots()[i], 0.0, 1.0, starts()[i])
            .expect_err("stops");
        assert_eq!((alone.reason, alone.t(), alone.x()), (stopped.reason, stopped.t, x[i]));
    }
}

#[test]
fn one_model_serves_all_starts_and_other_numbers_do_not() {
    let sampled = Sampled::new(HOLD, 0.02);
    let starts = starts();
    let ends = sampled
        .ensemble(&Rk4::new(0.01), &robots()[..1], 0.0, 1.0, &starts)
        .expect("motions");
    assert_eq!(
        sampled.end(&Rk4::new(0.01), &robots()[0], 0.0, 1.0, starts[8]),
        Ok(ends[8])
    );
    let wrong = sampled.ensemble(&Rk4::new(0.01), &robots()[..2], 0.0, 1.0, &starts);
    assert!(matches!(wrong, Err(EnsembleError::InvalidInput(_))));
    assert_eq!(
        sampled.ensemble(&Rk4::new(0.01), &[] as &[Robot], 0.0, 1.0, &[]),
        Ok(vec![])
    );
}

/// Gains, limits, noise and its seed by the trajectory; with one clock they share lanes, with several they do not.
#[test]
fn each_trajectory_may_have_a_controller_of_its_own() {
    let (robots, starts, method) = (robots(), starts(), Tsit5::new());
    let controllers = |period: &dyn Fn(usize) -> f64| -> Vec<_> {
        let controller = |i: usize| {
            let law = LinearLaw {
                gain: HOLD.gain * (1.0 + 0.02 * i as f64),
                ..HOLD
            };
            let sampled = Sampled::new(law, period(i)).delay(0.5 * period(i)).noise([1e-3; 4]);
            sampled.limits([-6.0 - i as f64; 2], [8.0; 2]).seed(i as u64)
        };
        (0..COUNT).map(controller).collect()
    };
    for period in [&|_| 0.02, &|i| 0.02 + 0.001 * (i % 3) as f64] as [&dyn Fn(usize) -> f64; 2] {
        let controllers = controllers(period);
        let ends = Sampled::ensemble_of(&controllers, &method, &robots, 0.0, 1.0, &starts).expect("motions");
        for i in 0..COUNT {
            let alone = controllers[i].end(&method, &robots[i], 0.0, 1.0, starts[i]);
            assert_eq!(Ok(ends[i]), alone, "{i}");
        }
    }
    // settings that are out of range stop one trajectory, or all
    let mut controllers = controllers(&|_| 0.02);
    controllers[5] = controllers[5].noise([-1.0; 4]);
    let error = Sampled::ensemble_of(&controllers, &method, &robots, 0.0, 1.0, &starts).expect_err("stops");
    let EnsembleError::Stopped { stopped, x } = error else {
        panic!("{error}");
    };
    assert_eq!((stopped.len(), stopped[0].index, stopped[0].t), (1, 5, 0.0));
    assert!(matches!(stopped[0].reason, Reason::InvalidInput { what: "noise", .. }));
    assert_eq!(x[5], starts[5]);
    let none = vec![Sampled::new(HOLD, 0.0); COUNT];
    let error = Sampled::ensemble_of(&none, &method, &robots, 0.0, 1.0, &starts).expect_err("no period");
    assert!(matches!(error, EnsembleError::Stopped { stopped, .. } if stopped.len() == COUNT));
    let wrong = Sampled::ensemble_of(&controllers[..2], &method, &robots, 0.0, 1.0, &starts);
    assert!(matches!(
        wrong,
        Err(EnsembleError::InvalidInput(Reason::InvalidInput {
            what: "controllers",
            ..
        }))
    ));
}

//! Limits, resolutions and noise of sensors and actuators.

use nalgebra::SVector;
use pendulum_core::control::{Pid, Sampled};
use pendulum_core::prelude::*;
use pendulum_core::{InputLaw, Real};

use super::{Cart, HOLD, HOLD_CART, START, cart, robot, tight};

/// The law that holds the robot, within limits of its own.
#[derive(Clone, Debug, PartialEq)]
struct Clamped;

impl InputLaw<4, 2> for Clamped {
    fn inputs<T: Real>(&self, t: T, x: &SVector<T, 4>) -> [T; 2] {
        let [shoulder, elbow] = HOLD.inputs(t, x);
        let [low, high] = [-3.0, 9.0].map(T::from_f64);
        [
            shoulder.at_least(low).at_most(high),
            elbow.at_least(T::from_f64(-2.5)).at_most(T::from_f64(2.5)),
        ]
    }
}

#[test]
fn commands_beyond_the_limits_are_clamped() {
    let sampled = Sampled::new(HOLD, 0.01).limits([-3.0, -2.5], [9.0, 2.5]);
    let motion = sampled.solve(&tight(), &robot(), 0.0, 2.0, START).expect("a motion");
    let clamped = Sampled::new(Clamped, 0.01)
        .end(&tight(), &robot(), 0.0, 2.0, START)
        .expect("a motion");
    assert_eq!(motion.trajectory.end(), clamped);
    let limited = motion
        .samples
        .iter()
        .filter(|sample| sample.sent != sample.command)
        .count();
    assert!((20..190).contains(&limited), "{limited}");
    assert!(
        motion
            .samples
            .iter()
            .all(|sample| sample.sent == Clamped.inputs(sample.t, &sample.measured))
    );
}

#[test]
fn measurements_and_commands_are_rounded_to_their_resolution() {
    let (angle, torque) = (0.01, 0.25);
    let sampled = Sampled::new(HOLD, 0.01)
        .resolution([angle, angle, 0.0, 0.0])
        .input_resolution([torque, 0.0])
        .limits([-3.1, -9.0], [9.1, 9.0]);
    let motion = sampled
        .solve(&Vern7::new(), &robot(), 0.0, 2.0, START)
        .expect("a motion");
    let is_multiple = |number: f64, step: f64| (number / step).round() * step == number;
    let mut limited = 0;
    for sample in &motion.samples {
        let x = motion.trajectory.at(sample.t).expect("regular");
        for n in 0..4 {
            let step = [angle, angle, 0.0, 0.0][n];
            assert!((sample.measured[n] - x[n]).abs() <= 0.5 * step + 1e-12);
            assert!(step == 0.0 || is_multiple(sample.measured[n], step));
        }
        let [shoulder, elbow] = sample.command;
        if [-3.1, 9.1].contains(&sample.sent[0]) {
            limited += 1;
        } else {
            assert!(is_multiple(sample.sent[0], torque) && (sample.sent[0] - shoulder).abs() <= 0.5 * torque);
        }
        assert_eq!(sample.sent[1], elbow.clamp(-9.0, 9.0));
    }
    assert!((1..150).contains(&limited), "{limited}");
}

#[test]
fn noise_has_its_deviation_and_is_a_function_of_seed_and_member() {
    let sampled = Sampled::new(HOLD_CART, 1e-3).noise([0.02, 0.0]).input_noise([0.5]);
    let motion = |sampled: Sampled<_, _, 2, 1>| {
        sampled
            .solve(&Rk4::new(1e-3), &cart(), 0.0, 10.0, [0.5, 0.0])
            .expect("a motion")
    };
    let first = motion(sampled);
    let count = first.samples.len() as f64;
    let square = |number: &dyn Fn(usize) -> f64| {
        ((0..first.samples.len()).map(|k| number(k).powi(2)).sum::<f64>() / count).sqrt()
    };
    let x = |k: usize| first.trajectory.at(first.samples[k].t).expect("regular");
    let [measured, input] = [
        square(&|k| first.samples[k].measured[0] - x(k)[0]) / 0.02,
        square(&|k| first.samples[k].inputs[0] - first.samples[k].sent[0]) / 0.5,
    ];
    // four standard errors of a deviation over 10,000 samples
    assert!(
        (measured - 1.0).abs() < 0.03 && (input - 1.0).abs() < 0.03,
        "{measured} {input}"
    );
    assert!((0..first.samples.len()).all(|k| first.samples[k].measured[1] == x(k)[1]));
    assert_eq!(motion(sampled).samples, first.samples);
    assert_ne!(motion(sampled.seed(1)).samples, first.samples);
    assert_ne!(motion(sampled.member(1)).samples, first.samples);
    // noise depends on the number of a sample, not on the motion
    let other = sampled
        .solve(&Rk4::new(5e-4), &cart(), 3.0, 4.0, [9.0, 2.0])
        .expect("a motion");
    let noise = |sample: &pendulum_core::control::Sample<f64, 2, 1>| sample.inputs[0] - sample.sent[0];
    for k in 0..1000 {
        assert!((noise(&other.samples[k]) - noise(&first.samples[k])).abs() < 1e-12);
    }
}

#[test]
fn outputs_may_be_components_or_functions() {
    let pid = Pid::new(30.0, 0.0, 4.0);
    let by_index = Sampled::of_components(pid, 0.01, [Cart::S]);
    let by_function = Sampled::of_outputs(pid, 0.01, |_t, x: &SVector<f64, 2>| [x[0]]);
    let end = by_index
        .end(&Vern7::new(), &cart(), 0.0, 1.0, [1.0, 0.0])
        .expect("a motion");
    assert_eq!(by_function.end(&Vern7::new(), &cart(), 0.0, 1.0, [1.0, 0.0]), Ok(end));
    // a moving set point: follows a ramp at a constant distance, here without a spring
    let free = super::Cart::new(super::CartParams { m: 2.0, k: 0.0, c: 0.0 }).expect("physical");
    let follow = Sampled::of_outputs(pid, 0.01, |t: f64, x: &SVector<f64, 2>| [x[0] - 0.5 * t]);
    let end = follow
        .end(&Vern7::new(), &free, 0.0, 20.0, [0.0, 0.5])
        .expect("a motion");
    assert!((end - SVector::from([10.0, 0.5])).amax() < 1e-9, "{end}");
}

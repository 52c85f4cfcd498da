//! Events under sampled controllers: located between samples, by one search over the whole motion.

use nalgebra::SVector;
use pendulum_core::control::Sampled;
use pendulum_core::prelude::*;
use pendulum_core::{InputLaw, Real, Reason};

use super::modes::{Block, block};
use super::{CartInputs, HOLD_CART, cart};

#[test]
fn an_event_is_located_between_samples() {
    let sampled = Sampled::new(HOLD_CART, 0.05).delay(0.02);
    let solve = |events: &[Event<'_, f64, 2>]| {
        let motion = sampled.solve_with(&Vern9::new(), &cart(), 0.0, 2.0, [1.0, 0.0], events);
        motion.expect("a motion")
    };
    let passes = || Event::new(|_t, x: &SVector<f64, 2>| x[0] - 0.7);
    let (free, seen, ended) = (solve(&[]), solve(&[passes()]), solve(&[passes().terminal()]));
    // recording changes nothing
    assert_eq!(
        (seen.trajectory.end(), &seen.samples),
        (free.trajectory.end(), &free.samples)
    );
    let [event] = seen.trajectory.events() else {
        panic!("{:?}", seen.trajectory.events());
    };
    let x = free.trajectory.at(event.t).expect("regular");
    assert!(
        (x[0] - 0.7).abs() < 1e-14 && (x - event.x).amax() < 1e-14,
        "{event:?} {x}"
    );
    assert!((0.005..0.045).contains(&(event.t % 0.05)), "{event:?}");
    // it ends there, after the samples before
    assert_eq!(ended.trajectory.last(), (event.t, event.x));
    assert_eq!(ended.samples, free.samples[..(event.t / 0.05).ceil() as usize]);
}

/// Zeros at samples, which end one part of the motion and begin the next.
#[test]
fn an_event_at_a_sample_occurs_once() {
    let sampled = Sampled::new(HOLD_CART, 0.125);
    let at = |t: f64| Event::new(move |now, _x: &SVector<f64, 2>| now - t);
    let saw = Event::new(|t: f64, _x: &SVector<f64, 2>| (t * 4.0 * std::f64::consts::PI).sin());
    let motion = sampled
        .solve_with(&Tsit5::new(), &cart(), 0.0, 2.0, [1.0, 0.0], &[at(0.25), at(1.0), saw])
        .expect("a motion");
    let times = |index: usize| -> Vec<f64> {
        let events = motion.trajectory.events().iter();
        events
            .filter(|event| event.index == index)
            .map(|event| event.t)
            .collect()
    };
    assert_eq!((times(0), times(1)), (vec![0.25], vec![1.0]));
    let zeros = times(2);
    assert!((8..=9).contains(&zeros.len()), "{zeros:?}");
    assert!(
        zeros
            .iter()
            .enumerate()
            .all(|(k, t)| (t - 0.25 * k as f64).abs() < 1e-14),
        "{zeros:?}"
    );
    let ended = sampled.solve_with(&Tsit5::new(), &cart(), 0.0, 2.0, [1.0, 0.0], &[at(1.0).terminal()]);
    let ended = ended.expect("a motion");
    assert_eq!((ended.trajectory.last().0, ended.samples.len()), (1.0, 8));
}

/// A cart that rebounds from a wall, beside a loop over the samples, each interval of which is solved by itself.
#[test]
fn a_reset_leaves_the_inputs_as_they_are() {
    let wall = || {
        let hits = Event::new(|_t, x: &SVector<f64, 2>| x[0] - 0.2).falling();
        hits.reset(|_t, x| SVector::from([0.2, -0.6 * x[1]]))
    };
    let method = Rk4::new(0.0125);
    let motion = Sampled::new(HOLD_CART, 0.05)
        .solve_with(&method, &cart(), 0.0, 1.0, [1.0, -3.0], &[wall()])
        .expect("a motion");
    assert_eq!(motion.trajectory.events().len(), 1);
    let mut x = SVector::from([1.0, -3.0]);
    for k in 0..20 {
        let [t, end] = [k, k + 1].map(|k| f64::from(k) * 0.05);
        let [push] = HOLD_CART.inputs(t, &x);
        let held = cart().with_inputs(move |_t, _x| CartInputs { push });
        let part = method.solve_with(&held, t, end, x, &[wall()]);
        x = part.expect("a motion").end();
    }
    assert_eq!(motion.trajectory.end(), x);
}

/// No push.
#[derive(Clone, Debug, PartialEq)]
struct Nothing;

impl InputLaw<2, 1> for Nothing {
    fn inputs<T: Real>(&self, _t: T, _measured: &SVector<T, 2>) -> [T; 1] {
        [T::default()]
    }
}

/// A block at rest that gets a speed at a sample, where the inputs stay as they are.
#[test]
fn a_reset_at_a_sample_begins_another_mode() {
    let kick = Event::new(|t, _x: &SVector<f64, 2>| t - 0.1).reset(|_t, x| SVector::from([x[0], 1.0]));
    let motion = Sampled::new(Nothing, 0.1)
        .solve_with(&Tsit5::new(), &block(), 0.0, 1.0, [0.1, 0.0], &[kick])
        .expect("a motion");
    // 2 m/s^2 of friction stop it within half a second and a quarter of a metre
    let end = motion.trajectory.end() - SVector::from([0.35, 0.0]);
    assert!(end.amax() < 1e-9, "{end}");
    let modes = motion.trajectory.modes();
    let held: Vec<bool> = modes.iter().map(|(_, mode)| mode.is_held(Block::S)).collect();
    assert_eq!(held, [true, false, true], "{modes:?}");
    assert_eq!(
        motion.samples[1].measured[1], 1.0,
        "the sample is taken after the event"
    );
}

#[test]
fn an_event_that_is_not_finite_is_named_with_its_time() {
    let root = Event::new(|t: f64, _x: &SVector<f64, 2>| (0.52 - t).sqrt());
    let error = Sampled::new(HOLD_CART, 0.05)
        .solve_with(&Rk4::new(0.05), &cart(), 0.0, 1.0, [1.0, 0.0], &[root])
        .expect_err("not a number");
    let Reason::EventNotFinite { event: 0, t } = error.reason else {
        panic!("{error}");
    };
    assert!((0.52..=0.55).contains(&t), "{t}");
}

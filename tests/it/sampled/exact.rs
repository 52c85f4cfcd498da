//! Motions between samples: exact, at the cost of the steps.

use nalgebra::SVector;
use pendulum_core::control::{Commanded, Sampled};
use pendulum_core::dense::Dense;
use pendulum_core::dual::Dual;
use pendulum_core::prelude::*;
use pendulum_core::{InputLaw, Need, Observer, Statistics, WithInputs};

use super::{HOLD, Robot, RobotInputs, START, Wave, cart, robot, tight};

/// Work of a motion of which nothing is recorded.
#[derive(Default)]
struct Work(Statistics);

impl<T, const N: usize> Observer<T, N> for Work {
    fn needs(&self, _t0: T, _t1: T) -> Need {
        Need::Nothing
    }

    fn step(&mut self, _dense: &Dense<'_, T, N>) {}

    fn finish(&mut self, statistics: Statistics) {
        self.0 = statistics;
    }
}

type Law = Box<dyn Fn(f64, &SVector<f64, 4>) -> RobotInputs>;

/// Final state of a loop over the samples, each interval of which is solved by itself.
fn by_hand<A>(method: &A, period: f64, samples: usize) -> SVector<f64, 4>
where
    A: for<'a> Method<WithInputs<Robot, Law, 2>, f64, 4>,
{
    let mut x = SVector::from(START);
    for k in 0..samples {
        let [t, end] = [k, k + 1].map(|k| k as f64 * period);
        let [shoulder, elbow] = HOLD.inputs(t, &x);
        let held: Law = Box::new(move |_t, _x| RobotInputs { shoulder, elbow });
        x = method
            .solve(&robot().with_inputs(held), t, end, x)
            .expect("a motion")
            .end();
    }
    x
}

#[test]
fn a_motion_is_that_of_a_loop_over_the_samples() {
    let sampled = Sampled::new(HOLD, 1e-3);
    let rk4 = Rk4::new(2.5e-4);
    let end = sampled.end(&rk4, &robot(), 0.0, 2.0, START).expect("a motion");
    assert_eq!(end, by_hand(&rk4, 1e-3, 2000));
    // one step a period, as long as that
    let vern7 = Vern7::new().h0(1e-3);
    let end = sampled.end(&vern7, &robot(), 0.0, 2.0, START).expect("a motion");
    assert_eq!(end, by_hand(&vern7, 1e-3, 2000));
    let slow = Sampled::new(HOLD, 0.02)
        .end(&tight(), &robot(), 0.0, 2.0, START)
        .expect("a motion");
    assert!((slow - by_hand(&tight(), 0.02, 100)).amax() < 1e-11);
}

#[test]
fn a_record_has_the_end_and_is_held_between_samples() {
    let sampled = Sampled::new(HOLD, 0.03);
    let motion = sampled
        .solve(&Vern7::new(), &robot(), 1.0, 2.0, START)
        .expect("a motion");
    let end = sampled.end(&Vern7::new(), &robot(), 1.0, 2.0, START).expect("a motion");
    assert_eq!((motion.trajectory.last(), motion.samples.len()), ((2.0, end), 34));
    for (k, sample) in motion.samples.iter().enumerate() {
        assert_eq!(sample.t, 1.0 + 0.03 * k as f64);
        assert_eq!(
            (sample.measured, sample.acts_from),
            (motion.trajectory.at(sample.t).expect("regular"), sample.t)
        );
        assert_eq!(sample.command, HOLD.inputs(sample.t, &sample.measured));
        assert_eq!([sample.sent, sample.inputs], [sample.command; 2]);
        assert_eq!(motion.inputs_at(sample.t + 0.029), sample.inputs);
    }
    assert_eq!(motion.inputs_at(0.5), [0.0; 2]);
    // the motion satisfies the equations with the held inputs
    let [shoulder, elbow] = motion.samples[10].inputs;
    let held = robot().with_inputs(move |_t, _x| RobotInputs { shoulder, elbow });
    let (t, h) = (motion.samples[10].t, 0.02);
    let expected = tight()
        .solve(&held, t, t + h, motion.samples[10].measured)
        .expect("a motion")
        .end();
    assert!((motion.trajectory.at(t + h).expect("regular") - expected).amax() < 1e-7);
}

/// Evaluations of 10 s at 1 kHz, relative to those of 10,000 plain steps.
fn share<A>(method: &A) -> f64
where
    A: for<'c> Method<WithInputs<Robot, Commanded<'c, f64, 2>, 2>, f64, 4>,
    A: Method<WithInputs<Robot, fn(f64, &SVector<f64, 4>) -> RobotInputs, 2>, f64, 4>,
{
    let (mut sampled, mut plain) = (Work::default(), Work::default());
    let span = (0.0, 10.0);
    Sampled::new(HOLD, 1e-3)
        .follow(method, &robot(), span, START, &[], &mut sampled, |_| {})
        .expect("a motion");
    let free: fn(f64, &SVector<f64, 4>) -> RobotInputs = |_t, _x| RobotInputs {
        shoulder: 1.0,
        elbow: 0.5,
    };
    method
        .follow(&robot().with_inputs(free), 0.0, 10.0, START, &[], &mut plain)
        .expect("a motion");
    assert_eq!([sampled.0.accepted, sampled.0.rejected], [10_000, 0]);
    assert!((9_999..=10_001).contains(&plain.0.accepted), "{:?}", plain.0);
    sampled.0.evaluations as f64 / plain.0.evaluations as f64
}

#[test]
fn a_sample_costs_one_evaluation() {
    let shares = [
        share(&Rk4::new(1e-3)),
        share(&Tsit5::new().h0(1e-3).h_max(1e-3)),
        share(&Vern7::new().h0(1e-3).h_max(1e-3)),
    ];
    for (share, expected) in shares.into_iter().zip([5.0 / 4.0, 7.0 / 6.0, 11.0 / 10.0]) {
        assert!((share - expected).abs() < 1e-3, "{shares:?}");
    }
}

#[test]
fn steps_keep_their_length_across_short_intervals() {
    // commands act 2 us after a sample, where a step of 2 us ends
    let count = |delay: f64| {
        let (mut work, sampled) = (Work::default(), Sampled::new(HOLD, 0.02).delay(delay));
        sampled
            .follow(&Tsit5::new(), &robot(), (0.0, 2.0), START, &[], &mut work, |_| {})
            .expect("a motion");
        work.0.accepted + work.0.rejected
    };
    let (without, with) = (count(0.0), count(2e-6));
    assert!(with <= without + 150, "{without} {with}");
}

#[test]
fn the_maximum_number_of_steps_counts_between_samples() {
    let sampled = Sampled::new(HOLD, 1e-3);
    let few = Tsit5::new().max_steps(10);
    assert!(sampled.end(&few, &robot(), 0.0, 1.0, START).is_ok());
    let error = Sampled::new(HOLD, 1.0)
        .end(&few, &robot(), 0.0, 1.0, START)
        .expect_err("too few");
    assert_eq!(error, pendulum_core::Reason::TooManySteps { max_steps: 10 });
}

#[test]
fn derivatives_pass_from_sample_to_sample() {
    let sampled = Sampled::new(HOLD, 0.02).delay(0.013);
    let end = |x: [f64; 4]| sampled.end(&tight(), &robot(), 0.0, 1.0, x).expect("a motion");
    let dual = SVector::<Dual<f64, 1>, 4>::from_fn(|n, _| match n {
        0 => Dual::variable(START[0], 0),
        _ => Dual::constant(START[n]),
    });
    let method = Vern9::new().rtol(1e-13).atol(1e-14);
    let (t0, t1) = (Dual::constant(0.0), Dual::constant(1.0));
    let found = sampled
        .end(&method, &robot().cast::<Dual<f64, 1>>(), t0, t1, dual)
        .expect("a motion");
    let [ahead, behind] = [1e-5, -1e-5].map(|by| end([START[0] + by, START[1], START[2], START[3]]));
    for n in 0..4 {
        assert_eq!(found[n].value, end(START)[n]);
        assert!((found[n].slopes[0] - (ahead[n] - behind[n]) / 2e-5).abs() < 1e-7);
    }
}

#[test]
fn single_precision_and_stiff_methods_agree() {
    let sampled = Sampled::new(HOLD, 0.01).delay(0.004);
    let end = sampled.end(&tight(), &robot(), 0.0, 1.0, START).expect("a motion");
    let single = robot().cast::<f32>();
    let rough = sampled
        .end(&Tsit5::new(), &single, 0.0, 1.0, START.map(|x| x as f32))
        .expect("a motion");
    assert!((rough.map(f64::from) - end).amax() < 1e-3);
    for stiff in [
        sampled.end(&Rodas5P::new().rtol(1e-9).atol(1e-10), &robot(), 0.0, 1.0, START),
        sampled.end(&Radau5::new().rtol(1e-9).atol(1e-10), &robot(), 0.0, 1.0, START),
        sampled.end(&Auto::new().rtol(1e-9).atol(1e-10), &robot(), 0.0, 1.0, START),
    ] {
        assert!((stiff.expect("a motion") - end).amax() < 1e-6);
    }
}

#[test]
fn a_linear_motion_is_that_of_the_discretized_model() {
    use pendulum_core::control::linearize;
    let (period, law) = (0.05, super::HOLD_CART);
    let linear = linearize(&cart(), 0.0, [0.0; 2], [0.0])
        .expect("regular")
        .discretize(period)
        .expect("regular");
    let mut x = SVector::from([1.0, 0.0]);
    for k in 0..100 {
        let inputs: [f64; 1] = law.inputs(k as f64 * period, &x);
        x = linear.a * x + linear.b * inputs[0];
    }
    let end = Sampled::new(law, period)
        .end(&tight(), &cart(), 0.0, 5.0, [1.0, 0.0])
        .expect("a motion");
    assert!((end - x).amax() < 1e-12, "{}", (end - x).amax());
}

#[test]
fn a_delay_shifts_the_commands() {
    // whole periods, parts of one, both, almost none
    for delay in [0.02, 0.1, 0.007, 0.093, 0.019_999] {
        let sampled = Sampled::new(Wave { late: 0.0 }, 0.02).delay(delay).start([0.3, -0.2]);
        let end = sampled.end(&tight(), &robot(), 0.0, 1.0, START).expect("a motion");
        let held = robot().with_inputs(|_t, _x| RobotInputs {
            shoulder: 0.3,
            elbow: -0.2,
        });
        let waited = tight().solve(&held, 0.0, delay, START).expect("a motion").end();
        let late = Sampled::new(Wave { late: delay }, 0.02);
        let expected = late.end(&tight(), &robot(), delay, 1.0, waited).expect("a motion");
        assert!((end - expected).amax() < 1e-11, "{delay}: {}", (end - expected).amax());
        let record = sampled.solve(&tight(), &robot(), 0.0, 1.0, START).expect("a motion");
        assert_eq!(record.inputs_at(delay - 1e-9), [0.3, -0.2]);
        assert_eq!(record.inputs_at(delay + 0.02 + 1e-9), record.samples[1].inputs);
    }
}

//! Settings out of range, commands that are not finite, and laws that jump.

use nalgebra::SVector;
use pendulum_core::Reason;
use pendulum_core::control::{ControlError, LinearLaw, MAX_DELAY, Sampled, linearize};
use pendulum_core::prelude::*;

use super::{Cart, CartInputs, HOLD_CART, cart};

type Whole = Sampled<LinearLaw<2, 1>, pendulum_core::control::WholeState, 2, 1>;

/// Reason and message of a motion from 0 s to 1 s.
fn refused(sampled: Whole) -> (Reason, String) {
    let reason = sampled
        .end(&Rk4::new(0.01), &cart(), 0.0, 1.0, [1.0, 0.0])
        .expect_err("refused");
    let error = sampled
        .solve(&Tsit5::new(), &cart(), 0.0, 1.0, [1.0, 0.0])
        .expect_err("refused");
    assert_eq!((error.t(), error.x()), (0.0, SVector::from([1.0, 0.0])));
    assert_eq!(error.reason.to_string(), reason.to_string());
    let starts = [SVector::from([1.0, 0.0])];
    let in_lanes = sampled
        .ensemble(&Rk4::new(0.01), &[cart()], 0.0, 1.0, &starts)
        .expect_err("refused");
    assert_eq!(in_lanes.to_string(), reason.to_string());
    (reason, reason.to_string())
}

#[test]
fn settings_out_of_range_are_named_with_what_to_pass() {
    let sampled = Sampled::new(HOLD_CART, 0.01);
    let what = |sampled| match refused(sampled) {
        (Reason::InvalidInput { what, value, .. }, text) => {
            assert!(
                text.contains(": pass ") || text.contains("lengthen") || text.contains("finite"),
                "{text}"
            );
            (what, value)
        }
        (other, _) => panic!("{other}"),
    };
    for period in [0.0, -0.1, f64::INFINITY] {
        assert_eq!(what(Sampled::new(HOLD_CART, period)), ("period", period));
    }
    assert_eq!(what(Sampled::new(HOLD_CART, 1e-16)), ("period", 1e-16));
    assert!(matches!(what(Sampled::new(HOLD_CART, f64::NAN)), ("period", value) if value.is_nan()));
    for delay in [-1e-3, f64::INFINITY, 0.3201, 1e300] {
        assert_eq!(what(sampled.delay(delay)), ("delay", delay));
    }
    assert!(refused(sampled.delay(0.33)).1.contains("at most 32 periods") && MAX_DELAY == 32);
    assert!(
        sampled
            .delay(0.32)
            .end(&Rk4::new(0.01), &cart(), 0.0, 1.0, [1.0, 0.0])
            .is_ok()
    );
    assert_eq!(what(sampled.limits([1.0], [-1.0])), ("limits", 1.0));
    assert!(matches!(what(sampled.limits([f64::NAN], [1.0])), ("limits", _)));
    assert_eq!(what(sampled.start([f64::INFINITY])), ("start", f64::INFINITY));
    assert_eq!(what(sampled.noise([0.1, -0.1])), ("noise", -0.1));
    assert_eq!(
        what(sampled.input_noise([f64::INFINITY])),
        ("input_noise", f64::INFINITY)
    );
    assert_eq!(what(sampled.resolution([-1.0, 0.0])), ("resolution", -1.0));
    assert_eq!(what(sampled.input_resolution([-1.0])), ("input_resolution", -1.0));
}

#[test]
fn limits_that_exclude_the_start_are_an_error_with_both() {
    let (reason, text) = refused(Sampled::new(HOLD_CART, 0.01).limits([1.0], [5.0]));
    let limits = [1.0, 5.0];
    assert_eq!(
        reason,
        Reason::StartBeyondLimits {
            input: 0,
            start: 0.0,
            limits
        }
    );
    assert_eq!(
        text,
        "input 0 is 0.0 before the first command, beyond its limits of 1.0 and 5.0; pass inputs within them to \
         `start`, or check the limits"
    );
    let within = Sampled::new(HOLD_CART, 0.01).limits([1.0], [5.0]).start([1.0]);
    assert!(within.end(&Rk4::new(0.01), &cart(), 0.0, 1.0, [1.0, 0.0]).is_ok());
}

#[test]
fn spans_and_components_are_checked() {
    let sampled = Sampled::new(HOLD_CART, 0.01);
    let back = sampled.end(&Rk4::new(0.01), &cart(), 1.0, 0.0, [1.0, 0.0]);
    assert!(matches!(back, Err(Reason::InvalidInput { what: "t1", .. })), "{back:?}");
    let endless = sampled.end(&Rk4::new(0.01), &cart(), 0.0, f64::INFINITY, [1.0, 0.0]);
    assert!(
        matches!(endless, Err(Reason::InvalidInput { what: "t1", .. })),
        "{endless:?}"
    );
    let pid = pendulum_core::control::Pid::new(1.0, 0.0, 0.0);
    let missing = Sampled::of_components(pid, 0.01, [2]).end(&Rk4::new(0.01), &cart(), 0.0, 1.0, [1.0, 0.0]);
    assert!(
        matches!(
            missing,
            Err(Reason::InvalidInput {
                what: "components",
                value: 2.0,
                ..
            })
        ),
        "{missing:?}"
    );
    let long = sampled
        .solve(&Rk4::new(0.01), &cart(), 0.0, 1.1e5, [1.0, 0.0])
        .expect_err("too much to store");
    assert!(
        long.to_string().contains("more than ten million samples to store"),
        "{long}"
    );
    assert_eq!(
        sampled.end(&Rk4::new(0.01), &cart(), 1.0, 1.0, [1.0, 0.5]),
        Ok(SVector::from([1.0, 0.5]))
    );
    let empty = sampled
        .solve(&Rk4::new(0.01), &cart(), 1.0, 1.0, [1.0, 0.5])
        .expect("a point");
    assert_eq!((empty.samples.len(), empty.trajectory.t()), (0, &[1.0][..]));
}

#[test]
fn a_command_that_is_not_finite_is_named_with_its_time() {
    let law = LinearLaw {
        gain: nalgebra::SMatrix::<f64, 1, 2>::new(-1e200, 0.0),
        ..HOLD_CART
    };
    let error = Sampled::new(law, 0.01)
        .solve(&Rk4::new(0.01), &cart(), 0.0, 1.0, [1.0, 0.0])
        .expect_err("overflow");
    let Reason::CommandNotFinite { input: 0, t } = error.reason else {
        panic!("{error}");
    };
    assert_eq!((t, error.t()), (0.01, 0.01));
    assert!(
        error
            .to_string()
            .contains("the command for input 0 is not finite at t = 0.01"),
        "{error}"
    );
}

#[test]
fn a_filter_needs_a_discretized_model() {
    let linear = linearize(&cart(), 0.0, [0.0; 2], [0.0])
        .expect("regular")
        .with_outputs(|_t, x, _u| [x[Cart::S]]);
    let law = linear
        .lqr(&nalgebra::SMatrix::identity(), &nalgebra::SMatrix::identity())
        .expect("regular")
        .law;
    let filter = linear
        .kalman(&nalgebra::SMatrix::identity(), &nalgebra::SMatrix::identity())
        .expect("regular");
    let error = linear.output_feedback(&law, &filter).expect_err("continuous");
    assert_eq!(error, ControlError::Continuous);
    assert!(error.to_string().contains("help: use `model.discretize(period)`"));
}

#[test]
fn a_law_that_is_sampled_by_its_time_is_named_as_one_that_jumps() {
    let held = |t: f64, x: &SVector<f64, 2>| CartInputs {
        push: ((1000.0 * t).floor() * 0.01).sin() - x[0],
    };
    let error = Tsit5::new()
        .max_steps(2000)
        .solve(&cart().with_inputs(held), 0.0, 10.0, [1.0, 0.0])
        .expect_err("jumps");
    assert!(matches!(error.reason, Reason::Jump { component: 1, .. }), "{error}");
    let text = error.to_string();
    assert!(
        text.contains("if a law is sampled or noisy, run it by `control::Sampled`"),
        "{text}"
    );
    assert!(!text.contains("stiff"), "{text}");
}

#[test]
fn too_many_steps_point_to_laws_that_jump_before_stiff_methods() {
    let text = Reason::TooManySteps { max_steps: 7 }.to_string();
    let [sampled, stiff] = ["`control::Sampled`", "stiff"].map(|word| text.find(word).expect("named"));
    assert!(sampled < stiff, "{text}");
}

//! A controller that samples: inputs that jump at known times.

use std::error::Error;

use pendulum_core::Real;
use pendulum_core::control::{LinearLaw, Sampled};
use pendulum_core::prelude::*;

use super::Answer;

mechanism! {
    /// A cart on a spring, pushed by a motor.
    pub Cart {
        params { m: kg = 1, k: N/m = 20, c: N s/m = 0.5 }
        input push: N,
        body cart on ground {
            mass: m, joint: prismatic(x), coordinate: s, spring: (k, 0), friction: c, torque: push,
        }
    }
}

/// Gains in N/m and N s/m, the sampling period and the delay in s.
pub(crate) const LAW: ([f64; 2], f64, f64) = ([4.0, 2.0], 0.1, 0.03);
/// Initial state, and the end in s.
pub(crate) const STEP: ([f64; 2], f64) = ([1.0, 0.0], 2.0);

/// Position and rate at the end.
pub(crate) fn end() -> Result<SVector<f64, 2>, Box<dyn Error>> {
    let cart = Cart::new(CartParams::default())?;
    let (gain, period, delay) = LAW;
    let law = LinearLaw {
        gain: SMatrix::from([[gain[0]], [gain[1]]]),
        x0: SVector::zeros(),
        u0: [0.0],
    };
    let sampled = Sampled::new(law, period).delay(delay);
    let (start, end) = STEP;
    Ok(sampled
        .solve(&Vern9::new().rtol(1e-13).atol(1e-13), &cart, 0.0, end, start)?
        .trajectory
        .end())
}

/// Position and rate after `time` under a constant push: a damped oscillation about the place where it holds the
/// spring.
fn under(push: f64, x: [f64; 2], time: f64) -> [f64; 2] {
    let (k, half) = (20.0, 0.25);
    let frequency = f64::sqrt(k - half * half);
    let (sin, cos) = Real::sin_cos(frequency * time);
    let (away, rate) = (x[0] - push / k, x[1]);
    let decay = Real::exp(-half * time);
    [
        push / k + decay * (away * cos + (rate + half * away) / frequency * sin),
        decay * (rate * cos - (half * rate + k * away) / frequency * sin),
    ]
}

/// Position and rate at the end in closed form.
pub(crate) fn exact() -> SVector<f64, 2> {
    let ([stiff, damped], period, delay) = LAW;
    let (mut x, mut push) = (STEP.0, 0.0);
    for _ in 0..(STEP.1 / period).round() as usize {
        let command = -stiff * x[0] - damped * x[1];
        x = under(command, under(push, x, delay), period - delay);
        push = command;
    }
    x.into()
}

pub(crate) fn answer() -> Result<Answer, Box<dyn Error>> {
    let error = (end()? - exact()).abs().max();
    let samples = (STEP.1 / LAW.1).round();
    Ok(Answer::new(
        error,
        format!("after {samples} samples the error is {error:.0e} m"),
    ))
}

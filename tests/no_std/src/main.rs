//! A double pendulum without `std` and without a heap: a model, and each kind of method step by step.
//!
//! It exits with 0 if all methods agree, and otherwise with a number that identifies the failure. `check` runs it, and
//! searches it for symbols that must not be in it.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use pendulum_core::Reason;
use pendulum_core::control::{Ilqr, Pid, Quadratic, Sampled};
use pendulum_core::prelude::*;

mechanism! {
    /// Two plates on axles with friction. Events and shapes require `std`, and leave no trace here.
    pub DoublePendulum {
        params { m: kg = 1, inertia: kg m^2 = 1, l: m = 1, gamma: N m s = 0.1 }
        gravity: [0, -9.8, 0],
        generate: [rhs, jacobian, energy, taylor, canonical, shapes],
        shape plate { mass: m, com: [0, -l, 0], inertia: inertia }
        body upper on ground: plate { joint: revolute(z), coordinate: theta1,
            torque: -gamma * 1 rad/s * tanh(qd * 1 s) }
        body lower on upper: plate { joint: revolute(z) at [0, -l, 0], coordinate: theta2 absolute, friction: gamma }
        event bottom: theta1,
        output height: cos(theta1),
    }
}

mechanism! {
    /// A cart under a force chosen by the program.
    pub Cart {
        input push: N,
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, torque: push }
    }
}

const START: [f64; 4] = [2.0, 2.5, 0.0, 0.0];
const END: f64 = 2.0;

/// Final state of the motion by a method.
fn end<M: Method<DoublePendulum, f64, 4>>(method: &M, model: &DoublePendulum) -> Result<SVector<f64, 4>, Reason> {
    method.stepper(model, 0.0, END, START)?.run()
}

/// Number of the first failure, or 0.
fn run() -> Result<u8, Reason> {
    let Ok(model) = DoublePendulum::new(DoublePendulumParams::default()) else {
        return Ok(1);
    };
    let wrong = DoublePendulumParams {
        m: -1.0,
        ..DoublePendulumParams::default()
    };
    if DoublePendulum::new(wrong).is_ok() {
        return Ok(2);
    }
    let expected = end(&Vern9::new().rtol(1e-12).atol(1e-12), &model)?;
    let ends = [
        end(&Rk4::new(1e-3), &model)?,
        end(&Rk45::new().rtol(1e-10).atol(1e-10), &model)?,
        end(&Taylor::new().rtol(1e-10).atol(1e-10), &model)?,
        end(&Rodas5P::new().rtol(1e-10).atol(1e-10), &model)?,
        end(&Radau5::new().rtol(1e-10).atol(1e-10), &model)?,
        end(&Auto::new().rtol(1e-10).atol(1e-10), &model)?,
        end(&Gauss6::new(1e-2), &model)?,
    ];
    for (place, end) in (3..).zip(ends) {
        if !((end - expected).amax() < 1e-7) {
            return Ok(place);
        }
    }
    // the first time at the bottom, step by step: the event function and the dense output are available
    let mut stepper = Tsit5::new().stepper(&model, 0.0, END, START)?;
    while let Some(step) = stepper.step()? {
        if model.bottom(step.t1, &step.x1) > 0.0 {
            continue;
        }
        let (dense, mut from, mut to) = (stepper.dense(), step.t0, step.t1);
        for _ in 0..50 {
            let t = 0.5 * (from + to);
            *(if model.bottom(t, &dense.at(t)) > 0.0 {
                &mut from
            } else {
                &mut to
            }) = t;
        }
        return Ok(if dense.at(to)[DoublePendulum::THETA1].abs() < 1e-9 {
            controlled()?
        } else {
            20
        });
    }
    Ok(21)
}

/// A loop of fixed steps in single precision, as in a controller.
fn controlled() -> Result<u8, Reason> {
    let Ok(cart) = Cart::new(CartParams {}) else {
        return Ok(30);
    };
    let braked = cart.cast::<f32>().with_inputs(|_t, x| CartInputs {
        push: -4.0 * x[Cart::DOT_S],
    });
    let mut stepper = Rk4::new(0.01).stepper(&braked, 0.0, 1.0, [0.0_f32, 1.0])?;
    let end = stepper.run()?;
    if !((end[Cart::DOT_S] - 0.135_335).abs() < 1e-5) {
        return Ok(31);
    }
    // with a period, a delay and noise
    let pid = Pid::new(20.0, 0.0, 10.0).set_point(1.0);
    let sampled = Sampled::of_components(pid, 0.01, [Cart::S]).delay(0.005).noise([1e-4]);
    let end = sampled.end(&Rk4::new(0.01), &cart, 0.0, 5.0, [0.0, 0.0])?;
    if !((end[Cart::S] - 1.0).abs() < 0.01) {
        return Ok(32);
    }
    // planned anew at each sample, in single precision
    let cost = Quadratic::diagonal([1.0_f32, 0.1], [0.01]).goal([1.0, 0.0], [0.0]);
    let mut ilqr = Ilqr::<_, _, 2, 1, 40>::new(0.05, cost).limits([-5.0], [5.0]);
    let cart = cart.cast::<f32>();
    let mut x = SVector::from([0.0, 0.0]);
    for k in 0..100 {
        let t = 0.05 * k as f32;
        ilqr.shift();
        if ilqr.pass(&cart, t, x).is_err() {
            return Ok(33);
        }
        let push = ilqr.inputs()[0];
        let pushed = cart.with_inputs(|_t, _x| push.into());
        x = Rk4::new(0.05).stepper(&pushed, t, t + 0.05, x)?.run()?;
    }
    Ok(if (x[Cart::S] - 1.0).abs() < 0.01 { 0 } else { 34 })
}

#[unsafe(no_mangle)]
extern "C" fn main() -> i32 {
    run().map_or(99, i32::from)
}

// Program start, `memcpy` and the like, which a controller has from its own runtime.
#[cfg(not(target_os = "none"))]
#[link(name = "c")]
unsafe extern "C" {
    safe fn abort() -> !;
}

#[cfg(target_os = "none")]
fn abort() -> ! {
    loop {
        core::hint::spin_loop();
    }
}

/// The installed `core` was built with unwinding, and refers to this symbol. Nothing unwinds here.
#[unsafe(no_mangle)]
extern "C" fn rust_eh_personality() {}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    abort()
}

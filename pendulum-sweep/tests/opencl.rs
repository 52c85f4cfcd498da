//! Ensembles on a device: `cargo test --features opencl`; skipped without OpenCL.
#![cfg(feature = "opencl")]

use std::error::Error;

use pendulum_core::prelude::*;
use pendulum_core::{EnsembleError, Reason};
use pendulum_sweep::opencl::{Declared, Device, KernelMethod};
use pendulum_sweep::{Draw, Sweep, SweepError, declared};

declared! {
    /// Two rods, the lower one of any length, with parameters named like keywords of OpenCL C.
    pub Double {
        params {
            /// The lower mass.
            m: kg = 1.0,
            kernel: m = 1.0,
            gamma: N m s = 0.1,
        }
        gravity: [0, -9.81, 0],
        body upper on ground {
            mass: 1, inertia: 0.1, com: [0, -0.5, 0], joint: revolute(z), coordinate: half, friction: gamma,
        }
        body lower on upper {
            mass: m, com: [0, -kernel, 0], joint: revolute(z) at [0, -1, 0], coordinate: beta,
            torque: sqrt(1 + t^2/1 s^2)*0.1 N m - gamma*qd*abs(qd)*1 s/rad,
        }
    }
}

declared! {
    /// Diverges to infinity in finite time.
    Runaway {
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: q*q*q*1 N/m^3 }
    }
}

declared! {
    Stuck {
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, dry_friction: 1 }
    }
}

/// Returns the first device; otherwise prints the reason.
fn device() -> Option<Device> {
    let device = Device::first();
    device.inspect_err(|error| eprintln!("skipped: {error}")).ok()
}

const SPAN: (f64, f64) = (0.0, 3.0);

fn starts() -> Vec<SVector<f64, 4>> {
    let angle = |n: usize| (n as f64 * 0.71).sin() * 3.0;
    (0..301)
        .map(|n| SVector::from([angle(n), angle(3 * n + 1), angle(7 * n), 2.0]))
        .collect()
}

fn doubles() -> Result<Vec<Double>, Box<dyn Error>> {
    let double = |n: usize| {
        let n = n as f64;
        Ok(Double::new(DoubleParams {
            m: 1.0 + 0.001 * n,
            kernel: 0.5 + 0.01 * n,
            gamma: 0.1 / (1.0 + n),
        })?)
    };
    (0..301).map(double).collect()
}

/// Descriptions of the stopped trajectories, and the final states of all.
fn outcome<const N: usize>(ends: Result<Vec<SVector<f64, N>>, EnsembleError<f64, N>>) -> (Vec<String>, String) {
    let (stopped, x) = match ends {
        Ok(x) => (Vec::new(), x),
        Err(EnsembleError::Stopped { stopped, x }) => (stopped, x),
        Err(other) => panic!("{other}"),
    };
    let said = |s: &pendulum_core::ensemble::Stopped| format!("{} {:?} {}", s.index, s.t, s.reason);
    (stopped.iter().map(said).collect(), format!("{x:?}"))
}

/// Checks that an ensemble on the CPU equals that on the device, bit for bit, in both directions of time.
fn assert_same<X>(method: X)
where
    X: std::fmt::Debug
        + KernelMethod
        + Ensemble<Double, f64, 4>
        + Method<Double, f64, 4>
        + Method<Double<f32>, f32, 4>
        + Clone,
{
    let Some(device) = device() else { return };
    let on_device = device.method(method.clone()).expect("a kernel");
    let (models, starts) = (doubles().expect("models"), starts());
    for (t0, t1) in [SPAN, (1.0, 0.7), (1.0, 1.0)] {
        let expected = outcome(method.ensemble(&models, t0, t1, &starts));
        let found = outcome(on_device.ensemble(&models, t0, t1, &starts));
        assert_eq!(found, expected, "{on_device:?} from {t0} to {t1}");
    }
}

#[test]
fn fixed_steps_have_the_same_bits() {
    assert_same(Rk4::new(0.01));
    // a shorter last step, and a last step that absorbs rounding
    assert_same(Rk4::new(0.007));
    assert_same(Rk4::new(3.0 / 171.0));
}

#[test]
fn steps_within_a_tolerance_have_the_same_bits() {
    assert_same(Rk45::new());
    assert_same(Tsit5::new().rtol(1e-10).atol(1e-12));
    assert_same(Vern7::new().rtol(1e-9).atol(1e-9));
    assert_same(Vern9::new().rtol(1e-13).atol(1e-13).h0(1e-3).h_max(0.2));
}

#[test]
fn trajectories_that_stop_say_why() -> Result<(), Box<dyn Error>> {
    let Some(device) = device() else { return Ok(()) };
    let models = [Runaway::new(RunawayParams {})?];
    let starts = [[1.0, 1.0], [0.0, 0.0], [f64::NAN, 0.0], [1e200, 0.0], [0.01, 0.0]].map(SVector::from);
    macro_rules! assert_same {
        ($($method:expr),*) => { $(
            let expected = outcome($method.ensemble(&models, 0.0, 10.0, &starts));
            assert!(expected.0.len() >= 2, "{expected:?}");
            assert_eq!(outcome(device.method($method)?.ensemble(&models, 0.0, 10.0, &starts)), expected);
        )* };
    }
    assert_same!(
        Rk4::new(0.01),
        Rk45::new(),
        Rk45::new().max_steps(20),
        Tsit5::new().h_min(0.05),
        Vern7::new()
    );
    Ok(())
}

/// Checks that the errors are about those of `f32` in Rust.
#[test]
fn single_precision_is_that_of_f32() -> Result<(), Box<dyn Error>> {
    let Some(device) = device() else { return Ok(()) };
    let (models, starts) = (doubles()?, starts());
    let exact = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .ensemble(&models, 0.0, 1.0, &starts)?;
    let error = |ends: &[SVector<f64, 4>]| {
        let errors = ends.iter().zip(&exact).map(|(end, exact)| (end - exact).amax());
        errors.fold(0.0, f64::max)
    };
    macro_rules! assert_near {
        ($method:expr) => {{
            let on_device = device.method_in_single($method)?.ensemble(&models, 0.0, 1.0, &starts)?;
            let alone = |(model, start): (&Double, &SVector<f64, 4>)| {
                let end = $method
                    .solve(&model.cast::<f32>(), 0.0, 1.0, start.map(|x| x as f32))?
                    .end();
                Ok(end.map(f64::from))
            };
            let alone = models
                .iter()
                .zip(&starts)
                .map(alone)
                .collect::<Result<Vec<_>, Box<dyn Error>>>()?;
            let (found, expected) = (error(&on_device), error(&alone));
            assert!(
                found < 3.0 * expected && expected < 3.0 * found,
                "{found:e} {expected:e}"
            );
        }};
    }
    assert_near!(Rk4::new(0.01));
    assert_near!(Rk45::new());
    Ok(())
}

#[test]
fn what_kernels_do_not_take_is_said() -> Result<(), Box<dyn Error>> {
    let Some(device) = device() else { return Ok(()) };
    let refused = device.method::<Stuck, _>(Rk4::new(0.1)).expect_err("dry friction");
    let expected =
        "`Stuck` has inputs, dry friction, stops or walls, which kernels do not take: integrate it on the CPU";
    assert_eq!(refused.to_string(), expected);
    let models = [Runaway::new(RunawayParams {})?];
    let wrong = device
        .method(Rk4::new(-1.0))?
        .ensemble(&models, 0.0, 1.0, &[SVector::from([0.0, 0.0])]);
    let Err(EnsembleError::InvalidInput(Reason::InvalidInput { what: "h", .. })) = wrong else {
        panic!("{wrong:?}");
    };
    let two = device
        .method(Rk45::new())?
        .ensemble(&[models[0], models[0]], 0.0, 1.0, &[SVector::from([0.0, 0.0])]);
    assert!(matches!(two, Err(EnsembleError::InvalidInput(_))), "{two:?}");
    assert!(Double::DECLARATION.contains("kernel"));
    Ok(())
}

#[test]
fn sweeps_run_on_devices() -> Result<(), SweepError> {
    let Some(device) = device() else { return Ok(()) };
    let sweep = || Sweep::random("throws", [Draw::normal("rate", "rad/s", 0.0, 5.0)], 5000, 3);
    let trial = |[rate]: [f64; 1]| {
        if rate > 12.0 {
            return Err("too fast".into());
        }
        Ok((Double::new(DoubleParams::default())?, [0.0, 0.0, rate, 0.0]))
    };
    let alone = sweep().ends(Rk4::new(0.01), SPAN, trial).quiet().run()?;
    let on_device = sweep()
        .ends(device.method(Rk4::new(0.01))?, SPAN, trial)
        .quiet()
        .run()?;
    for name in ["rate", "t", "half", "beta"] {
        let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&on_device[name]), bits(&alone[name]), "{name}");
    }
    assert!(on_device.failures() == alone.failures());
    Ok(())
}

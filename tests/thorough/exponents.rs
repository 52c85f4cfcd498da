//! Lyapunov exponents of many trajectories in lanes, bit for bit equal to those of each trajectory alone.

use pendulum_core::prelude::*;
use pendulum_core::real::lanes::Isa;
use pendulum_core::stability::{Exponents, Lyapunov, StabilityError};
use pendulum_core::{CastJacobian, Reason};
use testbed::random::Random;

mechanism! {
    /// Chaotic if friction is small and the moment is large.
    Rods {
        params { gamma: N m s, moment: N m }
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: arm {
            joint: revolute(z), coordinate: a, friction: gamma, torque: moment*cos(3 rad/s*t),
        }
        body lower on upper: arm { joint: revolute(z) at [0, -1, 0], coordinate: b, friction: gamma }
    }
}

mechanism! {
    /// A cart that escapes to infinity in finite time.
    Escaping {
        params { k: N/m^3 }
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: k*s^3 }
    }
}

mechanism! {
    /// A cart whose Jacobian is infinite at the origin, where it may rest.
    Rooted {
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: -sqrt(1 N^2/m*abs(s)) }
    }
}

mechanism! {
    Sticking {
        params { mu: N m }
        gravity: [0, -9.81, 0],
        body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, dry_friction: mu }
    }
}

mechanism! {
    Spherical {
        gravity: [0, 0, -9.81],
        body bob on ground { solids: [sphere(1, 0.1, [0, 0, -1])], joint: ball, orientation: o }
    }
}

/// Asserts that exponents of single trajectories and in lanes of all instruction sets are identical.
fn assert_same<const K: usize, M, const N: usize>(lyapunov: Lyapunov, models: &[M], starts: &[SVector<f64, N>])
where
    M: CastJacobian<N> + Jacobian<f64, N>,
    M::In<f64>: Jacobian<f64, N>,
{
    let model = |n: usize| if let [model] = models { model } else { &models[n] };
    let alone = |(n, &start)| lyapunov.exponents(model(n), start);
    let alone: Vec<Result<Exponents<K, N>, _>> = starts.iter().enumerate().map(alone).collect();
    for isa in Isa::available() {
        let found = lyapunov
            .ensemble_on::<K, _, _>(isa, models, starts)
            .expect("valid settings");
        for (n, (found, alone)) in found.iter().zip(&alone).enumerate() {
            // compare as text, in which NaNs are equal
            assert_eq!(format!("{found:?}"), format!("{alone:?}"), "trajectory {n} on {isa:?}");
        }
        assert_eq!(found.len(), starts.len());
    }
}

#[test]
fn exponents_in_lanes_are_those_of_each_alone() {
    let random = &mut Random::new(7);
    let model = |n: usize| {
        let params = RodsParams {
            gamma: 0.02 * (n % 5) as f64,
            moment: n as f64,
        };
        Rods::new(params).expect("physical parameters")
    };
    let models: Vec<Rods> = (0..37).map(model).collect();
    let starts: Vec<_> = models
        .iter()
        .map(|_| SVector::from_fn(|_, _| random.between(-2.0, 2.0)))
        .collect();
    let lyapunov = Lyapunov::new().tolerance(1e-6).transient(1.0).duration(4.0);
    assert_same::<1, _, 4>(lyapunov, &models, &starts);
    assert_same::<4, _, 4>(lyapunov, &models[..20], &starts[..20]);
    assert_same::<2, _, 4>(lyapunov, &models[9..10], &starts[..20]);
    assert_same::<1, _, 4>(lyapunov, &models[..1], &[]);
}

#[test]
fn those_that_end_early_spoil_no_other() -> Result<(), Box<dyn std::error::Error>> {
    let ks = (0..20).map(|n| {
        Escaping::new(EscapingParams {
            k: if n % 7 == 3 { 2.0 } else { -1.0 },
        })
    });
    let models: Vec<Escaping> = ks.collect::<Result<_, _>>()?;
    let mut starts = vec![SVector::from([1.0, 0.5]); 20];
    starts[5][1] = f64::NAN;
    let lyapunov = Lyapunov::new().duration(5.0);
    assert_same::<2, _, 2>(lyapunov, &models, &starts);
    let found = lyapunov.ensemble::<1, _, _>(&models, &starts)?;
    let failed: Vec<usize> = (0..20).filter(|&n| found[n].is_err()).collect();
    assert_eq!(failed, [3, 5, 10, 17]);

    // the state is finite, the tangent is not
    let rooted = [Rooted::new(RootedParams {})?];
    let starts = [[1.0, 0.5], [0.0, 0.0], [2.0, 0.0]].map(SVector::from);
    let lyapunov = Lyapunov::new().duration(0.5);
    assert_same::<1, _, 2>(lyapunov, &rooted, &starts);
    let found = lyapunov.ensemble::<1, _, _>(&rooted, &starts)?;
    assert_eq!([0, 1, 2].map(|n| found[n].is_ok()), [true, false, true]);
    Ok(())
}

#[test]
fn what_has_no_lanes_goes_one_by_one() -> Result<(), Box<dyn std::error::Error>> {
    let lyapunov = Lyapunov::new().tolerance(1e-6).duration(3.0);
    let sticking = [0.0, 0.5, 5.0].map(|mu| Sticking::new(StickingParams { mu }));
    let sticking: Vec<Sticking> = sticking.into_iter().collect::<Result<_, _>>()?;
    assert_same::<2, _, 2>(lyapunov, &sticking, &[SVector::from([1.0, 0.0]); 3]);
    let spherical = [Spherical::new(SphericalParams {})?];
    let mut start = SVector::<f64, 7>::zeros();
    (start[Spherical::O], start[Spherical::DOT_O]) = (1.0, 2.0);
    assert_same::<6, _, 7>(lyapunov, &spherical, &[start; 3]);
    let many = lyapunov.ensemble::<7, _, _>(&spherical, &[start]);
    let many = many.expect_err("a quaternion keeps its length").to_string();
    assert!(many.contains("number of independent directions"), "{many}");
    Ok(())
}

#[test]
fn what_is_wrong_for_all_is_said_once() -> Result<(), Box<dyn std::error::Error>> {
    let models = [
        Sticking::new(StickingParams { mu: 1.0 })?,
        Sticking::new(StickingParams { mu: 2.0 })?,
    ];
    let starts = [SVector::from([1.0, 0.0]); 3];
    let invalid = |lyapunov: Lyapunov, models: &[Sticking], wrong: &str| {
        let error = lyapunov.ensemble::<1, _, _>(models, &starts).expect_err(wrong);
        assert!(
            matches!(error, StabilityError::Integration(Reason::InvalidInput { what, .. }) if what == wrong),
            "{error}"
        );
    };
    invalid(Lyapunov::new(), &models, "models");
    invalid(Lyapunov::new().duration(-1.0), &models[..1], "duration");
    invalid(Lyapunov::new().tolerance(0.0), &models[..1], "rtol");
    Ok(())
}

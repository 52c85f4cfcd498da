//! Driven joints against the same mechanisms with those joints free, and against dual numbers.

use approx::assert_relative_eq;
use nalgebra::SVector;
use pendulum_core::prelude::*;
use testbed::dual::Dual;
use testbed::power_series;
use testbed::random::Random;

/// A crane with laws for the joints `j1` and `j2` to be filled in.
macro_rules! crane {
    ($name:ident { $($items:tt)* } $first:ident: $law1:tt, $second:ident: $law2:tt) => {
        mechanism! {
            pub $name {
                units: none,
                params { l: m = 0.4, w: rad/s = 2 }
                gravity: [1, -2, -9.81],
                $($items)*
                point tip on hook at [0, 0, -l],
                force on tip: [dot(tip.x), 1, tip.y],
                body rail on ground { mass: 2, com: [0.1, 0.2, 0.3], joint: prismatic([1, 2, 0.5]), $first: $law1 }
                body boom on rail { mass: 2, com: [0.1, l, 0.3], inertia: [0.3, 0.4, 0.5, 0.01, 0.02, 0.03],
                    joint: revolute([1, 2, -1]) at [0.1, 0, 0.4], coordinate: q1, friction: 0.3 }
                body winch on boom { mass: 1.5, com: [0, -0.3, 0.1], inertia: [0.2, 0.3, 0.25],
                    joint: revolute([0, 1, 1]) at [0.3, 0.1, 0] rpy [0.4, -0.7, 1.1], $second: $law2 }
                body hook on winch { mass: 0.7, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1],
                    joint: revolute(x) at [0, 0.2, 0.5], coordinate: q2, spring: (3, l) }
            }
        }
    };
}

crane!(Driven {
    let swing = sin(w*t) / 2,
    generate: [rhs, jacobian, energy, drive_forces, taylor, canonical, parameter_jacobian, inverse_dynamics],
    output tip: tip,
    output fast: dot(tip.x),
} motion: (l * cos(w*t) + t^2), motion: (swing + t));
crane!(Free {
    generate: [rhs, energy, mass_matrix, bias, inverse_dynamics],
    output tip: tip,
    output unused: w,
} coordinate: s, coordinate: phi);

fn driven() -> Driven {
    Driven::new(DrivenParams::default()).expect("physical")
}

/// Coordinates of the two drives, their rates and their second rates.
fn laws(t: f64) -> [[f64; 2]; 3] {
    let (sine, cosine) = (2.0 * t).sin_cos();
    [
        [0.4 * cosine + t * t, sine / 2.0 + t],
        [-0.8 * sine + 2.0 * t, cosine + 1.0],
        [-1.6 * cosine + 2.0, -2.0 * sine],
    ]
}

fn states() -> impl Iterator<Item = (f64, SVector<f64, 4>)> {
    let mut random = Random::new(11);
    (0..8).map(move |_| {
        (
            random.between(0.0, 2.0),
            SVector::from_fn(|_, _| random.between(-1.5, 1.5)),
        )
    })
}

/// State of the free mechanism with its joints as driven.
fn whole(t: f64, x: &SVector<f64, 4>) -> SVector<f64, 8> {
    let [[s, phi], [ds, dphi], _] = laws(t);
    SVector::from([s, x[0], phi, x[1], ds, x[2], dphi, x[3]])
}

#[test]
fn drives_move_as_prescribed_joints_do() {
    let (model, free) = (driven(), Free::new(FreeParams::default()).expect("physical"));
    for (t, x) in states() {
        let (full, [_, _, [dds, ddphi]]) = (whole(t, &x), laws(t));
        let rate = model.rhs(t, &x);
        // at these accelerations the free mechanism needs no force along its own joints, and along the others those of
        // the drives
        let forces = free.inverse_dynamics(t, &full, &SVector::from([dds, rate[2], ddphi, rate[3]]));
        let scale = forces.amax();
        assert!(
            forces[1].abs() < 1e-12 * scale && forces[3].abs() < 1e-12 * scale,
            "{forces}"
        );
        let supplied = model.drive_forces(t, &x);
        assert_relative_eq!(supplied, SVector::from([forces[0], forces[2]]), epsilon = 1e-12 * scale);
        assert_relative_eq!(model.kinetic(t, &x), free.kinetic(t, &full), max_relative = 1e-13);
        assert_relative_eq!(model.potential(t, &x), free.potential(t, &full), max_relative = 1e-13);
        assert_relative_eq!(model.tip(t, &x), free.tip(t, &full), epsilon = 1e-14);
        assert_relative_eq!(model.tip_rate(t, &x), free.tip_rate(t, &full), epsilon = 1e-13);
        assert_relative_eq!(model.tip_rate(t, &x)[0], model.fast(t, &x), epsilon = 1e-14);
        let taken = model.inverse_dynamics(t, &x, &rate.fixed_rows::<2>(2).into_owned());
        assert!(taken.amax() < 1e-12 * scale);
    }
    assert_eq!((Driven::DOF, Driven::COORDINATES), (2, ["q1", "q2"]));
    assert_eq!(Driven::DRIVES, ["rail", "winch"]);
}

#[test]
fn derivatives_follow_through_drives() {
    let (model, dual) = (driven(), driven().cast::<Dual>());
    for (t, x) in states() {
        let rate = model.rhs(t, &x);
        let along = |dt: f64, dx: &SVector<f64, 4>| {
            (
                Dual::new(t, dt),
                SVector::<Dual, 4>::from_fn(|n, _| Dual::new(x[n], dx[n])),
            )
        };
        let slope = |(t, x): (Dual, SVector<Dual, 4>)| dual.rhs(t, &x).map(|value| value.slope);
        let jacobian = model.jacobian(t, &x);
        for n in 0..4 {
            let column = slope(along(0.0, &SVector::from_fn(|i, _| f64::from(u8::from(i == n)))));
            assert_relative_eq!(
                jacobian.column(n).into_owned(),
                column,
                epsilon = 1e-11,
                max_relative = 1e-11
            );
        }
        let by_time = slope(along(1.0, &SVector::zeros()));
        assert_relative_eq!(
            model.time_derivative(t, &x),
            by_time,
            epsilon = 1e-11,
            max_relative = 1e-11
        );
        let (t1, x1) = along(1.0, &rate);
        let change = dual.canonical(t1, &x1).0.map(|value| value.slope);
        assert_relative_eq!(model.canonical(t, &x).1, change, epsilon = 1e-11, max_relative = 1e-11);
        assert_relative_eq!(model.fast_rate(t, &x), dual.fast(t1, &x1).slope, epsilon = 1e-11);
        // the rate of the energy is the power of friction, of the force on the tip and of the drives
        let energy = dual.energy(t1, &x1).slope;
        let tip = model.tip_rate(t, &x);
        let supplied = model.drive_forces(t, &x);
        let [_, [ds, dphi], _] = laws(t);
        let powers = [
            supplied[0] * ds,
            supplied[1] * dphi,
            -0.3 * x[2] * x[2],
            tip.x * tip.x,
            tip.y,
            model.tip(t, &x).y * tip.z,
        ];
        let largest = powers.iter().fold(0.0_f64, |largest, power| largest.max(power.abs()));
        assert_relative_eq!(energy, powers.iter().sum::<f64>(), epsilon = 1e-12 * largest);
        let slopes = model.parameter_jacobian(t, &x);
        for n in 0..2 {
            let moved = |h: f64| {
                let mut params = model.params().to_array();
                params[n] += h;
                let moved = model.with_params(DrivenParams::from_array(params)).expect("physical");
                moved.rhs(t, &x)
            };
            let slope = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
            let by_differences = (4.0 * slope(1e-3) - slope(2e-3)) / 3.0;
            assert_relative_eq!(
                slopes.column(n).into_owned(),
                by_differences,
                epsilon = 1e-7,
                max_relative = 1e-7
            );
        }
    }
}

#[test]
fn series_follow_through_drives() {
    let (model, independent) = (driven(), driven().cast::<power_series::Series>());
    for (t, x) in states() {
        let mut series = vec![x; 13];
        model.series(t, &mut series, &mut model.workspace());
        for (ours, theirs) in series.iter().zip(power_series::motion(&independent, t, x)) {
            let scale = theirs.amax().max(1.0);
            assert_relative_eq!(ours, &theirs, epsilon = 1e-10 * scale);
        }
    }
}

mechanism! {
    /// A pendulum on a pivot driven in two directions.
    Pivot {
        params { a: m = 0.1, b: m = 0.2, w: rad/s = 3 }
        gravity: [0, -9.81, 0],
        body across on ground { joint: prismatic(x), motion: a*sin(w*t) }
        body upward on across { joint: prismatic(y), motion: b*cos(2*w*t) }
        body bob on upward { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}

#[test]
fn a_driven_pivot_is_an_acceleration_of_gravity() {
    let model = Pivot::new(PivotParams::default()).expect("physical");
    for (t, x) in states() {
        let (theta, wt) = (x[0], 3.0 * t);
        let (ax, ay) = (-0.9 * wt.sin(), -7.2 * (2.0 * wt).cos());
        let expected = -(9.81 + ay) * theta.sin() - ax * theta.cos();
        let rate = model.rhs(t, &SVector::from([theta, x[2]]));
        assert_relative_eq!(rate[1], expected, epsilon = 1e-13);
    }
    const { assert!(!Pivot::LAYOUT.autonomous) };
    // one pair for the angle, and those of the two drives
    assert!(Pivot::COST["rhs"].operations.sincos <= 3, "{}", Pivot::COST);
}

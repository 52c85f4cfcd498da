//! Tests of bifurcations against published values.

use std::f64::consts::{FRAC_PI_2, TAU};

use approx::assert_abs_diff_eq;
use nalgebra::SVector;
use pendulum_core::prelude::*;
use pendulum_core::stability::{
    Bifurcation, BifurcationKind, BranchEnd, Continuation, Shooting, Stability, equilibrium,
};

mechanism! {
    /// A pendulum under a constant torque.
    pub Held {
        params { torque: N m }
        gravity: [0, -9.81, 0],
        body bob on ground {
            mass: 2, com: [0, -0.5, 0], joint: revolute(z), coordinate: angle, friction: 0.3, torque: torque,
        }
    }
}

#[test]
fn a_torque_holds_a_pendulum_up_to_the_horizontal_and_the_branch_goes_round() {
    let held = |torque| Held::new(HeldParams { torque });
    let branch = Continuation::new(held, -20.0, 20.0)
        .equilibria([0.0, 0.0], 0.0)
        .expect("it hangs");
    // hanging, horizontal, standing, horizontal on the other side, and hanging again after a full turn
    assert_eq!(branch.ends(), [const { BranchEnd::Closed }; 2]);
    let [up, down] = branch.bifurcations() else {
        panic!("{:?}", branch.bifurcations())
    };
    assert_eq!([up.kind, down.kind], [BifurcationKind::Fold; 2]);
    assert_abs_diff_eq!(up.parameter, 9.81, epsilon = 1e-8);
    assert_abs_diff_eq!(down.parameter, -9.81, epsilon = 1e-8);
    assert_abs_diff_eq!(up.solution.x[0], FRAC_PI_2, epsilon = 1e-4);
    assert_abs_diff_eq!(down.solution.x[0], 3.0 * FRAC_PI_2, epsilon = 1e-4);
    for point in branch.points() {
        let angle = point.solution.x[0];
        assert_abs_diff_eq!(point.parameter, 9.81 * angle.sin(), epsilon = 1e-11);
        let expected = if angle.cos() > 0.0 {
            Stability::AsymptoticallyStable
        } else {
            Stability::Unstable
        };
        assert_eq!(point.solution.stability(), expected);
    }
}

mechanism! {
    /// A bead on a hoop of 1 m that rotates about its vertical diameter.
    pub Hoop {
        params { omega: rad/s }
        gravity: [0, -9.81, 0],
        body bead on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: 0.2,
            torque: 1 kg m^2 * omega^2 * sin(q) * cos(q),
        }
    }
}

#[test]
fn a_bead_leaves_the_bottom_of_a_hoop_that_turns_fast_enough() {
    let hoop = |omega| Hoop::new(HoopParams { omega });
    let critical = 9.81_f64.sqrt();
    let continuation = Continuation::new(hoop, 1.0, 5.0);
    let bottom = continuation
        .equilibria([0.0, 0.0], 2.0)
        .expect("it rests at the bottom");
    let aside = continuation.equilibria([1.0, 0.0], 4.5).expect("it rests aside");
    for branch in [&bottom, &aside] {
        let [crossing] = branch.bifurcations() else {
            panic!("{:?}", branch.bifurcations())
        };
        assert_eq!(crossing.kind, BifurcationKind::Crossing);
        assert_abs_diff_eq!(crossing.parameter, critical, epsilon = 1e-8);
    }
    for point in aside.points() {
        let height = (9.81 / point.parameter.powi(2)).acos();
        assert_abs_diff_eq!(point.solution.x[0].abs(), height, epsilon = 1e-9);
        assert_eq!(point.solution.stability(), Stability::AsymptoticallyStable);
    }
}

mechanism! {
    /// Two rods of 1 m with springs of 1 N m/rad, 2 kg at the knee and 1 kg at the tip, and a follower force along the
    /// upper rod: H. Ziegler, Ingenieur-Archiv 20 (1952) 49.
    pub Ziegler {
        params { push: N, damping: N m s }
        body lower on ground {
            mass: 2, com: [0, 1, 0], joint: revolute(z), coordinate: bend, spring: (1, 0), friction: damping,
            torque: -push * 1 m * sin(knee),
        }
        body upper on lower {
            mass: 1, com: [0, 1, 0], joint: revolute(z) at [0, 1, 0],
            coordinate: knee, spring: (1, 0), friction: damping,
        }
    }
}

#[test]
fn zieglers_column_flutters_and_damping_makes_it_flutter_sooner() {
    let flutter = |damping: f64| {
        let column = move |push| Ziegler::new(ZieglerParams { push, damping });
        let branch = Continuation::new(column, 0.0, 2.5)
            .equilibria([0.0; 4], 0.1)
            .expect("it stands");
        let [
            Bifurcation {
                kind: BifurcationKind::Hopf { angular_frequency },
                parameter,
                ..
            },
        ] = branch.bifurcations()
        else {
            panic!("{:?}", branch.bifurcations())
        };
        (*parameter, *angular_frequency)
    };
    // Without damping two frequencies meet: the roots of 2 w^4 - (7 - 2 P) w^2 + 1 = 0.
    let (push, frequency) = flutter(0.0);
    assert_abs_diff_eq!(push, 3.5 - 2.0_f64.sqrt(), epsilon = 1e-8);
    assert_abs_diff_eq!(frequency, 0.5_f64.powf(0.25), epsilon = 1e-4);
    // With equal damping at both joints, by the Hurwitz criterion for 2 s^4 + 7 c s^3 + (7 - 2 P + c^2) s^2 + 2 c s + 1
    // = 0. Any damping, however small, lowers the load: V. V. Bolotin, "Nonconservative Problems of the Theory of
    // Elastic Stability" (1963)
    for damping in [1e-3, 0.1, 0.5] {
        let (push, frequency) = flutter(damping);
        assert_abs_diff_eq!(push, 41.0 / 28.0 + 0.5 * damping * damping, epsilon = 1e-8);
        assert_abs_diff_eq!(frequency, (2.0_f64 / 7.0).sqrt(), epsilon = 1e-8);
    }
}

mechanism! {
    /// The driven damped pendulum of J. R. Taylor, "Classical Mechanics" (2005), ch. 12, with the drive in units of the
    /// weight.
    pub Driven {
        params { drive: 1 }
        gravity: [0, -(3 * pi)^2, 0],
        body bob on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: 3 * pi / 2,
            torque: drive * (3 * pi)^2 * cos(2 rad/s * pi * t),
        }
    }
}

#[test]
fn the_driven_pendulum_doubles_its_period_where_taylor_says() {
    let driven = |drive| Driven::new(DrivenParams { drive });
    // The steady state, from the initial condition in the book; its period is 1, 2 or 4 s.
    let settled = |drive: f64, seconds: f64| {
        let model = driven(drive).expect("a pendulum");
        let method = Vern7::new().rtol(1e-9).atol(1e-9);
        method
            .stepper(&model, 0.0, seconds, [-FRAC_PI_2, 0.0])
            .and_then(|mut stepper| stepper.run())
            .expect("a smooth system")
    };
    let mut doublings = Vec::new();
    // To one unit in the last published digit; the second method below also yields 1.066373 for the first.
    for (start, period, published) in [(1.065, 1.0, 1.0663), (1.078, 2.0, 1.0793), (1.0818, 4.0, 1.0821)] {
        let continuation = Continuation::new(driven, 1.06, 1.09).step(0.02).points(10);
        let branch = continuation
            .forced_orbits(settled(start, 200.0), |_| period, start)
            .expect("a motion");
        let doubling = branch
            .bifurcations()
            .iter()
            .find(|bifurcation| bifurcation.kind == BifurcationKind::PeriodDoubling)
            .unwrap_or_else(|| panic!("{:?} {:?}", branch.bifurcations(), branch.ends()));
        assert_abs_diff_eq!(doubling.parameter, published, epsilon = 1e-4);
        assert_abs_diff_eq!(doubling.solution.nontrivial()[0].value.re, -1.0, epsilon = 1e-8);
        doublings.push(doubling.parameter);
    }
    // Beyond the first doubling, the distance of states one period apart grows as the square root of the distance in
    // the drive. Two long motions determine where it begins.
    let square = |drive: f64| (settled(drive, 601.0)[0] - settled(drive, 600.0)[0]).powi(2);
    let (near, far) = (square(1.0665), square(1.0668));
    let told = 1.0665 - 3e-4 * near / (far - near);
    assert_abs_diff_eq!(doublings[0], told, epsilon = 2e-6);
}

mechanism! {
    /// Two equal point masses on rods of 1 m, without friction.
    pub Double {
        gravity: [0, -9.81, 0],
        shape rod { mass: 1, com: [0, -1, 0] }
        body upper on ground: rod { joint: revolute(z), coordinate: theta1 }
        body lower on upper: rod { joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute }
    }
}

#[test]
fn normal_modes_of_a_double_pendulum_go_on_to_large_amplitudes() {
    let model = Double::new(DoubleParams {}).expect("a pendulum");
    let hanging = equilibrium(&model, [0.1, 0.1, 0.0, 0.0]).expect("it hangs");
    let modes = hanging.spectrum.modes();
    let frequencies: Vec<f64> = modes
        .iter()
        .map(|mode| mode.eigenvalue.im)
        .filter(|im| *im > 0.0)
        .collect();
    // g / l (2 +- sqrt 2)
    let expected = [2.0 + 2.0_f64.sqrt(), 2.0 - 2.0_f64.sqrt()].map(|factor| (9.81 * factor).sqrt());
    for (ratio, frequency) in [(-(2.0_f64.sqrt()), expected[0]), (2.0_f64.sqrt(), expected[1])] {
        assert!(frequencies.iter().any(|found| (found - frequency).abs() < 1e-9));
        let mut periods = Vec::new();
        let mut start = SVector::from([1e-2, 1e-2 * ratio, 0.0, 0.0]);
        let mut period = TAU / frequency;
        for amplitude in [1e-2, 2e-2, 0.1, 0.2, 0.3] {
            start *= amplitude / start[0];
            let orbit = Shooting::new().autonomous(&model, start, period).expect("a mode");
            // multipliers in reciprocal pairs: 1 twice, one of them along the orbit, and two whose product is 1
            let pair: Vec<_> = orbit.nontrivial().iter().map(|multiplier| multiplier.value).collect();
            let product = pair[0] * pair[1] * pair[2];
            assert_abs_diff_eq!(product.re, 1.0, epsilon = 1e-8);
            assert!(
                pair.iter().any(|multiplier| (multiplier - 1.0).norm() < 1e-8),
                "{pair:?}"
            );
            let after = Vern9::new()
                .rtol(1e-12)
                .atol(1e-12)
                .solve(&model, 0.0, orbit.period, orbit.x);
            assert_abs_diff_eq!(after.expect("a smooth system").end(), orbit.x, epsilon = 1e-9);
            periods.push((orbit.x[0], orbit.period));
            (start, period) = (orbit.x, orbit.period);
        }
        // the period differs from that of the linear mode by a term quadratic in the amplitude
        let off = |(amplitude, period): (f64, f64)| (period * frequency / TAU - 1.0) / amplitude.powi(2);
        assert!(off(periods[0]).abs() > 1e-3);
        assert_abs_diff_eq!(off(periods[0]) / off(periods[1]), 1.0, epsilon = 1e-3);
        assert!((periods[4].1 * frequency / TAU - 1.0).abs() > 1e-3, "{periods:?}");
    }
}

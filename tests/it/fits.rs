//! Parameters fitted to simulated measurements.

use pendulum_core::fit::{Experiment, Fit, FitError, Fitted, Loss, Measurement, Status, Warning};
use pendulum_core::inputs::TimeTable;
use pendulum_core::prelude::*;
use pendulum_core::{Parametric, SampleError};
use std::ops::ControlFlow;
use testbed::random::Random;

mechanism! {
    /// A rod of 0.8 m and 1 kg, with a weight at its tip.
    Rig {
        params { tip: kg = 0.5, gamma: N m s = 0.1 }
        gravity: [0, -9.81, 0],
        body rod on ground {
            solids: [rod(1, [0, 0, 0], [0, -0.8, 0]), point(tip, [0, -0.8, 0])],
            joint: revolute(z), coordinate: angle, friction: gamma,
        }
    }
}

mechanism! {
    Double {
        params { m1: kg = 1, m2: kg = 1, l1: m = 1, l2: m = 1, g1: N m s = 0.02, g2: N m s = 0.02 }
        gravity: [0, -9.81, 0],
        body upper on ground {
            solids: [rod(m1, [0, 0, 0], [0, -l1, 0])], joint: revolute(z), coordinate: a, friction: g1,
        }
        body lower on upper {
            solids: [rod(m2, [0, 0, 0], [0, -l2, 0])], joint: revolute(z) at [0, -l1, 0], coordinate: b, friction: g2,
        }
    }
}

mechanism! {
    /// A pendulum with both kinds of friction, a motor, and an encoder that is not aligned.
    Driven {
        params { k: N m = 8, viscous: N m s = 0.05, dry: N m = 0.3, zero: rad = 0, gain: 1 = 1 }
        gravity: [0, -9.81, 0],
        input motor: N m,
        output encoder: gain*theta + zero,
        body rod on ground {
            solids: [rod(1, [0, 0, 0], [0, -1, 0])],
            joint: revolute(z), coordinate: theta, friction: viscous, dry_friction: dry, torque: motor,
        }
        potential: -(k - 4.905 N m)*cos(theta),
    }
}

mechanism! {
    /// A rod with an axle whose bristles bend over a thousandth of a rad. Nothing depends on its heat.
    Bristled {
        params { friction: N m = 0.2 }
        gravity: [0, -9.81, 0],
        let w = dot(theta),
        state bent { unit: 1, rate: (w - abs(w)*bent)/(0.001 rad + 0.002 s*abs(w)) }
        state heat { unit: J, rate: friction*bent*w }
        state filtered { unit: rad, rate: (theta - filtered)/0.1 s }
        output readings: filtered,
        body rod on ground {
            solids: [rod(1, [0, 0, 0], [0, -1, 0])], joint: revolute(z), coordinate: theta, torque: -friction*bent,
        }
    }
}

/// A double pendulum with friction.
const SWINGING: DoubleParams = DoubleParams {
    m1: 1.3,
    m2: 0.6,
    l1: 0.8,
    l2: 0.7,
    g1: 0.03,
    g2: 0.01,
};

/// Times of samples at a rate in Hz.
fn times(rate: f64, end: f64) -> Vec<f64> {
    (0..).map(|n| f64::from(n) / rate).take_while(|t| *t < end).collect()
}

/// Measurement of components of the state, named `names`, with normal noise.
fn measured<M, const N: usize, const P: usize>(
    model: &M,
    x0: [f64; N],
    times: &[f64],
    names: &[(&str, usize)],
    (deviation, random): (f64, &mut Random),
) -> Measurement
where
    M: Parametric<N, P>,
    Vern9: Method<M::In<f64>, f64, N>,
{
    let end = times[times.len() - 1];
    let method = Vern9::new().rtol(1e-11).atol(1e-11);
    let motion = method.solve(&model.cast(), times[0], end, x0).expect("a motion");
    let mut measurement = Measurement::new(times).expect("times");
    for &(name, n) in names {
        let values = times
            .iter()
            .map(|&t| motion.at(t).expect("inside")[n] + deviation * random.normal());
        measurement = measurement.output(name, &values.collect::<Vec<_>>()).expect("values");
    }
    measurement
}

fn method() -> Vern9 {
    Vern9::new().rtol(1e-8).atol(1e-8)
}

/// Number of estimates whose intervals contain the true values.
fn covered<const N: usize, const P: usize>(fitted: &Fitted<N, P>, names: [&str; P], truth: [f64; P]) -> usize {
    let truths = names.into_iter().zip(truth);
    let within = truths.filter(|&(name, value)| {
        let estimate = fitted.estimate(name);
        estimate.is_some_and(|estimate| (estimate.interval[0]..=estimate.interval[1]).contains(&value))
    });
    within.count()
}

#[test]
fn intervals_of_95_percent_contain_true_values_95_times_of_100() {
    let truth = RigParams { tip: 0.3, gamma: 0.07 };
    let mut within = 0;
    for seed in 0..100 {
        let random = &mut Random::new(seed);
        let rig = Rig::new(truth).expect("valid");
        let measurement = measured(&rig, [1.0, 0.0], &times(50.0, 4.0), &[("angle", 0)], (0.02, random));
        let rough = Rig::new(RigParams::default()).expect("valid");
        let fitted = Fit::new(Rk4::new(0.02))
            .run(&[Experiment::new(&rough, &measurement)])
            .expect("a fit");
        within += covered(&fitted, RigParams::NAMES, truth.to_array());
        assert!((0.016..0.024).contains(&fitted.noise_of("angle").expect("measured")));
    }
    // 190 expected, with a standard deviation of 3
    assert!((184..=196).contains(&within), "{within} of 200");
}

/// A rod of 10 s at 200 Hz with 2 mrad of noise, whose accelerations by differences give an inertia 5.7 % off.
#[test]
fn angles_alone_determine_inertia_and_friction() {
    let truth = RigParams { tip: 0.3, gamma: 0.07 };
    let rig = Rig::new(truth).expect("valid");
    let measurement = measured(
        &rig,
        [2.0, 0.0],
        &times(200.0, 10.0),
        &[("angle", 0)],
        (0.002, &mut Random::new(1)),
    );
    let rough = Rig::new(RigParams::default()).expect("valid");
    let fitted = Fit::new(method())
        .run(&[Experiment::new(&rough, &measurement)])
        .expect("a fit");
    let params = RigParams::from_array(fitted.parameters);
    let inertia = |tip: f64| 0.8 * 0.8 * (1.0 / 3.0 + tip);
    assert!((inertia(params.tip) / inertia(truth.tip) - 1.0).abs() < 0.003);
    assert!((params.gamma / truth.gamma - 1.0).abs() < 0.003);
    assert!(fitted.status == Status::Converged && fitted.warnings.is_empty() && fitted.undetermined.is_empty());
    assert!(fitted.iterations < 15, "{}", fitted.iterations);
}

#[test]
fn rough_starts_end_at_the_same_optimum() {
    let truth = SWINGING;
    let random = &mut Random::new(3);
    let names = [("a", 0), ("b", 1)];
    let double = Double::new(truth).expect("valid");
    let measurement = measured(
        &double,
        [1.0, 1.5, 0.0, 0.0],
        &times(25.0, 3.0),
        &names,
        (0.002, random),
    );
    let free = ["m2", "l1", "l2", "g1", "g2"];
    let fit = Fit::new(Rk4::new(0.04)).free(free).windows(0.5);
    let mut best: Option<[f64; 6]> = None;
    for _ in 0..testbed::random::share(50) {
        let mut rough = truth.to_array().map(|value| value * random.between(0.5, 2.0));
        rough[0] = truth.m1;
        let rough = Double::new(DoubleParams::from_array(rough)).expect("valid");
        let fitted = fit.run(&[Experiment::new(&rough, &measurement)]).expect("a fit");
        assert_eq!(fitted.status, Status::Converged);
        let best = *best.get_or_insert(fitted.parameters);
        for estimate in &fitted.estimates {
            let n = DoubleParams::NAMES
                .iter()
                .position(|name| *name == estimate.name)
                .expect("a parameter");
            assert!((estimate.value - best[n]).abs() < 2e-3 * estimate.deviation, "{fitted}");
        }
        assert!(covered(&fitted, DoubleParams::NAMES, truth.to_array()) >= 3);
    }
}

#[test]
fn joined_windows_give_the_single_trajectory_and_separate_ones_less() {
    let truth = DoubleParams {
        m1: 1.0,
        m2: 0.6,
        l1: 0.8,
        l2: 0.7,
        g1: 0.03,
        g2: 0.01,
    };
    let double = Double::new(truth).expect("valid");
    let names = [("a", 0), ("b", 1)];
    let measurement = measured(
        &double,
        [1.0, 1.5, 0.0, 0.0],
        &times(50.0, 4.0),
        &names,
        (0.002, &mut Random::new(4)),
    );
    let near = Double::new(DoubleParams { m2: 0.62, ..truth }).expect("valid");
    let experiment = [Experiment::new(&near, &measurement)];
    let fit = Fit::new(method()).free(["m2", "l1", "l2", "g1", "g2"]);
    let single = fit.run(&experiment).expect("a fit");
    let joined = fit.clone().windows(0.5).run(&experiment).expect("a fit");
    let separate = fit.separate_windows(0.5).run(&experiment).expect("a fit");
    assert_eq!(
        (single.windows.len(), joined.windows.len(), separate.windows.len()),
        (1, 8, 8)
    );
    for ((single, joined), separate) in single.estimates.iter().zip(&joined.estimates).zip(&separate.estimates) {
        assert!(
            (single.value - joined.value).abs() < 1e-3 * single.deviation,
            "{single:?} {joined:?}"
        );
        assert!((single.deviation / joined.deviation - 1.0).abs() < 1e-3);
        assert!(separate.deviation > 2.0 * single.deviation);
        assert!((separate.value - single.value).abs() < 4.0 * separate.deviation);
    }
    for pair in joined.windows.windows(2) {
        assert!((pair[0].end - pair[1].start).amax() < 1e-7);
    }
}

/// A motor's torque, sampled at 200 Hz.
fn torque() -> TimeTable<1> {
    let clock = times(200.0, 8.0);
    let torque: Vec<f64> = clock
        .iter()
        .map(|t| 3.0 * (1.3 * t).sin() + 2.0 * (3.1 * t).sin())
        .collect();
    TimeTable::linear(&clock, [&torque]).expect("samples")
}

/// Readings of the encoder at 200 Hz, with noise of 2 mrad. The pendulum rests at times.
fn readings(truth: DrivenParams, seed: u64) -> Vec<f64> {
    let driven = Driven::new(truth).expect("valid");
    let motion = Rk4::new(0.0025)
        .solve(&driven.with_law(torque()), 0.0, 8.0, [0.3, 0.0])
        .expect("a motion");
    assert!(motion.modes().len() > 6);
    let random = &mut Random::new(seed);
    let reading = |t: f64| {
        let x = motion.at(t.min(motion.last().0)).expect("inside");
        driven.encoder(t, &x) + 0.002 * random.normal()
    };
    times(200.0, 8.0).into_iter().map(reading).collect()
}

fn of_encoder(readings: &[f64]) -> Measurement {
    let measurement = Measurement::new(&times(200.0, 8.0)).expect("times");
    measurement.output("encoder", readings).expect("values")
}

#[test]
fn dry_friction_offset_and_gain_are_fitted_to_driven_motion() {
    let truth = DrivenParams {
        k: 7.0,
        viscous: 0.08,
        dry: 0.5,
        zero: 0.05,
        gain: 1.03,
    };
    let mut angles = readings(truth, 5);
    // the encoder drops out
    angles[300..400].fill(f64::NAN);
    let measurement = of_encoder(&angles);
    let rough = Driven::new(DrivenParams::default()).expect("valid").with_law(torque());
    // the gain of an encoder is known by itself from the torque
    let fitted = Fit::new(Rk4::new(0.005))
        .run(&[Experiment::new(&rough, &measurement)])
        .expect("a fit");
    assert_eq!(fitted.status, Status::Converged);
    for (estimate, truth) in fitted.estimates.iter().zip(truth.to_array()) {
        let error = (estimate.value - truth).abs();
        assert!(
            error < 4.0 * estimate.deviation && estimate.deviation < 0.05 * truth,
            "{fitted}"
        );
    }
    // kinks in some windows hold up none of the others
    let separate = Fit::new(Rk4::new(0.005)).separate_windows(0.5);
    let separate = separate.run(&[Experiment::new(&rough, &measurement)]).expect("a fit");
    assert!((0.0017..0.0023).contains(&separate.rms("encoder")), "{separate}");
    let residuals = &fitted.residuals[0].values;
    assert!(residuals.len() == angles.len() && residuals[300..400].iter().all(|residual| residual.is_nan()));
    assert!((0.0018..0.0022).contains(&fitted.residuals[0].rms()));
}

#[test]
fn windows_that_stick_in_vain_are_fitted_from_other_starts() {
    let truth = DrivenParams {
        k: 7.0,
        viscous: 0.08,
        dry: 0.5,
        zero: 0.05,
        gain: 1.0,
    };
    let measurement = of_encoder(&readings(truth, 2));
    let fit = Fit::new(Rk4::new(0.005)).free(["k", "viscous", "dry", "zero"]);
    let run = |fit: Fit<_>, dry| {
        let rough = DrivenParams {
            dry,
            ..DrivenParams::default()
        };
        let rough = Driven::new(rough).expect("valid").with_law(torque());
        fit.run(&[Experiment::new(&rough, &measurement)]).expect("a fit")
    };
    let single = run(fit.clone(), 0.3);
    // it holds whole windows at rest
    let separate = run(fit.clone().separate_windows(0.4), 8.0);
    assert_eq!(separate.status, Status::Converged);
    assert!((0.0018..0.0022).contains(&separate.rms("encoder")), "{separate}");
    let joined = run(fit.windows(0.4), 8.0);
    assert_eq!(joined.status, Status::Converged);
    for (single, joined) in single.estimates.iter().zip(&joined.estimates) {
        assert!(
            (single.value - joined.value).abs() < 0.01 * single.deviation,
            "{single:?} {joined:?}"
        );
    }
}

mechanism! {
    Bouncing {
        params { e: 1 = 0.6, g: m/s^2 = 9 }
        gravity: [0, -g, 0],
        wall floor { gap: y, restitution: e }
        body ball on ground { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

mechanism! {
    /// A top: a body on a ball joint.
    Top {
        params { moment: kg m^2 = 0.002, height: m = 0.1 }
        gravity: [0, 0, -9.81],
        point tip on top at [0, 0, 0.2],
        output tip: tip,
        body top on ground {
            mass: 0.5, com: [0, 0, height], inertia: [0.001, 0.001, moment], joint: ball, orientation: o,
        }
    }
}

#[test]
fn impacts_and_orientations_are_fitted() {
    let clock = times(100.0, 2.0);
    let bouncing = Bouncing::new(BouncingParams { e: 0.8, g: 9.81 }).expect("valid");
    let measurement = measured(&bouncing, [1.0, 0.5], &clock, &[("y", 0)], (0.001, &mut Random::new(6)));
    let rough = Bouncing::new(BouncingParams::default()).expect("valid");
    let fitted = Fit::new(method())
        .windows(0.3)
        .run(&[Experiment::new(&rough, &measurement)])
        .expect("a fit");
    assert!(covered(&fitted, BouncingParams::NAMES, [0.8, 9.81]) == 2, "{fitted}");
    assert!(fitted.estimates[0].deviation < 1e-3);

    // from positions of the tip alone, with nothing known of the orientation
    let truth = TopParams {
        moment: 0.0015,
        height: 0.08,
    };
    let top = Top::new(truth).expect("valid");
    let (tilted, random) = (0.4_f64, &mut Random::new(7));
    let start = [(tilted / 2.0).cos(), (tilted / 2.0).sin(), 0.0, 0.0, 0.0, 0.3, 60.0];
    let motion = method().solve(&top, 0.0, 2.0, start).expect("a motion");
    let mut measurement = Measurement::new(&clock).expect("times");
    for n in 0..3 {
        let tip = |&t: &f64| top.tip(t, &motion.at(t).expect("inside"))[n] + 1e-4 * random.normal();
        let values: Vec<f64> = clock.iter().map(tip).collect();
        measurement = measurement.output(Top::OUTPUTS[n], &values).expect("values");
    }
    let rough = Top::new(TopParams::default()).expect("valid");
    let guess = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0];
    let fit = Fit::new(method()).free(["height"]).windows(0.25);
    let fitted = fit
        .run(&[Experiment::new(&rough, &measurement).from_guess(guess)])
        .expect("a fit");
    assert!(
        (fitted.parameters[1] - truth.height).abs() < 5.0 * fitted.estimates[0].deviation,
        "{fitted}"
    );
    assert!((fitted.windows[0].start.fixed_rows::<4>(0).norm() - 1.0).abs() < 1e-12);
}

#[test]
fn what_the_motion_does_not_determine_is_named() {
    let truth = SWINGING;
    let double = Double::new(truth).expect("valid");
    let names = [("a", 0), ("b", 1)];
    let measurement = measured(
        &double,
        [1.0, 1.5, 0.0, 0.0],
        &times(50.0, 4.0),
        &names,
        (0.002, &mut Random::new(8)),
    );
    let fitted = Fit::new(method())
        .run(&[Experiment::new(&double, &measurement)])
        .expect("a fit");
    // twice the masses and the friction give the same motion
    let [combination] = &fitted.undetermined[..] else {
        panic!("{fitted}")
    };
    let mut names: Vec<&str> = combination.terms.iter().map(|(name, _)| name.as_str()).collect();
    names.sort_unstable();
    assert_eq!(names, ["g1", "g2", "m1", "m2"]);
    assert!(combination.terms.iter().all(|(_, part)| (part - 1.0).abs() < 1e-6) && combination.deviation > 1e6);
    assert!(fitted.estimate("m1").expect("free").deviation.is_infinite());
    let length = fitted.estimate("l1").expect("free");
    assert!(length.deviation < 1e-3 && (length.value - truth.l1).abs() < 4.0 * length.deviation);
}

#[test]
fn first_order_states_that_nothing_measures_are_named() {
    let truth = Bristled::new(BristledParams::default()).expect("valid");
    let (times, method) = (times(100.0, 4.0), Rk4::new(0.002));
    let motion = method
        .solve(&truth, 0.0, 4.0, [1.0, 0.0, 0.0, 0.0, 0.9])
        .expect("a motion");
    let random = &mut Random::new(21);
    let mut measurement = Measurement::new(&times).expect("times");
    for (name, n) in [("theta", 0), ("readings", 4)] {
        let of = |&t: &f64| motion.at(t).expect("inside")[n] + 0.002 * random.normal();
        measurement = measurement
            .output(name, &times.iter().map(of).collect::<Vec<_>>())
            .expect("values");
    }
    let rough = Bristled::new(BristledParams { friction: 0.1 }).expect("valid");
    let unmeasured = |measurement: &Measurement| -> Vec<(String, usize, bool)> {
        let fit = Fit::new(method).separate_windows(0.5);
        let fitted = fit.run(&[Experiment::new(&rough, measurement)]).expect("a fit");
        let found = fitted.warnings.iter().filter_map(|warning| match warning {
            Warning::Unmeasured {
                state,
                windows,
                deviation,
                ..
            } => Some((state.clone(), *windows, deviation.is_infinite())),
            _ => None,
        });
        found.collect()
    };
    let heat = ("heat".to_owned(), 8, true);
    let [(bent, windows, false), other] = &unmeasured(&measurement)[..] else {
        panic!("{:?}", unmeasured(&measurement))
    };
    assert!(bent == "bent" && *windows > 0 && *other == heat, "{bent} {windows}");
    // a prior of the bristles alone, at the starts of windows
    let prior = (0..times.len()).map(|n| if n % 50 == 0 { 0.0 } else { f64::NAN });
    let measurement = measurement.output_with_noise("bent", &prior.collect::<Vec<_>>(), 0.6);
    assert_eq!(unmeasured(&measurement.expect("values")), [heat]);
}

#[test]
fn likelihood_tells_which_friction_acts() {
    let random = &mut Random::new(9);
    let clock = times(100.0, 6.0);
    let quiet = TimeTable::hold(&[0.0], [&[0.0]]).expect("samples");
    let mut compare = |dry: f64| {
        let params = DrivenParams {
            k: 8.0,
            viscous: 0.05,
            dry,
            zero: 0.0,
            gain: 1.0,
        };
        let model = Driven::new(params).expect("valid").with_law(quiet.clone());
        let measurement = measured(&model, [1.5, 0.0], &clock, &[("theta", 0)], (0.002, random));
        let rough = Driven::new(DrivenParams { dry: 0.05, ..params })
            .expect("valid")
            .with_law(quiet.clone());
        let without = Driven::new(DrivenParams { dry: 0.0, ..params })
            .expect("valid")
            .with_law(quiet.clone());
        let fit = |free: &[&'static str]| Fit::new(method()).free(free.iter().copied());
        let viscous = fit(&["k", "viscous"])
            .run(&[Experiment::new(&without, &measurement)])
            .expect("a fit");
        let both = fit(&["k", "viscous", "dry"])
            .run(&[Experiment::new(&rough, &measurement)])
            .expect("a fit");
        viscous.likelihood.compare(&both.likelihood)
    };
    let [with, without] = [compare(0.05), compare(0.0)];
    assert!(with.p_value < 1e-6 && with.bic < -10.0 && with.degrees == 1, "{with:?}");
    assert!(without.p_value > 0.01 && without.bic > 0.0, "{without:?}");
}

#[test]
fn robust_losses_bear_outliers() {
    let truth = RigParams { tip: 0.3, gamma: 0.07 };
    let rig = Rig::new(truth).expect("valid");
    let random = &mut Random::new(10);
    let clock = times(100.0, 5.0);
    let clean = measured(&rig, [1.0, 0.0], &clock, &[("angle", 0)], (0.002, random));
    let mut values = clean.values().next().expect("a column").to_vec();
    for value in values.iter_mut().step_by(17) {
        *value += random.between(0.0, 1.0);
    }
    let dirty = Measurement::new(&clock)
        .expect("times")
        .output("angle", &values)
        .expect("values");
    let rough = Rig::new(RigParams::default()).expect("valid");
    let error = |loss| {
        let fitted = Fit::new(method())
            .loss(loss)
            .run(&[Experiment::new(&rough, &dirty)])
            .expect("a fit");
        (fitted.parameters[0] - truth.tip).abs() / truth.tip
    };
    assert!(error(Loss::Squares) > 0.02);
    for loss in [Loss::Huber(1.5), Loss::SoftL1(1.5), Loss::Cauchy(1.5)] {
        assert!(error(loss) < 0.005, "{loss:?}: {}", error(loss));
    }
}

#[test]
fn experiments_share_parameters_and_starts_may_be_known() {
    let truth = RigParams { tip: 0.3, gamma: 0.07 };
    let rig = Rig::new(truth).expect("valid");
    let rough = Rig::new(RigParams::default()).expect("valid");
    let random = &mut Random::new(11);
    let clock = times(100.0, 2.0);
    let starts = [[1.0, 0.0], [0.3, 2.0]];
    let all = starts.map(|start| measured(&rig, start, &clock, &[("angle", 0)], (0.002, random)));
    let fit = Fit::new(method());
    let first = fit.run(&[Experiment::new(&rough, &all[0])]).expect("a fit");
    let both = fit
        .run(&[Experiment::new(&rough, &all[0]), Experiment::new(&rough, &all[1])])
        .expect("a fit");
    let known = fit
        .run(&[Experiment::new(&rough, &all[0].between(0.5, 2.0)).from_known(0.0, starts[0])])
        .expect("a fit");
    for fitted in [&first, &both, &known] {
        assert!(
            fitted
                .estimates
                .iter()
                .zip(truth.to_array())
                .all(|(e, v)| (e.value - v).abs() < 4.0 * e.deviation)
        );
    }
    assert!(both.estimates[0].deviation < 0.9 * first.estimates[0].deviation);
    assert_eq!((both.windows.len(), both.likelihood.unknowns), (2, 2 + 4 + 1));
    assert_eq!(
        (known.windows[0].t0, known.windows[0].start, known.likelihood.unknowns),
        (0.0, starts[0].into(), 2 + 1)
    );
    // nothing but the start is fitted
    let predicted = Fit::new(method())
        .free([])
        .run(&[Experiment::new(&rig, &all[1])])
        .expect("a fit");
    assert!(predicted.estimates.is_empty() && predicted.parameters == truth.to_array());
    assert!((0.0018..0.0022).contains(&predicted.rms("angle")));
}

#[test]
fn progress_is_reported_and_the_best_point_is_kept() {
    let rig = Rig::new(RigParams { tip: 0.3, gamma: 0.07 }).expect("valid");
    let rough = Rig::new(RigParams::default()).expect("valid");
    let measurement = measured(
        &rig,
        [1.0, 0.0],
        &times(50.0, 2.0),
        &[("angle", 0)],
        (0.002, &mut Random::new(12)),
    );
    let experiment = [Experiment::new(&rough, &measurement)];
    let mut losses = Vec::new();
    let fitted = Fit::new(method()).run_with(&experiment, |progress| {
        losses.push((progress.loss, progress.parameters.to_vec()));
        if losses.len() == 2 {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    let fitted = fitted.expect("a fit");
    assert_eq!(fitted.status, Status::Stopped);
    assert!(losses.len() == 2 && losses[1].0 < losses[0].0 && fitted.parameters.as_slice() == losses[1].1);
    let fitted = Fit::new(method()).max_iterations(1).run(&experiment).expect("a fit");
    assert_eq!((fitted.status, fitted.iterations), (Status::OutOfIterations, 1));
    assert!(fitted.to_string().ends_with("not converged after 1 iterations"));
}

#[test]
fn a_window_beyond_the_horizon_and_a_bound_are_warnings() {
    let truth = DoubleParams {
        m1: 1.0,
        m2: 1.0,
        l1: 1.0,
        l2: 1.0,
        g1: 0.0,
        g2: 0.0,
    };
    let double = Double::new(truth).expect("valid");
    let names = [("a", 0), ("b", 1)];
    let measurement = measured(
        &double,
        [2.0, 2.5, 0.0, 0.0],
        &times(50.0, 12.0),
        &names,
        (0.002, &mut Random::new(13)),
    );
    let fit = Fit::new(method()).free(["l1"]);
    let fitted = fit
        .clone()
        .max_iterations(3)
        .run(&[Experiment::new(&double, &measurement)])
        .expect("a fit");
    let Some(Warning::BeyondHorizon {
        exponent,
        horizon,
        length,
        ..
    }) = fitted
        .warnings
        .iter()
        .find(|warning| matches!(warning, Warning::BeyondHorizon { .. }))
    else {
        panic!("{fitted}")
    };
    assert!((0.5..5.0).contains(exponent) && horizon < length, "{fitted}");
    let fitted = fit
        .clone()
        .separate_windows(1.0)
        .run(&[Experiment::new(&double, &measurement)])
        .expect("a fit");
    assert!(fitted.warnings.is_empty(), "{fitted}");
    let fitted = fit.bounds("l1", 0.5, 1.0).separate_windows(1.0);
    let short = Double::new(DoubleParams { l1: 0.9, ..truth }).expect("valid");
    let longer = Double::new(DoubleParams { l1: 1.1, ..truth }).expect("valid");
    let measurement = measured(
        &longer,
        [2.0, 2.5, 0.0, 0.0],
        &times(50.0, 4.0),
        &names,
        (0.002, &mut Random::new(14)),
    );
    let fitted = fitted.run(&[Experiment::new(&short, &measurement)]).expect("a fit");
    assert!(
        fitted.warnings.contains(&Warning::AtBound {
            parameter: "l1".to_owned(),
            bound: 1.0
        }),
        "{fitted}"
    );
    assert_eq!(fitted.estimates[0].interval, [1.0, 1.0]);
    // friction must not be negative without saying so
    let measurement = measured(
        &double,
        [1.0, 0.5, 0.0, 0.0],
        &times(50.0, 2.0),
        &names,
        (0.02, &mut Random::new(15)),
    );
    let damped = Double::new(DoubleParams {
        g1: 0.05,
        g2: 0.05,
        ..truth
    })
    .expect("valid");
    let fitted = Fit::new(method())
        .free(["g1", "g2"])
        .run(&[Experiment::new(&damped, &measurement)])
        .expect("a fit");
    assert!(
        fitted.estimates.iter().all(|estimate| estimate.value >= 0.0),
        "{fitted}"
    );
}

mechanism! {
    Slider {
        params { k: N/m = 25, mass: kg = 1, drag: N s/m = 0.4, low: m = -0.25, high: m = 0.25, e: 1 = 0.7 }
        output grows: exp(900*s/1 m),
        body slider on ground {
            mass: mass, joint: prismatic(x), coordinate: s, spring: (k, 0), friction: drag,
            stop: [low, high] restitution(e),
        }
    }
}

#[test]
fn parameters_that_are_not_free_are_those_of_each_experiment() {
    // two masses known by a scale; neither alone determines the spring
    let (clock, random) = (times(100.0, 2.0), &mut Random::new(20));
    let heavy = |mass, k, drag| {
        Slider::new(SliderParams {
            mass,
            k,
            drag,
            ..SliderParams::default()
        })
        .expect("valid")
    };
    let masses = [1.0, 2.0];
    let all = masses.map(|mass| {
        measured(
            &heavy(mass, 20.0, 0.3),
            [0.2, 0.0],
            &clock,
            &[("s", 0)],
            (0.001, random),
        )
    });
    let models = masses.map(|mass| heavy(mass, 25.0, 0.4));
    let experiments = [
        Experiment::new(&models[0], &all[0]),
        Experiment::new(&models[1], &all[1]),
    ];
    let fitted = Fit::new(method()).free(["k", "drag"]).run(&experiments).expect("a fit");
    for (estimate, truth) in fitted.estimates.iter().zip([20.0, 0.3]) {
        assert!((estimate.value - truth).abs() < 4.0 * estimate.deviation, "{fitted}");
    }
    assert!((0.0009..0.0011).contains(&fitted.noise_of("s").expect("measured")));
}

#[test]
fn starts_that_noise_puts_beyond_a_stop_are_put_back() {
    let slider = Slider::new(SliderParams::default()).expect("valid");
    let (clock, random) = (times(100.0, 1.0), &mut Random::new(21));
    let (mut near, mut all) = (0, 0);
    for _ in 0..10 {
        let measurement = measured(&slider, [0.25, 0.0], &clock, &[("s", 0)], (0.005, random));
        let rough = Slider::new(SliderParams {
            k: 30.0,
            ..SliderParams::default()
        })
        .expect("valid");
        for fit in [Fit::new(method()), Fit::new(method()).windows(0.25)] {
            let fitted = fit
                .free(["k"])
                .run(&[Experiment::new(&rough, &measurement)])
                .expect("a fit");
            near += usize::from((fitted.estimates[0].value - 25.0).abs() < 5.0 * fitted.estimates[0].deviation);
            all += 1;
        }
    }
    // a start at a stop, with an impact at once or not, may end at another optimum
    assert!(near >= all / 2, "{near} of {all}");
}

#[test]
fn starts_that_noise_puts_beyond_a_wall_are_put_back() {
    let bouncing = Bouncing::new(BouncingParams { e: 0.8, g: 9.81 }).expect("valid");
    let noise = (0.001, &mut Random::new(22));
    let measurement = measured(&bouncing, [0.0, 3.0], &times(100.0, 2.0), &[("y", 0)], noise);
    let rough = Bouncing::new(BouncingParams::default()).expect("valid");
    // some windows start on the other side of an impact than their first guess
    let fit = Fit::new(method());
    for fit in [fit.clone(), fit.clone().windows(0.2), fit.separate_windows(0.2)] {
        let fitted = fit.run(&[Experiment::new(&rough, &measurement)]).expect("a fit");
        for (estimate, truth) in fitted.estimates.iter().zip([0.8, 9.81]) {
            let error = (estimate.value - truth).abs();
            assert!(error < 4.0 * estimate.deviation && error < 0.02 * truth, "{fitted}");
        }
    }
}

#[test]
fn windows_have_enough_values_and_gaps_are_reported() {
    let truth = RigParams { tip: 0.3, gamma: 0.07 };
    let rig = Rig::new(truth).expect("valid");
    let rough = Rig::new(RigParams::default()).expect("valid");
    let measurement = measured(
        &rig,
        [1.0, 0.0],
        &times(4.0, 8.0),
        &[("angle", 0)],
        (0.002, &mut Random::new(22)),
    );
    let experiment = [Experiment::new(&rough, &measurement).from_guess([1.0, 0.0])];
    let single = Fit::new(method()).run(&experiment).expect("a fit");
    for length in [1e-300, 0.1, 0.5, 1.5] {
        let joined = Fit::new(method()).windows(length).run(&experiment).expect("a fit");
        assert!((1..=8).contains(&joined.windows.len()) && joined.status == Status::Converged);
        for (single, joined) in single.estimates.iter().zip(&joined.estimates) {
            assert!(
                (single.value - joined.value).abs() < 0.01 * single.deviation,
                "{length}: {joined:?}"
            );
        }
    }
    let early = Fit::new(method())
        .windows(1.5)
        .max_iterations(2)
        .run(&experiment)
        .expect("a fit");
    assert!(
        early.warnings.iter().any(|warning| matches!(warning, Warning::Gap(_))),
        "{early}"
    );
}

#[test]
fn deviations_of_robust_fits_are_those_of_the_scatter() {
    let truth = RigParams { tip: 0.3, gamma: 0.07 };
    let rig = Rig::new(truth).expect("valid");
    let random = &mut Random::new(23);
    let clock = times(50.0, 3.0);
    for loss in [Loss::Huber(1.5), Loss::Cauchy(2.0)] {
        let (mut squares, mut count) = (0.0, 0.0);
        for _ in 0..20 {
            let clean = measured(&rig, [1.0, 0.0], &clock, &[("angle", 0)], (0.01, random));
            let mut values = clean.values().next().expect("a column").to_vec();
            for value in &mut values {
                if random.between(0.0, 1.0) < 0.1 {
                    *value += random.between(-1.0, 1.0);
                }
            }
            let dirty = Measurement::new(&clock)
                .expect("times")
                .output("angle", &values)
                .expect("values");
            let near = Experiment::new(&rig, &dirty).from_guess([1.0, 0.0]);
            let fitted = Fit::new(Rk4::new(0.02)).loss(loss).run(&[near]).expect("a fit");
            for (estimate, truth) in fitted.estimates.iter().zip(truth.to_array()) {
                squares += ((estimate.value - truth) / estimate.deviation).powi(2);
                count += 1.0;
            }
            assert!(fitted.likelihood.logarithm.is_nan());
        }
        // 40 values: 1 with a standard deviation of 0.11
        let ratio = f64::sqrt(squares / count);
        assert!((0.75..1.3).contains(&ratio), "{loss:?}: {ratio}");
    }
}

#[test]
fn bad_input_is_an_error_that_says_what_to_do() {
    let rig = Rig::new(RigParams::default()).expect("valid");
    let clock = times(50.0, 1.0);
    let good = measured(&rig, [1.0, 0.0], &clock, &[("angle", 0)], (0.002, &mut Random::new(16)));
    let of = |fit: Fit<Vern9>, measurement: &Measurement| {
        fit.run(&[Experiment::new(&rig, measurement)])
            .expect_err("bad input")
            .to_string()
    };
    let named = |name: &str| {
        Measurement::new(&clock)
            .expect("times")
            .output(name, &clock)
            .expect("values")
    };
    let message = of(Fit::new(method()), &named("angel"));
    assert_eq!(
        message,
        "the scene has no output or component of the state `angel`; did you mean `angle`?"
    );
    let message = of(Fit::new(method()), &named("voltage"));
    assert!(message.ends_with("it has `angle`, `dot(angle)`"), "{message}");
    let message = of(Fit::new(method()).free(["gama"]), &good);
    assert_eq!(message, "the scene has no parameter `gama`; did you mean `gamma`?");
    assert!(of(Fit::new(method()).bounds("mass", 0.0, 1.0), &good).ends_with("it has `tip`, `gamma`"));
    let message = of(Fit::new(method()).bounds("tip", 0.6, 1.0), &good);
    assert_eq!(
        message,
        "`tip` is 0.5 in the model, outside of its bounds 0.6 and 1: begin inside"
    );
    let message = of(Fit::new(method()), &good.between(0.0, 0.05));
    assert!(message.starts_with("3 measured values for 4 unknowns"), "{message}");
    assert!(of(Fit::new(method()).windows(-1.0), &good).starts_with("the length of the windows is -1"));
    assert!(of(Fit::new(method()).loss(Loss::Huber(0.0)), &good).starts_with("the threshold of the loss is 0"));
    assert!(of(Fit::new(method().rtol(-1.0)), &good).contains("rtol"));
    let late = Experiment::new(&rig, &good).from_known(0.5, [1.0, 0.0]);
    assert!(matches!(
        Fit::new(method()).run(&[late]),
        Err(FitError::StartsLate { .. })
    ));
    assert!(matches!(
        Fit::new(method()).run::<Rig, 2, 2>(&[]),
        Err(FitError::NoExperiment)
    ));
    let empty = Measurement::new(&clock).expect("times");
    assert!(matches!(
        Fit::new(method()).run(&[Experiment::new(&rig, &empty)]),
        Err(FitError::NoOutput { .. })
    ));
    let message = of(Fit::new(method()).bounds("tip", 2.0, 0.5), &good);
    assert_eq!(message, "the bounds of `tip` are 2 and 0.5: give the lower one first");
    assert!(
        of(Fit::new(method()).bounds("tip", f64::NAN, 0.5), &good).starts_with("the bounds of `tip` are NaN and 0.5")
    );
    let missing = good
        .clone()
        .output("dot(angle)", &vec![f64::NAN; clock.len()])
        .expect("values");
    assert!(of(Fit::new(method()), &missing).starts_with("all values of `dot(angle)` are missing"));
    let slider = Slider::new(SliderParams {
        low: -9.0,
        high: 9.0,
        ..SliderParams::default()
    })
    .expect("valid");
    let grows = Measurement::new(&clock)
        .expect("times")
        .output("grows", &clock)
        .expect("values");
    let start = Experiment::new(&slider, &grows).from_guess([1.0, 0.0]);
    let message = Fit::new(method())
        .free(["k"])
        .run(&[start])
        .expect_err("not finite")
        .to_string();
    assert!(
        message.starts_with("`grows` or its derivative is not finite at t = 0 in experiment 0"),
        "{message}"
    );
    // at rest no parameter has an influence
    let rest = Measurement::new(&clock)
        .expect("times")
        .output("angle", &vec![0.0; clock.len()])
        .expect("values");
    let known = Experiment::new(&rig, &rest).from_known(0.0, [0.0, 0.0]);
    let message = Fit::new(method()).run(&[known]).expect_err("no influence").to_string();
    assert!(message.starts_with("no measured output depends on `tip`"), "{message}");
    let order = Measurement::new(&[0.0, 0.2, 0.1]).expect_err("order");
    assert!(matches!(order, SampleError::Order { index: 2, .. }) && order.to_string().contains("sort the samples"));
    assert!(matches!(
        Measurement::new(&[0.0, f64::NAN]),
        Err(SampleError::Time { index: 1, .. })
    ));
    let infinite =
        Measurement::new(&[0.0, 1.0]).and_then(|measurement| measurement.output("angle", &[0.0, f64::INFINITY]));
    assert!(matches!(infinite, Err(SampleError::Value { index: 1, .. })));
    let noise = Measurement::new(&[0.0]).and_then(|measurement| measurement.output_with_noise("angle", &[0.0], 0.0));
    assert!(matches!(noise, Err(SampleError::Noise { .. })));
}

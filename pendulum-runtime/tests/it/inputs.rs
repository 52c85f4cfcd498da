//! Inputs that follow samples: motions, ensembles and fits are those of compiled code.

use std::fs::File;

use pendulum_core::fit::{self, Measurement, Table};
use pendulum_core::inputs::Generic;
use pendulum_core::prelude::*;
use pendulum_core::{CastJacobian, WithInputs};
use pendulum_runtime::{
    Declaration, Error, Experiment, Fit, Lyapunov, Members, Method as Named, Model, Question, TimeTable, simplest,
};

mod smooth {
    use super::*;

    twice! {
        /// A cart that is pushed, and a pole with a motor.
        pub Driven {
            params { l: m = 0.6, gamma: N m s = 0.1, bias: N m = 0.05 }
            input push: N,
            input motor: N m,
            gravity: [0, -9.81, 0],
            output angle: turn,
            body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, torque: push, spring: (30, 0) }
            body rod on cart {
                mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: turn, torque: motor + bias, friction: gamma,
            }
        }
    }

    pub(super) fn model() -> (Driven, Model) {
        let compiled = Driven::new(DrivenParams::default()).expect("valid");
        (compiled, Model::parse(TEXT).expect("valid"))
    }
}

mod hybrid {
    use super::*;

    twice! {
        /// Cart and pole with dry friction and a stop.
        pub Sticky {
            params { l: m = 0.6, mu: N m = 0.3 }
            input push: N,
            input motor: N m,
            gravity: [0, -9.81, 0],
            body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, torque: push, spring: (30, 0) }
            body rod on cart {
                mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: turn, torque: motor, dry_friction: mu,
                stop: [-0.5, 0.8],
            }
        }
    }

    pub(super) fn model() -> (Sticky, Model) {
        let compiled = Sticky::new(StickyParams::default()).expect("valid");
        (compiled, Model::parse(TEXT).expect("valid"))
    }
}

mod arm {
    use super::*;

    twice! {
        /// The arm of the example `measured`.
        pub Arm {
            params {
                m1: kg = 0.559, m2: kg = 0.604, l: m = 0.3, i1: kg m^2 = 0.0535, i2: kg m^2 = 0.0239,
                r1: m = 0.3, r2: m = 0.184, rotor: kg m^2 = 1e-12, viscous1: N m s = 0.001, viscous2: N m s = 0.001,
                dry1: N m = 0, dry2: N m = 0, static1: 1 = 1, static2: 1 = 1, zero1: rad = 0, zero2: rad = 0,
                error1: N m = 0, error2: N m = 0,
            }
            input torque1: N m, input torque2: N m,
            gravity: [0, -9.81, 0],
            output q1: upper_angle - zero1,
            output q2: lower_angle - zero2,
            body upper on ground {
                mass: m1, com: [0, -r1, 0], inertia: i1 about joint,
                joint: revolute(z), coordinate: upper_angle, torque: torque1 + error1,
                friction: viscous1, dry_friction: dry1, static_friction: static1*dry1,
            }
            body lower on upper {
                mass: m2, com: [0, -r2, 0], inertia: i2 about joint, joint: revolute(z) at [0, -l, 0],
                coordinate: lower_angle, torque: torque2 + error2,
                friction: viscous2, dry_friction: dry2, static_friction: static2*dry2,
            }
            body rotor2 on upper { inertia: rotor, joint: revolute(z), motion: -6*lower_angle }
        }
    }

    pub(super) const FREE: [&str; 6] = ["i1", "i2", "r1", "r2", "viscous1", "viscous2"];

    pub(super) fn model() -> (Arm, Model) {
        let compiled = Arm::new(ArmParams::default()).expect("valid");
        (compiled, Model::parse(TEXT).expect("valid"))
    }
}

const START: [f64; 4] = [0.1, 0.4, 0.0, -0.3];
const NAMES: [&str; 2] = ["push", "motor"];

/// Times and samples of both inputs; the times are uneven.
fn samples(phase: f64) -> (Vec<f64>, [Vec<f64>; 2]) {
    let times: Vec<f64> = (0..40)
        .map(|n| 0.08 * f64::from(n) + 0.02 * f64::from(n).sin())
        .collect();
    let motor = times.iter().map(|t| 1.5 * (3.0 * t + phase).sin()).collect();
    let push = times.iter().map(|t| 4.0 * (2.0 * t + phase).cos()).collect();
    (times, [push, motor])
}

/// Both inputs in one law, as compiled code takes it, and one law for each.
fn laws(phase: f64, interpolation: &str) -> (TimeTable<2>, [TimeTable<1>; 2]) {
    let (times, [push, motor]) = samples(phase);
    let (both, push, motor) = match interpolation {
        "hold" => (
            TimeTable::hold(&times, [&push, &motor]),
            TimeTable::hold(&times, [&push]),
            TimeTable::hold(&times, [&motor]),
        ),
        "linear" => (
            TimeTable::linear(&times, [&push, &motor]),
            TimeTable::linear(&times, [&push]),
            TimeTable::linear(&times, [&motor]),
        ),
        _ => (
            TimeTable::cubic(&times, [&push, &motor]),
            TimeTable::cubic(&times, [&push]),
            TimeTable::cubic(&times, [&motor]),
        ),
    };
    (both.expect("samples"), [push, motor].map(|law| law.expect("samples")))
}

fn named(laws: [TimeTable<1>; 2]) -> [(&'static str, TimeTable<1>); 2] {
    let [push, motor] = laws;
    [(NAMES[0], push), (NAMES[1], motor)]
}

fn method(name: &str) -> Named {
    let method = Named::new(name).expect("known");
    if method.is_fixed() {
        method.h(0.01)
    } else {
        method.rtol(1e-7).atol(1e-8)
    }
}

/// Compares motions of compiled code and of the model at run time under the same samples.
fn compare<S>(compiled: &S, model: &Model)
where
    S: Controlled<f64, 4, 2> + Copy,
    WithInputs<S, Generic<TimeTable<2>>, 2>: CastJacobian<4>,
    for<'s> WithInputs<S, Generic<TimeTable<2>>, 2>: Jacobian<f64, 4>,
{
    for interpolation in ["hold", "linear", "cubic"] {
        let (both, each) = laws(0.3, interpolation);
        let compiled = compiled.with_law(both);
        let model = model.with_laws(&named(each)).expect("inputs");
        macro_rules! same {
            ($($name:ident $method:expr;)*) => { $({
                let own = model.solve(&method(stringify!($name)), [0.0, 3.5], &START).expect("regular");
                let other = $method.solve(&compiled, 0.0, 3.5, START).expect("regular");
                let what = format!("{} {interpolation}", stringify!($name));
                assert_eq!(own.end().1, other.end().as_slice(), "{what}");
                assert_eq!(own.t(), other.t(), "{what}");
                assert_eq!(own.statistics(), other.statistics(), "{what}");
                assert_eq!(own.impacts().len(), other.impacts().len(), "{what}");
            })* };
        }
        same! {
            Rk4 Rk4::new(0.01);
            Vern9 Vern9::new().rtol(1e-7).atol(1e-8);
            Rodas5P Rodas5P::new().rtol(1e-7).atol(1e-8);
            Radau5 Radau5::new().rtol(1e-7).atol(1e-8);
        }
        let x = SVector::from(START);
        assert_eq!(model.rhs(1.23, &START).expect("4"), compiled.rhs(1.23, &x).as_slice());
        assert_eq!(
            model.jacobian(1.23, &START).expect("4").as_slice(),
            compiled.jacobian(1.23, &x).as_slice()
        );
    }
}

#[test]
fn motions_under_samples_have_the_bits_of_compiled_code() {
    let (compiled, model) = smooth::model();
    compare(&compiled, &model);
    let (compiled, model) = hybrid::model();
    compare(&compiled, &model);
    let (_, each) = laws(0.3, "linear");
    let motion = model
        .with_laws(&named(each))
        .map(|model| model.solve(&method("Vern9"), [0.0, 3.5], &START).expect("regular"))
        .expect("inputs");
    assert!(!motion.impacts().is_empty() && !motion.modes().is_empty());
}

#[test]
fn functions_use_the_samples_at_their_time() {
    let (_, model) = smooth::model();
    let (times, [_, motor]) = samples(0.0);
    let law = TimeTable::linear(&times, [&motor]).expect("samples");
    let driven = model
        .with_inputs(&[("push", 2.0)])
        .and_then(|model| model.with_laws(&[("motor", law)]));
    let driven = driven.expect("inputs");
    let (t, last) = (times[7], times[times.len() - 1]);
    for (t, value) in [(t, motor[7]), (last + 1.0, motor[times.len() - 1]), (-1.0, motor[0])] {
        let constant = model.with_inputs(&[("push", 2.0), ("motor", value)]).expect("inputs");
        assert_eq!(driven.rhs(t, &START), constant.rhs(t, &START));
        let columns = |model: &Model| model.evaluate("input_jacobian", t, &START, &[]).expect("generated");
        assert_eq!(columns(&driven), columns(&constant));
    }
    assert_eq!(
        driven.laws().iter().map(|(name, _)| *name).collect::<Vec<_>>(),
        ["motor"]
    );
    // other parameters keep the law, a constant replaces it
    let longer = driven.with(&[("l", 0.9)]).expect("valid");
    let alone = model
        .with(&[("l", 0.9)])
        .and_then(|model| model.with_inputs(&[("push", 2.0), ("motor", motor[7])]));
    assert_eq!(longer.rhs(t, &START), alone.expect("valid").rhs(t, &START));
    let idle = driven.with_inputs(&[("push", 0.0), ("motor", 0.0)]).expect("inputs");
    assert_eq!(idle.rhs(t, &START), model.rhs(t, &START));
}

#[test]
fn a_model_under_samples_depends_on_time() {
    let (_, model) = smooth::model();
    let driven = model.with_laws(&named(laws(0.0, "cubic").1)).expect("inputs");
    let error = driven
        .equilibria(&[START.to_vec()])
        .expect_err("it depends on time")
        .to_string();
    assert!(error.contains("time"), "{error}");
    let settings = Lyapunov {
        duration: 3.0,
        ..Lyapunov::default()
    };
    let [own, idle] = [&driven, &model].map(|model| model.lyapunov(&START, &settings).expect("regular").values[0]);
    assert_ne!(own, idle);
    // the derivatives by the start are those of differences
    let times = [0.2, 1.7];
    let found = driven
        .sensitivity(&method("Rk4"), &times, &START, &["turn", "bias"])
        .expect("regular");
    let end = |model: &Model, x0: [f64; 4]| {
        let motion = model.solve(&method("Rk4"), [0.2, 1.7], &x0).expect("regular");
        motion.end().1.to_vec()
    };
    let step = 1e-5;
    let by_start = [-step, step].map(|step| end(&driven, [START[0], START[1] + step, START[2], START[3]]));
    let by_bias = [-step, step].map(|step| end(&driven.with(&[("bias", 0.05 + step)]).expect("valid"), START));
    for (column, [low, high]) in [by_start, by_bias].iter().enumerate() {
        for row in 0..4 {
            let difference = (high[row] - low[row]) / (2.0 * step);
            assert!((found.derivatives[1][(row, column)] - difference).abs() < 1e-8);
        }
    }
}

/// Compares an ensemble, with parameters and samples of each member, with motions of compiled code.
fn compare_ensembles<S>(model: &Model, names: &[&str], of: impl Fn(f64) -> S, second: f64)
where
    S: Controlled<f64, 4, 2> + Copy,
    WithInputs<S, Generic<TimeTable<2>>, 2>: CastJacobian<4>,
{
    const COUNT: usize = 9;
    let starts: Vec<[f64; 4]> = (0..COUNT).map(|n| START.map(|x| x * (1.0 - 0.05 * n as f64))).collect();
    let values = model.values();
    let changed = |n: usize| second * (1.0 + 0.05 * n as f64);
    let parameters: Vec<f64> = (0..COUNT)
        .flat_map(|n| (0..values.len()).map(move |k| if k == 1 { changed(n) } else { values[k] }))
        .collect();
    for interpolation in ["hold", "linear", "cubic"] {
        let each: Vec<_> = (0..COUNT).map(|n| laws(0.1 * n as f64, interpolation)).collect();
        let of_input = |input: usize| each.iter().map(|(_, each)| each[input].clone()).collect();
        let own = [("push", of_input(0)), ("motor", of_input(1))];
        for name in names {
            let members = Members {
                starts: starts.as_flattened(),
                parameters: Some(&parameters),
                laws: &own,
                times: &[],
                cancel: None,
            };
            let apart = model.ensemble(&method(name), [0.0, 1.0], &members).expect("valid");
            assert!(apart.stopped.is_empty());
            let all = model.with_laws(&named(each[3].1.clone())).expect("inputs");
            let members = Members { laws: &[], ..members };
            let alike = all.ensemble(&method(name), [0.0, 1.0], &members).expect("valid");
            for (n, start) in starts.iter().enumerate() {
                let compiled = of(changed(n));
                for (ends, law) in [(&apart.ends, &each[n].0), (&alike.ends, &each[3].0)] {
                    let compiled = compiled.with_law(law.clone());
                    let end = match *name {
                        "Rk4" => Rk4::new(0.01).solve(&compiled, 0.0, 1.0, *start),
                        _ => Vern9::new().rtol(1e-7).atol(1e-8).solve(&compiled, 0.0, 1.0, *start),
                    };
                    let end = end.expect("regular").end();
                    assert_eq!(&ends[4 * n..4 * n + 4], end.as_slice(), "{name} {interpolation} {n}");
                }
            }
        }
    }
}

#[test]
fn ensembles_under_samples_have_the_bits_of_compiled_code() {
    let of = |gamma| {
        let params = smooth::DrivenParams {
            gamma,
            ..Default::default()
        };
        smooth::Driven::new(params).expect("valid")
    };
    compare_ensembles(&smooth::model().1, &["Rk4", "Vern9"], of, 0.1);
    let of = |mu| {
        let params = hybrid::StickyParams {
            mu,
            ..Default::default()
        };
        hybrid::Sticky::new(params).expect("valid")
    };
    compare_ensembles(&hybrid::model().1, &["Vern9"], of, 0.3);
}

/// Angles of a motion under samples, with small errors.
fn measured(phase: f64, interpolation: &str) -> Measurement {
    let truth = smooth::DrivenParams {
        l: 0.7,
        gamma: 0.15,
        bias: 0.08,
    };
    let driven = smooth::Driven::new(truth)
        .expect("valid")
        .with_law(laws(phase, interpolation).0);
    let motion = Rk4::new(0.002).solve(&driven, 0.0, 1.5, START).expect("regular");
    let times: Vec<f64> = (0..30).map(|n| 0.05 * f64::from(n)).collect();
    let noise = |t: f64| 1e-5 * (1e4 * t).sin();
    let column = |place: usize| -> Vec<f64> {
        times
            .iter()
            .map(|&t| motion.at(t).expect("inside")[place] + noise(t))
            .collect()
    };
    let measurement = Measurement::new(&times).and_then(|own| own.output("angle", &column(1)));
    measurement.and_then(|own| own.output("s", &column(0))).expect("valid")
}

#[test]
fn fits_with_samples_of_each_experiment_are_those_of_compiled_code() {
    let (compiled, model) = smooth::model();
    let experiments = [(0.3, "linear"), (2.0, "cubic")];
    let measurements = experiments.map(|(phase, interpolation)| measured(phase, interpolation));
    let driven = experiments.map(|(phase, interpolation)| compiled.with_law(laws(phase, interpolation).0));
    let of_compiled = [0, 1].map(|n| fit::Experiment::new(&driven[n], &measurements[n]));
    let own = [0, 1].map(|n| {
        let (phase, interpolation) = experiments[n];
        Experiment {
            measurement: measurements[n].clone(),
            guess: None,
            known: None,
            laws: named(laws(phase, interpolation).1)
                .map(|(name, law)| (name.to_owned(), law))
                .into(),
        }
    });
    macro_rules! same {
        ($($name:ident $method:expr;)*) => { $({
            let compiled: fit::Fitted<4, 3> = fit::Fit::new($method).run(&of_compiled).expect("valid");
            let fitted = model.fit(&Fit::new(method(stringify!($name))), &own).expect("valid");
            assert!(fitted.converged, "{}", fitted.summary);
            for (own, other) in fitted.estimates.iter().zip(&compiled.estimates) {
                assert!((own.value - other.value).abs() <= 1e-12 * other.value.abs(), "{own:?} {other:?}");
                assert!((own.deviation - other.deviation).abs() <= 1e-9 * other.deviation, "{own:?} {other:?}");
            }
            for (value, truth) in fitted.parameters.iter().zip([0.7, 0.15, 0.08]) {
                assert!((value - truth).abs() < 1e-3, "{fitted:?}");
            }
        })* };
    }
    same! {
        Rk4 Rk4::new(0.01);
        Vern9 Vern9::new().rtol(1e-7).atol(1e-8);
    }
}

/// Measured angles and torques of the example `measured`, of its scene with viscous friction.
#[test]
fn a_fit_to_a_real_arm_is_that_of_compiled_code() {
    let file = File::open("../examples/measured/data/run_1.csv").expect("data of the example");
    let table = Table::read_csv(file).expect("a table");
    let column = |name: &str| table.column(name).expect("a column");
    let times = column("time_s");
    let angles = Measurement::new(times).and_then(|own| own.output_with_noise("q1", column("q1_rad"), 2e-4));
    let angles = angles
        .and_then(|own| own.output_with_noise("q2", column("q2_rad"), 2e-4))
        .expect("valid");
    let measurement = angles.between(0.0, 2.0);
    let (compiled, model) = arm::model();
    let torques = ["tau1_Nm", "tau2_Nm"].map(column);
    let driven = compiled.with_law(TimeTable::linear(times, torques).expect("samples"));
    let compiled: fit::Fitted<4, 18> = fit::Fit::new(Rk4::new(0.004))
        .free(arm::FREE)
        .separate_windows(0.5)
        .run(&[fit::Experiment::new(&driven, &measurement)])
        .expect("valid");
    let laws = [("torque1", torques[0]), ("torque2", torques[1])]
        .map(|(name, torque)| (name.to_owned(), TimeTable::linear(times, [torque]).expect("samples")));
    let experiment = Experiment {
        measurement,
        guess: None,
        known: None,
        laws: laws.into(),
    };
    let settings = Fit {
        free: Some(arm::FREE.map(str::to_owned).into()),
        separate_windows: Some(0.5),
        ..Fit::new(Named::new("Rk4").expect("known").h(0.004))
    };
    let fitted = model.fit(&settings, &[experiment]).expect("valid");
    assert!(fitted.converged, "{}", fitted.summary);
    for (own, other) in fitted.estimates.iter().zip(&compiled.estimates) {
        assert!(
            (own.value - other.value).abs() <= 1e-12 * other.value.abs(),
            "{own:?} {other:?}"
        );
    }
}

fn says<T>(result: Result<T, Error>, what: &str) {
    let message = result.err().expect("an error").to_string();
    assert!(message.contains(what), "{message}");
}

#[test]
fn samples_that_are_wrong_are_refused() {
    let (_, model) = smooth::model();
    let (times, [push, motor]) = samples(0.0);
    let push = TimeTable::linear(&times, [&push]).expect("samples");
    let motor = TimeTable::linear(&times, [&motor]).expect("samples");
    says(
        model.with_laws(&[("moter", motor.clone())]),
        "there is no input `moter`; did you mean `motor`?",
    );
    let members = Members {
        starts: &START.repeat(2),
        parameters: None,
        laws: &[("motor", vec![motor.clone()])],
        times: &[],
        cancel: None,
    };
    says(
        model.ensemble(&method("Vern9"), [0.0, 1.0], &members),
        "the list of laws of `motor` has 1 entries, and 2 are needed",
    );
    let members = Members {
        laws: &[("torque", vec![motor.clone(), motor.clone()])],
        ..members
    };
    says(
        model.ensemble(&method("Vern9"), [0.0, 1.0], &members),
        "there is no input `torque`",
    );
    let fit = |laws: &[(&str, &TimeTable<1>)], times: &[f64]| {
        let zeros = vec![0.0; times.len()];
        let measurement = Measurement::new(times)
            .and_then(|own| own.output("angle", &zeros))
            .expect("valid");
        let experiment = Experiment {
            measurement,
            guess: None,
            known: None,
            laws: laws.iter().map(|&(name, law)| (name.to_owned(), law.clone())).collect(),
        };
        let settings = Fit {
            max_iterations: 1,
            ..Fit::new(method("Rk4"))
        };
        model.fit(&settings, &[experiment])
    };
    let inside: Vec<f64> = (0..20).map(|n| 0.1 * f64::from(n)).collect();
    says(fit(&[("moter", &motor)], &inside), "did you mean `motor`?");
    says(
        fit(&[("motor", &motor)], &inside),
        "the input `push` of experiment 0: others have samples",
    );
    let both = [("push", &push), ("motor", &motor)];
    assert!(fit(&both, &inside).is_ok());
    let zero = TimeTable::hold(&[0.0], [&[0.0]]).expect("a sample");
    assert!(fit(&[("push", &zero), ("motor", &motor)], &inside).is_ok());
    let late: Vec<f64> = inside.iter().map(|t| t + 2.0).collect();
    says(fit(&both, &late), "give samples of the whole motion");
    // a held value lasts as long as the one before
    let held = TimeTable::hold(&[0.0, 1.0, 2.0], [&[0.1, 0.0, 0.2]]).expect("samples");
    let until = |end: f64| [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 1.0, 1.5, 2.0, 2.5, end];
    assert!(fit(&[("push", &zero), ("motor", &held)], &until(3.0)).is_ok());
    says(
        fit(&[("push", &zero), ("motor", &held)], &until(3.1)),
        "the input `motor` of experiment 0: its samples are of 0.0 to 2.0 s, and the motion is of 0.0 to 3.1 s",
    );
    says(
        model.fit(&Fit::new(method("Tsit5")), &[]),
        "derivatives of trajectories are computed by `Vern9`",
    );
}

#[test]
fn simpler_models_follow_the_same_samples() {
    let law = laws(0.0, "cubic").1;
    let declaration = Declaration::new(smooth::TEXT);
    let question = Question {
        starts: vec![START.to_vec()],
        horizon: 2.0,
        outputs: vec!["angle".to_owned()],
        laws: named(law).map(|(name, law)| (name.to_owned(), law)).into(),
        ..Question::default()
    };
    let answer = simplest(&declaration, &question).expect("valid");
    let linear = answer
        .simpler
        .iter()
        .find(|own| own.changes[0].starts_with("linear about s = 0, turn"));
    let linear = linear.expect("it follows the samples, too");
    assert!(
        (linear.predicted[0] - linear.observed[0]).abs() < 0.1 * linear.observed[0],
        "{answer}"
    );
    let idle = Question {
        laws: Vec::new(),
        ..question
    };
    assert_ne!(answer.sizes, simplest(&declaration, &idle).expect("valid").sizes);
}

//! Stability, derivatives and fits.

use pendulum_core::fit::Measurement;
use pendulum_runtime::{Event, Experiment, Fit, Lyapunov, Method, Model, Options, Stability};

/// A damped pendulum, whose length and damping are parameters; with a state of two components, it is padded.
const DAMPED: &str = "pub Damped {
    params { l: m = 1, gamma: N m s = 0.1 }
    gravity: [0, -9.81, 0],
    body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: theta, friction: gamma }
}";

fn method() -> Method {
    Method::new("Vern9").expect("known").rtol(1e-11).atol(1e-12)
}

#[test]
fn equilibria_hang_and_stand() {
    let model = Model::parse(DAMPED).expect("valid");
    let (found, unsearched) = model.equilibria(&[vec![0.1, 0.0]]).expect("autonomous");
    assert!(unsearched.is_empty());
    let [hanging, standing] = &found[..] else {
        panic!("{found:?}")
    };
    assert_eq!(hanging.stability, Stability::AsymptoticallyStable);
    assert_eq!(standing.stability, Stability::Unstable);
    // lambda^2 + gamma lambda - g = 0
    let fastest = -0.05 + (9.81_f64 + 0.0025).sqrt();
    assert_eq!(standing.eigenvalues.len(), 2);
    assert!((standing.eigenvalues[0].re - fastest).abs() < 1e-12);
}

#[test]
fn a_search_for_rest_needs_a_finite_seed() {
    let held = DAMPED.replace("friction: gamma", "friction: gamma, stop: [-1, 2]");
    let model = Model::parse(&held).expect("valid");
    let error = model.resting(&[f64::NAN, 0.0]).expect_err("no number").to_string();
    assert!(
        error.contains("`seed` is NaN: its components must be finite"),
        "{error}"
    );
    // rates are ignored
    assert!(model.resting(&[0.0, f64::NAN]).is_ok());
}

#[test]
fn exponents_are_those_of_the_linearisation() {
    let model = Model::parse(DAMPED).expect("valid");
    let settings = Lyapunov {
        count: 2,
        duration: 400.0,
        ..Lyapunov::default()
    };
    let found = model.lyapunov(&[1e-6, 0.0], &settings).expect("regular");
    let sum: f64 = found.values.iter().sum();
    assert!((sum + 0.1).abs() < 1e-6, "the sum is the divergence: {found:?}");
    assert!(
        found.values.iter().all(|value| (value + 0.05).abs() < 1e-2),
        "{found:?}"
    );
    let three = Lyapunov { count: 3, ..settings };
    assert!(model.lyapunov(&[1e-6, 0.0], &three).is_err());
}

#[test]
fn tuned_methods_keep_within_the_error() {
    let model = Model::parse(DAMPED).expect("valid");
    let starts = [vec![0.8, 0.1], vec![2.0, 0.0]];
    let choices = model.tune([0.0, 2.5], &starts, 1e-7, 1.0).expect("regular");
    assert!(
        choices.windows(2).all(|pair| pair[0].time <= pair[1].time),
        "{choices:?}"
    );
    for start in &starts {
        let end = |method: &Method| {
            model
                .solve(method, [0.0, 2.5], start)
                .expect("regular")
                .end()
                .1
                .to_vec()
        };
        let known = end(&method());
        for choice in &choices {
            let off = end(&choice.method)
                .iter()
                .zip(&known)
                .any(|(x, known)| (x - known).abs() > 1e-7 * known.abs().max(1.0));
            assert!(!off, "{choice:?}");
        }
    }
    let refused = |starts: &[Vec<f64>], error| {
        model
            .tune([0.0, 2.5], starts, error, 1.0)
            .expect_err("refused")
            .to_string()
    };
    assert!(refused(&starts, 1e-17).contains("at least 8 ulps"));
    assert!(refused(&[], 1e-7).contains("at least one start"));
    assert!(refused(&[vec![0.8]], 1e-7).contains("2 are needed"));
    let cancelled = model
        .tune_unless([0.0, 2.5], &starts, 1e-7, 1.0, &|| true)
        .expect_err("cancelled");
    assert!(cancelled.to_string().contains("cancelled"), "{cancelled}");
}

#[test]
fn derivatives_agree_with_differences() {
    let model = Model::parse(DAMPED).expect("valid");
    let (times, start) = ([0.0, 1.0, 2.5], [0.8, 0.1]);
    let by = ["theta", "l", "gamma"];
    let found = model.sensitivity(&method(), &times, &start, &by).expect("regular");
    let end = |model: &Model, start: &[f64]| {
        let motion = model.solve(&method(), [0.0, 2.5], start).expect("regular");
        motion.end().1.to_vec()
    };
    let step = 1e-5;
    let differences = [
        [-1.0, 1.0].map(|side| end(&model, &[0.8 + side * step, 0.1])),
        [-1.0, 1.0].map(|side| end(&model.with(&[("l", 1.0 + side * step)]).expect("valid"), &start)),
        [-1.0, 1.0].map(|side| end(&model.with(&[("gamma", 0.1 + side * step)]).expect("valid"), &start)),
    ];
    for (k, [low, high]) in differences.iter().enumerate() {
        for row in 0..2 {
            let difference = (high[row] - low[row]) / (2.0 * step);
            let derivative = found.derivatives[2][(row, k)];
            assert!(
                (derivative - difference).abs() < 1e-7,
                "{} of {row}: {derivative} {difference}",
                by[k]
            );
        }
    }
    assert_eq!(found.derivatives[0].column(0).as_slice(), [1.0, 0.0]);
}

#[test]
fn derivatives_pass_where_a_clamp_saturates() {
    let motor = "pub Motor {
        params { k: N/m = 8, most: N = 1 }
        body cart on ground {
            mass: 1, joint: prismatic(x), coordinate: x, torque: clamp(-k*q, -most, most) - 0.1 N s/m*qd,
        }
    }";
    let model = Model::parse(motor).expect("valid");
    let loose = Method::new("Vern9").expect("known").rtol(1e-8).atol(1e-8);
    let found = model
        .sensitivity(&loose, &[0.0, 7.0], &[1.0, 0.0], &["x"])
        .expect("regular");
    let end = |start: f64| {
        let saturates = Options {
            events: vec![Event::declared("saturation_1")],
            ..Options::default()
        };
        let motion = model
            .solve_with(&method(), [0.0, 7.0], &[start, 0.0], &saturates)
            .expect("regular");
        motion.end().1.to_vec()
    };
    let step = 1e-5;
    let [low, high] = [1.0 - step, 1.0 + step].map(end);
    for row in 0..2 {
        let difference = (high[row] - low[row]) / (2.0 * step);
        let derivative = found.derivatives[1][(row, 0)];
        // in steps across the kinks 0.3 to 0.5 % are lost
        assert!((derivative - difference).abs() < 1e-5, "{derivative} {difference}");
    }
}

#[test]
fn a_fit_finds_the_parameters_of_a_motion() {
    let truth = Model::parse_with(DAMPED, &[("l", 1.3), ("gamma", 0.2)]).expect("valid");
    let times: Vec<f64> = (0..60).map(|n| 0.05 * f64::from(n)).collect();
    let motion = truth.solve(&method(), [0.0, 3.0], &[0.9, 0.0]).expect("regular");
    let measured: Vec<f64> = times
        .iter()
        .map(|&t| motion.at(t).expect("inside")[0] + 1e-6 * (1e4 * t).sin())
        .collect();
    let experiment = Experiment {
        measurement: Measurement::new(&times)
            .and_then(|all| all.output("theta", &measured))
            .expect("valid"),
        guess: None,
        known: None,
        laws: Vec::new(),
    };
    let guess = Model::parse(DAMPED).expect("valid");
    let both = Fit {
        windows: Some(1.0),
        separate_windows: Some(1.0),
        ..Fit::new(method())
    };
    let error = guess.fit(&both, std::slice::from_ref(&experiment));
    let error = error.expect_err("they exclude each other").to_string();
    assert!(error.contains("only one of them can be set"), "{error}");
    let nothing = Fit {
        free: Some(Vec::new()),
        ..Fit::new(method())
    };
    let fitted = truth.fit(&nothing, std::slice::from_ref(&experiment)).expect("a start");
    assert!(fitted.summary.starts_with("residuals of `theta`"), "{}", fitted.summary);
    let fitted = guess.fit(&Fit::new(method()), &[experiment]).expect("valid");
    assert!(fitted.converged, "{}", fitted.summary);
    assert!(
        (fitted.parameters[0] - 1.3).abs() < 1e-5 && (fitted.parameters[1] - 0.2).abs() < 1e-5,
        "{fitted:?}"
    );
    assert!((fitted.starts[0][0] - 0.9).abs() < 1e-5);
}

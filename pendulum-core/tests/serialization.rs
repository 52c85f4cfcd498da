//! Results survive a round trip through serialisation.
#![forbid(unsafe_code)]
#![allow(clippy::disallowed_methods, reason = "a test")]

use pendulum_core::prelude::*;
use pendulum_core::{ParameterError, Solution};

#[test]
fn a_solution_is_read_back_as_it_was_written() {
    let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]));
    let solution = Rk45::new().solve(&swing, 0.0, 5.0, [0.5, 0.0]).expect("regular");
    let text = serde_json::to_string(&solution).expect("writes");
    let read: Solution<f64, 2> = serde_json::from_str(&text).expect("reads");
    assert_eq!(read, solution);
    assert_eq!(read.at(2.5), solution.at(2.5));
    let event = || Event::new(|_t, x: &SVector<f64, 2>| x[0]).reset(|_t, x| -x);
    let solution = Rk45::new().solve_with(&swing, 0.0, 5.0, [0.5, 0.0], &[event()]);
    let solution = solution.expect("regular");
    let text = serde_json::to_string(&solution).expect("writes");
    assert_eq!(
        serde_json::from_str::<Solution<f64, 2>>(&text).expect("reads"),
        solution
    );
}

mechanism! {
    pub Ball {
        gravity: [0, -9.8, 0],
        wall floor { gap: y, restitution: 0.5 }
        body ball on ground { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

#[test]
fn modes_and_impacts_are_read_back() {
    let ball = Ball::new(BallParams {}).expect("physical");
    let solution = Rk45::new().solve(&ball, 0.0, 1.0, [1.0, 0.0]).expect("regular");
    assert!(!solution.impacts().is_empty());
    let text = serde_json::to_string(&solution).expect("writes");
    assert_eq!(
        serde_json::from_str::<Solution<f64, 2>>(&text).expect("reads"),
        solution
    );
}

mechanism! {
    pub Pendulum {
        params { m: kg, l: m, g: m/s^2 = 9.8 }
        gravity: [0, -g, 0],
        body bob on ground { mass: m, com: [0, -l, 0], joint: revolute(z), coordinate: theta }
    }
}

#[test]
fn parameters_of_a_model_are_read_by_name() {
    let params: PendulumParams = serde_json::from_str(r#"{"m":0.1,"l":2.5,"g":1.62}"#).expect("reads");
    let expected = PendulumParams {
        m: 0.1,
        l: 2.5,
        g: 1.62,
    };
    assert_eq!(params, expected);
    assert_eq!(
        serde_json::to_string(&params).expect("writes"),
        r#"{"m":0.1,"l":2.5,"g":1.62}"#
    );
    assert!(Pendulum::new(params).is_ok());
}

#[test]
fn a_parameter_error_is_written_by_field() {
    let error = ParameterError::new("m", -1.0, "a mass must be positive", &[]);
    let text = serde_json::to_string(&error).expect("writes");
    assert_eq!(
        text,
        r#"{"name":"m","value":-1.0,"rule":"a mass must be positive","given":[]}"#
    );
}

#[test]
fn what_is_not_a_solution_is_not_read_as_one() {
    let statistics = r#""statistics":{"evaluations":0,"accepted":0,"rejected":0}"#;
    let cases = [
        (
            r#""t":[],"x":[],"coefficients":[],"ends":[],"events":[]"#,
            "at least one point",
        ),
        (
            r#""t":[0.0],"x":[],"coefficients":[],"ends":[],"events":[]"#,
            "a state for each time",
        ),
        (
            r#""t":[0.0,1.0,0.5],"x":[[1.0],[1.0],[1.0]],"coefficients":[[0.0],[0.0]],"ends":[1,2],"events":[]"#,
            "ascend or descend",
        ),
    ];
    for (fields, message) in cases {
        let text = format!("{{{fields},{statistics}}}");
        let error = serde_json::from_str::<Solution<f64, 1>>(&text).expect_err(message);
        assert!(error.to_string().contains(message), "{error}");
    }
}

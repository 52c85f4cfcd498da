//! Errors say where the mistake is.

use pendulum_runtime::{Error, Event, Members, Method, Model, Options, Robot};

const TEXT: &str = "pub Pendulum {
    params { length: m = 0.5, mass: kg = 1 }
    gravity: [0, -9.81, 0],
    generate: [rhs],
    body bob on ground { mass: mass, com: [0, -length, 0], joint: revolute(z), coordinate: theta }
}";

fn says<T>(result: Result<T, impl ToString>, text: &str) {
    let message = result.err().expect("an error").to_string();
    assert!(message.contains(text), "{message}");
}

#[test]
fn errors_have_their_place_in_the_text() {
    let wrong = TEXT.replace("-length", "-lenght");
    let Err(Error::Declaration(error)) = Model::parse(&wrong) else {
        panic!("it is refused")
    };
    let problem = &error.problems[0];
    assert_eq!((problem.line, problem.column, problem.width), (5, 48, 6));
    assert!(problem.help.contains("`length`"), "{}", problem.help);
    assert!(problem.code.starts_with('M'));
    let text = error.to_string();
    assert!(
        text.contains("--> line 5, column 48") && text.contains("| ^^^^^^") || text.contains("^^^^^^\n"),
        "{text}"
    );
    says(Model::parse("pub A { body"), "bracket");
    assert!(Model::parse(&format!("mechanism! {{ {TEXT} }}")).is_ok());
    says(Model::parse(&TEXT.replace("[rhs]", "[energy]")), "a model needs `rhs`");
    says(Model::parse(""), "error[M0");
    says(Model::parse("\u{0}"), "error[M0");
}

#[test]
fn nesting_ends_in_an_error() {
    for nested in ["(".repeat(100_000), "[".repeat(100_000) + &"]".repeat(100_000)] {
        assert!(Model::parse(&format!("pub A {{ gravity: {nested} }}")).is_err());
    }
    let sum = "1+".repeat(20_000) + "1";
    assert!(Model::parse(&format!("pub A {{ gravity: [0, {sum}, 0] }}")).is_err());
}

#[test]
fn names_have_the_most_similar_one() {
    let model = Model::parse(TEXT).expect("valid");
    says(
        model.with(&[("lenght", 1.0)]),
        "there is no parameter `lenght`; did you mean `length`?",
    );
    says(
        model.with_inputs(&[("force", 1.0)]),
        "there is no input `force`: the mechanism has none",
    );
    says(model.state(&[("thetta", 1.0)]), "did you mean `theta`?");
    says(
        Method::new("Vern8"),
        "there is no method `Vern8`; did you mean `Vern7`?",
    );
    says(
        model.evaluate("mass_matrx", 0.0, &[0.0, 0.0], &[]),
        "there is no function `mass_matrx`",
    );
    let options = Options {
        events: vec![Event::value("height", 0.0)],
        ..Options::default()
    };
    let method = Method::new("Vern9").expect("known");
    says(
        model.solve_with(&method, [0.0, 1.0], &[0.1, 0.0], &options),
        "there is no output or component `height`",
    );
}

#[test]
fn lists_settings_and_numbers_are_checked() {
    let model = Model::parse(TEXT).expect("valid");
    let method = Method::new("Vern9").expect("known");
    says(model.rhs(0.0, &[0.0; 3]), "the state has 3 entries, and 2 are needed");
    says(model.solve(&method, [0.0, 1.0], &[f64::NAN, 0.0]), "finite");
    says(model.solve(&method, [0.0, f64::INFINITY], &[0.0, 0.0]), "finite");
    says(
        model.solve(&method.clone().h(0.1), [0.0, 1.0], &[0.0, 0.0]),
        "`Vern9` chooses its steps",
    );
    says(
        model.solve(&Method::new("Rk4").expect("known"), [0.0, 1.0], &[0.0, 0.0]),
        "`Rk4` takes fixed steps",
    );
    says(
        model.solve(&method.clone().rtol(-1.0), [0.0, 1.0], &[0.0, 0.0]),
        "`rtol` is -1.0",
    );
    says(
        model.jacobian(0.0, &[0.0, 0.0]),
        "needs `jacobian`: add it to `generate: [..]`",
    );
    says(
        model.solve(&Method::new("Radau5").expect("known"), [0.0, 1.0], &[0.0, 0.0]),
        "needs `jacobian`",
    );
    says(
        model.solve(&Method::new("Taylor").expect("known"), [0.0, 1.0], &[0.0, 0.0]),
        "needs `taylor`",
    );
    says(
        model.solve(&Method::new("Gauss4").expect("known").h(0.1), [0.0, 1.0], &[0.0, 0.0]),
        "needs `canonical`",
    );
    says(model.shapes(0.0, &[0.0, 0.0]), "needs `shapes`");
    says(model.with(&[("mass", -1.0)]), "the mass of `bob` must be positive");
    says(model.with(&[("mass", f64::NAN)]), "finite");
    let unsorted = Options {
        times: Some(vec![0.5, 0.1]),
        ..Options::default()
    };
    says(model.solve_with(&method, [0.0, 1.0], &[0.1, 0.0], &unsorted), "sorted");
    let members = Members {
        starts: &[0.0; 5],
        parameters: None,
        laws: &[],
        times: &[],
        cancel: None,
    };
    says(model.ensemble(&method, [0.0, 1.0], &members), "5 entries");
    let members = Members {
        starts: &[0.1; 6],
        parameters: Some(&[0.5, 1.0, 0.5, -1.0, 0.5, 1.0]),
        ..members
    };
    says(
        model.ensemble(&method, [0.0, 1.0], &members),
        "the parameters of trajectory 1: parameter `mass` is -1: the mass of `bob` must be positive",
    );
    let without = TEXT.replace(" = 0.5", "");
    says(Model::parse(&without), "give values of `length`");
    assert!(Model::parse_with(&without, &[("length", 0.5)]).is_ok());
    says(
        Model::robot(&Robot::new("nowhere.urdf")),
        "`nowhere.urdf` cannot be read",
    );
}

/// A chain of rods.
fn chain(links: usize) -> String {
    let body = |n: usize| {
        let (parent, at) = match n {
            0 => ("ground".to_owned(), "0"),
            _ => (format!("b{}", n - 1), "-0.1"),
        };
        format!(
            "body b{n} on {parent} {{ mass: 1, com: [0, -0.05, 0], joint: revolute(z) at [0, {at}, 0], \
             coordinate: q{n} }}\n"
        )
    };
    let bodies: String = (0..links).map(body).collect();
    format!("pub Chain {{ gravity: [0, -9.81, 0], generate: [rhs, jacobian], {bodies} }}")
}

#[test]
fn the_longest_state_has_64_components() {
    let model = Model::parse(&chain(32)).expect("valid");
    let x = vec![0.1; 64];
    for name in ["Rk4", "Vern9", "Rodas5P", "Radau5", "Auto"] {
        let method = Method::new(name).expect("known");
        let method = if method.is_fixed() {
            method.h(1e-4)
        } else {
            method.rtol(1e-4).atol(1e-4)
        };
        let motion = model.solve(&method, [0.0, 0.01], &x).expect(name);
        let members = Members {
            starts: &x.repeat(3),
            parameters: None,
            laws: &[],
            times: &[],
            cancel: None,
        };
        let together = model.ensemble(&method, [0.0, 0.01], &members).expect(name);
        assert_eq!(&together.ends[128..], motion.end().1, "{name}");
    }
    says(
        Model::parse(&chain(33)),
        "the state has 66 entries, and at most 64 are supported",
    );
}

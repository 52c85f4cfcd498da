//! Files and words beside the text of a declaration.

use pendulum_runtime::{Declaration, Error, Model};

const BALL: &str = "pub Ball {
    gravity: [0, -9.81, 0],
    body bob on ground { mass: 1, com: [0, -1, 0], inertia: [0.1, 0.1, 0.1], joint: ball, orientation: o }
    generate: [rhs],
}";

fn names(model: &Model) -> Vec<&str> {
    model
        .functions()
        .iter()
        .map(|function| function.name.as_str())
        .collect()
}

#[test]
fn words_are_added_where_the_mechanism_can_have_them() {
    let declaration = Declaration::new(BALL).also(["energy", "canonical", "rhs"]);
    let model = Model::declared(&declaration, &[]).expect("valid");
    // a ball joint has no canonical equations
    assert_eq!(names(&model), ["rhs", "kinetic", "potential"]);
    assert_eq!(names(&Model::parse(BALL).expect("valid")), ["rhs"]);
    let refused = BALL.replace("[rhs]", "[rhs, canonical]");
    assert!(matches!(Model::parse(&refused), Err(Error::Declaration(_))));
    let misspelt = Declaration::new(BALL).also(["enrgy"]);
    let error = Model::declared(&misspelt, &[]).expect_err("no word").to_string();
    assert!(error.contains("did you mean `energy`?"), "{error}");
}

#[test]
fn a_model_of_the_motion_alone_has_the_same_motion() {
    let text = BALL.replace("[rhs]", "[rhs, jacobian, mass_matrix]");
    let declaration = Declaration::new(&text).also(["energy"]);
    let [whole, alone] = [declaration.clone(), declaration.only_motion()]
        .map(|declaration| Model::declared(&declaration, &[]).expect("valid"));
    assert_eq!(names(&alone), ["rhs", "kinetic", "potential"]);
    assert_eq!(names(&whole).len(), 5);
    assert_eq!(alone.latex(), "");
    let x = whole.state(&[]).expect("a state");
    assert_eq!(whole.rhs(0.0, &x).expect("valid"), alone.rhs(0.0, &x).expect("valid"));
    // errors are those of the whole list
    let wrong = Declaration::new(&BALL.replace("[rhs]", "[rhs, nothing]")).only_motion();
    assert!(matches!(Model::declared(&wrong, &[]), Err(Error::Declaration(_))));
}

#[test]
fn robots_come_from_texts_that_are_given() {
    let text = "pub Arm { robot: urdf(\"arm.urdf\"), gravity: [0, 0, -9.81] }";
    assert!(matches!(Model::parse(text), Err(Error::Declaration(_))));
    let file = include_str!("../../../testbed/data/urdf/declared/ur5.urdf");
    let declaration = Declaration::new(text).file("arm.urdf", file);
    let model = Model::declared(&declaration, &[]).expect("valid");
    assert_eq!(model.components().len(), 12);
    assert!(declaration.rust().expect("valid").contains("fn rhs"));
}

#[test]
fn code_is_that_of_the_macro() {
    let declaration = Declaration::new(BALL).also(["energy"]);
    let tokens = BALL.parse().expect("tokens");
    // words that are added are for the model, not for the reader
    assert_eq!(
        declaration.rust().expect("valid"),
        pendulum_codegen::expand(tokens).to_string()
    );
    let c = declaration.c().expect("valid");
    assert!(c.header.contains("ball_rhs") && !c.header.contains("#include \"ball.h\""));
    assert!(c.source.contains("#include \"ball.h\""));
    let error = Declaration::new("pub Ball { gravty: [0, 0, 0] }")
        .rust()
        .expect_err("a wrong word");
    assert!(error.to_string().contains("did you mean `gravity`?"), "{error}");
}

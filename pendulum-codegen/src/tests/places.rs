//! Constants for the indices of coordinates in the state.

use crate::program;

/// Errors of a scene with two coordinates.
fn errors(coordinates: [&str; 2]) -> Option<String> {
    let [first, second] = coordinates;
    let scene = format!(
        "pub Chain {{
            body a on ground {{ mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: {first} }}
            body b on a {{ mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: {second} }}
        }}"
    );
    let program = program(scene.parse().expect("tokens"));
    program.err().map(|errors| errors.to_string())
}

#[test]
fn no_two_constants_have_the_same_name() {
    for (coordinates, fact) in [
        (
            ["x1", "cost"],
            "coordinate `cost` needs the constant `COST` for its index in the state, but another constant",
        ),
        (
            ["x1", "X1"],
            "coordinate `X1` needs the constant `X1` for its index in the state, but `x1`",
        ),
        (
            ["x1", "dot_x1"],
            "coordinate `dot_x1` needs the constant `DOT_X1` for its index in the state, but `x1`",
        ),
        (
            ["dot_x1", "x1"],
            "coordinate `x1` needs the constant `DOT_X1` for its index in the state, but `dot_x1`",
        ),
    ] {
        let errors = errors(coordinates).expect("a clash");
        assert!(
            errors.contains(fact) && errors.contains("help: rename the coordinate"),
            "{errors}"
        );
    }
    let spelled = errors(["theta", "\u{3b8}"]).expect("a clash");
    assert!(spelled.contains("needs the constant `THETA`"), "{spelled}");
    assert_eq!(errors(["x1", "\u{3b8}"]), None);
}

//! Words added to the list `generate`.

use crate::pipeline::program;
use crate::{Unreadable, Wanted};

/// Bennett's linkage: a loop in space without a closed form.
const BENNETT: &str = "pub Bennett {
    gravity: [0, 0, -9.81],
    body first on ground { solids: [rod(0.5, [0, 0, 0], [0.4, 0, 0])],
        joint: revolute(z) at [0.8, 0, 0] rpy [0.8928089789005025, 0, 0], coordinate: theta near 2 }
    body second on first { solids: [rod(1, [0, 0, 0], [0.8, 0, 0])],
        joint: revolute(z) at [0.4, 0, 0] rpy [0.4, 0, 0], coordinate: phi depends near 2 }
    body third on second { solids: [rod(0.5, [0, 0, 0], [0.4, 0, 0])],
        joint: revolute(z) at [0.8, 0, 0] rpy [0.8928089789005025, 0, 0], coordinate: psi depends near -2 }
    close third at [0.4, 0, 0] rpy [0.4, 0, 0] to ground: revolute(z),
}";

/// Names of the routines of a declaration with added words, or its errors.
fn routines(declaration: &str, wanted: Wanted<'_>) -> Result<Vec<String>, String> {
    let none = |_: &str| -> Result<String, Unreadable> { unreachable!("there is no file") };
    let tokens = declaration.parse().expect("the declaration is made of tokens");
    let program = program(tokens, wanted, &none).map_err(|errors| errors.to_string())?;
    Ok(program.routines.into_iter().map(|routine| routine.name).collect())
}

#[test]
fn loops_without_a_closed_form_have_no_canonical_equations() {
    for wanted in [Wanted::Also, Wanted::Only] {
        let added = routines(BENNETT, wanted(&["energy", "canonical"])).expect("valid");
        assert_eq!(added, routines(BENNETT, wanted(&["energy"])).expect("valid"));
    }
}

#[test]
fn unknown_words_are_reported() {
    for wanted in [Wanted::Also, Wanted::Only] {
        let error = routines(BENNETT, wanted(&["mass_matrx"])).expect_err("misspelt");
        let text = BENNETT.replacen('{', "{ generate: [mass_matrx],", 1);
        let listed = routines(&text, Wanted::Also(&[])).expect_err("misspelt");
        // at the name rather than in the list
        let [own, listed] = [&error, &listed].map(|error| error.split_once(": ").expect("a place"));
        assert_eq!((own.0, own.1), ("1:5", listed.1));
        assert!(error.contains("did you mean `mass_matrix`?"), "{error}");
    }
}

//! Constants of a model.

/// Names of the constants of a model, other than those for the indices of its coordinates.
pub(crate) const FACTS: [&str; 11] = [
    "DOF",
    "COORDINATES",
    "COST",
    "LAYOUT",
    "EQUATIONS",
    "OUTPUTS",
    "EVENTS",
    "DRIVES",
    "REPAIRED",
    "EFFORT_LIMITS",
    "VELOCITY_LIMITS",
];

/// Names of the constants for the indices of a coordinate and of its rate in the state: `THETA1` and `DOT_THETA1` for
/// `theta1`, `P_X` and `DOT_P_X` for `p.x`. For an orientation they give the index of its first component.
pub(crate) fn places(coordinate: &str) -> [String; 2] {
    let name = constant(coordinate);
    [name.clone(), format!("DOT_{name}")]
}

/// Name of the constant for the index of a first-order state, or of a position: `I` for `i`.
///
/// Greek letters are spelled out, because `rustc` warns of capitals that look like the small letters.
pub(crate) fn constant(name: &str) -> String {
    let name = name.trim_start_matches("r#").replace('.', "_");
    let spelled = name
        .chars()
        .map(|letter| match GREEK.iter().find(|(greek, _)| *greek == letter) {
            Some((_, name)) => (*name).to_owned(),
            None => letter.to_string(),
        });
    spelled.collect::<String>().to_uppercase()
}

/// Small Greek letters and their names.
const GREEK: [(char, &str); 24] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('ο', "omicron"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
];

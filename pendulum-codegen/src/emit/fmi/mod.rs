//! A program as a functional mock-up unit (FMU) of FMI 3.0: its model description and its sources in C99.
//!
//! The functions of FMI are the same for every model. They read the tables and call the functions of `fmi3-model.h`,
//! which alone is written for a model.

mod description;
mod model;
mod units;
mod variables;

use std::error::Error;
use std::fmt::{Display, Formatter};

use super::c::template::{fill, lines};
use super::c::{Sources, c};
use crate::program::{Program, Role};

/// Name of the program that writes FMUs, in their model descriptions.
const TOOL: &str = concat!("pendulum-codegen ", env!("CARGO_PKG_VERSION"));

/// Sources that are the same for every model: their names, and their texts. Names with a dash cannot be those of a
/// model, nor can the names in camel case within them.
const COMMON: [(&str, &str); 6] = [
    ("fmi3-functions.c", include_str!("templates/fmi3-functions.c")),
    ("fmi3-loops.c", include_str!("templates/fmi3-loops.c")),
    ("fmi3-integrate.c", include_str!("templates/fmi3-integrate.c")),
    ("fmi3-absent.c", include_str!("templates/fmi3-absent.c")),
    ("fmi3-instance.c", include_str!("templates/fmi3-instance.c")),
    ("fmi3-instance.h", include_str!("templates/fmi3-instance.h")),
];

/// Functional mock-up unit, without binaries.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fmu {
    /// Name of the model; the archive is `<name>.fmu`.
    pub name: String,
    /// Model identifier: the name of the binary, without its extension.
    pub identifier: String,
    /// Files: their paths in the archive, and their texts. `binaries/<platform>/<identifier>` with the extension of a
    /// shared library is compiled from all files `sources/*.c`, with the libraries of C and of its `math.h`.
    pub files: Vec<(String, String)>,
}

/// Reason why a program has no FMU.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoFmu {
    /// The model switches between modes: the names of its constraints.
    SwitchesModes(Vec<String>),
    /// The model has no right-hand side.
    NoRightHandSide,
}

impl Display for NoFmu {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::SwitchesModes(names) => {
                let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
                write!(
                    f,
                    "an FMU has no dry friction, stops or walls, as at {}\nhelp: in place of `dry_friction: f` write \
                     `torque: -f*tanh(qd/w)` with a small rate `w`, and in place of a stop or a wall a stiff spring",
                    names.join(", ")
                )
            }
            Self::NoRightHandSide => f.write_str(
                "an FMU needs equations of motion\nhelp: write `generate: [rhs, jacobian]`, or leave `generate` out",
            ),
        }
    }
}

impl Error for NoFmu {}

/// Prints a program as an FMU for model exchange and co-simulation.
///
/// # Errors
///
/// [`NoFmu`] if the model has dry friction, stops or walls, or no right-hand side.
pub fn fmu(program: &Program) -> Result<Fmu, NoFmu> {
    if !program.constraints.is_empty() {
        let names = program.constraints.iter().map(|constraint| constraint.name.clone());
        return Err(NoFmu::SwitchesModes(names.collect()));
    }
    if program.with_role(Role::Rhs).is_none() {
        return Err(NoFmu::NoRightHandSide);
    }
    let Sources { name, header, source } = c(program);
    let (own, own_header) = (format!("{name}.c"), format!("{name}.h"));
    let mut sources = COMMON.map(|(name, text)| (name.to_owned(), text.to_owned())).to_vec();
    sources.extend([(own, source), (own_header, header)]);
    let compiled = sources.iter().map(|(name, _)| name).filter(|name| name.ends_with(".c"));
    let compiled = lines(compiled.map(|name| format!("<SourceFile name=\"{name}\"/>")));
    let build = fill(
        include_str!("templates/build.xml"),
        &[("name", name.clone()), ("files", compiled)],
    );
    // the token depends on everything else
    let unsigned = [
        description::description(program, &name, ""),
        model::model(program, &name, ""),
    ];
    let texts = unsigned.iter().chain(sources.iter().map(|(_, text)| text));
    let token = token(texts.map(String::as_str));
    sources.extend([
        ("fmi3-model.h".to_owned(), model::model(program, &name, &token)),
        ("buildDescription.xml".to_owned(), build),
    ]);
    let mut files = vec![(
        "modelDescription.xml".to_owned(),
        description::description(program, &name, &token),
    )];
    files.extend(
        sources
            .into_iter()
            .map(|(name, text)| (format!("sources/{name}"), text)),
    );
    Ok(Fmu {
        name: program.name.clone(),
        identifier: name,
        files,
    })
}

/// Instantiation token of texts: their FNV-1a hash of 128 bits, in the notation of a GUID.
fn token<'a>(texts: impl Iterator<Item = &'a str>) -> String {
    let start = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d_u128;
    let prime = 0x0000_0000_0100_0000_0000_0000_0000_013b_u128;
    let bytes = texts.flat_map(str::bytes);
    let hash = bytes.fold(start, |hash, byte| (hash ^ u128::from(byte)).wrapping_mul(prime));
    let digits = format!("{hash:032x}");
    let parts = [0..8, 8..12, 12..16, 16..20, 20..32].map(|part| &digits[part]);
    format!("{{{}}}", parts.join("-"))
}

#[cfg(test)]
mod tests {
    use super::token;

    #[test]
    fn tokens_are_hashes() {
        // of "foobar", by the authors of the hash
        assert_eq!(
            token(["foo", "bar"].into_iter()),
            "{343e1662-793c-64bf-6f0d-3597ba446f18}"
        );
    }
}

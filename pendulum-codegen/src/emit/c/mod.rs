//! A program as C99: a header and a source without heap, and without any library except for the functions named in the
//! header. A controller adds its laws.

mod block;
mod controller;
mod functions;
mod model;
pub(in crate::emit) mod names;
mod opencl;
mod routines;
mod single;
pub(in crate::emit) mod template;

pub use controller::{Controller, Ilqr, NoController};
use names::{identifiers, snake_case};
pub use opencl::opencl;

use crate::program::Program;

/// Scene as C.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sources {
    /// Prefix of all functions and types; the files are `<name>.h` and `<name>.c`.
    pub name: String,
    /// Header, with all documentation.
    pub header: String,
    /// Source.
    pub source: String,
}

/// Prints a program as C99.
///
/// Results equal those of the Rust code bit for bit if `sqrt` and `fabs` are the only platform functions called. The
/// last bits of other functions differ from platform to platform; those of the Rust code do not.
///
/// Functions have their names in Rust after the prefix. Outputs and events with the name of another function or type of
/// the header, such as `error`, end in an underscore, `pendulum_error_`.
pub fn c(program: &Program) -> Sources {
    sources(Scene::new(program, snake_case(&program.name)))
}

/// Like [`c`], but sums with a product call `fma`, as code in fused arithmetic does: results equal those of the Rust
/// code for `Fused<f64>` bit for bit, except for the coefficients of series and under the same condition on the
/// functions of the platform.
///
/// Without `-mfma`, or the like for another processor, the calls take much longer than a multiplication and an
/// addition. The function `<name>_rounds_once` tells if the platform rounds as IEEE 754 demands.
pub fn c_fused(program: &Program) -> Sources {
    let scene = Scene::new(program, snake_case(&program.name));
    sources(Scene { fused: true, ..scene })
}

fn sources(scene: Scene<'_>) -> Sources {
    let (source, heads) = scene.source();
    let (header, name) = (scene.header(&heads), scene.name);
    Sources { name, header, source }
}

/// Program, and the names of its parts in C.
struct Scene<'p> {
    program: &'p Program,
    /// True if sums with a product are fused.
    fused: bool,
    /// Controller whose laws are added.
    controller: Option<&'p Controller>,
    name: String,
    parameters: Vec<String>,
    inputs: Vec<String>,
    positions: Vec<String>,
    rates: Vec<String>,
    states: Vec<String>,
}

impl<'p> Scene<'p> {
    fn new(program: &'p Program, name: String) -> Self {
        let [positions, rates] = program.layout.components();
        Self {
            program,
            fused: false,
            controller: None,
            name,
            parameters: identifiers(program.parameters.iter().map(|parameter| &parameter.name)),
            inputs: identifiers(program.inputs.iter().map(|input| &input.name)),
            positions: identifiers(&positions),
            rates: identifiers(&rates),
            states: identifiers(program.layout.states.iter().map(|state| &state.name)),
        }
    }

    /// True if states, inputs and results are in single precision.
    fn is_single(&self) -> bool {
        self.controller.is_some_and(Controller::is_single)
    }

    /// Code in the precision of the states, from that in double precision.
    fn real(&self, code: String) -> String {
        if self.is_single() { single::single(&code) } else { code }
    }

    /// Fills a template with the names and lengths of the scene. C has no arrays without elements.
    fn fill(&self, template: &str, values: &[(&str, String)]) -> String {
        let (program, series) = (self.program, self.program.series.as_ref());
        let length = |length: usize| length.max(1).to_string();
        let own = [
            ("name", self.name.clone()),
            ("NAME", self.name.to_uppercase()),
            ("scene", program.name.clone()),
            ("length", length(program.layout.len())),
            ("constants", length(program.constants_text.len())),
            ("products", length(series.map_or(0, |series| series.products))),
            ("kept", length(series.map_or(0, |series| series.kept))),
            ("forces", self.forces()),
            (
                "constant",
                if self.forces().is_empty() {
                    ""
                } else {
                    ", under constant forces"
                }
                .to_owned(),
            ),
        ];
        template::fill(template, &[&own, values].concat())
    }
}

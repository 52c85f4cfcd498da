//! Models that are declared, expanded, compiled and loaded while a measurement runs.

use std::error::Error;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use pendulum_codegen::expr::Graph;
use pendulum_codegen::{Function, Program, expand, program};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::rust::Rust;

/// A declaration, with numbers for those of its parameters that have none of their own.
#[derive(Clone)]
pub(crate) struct Declaration {
    pub name: String,
    pub text: String,
    pub parameters: Vec<(&'static str, f64)>,
}

impl Declaration {
    /// That of a model in a Rust source, but with a list of its own of what to generate.
    pub(crate) fn read(source: &str, name: &str, generate: &str) -> Result<Self, Box<dyn Error>> {
        let tokens: TokenStream = source.parse()?;
        let text = tokens
            .into_iter()
            .filter_map(|token| match token {
                TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group.stream().to_string()),
                _ => None,
            })
            .find(|text| text.contains(&format!("pub {name} {{")))
            .ok_or_else(|| format!("no declaration of {name}"))?;
        let text = match text.find("generate") {
            Some(at) => {
                let end = at + text[at..].find(']').ok_or("a list without end")?;
                format!("{}generate: [{generate}{}", &text[..at], &text[end..])
            }
            None => text.replacen('{', &format!("{{ generate: [{generate}],"), 1),
        };
        Ok(Self {
            name: name.to_owned(),
            text,
            parameters: Vec::new(),
        })
    }

    fn tokens(&self) -> Result<TokenStream, Box<dyn Error>> {
        Ok(self.text.parse()?)
    }

    pub(crate) fn program<'g>(&self, graph: &'g Graph) -> Result<Program<'g>, Box<dyn Error>> {
        Ok(program(graph, self.tokens()?).map_err(|errors| format!("{}: {errors}", self.name))?)
    }

    /// The Rust that the macro makes of it, and the least time that this took of several.
    pub(crate) fn expand(&self, budget: Duration) -> Result<(String, Duration), Box<dyn Error>> {
        let (mut text, mut least) = (String::new(), Duration::MAX);
        let all = Instant::now();
        for round in 0..MOST {
            let tokens = self.tokens()?;
            let start = Instant::now();
            let items = expand(tokens);
            least = least.min(start.elapsed());
            if round == 0 {
                // The compiler takes long over long lines.
                text = items.to_string().replace("; ", ";\n");
            } else if all.elapsed() > budget {
                break;
            }
        }
        Ok((text, least))
    }

    /// The source of a library with the functions, each of which takes states and leaves the last result.
    pub(crate) fn source(&self, items: &str, functions: &[Function]) -> String {
        let Self { name, parameters, .. } = self;
        let fields: String = parameters
            .iter()
            .map(|(name, value)| format!("{name}: {value:?}, "))
            .collect();
        // Those of a model that has a number for each.
        let rest = if parameters.is_empty() {
            "..Default::default()"
        } else {
            ""
        };
        let mut source = format!(
            "{items}
use pendulum_core::prelude::*;
static MODEL: std::sync::LazyLock<{name}> = std::sync::LazyLock::new(|| {{
    {name}::new(std::hint::black_box({name}Params {{ {fields}{rest} }})).expect(\"good parameters\")
}});
const N: usize = 2 * {name}::<f64>::DOF;
"
        );
        for function in functions.iter().map(|function| function.name()) {
            source += &format!(
                "
#[unsafe(no_mangle)]
pub unsafe extern \"C\" fn {function}(states: *const [f64; N], out: *mut f64, count: std::ffi::c_long) {{
    let states = unsafe {{ std::slice::from_raw_parts(states, count as usize) }};
    let model = &*MODEL;
    for x in states {{
        let result = std::hint::black_box(model.{function}(0.0, &SVector::from(*x)));
        unsafe {{ out.copy_from_nonoverlapping(result.as_ptr(), result.len()) }};
    }}
}}
"
            );
        }
        source
    }

    /// The least time of the compiler, of several, and the library of the last.
    pub(crate) fn compile(
        &self,
        rust: &Rust,
        library: &str,
        source: &str,
        budget: Duration,
    ) -> Result<(PathBuf, Duration), Box<dyn Error>> {
        let all = Instant::now();
        let (mut path, mut least) = rust.library(library, source)?;
        while 2 * all.elapsed() < budget {
            let (again, time) = rust.library(library, source)?;
            (path, least) = (again, least.min(time));
        }
        Ok((path, least))
    }
}

/// Expansions after which the least time does not get less.
const MOST: usize = 20;

//! Models that are expanded, compiled and loaded at run time.

use std::error::Error;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use pendulum_codegen::program::Program;
use pendulum_codegen::{expand, program};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::rust::Rust;

/// Declaration, with values for those parameters that have no default.
#[derive(Clone)]
pub(crate) struct Declaration {
    pub name: String,
    pub text: String,
    pub parameters: Vec<(&'static str, f64)>,
}

impl Declaration {
    /// Reads the declaration of a model from a Rust source, with another `generate` list.
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

    pub(crate) fn program(&self) -> Result<Program, Box<dyn Error>> {
        Ok(program(self.tokens()?).map_err(|errors| format!("{}: {errors}", self.name))?)
    }

    /// Expands the declaration to Rust, and returns the text with the minimum time of several expansions.
    pub(crate) fn expand(&self, budget: Duration) -> Result<(String, Duration), Box<dyn Error>> {
        let (mut text, mut least) = (String::new(), Duration::MAX);
        let all = Instant::now();
        for round in 0..MOST {
            let tokens = self.tokens()?;
            let start = Instant::now();
            let items = expand(tokens);
            least = least.min(start.elapsed());
            if round == 0 {
                // The compiler is slow on long lines.
                text = items.to_string().replace("; ", ";\n");
            } else if all.elapsed() > budget {
                break;
            }
        }
        Ok((text, least))
    }

    /// Source of a library with the functions, each of which evaluates given states and stores the last result.
    pub(crate) fn source(&self, items: &str, functions: &[&str]) -> String {
        let Self { name, parameters, .. } = self;
        let fields: String = parameters
            .iter()
            .map(|(name, value)| format!("{name}: {value:?}, "))
            .collect();
        // Defaults are used only if all parameters have one.
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
        for function in functions {
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

    /// Compiles the source repeatedly; returns the minimum time and the last library.
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

/// Maximum number of expansions, beyond which the minimum time does not improve.
const MOST: usize = 20;

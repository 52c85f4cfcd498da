//! The problems as C and as tapes, for peers in other languages.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use pendulum_codegen::{c, program_in, tape};
use twelve::Problem;

use crate::compile::{self, Job};
use crate::generated::Declaration;
use crate::library;

/// Declaration of a problem.
struct Source {
    problem: &'static str,
    text: &'static str,
    declaration: &'static str,
    /// Parameters other than the defaults.
    parameters: &'static [(&'static str, f64)],
}

const PROBLEMS: &str = include_str!("../../../testbed/src/problems.rs");
const LINKAGES: &str = include_str!("../../../testbed/src/linkages.rs");
const SCENES: &str = include_str!("../../../testbed/src/scenes.rs");

const SOURCES: [Source; 12] = [
    Source {
        parameters: &[("gamma1", 0.1), ("gamma2", 0.1)],
        ..source("regular", SCENES, "DoublePendulum")
    },
    Source {
        parameters: &[("gamma1", 0.0), ("gamma2", 0.0)],
        ..source("chaotic", SCENES, "DoublePendulum")
    },
    Source {
        parameters: &[("gamma1", 1e4), ("gamma2", 1e4)],
        ..source("stiff", SCENES, "DoublePendulum")
    },
    source("arenstorf", PROBLEMS, "Arenstorf"),
    source("pleiades", PROBLEMS, "Pleiades"),
    source("henon_heiles", PROBLEMS, "HenonHeiles"),
    source("van_der_pol", PROBLEMS, "VanDerPol"),
    source("hires", PROBLEMS, "Hires"),
    source("robertson", PROBLEMS, "Robertson"),
    source("andrews", LINKAGES, "Andrews"),
    source("heavy_top", PROBLEMS, "HeavyTop"),
    source("ur5", PROBLEMS, "FallingUr5"),
];

const fn source(problem: &'static str, text: &'static str, declaration: &'static str) -> Source {
    Source {
        problem,
        text,
        declaration,
        parameters: &[],
    }
}

/// Problem for peers in other languages.
pub(crate) struct Emitted {
    /// Folder of `model.h`, for compilers of C.
    pub folder: PathBuf,
    pub tape: PathBuf,
    /// Library with the right-hand side and the Jacobian.
    pub library: PathBuf,
    pub parameters: &'static [(&'static str, f64)],
}

/// Flags of the compilers; the last one is for the linker.
pub(crate) const FLAGS: [&str; 5] = [
    "-O3",
    "-march=native",
    "-ffp-contract=fast",
    "-DNDEBUG",
    "-Wl,--no-as-needed",
];

impl Emitted {
    /// Writes the problem below `build`, and compares it with the one in Rust.
    pub(crate) fn new(root: &Path, build: &Path, problem: &Problem) -> Result<Self, Box<dyn Error>> {
        let source = SOURCES.iter().find(|source| source.problem == problem.name);
        let source = source.ok_or_else(|| format!("no source of {}", problem.name))?;
        let declaration = Declaration::read(source.text, source.declaration, "rhs, jacobian")?;
        let program = program_in(&root.join("../testbed"), declaration.text.parse()?)
            .map_err(|errors| format!("{}: {errors}", problem.name))?;
        let folder = build.join("twelve").join(problem.name);
        fs::create_dir_all(&folder)?;
        let code = c(&program);
        fs::write(folder.join(format!("{}.h", code.name)), &code.header)?;
        fs::write(
            folder.join("model.h"),
            header(source, problem, &code.name, &code.source),
        )?;
        let tape_file = folder.join("tape.txt");
        fs::write(&tape_file, tape(&program))?;
        let job = job(&root.join("twelve/peers/model.c"), &folder, "gcc", &[])?;
        let library = compile::compile(&[job])?.pop().ok_or("nothing compiled")?;
        let emitted = Self {
            folder,
            tape: tape_file,
            library,
            parameters: source.parameters,
        };
        emitted.agrees(problem)?;
        Ok(emitted)
    }

    /// Compares the derivatives at the start and at the end with those of Rust.
    fn agrees(&self, problem: &Problem) -> Result<(), Box<dyn Error>> {
        let length = problem.model.length;
        let functions = [
            ("rhs", length, &problem.model.rhs),
            ("jacobian", length * length, &problem.model.jacobian),
        ];
        for (name, results, ours) in functions {
            let theirs = library::load(&self.library, name, length, results)?;
            for x in [&problem.x0, &problem.end] {
                let mut expected = vec![0.0; results];
                ours(x, &mut expected);
                let found = (theirs.value)(x);
                let size = expected.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
                let differs = |(a, b): (&f64, &f64)| (a - b).abs() > AGREEMENT * size || !(a - b).is_finite();
                if expected.iter().zip(&found).any(differs) {
                    return Err(format!("{}: {name} of the emitted C differs", problem.name).into());
                }
            }
        }
        Ok(())
    }
}

/// Largest difference of derivatives, relative to the largest one.
const AGREEMENT: f64 = 1e-11;

/// The emitted source, less its settings for equal bits on all machines, and the functions that peers call.
fn header(source: &Source, problem: &Problem, name: &str, code: &str) -> String {
    let is_strict = |line: &&str| line.starts_with("#pragma") && line.to_lowercase().contains("fp");
    let code: Vec<&str> = code.lines().filter(|line| !is_strict(line)).collect();
    let defaults = if code.iter().any(|line| line.contains("_defaults = {")) {
        format!(" = {name}_defaults")
    } else {
        " = {0}".to_owned()
    };
    let set: String = source
        .parameters
        .iter()
        .map(|(parameter, value)| format!("    params.{parameter} = {value:?};\n"))
        .collect();
    format!(
        "#define LENGTH {}
{}
static {name}_model model;
static void start_model(void) {{
    {name}_params params{defaults};
{set}    {name}_new(&model, &params);
}}
static inline void model_rhs(const double *x, double *slope) {{ {name}_rhs(&model, 0.0, x, slope); }}
static inline void model_jacobian(const double *x, double *columns) {{
    double slope[LENGTH];
    {name}_rhs_and_jacobian(&model, 0.0, x, slope, columns);
}}
",
        problem.model.length,
        code.join("\n"),
    )
}

/// Job that compiles a source of `twelve/peers` for the problem in `folder`.
pub(crate) fn job(source: &Path, folder: &Path, compiler: &str, libraries: &[&str]) -> Result<Job, Box<dyn Error>> {
    let copy = folder.join(source.file_name().unwrap_or_default());
    let peers = source.parent().unwrap_or(Path::new("."));
    fs::write(&copy, with_headers(&fs::read_to_string(source)?, &[folder, peers]))?;
    Ok(Job {
        source: copy,
        compiler: compiler.to_owned(),
        flags: FLAGS.iter().chain(libraries).map(|&flag| flag.to_owned()).collect(),
        define: None,
        before: None,
    })
}

/// Source with the headers in these folders in place of their includes, so that a change of a header changes the text.
fn with_headers(source: &str, folders: &[&Path]) -> String {
    let line = |line: &str| {
        let name = line.strip_prefix("#include \"").and_then(|rest| rest.strip_suffix('"'));
        let found = name.and_then(|name| {
            folders
                .iter()
                .find_map(|folder| fs::read_to_string(folder.join(name)).ok())
        });
        found.map_or_else(|| format!("{line}\n"), |header| with_headers(&header, folders))
    };
    source.lines().map(line).collect()
}

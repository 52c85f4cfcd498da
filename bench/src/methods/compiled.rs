//! Methods of libraries in C and C++.

use std::error::Error;
use std::fs;
use std::path::Path;

use super::entrant::{End, Entrant, Scenes};
use crate::compile::{self, Job};
use crate::library;
use crate::machine;
use crate::rust::{Processors, Rust};

/// Source file in `bench/methods`, with the libraries that it needs.
struct Source {
    by: &'static str,
    file: &'static str,
    compiler: &'static str,
    libraries: &'static [&'static str],
    package: &'static str,
    /// Functions with the names of their methods.
    methods: &'static [(&'static str, &'static str, Scenes)],
}

const SOURCES: [Source; 3] = [
    Source {
        by: "GSL",
        file: "gsl.c",
        compiler: "gcc",
        libraries: &["-lgsl", "-lgslcblas"],
        package: "libgsl-dev",
        methods: &[
            ("rkck", "rkck", Scenes::Smooth),
            ("rk8pd", "rk8pd", Scenes::Smooth),
            ("msadams", "msadams", Scenes::Smooth),
            ("bsimp", "bsimp", Scenes::Stiff),
            ("msbdf", "msbdf", Scenes::Stiff),
        ],
    },
    Source {
        by: "Boost.odeint",
        file: "odeint.cpp",
        compiler: "g++",
        libraries: &[],
        package: "libboost-dev",
        methods: &[
            ("dopri5", "dopri5", Scenes::All),
            ("fehlberg78", "fehlberg78", Scenes::Smooth),
            ("bulirsch_stoer", "Bulirsch-Stoer", Scenes::Smooth),
            ("rosenbrock4", "Rosenbrock4", Scenes::Stiff),
        ],
    },
    Source {
        by: "CVODE",
        file: "cvode.c",
        compiler: "gcc",
        libraries: &["-lsundials_cvode", "-lsundials_nvecserial"],
        package: "libsundials-dev",
        methods: &[("adams", "Adams", Scenes::Smooth), ("bdf", "BDF", Scenes::Stiff)],
    },
];

const FLAGS: [&str; 4] = ["-O3", "-march=native", "-DNDEBUG", "-Wl,--no-as-needed"];

/// Lengths of `Task` and `End` of `double_pendulum.h`, in numbers.
const LENGTHS: [usize; 2] = [8, 6];

/// All installed libraries; the model is compiled into a library that they all call.
pub(crate) fn entrants(
    root: &Path,
    build: &Path,
    header: &mut Vec<String>,
    notes: &mut Vec<String>,
) -> Result<Vec<Entrant>, Box<dyn Error>> {
    let model = include_str!("pendulum.rs").to_owned() + include_str!("../../methods/model.rs");
    // Inner doc comments are allowed only at the start of a file.
    let model = model.replace("//!", "//");
    let (model, _) = Rust::new(root, build, Processors::This)?.library("methods_model", &model)?;
    let folder = build.join("methods");
    fs::create_dir_all(&folder)?;
    fs::copy(root.join("methods/double_pendulum.h"), folder.join("double_pendulum.h"))?;
    let mut entrants = Vec::new();
    for source in SOURCES {
        match load(&source, root, &folder, &model) {
            Ok(found) => {
                let version = machine::says("dpkg-query", &["-W", "-f", "${Version}", source.package]);
                header.push(format!("{}: {} {version}", source.by, source.package));
                entrants.extend(found);
            }
            Err(why) => notes.push(format!(
                "{}: {why}; `sudo apt-get install gcc g++ {}`",
                source.by, source.package
            )),
        }
    }
    header.push(format!(
        "C and C++: {}, `{}`",
        machine::says("gcc", &["--version"]),
        FLAGS[..3].join(" ")
    ));
    Ok(entrants)
}

fn load(source: &Source, root: &Path, folder: &Path, model: &Path) -> Result<Vec<Entrant>, String> {
    let path = folder.join(source.file);
    fs::copy(root.join("methods").join(source.file), &path).map_err(|error| error.to_string())?;
    let flags = FLAGS.iter().chain(source.libraries).map(|&flag| flag.to_owned());
    let job = Job {
        source: path,
        compiler: source.compiler.to_owned(),
        flags: flags.chain([model.display().to_string()]).collect(),
        define: None,
        before: None,
    };
    let libraries = compile::compile(&[job]).map_err(|error| {
        let error = error.to_string();
        let line = error.lines().find(|line| line.contains("error:"));
        line.unwrap_or(&error).to_owned()
    })?;
    let mut entrants = Vec::new();
    for &(symbol, method, scenes) in source.methods {
        for library in &libraries {
            let program = library::load(library, symbol, LENGTHS[0], LENGTHS[1]).map_err(|error| error.to_string())?;
            entrants.push(Entrant {
                by: source.by,
                method,
                scenes,
                integrate: Box::new(move |scene, tolerance, times| {
                    let task = [&[tolerance, scene.gamma, scene.t1, scene.h0][..], &scene.x0].concat();
                    let [t, x @ .., evaluations] = <[f64; 6]>::try_from((program.value)(&task.repeat(times)))
                        .map_err(|_| "other numbers than asked for")?;
                    Ok(End {
                        t,
                        x,
                        evaluations: Some(evaluations as usize),
                    })
                }),
            });
        }
    }
    Ok(entrants)
}

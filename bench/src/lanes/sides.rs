//! Implementations that integrate many trajectories.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use pendulum_core::real::lanes::Isa;

use super::COUNT;
use crate::compile::{self, Job};
use crate::library::{self, Program};
use crate::machine;
use crate::rust::{Processors, Rust};

const FLAGS: [&str; 5] = ["-O3", "-march=native", "-std=c++17", "-Wl,--no-as-needed", "-lsleef"];

/// An implementation.
pub(crate) struct Side {
    pub name: String,
    pub number: &'static str,
    /// Number of interleaved groups of lanes, if it is varied.
    pub together: Option<usize>,
    pub ours: bool,
    pub program: Program,
}

impl Side {
    pub(crate) fn title(&self) -> String {
        match self.together {
            None => self.name.clone(),
            Some(1) => format!("{}, 1 group", self.name),
            Some(groups) => format!("{}, {groups} groups", self.name),
        }
    }
}

/// Index of the side without lanes.
pub(crate) fn alone(sides: &[Side], number: &str) -> Option<usize> {
    sides
        .iter()
        .position(|side| side.number == number && side.name == ALONE)
}

const ALONE: &str = "one at a time";

/// Our sides for each instruction set of this machine, and their library. It is compiled for generic machines: wider
/// registers must come from run-time dispatch alone.
pub(crate) fn ours(root: &Path, build: &Path) -> Result<(Vec<Side>, PathBuf), Box<dyn Error>> {
    let source = fs::read_to_string(root.join("lanes/ours.rs"))?;
    let (library, _) = Rust::new(root, build, Processors::All)?.library("lanes", &source)?;
    let available: Vec<String> = Isa::available().map(|isa| format!("{isa:?}")).collect();
    let mut sides = Vec::new();
    for number in ["f64", "f32"] {
        let ways = [
            (ALONE, "alone", ""),
            ("portable", "portable", "Portable"),
            ("AVX2", "avx2", "Avx2"),
            ("AVX-512", "avx512", "Avx512"),
        ];
        for (name, symbol, isa) in ways {
            if isa.is_empty() || available.iter().any(|known| known == isa) {
                sides.push(Side {
                    name: name.to_owned(),
                    number,
                    together: None,
                    ours: true,
                    program: library::load(&library, &format!("{symbol}_{number}"), 4, 4 * COUNT)?,
                });
            }
        }
    }
    Ok((sides, library))
}

/// C++ with intrinsics and SLEEF, and the version of its compiler; an error with the reason if it is left out. SLEEF
/// has sines and cosines of two accuracies (ours are below 1 ulp).
pub(crate) fn sleef(root: &Path, build: &Path) -> Result<(Vec<Side>, String), String> {
    if !has_avx512() {
        return Err("C++ with SLEEF: this processor has no AVX-512".to_owned());
    }
    let source = build.join("sleef.cpp");
    fs::copy(root.join("lanes/sleef.cpp"), &source).map_err(|error| error.to_string())?;
    let job = Job {
        source,
        compiler: "g++".to_owned(),
        flags: FLAGS.map(str::to_owned).into(),
        define: None,
        before: None,
    };
    let missing = |error: Box<dyn Error>| {
        let error = error.to_string();
        let line = error.lines().find(|line| line.contains("error:")).unwrap_or(&error);
        format!("C++ with SLEEF: {line}; `sudo apt-get install g++ libsleef-dev`")
    };
    let libraries = compile::compile(&[job]).map_err(missing)?;
    let mut sides = Vec::new();
    for (ulp, name) in [("10", "C++, SLEEF to 1 ulp"), ("35", "C++, SLEEF to 3.5 ulp")] {
        for groups in [1, 2, 4] {
            for library in &libraries {
                let symbol = format!("sleef_u{ulp}_{groups}");
                let program = library::load(library, &symbol, 4, 4 * COUNT).map_err(|error| error.to_string())?;
                sides.push(Side {
                    name: name.to_owned(),
                    number: "f64",
                    together: Some(groups),
                    ours: false,
                    program,
                });
            }
        }
    }
    let compiler = format!("C++: {}, `{}`", machine::says("g++", &["--version"]), FLAGS.join(" "));
    Ok((sides, compiler))
}

fn has_avx512() -> bool {
    #[cfg(target_arch = "x86_64")]
    return is_x86_feature_detected!("avx512f");
    #[cfg(not(target_arch = "x86_64"))]
    return false;
}

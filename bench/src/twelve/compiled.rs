//! Libraries in C and C++.

use std::error::Error;
use std::path::Path;

use twelve::{End, OUTPUTS, Problem, Request};

use super::emitted::{Emitted, FLAGS, job};
use super::entrant::Entrant;
use crate::compile;
use crate::library;
use crate::machine;

/// Source file in `twelve/peers`, with the libraries that it needs.
struct Source {
    by: &'static str,
    file: &'static str,
    compiler: &'static str,
    libraries: &'static [&'static str],
    package: &'static str,
    /// Functions with the names of their methods.
    smooth: &'static [(&'static str, &'static str)],
    stiff: &'static [(&'static str, &'static str)],
}

const SOURCES: [Source; 4] = [
    Source {
        by: "GSL",
        file: "gsl.c",
        compiler: "gcc",
        libraries: &["-lgsl", "-lgslcblas"],
        package: "libgsl-dev",
        smooth: &[("rkck", "rkck"), ("rk8pd", "rk8pd"), ("msadams", "msadams")],
        stiff: &[("bsimp", "bsimp"), ("msbdf", "msbdf")],
    },
    Source {
        by: "Boost.odeint",
        file: "odeint.cpp",
        compiler: "g++",
        libraries: &[],
        package: "libboost-dev",
        smooth: &[
            ("dopri5", "dopri5"),
            ("fehlberg78", "fehlberg78"),
            ("bulirsch_stoer", "Bulirsch-Stoer"),
        ],
        stiff: &[("rosenbrock4", "Rosenbrock4")],
    },
    Source {
        by: "CVODE",
        file: "cvode.c",
        compiler: "gcc",
        libraries: &["-lsundials_cvode", "-lsundials_nvecserial"],
        package: "libsundials-dev",
        smooth: &[("adams", "Adams")],
        stiff: &[("bdf", "BDF")],
    },
    Source {
        by: "ARKODE",
        file: "arkode.c",
        compiler: "gcc",
        libraries: &["-lsundials_arkode", "-lsundials_nvecserial"],
        package: "libsundials-dev",
        smooth: &[("verner56", "Verner 5(6)"), ("fehlberg78", "Fehlberg 7(8)")],
        stiff: &[("dirk5", "DIRK of order 5")],
    },
];

/// Adds the methods of all installed libraries to the entrants of each problem.
pub(crate) fn enter(
    root: &Path,
    problems: &[Problem],
    emitted: &[Emitted],
    entrants: &mut [Vec<Entrant>],
    [header, notes]: [&mut Vec<String>; 2],
) -> Result<(), Box<dyn Error>> {
    for source in &SOURCES {
        let file = root.join("twelve/peers").join(source.file);
        let jobs = emitted
            .iter()
            .map(|emitted| job(&file, &emitted.folder, source.compiler, source.libraries));
        let libraries = match compile::compile(&jobs.collect::<Result<Vec<_>, _>>()?) {
            Ok(libraries) => libraries,
            Err(why) => {
                let why = why.to_string();
                let line = why.lines().find(|line| line.contains("error:")).unwrap_or(&why);
                notes.push(format!(
                    "{}: {line}; `sudo apt-get install gcc g++ {}`",
                    source.by, source.package
                ));
                continue;
            }
        };
        let version = machine::says("dpkg-query", &["-W", "-f", "${Version}", source.package]);
        header.push(format!("{}: {} {version}", source.by, source.package));
        for ((problem, library), entrants) in problems.iter().zip(&libraries).zip(entrants.iter_mut()) {
            let methods = if problem.is_stiff { source.stiff } else { source.smooth };
            for &(symbol, method) in methods {
                match load(source.by, method, library, symbol, problem) {
                    Ok(entrant) => entrants.push(entrant),
                    Err(why) => notes.push(format!("{} {method}, {}: {why}", source.by, problem.name)),
                }
            }
        }
    }
    header.push(format!(
        "C and C++: {}, `{}`",
        machine::says("gcc", &["--version"]),
        FLAGS[..4].join(" ")
    ));
    Ok(())
}

/// First step, which GSL and odeint require.
fn first_step(problem: &Problem) -> f64 {
    if problem.is_stiff { 1e-6 } else { 1e-3 * problem.t1 }
}

fn load(
    by: &'static str,
    method: &'static str,
    library: &Path,
    symbol: &str,
    problem: &Problem,
) -> Result<Entrant, Box<dyn Error>> {
    let (length, t1, h0) = (problem.model.length, problem.t1, first_step(problem));
    let (x0, absolute, flops) = (problem.x0.clone(), problem.absolute, problem.flops);
    // a task, and an end without and with output times
    let load = |outputs| library::load(library, symbol, 5 + length, 4 + length + outputs * length);
    let (plain, dense) = (load(0)?, load(OUTPUTS)?);
    Ok(Entrant::timed(by, method, move |request| {
        let Request {
            tolerance,
            times,
            outputs,
        } = request;
        let task = [&[tolerance, absolute * tolerance, t1, h0, outputs as f64][..], &x0].concat();
        let program = if outputs == OUTPUTS { &dense } else { &plain };
        let end = (program.value)(&task.repeat(times));
        let (end, along) = end.split_at(4 + length);
        Ok(End {
            t: end[0],
            x: end[1..=length].to_vec(),
            evaluations: Some(end[1 + length] as usize),
            operations: Some(flops.of(end[1 + length] as usize, end[2 + length] as usize)),
            along: along
                .chunks(length)
                .take(end[3 + length] as usize)
                .map(<[f64]>::to_vec)
                .collect(),
        })
    }))
}

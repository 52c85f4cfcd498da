//! The functions of the peers as candidates, one for each compiler call.

use std::error::Error;
use std::path::Path;

use ours::cheap;

use super::candidate::{Candidate, Function, Order};
use super::generate::{Generated, Source};
use crate::compile::{self, Job};
use crate::library::{self, Program};
use crate::machine;

/// Compiler flags for the C of the peers; the fastest ones depend on the code. The last set has no fused multiply-add,
/// like the generated code, to show its effect. Clang computes sine and cosine together only without `errno`, and fuses
/// the peers' operations, which are statements of their own, only if asked to; gcc does both by itself.
const FLAGS: [&[&str]; 3] = [
    &["-O2"],
    &["-O3", "-march=native", "-fno-math-errno", "-ffp-contract=fast"],
    &["-O3", "-march=native", "-fno-math-errno", "-ffp-contract=off"],
];
const CPP_FLAGS: [&str; 4] = ["-O3", "-march=native", "-DNDEBUG", "-std=c++17"];

/// Candidates for all functions of the peers and all compiler calls; adds the available compilers to the header.
pub(crate) fn compiled(
    generated: &mut Generated,
    folder: &Path,
    header: &mut Vec<String>,
) -> Result<Vec<Candidate>, Box<dyn Error>> {
    let (compilers, missing): (Vec<&str>, Vec<&str>) = ["gcc", "clang"].into_iter().partition(|name| runs(name));
    for compiler in &compilers {
        let flags: Vec<String> = FLAGS.iter().map(|flags| format!("`{}`", flags.join(" "))).collect();
        header.push(format!(
            "C: {}, the best of {}",
            machine::says(compiler, &["--version"]),
            flags.join(", ")
        ));
    }
    for compiler in missing {
        generated.notes.push(format!(
            "C of {compiler}: there is no {compiler}; `sudo apt-get install {compiler}`"
        ));
    }
    let has_cpp = runs("g++");
    if has_cpp {
        header.push(format!(
            "C++: {}, `{}`",
            machine::says("g++", &["--version"]),
            CPP_FLAGS.join(" ")
        ));
    } else if generated.candidates.iter().any(|source| source.file.ends_with("cpp")) {
        generated
            .notes
            .push("Pinocchio: there is no C++ compiler; `sudo apt-get install g++`".to_owned());
    }
    let mut variants: Vec<(Source, Order, Job)> = Vec::new();
    for source in &generated.candidates {
        let mut add = |compiler: &str, flags: Vec<String>| {
            for order in Order::ALL {
                variants.push((source.clone(), order, job(folder, source, compiler, &flags, order)));
            }
        };
        if !source.file.ends_with("cpp") {
            for compiler in &compilers {
                for flags in FLAGS {
                    add(compiler, flags.iter().map(|&flag| flag.to_owned()).collect());
                }
            }
        } else if has_cpp {
            let includes = generated.include.iter().map(|path| format!("-I{path}"));
            add(
                "g++",
                CPP_FLAGS.iter().map(|&flag| flag.to_owned()).chain(includes).collect(),
            );
        }
    }
    // One library serves several functions.
    let mut jobs: Vec<Job> = Vec::new();
    for (.., job) in &variants {
        if !jobs.contains(job) {
            jobs.push(job.clone());
        }
    }
    let libraries = compile::compile(&jobs)?;
    let library = |job: &Job| jobs.iter().position(|known| known == job).map(|n| &libraries[n]);
    let mut candidates = Vec::new();
    for (source, order, job) in variants {
        let Some(library) = library(&job) else { continue };
        let program = load(&source, library)?;
        let cpp = source.file.ends_with("cpp");
        let form = if cpp {
            source.form.clone()
        } else {
            format!("{}; {}", source.form, job.describe())
        };
        candidates.push(Candidate {
            model: source.model,
            function: source.function,
            order,
            peer: source.peer,
            form,
            operations: source.operations.map(Into::into),
            program,
            cheap: None,
            job: Some((job, source.symbol)),
        });
    }
    Ok(candidates)
}

fn runs(program: &str) -> bool {
    !machine::says(program, &["--version"]).starts_with("no ")
}

fn job(folder: &Path, source: &Source, compiler: &str, flags: &[String], order: Order) -> Job {
    Job {
        source: folder.join(&source.file),
        compiler: compiler.to_owned(),
        flags: flags.to_vec(),
        define: match order {
            Order::SideBySide => None,
            Order::InSequence => Some("IN_SEQUENCE"),
        },
        before: None,
    }
}

fn load(source: &Source, library: &Path) -> Result<Program, Box<dyn Error>> {
    let (states, results) = sizes(&source.model, source.function)?;
    library::load(library, &source.symbol, states, results)
}

/// Lengths of the state, and of the output of a peer's function.
pub(crate) fn sizes(model: &str, function: Function) -> Result<(usize, usize), String> {
    let (dof, more) = match model {
        "eq22" => (2, 0),
        "ur5" => (6, 0),
        "panda" | "xarm7" => (7, 0),
        // a quaternion has one number more than there are rates
        "solo" => (18, 1),
        _ => return Err(format!("the peers have a model that is not known here: {model}")),
    };
    let (values, by) = function.shape(dof);
    Ok((2 * dof + more, values * (1 + by)))
}

/// The function of a candidate with cheap sines and cosines. Only for C: Pinocchio's headers use these names for other
/// functions, too. Only side by side: in sequence, nobody reads the result.
pub(crate) fn cheapened(candidate: &Candidate) -> Result<Option<Program>, Box<dyn Error>> {
    let Some((job, symbol)) = &candidate.job else {
        return Ok(None);
    };
    if candidate.order != Order::SideBySide || job.source.extension().is_none_or(|ending| ending != "c") {
        return Ok(None);
    }
    let job = Job {
        before: Some(cheap::IN_C),
        ..job.clone()
    };
    let (states, results) = sizes(&candidate.model, candidate.function)?;
    let [library] = &compile::compile(&[job])?[..] else {
        return Ok(None);
    };
    Ok(Some(library::load(library, symbol, states, results)?))
}

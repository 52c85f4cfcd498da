//! Emitted C code, compiled with the machine's compiler and run.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;

use pendulum_codegen::Sources;
use pendulum_codegen::program::{Argument, Program, Routine, Shape};

/// Highest order of the series.
pub(crate) const ORDER: usize = 24;

/// Folder for a test. Returns `None` and prints the reason if there is no compiler.
pub(crate) fn folder(name: &str) -> Option<PathBuf> {
    if Command::new("cc").arg("--version").output().is_err() {
        eprintln!("skipped: there is no `cc` that could compile C");
        return None;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("emitted_c").join(name);
    fs::create_dir_all(&folder).expect("a folder");
    Some(folder)
}

/// All results of C code at default parameters, routine by routine, followed by those of the series. Each list of
/// numbers holds the time, the state, accelerations, which also serve as constraint forces, and inputs. The state also
/// serves as weights, and the numbers from there on as a direction.
pub(crate) fn results(folder: &Path, program: &Program, sources: &Sources, given: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let bytes = output(&compiled(folder, sources, &evaluation(program, &sources.name)), given);
    let numbers = bytes.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes));
    let numbers: Vec<f64> = numbers.collect();
    numbers
        .chunks(numbers.len() / given.len())
        .map(<[f64]>::to_vec)
        .collect()
}

/// Compiles a program of a scene and a `main`.
pub(crate) fn compiled(folder: &Path, sources: &Sources, main: &str) -> PathBuf {
    compiled_with(folder, sources, main, &[])
}

/// Compiles a program with more options.
pub(crate) fn compiled_with(folder: &Path, sources: &Sources, main: &str, options: &[&str]) -> PathBuf {
    let own = |extension| folder.join(&sources.name).with_extension(extension);
    for (path, text) in [
        (own("h"), &*sources.header),
        (own("c"), &*sources.source),
        (folder.join("main.c"), main),
    ] {
        fs::write(path, text).expect("a file");
    }
    let mut command = Command::new("cc");
    command.args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-O2"]);
    command.args(options);
    // with instructions that could fuse operations, if the machine has them
    command.args(cfg!(target_arch = "x86_64").then_some("-march=native"));
    command.arg("main.c").arg(own("c")).args(["-lm", "-o", "main"]);
    let status = command.current_dir(folder).status();
    assert!(
        status.expect("a compiler").success(),
        "{} does not compile",
        sources.name
    );
    folder.join("main")
}

/// Output of a program for these input numbers.
pub(crate) fn output(program: &Path, given: &[Vec<f64>]) -> Vec<u8> {
    let numbers = program.with_extension("numbers");
    let bytes = given.iter().flatten().flat_map(|number| number.to_le_bytes());
    fs::write(&numbers, bytes.collect::<Vec<u8>>()).expect("a file");
    let given = File::open(numbers).expect("a file");
    let output = Command::new(program).stdin(given).output().expect("it runs");
    assert!(output.status.success(), "{}: {:?}", program.display(), output.status);
    output.stdout
}

/// Source of a program that evaluates everything for each list of input numbers.
fn evaluation(program: &Program, name: &str) -> String {
    let (length, dof) = (program.layout.len(), program.layout.dof());
    let (mut calls, mut at) = (String::new(), 0);
    for routine in &program.routines {
        let mut arguments = String::from("&model, in[0], in + 1");
        for argument in &routine.arguments {
            arguments += match argument {
                Argument::Inputs => ", &u",
                Argument::Accelerations | Argument::Forces => ", more",
                Argument::Weights | Argument::Direction => ", in + 1",
            };
        }
        if routine.shapes == [Shape::Scalar] {
            calls += &format!("out[{at}] = {name}_{}({arguments});\n", function(routine));
            at += 1;
            continue;
        }
        for shape in &routine.shapes {
            arguments += &format!(", out + {at}");
            at += match *shape {
                Shape::Symmetric(n) => n * n,
                shape => shape.len(),
            };
        }
        calls += &format!("{name}_{}({arguments});\n", function(routine));
    }
    if program.inputs.is_empty() {
        // results may overwrite the state; the right-hand side comes first
        calls += &format!("double x[{length}];\nfor (int n = 0; n < {length}; n++) x[n] = in[1 + n];\n");
        let forces = if program.constraints.is_empty() { "" } else { " more," };
        calls += &format!("{name}_rhs(&model, in[0], x,{forces} x);\nif (memcmp(x, out, sizeof x) != 0) return 4;\n");
    }
    if program.series.is_some() {
        calls += &format!("for (int n = 0; n < {length}; n++) series[0][n] = in[1 + n];\n");
        let forces = if program.constraints.is_empty() { "" } else { ", more" };
        for (order, status, code) in [(ORDER + 1, 1, 2), (ORDER, 0, 3)] {
            let call = format!("{name}_series(&model, in[0], series, {order}, &work{forces})");
            calls += &format!("if ({call} != {status}) return {code};\n");
        }
        calls += &format!(
            "for (int n = 0; n < {ORDER} * {length}; n++) out[{at} + n] = series[1 + n / {length}][n % {length}];\n"
        );
        at += ORDER * length;
    }
    if program.layout.quaternions().next().is_some() {
        let copied = format!("for (int n = 0; n < {length}; n++) out[{at} + n] = in[1 + n];\n");
        calls += &format!("{copied}{name}_project(out + {at});\n");
        at += length;
    }
    let declared = match &program.series {
        Some(_) => format!("static double series[{ORDER} + 1][{length}];\nstatic {name}_work work;\n"),
        None => String::new(),
    };
    let inputs = match program.inputs.len() {
        0 => String::new(),
        n => {
            let list: Vec<String> = (dof..dof + n).map(|at| format!("more[{at}]")).collect();
            format!("const {name}_inputs u = {{{}}};\n", list.join(", "))
        }
    };
    include_str!("c_code/evaluate.c")
        .replace("DECLARED", &declared)
        .replace("CALLS", &(inputs + &calls))
        .replace("IN", &(1 + length + dof + program.inputs.len()).to_string())
        .replace("MORE", &(1 + length).to_string())
        .replace("OUT", &at.to_string())
        .replace("name", name)
}

/// Name of the function in C, which is the one in Rust.
fn function(routine: &Routine) -> &str {
    match routine.name.as_str() {
        "jacobian" => "rhs_and_jacobian",
        name => name,
    }
}

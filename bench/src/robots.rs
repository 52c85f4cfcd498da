//! Robot files of example-robot-data: which ones can be read, and whether their motion agrees with Pinocchio.

use std::collections::BTreeMap;
use std::error::Error;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use pendulum_codegen::program::Program;
use pendulum_codegen::{Errors, c, program_in};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::machine;
use crate::python::python;
use crate::report::{list, number, table, write};

/// Ways to read a file, beginning with the simplest: a name, options after its path, and a body of the scene, in which
/// `{root}` stands for the root link.
const WAYS: [(&str, &str, &str); 5] = [
    ("as it is", "", ""),
    ("`without dry_friction`", ", without dry_friction", ""),
    ("`repair`", ", repair", ""),
    ("both", ", without dry_friction, repair", ""),
    (
        "its root free",
        "",
        "body {root} on ground { joint: free, orientation: o, position: p }",
    ),
];

/// Relative errors of a robot compared with Pinocchio; or the reason why Pinocchio rejects it.
#[derive(Deserialize)]
struct Compared {
    accelerations: Option<f64>,
    energies: Option<f64>,
    forces: Option<f64>,
    refused: Option<String>,
}

/// Robot file.
struct File {
    /// Path relative to the folder of all files.
    name: String,
    path: PathBuf,
    /// Link without a parent, if there is a link.
    root: Option<String>,
}

/// Robot that was read.
struct Taken {
    way: usize,
    program: Program,
    seconds: f64,
}

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = root.join("out/robots");
    let script = |arguments: &[&OsStr]| {
        let mut script = Command::new(python(&root));
        script.arg(root.join("bench/robots/compare.py")).args(arguments);
        script
    };
    let output = script(&["files".as_ref()]).output()?;
    if !output.status.success() {
        return Err("compare.py failed; `.venv/bin/pip install pin example-robot-data`, or set PYTHON".into());
    }
    let files = files(&String::from_utf8(output.stdout)?)?;
    let taken = files.iter().map(take).collect::<Result<Vec<_>, _>>()?;
    let mut tasks = Vec::new();
    for (n, (file, taken)) in files.iter().zip(&taken).enumerate() {
        if let Ok(taken) = taken {
            tasks.push(task(file, taken, &folder, format!("r{n}"))?);
        }
    }
    write(folder.join("task.json"), &serde_json::to_string(&tasks)?)?;
    if !script(&["compare".as_ref(), folder.as_os_str()]).status()?.success() {
        return Err("compare.py failed".into());
    }
    let compared: BTreeMap<String, Compared> = serde_json::from_str(&fs::read_to_string(folder.join("errors.json"))?)?;
    let rows: Vec<Vec<String>> = files
        .iter()
        .zip(&taken)
        .map(|(file, taken)| row(file, taken, compared.get(&file.name)))
        .collect();
    let head = [
        "file",
        "read",
        "repaired",
        "rates",
        "operations",
        "seconds",
        "accelerations",
        "energies",
        "forces",
    ];
    let read = taken.iter().filter(|taken| taken.is_ok()).count();
    let text = format!(
        "{}\n{read} of {} files are read.\n\n{}",
        list(&machine::describe()),
        files.len(),
        table(&head, 3, &rows)
    );
    print!("{text}");
    println!("{}", write(folder.join("robots.md"), &text)?.display());
    Ok(())
}

/// The folder of all files, then each file with its root.
fn files(text: &str) -> Result<Vec<File>, Box<dyn Error>> {
    let mut lines = text.lines();
    let robots = Path::new(lines.next().ok_or("no folder")?);
    let files = lines.map(|line| {
        let mut parts = line.split('\t').map(str::to_owned);
        let name = parts.next().unwrap_or_default();
        let path = robots.join(&name);
        let root = parts.next();
        File { name, path, root }
    });
    Ok(files.collect())
}

/// Reads a file in the first way that succeeds; otherwise returns the errors of the last way without a free root.
fn take(file: &File) -> Result<Result<Taken, Errors>, Box<dyn Error>> {
    let mut refused = None;
    for (way, (_, words, body)) in WAYS.iter().enumerate() {
        let since = Instant::now();
        match declared(file, words, body)? {
            Ok(program) => {
                let seconds = since.elapsed().as_secs_f64();
                return Ok(Ok(Taken { way, program, seconds }));
            }
            Err(errors) if body.is_empty() => refused = Some(errors),
            Err(_) => {}
        }
    }
    Ok(Err(refused.expect("the errors of a way")))
}

/// Expands the scene of a file.
fn declared(file: &File, words: &str, body: &str) -> Result<Result<Program, Errors>, Box<dyn Error>> {
    let folder = file.path.parent().ok_or("no folder")?;
    let name = file.path.file_name().and_then(|name| name.to_str()).ok_or("no name")?;
    let body = body.replace("{root}", file.root.as_deref().unwrap_or("none"));
    let text =
        format!("Robot {{ robot: urdf(\"{name}\"{words}), {body} gravity: [0, 0, -9.81], generate: [rhs, energy] }}");
    Ok(program_in(folder, text.parse()?))
}

/// Writes the C code of a robot, and returns its description for Pinocchio.
fn task(file: &File, taken: &Taken, folder: &Path, name: String) -> Result<Value, Box<dyn Error>> {
    let (_, words, body) = WAYS[taken.way];
    // compare without dry friction
    let without = match words.contains("without") {
        true => None,
        false => Some(
            declared(file, &format!("{words}, without dry_friction"), body)?.map_err(|errors| errors.to_string())?,
        ),
    };
    let program = without.as_ref().unwrap_or(&taken.program);
    let sources = c(program);
    write(folder.join(&name).join("robot.h"), &sources.header)?;
    write(folder.join(&name).join("robot.c"), &sources.source)?;
    let held = program
        .repaired
        .iter()
        .filter_map(|repair| repair.strip_prefix("joint `"));
    let held: Vec<&str> = held.filter_map(|rest| rest.split('`').next()).collect();
    Ok(json!({
        "file": file.name,
        "name": name,
        "repair": words.contains("repair"),
        "held": held,
        "free": file.root.as_ref().filter(|_| !body.is_empty()),
        "length": program.layout.len(),
        "constants": program.constants.results.len(),
    }))
}

fn row(file: &File, taken: &Result<Taken, Errors>, compared: Option<&Compared>) -> Vec<String> {
    let name = file.name.rsplit('/').next().unwrap_or_default().to_owned();
    let Taken { way, program, seconds } = match taken {
        Ok(taken) => taken,
        Err(errors) => {
            let first = errors.iter().next().map_or(String::new(), |error| error.to_string());
            let first = first.lines().next().unwrap_or_default().to_owned();
            let mut row = vec![name, format!("refused: {first}")];
            row.resize(9, String::new());
            return row;
        }
    };
    let operations = program.routine("rhs").map(|rhs| &rhs.cost.operations);
    let error = |error: fn(&Compared) -> Option<f64>| {
        compared
            .and_then(error)
            .map_or(String::new(), |error| format!("{error:.0e}"))
    };
    let repaired = match program.repaired.len() {
        0 => String::new(),
        n => n.to_string(),
    };
    vec![
        name,
        WAYS[*way].0.to_owned(),
        repaired,
        program.layout.dof().to_string(),
        operations.map_or(String::new(), |all| {
            (all.additions + all.multiplications + all.divisions).to_string()
        }),
        number(Some(*seconds)),
        match compared.and_then(|compared| compared.refused.as_ref()) {
            Some(why) => format!("Pinocchio: {why}"),
            None => error(|compared| compared.accelerations),
        },
        error(|compared| compared.energies),
        error(|compared| compared.forces),
    ]
}

//! The robot files of example-robot-data: which are read, and whether Pinocchio has the same motion.

use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use pendulum_codegen::program::Program;
use pendulum_codegen::{Errors, c, program_in};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::machine;
use crate::python::python;
use crate::report::{list, number, table, write};

/// What is said of a file, from the least on; a root that is named `{root}` is set free.
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

/// The errors of a robot against Pinocchio, relative; or why Pinocchio has none.
#[derive(Deserialize)]
struct Compared {
    accelerations: Option<f64>,
    energies: Option<f64>,
    forces: Option<f64>,
    refused: Option<String>,
}

/// A robot as it was read.
struct Taken {
    way: usize,
    program: Program,
    seconds: f64,
}

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = root.join("out/robots");
    fs::create_dir_all(&folder)?;
    let script = root.join("bench/robots/compare.py");
    let output = Command::new(python(&root)).arg(&script).arg("files").output()?;
    if !output.status.success() {
        return Err("compare.py failed; `.venv/bin/pip install pin example-robot-data`, or set PYTHON".into());
    }
    let text = String::from_utf8(output.stdout)?;
    let mut files = text.lines();
    let robots = Path::new(files.next().ok_or("no folder")?);
    let files: Vec<&str> = files.collect();
    let mut tasks = Vec::new();
    let mut taken = Vec::new();
    for (n, &file) in files.iter().enumerate() {
        let found = take(&robots.join(file))?;
        if let Ok(Taken { way, program, .. }) = &found {
            let name = format!("r{n}");
            // what is compared has no dry friction
            let compared = if WAYS[*way].1.contains("without") {
                program
            } else {
                &declared(
                    &robots.join(file),
                    &format!("{}, without dry_friction", WAYS[*way].1),
                    WAYS[*way].2,
                )?
                .map_err(|errors| errors.to_string())?
            };
            let sources = c(compared);
            write(folder.join(&name).join("robot.h"), &sources.header)?;
            write(folder.join(&name).join("robot.c"), &sources.source)?;
            tasks.push(task(file, &name, compared, *way, &robots.join(file))?);
        }
        taken.push(found);
    }
    fs::write(folder.join("task.json"), serde_json::to_string(&tasks)?)?;
    let status = Command::new(python(&root))
        .arg(&script)
        .arg("compare")
        .arg(&folder)
        .status()?;
    if !status.success() {
        return Err("compare.py failed".into());
    }
    let compared: BTreeMap<String, Compared> = serde_json::from_str(&fs::read_to_string(folder.join("errors.json"))?)?;
    let rows: Vec<Vec<String>> = files
        .iter()
        .zip(&taken)
        .map(|(file, taken)| row(file, taken, compared.get(*file)))
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

/// A file in the first way in which it is read, or the errors of the last.
fn take(path: &Path) -> Result<Result<Taken, Errors>, Box<dyn Error>> {
    let mut refused = None;
    for (way, (_, words, body)) in WAYS.iter().enumerate() {
        let since = Instant::now();
        match declared(path, words, body)? {
            Ok(program) => {
                let seconds = since.elapsed().as_secs_f64();
                return Ok(Ok(Taken { way, program, seconds }));
            }
            // a free root moves what nothing else does
            Err(errors) if body.is_empty() || refused.is_none() => refused = Some(errors),
            Err(_) => {}
        }
    }
    Ok(Err(refused.expect("the errors of a way")))
}

/// The scene of a file.
fn declared(path: &Path, words: &str, body: &str) -> Result<Result<Program, Errors>, Box<dyn Error>> {
    let folder = path.parent().ok_or("no folder")?;
    let name = path.file_name().and_then(|name| name.to_str()).ok_or("no name")?;
    let body = body.replace("{root}", &root_of(path)?);
    let text =
        format!("Robot {{ robot: urdf(\"{name}\"{words}), {body} gravity: [0, 0, -9.81], generate: [rhs, energy] }}");
    Ok(program_in(folder, text.parse()?))
}

/// The link that hangs on none.
fn root_of(path: &Path) -> Result<String, Box<dyn Error>> {
    let text = fs::read_to_string(path)?;
    let named = |element: &str, attribute: &str| -> Vec<String> {
        let start = format!("<{element} ");
        let values = text.split(start.as_str()).skip(1).filter_map(|rest| {
            let (_, value) = rest.split_once('>')?.0.split_once(&format!("{attribute}=\""))?;
            Some(value.split('"').next()?.to_owned())
        });
        values.collect()
    };
    let children = named("child", "link");
    let root = named("link", "name").into_iter().find(|link| !children.contains(link));
    Ok(root.unwrap_or_else(|| "none".to_owned()))
}

/// What Pinocchio must know of a robot.
fn task(file: &str, name: &str, program: &Program, way: usize, path: &Path) -> Result<Value, Box<dyn Error>> {
    let held = program
        .repaired
        .iter()
        .filter_map(|repair| repair.strip_prefix("joint `"));
    let held: Vec<&str> = held.filter_map(|rest| rest.split('`').next()).collect();
    let (_, words, body) = WAYS[way];
    Ok(json!({
        "file": file,
        "name": name,
        "repair": words.contains("repair"),
        "held": held,
        "free": if body.is_empty() { None } else { Some(root_of(path)?) },
        "length": program.layout.len(),
        "constants": program.constants.results.len(),
    }))
}

fn row(file: &str, taken: &Result<Taken, Errors>, compared: Option<&Compared>) -> Vec<String> {
    let name = file.rsplit('/').next().unwrap_or(file).to_owned();
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

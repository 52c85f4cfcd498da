//! Ten questions of users of other software: our answers beside those of the software, from one run.

use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde::{Deserialize, Serialize};

use crate::machine;
use crate::python::python;
use crate::report::{list, table, write};

/// Our answer to a question.
#[derive(Deserialize, Serialize)]
struct Answer {
    figure: f64,
    text: String,
    seconds: Option<f64>,
}

/// Answer of other software.
#[derive(Deserialize, Serialize)]
struct Peer {
    name: String,
    figure: f64,
    text: String,
}

#[derive(Serialize)]
struct Raw<'r> {
    machine: &'r [String],
    ours: &'r BTreeMap<String, Answer>,
    peers: &'r BTreeMap<String, Vec<Peer>>,
}

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = root.join("out/questions");
    fs::create_dir_all(&folder)?;
    let program = [
        "run",
        "--release",
        "-p",
        "studies",
        "--example",
        "open_questions",
        "--",
        "--json",
    ];
    let output = Command::new("cargo").args(program).current_dir(&root).output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let ours: BTreeMap<String, Answer> = serde_json::from_slice(&output.stdout)?;
    let script = root.join("bench/questions/peers.py");
    let status = Command::new(python(&root)).arg(script).arg(&folder).status()?;
    if !status.success() {
        return Err("peers.py failed: see the README for what to install, or set PYTHON".into());
    }
    let peers: BTreeMap<String, Vec<Peer>> = serde_json::from_str(&fs::read_to_string(folder.join("results.json"))?)?;

    let mut rows = Vec::new();
    for (question, answer) in &ours {
        let time = answer
            .seconds
            .map_or(String::new(), |seconds| format!(", in {seconds:.2} s"));
        rows.push(vec![
            question.clone(),
            "ours".to_owned(),
            format!("{}{time}", answer.text),
        ]);
        let others = peers.get(question).into_iter().flatten();
        rows.extend(others.map(|peer| vec![String::new(), peer.name.clone(), peer.text.clone()]));
    }
    let machine = machine::describe();
    let text = list(&machine) + "\n" + &table(&["question", "", "answer"], 3, &rows);
    print!("{text}");
    println!("{}", write(folder.join("questions.md"), &text)?.display());
    let raw = Raw {
        machine: &machine,
        ours: &ours,
        peers: &peers,
    };
    let path = write(folder.join("questions.json"), &serde_json::to_string_pretty(&raw)?)?;
    println!("{}", path.display());
    Ok(())
}

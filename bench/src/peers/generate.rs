//! Generation of the peers' code by Python.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::Command;

use pendulum_core::Operations;
use serde::Deserialize;

use crate::python::python;

/// List printed by `peers/generate.py`.
#[derive(Default, Deserialize)]
pub(crate) struct Generated {
    pub candidates: Vec<Source>,
    /// Left-out items, with the reason.
    pub notes: Vec<String>,
    /// Versions of the packages.
    pub versions: Vec<String>,
    /// Folders of C++ headers.
    pub include: Vec<String>,
}

/// Function in a C or C++ file.
#[derive(Clone, Deserialize)]
pub(crate) struct Source {
    pub model: String,
    pub function: super::candidate::Function,
    pub peer: String,
    pub form: String,
    pub file: String,
    pub symbol: String,
    pub operations: Option<Counted>,
}

/// Counts of [`pendulum_core::Operations`].
#[derive(Clone, Copy, Deserialize)]
pub(crate) struct Counted {
    pub additions: usize,
    pub multiplications: usize,
    pub divisions: usize,
    pub sincos: usize,
    pub functions: usize,
}

impl From<Counted> for Operations {
    fn from(counted: Counted) -> Self {
        let Counted {
            additions,
            multiplications,
            divisions,
            sincos,
            functions,
        } = counted;
        let chain = 0; // not counted
        Self::new(additions, multiplications, divisions, sincos, functions, chain)
    }
}

pub(crate) fn generate(root: &Path, folder: &Path) -> Result<Generated, Box<dyn Error>> {
    let python = python(root);
    let output = Command::new(&python)
        .arg(root.join("peers/generate.py"))
        .args([root.join("../testbed/data"), root.join("peers/double_pendulum.json")])
        .arg(folder)
        .output();
    let output = match output {
        Ok(output) => output,
        Err(error) => {
            let note = format!(
                "all peers: {} does not start ({error}); `sudo apt-get install python3 python3-venv`, and see \
                 README.md",
                python.display()
            );
            return Ok(Generated {
                notes: vec![note],
                ..Generated::default()
            });
        }
    };
    if !output.status.success() {
        return Err(format!("peers/generate.py failed:\n{}", String::from_utf8_lossy(&output.stderr)).into());
    }
    Ok(serde_json::from_str(&fs::read_to_string(
        folder.join("candidates.json"),
    )?)?)
}

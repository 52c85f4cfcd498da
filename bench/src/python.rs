//! The Python with the peers.

use std::error::Error;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde_json::Value;

/// `$PYTHON`, otherwise the Python of the environment beside the README, otherwise of the system.
pub(crate) fn python(root: &Path) -> PathBuf {
    let local = root.join(".venv/bin/python");
    match std::env::var_os("PYTHON") {
        Some(python) => python.into(),
        None if local.exists() => local,
        None => "python3".into(),
    }
}

/// A running script, which answers each line of its input by a line.
pub(crate) struct Server {
    process: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
}

impl Server {
    /// Starts a script below the folder `root`.
    pub(crate) fn start(root: &Path, script: &str) -> Result<Self, Box<dyn Error>> {
        let mut process = Command::new(python(root))
            .arg(root.join(script))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let (input, output) = (process.stdin.take(), process.stdout.take());
        Ok(Self {
            process,
            input: input.ok_or("no input")?,
            output: BufReader::new(output.ok_or("no output")?),
        })
    }

    /// Writes a line, and reads one.
    pub(crate) fn ask(&mut self, request: &Value) -> Result<String, Box<dyn Error>> {
        writeln!(self.input, "{request}")?;
        let mut answer = String::new();
        if self.output.read_line(&mut answer)? == 0 {
            return Err("no answer".into());
        }
        Ok(answer)
    }
}

/// The process ends with its input, but would remain a zombie.
impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

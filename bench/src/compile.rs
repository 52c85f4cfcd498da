//! Compilation of C and C++ into shared libraries.

use std::collections::hash_map::DefaultHasher;
use std::error::Error;
use std::fs;
use std::hash::{Hash, Hasher};
use std::path::PathBuf;
use std::process::Command;
use std::sync::Mutex;
use std::thread;

/// A compiler call.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Job {
    pub source: PathBuf,
    pub compiler: String,
    pub flags: Vec<String>,
    /// Macro to define.
    pub define: Option<&'static str>,
    /// C code to include before all other code.
    pub before: Option<&'static str>,
}

impl Job {
    pub(crate) fn describe(&self) -> String {
        format!("{} {}", self.compiler, self.flags.join(" "))
    }

    /// Compiles the library, unless the same one exists from an earlier run.
    fn library(&self) -> Result<PathBuf, String> {
        let text = fs::read(&self.source).map_err(|error| format!("{}: {error}", self.source.display()))?;
        let mut hasher = DefaultHasher::new();
        (text, &self.compiler, &self.flags, self.define, self.before).hash(&mut hasher);
        let target = self.source.with_extension(format!("{:016x}.so", hasher.finish()));
        if target.exists() {
            return Ok(target);
        }
        let unfinished = target.with_extension("part");
        let mut command = Command::new(&self.compiler);
        command
            .args(["-shared", "-fPIC", "-fvisibility=hidden", "-w"])
            .args(&self.flags)
            .args(self.define.map(|name| format!("-D{name}")));
        if let Some(before) = self.before {
            let header = target.with_extension("h");
            fs::write(&header, before).map_err(|error| error.to_string())?;
            command.arg("-include").arg(header);
        }
        command.arg(&self.source).arg("-lm").arg("-o").arg(&unfinished);
        let output = command
            .output()
            .map_err(|error| format!("{}: {error}", self.compiler))?;
        if !output.status.success() {
            let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
            return Err(format!("{} {}:\n{complaint}", self.compiler, self.source.display()));
        }
        fs::rename(&unfinished, &target).map_err(|error| error.to_string())?;
        Ok(target)
    }
}

/// Compiles the libraries of all jobs, in order, with as many compilers in parallel as there are processors.
pub(crate) fn compile(jobs: &[Job]) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let done: Mutex<Vec<Option<Result<PathBuf, String>>>> = Mutex::new(vec![None; jobs.len()]);
    let next = std::sync::atomic::AtomicUsize::new(0);
    let work = || {
        loop {
            let n = next.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            let Some(job) = jobs.get(n) else { return };
            let library = job.library();
            if let Ok(mut done) = done.lock() {
                done[n] = Some(library);
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    let done = done.into_inner().map_err(|_| "a compiling thread panicked")?;
    let libraries: Result<Vec<PathBuf>, String> = done
        .into_iter()
        .map(|library| library.unwrap_or_else(|| Err("not compiled".to_owned())))
        .collect();
    Ok(libraries?)
}

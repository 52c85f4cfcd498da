//! The peers' C and C++, compiled into shared libraries and loaded.

use std::collections::hash_map::DefaultHasher;
use std::error::Error;
use std::fs;
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::rc::Rc;
use std::sync::Mutex;
use std::thread;

use libloading::Library;

use super::candidate::Program;
use super::cheap;

/// One call of a compiler.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Job {
    pub source: PathBuf,
    pub compiler: String,
    pub flags: Vec<String>,
    /// Without sine and cosine.
    pub cheap: bool,
}

impl Job {
    pub(crate) fn describe(&self) -> String {
        format!("{} {}", self.compiler, self.flags.join(" "))
    }

    /// Compiles, unless the same library is there from an earlier run.
    fn library(&self) -> Result<PathBuf, String> {
        let text = fs::read(&self.source).map_err(|error| format!("{}: {error}", self.source.display()))?;
        let mut hasher = DefaultHasher::new();
        (text, &self.compiler, &self.flags, self.cheap, cheap::IN_C).hash(&mut hasher);
        let target = self.source.with_extension(format!("{:016x}.so", hasher.finish()));
        if target.exists() {
            return Ok(target);
        }
        let unfinished = target.with_extension("part");
        let mut command = Command::new(&self.compiler);
        command
            .args(["-shared", "-fPIC", "-fvisibility=hidden", "-w"])
            .args(&self.flags);
        if self.cheap {
            let header = target.with_extension("h");
            fs::write(&header, cheap::IN_C).map_err(|error| error.to_string())?;
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

/// The libraries of all jobs in their order, made by as many compilers at a time as there are processors.
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

type Run = unsafe extern "C" fn(*const f64, *mut f64, std::ffi::c_long);

/// The function `symbol`, which reads states of the length `states` and writes `results` numbers for each.
#[allow(
    unsafe_code,
    reason = "the peers are C: their functions are loaded and called by address"
)]
pub(crate) fn load(library: &Path, symbol: &str, states: usize, results: usize) -> Result<Program, Box<dyn Error>> {
    // SAFETY: the library was compiled from `peers/`: its initialisers are those of C++ globals.
    let library = unsafe { Library::new(library)? };
    // SAFETY: all functions of the peers are made by the template in `peers/candidate.py`, with this signature.
    let function: Run = unsafe { *library.get::<Run>(symbol.as_bytes())? };
    let library = Rc::new(library);
    let call = move |x: &[f64], out: &mut [f64]| {
        let _alive = &library;
        assert!(x.len().is_multiple_of(states) && out.len() == results);
        let count = (x.len() / states) as std::ffi::c_long;
        // SAFETY: the function reads `count` states and writes each result to the same `results` numbers, as asserted above;
        // the library outlives the closure.
        unsafe { function(x.as_ptr(), out.as_mut_ptr(), count) }
    };
    let call = Rc::new(call);
    let once = Rc::clone(&call);
    Ok(Program {
        run: Box::new(move |x| call(x, &mut vec![0.0; results])),
        value: Box::new(move |x| {
            let mut out = vec![0.0; results];
            once(x, &mut out);
            out
        }),
    })
}

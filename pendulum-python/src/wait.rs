//! Work that releases the interpreter, and ends when the user interrupts it.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use pendulum_runtime::{Error, Model};
use pyo3::prelude::*;

use crate::error::OrRaise;

/// Does work on another thread. At a signal, such as Ctrl-C, `cancel` is set, and the work should end soon. Returns its
/// result, and the exception of the signal.
pub(crate) fn wait<R: Send>(
    py: Python<'_>,
    cancel: &AtomicBool,
    work: impl FnOnce() -> R + Send,
) -> (R, Option<PyErr>) {
    py.detach(|| {
        let mut signal = None;
        let look = || {
            if let Err(error) = Python::attach(|py| py.check_signals()) {
                cancel.store(true, Ordering::Relaxed);
                signal = Some(error);
            }
        };
        let result = pendulum_runtime::while_waiting(work, look);
        (result, signal)
    })
}

/// Looks for a signal from time to time, on the thread that works; only the main thread of Python receives any.
pub(crate) struct Signals {
    /// Time of the last look, and the exception of a signal.
    state: Mutex<(Instant, Option<PyErr>)>,
    calls: AtomicUsize,
    pub(crate) cancel: AtomicBool,
}

/// Number of calls between two looks at the clock.
const CALLS: usize = 64;
/// Time between two looks for a signal.
const LOOK: Duration = Duration::from_millis(20);

impl Signals {
    pub(crate) fn new() -> Self {
        Self {
            state: Mutex::new((Instant::now(), None)),
            calls: AtomicUsize::new(0),
            cancel: AtomicBool::new(false),
        }
    }

    /// Does work on a model, on this thread if that has enough of a stack, which then looks for signals itself.
    pub(crate) fn run<R: Send>(&self, py: Python<'_>, model: &Model, work: impl FnOnce() -> R + Send) -> R {
        if model.is_short() {
            return py.detach(work);
        }
        let (result, signal) = wait(py, &self.cancel, work);
        if let Some(signal) = signal {
            self.put(signal);
        }
        result
    }

    /// Keeps the exception of a signal.
    pub(crate) fn put(&self, signal: PyErr) {
        if let Ok(mut state) = self.state.lock() {
            state.1.get_or_insert(signal);
        }
    }

    /// True if the work should end.
    pub(crate) fn is_cancelled(&self) -> bool {
        if self.calls.fetch_add(1, Ordering::Relaxed) % CALLS == CALLS - 1
            && let Ok(mut state) = self.state.lock()
            && state.0.elapsed() > LOOK
        {
            state.0 = Instant::now();
            if let Err(error) = Python::attach(|py| py.check_signals()) {
                state.1.get_or_insert(error);
                self.cancel.store(true, Ordering::Relaxed);
            }
        }
        self.cancel.load(Ordering::Relaxed)
    }

    /// Result of the work, or the exception of a signal that ended it.
    pub(crate) fn instead_of<R>(self, py: Python<'_>, result: Result<R, Error>) -> PyResult<R> {
        match self.signal() {
            Some(signal) => Err(signal),
            None => result.or_raise(py),
        }
    }

    /// Exception of a signal.
    pub(crate) fn signal(self) -> Option<PyErr> {
        self.state.into_inner().ok()?.1
    }
}

//! Work that releases the interpreter, and ends when the user interrupts it.

use std::sync::atomic::{AtomicBool, Ordering};

use pyo3::prelude::*;

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

/// Like [`wait`], for work that cannot end early: a signal is raised after it.
pub(crate) fn wait_to_the_end<R: Send>(py: Python<'_>, work: impl FnOnce() -> R + Send) -> R {
    py.detach(work)
}

//! Work that releases the interpreter, and ends when the user interrupts it.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

use pyo3::prelude::*;

/// Time between two looks for a signal.
const LOOK: Duration = Duration::from_millis(20);

/// Does work on another thread. At a signal, such as Ctrl-C, `cancel` is set, and the work should end soon. Returns its
/// result, and the exception of the signal.
pub(crate) fn wait<R: Send>(
    py: Python<'_>,
    cancel: &AtomicBool,
    work: impl FnOnce() -> R + Send,
) -> (R, Option<PyErr>) {
    py.detach(|| {
        std::thread::scope(|scope| {
            let (sender, receiver) = mpsc::channel();
            let thread = scope.spawn(move || {
                // the receiver waits until the work has ended
                let _ = sender.send(work());
            });
            let mut signal = None;
            loop {
                match receiver.recv_timeout(LOOK) {
                    Ok(result) => return (result, signal),
                    Err(RecvTimeoutError::Timeout) => {
                        if let Err(error) = Python::attach(|py| py.check_signals()) {
                            cancel.store(true, Ordering::Relaxed);
                            signal = Some(error);
                        }
                    }
                    Err(RecvTimeoutError::Disconnected) => {
                        let panic = thread.join().err().unwrap_or_else(|| Box::new("no result"));
                        std::panic::resume_unwind(panic)
                    }
                }
            }
        })
    })
}

/// Like [`wait`], for work that cannot end early.
pub(crate) fn wait_to_the_end<R: Send>(py: Python<'_>, work: impl FnOnce() -> R + Send) -> R {
    py.detach(work)
}

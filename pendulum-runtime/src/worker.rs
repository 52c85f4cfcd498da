//! Threads with stacks that hold the longest states.

use std::cell::Cell;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Size of a stack in bytes. It is reserved, not used.
const STACK: usize = 64 << 20;
/// Time between two calls of the function that polls.
const LOOK: Duration = Duration::from_millis(20);

/// Function that ends a computation when it returns true.
pub(crate) type Cancel<'c> = dyn Fn() -> bool + Sync + 'c;

thread_local! {
    /// True in threads with such a stack.
    static IS_LARGE: Cell<bool> = const { Cell::new(false) };
}

/// Runs work on a thread with a large stack, on which this crate then works without further ones, and calls `look`
/// every 20 ms meanwhile: for a program that waits for the user to interrupt it.
pub fn while_waiting<R: Send>(work: impl FnOnce() -> R + Send, mut look: impl FnMut()) -> R {
    if cfg!(target_family = "wasm") {
        return work();
    }
    std::thread::scope(|scope| {
        let (sender, receiver) = mpsc::channel();
        let work = move || {
            IS_LARGE.set(true);
            // the receiver waits until the work has ended
            let _ = sender.send(work());
        };
        let thread = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work);
        let thread = thread.expect("a thread can be started");
        loop {
            match receiver.recv_timeout(LOOK) {
                Ok(result) => return result,
                Err(RecvTimeoutError::Timeout) => look(),
                Err(RecvTimeoutError::Disconnected) => {
                    let panic = thread.join().err().unwrap_or_else(|| Box::new("no result"));
                    std::panic::resume_unwind(panic)
                }
            }
        }
    })
}

/// Runs work on a thread with a large stack.
pub(crate) fn run<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    if IS_LARGE.get() { work() } else { alone(work) }
}

/// Runs work on a thread that ends with it, and so forgets the sources of its tokens.
pub(crate) fn alone<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    while_waiting(work, || ())
}

/// Runs work on one of as many threads as there are processors; work that it spawns runs on all.
pub(crate) fn on_all<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    /// The threads, and the process that started them: a fork has none of them.
    static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);
    if cfg!(target_family = "wasm") {
        return work();
    }
    let process = std::process::id();
    let pool = {
        let mut pool = POOL.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if pool.as_ref().is_none_or(|(own, _)| *own != process) {
            let started = ThreadPoolBuilder::new().stack_size(STACK).build().ok();
            let before = std::mem::replace(&mut *pool, started.map(|pool| (process, Arc::new(pool))));
            // the threads of another process cannot be joined
            std::mem::forget(before);
        }
        pool.as_ref().map(|(_, pool)| pool.clone())
    };
    match pool {
        Some(pool) => pool.install(work),
        // where threads cannot be started
        None => work(),
    }
}

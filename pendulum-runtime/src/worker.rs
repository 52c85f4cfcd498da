//! Threads with stacks that hold the longest states in the widest lanes.

use std::sync::OnceLock;

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Size of a stack in bytes. It is reserved, not used.
const STACK: usize = 64 << 20;

/// Runs work on one of as many threads as there are processors; work that it spawns runs on all.
pub(crate) fn run<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    static POOL: OnceLock<Option<ThreadPool>> = OnceLock::new();
    let build = || ThreadPoolBuilder::new().stack_size(STACK).build().ok();
    match POOL.get_or_init(build) {
        Some(pool) => pool.install(work),
        // without threads, as in a browser
        None => work(),
    }
}

/// Runs work on a thread that ends with it, and so forgets the sources of its tokens.
pub(crate) fn alone<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    if cfg!(target_family = "wasm") {
        return work();
    }
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work);
        let ended = thread.expect("a thread can be started").join();
        ended.unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

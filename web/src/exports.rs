//! The functions that the worker calls. All memory belongs to the module: the worker asks for room, writes the request
//! there, and reads the answer before its next call.
#![allow(unsafe_code, reason = "functions that keep their names could hide others")]

use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use crate::page::Page;

/// State between calls.
#[derive(Default)]
struct Kept {
    page: Page,
    request: Vec<u8>,
    text: String,
    numbers: Vec<f64>,
}

fn kept() -> MutexGuard<'static, Kept> {
    static KEPT: LazyLock<Mutex<Kept>> = LazyLock::new(Mutex::default);
    KEPT.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Address of room for a request of this many bytes.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn room(bytes: usize) -> *mut u8 {
    let request = &mut kept().request;
    request.clear();
    request.resize(bytes, 0);
    request.as_mut_ptr()
}

/// Answers the request, and returns the length of the text of the answer in bytes.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn answer() -> usize {
    let kept = &mut *kept();
    (kept.text, kept.numbers) = kept.page.answer_json(&kept.request);
    kept.text.len()
}

/// Address of the text of the answer.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn text() -> *const u8 {
    kept().text.as_ptr()
}

/// Address of the numbers of the answer.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn numbers() -> *const f64 {
    kept().numbers.as_ptr()
}

/// Number of the numbers of the answer.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn count() -> usize {
    kept().numbers.len()
}

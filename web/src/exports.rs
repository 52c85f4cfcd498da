//! The functions that the worker calls. All memory belongs to the module: the worker asks for room, writes the request
//! there, and reads the answer before its next call.
#![allow(unsafe_code, reason = "functions that keep their names could hide others")]

use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::page::Page;

/// What is kept between calls.
struct Kept {
    page: Page,
    request: Vec<u8>,
    text: String,
    numbers: Vec<f64>,
}

static KEPT: Mutex<Option<Kept>> = Mutex::new(None);

fn kept(guard: &mut Option<Kept>) -> &mut Kept {
    guard.get_or_insert_with(|| Kept {
        page: Page::default(),
        request: Vec::new(),
        text: String::new(),
        numbers: Vec::new(),
    })
}

fn lock() -> MutexGuard<'static, Option<Kept>> {
    KEPT.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Address of room for a request of this many bytes.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn room(bytes: usize) -> *mut u8 {
    let mut guard = lock();
    let request = &mut kept(&mut guard).request;
    request.clear();
    request.resize(bytes, 0);
    request.as_mut_ptr()
}

/// Answers the request, and returns the length of the text of the answer in bytes.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn answer() -> usize {
    let mut guard = lock();
    let kept = kept(&mut guard);
    (kept.text, kept.numbers) = kept.page.answer_json(&kept.request);
    kept.text.len()
}

/// Address of the text of the answer.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn text() -> *const u8 {
    kept(&mut lock()).text.as_ptr()
}

/// Address of the numbers of the answer.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn numbers() -> *const f64 {
    kept(&mut lock()).numbers.as_ptr()
}

/// Number of the numbers of the answer.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn count() -> usize {
    kept(&mut lock()).numbers.len()
}

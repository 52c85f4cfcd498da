//! Vector registers of x86-64, and functions in which the compiler may use them.
#![allow(
    unsafe_code,
    reason = "intrinsics are unsafe where the instruction set is not known to be there, and so is the call of a function that uses it"
)]

mod enter;
mod registers;

pub(super) use enter::{avx2, avx512};
pub(in crate::real) use registers::{Xmm32, Xmm64};
pub(super) use registers::{Ymm32, Ymm64, Zmm32, Zmm64};

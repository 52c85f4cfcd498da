//! Vector registers of x86-64, and functions in which the compiler may use them.
#![allow(
    unsafe_code,
    reason = "intrinsics, and functions compiled for an instruction set, are unsafe where it may not exist"
)]

mod enter;
mod registers;

pub(super) use enter::{avx2, avx512};
pub(in crate::real) use registers::{Xmm32, Xmm64};
pub(super) use registers::{Ymm32, Ymm64, Zmm32, Zmm64};

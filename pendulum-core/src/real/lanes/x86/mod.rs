//! Vector registers of x86-64, and functions in which the compiler may use them: all the unsafe code of the crate.
//!
//! Two facts make it sound; each block says which it rests on.
//!
//! 1. Where there is a value of a register type, the machine has its instructions. Every x86-64 machine that this is
//!    compiled for has `xmm` registers. The types of `ymm` and `zmm` registers are private to [`lanes`](super): other
//!    code meets them as the type argument of [`Kernel::run`](super::Kernel::run) alone, and only [`enter`] calls that
//!    with them, after it has looked whether the machine has the instructions. A machine does not lose them.
//! 2. A vector is laid out as the array of its lanes, and every pattern of bits is a number.
#![allow(
    unsafe_code,
    reason = "intrinsics, and functions compiled for an instruction set, are unsafe where it may not exist"
)]

mod enter;
mod registers;

pub(super) use enter::{avx2, avx512};
pub(in crate::real) use registers::{Xmm32, Xmm64};
pub(super) use registers::{Ymm32, Ymm64, Zmm32, Zmm64};

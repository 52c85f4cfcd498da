//! Vector registers of x86-64, and functions compiled with their instructions.
//!
//! Its soundness rests on two facts, and each block names the one it uses.
//!
//! 1. If a value of a register type exists, the machine has its instructions. Every supported x86-64 machine has `xmm`
//!    registers. The types of `zmm` registers are private to [`lanes`](super), those of `ymm` registers to
//!    [`real`](crate::real), which computes with them only if the compilation enables AVX2: other code receives them as
//!    the type argument of [`Kernel::run`](super::Kernel::run). Only [`enter`] calls it with them, after checking that
//!    the machine has the instructions. A value of `routine::Avx2` exists only after the same check.
//! 2. A vector has the memory layout of the array of its lanes, and every bit pattern is a valid number.
#![allow(
    unsafe_code,
    reason = "intrinsics, and functions compiled for an instruction set, are unsafe where it may not exist"
)]

mod enter;
mod registers;
#[cfg(all(
    feature = "std",
    not(debug_assertions),
    not(all(target_feature = "avx2", target_feature = "fma"))
))]
mod routine;

pub(super) use enter::{avx2, avx512};
pub(in crate::real) use registers::{Xmm32, Xmm64};
pub(in crate::real) use registers::{Ymm32, Ymm64};
pub(super) use registers::{Zmm32, Zmm64};
#[cfg(all(
    feature = "std",
    not(debug_assertions),
    not(all(target_feature = "avx2", target_feature = "fma"))
))]
pub(super) use routine::Avx2;

//! Loops over states, and the results on which the next state depends.

use std::ffi::c_long;
use std::hint::black_box;

use nalgebra::{SMatrix, SVector};

use crate::cheap::Cheap;

/// Factor of the previous result in the next state: the sum is the state itself, but no compiler knows it. The same
/// as in `peers/candidate.py`.
const TINY: f64 = 1e-200;

/// Result of a function.
pub(crate) trait Outcome {
    /// The part that the next state depends on: accelerations, or a position.
    fn values(&self) -> &[f64];

    /// All numbers that the peers compute as well.
    fn flat(&self) -> Vec<f64>;
}

impl<const N: usize> Outcome for SVector<f64, N> {
    fn values(&self) -> &[f64] {
        // there may be one position more than rates
        &self.as_slice()[N.div_ceil(2)..]
    }

    fn flat(&self) -> Vec<f64> {
        self.values().to_vec()
    }
}

impl<const N: usize> Outcome for (SVector<f64, N>, SMatrix<f64, N, N>) {
    fn values(&self) -> &[f64] {
        self.0.values()
    }

    /// Of the Jacobian the lower half, column by column: derivatives of the accelerations by coordinates and rates.
    fn flat(&self) -> Vec<f64> {
        let lower = self.1.rows(N / 2, N / 2);
        self.values().iter().chain(lower.iter()).copied().collect()
    }
}

impl Outcome for (SVector<f64, 3>, SMatrix<f64, 3, 6>) {
    fn values(&self) -> &[f64] {
        self.0.as_slice()
    }

    fn flat(&self) -> Vec<f64> {
        [self.0.as_slice(), self.1.as_slice()].concat()
    }
}

/// # Safety
/// `states` points to `count` states.
#[allow(unsafe_code, reason = "called from another library")]
pub(crate) unsafe fn given<'a, const N: usize>(states: *const f64, count: c_long) -> &'a [[f64; N]] {
    // SAFETY: guaranteed by the caller.
    unsafe { std::slice::from_raw_parts(states.cast(), count as usize) }
}

/// Evaluates states that do not depend on each other, and writes the last result.
///
/// # Safety
/// `out` points to room for a result.
#[allow(unsafe_code, reason = "called from another library")]
#[inline(always)]
pub(crate) unsafe fn beside<const N: usize, R: Outcome>(
    states: &[[f64; N]],
    out: *mut f64,
    function: impl Fn(&SVector<f64, N>) -> R,
) {
    for (n, x) in states.iter().enumerate() {
        let result = function(&SVector::from(*x));
        // A reference, since the value would be copied.
        black_box(&result);
        if n + 1 == states.len() {
            // SAFETY: guaranteed by the caller.
            unsafe { write(&result, out) };
        }
    }
}

/// Evaluates states each of which depends on the previous result, and writes the last result.
///
/// # Safety
/// `out` points to room for a result.
#[allow(unsafe_code, reason = "called from another library")]
#[inline(always)]
pub(crate) unsafe fn after<const N: usize, R: Outcome>(
    states: &[[f64; N]],
    out: *mut f64,
    function: impl Fn(&SVector<f64, N>) -> R,
) {
    let mut before = [0.0; N];
    for (n, x) in states.iter().enumerate() {
        let result = function(&SVector::from_fn(|i, _| x[i] + TINY * before[i]));
        black_box(&result);
        let values = result.values();
        for (i, before) in before.iter_mut().enumerate() {
            // One number at a time, as in C: wide loads of numbers that were stored one by one would stall.
            // SAFETY: a reference is valid.
            *before = unsafe { std::ptr::read_volatile(&values[i % values.len()]) };
        }
        if n + 1 == states.len() {
            // SAFETY: guaranteed by the caller.
            unsafe { write(&result, out) };
        }
    }
}

/// Evaluates states that do not depend on each other, with cheap sines and cosines.
#[inline(always)]
pub(crate) fn cheap<const N: usize, R>(states: &[[f64; N]], function: impl Fn(&SVector<Cheap, N>) -> R) {
    for x in states {
        black_box(&function(&SVector::from(x.map(Cheap))));
    }
}

/// # Safety
/// `out` points to room for the result.
#[allow(unsafe_code, reason = "called from another library")]
#[cold]
#[inline(never)]
unsafe fn write(result: &impl Outcome, out: *mut f64) {
    let flat = result.flat();
    // SAFETY: guaranteed by the caller.
    unsafe { out.copy_from_nonoverlapping(flat.as_ptr(), flat.len()) };
}

//! Loops over states, and the results on which the next state depends.

use std::ffi::c_long;
use std::hint::black_box;
use std::marker::PhantomData;

use nalgebra::{SMatrix, SVector};
use pendulum_core::batch::{self, StateFunction};
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::Routine;
use pendulum_core::real::{Float, Real};
use pendulum_core::{Cast, CastJacobian};

use crate::cheap::Cheap;

/// Factor of the previous result in the next state: the sum is the state itself, but no compiler knows it. The same
/// as in `peers/candidate.py`.
const TINY: f64 = 1e-200;

/// Result of a function in numbers `T`.
pub(crate) trait Outcome<T> {
    /// The part that the next state depends on: accelerations, or a position.
    fn values(&self) -> &[T];

    /// All numbers that the peers compute as well.
    fn flat(&self) -> Vec<T>;
}

impl<T: Float, const N: usize> Outcome<T> for SVector<T, N> {
    fn values(&self) -> &[T] {
        // there may be one position more than rates
        &self.as_slice()[N.div_ceil(2)..]
    }

    fn flat(&self) -> Vec<T> {
        self.values().to_vec()
    }
}

impl<T: Float, const N: usize> Outcome<T> for (SVector<T, N>, SMatrix<T, N, N>) {
    fn values(&self) -> &[T] {
        self.0.values()
    }

    /// Of the Jacobian the lower half, column by column: derivatives of the accelerations by coordinates and rates.
    fn flat(&self) -> Vec<T> {
        let lower = self.1.rows(N / 2, N / 2);
        self.values().iter().chain(lower.iter()).copied().collect()
    }
}

impl<T: Float> Outcome<T> for (SVector<T, 3>, SMatrix<T, 3, 6>) {
    fn values(&self) -> &[T] {
        self.0.as_slice()
    }

    fn flat(&self) -> Vec<T> {
        [self.0.as_slice(), self.1.as_slice()].concat()
    }
}

/// A function of a model at a state, in numbers `T`.
pub(crate) trait Function<T, const N: usize> {
    type Outcome;

    fn at(&self, x: &SVector<T, N>) -> Self::Outcome;
}

/// Right-hand side of a model.
pub(crate) struct Rhs<M>(pub M);

impl<T: Real, const N: usize, M: System<T, N>> Function<T, N> for Rhs<M> {
    type Outcome = SVector<T, N>;

    #[inline(always)]
    fn at(&self, x: &SVector<T, N>) -> Self::Outcome {
        self.0.rhs(T::default(), x)
    }
}

/// Right-hand side of a model with its Jacobian.
pub(crate) struct Both<M>(pub M);

impl<T: Real, const N: usize, M: Jacobian<T, N>> Function<T, N> for Both<M> {
    type Outcome = (SVector<T, N>, SMatrix<T, N, N>);

    #[inline(always)]
    fn at(&self, x: &SVector<T, N>) -> Self::Outcome {
        self.0.rhs_and_jacobian(T::default(), x)
    }
}

/// Evaluates states that do not depend on each other, and writes the last result.
pub(crate) struct Beside<F>(pub F);

/// Evaluates states each of which depends on the previous result, and writes the last result.
pub(crate) struct After<F>(pub F);

/// States, and room for a result.
pub(crate) type Given<'a, const N: usize> = (&'a [[f64; N]], *mut f64);

/// # Safety
/// `states` points to `count` states, and `out` to room for a result.
#[allow(unsafe_code, reason = "called from another library")]
pub(crate) unsafe fn given<'a, const N: usize>(states: *const f64, out: *mut f64, count: c_long) -> Given<'a, N> {
    // SAFETY: guaranteed by the caller.
    let states = unsafe { std::slice::from_raw_parts(states.cast(), count as usize) };
    (states, out)
}

impl<T, F, const N: usize> Routine<PhantomData<T>, Given<'_, N>> for Beside<F>
where
    T: Float,
    F: Function<T, N, Outcome: Outcome<T>>,
{
    type Output = ();

    #[inline(always)]
    fn run(self, _: &mut PhantomData<T>, &(states, out): &Given<'_, N>) {
        for (n, x) in states.iter().enumerate() {
            let result = self.0.at(&SVector::from(x.map(T::from_f64)));
            // A reference, since the value would be copied.
            black_box(&result);
            if n + 1 == states.len() {
                write(&result, out);
            }
        }
    }
}

impl<T, F, const N: usize> Routine<PhantomData<T>, Given<'_, N>> for After<F>
where
    T: Float,
    F: Function<T, N, Outcome: Outcome<T>>,
{
    type Output = ();

    #[inline(always)]
    #[allow(unsafe_code, reason = "volatile reads")]
    fn run(self, _: &mut PhantomData<T>, &(states, out): &Given<'_, N>) {
        let mut before = [0.0; N];
        for (n, x) in states.iter().enumerate() {
            let result = self
                .0
                .at(&SVector::from_fn(|i, _| T::from_f64(x[i] + TINY * before[i])));
            black_box(&result);
            let values = result.values();
            for (i, before) in before.iter_mut().enumerate() {
                // One number at a time, as in C: wide loads of numbers that were stored one by one would stall.
                // SAFETY: a reference is valid.
                *before = unsafe { std::ptr::read_volatile(&values[i % values.len()]) }.to_f64();
            }
            if n + 1 == states.len() {
                write(&result, out);
            }
        }
    }
}

/// Accelerations, of which a result has as many as there are rows.
pub(crate) struct Rates;

impl<M: Cast<N>, const N: usize, const R: usize> StateFunction<M, N, R> for Rates {
    #[inline(always)]
    fn value<T: Real>(&self, model: &M::In<T>, t: T, x: &SVector<T, N>) -> SVector<T, R> {
        let rates = model.rhs(t, x);
        SVector::from_fn(|i, _| rates[N - R + i])
    }
}

/// Accelerations, and columns of their derivatives.
pub(crate) struct RatesAndJacobian;

impl<M: CastJacobian<N>, const N: usize, const R: usize, const C: usize> StateFunction<M, N, R, C>
    for RatesAndJacobian
{
    #[inline(always)]
    fn value<T: Real>(&self, model: &M::In<T>, t: T, x: &SVector<T, N>) -> SMatrix<T, R, C> {
        let (rates, jacobian) = M::with_jacobian(model).rhs_and_jacobian(t, x);
        SMatrix::from_fn(|i, j| match j {
            0 => rates[N - R + i],
            _ => jacobian[(N - R + i, j - 1)],
        })
    }
}

/// Number of states of a batch: its results stay in the cache, as those of evaluations alone do.
const BATCH: usize = 32;

/// Evaluates states in batches, and writes the last result.
#[allow(unsafe_code, reason = "vectors are arrays, and the results go to another library")]
pub(crate) fn batch<F, M, const N: usize, const R: usize, const C: usize>(
    function: &F,
    model: &M,
    (states, out): Given<'_, N>,
) where
    F: StateFunction<M, N, R, C>,
    M: Cast<N> + Clone,
{
    // SAFETY: a vector is a column of numbers.
    let states: &[SVector<f64, N>] = unsafe { std::slice::from_raw_parts(states.as_ptr().cast(), states.len()) };
    let mut results = [SMatrix::<f64, R, C>::zeros(); BATCH];
    let models = std::slice::from_ref(model);
    let mut last = 0;
    for states in states.chunks(BATCH) {
        last = states.len() - 1;
        batch::evaluate(function, models, 0.0, states, &mut results[..=last]).expect("one model");
        black_box(&results);
    }
    let last = results[last].as_slice();
    // SAFETY: the pointer is that of `given`.
    unsafe { out.copy_from_nonoverlapping(last.as_ptr(), last.len()) };
}

/// Evaluates states that do not depend on each other, with cheap sines and cosines.
#[inline(always)]
pub(crate) fn cheap<const N: usize>(function: impl Function<Cheap, N>, (states, _): Given<'_, N>) {
    for x in states {
        black_box(&function.at(&SVector::from(x.map(Cheap))));
    }
}

#[allow(unsafe_code, reason = "called from another library, with room for a result")]
#[cold]
#[inline(never)]
fn write<T: Float>(result: &impl Outcome<T>, out: *mut f64) {
    let flat: Vec<f64> = result.flat().into_iter().map(T::to_f64).collect();
    // SAFETY: the pointer is that of `given`.
    unsafe { out.copy_from_nonoverlapping(flat.as_ptr(), flat.len()) };
}

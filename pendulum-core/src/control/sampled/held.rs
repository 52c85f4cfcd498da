//! Inputs that do not change between samples.

use core::cell::Cell;
use core::fmt;

use nalgebra::{SMatrix, SVector};

#[cfg(feature = "std")]
use crate::inputs::{CastControlled, WithInputs};
use crate::inputs::{ControlLaw, LawJacobian};
use crate::real::Real;
use crate::real::lanes::Lanes;
#[cfg(feature = "std")]
use crate::system::{Cast, CastJacobian, Jacobian};

/// The law of `M` inputs that hold their values.
#[derive(Clone, Copy, Debug)]
pub struct Held<T, const M: usize>(pub(in crate::control) [T; M]);

impl<T: Real, const N: usize, const M: usize> ControlLaw<T, N, M> for Held<T, M> {
    #[inline(always)]
    fn inputs(&self, _t: T, _x: &SVector<T, N>) -> [T; M] {
        self.0
    }
}

impl<T: Real, const N: usize, const M: usize> LawJacobian<T, N, M> for Held<T, M> {
    #[inline(always)]
    fn inputs_and_jacobian(&self, _t: T, _x: &SVector<T, N>) -> ([T; M], SMatrix<T, M, N>) {
        (self.0, SMatrix::from_element(T::default()))
    }

    #[inline(always)]
    fn time_derivative(&self, _t: T, _x: &SVector<T, N>) -> SVector<T, M>
    where
        T: Lanes,
    {
        SVector::from_element(T::default())
    }
}

/// The law of `M` inputs that a [`Sampled`](super::Sampled) controller changes: they are [`Held`] in between. A model
/// with it is the system that a method integrates from sample to sample.
///
/// The inputs are behind a reference, so that the parameters of the model are not beside a `Cell`: the compiler would
/// load all of them again after each call.
#[derive(Clone, Copy)]
pub struct Commanded<'c, T, const M: usize>(pub(super) &'c Cell<[T; M]>);

impl<T: Real, const N: usize, const M: usize> ControlLaw<T, N, M> for Commanded<'_, T, M> {
    #[inline(always)]
    fn inputs(&self, _t: T, _x: &SVector<T, N>) -> [T; M] {
        self.0.get()
    }
}

impl<T: Real, const N: usize, const M: usize> LawJacobian<T, N, M> for Commanded<'_, T, M> {
    #[inline(always)]
    fn inputs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> ([T; M], SMatrix<T, M, N>) {
        Held(self.0.get()).inputs_and_jacobian(t, x)
    }

    #[inline(always)]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, M>
    where
        T: Lanes,
    {
        Held(self.0.get()).time_derivative(t, x)
    }
}

impl<T: Copy + fmt::Debug, const M: usize> fmt::Debug for Commanded<'_, T, M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Commanded").field(&self.0.get()).finish()
    }
}

/// A model of an ensemble with the inputs that it holds now.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug)]
pub struct Holding<S, const M: usize> {
    pub(super) system: S,
    pub(super) inputs: [f64; M],
}

#[cfg(feature = "std")]
impl<S: CastControlled<N, M>, const N: usize, const M: usize> Cast<N> for Holding<S, M> {
    const HYBRID: bool = S::HYBRID;

    type In<T: Real> = WithInputs<S::In<T>, Held<T, M>, M>;

    fn cast<T: Real>(&self) -> Self::In<T> {
        WithInputs::of(self.system.cast(), Held(self.inputs.map(T::from_f64)))
    }

    #[inline]
    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Self::In<V>
    where
        Self: 'm,
    {
        let inputs = core::array::from_fn(|m| V::from_fn(|lane| V::Scalar::from_f64(models(lane).inputs[m])));
        WithInputs::of(S::gather(|lane| &models(lane).system), Held(inputs))
    }
}

#[cfg(feature = "std")]
impl<S: CastControlled<N, M>, const N: usize, const M: usize> CastJacobian<N> for Holding<S, M> {
    fn with_jacobian<T: Real>(model: &Self::In<T>) -> &impl Jacobian<T, N> {
        model
    }
}

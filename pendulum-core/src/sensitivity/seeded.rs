//! Models some of whose parameters are variables.

use nalgebra::SVector;

use super::Variable;
use crate::real::Real;
use crate::real::lanes::Lanes;
use crate::system::{Cast, CastJacobian, Jacobian, Parametric};
use crate::taylor::{CastTaylor, TaylorSeries};

/// A model some of whose parameters are variables, in [dual numbers](crate::dual) and lanes of these.
#[derive(Clone, Copy, Debug)]
pub struct Seeded<'m, M, const N: usize, const P: usize, const K: usize> {
    model: &'m M,
    variables: [Variable; K],
}

impl<'m, M, const N: usize, const P: usize, const K: usize> Seeded<'m, M, N, P, K>
where
    M: Parametric<N, P>,
{
    pub(super) fn new(model: &'m M, variables: [Variable; K]) -> Self {
        Self { model, variables }
    }

    fn parameters<T: Real>(&self) -> [T; P] {
        let mut parameters = self.model.parameters().map(T::from_f64);
        for (k, variable) in self.variables.into_iter().enumerate() {
            if let Variable::Parameter(n) = variable {
                parameters[n] = parameters[n].as_variable(k);
            }
        }
        parameters
    }
}

/// # Panics
///
/// If the index of a variable is out of range.
#[track_caller]
pub(super) fn check<const N: usize, const P: usize>(variables: &[Variable]) {
    for variable in variables {
        let (n, count, what) = match *variable {
            Variable::Start(n) => (n, N, "components of the state"),
            Variable::Parameter(n) => (n, P, "parameters"),
        };
        assert!(
            n < count,
            "{variable:?} does not exist: the {what} are counted from 0, and there are {count}"
        );
    }
}

/// An initial condition with its derivatives.
pub(super) fn started<T: Real, const N: usize>(x0: &SVector<f64, N>, variables: &[Variable]) -> SVector<T, N> {
    let mut start = x0.map(T::from_f64);
    for (k, variable) in variables.iter().enumerate() {
        if let Variable::Start(n) = *variable {
            start[n] = start[n].as_variable(k);
        }
    }
    start
}

impl<M, const N: usize, const P: usize, const K: usize> Cast<N> for Seeded<'_, M, N, P, K>
where
    M: Parametric<N, P>,
{
    const HYBRID: bool = M::HYBRID;

    type In<T: Real> = M::In<T>;

    fn cast<T: Real>(&self) -> M::In<T> {
        self.model.with_parameters(self.parameters())
    }

    #[inline]
    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> M::In<V>
    where
        Self: 'm,
    {
        let mut parameters = [V::default(); P];
        for (n, parameter) in parameters.iter_mut().enumerate() {
            *parameter = V::from_fn(|lane| models(lane).parameters::<V::Scalar>()[n]);
        }
        models(0).model.with_parameters(parameters)
    }

    fn shares_lanes(&self, other: &Self) -> bool {
        let fits = |a: &M, b: &M| a.shares_lanes(b) && a.differs_in_parameters(b);
        self.variables == other.variables && fits(self.model, other.model)
    }
}

impl<M, const N: usize, const P: usize, const K: usize> CastJacobian<N> for Seeded<'_, M, N, P, K>
where
    M: Parametric<N, P> + CastJacobian<N> + 'static,
{
    #[inline]
    fn with_jacobian<T: Real>(model: &M::In<T>) -> &impl Jacobian<T, N> {
        M::with_jacobian(model)
    }
}

impl<M, const N: usize, const P: usize, const K: usize> CastTaylor<N> for Seeded<'_, M, N, P, K>
where
    M: Parametric<N, P> + CastTaylor<N> + 'static,
{
    type Workspace<T: Real> = M::Workspace<T>;

    #[inline]
    fn with_series<T: Real>(model: &M::In<T>) -> &impl TaylorSeries<T, N, Workspace = Self::Workspace<T>> {
        M::with_series(model)
    }
}

//! Operations of the functions of a model.

use std::hint::black_box;

use nalgebra::SVector;
use pendulum_core::taylor::MAX_ORDER;
use pendulum_core::{Cast, Jacobian, System, TaylorSeries};
use testbed::counted::{Counted, spent};

/// Additions and multiplications of one call of each function, which the emitted C has as well.
#[derive(Clone, Copy, Debug)]
pub struct Flops {
    pub rhs: usize,
    /// Jacobian together with the right-hand side.
    pub jacobian: usize,
    /// Our series of each order.
    pub series: [usize; MAX_ORDER + 1],
}

impl Flops {
    pub(crate) fn count<S, const N: usize>(model: &S, x: &SVector<f64, N>) -> Self
    where
        S: Cast<N>,
        S::In<Counted>: Jacobian<Counted, N> + TaylorSeries<Counted, N>,
    {
        let (model, t, x) = (model.cast::<Counted>(), Counted(0.0), x.map(Counted));
        let mut work = model.workspace();
        let of = |call: &dyn Fn()| spent(call).flops();
        let series = |order: usize| {
            let mut x = [x; MAX_ORDER + 1];
            spent(|| model.series(t, &mut x[..=order], &mut work)).flops()
        };
        Self {
            rhs: of(&|| _ = black_box(model.rhs(t, &x))),
            jacobian: of(&|| _ = black_box(model.rhs_and_jacobian(t, &x))),
            series: std::array::from_fn(series),
        }
    }

    /// Operations of all calls of a trajectory.
    #[must_use]
    pub fn of(&self, evaluations: usize, jacobians: usize) -> f64 {
        (evaluations * self.rhs + jacobians * self.jacobian) as f64
    }
}

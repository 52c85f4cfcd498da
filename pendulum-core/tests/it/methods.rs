//! Test systems for every method, and lists of methods.

use pendulum_core::prelude::*;
use pendulum_core::{Canonical, TaylorSeries};

/// `x' = u(t, x)` with the derivative `a` of `u` with respect to `x`; canonical with states as momenta.
///
/// Its power series treats the drive as constant, as generated series do with `signum`.
pub(crate) struct Driven<U, const N: usize> {
    pub(crate) u: U,
    pub(crate) a: SMatrix<f64, N, N>,
}

impl<U: Fn(f64, &SVector<f64, N>) -> SVector<f64, N>, const N: usize> Driven<U, N> {
    pub(crate) fn new(a: SMatrix<f64, N, N>, u: U) -> Self {
        Self { u, a }
    }
}

impl<U: Fn(f64, &SVector<f64, N>) -> SVector<f64, N>, const N: usize> System<f64, N> for Driven<U, N> {
    fn rhs(&self, t: f64, x: &SVector<f64, N>) -> SVector<f64, N> {
        (self.u)(t, x)
    }
}

impl<U: Fn(f64, &SVector<f64, N>) -> SVector<f64, N>, const N: usize> Jacobian<f64, N> for Driven<U, N> {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        self.a
    }
}

impl<U: Fn(f64, &SVector<f64, N>) -> SVector<f64, N>, const N: usize> Canonical<f64, N> for Driven<U, N> {
    fn canonical(&self, t: f64, x: &SVector<f64, N>) -> (SVector<f64, N>, SVector<f64, N>) {
        (*x, self.rhs(t, x))
    }

    fn canonical_jacobian(&self, _t: f64, _x: &SVector<f64, N>) -> (SMatrix<f64, N, N>, SMatrix<f64, N, N>) {
        (SMatrix::identity(), self.a)
    }
}

impl<U: Fn(f64, &SVector<f64, N>) -> SVector<f64, N>, const N: usize> TaylorSeries<f64, N> for Driven<U, N> {
    type Workspace = ();

    fn workspace(&self) {}

    fn series(&self, t: f64, x: &mut [SVector<f64, N>], _work: &mut ()) {
        x[1] = self.rhs(t, &x[0]);
        for k in 1..x.len() - 1 {
            x[k + 1] = self.a * x[k] / (k as f64 + 1.0);
        }
    }
}

/// Calls a function, generic in the family, for each family of adaptive methods.
macro_rules! each_adaptive {
    ($check:ident($($argument:expr),*)) => {{
        use pendulum_core::method::{Explicit, PowerSeries, RadauIIA, Rosenbrock, Switching};
        use pendulum_core::tableau;
        $check::<Explicit<tableau::DormandPrince5, 7>>("Rk45", $($argument),*);
        $check::<Explicit<tableau::Tsitouras5, 7>>("Tsit5", $($argument),*);
        $check::<Explicit<tableau::Verner7, 11>>("Vern7", $($argument),*);
        $check::<Explicit<tableau::Verner9, 17>>("Vern9", $($argument),*);
        $check::<Rosenbrock<tableau::HairerWanner4, 6>>("Rodas4", $($argument),*);
        $check::<Rosenbrock<tableau::Steinebach5, 8>>("Rodas5P", $($argument),*);
        $check::<RadauIIA>("Radau5", $($argument),*);
        $check::<RadauIIA<5, 2>>("Radau9", $($argument),*);
        $check::<RadauIIA<7, 3>>("Radau13", $($argument),*);
        $check::<Switching>("Auto", $($argument),*);
        $check::<PowerSeries>("Taylor", $($argument),*);
    }};
}

/// Calls a function, generic in the family, for each family of fixed-step methods.
macro_rules! each_fixed {
    ($check:ident($($argument:expr),*)) => {{
        use pendulum_core::method::{Explicit, Gauss};
        $check::<Explicit<pendulum_core::tableau::Kutta4, 5>>("Rk4", $($argument),*);
        $check::<Gauss<2>>("Gauss4", $($argument),*);
        $check::<Gauss<3>>("Gauss6", $($argument),*);
        $check::<Gauss<8, 4>>("Gauss16", $($argument),*);
    }};
}

pub(crate) use {each_adaptive, each_fixed};

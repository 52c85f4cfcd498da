//! Sums over the stages of a step, in a form that compilers unroll and inline.

use nalgebra::{SMatrix, SVector};

use crate::real::Real;
use crate::real::lanes::Routine;
use crate::system::{Canonical, System};

/// Number of states, two bodies, up to which a right-hand side takes few operations, most of which wait for one
/// another.
pub(crate) const SHORT: usize = 4;

/// A system whose functions are long: they are called, compiled for the instruction set.
pub(crate) struct Called<'a, S: ?Sized>(pub(crate) &'a S);

impl<S: System<T, N> + ?Sized, T: Real, const N: usize> System<T, N> for Called<'_, S> {
    #[inline(always)]
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        if self.0.is_apart() {
            return self.0.rhs(t, x);
        }
        T::call(Evaluation { t, x }, &mut (), self.0)
    }

    #[inline(always)]
    fn active(&self) -> usize {
        self.0.active()
    }
}

impl<S: Canonical<T, N> + ?Sized, T: Real, const N: usize> Canonical<T, N> for Called<'_, S> {
    #[inline(always)]
    fn canonical(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SVector<T, N>) {
        T::call(CanonicalEvaluation { t, x }, &mut (), self.0)
    }

    #[inline(always)]
    fn canonical_jacobian(&self, t: T, x: &SVector<T, N>) -> (SMatrix<T, N, N>, SMatrix<T, N, N>) {
        T::call(CanonicalDerivatives { t, x }, &mut (), self.0)
    }
}

/// Routines that evaluate a function of a system.
macro_rules! evaluations {
    ($($(#[$doc:meta])* $name:ident = $trait:ident::$function:ident -> $output:ty;)*) => { $(
        $(#[$doc])*
        struct $name<'a, T, const N: usize> {
            t: T,
            x: &'a SVector<T, N>,
        }

        impl<S: $trait<T, N> + ?Sized, T: Real, const N: usize> Routine<(), S> for $name<'_, T, N> {
            type Output = $output;

            #[inline(always)]
            fn run(self, (): &mut (), system: &S) -> $output {
                system.$function(self.t, self.x)
            }
        }
    )* };
}

evaluations! {
    /// Evaluation of a right-hand side.
    Evaluation = System::rhs -> SVector<T, N>;
    /// Evaluation of canonical variables and their rates.
    CanonicalEvaluation = Canonical::canonical -> (SVector<T, N>, SVector<T, N>);
    /// Evaluation of their derivatives.
    CanonicalDerivatives = Canonical::canonical_jacobian -> (SMatrix<T, N, N>, SMatrix<T, N, N>);
}

/// `x + change` in a loop over the components; see [`weighted_sum`].
#[inline(always)]
pub(crate) fn shifted<T: Real, const N: usize>(x: &SVector<T, N>, change: &SVector<T, N>) -> SVector<T, N> {
    let mut sum = *x;
    for (sum, change) in sum.data.0[0].iter_mut().zip(&change.data.0[0]) {
        *sum += *change;
    }
    sum
}

/// Computes `sum_(i < count) (h weights_i) stages_i`, skipping zero weights.
///
/// The products `h weights_i` are formed first: once instead of for each component, and off the critical path between
/// stages. Loops over the components replace vector arithmetic, whose functions compilers need not inline: in lanes
/// they must.
#[inline(always)]
pub(crate) fn weighted_sum<T: Real, const STAGES: usize, const N: usize>(
    h: T,
    weights: &[f64; STAGES],
    count: usize,
    stages: &[SVector<T, N>; STAGES],
) -> SVector<T, N> {
    let mut sums = [T::default(); N];
    let mut is_first = true;
    let is_constant = h.is_constant();
    for i in 0..count {
        if weights[i] == 0.0 {
            continue;
        }
        let weight = T::from_f64(weights[i]);
        let weight = if is_constant { weight.scaled(h) } else { h * weight };
        for (component, sum) in sums.iter_mut().enumerate() {
            let stage = stages[i].data.0[0][component];
            *sum = match (is_first, is_constant) {
                (true, true) => stage.scaled(weight),
                (true, false) => weight * stage,
                (false, true) => stage.scaled_onto(weight, *sum),
                (false, false) => weight.mul_add(stage, *sum),
            };
        }
        is_first = false;
    }
    SVector::from(sums)
}

/// Computes `(sum_i weights_i stages_i) factor`, skipping zero weights, over the stages of a step and then over `extra`
/// ones; for weights such as those of dense output, which need no particular order in registers.
#[inline(always)]
pub(crate) fn combination<T: Real, const N: usize>(
    weights: &[f64],
    (stages, extra): (&[SVector<T, N>], &[SVector<T, N>]),
    factor: T,
) -> SVector<T, N> {
    let mut sums = [T::default(); N];
    let (of_stages, of_extra) = weights.split_at(stages.len().min(weights.len()));
    for (weights, stages) in [(of_stages, stages), (of_extra, extra)] {
        for (&weight, stage) in weights.iter().zip(stages) {
            if weight != 0.0 {
                let weight = T::from_f64(weight);
                for (sum, &component) in sums.iter_mut().zip(&stage.data.0[0]) {
                    *sum = component.scaled_onto(weight, *sum);
                }
            }
        }
    }
    for sum in &mut sums {
        *sum *= factor;
    }
    SVector::from(sums)
}

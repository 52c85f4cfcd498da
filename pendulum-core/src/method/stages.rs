//! Sums over the stages of a step, in a form that compilers unroll and inline.

use nalgebra::{SMatrix, SVector};

use crate::real::Real;
use crate::real::lanes::Routine;
use crate::system::{Canonical, System};

/// Number of states, two bodies, up to which a right-hand side takes few operations, most of which wait for one
/// another.
pub(crate) const SHORT: usize = 4;

/// Maximum number of stages of a method whose stages are unrolled.
pub(crate) const MAX_STAGES: usize = 20;

/// A system whose functions are long: they are called, compiled for the instruction set.
pub(crate) struct Called<'a, S: ?Sized>(pub(crate) &'a S);

impl<S: System<T, N> + ?Sized, T: Real, const N: usize> System<T, N> for Called<'_, S> {
    #[inline(always)]
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        if const { T::LANES == 1 } && self.0.is_apart() {
            return self.0.rhs(t, x);
        }
        T::call(Evaluation { t, x }, &mut (), self.0)
    }

    /// Numbers with derivatives are large: they are written in place.
    #[inline(always)]
    fn rhs_into(&self, t: T, x: &SVector<T, N>, rates: &mut SVector<T, N>) {
        if const { T::HAS_SLOPES } && (const { T::LANES > 1 } || !self.0.is_apart()) {
            T::call(EvaluationInto { t, x }, rates, self.0);
        } else {
            *rates = self.rhs(t, x);
        }
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

/// Evaluation of a right-hand side in place.
struct EvaluationInto<'a, T, const N: usize> {
    t: T,
    x: &'a SVector<T, N>,
}

impl<S: System<T, N> + ?Sized, T: Real, const N: usize> Routine<SVector<T, N>, S> for EvaluationInto<'_, T, N> {
    type Output = ();

    #[inline(always)]
    fn run(self, rates: &mut SVector<T, N>, system: &S) {
        system.rhs_into(self.t, self.x, rates);
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

/// Computes `x + sum_(i < count) (h weights_i) stages_i`, skipping zero weights; see [`weighted_sum`].
#[inline(always)]
pub(crate) fn shifted_by_sum<T: Real, const STAGES: usize, const N: usize>(
    (x, h): (&SVector<T, N>, T),
    (weights, count): (&[f64; STAGES], usize),
    stages: &[SVector<T, N>; STAGES],
) -> SVector<T, N> {
    if const { sums_wide::<T, N>() } {
        let mut sum = *x;
        shift_by_sum((x, h), (weights, count), stages, &mut sum);
        return sum;
    }
    shifted(x, &weighted_sum(h, weights, count, stages))
}

/// Writes a [`shifted_by_sum`] to `to`: numbers with derivatives are large, and copies wait for them.
#[inline(always)]
pub(crate) fn shift_by_sum<T: Real, const STAGES: usize, const N: usize>(
    (x, h): (&SVector<T, N>, T),
    (weights, count): (&[f64; STAGES], usize),
    stages: &[SVector<T, N>; STAGES],
    to: &mut SVector<T, N>,
) {
    if const { !sums_wide::<T, N>() } {
        *to = shifted(x, &weighted_sum(h, weights, count, stages));
    } else if h.is_constant() {
        T::sum_stages((h, &weights[..count]), &stages[..count], Some(x), to);
    } else {
        *to = shifted(x, &sum_by_variable_length(&h, weights, count, stages));
    }
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
    if const { T::HAS_SLOPES && T::LANES == 1 } {
        if !h.is_constant() {
            return sum_by_variable_length(&h, weights, count, stages);
        }
        if const { !sums_wide::<T, N>() } {
            return sum_by_component::<false, _, _, _>(h, weights, count, stages);
        }
        let mut sum = SVector::from([T::default(); N]);
        T::sum_stages((h, &weights[..count]), &stages[..count], None, &mut sum);
        return sum;
    }
    if const { is_wide::<T, N>() } {
        return sum_by_component::<false, _, _, _>(h, weights, count, stages);
    }
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

/// True if sums over stages run in a [kernel](Real::sum_stages): it takes longer for the few numbers of a state with up
/// to three derivatives in four components.
pub(crate) const fn sums_wide<T: Real, const N: usize>() -> bool {
    T::SUMS_WIDE && N * size_of::<T>() >= 20 * size_of::<f64>()
}

/// True if a number fills so many vector registers that sums over stages go component by component: each stays in
/// registers, while sums of all components at once are loaded and stored for each stage.
pub(crate) const fn is_wide<T: Real, const N: usize>() -> bool {
    let bytes = size_of::<T>();
    T::LANES > 1 && !T::HAS_SLOPES && (bytes > 128 || bytes == 128 && N > SHORT)
}

/// True if compilers load several dual numbers at once, in registers of 512 bits, and permute these to sum all values
/// side by side. Such loads wait for the stores of the stage before: with up to four derivatives, steps then take up to
/// 1.6 times as long.
const fn is_permuted<T: Real>() -> bool {
    cfg!(target_feature = "avx512f") && T::HAS_SLOPES && T::LANES == 1 && size_of::<T>() <= 5 * size_of::<f64>()
}

/// Computes `x + sum_(i < count) (h weights_i) stages_i` into the first `active` components of `to`, one by one.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn shift_by_component<T: Real, const STAGES: usize, const N: usize>(
    (x, h): (&SVector<T, N>, T),
    (weights, count): (&[f64; STAGES], usize),
    stages: &[SVector<T, N>; STAGES],
    (to, active): (&mut SVector<T, N>, usize),
) {
    for n in 0..active {
        to.data.0[0][n] = x.data.0[0][n] + component::<false, _, _, _>(n, h, weights, count, stages);
    }
}

/// Values of the [`weighted_sum`] of dual numbers.
#[inline(always)]
pub(crate) fn sum_of_values<T: Real, const STAGES: usize, const N: usize>(
    h: T,
    weights: &[f64; STAGES],
    stages: &[SVector<T, N>; STAGES],
) -> SVector<T, N> {
    sum_by_component::<true, _, _, _>(h.without_slopes(), weights, STAGES, stages)
}

/// [`weighted_sum`] of wide numbers, and of dual numbers with an `h` without derivatives. With `VALUES` the sum has
/// none, either.
///
/// The sum over the stages is unrolled, and its partial sums fit into the registers. The loop over the components is
/// not: unrolled as well, the sums of a step would not fit into the instruction cache.
#[inline(always)]
fn sum_by_component<const VALUES: bool, T: Real, const STAGES: usize, const N: usize>(
    h: T,
    weights: &[f64; STAGES],
    count: usize,
    stages: &[SVector<T, N>; STAGES],
) -> SVector<T, N> {
    let mut sums = [T::default(); N];
    for (n, sum) in sums.iter_mut().enumerate() {
        let component = component::<VALUES, _, _, _>(n, h, weights, count, stages);
        if const { is_permuted::<T>() } {
            T::put(sum, component);
        } else {
            *sum = component;
        }
    }
    SVector::from(sums)
}

/// Component `n` of a [`weighted_sum`]. Inlining is not forced without optimisation, where its numbers in lanes would
/// take much of the stack.
#[cfg_attr(not(debug_assertions), inline(always))]
fn component<const VALUES: bool, T: Real, const STAGES: usize, const N: usize>(
    n: usize,
    h: T,
    weights: &[f64; STAGES],
    count: usize,
    stages: &[SVector<T, N>; STAGES],
) -> T {
    const { assert!(STAGES <= MAX_STAGES) };
    let of = |number: T| if VALUES { number.without_slopes() } else { number };
    let mut sum = None;
    macro_rules! add {
        ($($i:literal)*) => { $(
            if $i < count && weights[$i % STAGES] != 0.0 {
                let weight = T::from_f64(weights[$i % STAGES]).scaled(h);
                let stage = of(stages[$i % STAGES].data.0[0][n]);
                sum = Some(match sum {
                    None => stage.scaled(weight),
                    Some(sum) => stage.scaled_onto(weight, sum),
                });
            }
        )* };
    }
    add!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19);
    of(sum.unwrap_or_default())
}

/// [`weighted_sum`] with an `h` that carries derivatives, as in the steps to an event. A reference leaves `h` in
/// registers elsewhere.
#[cold]
#[inline(never)]
fn sum_by_variable_length<T: Real, const STAGES: usize, const N: usize>(
    h: &T,
    weights: &[f64; STAGES],
    count: usize,
    stages: &[SVector<T, N>; STAGES],
) -> SVector<T, N> {
    let mut sums: Option<SVector<T, N>> = None;
    for (&weight, stage) in weights[..count].iter().zip(stages) {
        if weight == 0.0 {
            continue;
        }
        let weight = *h * T::from_f64(weight);
        sums = Some(match sums {
            None => stage.map(|stage| weight * stage),
            Some(sums) => sums.zip_map(stage, |sum, stage| weight.mul_add(stage, sum)),
        });
    }
    sums.unwrap_or_else(|| SVector::from([T::default(); N]))
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

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::{shift_by_sum, shifted, sum_by_component, sum_by_variable_length, sum_of_values, weighted_sum};
    use crate::dual::Dual;
    use crate::real::{Float, Fused, Real};

    #[test]
    fn sums_of_dual_numbers_agree_with_each_other_and_with_their_values() {
        let weights = [0.0, 0.3, -1.7, 0.0, 2.1, 0.9];
        let number = |seed: usize| (seed as f64 * 0.7).sin();
        let stages: [SVector<Dual<f64, 5>, 3>; 6] = core::array::from_fn(|i| {
            SVector::from(core::array::from_fn(|n| Dual {
                value: number(20 * i + n),
                slopes: core::array::from_fn(|k| number(20 * i + 5 * n + k + 3)),
            }))
        });
        let (h, values) = (0.13, stages.map(|stage| stage.map(|x| x.value)));
        for count in 0..=6 {
            let sum = sum_by_component::<false, _, _, _>(Dual::constant(h), &weights, count, &stages);
            let other = sum_by_variable_length(&Dual::constant(h), &weights, count, &stages);
            assert_eq!(sum.map(|x| x.slopes), other.map(|x| x.slopes));
            assert_eq!(sum, other);
            assert_eq!(sum.map(|x| x.value), weighted_sum(h, &weights, count, &values));
        }
        let alone = sum_of_values(Dual::constant(h), &weights, &stages);
        assert_eq!(alone.map(|x| x.value), weighted_sum(h, &weights, 6, &values));
        assert_eq!(alone.map(|x| x.slopes), SVector::from([[0.0; 5]; 3]));
    }

    #[test]
    fn sums_in_wide_registers_have_the_bits_of_those_by_component() {
        assert_equal::<f64, 4, 10>();
        assert_equal::<f64, 1, 1>();
        assert_equal::<f64, 3, 6>();
        assert_equal::<f64, 5, 12>();
        assert_equal::<f32, 4, 4>();
        assert_equal::<Fused<f64>, 4, 10>();
        assert_equal::<Fused<f64>, 7, 8>();
    }

    fn assert_equal<F: Float, const M: usize, const K: usize>()
    where
        Dual<F, K>: Float,
    {
        let number = |seed: usize| F::from_f64((seed as f64 * 0.7).sin());
        let vector = |seed: usize| -> SVector<Dual<F, K>, M> {
            SVector::from(core::array::from_fn(|m| Dual {
                value: number(seed + 30 * m),
                slopes: core::array::from_fn(|k| number(seed + 30 * m + k + 1)),
            }))
        };
        let weights = [0.0, 0.3, -1.7, 0.0, 2.1, 0.9];
        let (h, x) = (Dual::constant(F::from_f64(0.13)), vector(7));
        let stages: [_; 6] = core::array::from_fn(|i| vector(400 * i + 20));
        let bits = |of: SVector<Dual<F, K>, M>| {
            of.map(|number| {
                (
                    number.value.to_f64().to_bits(),
                    number.slopes.map(|slope| slope.to_f64().to_bits()),
                )
            })
        };
        for count in 0..=6 {
            let expected = sum_by_component::<false, _, _, _>(h, &weights, count, &stages);
            let (given, mut sum) = ((h, &weights[..count]), x);
            Dual::sum_stages(given, &stages[..count], None, &mut sum);
            assert_eq!(bits(sum), bits(expected), "{count} stages");
            Dual::sum_stages(given, &stages[..count], Some(&x), &mut sum);
            assert_eq!(bits(sum), bits(shifted(&x, &expected)), "{count} stages after a start");
            let varied = Dual::variable(h.value, 0);
            shift_by_sum((&x, varied), (&weights, count), &stages, &mut sum);
            let expected = shifted(&x, &sum_by_variable_length(&varied, &weights, count, &stages));
            assert_eq!(bits(sum), bits(expected), "{count} stages of variable length");
        }
    }
}

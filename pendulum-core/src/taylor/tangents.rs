//! Power series of motions in dual numbers, by those of the linearized equations of motion.
//!
//! The values are a series in plain numbers. The derivatives are tangents: linear equations, whose coefficients are
//! series in plain numbers, too, give those of each order from those of all lower orders. These equations are the same
//! for all tangents, which fill vector registers.

use core::marker::PhantomData;

use nalgebra::SVector;

use super::{MAX_ORDER, Newest, Products, TaylorSeries};
use crate::dual::Dual;
use crate::real::Real;
use crate::real::lanes::{Lanes, WideKernel};

/// Equations of motion `r = 0` of a generated model without constraints and first-order states, and their derivatives,
/// the entries.
///
/// There are `R` equations, `C` constants, `E` entries that are multiplied by tangents of the `N` components of the
/// state and of the `R` accelerations, `F` entries by tangents of constants, `K` values that all orders read, and `M`
/// products of series.
#[doc(hidden)]
pub trait Linearized<
    const N: usize,
    const R: usize,
    const C: usize,
    const E: usize,
    const F: usize,
    const K: usize,
    const M: usize,
>
{
    /// Parameters of the model.
    type Parameters;

    /// Builds the model in another number type, with these constants.
    fn with_constants<T: Real>(params: &Self::Parameters, constants: [T; C]) -> impl TaylorSeries<T, N>;

    /// Computes the entries and kept values of order 0.
    fn start<T: Real>(constants: &[T; C], x: &SVector<T, N>, accelerations: &[T; R]) -> ([T; E], [T; F], [T; K]);

    /// Computes the entries of order `k`, and the factors of the products, given `k` and its reciprocal, the interior
    /// sums of the products, and the coefficients of the state and the accelerations.
    fn order<T: Real>(
        constants: &[T; C],
        kept: &[T; K],
        orders: [T; 2],
        sums: &[T; M],
        x: &SVector<T, N>,
        accelerations: &[T; R],
    ) -> ([T; E], [T; F], [[T; M]; 2]);

    /// Adds the products of entries with tangents of the state and of the accelerations, for each equation.
    fn terms<T: Real>(entries: &[T; E], of_state: &[T; N], of_accelerations: &[T; R]) -> [T; R];

    /// Computes the tangents of the accelerations of an order, given its entries by constants, the sums of all
    /// [`terms`](Self::terms) of this order, and the tangents of the state and of the constants.
    fn step<T: Real>(
        constants: &[T; C],
        kept: &[T; K],
        by_constants: &[T; F],
        sums: &[T; R],
        of_state: &[T; N],
        of_constants: &[T; C],
    ) -> [T; R];
}

/// Code that takes dual numbers apart.
///
/// The trait is public because it bounds a public method.
pub trait DualKernel<T> {
    /// Runs the code, given `T` as a dual number.
    fn run<U: Real, const P: usize>(
        self,
        of: impl Fn(&T) -> &Dual<U, P> + Copy,
        of_mut: impl Fn(&mut T) -> &mut Dual<U, P> + Copy,
    );
}

/// Computes [`TaylorSeries::series`] of a model in [numbers that are taken apart](Real::take_apart).
#[doc(hidden)]
#[inline(always)]
pub fn series_by_tangents<
    S: Linearized<N, R, C, E, F, K, M>,
    T: Real,
    const N: usize,
    const R: usize,
    const C: usize,
    const E: usize,
    const F: usize,
    const K: usize,
    const M: usize,
>(
    params: &S::Parameters,
    constants: &[T; C],
    t: T,
    x: &mut [SVector<T, N>],
) {
    T::take_apart(Motion::<S, T, N, R, C, E, F, K, M> {
        params,
        constants,
        t,
        x,
    });
}

/// A motion in dual numbers.
struct Motion<
    'a,
    S: Linearized<N, R, C, E, F, K, M>,
    T,
    const N: usize,
    const R: usize,
    const C: usize,
    const E: usize,
    const F: usize,
    const K: usize,
    const M: usize,
> {
    params: &'a S::Parameters,
    constants: &'a [T; C],
    t: T,
    x: &'a mut [SVector<T, N>],
}

impl<
    S: Linearized<N, R, C, E, F, K, M>,
    T: Real,
    const N: usize,
    const R: usize,
    const C: usize,
    const E: usize,
    const F: usize,
    const K: usize,
    const M: usize,
> DualKernel<T> for Motion<'_, S, T, N, R, C, E, F, K, M>
{
    #[inline(always)]
    fn run<U: Real, const P: usize>(
        self,
        of: impl Fn(&T) -> &Dual<U, P> + Copy,
        of_mut: impl Fn(&mut T) -> &mut Dual<U, P> + Copy,
    ) {
        let Self {
            params,
            constants: duals,
            t,
            x,
        } = self;
        let order = x.len() - 1;
        assert!(order <= MAX_ORDER, "the order of a series is at most {MAX_ORDER}");
        let constants: [U; C] = core::array::from_fn(|n| of(&duals[n]).value);
        let mut values = [SVector::from_element(U::default()); MAX_ORDER + 1];
        values[0] = SVector::from_fn(|n, _| of(&x[0][n]).value);
        let model = S::with_constants(params, constants);
        model.series(of(&t).value, &mut values[..=order], &mut model.workspace());
        for (x, values) in x.iter_mut().zip(&values).skip(1) {
            for (x, value) in x.iter_mut().zip(values) {
                of_mut(x).value = *value;
            }
        }
        let accelerations = |k: usize| -> [U; R] {
            let factor = U::from_f64((k + 1) as f64);
            core::array::from_fn(|n| factor * values[k + 1][N - R + n])
        };
        let (mut entries, mut by_constants) = ([[U::default(); E]; MAX_ORDER], [[U::default(); F]; MAX_ORDER]);
        let (of_motion, of_constants, kept) = S::start(&constants, &values[0], &accelerations(0));
        (entries[0], by_constants[0]) = (of_motion, of_constants);
        let (mut products, mut newest) = (Products::<U, M>::new(), Newest::new());
        for k in 1..order {
            let sums = newest.add(products.sums(k));
            let orders = [k as f64, 1.0 / k as f64].map(U::from_f64);
            let (of_motion, of_constants, [left, right]) =
                S::order(&constants, &kept, orders, &sums, &values[k], &accelerations(k));
            (entries[k], by_constants[k]) = (of_motion, of_constants);
            newest.push(k, left, right);
            products.set(k, left, right);
        }
        let mut tangents = Tangents::<S, T, U, _, _, N, R, C, E, F, K, M, P> {
            constants: &constants,
            duals,
            kept: &kept,
            entries: &entries,
            by_constants: &by_constants,
            x,
            of,
            of_mut,
            system: PhantomData,
        };
        if const { U::LANES == 1 } {
            U::run_wide(tangents);
        } else {
            let start = tangents.groups::<Alone, BLOCK>(0);
            tangents.groups::<Alone, 1>(start);
        }
    }
}

/// Derivatives in `U` that are computed side by side.
trait Beside<U> {
    /// Number type for all of them.
    type All: Real;

    /// Number of derivatives.
    const WIDTH: usize;

    /// Repeats a number for each of them.
    fn splat(number: U) -> Self::All;

    /// Loads the derivatives from the number `start` on.
    fn load(slopes: &[U], start: usize) -> Self::All;

    /// Stores the derivatives from the number `start` on.
    fn store(all: Self::All, slopes: &mut [U], start: usize);
}

/// A single derivative.
struct Alone;

impl<U: Real> Beside<U> for Alone {
    type All = U;
    const WIDTH: usize = 1;

    #[inline(always)]
    fn splat(number: U) -> U {
        number
    }

    #[inline(always)]
    fn load(slopes: &[U], start: usize) -> U {
        slopes[start]
    }

    #[inline(always)]
    fn store(all: U, slopes: &mut [U], start: usize) {
        slopes[start] = all;
    }
}

/// As many derivatives as fill lanes `V`.
struct InLanes<V>(PhantomData<V>);

impl<V: Lanes> Beside<V::Scalar> for InLanes<V> {
    type All = V;
    const WIDTH: usize = V::LANES;

    #[inline(always)]
    fn splat(number: V::Scalar) -> V {
        V::splat(number)
    }

    #[inline(always)]
    fn load(slopes: &[V::Scalar], start: usize) -> V {
        V::from_fn(|lane| slopes[start + lane])
    }

    #[inline(always)]
    fn store(all: V, slopes: &mut [V::Scalar], start: usize) {
        for lane in 0..V::LANES {
            slopes[start + lane] = all.lane(lane);
        }
    }
}

/// The tangents of a motion.
struct Tangents<
    'a,
    S,
    T,
    U,
    Of,
    OfMut,
    const N: usize,
    const R: usize,
    const C: usize,
    const E: usize,
    const F: usize,
    const K: usize,
    const M: usize,
    const P: usize,
> {
    constants: &'a [U; C],
    duals: &'a [T; C],
    kept: &'a [U; K],
    entries: &'a [[U; E]; MAX_ORDER],
    by_constants: &'a [[U; F]; MAX_ORDER],
    x: &'a mut [SVector<T, N>],
    of: Of,
    of_mut: OfMut,
    system: PhantomData<S>,
}

impl<
    S: Linearized<N, R, C, E, F, K, M>,
    T,
    U: Real,
    Of: Fn(&T) -> &Dual<U, P>,
    OfMut: Fn(&mut T) -> &mut Dual<U, P>,
    const N: usize,
    const R: usize,
    const C: usize,
    const E: usize,
    const F: usize,
    const K: usize,
    const M: usize,
    const P: usize,
> Tangents<'_, S, T, U, Of, OfMut, N, R, C, E, F, K, M, P>
{
    /// Computes as many tangents from the number `start` on as fill `G` registers at a time, and returns the next
    /// number.
    #[inline(always)]
    fn groups<V: Beside<U>, const G: usize>(&mut self, mut start: usize) -> usize {
        while start + G * V::WIDTH <= P {
            self.group::<V, G>(start);
            start += G * V::WIDTH;
        }
        start
    }

    /// Computes the tangents from the number `start` on that fill `G` registers.
    #[inline(always)]
    fn group<V: Beside<U>, const G: usize>(&mut self, start: usize) {
        let load = |x: &T, g: usize| V::load(&(self.of)(x).slopes, start + g * V::WIDTH);
        let of_constants: [[V::All; C]; G] =
            core::array::from_fn(|g| core::array::from_fn(|n| load(&self.duals[n], g)));
        let (constants, kept) = (self.constants.map(V::splat), self.kept.map(V::splat));
        let mut accelerations = [[[V::All::default(); R]; G]; MAX_ORDER];
        for k in 0..self.x.len() - 1 {
            let mut sums = [[V::All::default(); R]; G];
            // the tangents of the accelerations of this order are zero so far
            let lower = self.x[..=k].iter().zip(&accelerations[..=k]).rev();
            for (entries, (x, accelerations)) in self.entries.iter().zip(lower) {
                let entries = entries.map(V::splat);
                for g in 0..G {
                    let of_state: [V::All; N] = core::array::from_fn(|n| load(&x[n], g));
                    let terms = S::terms(&entries, &of_state, &accelerations[g]);
                    for n in 0..R {
                        sums[g][n] += terms[n];
                    }
                }
            }
            let by_constants = self.by_constants[k].map(V::splat);
            let over = V::All::from_f64(1.0 / (k + 1) as f64);
            for g in 0..G {
                let of_state: [V::All; N] = core::array::from_fn(|n| load(&self.x[k][n], g));
                let solved = S::step(&constants, &kept, &by_constants, &sums[g], &of_state, &of_constants[g]);
                accelerations[k][g] = solved;
                let rates = of_state[N - R..].iter().chain(&solved);
                for (x, &rate) in self.x[k + 1].iter_mut().zip(rates) {
                    V::store(rate * over, &mut (self.of_mut)(x).slopes, start + g * V::WIDTH);
                }
            }
        }
    }
}

/// Number of registers of tangents computed side by side: few enough that their sums stay in registers.
const BLOCK: usize = 2;

impl<
    S: Linearized<N, R, C, E, F, K, M>,
    T,
    U,
    Of: Fn(&T) -> &Dual<U, P>,
    OfMut: Fn(&mut T) -> &mut Dual<U, P>,
    const N: usize,
    const R: usize,
    const C: usize,
    const E: usize,
    const F: usize,
    const K: usize,
    const M: usize,
    const P: usize,
> WideKernel<U> for Tangents<'_, S, T, U, Of, OfMut, N, R, C, E, F, K, M, P>
{
    #[inline(always)]
    fn run<V, Narrow>(mut self)
    where
        U: Lanes<Scalar = U>,
        V: Lanes<Scalar = U>,
        Narrow: Lanes<Scalar = U>,
    {
        let start = self.groups::<InLanes<V>, BLOCK>(0);
        let start = self.groups::<InLanes<V>, 1>(start);
        let start = self.groups::<InLanes<Narrow>, 1>(start);
        self.groups::<Alone, 1>(start);
    }
}

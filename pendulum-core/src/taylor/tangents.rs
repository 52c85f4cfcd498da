//! Power series of motions in dual numbers, by those of the linearized equations of motion.
//!
//! The values are a series in plain numbers. The derivatives are tangents: linear equations, whose coefficients are
//! series in plain numbers, too, give those of each order from those of all lower orders. These equations are the same
//! for all tangents, which fill vector registers.

use core::marker::PhantomData;

use nalgebra::SVector;

use super::{CastTaylor, MAX_ORDER, Newest, Products, TaylorSeries};
use crate::dual::Dual;
use crate::real::Real;
use crate::real::lanes::{Lanes, WideKernel};

/// Derivatives of `R` equations of motion by coordinates, by rates and by accelerations: a matrix each.
#[doc(hidden)]
pub type Matrices<T, const R: usize> = [[[T; R]; R]; 3];

/// Equations of motion `r = 0` of a generated model without constraints and first-order states, and their derivatives,
/// the entries.
///
/// There are `R` equations, `C` constants, `F` distinct entries by constants, `K` values that all orders read, and `M`
/// products of series. The `N` components of the state are the `R` coordinates and their rates.
#[doc(hidden)]
pub trait Linearized<const N: usize, const R: usize, const C: usize, const F: usize, const K: usize, const M: usize>:
    CastTaylor<N>
{
    /// Parameters of the model.
    type Parameters;

    /// Builds the model in another number type, with these constants.
    fn with_constants<T: Real>(params: &Self::Parameters, constants: [T; C]) -> Self::In<T>;

    /// Computes the entries and kept values of order 0.
    fn start<T: Real>(
        constants: &[T; C],
        x: &SVector<T, N>,
        accelerations: &[T; R],
    ) -> (Matrices<T, R>, [T; F], [T; K]);

    /// Computes the entries of order `k`, and the factors of the products, given the interior sums of the products, the
    /// coefficients of the state and the accelerations, and the factors of the motion.
    fn order<T: Real>(
        constants: &[T; C],
        kept: &[T; K],
        k: usize,
        sums: &[T; M],
        x: &SVector<T, N>,
        accelerations: &[T; R],
        motion: &Self::Workspace<T>,
    ) -> (Matrices<T, R>, [T; F], [[T; M]; 2]);

    /// Computes the tangents of the accelerations of an order, given its entries by constants, the sums of all products
    /// of matrices and tangents of this order without these, and the tangents of the constants.
    fn step<T: Real>(
        constants: &[T; C],
        kept: &[T; K],
        by_constants: &[T; F],
        sums: &[T; R],
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
    S: Linearized<N, R, C, F, K, M>,
    T: Real,
    const N: usize,
    const R: usize,
    const C: usize,
    const F: usize,
    const K: usize,
    const M: usize,
>(
    params: &S::Parameters,
    constants: &[T; C],
    t: T,
    x: &mut [SVector<T, N>],
) {
    T::take_apart(Motion::<S, T, N, R, C, F, K, M> {
        params,
        constants,
        t,
        x,
    });
}

/// A motion in dual numbers.
struct Motion<
    'a,
    S: Linearized<N, R, C, F, K, M>,
    T,
    const N: usize,
    const R: usize,
    const C: usize,
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
    S: Linearized<N, R, C, F, K, M>,
    T: Real,
    const N: usize,
    const R: usize,
    const C: usize,
    const F: usize,
    const K: usize,
    const M: usize,
> DualKernel<T> for Motion<'_, S, T, N, R, C, F, K, M>
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
        let model = S::with_series(&model);
        let mut motion = model.workspace();
        model.series(of(&t).value, &mut values[..=order], &mut motion);
        for (x, values) in x.iter_mut().zip(&values).skip(1) {
            for (x, value) in x.iter_mut().zip(values) {
                of_mut(x).value = *value;
            }
        }
        let tangents = Tangents::<S, T, U, _, _, N, R, C, F, K, M, P> {
            constants: &constants,
            duals,
            values: &values,
            motion: &motion,
            x,
            of,
            of_mut,
        };
        if const { U::LANES == 1 } {
            U::run_wide(tangents);
        } else {
            tangents.orders::<Alone, Alone>();
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
    S: Linearized<N, R, C, F, K, M>,
    T,
    U: Real,
    Of,
    OfMut,
    const N: usize,
    const R: usize,
    const C: usize,
    const F: usize,
    const K: usize,
    const M: usize,
    const P: usize,
> {
    constants: &'a [U; C],
    duals: &'a [T; C],
    values: &'a [SVector<U, N>; MAX_ORDER + 1],
    motion: &'a S::Workspace<U>,
    x: &'a mut [SVector<T, N>],
    of: Of,
    of_mut: OfMut,
}

/// Numbers of one order that all tangents read.
struct Shared<'a, U, const R: usize, const F: usize, const K: usize> {
    order: usize,
    kept: &'a [U; K],
    by_constants: &'a [U; F],
    /// Factors of the coordinates of each order in the equations.
    matrices: &'a [[[U; R]; R]; MAX_ORDER + 1],
}

impl<
    S: Linearized<N, R, C, F, K, M>,
    T,
    U: Real,
    Of: Fn(&T) -> &Dual<U, P>,
    OfMut: Fn(&mut T) -> &mut Dual<U, P>,
    const N: usize,
    const R: usize,
    const C: usize,
    const F: usize,
    const K: usize,
    const M: usize,
    const P: usize,
> Tangents<'_, S, T, U, Of, OfMut, N, R, C, F, K, M, P>
{
    /// Computes all orders, with tangents side by side in `A`, then in `B`, and the last ones alone.
    ///
    /// The derivatives of the equations by rates and by accelerations are multiplied by the powers of the order that
    /// rates and accelerations have beside coordinates: once for all tangents.
    #[inline(always)]
    fn orders<A: Beside<U>, B: Beside<U>>(mut self) {
        let accelerations = |k: usize| {
            let mut accelerations = [U::default(); R];
            for (acceleration, n) in accelerations.iter_mut().zip(N - R..N) {
                *acceleration = U::from_f64((k + 1) as f64) * self.values[k + 1][n];
            }
            accelerations
        };
        let (mut entries, mut by_constants, kept) = S::start(self.constants, &self.values[0], &accelerations(0));
        let (mut products, mut newest) = (Products::<U, M>::new(), Newest::new());
        let zeros = [[U::default(); R]; R];
        // at `n` the matrices by coordinates of order `n - 1`, by rates of order `n`, by accelerations of order `n + 1`
        let mut by_lag = [[zeros; 3]; MAX_ORDER + 1];
        let mut matrices = [zeros; MAX_ORDER + 1];
        let orders = self.x.len() - 1;
        for k in 0..orders {
            (by_lag[k + 1][0], by_lag[k][1]) = (entries[0], entries[1]);
            if k > 0 {
                by_lag[k - 1][2] = entries[2];
            }
            let of_constants = by_constants;
            // before the tangents of this order, which need not wait for them
            if k + 1 < orders {
                let k = k + 1;
                let sums = newest.add(products.sums(k));
                let (values, accelerations) = (&self.values[k], accelerations(k));
                let (of_motion, of_constants, [left, right]) =
                    S::order(self.constants, &kept, k, &sums, values, &accelerations, self.motion);
                (entries, by_constants) = (of_motion, of_constants);
                newest.push(k, left, right);
                products.set(k, left, right);
            }
            for (m, matrix) in matrices[..k + 2].iter_mut().enumerate() {
                let [of_coordinates, of_rates, of_accelerations] = &by_lag[k + 1 - m];
                let parts = [
                    of_coordinates.as_flattened(),
                    of_rates.as_flattened(),
                    of_accelerations.as_flattened(),
                ];
                let (powers, sums) = (POWERS[m].map(U::from_f64), matrix.as_flattened_mut());
                let start = weigh::<U, A>(parts, powers, sums, 0);
                let start = weigh::<U, B>(parts, powers, sums, start);
                weigh::<U, Alone>(parts, powers, sums, start);
            }
            let shared = Shared {
                order: k,
                kept: &kept,
                by_constants: &of_constants,
                matrices: &matrices,
            };
            let start = self.groups::<A, BLOCK>(&shared, 0);
            let start = self.groups::<A, 1>(&shared, start);
            let start = self.groups::<B, 1>(&shared, start);
            self.groups::<Alone, 1>(&shared, start);
        }
    }

    /// Computes as many tangents from the number `start` on as fill `G` registers at a time, and returns the next
    /// number.
    #[inline(always)]
    fn groups<V: Beside<U>, const G: usize>(&mut self, shared: &Shared<'_, U, R, F, K>, mut start: usize) -> usize {
        while start + G * V::WIDTH <= P {
            self.group::<V, G>(shared, start);
            start += G * V::WIDTH;
        }
        start
    }

    /// Computes the tangents from the number `start` on that fill `G` registers.
    #[inline(always)]
    fn group<V: Beside<U>, const G: usize>(&mut self, shared: &Shared<'_, U, R, F, K>, start: usize) {
        let k = shared.order;
        let (lower, newest) = shared.matrices[..k + 2].split_at(k + 1);
        // two parts for each sum, so that an addition need not wait for the one before
        let mut sums = [[[V::All::default(); 2]; R]; G];
        for (matrix, x) in lower.iter().zip(&self.x[..=k]) {
            for c in 0..R {
                for (g, sums) in sums.iter_mut().enumerate() {
                    let tangent = V::load(&(self.of)(&x[c]).slopes, start + g * V::WIDTH);
                    for r in 0..R {
                        sums[r][c % 2] = tangent.mul_add(V::splat(matrix[r][c]), sums[r][c % 2]);
                    }
                }
            }
        }
        let (constants, kept) = (splat::<U, V, _>(self.constants), splat::<U, V, _>(shared.kept));
        let by_constants = splat::<U, V, _>(shared.by_constants);
        let over = V::All::from_f64(1.0 / (k + 1) as f64);
        for (g, sums) in sums.iter().enumerate() {
            let start = start + g * V::WIDTH;
            let mut of_constants = [V::All::default(); C];
            for (of_constant, dual) in of_constants.iter_mut().zip(self.duals) {
                *of_constant = V::load(&(self.of)(dual).slopes, start);
            }
            let mut newer = [V::All::default(); R];
            for (c, n) in (N - R..N).enumerate() {
                let rate = V::load(&(self.of)(&self.x[k][n]).slopes, start);
                let tangent = rate * over;
                V::store(tangent, &mut (self.of_mut)(&mut self.x[k + 1][c]).slopes, start);
                for r in 0..R {
                    newer[r] = tangent.mul_add(V::splat(newest[0][r][c]), newer[r]);
                }
            }
            let mut all = newer;
            for r in 0..R {
                all[r] = (sums[r][0] + sums[r][1]) + newer[r];
            }
            let solved = S::step(&constants, &kept, &by_constants, &all, &of_constants);
            for (&acceleration, n) in solved.iter().zip(N - R..N) {
                V::store(
                    acceleration * over,
                    &mut (self.of_mut)(&mut self.x[k + 1][n]).slopes,
                    start,
                );
            }
        }
    }
}

/// Repeats each number for all tangents side by side. The functions of arrays are calls, compiled for the baseline.
#[inline(always)]
fn splat<U: Real, V: Beside<U>, const L: usize>(numbers: &[U; L]) -> [V::All; L] {
    let mut all = [V::All::default(); L];
    for (all, &number) in all.iter_mut().zip(numbers) {
        *all = V::splat(number);
    }
    all
}

/// Computes as many factors of coordinates from the number `start` on as fill registers, and returns the next number.
/// Without registers, compilers compute those of several orders side by side, and load and store them one by one.
#[inline(always)]
fn weigh<U: Real, V: Beside<U>>(
    [of_coordinates, of_rates, of_accelerations]: [&[U]; 3],
    [once, twice]: [U; 2],
    sums: &mut [U],
    mut start: usize,
) -> usize {
    while start + V::WIDTH <= sums.len() {
        let rates = V::load(of_rates, start);
        let sum = rates.mul_add(V::splat(once), V::load(of_coordinates, start));
        let sum = V::load(of_accelerations, start).mul_add(V::splat(twice), sum);
        V::store(sum, sums, start);
        start += V::WIDTH;
    }
    start
}

/// `m` and `m (m - 1)` for each order `m`.
const POWERS: [[f64; 2]; MAX_ORDER + 1] = {
    let mut powers = [[0.0; 2]; MAX_ORDER + 1];
    let mut m = 0;
    while m <= MAX_ORDER {
        let order = m as f64;
        powers[m] = [order, order * (order - 1.0)];
        m += 1;
    }
    powers
};

/// Number of registers of tangents computed side by side: few enough that their sums stay in registers.
const BLOCK: usize = 2;

impl<
    S: Linearized<N, R, C, F, K, M>,
    T,
    U: Real,
    Of: Fn(&T) -> &Dual<U, P>,
    OfMut: Fn(&mut T) -> &mut Dual<U, P>,
    const N: usize,
    const R: usize,
    const C: usize,
    const F: usize,
    const K: usize,
    const M: usize,
    const P: usize,
> WideKernel<U> for Tangents<'_, S, T, U, Of, OfMut, N, R, C, F, K, M, P>
{
    #[inline(always)]
    fn run<V, Narrow>(self)
    where
        U: Lanes<Scalar = U>,
        V: Lanes<Scalar = U>,
        Narrow: Lanes<Scalar = U>,
    {
        self.orders::<InLanes<V>, InLanes<Narrow>>();
    }
}

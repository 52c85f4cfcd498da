//! The Taylor method.

use nalgebra::SVector;

use crate::cost::Operations;
use crate::dense::{Step, polynomial_of_step};
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::method::operations as count;
use crate::method::scheme::{Accepted, OneStep, Scheme, Stalled};
use crate::method::toggle::end_step;
use crate::method::{Adaptive, require};
use crate::real::lanes::{Isa, Lanes, Routine};
use crate::real::{Float, Real};
use crate::statistics::Statistics;
use crate::step_size::{Estimates, Tolerance, exp2, log2};
use crate::system::System;
use crate::taylor::{MAX_ORDER, TaylorSeries};

/// The Taylor method, with an order determined by the tolerance; see [`Adaptive`] for its settings.
///
/// It needs [power series](TaylorSeries): of a declaration whose `generate` has `taylor`, or, slower, of
/// [equations by hand](crate::system::Equations).
///
/// Each step evaluates the power series of the motion once. It is as long as keeps the last terms below the tolerance:
/// À. Jorba and M. Zou, "A software package for the numerical integration of ODEs by means of high-order Taylor
/// methods", Experimental Mathematics 14 (2005) 99-117. A step is rejected if the derivative at its end differs from
/// the derivative of the series, for example across a pole that the terms do not reveal. The series is the dense
/// output. The order is `-ln(tolerance) / 2 + 5`, unless [`order`](Taylor::order) sets it.
///
/// A series does not contain the jumps of `signum` or of a law in time; only the derivative at the end of a step
/// reveals them. If there are jumps, set [`h0`](Adaptive::h0) no longer than the time to the first, and
/// [`h_max`](Adaptive::h_max) no longer than the shortest time between two.
///
/// ```
/// use pendulum_core::prelude::*;
///
/// mechanism! {
///     pub Swing {
///         params { l: m = 1.0 }
///         gravity: [0, -9.81, 0],
///         generate: [rhs, energy, taylor],
///         body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: angle }
///     }
/// }
///
/// let swing = Swing::new(SwingParams::default())?;
/// let solution = Taylor::new().rtol(1e-14).atol(1e-14).solve(&swing, 0.0, 10.0, [3.0, 0.0])?;
/// let energy = |x: &SVector<f64, 2>| swing.energy(0.0, x);
/// assert!((energy(&solution.end()) - energy(&solution.at(0.0)?)).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type Taylor = Adaptive<PowerSeries>;

/// Kind of method of [`Taylor`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PowerSeries {
    pub(crate) order: Option<usize>,
}

/// Order without a tolerance.
const DEFAULT_ORDER: usize = 20;

impl Taylor {
    /// Sets the order of the series, from 4 to [`MAX_ORDER`]. Default: determined by the tolerance.
    #[must_use]
    pub fn order(mut self, order: usize) -> Self {
        self.family.order = Some(order);
        self
    }

    /// Upper bound of the operations of one attempt of a step, in a system of `n` state components whose power series
    /// of this `order`, from the state on, takes `series`. A derivative at the end that differs from the series takes
    /// another attempt.
    ///
    /// For a generated model most of `series` is [`FunctionCost::series`](crate::FunctionCost::series). Comparisons and
    /// moves of numbers are extra. The error and the choice of the step are included, dense output is not.
    #[must_use]
    pub const fn operations(series: Operations, order: usize, n: usize) -> Operations {
        let sizes = Operations::new(n * (1 + TERMS), n * (1 + TERMS) + TERMS, n, 0, n * (1 + TERMS), n + 26);
        // `length`, whose logarithm and power are `log2` and `exp2`
        let length = Operations::new(12 * TERMS + 10, 5 * TERMS + 5, TERMS + 1, 0, 0, 60);
        let terms = order * n;
        let polynomial = Operations::new(terms, terms + 1, 0, 0, 0, order + 5);
        let defect = Operations::new(terms + 2 * n, 2 * terms + 2 * n + 2, 0, 0, 0, order + 5);
        sizes
            .and(length)
            .and(polynomial)
            .and(series)
            .and(defect)
            .and(count::mean_square(n))
            .and(count::CONTROLLED)
    }
}

impl PowerSeries {
    /// Order of the series: as set, or determined by the tolerance.
    pub(crate) fn order_within<T: Float>(&self, tolerance: Option<Tolerance<T>>) -> Result<usize, Reason> {
        let order = match (self.order, &tolerance) {
            (Some(order), _) => order,
            (None, Some(tolerance)) => order_for(tolerance),
            (None, None) => DEFAULT_ORDER,
        };
        let rule = "the order of a Taylor method must be between 4 and 24";
        require((TERMS..=MAX_ORDER).contains(&order), "order", order as f64, rule)?;
        Ok(order)
    }
}

impl<S, T, const N: usize> OneStep<S, T, N> for PowerSeries
where
    S: TaylorSeries<T, N> + ?Sized,
    T: Lanes,
{
    type Scheme = TaylorStages<S::Workspace, T, N>;

    #[inline(always)]
    fn scheme(&self, system: &S, tolerance: Option<Tolerance<T::Scalar>>) -> Result<Self::Scheme, Reason> {
        let order = self.order_within(tolerance)?;
        let zero = SVector::from_element(T::default());
        Ok(TaylorStages {
            tolerance: tolerance.map(|tolerance| (tolerance.in_lanes(), bits(&tolerance))),
            order,
            current: 0,
            from: 0,
            x: [[zero; MAX_ORDER + 1]; 2],
            coefficients: [zero; MAX_ORDER],
            work: system.workspace(),
        })
    }
}

impl Estimates for PowerSeries {}

/// Order that meets a tolerance with the least work. It would be `-ln(tolerance) / 2 + 1` if operations grew with the
/// square of the order (Jorba and Zou, 3.1). Here part of the work is independent of the order, which favours a
/// slightly higher one.
fn order_for<T: Float>(tolerance: &Tolerance<T>) -> usize {
    let error = tolerance.rtol.max(tolerance.atol).to_f64().min(1.0);
    let order = libm::ceil(-0.5 * libm::log(error) + 5.0) as usize;
    order.clamp(TERMS, MAX_ORDER)
}

/// Number of last terms that determine the length of a step. Symmetric motions, such as those from rest, may have only
/// every fourth term.
const TERMS: usize = 4;
/// Distance of the last term of a series below the tolerance, in powers of two. The sum of all omitted terms is about
/// as small.
const SAFETY: f64 = 4.0;

/// Number of bits of the state within the tolerance.
fn bits<T: Float>(tolerance: &Tolerance<T>) -> f64 {
    -log2(tolerance.rtol.max(tolerance.atol).to_f64())
}

/// Length of a step whose last terms are well within a tolerance of `bits`, from the sizes of their coefficients in
/// units of the state's tolerance. It is 0 if the sizes overflow, as near a pole.
///
/// Each term gives a radius of convergence, as if the terms were a geometric series from the state on. The smallest
/// radius counts.
#[inline(always)]
fn length<T: Float>(order: usize, bits: f64, sizes: [T; TERMS]) -> T {
    let sizes = sizes.map(T::to_f64);
    if !sizes.iter().sum::<f64>().is_finite() {
        return T::default();
    }
    let mut radius = f64::INFINITY;
    for (n, size) in sizes.into_iter().enumerate() {
        radius = radius.min((bits - log2(size)) / (order - n) as f64);
    }
    T::from_f64(exp2(radius - (bits + SAFETY) / order as f64))
}

/// Last terms of a series, the last one first.
#[inline(always)]
fn last_terms<R, const N: usize>(x: &[SVector<R, N>]) -> [&SVector<R, N>; TERMS] {
    core::array::from_fn(|n| &x[x.len() - 1 - n])
}

/// Error of a step of length `h` along the series `x`. The derivative of the series at its end differs from the `slope`
/// there by the omitted terms; as these grow with a power of the time, their integral is the difference times
/// `h / (order + 1)`. With `VALUES` it has no derivatives.
#[inline(always)]
fn defect<const VALUES: bool, R: Real, const N: usize>(
    x: &[SVector<R, N>],
    h: R,
    slope: &SVector<R, N>,
) -> SVector<R, N> {
    let of = |number: R| if VALUES { number.without_slopes() } else { number };
    let h = of(h);
    let square = h * h;
    let (mut odd, mut even) = ([R::default(); N], [R::default(); N]);
    let mut order = (x.len() - 1) as u32;
    let (pairs, last) = x[1..].as_chunks::<2>();
    for last in last {
        let factor = R::from_f64(f64::from(order));
        for (odd, &coefficient) in odd.iter_mut().zip(&last.data.0[0]) {
            *odd = odd.mul_add(square, of(coefficient).scaled(factor));
        }
        order -= 1;
    }
    for [first, second] in pairs.iter().rev() {
        let factors = [order - 1, order].map(|factor| R::from_f64(f64::from(factor)));
        for i in 0..N {
            odd[i] = odd[i].mul_add(square, of(first.data.0[0][i]).scaled(factors[0]));
            even[i] = even[i].mul_add(square, of(second.data.0[0][i]).scaled(factors[1]));
        }
        order -= 2;
    }
    let share = h * R::from_f64(1.0 / x.len() as f64);
    let mut error = *slope;
    for (error, (&odd, &even)) in error.data.0[0].iter_mut().zip(odd.iter().zip(&even)) {
        *error = of(share * (*error - (odd + h * even)));
    }
    error
}

/// Computation of a series from the time on.
struct Series<T>(T);

impl<S, T, const N: usize> Routine<(&mut [SVector<T, N>], &mut S::Workspace), S> for Series<T>
where
    S: TaylorSeries<T, N> + ?Sized,
    T: Lanes,
{
    type Output = ();

    #[inline(always)]
    fn run(self, (x, work): &mut (&mut [SVector<T, N>], &mut S::Workspace), system: &S) {
        system.series(self.0, x, work);
    }
}

/// Power series of a step.
#[derive(Clone, Debug)]
pub struct TaylorStages<W, T, const N: usize> {
    /// Tolerance, and its number of bits.
    tolerance: Option<(Tolerance<T>, f64)>,
    order: usize,
    /// Index of the series at the point reached. The other one belongs to the start of the last step, or to the end of
    /// the last attempt.
    current: usize,
    /// Index of the series at the start of the last attempt.
    from: usize,
    x: [[SVector<T, N>; MAX_ORDER + 1]; 2],
    /// The dense output.
    coefficients: [SVector<T, N>; MAX_ORDER],
    work: W,
}

impl<W, T: Lanes, const N: usize> TaylorStages<W, T, N> {
    /// Computes one of the two series.
    #[inline(always)]
    fn find<S>(&mut self, which: usize, system: &S, (t, x): (T, &SVector<T, N>), work: &mut Statistics)
    where
        S: TaylorSeries<T, N, Workspace = W> + ?Sized,
    {
        let series = &mut self.x[which][..=self.order];
        series[0] = *x;
        // lanes are in code for their registers already; for scalars a separate function is faster than a part of the
        // step
        if const { T::LANES == 1 } {
            Isa::run_routine(Series(t), &mut (series, &mut self.work), system);
        } else {
            system.series(t, series, &mut self.work);
        }
        work.evaluations += 1;
    }

    #[inline(always)]
    fn series(&self, which: usize) -> &[SVector<T, N>] {
        &self.x[which][..=self.order]
    }
}

impl<S, T, const N: usize> Scheme<S, T, N> for TaylorStages<S::Workspace, T, N>
where
    S: TaylorSeries<T, N> + ?Sized,
    T: Lanes,
{
    const PROPOSES: bool = true;
    const DENSE_IS_EXACT: bool = true;

    #[inline(always)]
    fn error_order(&self) -> usize {
        self.order - 1
    }

    #[inline(always)]
    fn begin(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N> {
        self.find(self.current, system, (t, x), work);
        self.x[self.current][1]
    }

    #[inline(always)]
    fn prepare(&mut self, system: &InMode<'_, S, T>, _t: T, x: &SVector<T, N>, _work: &mut Statistics) -> Option<T> {
        let (tolerance, bits) = self.tolerance.as_ref()?;
        let sizes = tolerance.mean_sizes(last_terms(self.series(self.current)), x, system.active());
        Some(T::from_fn(|lane| {
            length(self.order, *bits, sizes.map(|size| size.lane(lane)))
        }))
    }

    #[inline(always)]
    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled> {
        let (h, other) = (t_new - t, 1 - self.current);
        self.from = self.current;
        *x_new = polynomial_of_step(x, &self.series(self.current)[1..], h);
        end_step(system, (t, x), (t_new, x_new));
        self.find(other, system, (t_new, x_new), work);
        Ok(match &self.tolerance {
            Some((tolerance, _)) => {
                let (series, slope) = (self.series(self.current), &self.x[other][1]);
                let error = if tolerance.is_of_values() {
                    defect::<true, _, _>(series, h, slope)
                } else {
                    defect::<false, _, _>(series, h, slope)
                };
                tolerance.mean_square(&error, [x, x_new], system.active())
            }
            None => T::default(),
        })
    }

    #[inline(always)]
    fn arrive(
        &mut self,
        _system: &InMode<'_, S, T>,
        _end: (T, &SVector<T, N>),
        _work: &mut Statistics,
    ) -> Option<&SVector<T, N>> {
        Some(&self.x[1 - self.current][1])
    }

    #[inline(always)]
    fn accept(&mut self, _system: &InMode<'_, S, T>, _step: &Step<T, N>, lanes: Accepted<T>, _work: &mut Statistics) {
        let (old, new) = (self.current, 1 - self.current);
        if let Accepted::Negative(_) = lanes {
            for k in 0..=self.order {
                self.x[new][k] = lanes.select(&self.x[new][k], &self.x[old][k]);
            }
        }
        self.current = new;
    }

    #[inline(always)]
    fn dense(&mut self, _system: &InMode<'_, S, T>, step: &Step<T, N>, _work: &mut Statistics) -> &[SVector<T, N>] {
        let mut power = T::from_f64(1.0);
        let start = if const { T::LANES == 1 } {
            self.from
        } else {
            self.current
        };
        let series = &self.x[start][1..=self.order];
        for (coefficient, x) in self.coefficients.iter_mut().zip(series) {
            power *= step.h;
            for (coefficient, &x) in coefficient.data.0[0].iter_mut().zip(&x.data.0[0]) {
                *coefficient = x * power;
            }
        }
        &self.coefficients[..self.order]
    }

    fn coefficients(&self) -> &[SVector<T, N>] {
        &self.coefficients[..self.order]
    }
}

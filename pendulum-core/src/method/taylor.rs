//! The Taylor method.

use nalgebra::SVector;

use crate::control::{Tolerance, exp2, log2};
use crate::dense::{Step, polynomial};
use crate::error::Reason;
use crate::method::scheme::{Attempt, Family, NonFinite, Scheme, Stalled};
use crate::method::{Adaptive, require};
use crate::real::Float;
use crate::real::lanes::{Isa, Kernel, Lane, Lanes};
use crate::solution::Statistics;
use crate::taylor::{MAX_ORDER, TaylorSeries};

/// The Taylor method of an order that follows from the tolerance; see [`Adaptive`] for its settings.
///
/// Each step evaluates the power series of the motion once, and is as long as its last two terms stay below the tolerance: À. Jorba and
/// M. Zou, "A software package for the numerical integration of ODEs by means of high-order Taylor methods", Experimental Mathematics 14
/// (2005) 99-117. No step is rejected, and the series is the dense output. The order is `-ln(tolerance) / 2 + 5`, or what [`order`](Taylor::order) sets.
///
/// Where the right-hand side ends without a trace in the motion above the tolerance, as at the edge of a square root, a step may reach past
/// that: the error comes with the next one.
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
/// assert!((energy(&solution.last().1) - energy(&solution.at(0.0)?)).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub type Taylor = Adaptive<PowerSeries>;

/// The kind of method that [`Taylor`] is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PowerSeries {
    pub(crate) order: Option<usize>,
}

/// The order without a tolerance.
const DEFAULT_ORDER: usize = 20;

impl Taylor {
    /// The order of the series, from 2 to [`MAX_ORDER`], in place of the one that follows from the tolerance.
    #[must_use]
    pub fn order(mut self, order: usize) -> Self {
        self.family.order = Some(order);
        self
    }
}

impl<S, T, const N: usize> Family<S, T, N> for PowerSeries
where
    S: TaylorSeries<T, N> + ?Sized,
    T: Lane,
{
    type Scheme = Series<S::Workspace, N, T>;

    fn scheme(&self, system: &S, tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        let order = match (self.order, &tolerance) {
            (Some(order), _) => order,
            (None, Some(tolerance)) => order_for(tolerance),
            (None, None) => DEFAULT_ORDER,
        };
        let rule = "the order of a Taylor method must be from 2 to 24";
        require((2..=MAX_ORDER).contains(&order), "order", order as f64, rule)?;
        let zero = SVector::from_element(T::default());
        Ok(Series {
            tolerance,
            order,
            isa: Isa::for_scalars(),
            known: false,
            x: [zero; MAX_ORDER + 1],
            coefficients: [zero; MAX_ORDER],
            work: system.workspace(),
        })
    }
}

/// The order that reaches a tolerance with the least work. For operations that grow with the square of the order it would be
/// `-ln(tolerance) / 2 + 1` (Jorba and Zou, 3.1); here part of the work is the same for each order, so that some more are better.
pub(crate) fn order_for<T: Float>(tolerance: &Tolerance<T>) -> usize {
    let error = tolerance.rtol.max(tolerance.atol).to_f64().min(1.0);
    let order = (-0.5 * error.ln() + 5.0).ceil() as usize;
    order.clamp(4, MAX_ORDER)
}

/// The last two terms of a series are this many powers of two below the tolerance: so is about the sum of all that are left out.
const SAFETY: f64 = 4.0;

/// The length of a step whose last two terms are well within the tolerance, from the sizes of their coefficients in units of it:
/// 0 where these are beyond all numbers, as close to a pole.
#[inline(always)]
pub(crate) fn length<T: Float>(order: usize, [last_but_one, last]: [T; 2]) -> T {
    if !(last_but_one + last).is_finite() {
        return T::default();
    }
    let logarithm = |size: T| -log2(size.to_f64()) - SAFETY;
    let (last, last_but_one) = (
        logarithm(last) / order as f64,
        logarithm(last_but_one) / (order as f64 - 1.0),
    );
    T::from_f64(exp2(last.min(last_but_one)))
}

/// A series, as code that may use wider registers: its loops over products have the numbers side by side.
struct Recurrences<'a, S: ?Sized, W, const N: usize, T> {
    system: &'a S,
    t: T,
    x: &'a mut [SVector<T, N>],
    work: &'a mut W,
}

impl<S, T, const N: usize> Kernel<T> for Recurrences<'_, S, S::Workspace, N, T>
where
    S: TaylorSeries<T, N> + ?Sized,
    T: Lane,
{
    type Output = ();

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) {
        self.system.series(self.t, self.x, self.work);
    }
}

/// The power series of a step.
#[derive(Clone, Debug)]
pub struct Series<W, const N: usize, T> {
    tolerance: Option<Tolerance<T>>,
    order: usize,
    isa: Isa,
    /// Whether the series is that of the point reached.
    known: bool,
    x: [SVector<T, N>; MAX_ORDER + 1],
    /// The dense output.
    coefficients: [SVector<T, N>; MAX_ORDER],
    work: W,
}

impl<W, const N: usize, T: Lane> Series<W, N, T> {
    #[inline]
    fn find<S>(&mut self, system: &S, t: T, x: &SVector<T, N>, work: &mut Statistics)
    where
        S: TaylorSeries<T, N, Workspace = W> + ?Sized,
    {
        if !self.known {
            self.x[0] = *x;
            self.isa.run(Recurrences {
                system,
                t,
                x: &mut self.x[..=self.order],
                work: &mut self.work,
            });
            self.known = true;
            work.evaluations += 1;
        }
    }
}

impl<S, T, const N: usize> Scheme<S, T, N> for Series<S::Workspace, N, T>
where
    S: TaylorSeries<T, N> + ?Sized,
    T: Lane,
{
    const PROPOSES: bool = true;

    fn error_order(&self) -> usize {
        self.order - 1
    }

    fn begin(&mut self, system: &S, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N> {
        self.known = false;
        self.find(system, t, x, work);
        self.x[1]
    }

    #[inline]
    fn prepare(&mut self, system: &S, t: T, x: &SVector<T, N>, work: &mut Statistics) -> Option<T> {
        self.find(system, t, x, work);
        let tolerance = self.tolerance.as_ref()?;
        // Where there is no derivative there is no series: let it be told from where the step arrives.
        NonFinite::check(&self.x[1]).ok()?;
        let terms = [&self.x[self.order - 1], &self.x[self.order]];
        Some(length(self.order, tolerance.mean_sizes(terms, x)))
    }

    #[inline]
    fn attempt(
        &mut self,
        system: &S,
        (t, x): (T, &SVector<T, N>),
        t_new: T,
        work: &mut Statistics,
    ) -> Result<Attempt<N, T>, Stalled> {
        self.find(system, t, x, work);
        Ok(Attempt {
            x: polynomial(x, &self.x[1..=self.order], t_new - t),
            mean_square: T::default(),
        })
    }

    #[inline]
    fn finish(&mut self, system: &S, step: &Step<N, T>, work: &mut Statistics) -> Result<(), NonFinite> {
        // Steps within a tolerance pass the end of a right-hand side by no more than that allows; these may lead anywhere.
        if self.tolerance.is_none() {
            work.evaluations += 1;
            NonFinite::check(&system.rhs(step.t1, &step.x1))?;
        }
        self.known = false;
        Ok(())
    }

    fn dense(&mut self, _system: &S, step: &Step<N, T>, _work: &mut Statistics) -> &[SVector<T, N>] {
        let mut power = T::from_f64(1.0);
        for (coefficient, x) in self.coefficients.iter_mut().zip(&self.x[1..=self.order]) {
            power *= step.h;
            *coefficient = x * power;
        }
        &self.coefficients[..self.order]
    }
}

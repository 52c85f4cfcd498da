//! Lyapunov exponents: rates at which neighbouring trajectories diverge.

use nalgebra::SVector;

mod in_lanes;

use super::StabilityError;
use super::directions::{dimension, directions};
use super::transition::flow;
use crate::error::Reason;
use crate::method::{Method, require};
use crate::settings::settings;
use crate::system::{IntoState, Jacobian, System};

/// Computation of Lyapunov exponents: a plain value with settings.
///
/// Tangent vectors follow the variational equations along a trajectory. After each step they are orthonormalised, and
/// the logarithms of their lengths are accumulated. Their mean growth rates converge to the largest exponents (G.
/// Benettin, L. Galgani, A. Giorgilli, J.-M. Strelcyn, Meccanica 15 (1980) 9 and 21). Convergence is slow: as
/// `ln(t) / t` in regular motion, and as `1 / sqrt(t)` in chaotic motion.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::stability::Lyapunov;
///
/// mechanism! {
///     pub Swing {
///         gravity: [0, -9.81, 0],
///         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: 0.2 }
///     }
/// }
///
/// let swing = Swing::new(SwingParams {})?;
/// let exponents = Lyapunov::new().duration(200.0).exponents::<2, _>(&swing, [0.01, 0.0])?;
/// assert!((exponents.values[0] + 0.1).abs() < 1e-2);
/// assert!((exponents.values.iter().sum::<f64>() + 0.2).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lyapunov {
    tolerance: f64,
    transient: f64,
    duration: f64,
}

/// The largest `K` Lyapunov exponents of a trajectory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponents<const K: usize, const N: usize> {
    /// Exponents in 1/s, in descending order within their uncertainty. Minus infinity if the trajectory of a
    /// [hybrid](crate::hybrid) system loses the memory of its initial condition, as in sticking.
    pub values: [f64; K],
    /// Standard error of each exponent, from the scatter of its means over ten parts of the duration. An effect common
    /// to all parts, such as an unfinished transient, is not included. Persistent oscillations of the tangent lengths,
    /// as of a damped mode, may cause errors a few times larger.
    pub uncertainty: [f64; K],
    /// Final time.
    pub t: f64,
    /// Final state.
    pub x: SVector<f64, N>,
}

impl<const K: usize, const N: usize> Exponents<K, N> {
    /// Prediction horizon: the time in s for an error to grow from `from` to `to`, `ln(to / from) / values[0]`.
    ///
    /// Infinite if the largest exponent is not positive. Twice the number of digits only doubles the horizon.
    #[must_use]
    pub fn horizon(&self, from: f64, to: f64) -> f64 {
        if self.values[0] > 0.0 {
            libm::log(to / from) / self.values[0]
        } else {
            f64::INFINITY
        }
    }
}

/// Number of parts of the duration for the estimate of the uncertainty.
const PARTS: usize = 10;

impl Default for Lyapunov {
    fn default() -> Self {
        Self::new()
    }
}

impl Lyapunov {
    /// Default settings.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            tolerance: 1e-8,
            transient: 0.0,
            duration: 1000.0,
        }
    }

    settings! {
        /// Sets the relative and absolute tolerance of the trajectory and of its tangents. Default: 1e-8.
        tolerance: f64;

        /// Sets the time in s before growth is counted, in which the motion settles and the tangents align with the
        /// growing directions. Default: 0.
        transient: f64;

        /// Sets the time over which growth is counted, in s. Default: 1000.
        duration: f64;
    }

    /// Computes the largest exponent of the trajectory from `x0` at the time 0.
    ///
    /// # Errors
    /// See [`exponents`](Self::exponents).
    pub fn largest<const N: usize>(
        &self,
        system: &(impl Jacobian<f64, N> + ?Sized),
        x0: impl IntoState<f64, N>,
    ) -> Result<Exponents<1, N>, StabilityError> {
        self.exponents(system, x0)
    }

    /// Computes the `K` largest exponents of the trajectory from `x0` at the time 0. There are `N` exponents, or twice
    /// the number of rates if there are more positions than rates, as with quaternions.
    ///
    /// # Errors
    /// [`StabilityError::Integration`] if a setting is out of its range, or if the trajectory stops early.
    pub fn exponents<const K: usize, const N: usize>(
        &self,
        system: &(impl Jacobian<f64, N> + ?Sized),
        x0: impl IntoState<f64, N>,
    ) -> Result<Exponents<K, N>, StabilityError> {
        self.exponents_unless(system, x0, &|| false)
    }

    /// Like [`exponents`](Self::exponents), but ends with [`Reason::Cancelled`] when `is_cancelled` returns true, which
    /// is called after each step.
    ///
    /// # Errors
    /// See [`exponents`](Self::exponents).
    pub fn exponents_unless<const K: usize, const N: usize>(
        &self,
        system: &(impl Jacobian<f64, N> + ?Sized),
        x0: impl IntoState<f64, N>,
        is_cancelled: &dyn Fn() -> bool,
    ) -> Result<Exponents<K, N>, StabilityError> {
        self.check::<K, N>(system)?;
        let flow = flow::<K>(self.tolerance).h_max(self.h_max());
        let mut stepper = flow.stepper(system, 0.0, self.end(), x0)?;
        stepper.scheme_mut().tangents = oblique(system.active());
        // constraints held from the start also constrain the tangents
        let (t, x) = (stepper.t(), stepper.x());
        stepper.restart(t, x)?;
        keep_to_directions(system, (t, &x), &mut stepper.scheme_mut().tangents);
        orthonormalize(&mut stepper.scheme_mut().tangents, system.active());
        let mut growth = TangentGrowth::new(self.transient, self.end());
        while let Some(step) = stepper.step()? {
            keep_to_directions(system, (step.t1, &step.x1), &mut stepper.scheme_mut().tangents);
            let lengths = orthonormalize(&mut stepper.scheme_mut().tangents, system.active());
            growth.count((step.t0, step.h), lengths);
            if is_cancelled() {
                return Err(Reason::Cancelled.into());
            }
        }
        Ok(growth.exponents(stepper.t(), stepper.x()))
    }

    fn end(&self) -> f64 {
        self.transient + self.duration
    }

    /// Largest step size. At rest, a single step could otherwise cover the whole duration.
    fn h_max(&self) -> f64 {
        self.duration / PARTS as f64
    }

    fn check<const K: usize, const N: usize>(&self, system: &(impl System<f64, N> + ?Sized)) -> Result<(), Reason> {
        const { assert!(1 <= K && K <= N, "there are from one to N exponents") };
        let rule = "the time to settle must be finite and not negative";
        require(
            self.transient.is_finite() && self.transient >= 0.0,
            "transient",
            self.transient,
            rule,
        )?;
        let rule = "the time over which growth is counted must be finite and positive";
        require(
            self.duration.is_finite() && self.duration > 0.0,
            "duration",
            self.duration,
            rule,
        )?;
        let rule = "it must be at most the number of independent directions, which quaternions and closed loops \
                    reduce";
        require(K <= dimension(system), "K", K as f64, rule)
    }
}

/// Accumulated growth of the tangents in each part of the duration.
#[derive(Clone)]
struct TangentGrowth<const K: usize> {
    /// Start of counting: steps from this time on are counted. Set to the start of the first counted step.
    from: f64,
    end: f64,
    is_counting: bool,
    parts: [[Growth; K]; PARTS],
    seconds: [f64; PARTS],
}

/// A product of lengths of any size: `product exp(log)`. Logarithms are taken rarely.
#[derive(Clone, Copy)]
struct Growth {
    product: f64,
    log: f64,
}

impl Growth {
    const NONE: Self = Self { product: 1.0, log: 0.0 };

    /// Range of the product: a length of any size may follow.
    const RANGE: core::ops::Range<f64> = 1e-100..1e100;

    fn multiply(&mut self, length: f64) {
        self.product *= length;
        if !Self::RANGE.contains(&self.product) {
            *self = Self {
                product: 1.0,
                log: self.log(),
            };
        }
    }

    fn log(self) -> f64 {
        self.log + libm::log(self.product)
    }
}

impl<const K: usize> TangentGrowth<K> {
    fn new(from: f64, end: f64) -> Self {
        Self {
            from,
            end,
            is_counting: false,
            parts: [[Growth::NONE; K]; PARTS],
            seconds: [0.0; PARTS],
        }
    }

    /// Counts a step of size `h` from `t`, if it begins late enough, in the part in which it begins.
    fn count(&mut self, (t, h): (f64, f64), lengths: [f64; K]) {
        if t < self.from {
            return;
        }
        if !self.is_counting {
            (self.from, self.is_counting) = (t, true);
        }
        let part = (PARTS as f64 * (t - self.from) / (self.end - self.from)) as usize;
        let part = part.min(PARTS - 1);
        self.seconds[part] += h;
        for (growth, length) in self.parts[part].iter_mut().zip(lengths) {
            growth.multiply(length);
        }
    }

    /// Exponents of a trajectory that ends in the state `x` at `t`.
    fn exponents<const N: usize>(&self, t: f64, x: SVector<f64, N>) -> Exponents<K, N> {
        let (values, uncertainty) = self.rates();
        Exponents {
            values,
            uncertainty,
            t,
            x,
        }
    }

    /// Growth rates with their standard errors.
    fn rates(&self) -> ([f64; K], [f64; K]) {
        let [mut values, mut uncertainty] = [[0.0; K]; 2];
        let total: f64 = self.seconds.iter().sum();
        let logs = self.parts.map(|part| part.map(Growth::log));
        for k in 0..K {
            values[k] = logs.iter().map(|part| part[k]).sum::<f64>() / total;
            // Parts covered by a single longer step have no weight.
            if values[k] == f64::NEG_INFINITY {
                continue;
            }
            let rates = logs.iter().zip(self.seconds).filter(|&(_, seconds)| seconds > 0.0);
            let apart = rates.map(|(part, seconds)| {
                let apart = part[k] / seconds - values[k];
                apart * apart * seconds / total
            });
            uncertainty[k] = (apart.sum::<f64>() / (PARTS - 1) as f64).sqrt();
        }
        (values, uncertainty)
    }
}

/// Initial directions that are not aligned with any axis, without padding. An invariant direction, such as the rate of
/// a cyclic coordinate, would never turn towards the growing ones.
fn oblique<const K: usize, const N: usize>(active: usize) -> [SVector<f64, N>; K] {
    let component = |k: usize, i: usize| libm::sin(1.0 + ((i + 1) * (i + 2 * k + 3)) as f64);
    let component = |k, i| if i < active { component(k, i) } else { 0.0 };
    let mut vectors = std::array::from_fn(|k| SVector::from_fn(|i, _| component(k, i)));
    orthonormalize(&mut vectors, active);
    vectors
}

/// Removes inadmissible components from tangents, such as a change of the norm of a quaternion. Rounding errors in
/// these components would persist while all others decay.
fn keep_to_directions<const K: usize, const N: usize>(
    system: &(impl Jacobian<f64, N> + ?Sized),
    (t, x): (f64, &SVector<f64, N>),
    vectors: &mut [SVector<f64, N>; K],
) {
    if dimension(system) == system.active() {
        return;
    }
    if let Some(basis) = directions(system, &system.jacobian(t, x)) {
        for vector in vectors {
            let within = &basis * (basis.transpose() * *vector);
            *vector = SVector::from_column_slice(within.as_slice());
        }
    }
}

/// Orthonormalises vectors by the modified Gram-Schmidt method. Returns the lengths of the remainders, or 0 for those
/// of the size of rounding errors. The latter vectors are replaced by arbitrary orthogonal ones: the next step removes
/// them again if there are too few growing directions, and otherwise they represent a new one.
fn orthonormalize<const K: usize, const N: usize>(vectors: &mut [SVector<f64, N>; K], active: usize) -> [f64; K] {
    let longest = vectors.iter().map(|vector| vector.norm()).fold(1.0, f64::max);
    let mut lengths = [0.0; K];
    for (k, length) in lengths.iter_mut().enumerate() {
        let (done, rest) = vectors.split_at_mut(k);
        for before in done.iter() {
            let share = before.dot(&rest[0]);
            rest[0].axpy(-share, before, 1.0);
        }
        let left = rest[0].norm();
        if left > LEAST * longest {
            rest[0] /= left;
            *length = left;
        } else {
            rest[0] = left_over(done, active);
        }
    }
    lengths
}

/// Length relative to the longest vector below which a vector counts as rounding error.
const LEAST: f64 = 1e-12;

/// A unit vector orthogonal to the others, without a component beyond the active ones.
fn left_over<const N: usize>(done: &[SVector<f64, N>], active: usize) -> SVector<f64, N> {
    let without = |axis: usize| {
        let mut rest = SVector::from_fn(|i, _| f64::from(u8::from(i == axis)));
        for _ in 0..2 {
            for before in done {
                let share = before.dot(&rest);
                rest.axpy(-share, before, 1.0);
            }
        }
        rest
    };
    let longest = (0..active).map(without).max_by(|a, b| a.norm().total_cmp(&b.norm()));
    longest.map_or(SVector::zeros(), |longest| longest.normalize())
}

#[cfg(test)]
mod tests {
    use super::{Exponents, PARTS, TangentGrowth};

    /// Counts steps `(t, h)` with growth rates that depend on `t`.
    fn counted(
        from: f64,
        end: f64,
        steps: impl Iterator<Item = (f64, f64)>,
        rate: impl Fn(f64) -> f64,
    ) -> TangentGrowth<1> {
        let mut growth = TangentGrowth::new(from, end);
        for (t, h) in steps {
            growth.count((t, h), [(rate(t) * h).exp()]);
        }
        growth
    }

    #[test]
    fn steps_are_counted_in_the_part_in_which_they_begin() {
        // Steps of 1/2 from 1/4 on: the first that is counted begins at 3.25, and the parts of 4.375 s have 9 or 8
        // steps.
        let steps = (0..200)
            .map(|n| (0.25 + 0.5 * f64::from(n), 0.5))
            .take_while(|&(t, _)| t < 47.0);
        let growth = counted(3.0, 47.0, steps, |_| -0.25);
        assert_eq!((growth.from, growth.seconds.iter().sum::<f64>()), (3.25, 44.0));
        assert_eq!(growth.seconds, [4.5, 4.5, 4.5, 4.0, 4.5, 4.5, 4.5, 4.0, 4.5, 4.5]);
        let ([value], [uncertainty]) = growth.rates();
        assert!((value + 0.25).abs() < 1e-14 && uncertainty < 1e-14);
        // a step that begins at the start of counting is counted
        assert_eq!(counted(3.25, 47.0, [(3.25, 1.0)].into_iter(), |_| 0.0).seconds[0], 1.0);
    }

    #[test]
    fn the_uncertainty_is_that_of_a_weighted_mean() {
        // Parts of 1 s with rates 0 to 9. Two steps cover several parts: 2 to 4, and 8 to the end.
        let steps = [
            (0.0, 1.0),
            (1.0, 1.0),
            (2.0, 3.0),
            (5.0, 1.0),
            (6.0, 1.0),
            (7.0, 1.0),
            (8.0, 2.0),
        ];
        let ([value], [uncertainty]) = counted(0.0, PARTS as f64, steps.into_iter(), |t| t).rates();
        let mean = steps.iter().map(|(t, h)| t * h).sum::<f64>() / 10.0;
        let variance = steps.iter().map(|(t, h)| (t - mean).powi(2) * h / 10.0).sum::<f64>();
        assert!((value - mean).abs() < 1e-14, "{value}");
        assert!((uncertainty - (variance / 9.0).sqrt()).abs() < 1e-14, "{uncertainty}");
    }

    #[test]
    fn what_does_not_grow_is_foreseen_for_ever() {
        let exponents = |value: f64| Exponents {
            values: [value],
            uncertainty: [0.0],
            t: 0.0,
            x: nalgebra::SVector::<f64, 1>::zeros(),
        };
        assert_eq!(exponents(2.0).horizon(1.0, 1.0_f64.exp()), 0.5);
        for value in [-1.0, 0.0] {
            assert_eq!(exponents(value).horizon(1e-6, 1.0), f64::INFINITY);
            assert_eq!(exponents(value).horizon(1.0, 1e-6), f64::INFINITY);
        }
    }
}

//! Lyapunov exponents: at what rate neighbouring trajectories part.

use nalgebra::SVector;

mod in_lanes;

use super::StabilityError;
use super::directions::{dimension, directions};
use super::transition::flow;
use crate::error::Reason;
use crate::method::{Method, require};
use crate::system::{IntoState, Jacobian, System};

/// The measurement of Lyapunov exponents, a plain value with settings.
///
/// Tangents follow the variational equations along a trajectory. After each step they are made orthonormal again, and the logarithms of the lengths
/// that they had are summed up; their mean growth rates tend to the largest exponents (G. Benettin, L. Galgani, A. Giorgilli, J.-M. Strelcyn,
/// Meccanica 15 (1980) 9 and 21). They tend slowly: as `ln(t) / t` in regular motion, and as `1 / sqrt(t)` in chaotic motion.
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
    /// The exponents, in 1/s, falling as far as their uncertainty allows; minus infinity where the trajectory of a
    /// [hybrid](crate::hybrid) system forgets where it came from, as in sticking.
    pub values: [f64; K],
    /// The standard error of each, from the scatter of its means over ten parts of the duration. What is the same in all parts, such as a
    /// transient that has not ended, does not show in it, and what turns on and on, such as the tangents of a damped mode, whose lengths swing, may
    /// leave a few times as much.
    pub uncertainty: [f64; K],
    /// The time at the end.
    pub t: f64,
    /// The state at the end.
    pub x: SVector<f64, N>,
}

impl<const K: usize, const N: usize> Exponents<K, N> {
    /// The horizon of prediction: how long until an error grows from `from` to `to`, `ln(to / from) / values[0]`, in s.
    ///
    /// Infinite where the largest exponent is not positive. Twice as many digits give twice the time, and no more.
    #[must_use]
    pub fn horizon(&self, from: f64, to: f64) -> f64 {
        if self.values[0] > 0.0 {
            libm::log(to / from) / self.values[0]
        } else {
            f64::INFINITY
        }
    }
}

/// The duration is cut in so many parts, whose scatter tells the uncertainty.
const PARTS: usize = 10;

impl Default for Lyapunov {
    fn default() -> Self {
        Self::new()
    }
}

impl Lyapunov {
    /// The measurement with its default settings.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            tolerance: 1e-8,
            transient: 0.0,
            duration: 1000.0,
        }
    }

    /// The relative and absolute tolerance of the trajectory and of its tangents. Default: 1e-8.
    #[must_use]
    pub const fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// The time that the motion has to settle, and the tangents to turn to the directions in which they grow, before growth is counted, in s.
    /// Default: 0.
    #[must_use]
    pub const fn transient(mut self, transient: f64) -> Self {
        self.transient = transient;
        self
    }

    /// The time over which growth is counted, in s. Default: 1000.
    #[must_use]
    pub const fn duration(mut self, duration: f64) -> Self {
        self.duration = duration;
        self
    }

    /// The largest exponent of the trajectory from `x0` at the time 0.
    ///
    /// # Errors
    /// As [`exponents`](Self::exponents).
    pub fn largest<const N: usize>(
        &self,
        system: &(impl Jacobian<f64, N> + ?Sized),
        x0: impl IntoState<f64, N>,
    ) -> Result<Exponents<1, N>, StabilityError> {
        self.exponents(system, x0)
    }

    /// The `K` largest exponents of the trajectory from `x0` at the time 0; all of them for `K = N`, or where
    /// positions outnumber rates, as those of quaternions do, for twice the number of rates.
    ///
    /// # Errors
    /// [`StabilityError::Integration`] if a setting is out of its range, or if the trajectory comes to an end before its time.
    pub fn exponents<const K: usize, const N: usize>(
        &self,
        system: &(impl Jacobian<f64, N> + ?Sized),
        x0: impl IntoState<f64, N>,
    ) -> Result<Exponents<K, N>, StabilityError> {
        self.check::<K, N>(system)?;
        let flow = flow::<K>(self.tolerance).h_max(self.h_max());
        let mut stepper = flow.stepper(system, 0.0, self.end(), x0)?;
        stepper.scheme_mut().tangents = oblique();
        // what is held from the start holds these as well
        let (t, x) = (stepper.t(), stepper.x());
        stepper.restart(t, x)?;
        keep_to_directions(system, (t, &x), &mut stepper.scheme_mut().tangents);
        orthonormalize(&mut stepper.scheme_mut().tangents);
        let mut growth = TangentGrowth::new(self.transient, self.end());
        while let Some(step) = stepper.step()? {
            keep_to_directions(system, (step.t1, &step.x1), &mut stepper.scheme_mut().tangents);
            let lengths = orthonormalize(&mut stepper.scheme_mut().tangents);
            growth.count((step.t0, step.h), lengths);
        }
        Ok(growth.exponents(stepper.t(), stepper.x()))
    }

    fn end(&self) -> f64 {
        self.transient + self.duration
    }

    /// Where all stands still a step might pass over the whole duration.
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
        let rule = "there are no more exponents than directions: a quaternion keeps its length, and loops stay closed";
        require(K <= dimension(system), "K", K as f64, rule)
    }
}

/// How much tangents grew in each part of the time.
#[derive(Clone)]
struct TangentGrowth<const K: usize> {
    /// Steps from here on are counted; of those that were, where the first began.
    from: f64,
    end: f64,
    is_counting: bool,
    /// The logarithms of lengths, summed up.
    parts: [[f64; K]; PARTS],
    seconds: [f64; PARTS],
}

impl<const K: usize> TangentGrowth<K> {
    fn new(from: f64, end: f64) -> Self {
        Self {
            from,
            end,
            is_counting: false,
            parts: [[0.0; K]; PARTS],
            seconds: [0.0; PARTS],
        }
    }

    /// Counts a step from `t` over `h`, if it begins late enough, in the part in which it does.
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
        for (sum, length) in self.parts[part].iter_mut().zip(lengths) {
            *sum += libm::log(length);
        }
    }

    /// The exponents of a trajectory that ends in the state `x` at `t`.
    fn exponents<const N: usize>(&self, t: f64, x: SVector<f64, N>) -> Exponents<K, N> {
        let (values, uncertainty) = self.rates();
        Exponents {
            values,
            uncertainty,
            t,
            x,
        }
    }

    /// The rates of growth, and the standard error of each.
    fn rates(&self) -> ([f64; K], [f64; K]) {
        let [mut values, mut uncertainty] = [[0.0; K]; 2];
        let total: f64 = self.seconds.iter().sum();
        for k in 0..K {
            values[k] = self.parts.iter().map(|part| part[k]).sum::<f64>() / total;
            // Parts that a single step passed over have no share in it.
            if values[k] == f64::NEG_INFINITY {
                continue;
            }
            let rates = self
                .parts
                .iter()
                .zip(self.seconds)
                .filter(|&(_, seconds)| seconds > 0.0);
            let apart = rates.map(|(part, seconds)| {
                let apart = part[k] / seconds - values[k];
                apart * apart * seconds / total
            });
            uncertainty[k] = (apart.sum::<f64>() / (PARTS - 1) as f64).sqrt();
        }
        (values, uncertainty)
    }
}

/// Directions that lie along no axis: one that a system keeps, such as the rate of a coordinate that nothing depends on, would never turn to those
/// that grow.
fn oblique<const K: usize, const N: usize>() -> [SVector<f64, N>; K] {
    let mut vectors =
        std::array::from_fn(|k| SVector::from_fn(|i, _| libm::sin(1.0 + ((i + 1) * (i + 2 * k + 3)) as f64)));
    orthonormalize(&mut vectors);
    vectors
}

/// Takes off tangents what no motion does, as a change of the length of a quaternion: rounding errors in it would stay where all
/// else decays.
fn keep_to_directions<const K: usize, const N: usize>(
    system: &(impl Jacobian<f64, N> + ?Sized),
    (t, x): (f64, &SVector<f64, N>),
    vectors: &mut [SVector<f64, N>; K],
) {
    if dimension(system) == N {
        return;
    }
    if let Some(basis) = directions(system, &system.jacobian(t, x)) {
        for vector in vectors {
            let within = &basis * (basis.transpose() * *vector);
            *vector = SVector::from_column_slice(within.as_slice());
        }
    }
}

/// Makes vectors orthonormal, each by what the ones before it leave of it (modified Gram-Schmidt): the lengths that were
/// left, 0 where these are rounding errors. In place of such a vector comes any that is left over: where the directions
/// that grow are too few, the next step takes it away again, and where there are more of them later it is one.
fn orthonormalize<const K: usize, const N: usize>(vectors: &mut [SVector<f64, N>; K]) -> [f64; K] {
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
            rest[0] = left_over(done);
        }
    }
    lengths
}

/// Shorter vectors than this part of the longest are rounding errors.
const LEAST: f64 = 1e-12;

/// A unit vector at right angles to the others.
fn left_over<const N: usize>(done: &[SVector<f64, N>]) -> SVector<f64, N> {
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
    let longest = (0..N).map(without).max_by(|a, b| a.norm().total_cmp(&b.norm()));
    longest.map_or(SVector::zeros(), |longest| longest.normalize())
}

#[cfg(test)]
mod tests {
    use super::{Exponents, PARTS, TangentGrowth};

    /// Steps of a length, at rates of growth that depend on where they begin.
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
        // of 1/2 from 1/4 on: the first that is counted begins at 3.25, and the parts of 4.375 are of 9 and 8 steps
        let steps = (0..200)
            .map(|n| (0.25 + 0.5 * f64::from(n), 0.5))
            .take_while(|&(t, _)| t < 47.0);
        let growth = counted(3.0, 47.0, steps, |_| -0.25);
        assert_eq!((growth.from, growth.seconds.iter().sum::<f64>()), (3.25, 44.0));
        assert_eq!(growth.seconds, [4.5, 4.5, 4.5, 4.0, 4.5, 4.5, 4.5, 4.0, 4.5, 4.5]);
        let ([value], [uncertainty]) = growth.rates();
        assert!((value + 0.25).abs() < 1e-14 && uncertainty < 1e-14);
        // one that begins where counting does is counted
        assert_eq!(counted(3.25, 47.0, [(3.25, 1.0)].into_iter(), |_| 0.0).seconds[0], 1.0);
    }

    #[test]
    fn the_uncertainty_is_that_of_a_weighted_mean() {
        // Parts of 1 s with the rates 0 to 9, of which some steps take several: 2 to 4, and 8 to the end.
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

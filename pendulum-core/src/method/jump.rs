//! Detection of discontinuities of a right-hand side that steps within a tolerance cannot cross.

use nalgebra::SVector;

use crate::error::Reason;
use crate::real::{Float, ulps};
use crate::system::System;

/// Times in which the state would change by its own size, up to which jumps are searched for.
const REACH: f64 = 16.0;
/// Length to which an interval is bisected, in ulps of the time or of [`REACH`].
const SHORTEST_ULPS: f64 = 4.0;
/// Minimum length of an interval that is searched, relative to the length to which it is bisected: over that a smooth
/// law changes by far less than [`LEAST_OF_INTERVAL`].
const LEAST_INTERVAL: f64 = 1e4;
/// Minimum jump, relative to the derivative.
const LEAST: f64 = 1e-5;
/// Minimum jump, relative to the change over the interval that was bisected: a steep law changes by less.
const LEAST_OF_INTERVAL: f64 = 0.1;
/// Maximum jump, relative to the derivative: at a pole it changes by more.
const LARGEST: f64 = 1e3;

/// Replaces the reason that steps up to `(t, x)` are too many by a jump nearby, if there is one.
/// Hybrid systems are excluded, since they jump at mode switches.
#[cold]
pub(crate) fn behind<S, T, const N: usize>(reason: Reason, system: &S, t: T, x: &SVector<T, N>) -> Reason
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    // steps that underflow may come to a pole, where the derivative changes within the resolution of the time
    if !matches!(reason, Reason::TooManySteps { .. }) || system.hybrid().is_some() {
        return reason;
    }
    let found = Line::new(system, t, x).jump();
    found.map_or(reason, |(component, by)| Reason::Jump { component, by })
}

/// Straight line through a state along its derivative, in both directions of time.
struct Line<'a, S: ?Sized, T, const N: usize> {
    system: &'a S,
    t: T,
    x: &'a SVector<T, N>,
    slope: SVector<T, N>,
    /// Largest component of the slope.
    size: T,
}

impl<'a, S: System<T, N> + ?Sized, T: Float, const N: usize> Line<'a, S, T, N> {
    fn new(system: &'a S, t: T, x: &'a SVector<T, N>) -> Self {
        let slope = system.rhs(t, x);
        let size = largest(&slope).1;
        Self {
            system,
            t,
            x,
            slope,
            size,
        }
    }

    fn at(&self, h: T) -> SVector<T, N> {
        self.system.rhs(self.t + h, &(self.x + self.slope * h))
    }

    /// Nearest jump: the component that jumps the most, and the size of its jump.
    fn jump(&self) -> Option<(usize, f64)> {
        if self.size == T::default() || !self.size.is_finite() {
            return None;
        }
        let own = largest(self.x).1 / self.size;
        let reach = T::from_f64(REACH) * own.max(T::EPSILON.sqrt() * self.t.abs()).max(T::MIN_POSITIVE.sqrt());
        let shortest = ulps(SHORTEST_ULPS, self.t.abs().max(reach));
        [reach, -reach].into_iter().find_map(|mut far| {
            while far.abs() >= T::from_f64(LEAST_INTERVAL) * shortest {
                let found = self.within(far, shortest);
                if found.is_some() {
                    return found;
                }
                far *= T::from_f64(0.5);
            }
            None
        })
    }

    /// Bisects the interval from the state to `far` to a jump, if a large part of the change of the derivative
    /// concentrates in one point.
    fn within(&self, mut far: T, shortest: T) -> Option<(usize, f64)> {
        let mut near = T::default();
        let whole = self.change(near, far).1;
        let least = (T::from_f64(LEAST) * self.size).max(T::from_f64(LEAST_OF_INTERVAL) * whole);
        while (far - near).abs() > shortest && self.change(near, far).1 > least {
            let middle = T::from_f64(0.5) * (near + far);
            if self.change(near, middle).1 > self.change(middle, far).1 {
                far = middle;
            } else {
                near = middle;
            }
        }
        let (component, by) = self.change(near, far);
        let is_jump = by > least && by < T::from_f64(LARGEST) * self.size;
        is_jump.then(|| (component, by.to_f64()))
    }

    /// Component of the derivative that changes the most between two positions, and its change.
    fn change(&self, from: T, to: T) -> (usize, T) {
        largest(&(self.at(to) - self.at(from)))
    }
}

fn largest<T: Float, const N: usize>(x: &SVector<T, N>) -> (usize, T) {
    let sizes = x.iter().map(|x| x.abs()).enumerate();
    sizes.fold(
        (0, T::default()),
        |most, next| if next.1 > most.1 { next } else { most },
    )
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use nalgebra::SVector;

    use crate::error::Reason;
    use crate::prelude::*;

    /// Reason why a motion from (1, 0) does not reach its end.
    fn reason(rhs: impl Fn(f64, &SVector<f64, 2>) -> SVector<f64, 2>, max_steps: usize) -> Reason {
        let method = Vern7::new().max_steps(max_steps);
        let error = method
            .solve(&FnSystem(rhs), 0.0, 100.0, [1.0, 0.0])
            .expect_err("too many steps");
        error.reason
    }

    #[test]
    fn a_law_that_switches_is_named() {
        let sliding = reason(
            |_, x| SVector::from([x[1], -3.0 * (x[0] + x[1]).signum() - 0.1 * x[0]]),
            20_000,
        );
        assert!(
            matches!(sliding, Reason::Jump { component: 1, by } if (5.9..6.1).contains(&by)),
            "{sliding}"
        );
    }

    #[test]
    fn noise_is_named() {
        let noise = |t: f64| (t.to_bits().wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 11) as f64 / (1_u64 << 53) as f64;
        let noisy = reason(|t, x| SVector::from([x[1], -x[0] + noise(t)]), 20_000);
        assert!(matches!(noisy, Reason::Jump { component: 1, .. }), "{noisy}");
    }

    #[test]
    fn small_jumps_are_named_from_rest_and_between_samples() {
        let from_rest = FnSystem(|_, x: &SVector<f64, 2>| SVector::from([x[1], 1.0 - 3.0 * (x[0] + x[1]).signum()]));
        let error = Vern7::new()
            .max_steps(5000)
            .solve(&from_rest, 0.0, 10.0, [0.0, 0.0])
            .expect_err("sliding");
        assert!(matches!(error.reason, Reason::Jump { component: 1, .. }), "{error}");
        let sampled = reason(
            |t, x| SVector::from([x[1], -x[0] + ((t * 100.0).floor() / 100.0).sin()]),
            1000,
        );
        assert!(
            matches!(sampled, Reason::Jump { component: 1, by } if by < 0.011),
            "{sampled}"
        );
    }

    #[test]
    fn steep_and_stiff_laws_do_not_jump() {
        let steep = |_, x: &SVector<f64, 2>| SVector::from([x[1], -3.0 * (1e6 * (x[0] + x[1])).tanh() - 0.1 * x[0]]);
        assert_eq!(reason(steep, 5000), Reason::TooManySteps { max_steps: 5000 });
        let stiff = |_, x: &SVector<f64, 2>| SVector::from([x[1], -1e8 * (x[0] + x[1] - 2.0)]);
        assert_eq!(reason(stiff, 5000), Reason::TooManySteps { max_steps: 5000 });
    }
}

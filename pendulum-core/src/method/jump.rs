//! Detection of discontinuities of a right-hand side that steps within a tolerance cannot cross.

use nalgebra::SVector;

use crate::error::Reason;
use crate::real::Float;
use crate::system::System;

/// Maximum number of times that the compared length is halved.
const LENGTHS: usize = 50;
/// Ratio of changes of the derivative over a length and over its half, beyond which a jump lies between: smooth changes
/// shrink by a few times.
const DROP: f64 = 100.0;
/// Minimum jump, relative to the derivative.
const LEAST: f64 = 1e-3;

/// Replaces the reason for which steps from `(t, x)` become too short or too many by a jump nearby, if there is one.
/// Hybrid systems are excluded, since they jump at mode switches.
#[cold]
pub(crate) fn behind<S, T, const N: usize>(reason: Reason, system: &S, t: T, x: &SVector<T, N>) -> Reason
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    let is_of_steps = matches!(
        reason,
        Reason::TooManySteps { .. } | Reason::StepUnderflow { .. } | Reason::NoConvergence { .. }
    );
    if !is_of_steps || system.hybrid().is_some() {
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
        let (one, half) = (T::from_f64(1.0), T::from_f64(0.5));
        // time in which the state would change by its own size
        let reach = largest(self.x).1.max(T::MIN_POSITIVE) / self.size;
        [one, -one].into_iter().find_map(|ahead| {
            let mut beyond = ahead * reach;
            let mut change = self.change(T::default(), beyond).1;
            for _ in 0..LENGTHS {
                let nearer = half * beyond;
                let next = self.change(T::default(), nearer).1;
                let drops = self.is_jump(change) && next * T::from_f64(DROP) < change;
                if drops && let Some(jump) = self.within(nearer, beyond) {
                    return Some(jump);
                }
                (beyond, change) = (nearer, next);
            }
            // a change that persists at every distance is noise
            self.is_jump(change)
                .then(|| self.within(T::default(), beyond))
                .flatten()
        })
    }

    /// Bisects an interval to a jump, if most of the change of the derivative concentrates in one point.
    fn within(&self, mut near: T, mut far: T) -> Option<(usize, f64)> {
        let whole = self.change(near, far).1;
        for _ in 0..LENGTHS {
            let middle = T::from_f64(0.5) * (near + far);
            if self.change(near, middle).1 > self.change(middle, far).1 {
                far = middle;
            } else {
                near = middle;
            }
        }
        let (component, by) = self.change(near, far);
        (by + by > whole).then(|| (component, by.to_f64()))
    }

    /// Component of the derivative that changes the most between two positions, and its change.
    fn change(&self, from: T, to: T) -> (usize, T) {
        largest(&(self.at(to) - self.at(from)))
    }

    fn is_jump(&self, change: T) -> bool {
        change > T::from_f64(LEAST) * self.size
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
    fn steep_and_stiff_laws_do_not_jump() {
        let steep = |_, x: &SVector<f64, 2>| SVector::from([x[1], -3.0 * (1e6 * (x[0] + x[1])).tanh() - 0.1 * x[0]]);
        assert_eq!(reason(steep, 5000), Reason::TooManySteps { max_steps: 5000 });
        let stiff = |_, x: &SVector<f64, 2>| SVector::from([x[1], -1e8 * (x[0] + x[1] - 2.0)]);
        assert_eq!(reason(stiff, 5000), Reason::TooManySteps { max_steps: 5000 });
    }
}

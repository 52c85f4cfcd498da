//! Witnesses that are polynomials of the dense output.

use core::convert::identity;

use nalgebra::SVector;

use super::Constraint;
use super::kinematics::Kinematics;
use super::witness::Witness;
#[cfg(feature = "std")]
use super::{Law, MAX_CONSTRAINTS};
use crate::method::{MAX_DEGREE, root};
use crate::real::Float;
use crate::real::lanes::Lanes;
use crate::taylor::MAX_ORDER;

/// Margin of the bounds of a polynomial for rounding errors, relative to the sum of its terms.
const SLACK: f64 = 1e-4;
/// Length of the shortest subinterval, relative to the distance of its end from the start of the step.
const SHORTEST: f64 = 1e-9;

/// Number of terms of a polynomial of any scheme but a Taylor series.
const FEW: usize = MAX_DEGREE + 1;
/// Number of terms of a polynomial of any scheme.
const MANY: usize = MAX_ORDER + 1;

/// A witness of a constraint, and the places of the positions and rates.
pub(super) type Watched<'a> = (&'a Constraint<'a>, Witness, Kinematics<'a>);

/// Lower bounds, over a step in lanes, of the rate of each constraint in its direction and of its distance from its
/// limits, where nothing is held. The mode of a lane does not end if both are positive. All rates are sums of
/// components of the state.
#[cfg(feature = "std")]
#[inline(always)]
pub(crate) fn room<V: Lanes, const N: usize>(
    (constraints, laws, kinematics): (&[Constraint], &[Law<V>; MAX_CONSTRAINTS], Kinematics<'_>),
    measures: &[[V; 2]; MAX_CONSTRAINTS],
    terms: &[SVector<V, N>],
) -> [[V; 2]; MAX_CONSTRAINTS] {
    let one = V::from_f64(1.0);
    let mut room = [[one; 2]; MAX_CONSTRAINTS];
    for (n, constraint) in constraints.iter().enumerate() {
        let [value, rate] = measures[n];
        // no closures: they might not be inlined
        let low = match laws[n].low {
            Some(low) => least((value - low, one), (constraint, Witness::Low, kinematics), terms),
            None => one,
        };
        let high = match laws[n].high {
            Some(high) => least((high - value, -one), (constraint, Witness::High, kinematics), terms),
            None => one,
        };
        let rate = least(
            (rate.abs(), rate.signum()),
            (constraint, Witness::Slip, kinematics),
            terms,
        );
        room[n] = [rate, (low - high).select(low, high)];
    }
    room
}

/// Lower bound of a witness over a step. `start` holds its value at the start and the sign of its changes; it changes
/// with a sum of components of the polynomial `x0 + c_1 theta + c_2 theta^2 + ..`.
#[cfg(feature = "std")]
#[inline(always)]
fn least<V: Lanes, const N: usize>(start: (V, V), witness: Watched<'_>, terms: &[SVector<V, N>]) -> V {
    if terms.len() < FEW {
        Polynomial::<V, FEW>::new(start, witness, terms, identity).least()
    } else {
        Polynomial::<V, MANY>::new(start, witness, terms, identity).least()
    }
}

/// True if the lower bound of a witness over a step is positive. Only values matter, so numbers with derivatives are
/// reduced to these.
pub(super) fn stays_positive<T: Float, const N: usize>(
    start: (f64, f64),
    witness: Watched<'_>,
    terms: &[SVector<T, N>],
) -> bool {
    if terms.len() < FEW {
        Polynomial::<f64, FEW>::new(start, witness, terms, T::to_f64).stays_positive()
    } else {
        Polynomial::<f64, MANY>::new(start, witness, terms, T::to_f64).stays_positive()
    }
}

/// Value of a rate that is a sum of components of the state.
pub(super) fn rate_of<T: Float, const N: usize>(constraint: &Constraint<'_>, x: &SVector<T, N>) -> f64 {
    let terms = constraint.rate.iter();
    terms.fold(0.0, |sum, &(component, its)| {
        sum + x[component].to_f64() * f64::from(its)
    })
}

/// Course of a witness over a step.
#[derive(Clone, Copy)]
pub(super) enum Course<T> {
    /// Positive, except for rounding errors at the start.
    Positive {
        /// Value at the end.
        end: T,
    },
    /// Positive up to its first zero.
    Zero {
        theta: T,
        /// Value halfway to the zero.
        halfway: T,
    },
    /// Not positive at the start.
    Unclear,
}

/// Determines the course of a witness that has been positive before (`is_positive`), or is zero at the start within
/// `noise`. Undershoots of at most `noise` do not count as zeros.
pub(super) fn course<T: Float, const N: usize>(
    start: (T, T),
    witness: Watched<'_>,
    terms: &[SVector<T, N>],
    (is_positive, noise): (bool, T),
) -> Course<T> {
    if terms.len() < FEW {
        Polynomial::<T, FEW>::new(start, witness, terms, identity).course(is_positive, noise)
    } else {
        Polynomial::<T, MANY>::new(start, witness, terms, identity).course(is_positive, noise)
    }
}

/// A polynomial over the fraction of a step, with its coefficients in ascending order.
struct Polynomial<V, const TERMS: usize> {
    coefficients: [V; TERMS],
    degree: usize,
}

impl<V: Lanes, const TERMS: usize> Polynomial<V, TERMS> {
    /// `number` converts the components of the terms.
    #[inline(always)]
    fn new<T: Lanes, const N: usize>(
        (value, sign): (V, V),
        (constraint, witness, kinematics): Watched<'_>,
        terms: &[SVector<T, N>],
        number: impl Fn(T) -> V,
    ) -> Self {
        let (mut coefficients, degree) = ([V::default(); TERMS], terms.len());
        for &(rate, its) in constraint.rate {
            let component = if witness.is_gap() {
                kinematics.position(rate)
            } else {
                rate
            };
            for (coefficient, term) in coefficients[1..].iter_mut().zip(terms) {
                *coefficient += number(term[component]) * V::from_f64(f64::from(its));
            }
        }
        coefficients[1..=degree]
            .iter_mut()
            .for_each(|coefficient| *coefficient *= sign);
        coefficients[0] = value;
        Self { coefficients, degree }
    }

    /// Bernstein coefficients, which bound the polynomial (G. Farin, "Curves and Surfaces for CAGD" 2002, Sec. 5.1).
    #[inline(always)]
    fn bernstein(&self) -> [V; TERMS] {
        let (mut sums, mut choices) = (self.coefficients, 1.0);
        for (power, sum) in sums[1..=self.degree].iter_mut().enumerate() {
            // divide by the binomial coefficient
            choices *= (self.degree - power) as f64 / (power + 1) as f64;
            *sum *= V::from_f64(1.0 / choices);
        }
        for first in 0..self.degree {
            for n in (first..self.degree).rev() {
                let sum = sums[n];
                sums[n + 1] += sum;
            }
        }
        sums
    }

    /// Sum of the sizes of all terms but the constant.
    #[inline(always)]
    fn size(&self) -> V {
        let terms = self.coefficients[1..=self.degree].iter();
        terms.fold(V::default(), |sum, term| sum + term.abs())
    }

    #[inline(always)]
    fn least(&self) -> V {
        let bernstein = self.bernstein();
        let least = |least: V, &other: &V| (least - other).select(least, other);
        bernstein[1..=self.degree].iter().fold(bernstein[0], least) - self.size() * V::from_f64(SLACK)
    }
}

impl<const TERMS: usize> Polynomial<f64, TERMS> {
    fn stays_positive(&self) -> bool {
        // usually the terms are too small to reach zero
        self.coefficients[0] > self.size() * (1.0 + SLACK) || self.least() > 0.0
    }
}

impl<T: Float, const TERMS: usize> Polynomial<T, TERMS> {
    fn course(&self, is_positive: bool, noise: T) -> Course<T> {
        let (zero, start) = (T::default(), self.coefficients[0]);
        let end = self.at(T::from_f64(1.0));
        if !end.is_finite() {
            return Course::Unclear;
        }
        let root = if is_positive && start > zero {
            self.first_zero(&self.bernstein(), (zero, T::from_f64(1.0)), noise)
        } else if !is_positive && start >= -noise && self.degree > 0 {
            let slope = self.divided();
            let bernstein = slope.bernstein();
            let slack = slope.size() * T::from_f64(SLACK);
            let (first, others) = (bernstein[0], &bernstein[1..self.degree]);
            // a constraint that breaks loose has no acceleration yet
            if first.abs() <= slack && !others.is_empty() && others.iter().all(|&other| other > slack) {
                return Course::Positive { end };
            }
            if first <= slack {
                return Course::Unclear;
            }
            let root = slope.first_zero(&bernstein, (zero, T::from_f64(1.0)), zero);
            if root.is_some_and(|root| self.at(root * T::from_f64(0.5)) <= noise) {
                return Course::Unclear;
            }
            root
        } else {
            return Course::Unclear;
        };
        match root {
            Some(theta) => Course::Zero {
                theta,
                halfway: self.at(theta * T::from_f64(0.5)),
            },
            None => Course::Positive { end },
        }
    }

    fn at(&self, theta: T) -> T {
        let powers = self.coefficients[..=self.degree].iter().rev();
        powers.fold(T::default(), |sum, &coefficient| sum * theta + coefficient)
    }

    /// Without its constant term, divided by the fraction of the step.
    fn divided(&self) -> Self {
        let mut coefficients = [T::default(); TERMS];
        coefficients[..self.degree].copy_from_slice(&self.coefficients[1..=self.degree]);
        Self {
            coefficients,
            degree: self.degree - 1,
        }
    }

    /// First zero in a subinterval, given the Bernstein coefficients there, of which the first is positive. Undershoots
    /// of at most `noise` do not count.
    ///
    /// Coefficients that change their sign once have exactly one zero. Otherwise the interval is bisected (J. M. Lane,
    /// R. F. Riesenfeld, "Bounds on a polynomial", BIT 21 (1981) 112-117).
    fn first_zero(&self, bernstein: &[T; TERMS], (from, to): (T, T), noise: T) -> Option<T> {
        let zero = T::default();
        let coefficients = &bernstein[..=self.degree];
        let (first, last) = (coefficients[0], coefficients[self.degree]);
        if last > zero && coefficients.iter().all(|&coefficient| coefficient >= -noise) {
            return None;
        }
        let changes = coefficients
            .windows(2)
            .filter(|pair| (pair[0] > zero) != (pair[1] > zero));
        if changes.count() == 1 && last <= zero {
            return Some(root(|theta| self.at(theta), (from, first), (to, last)));
        }
        if to - from <= T::from_f64(SHORTEST) * to || to <= T::EPSILON {
            return (last <= zero).then_some(to);
        }
        let half = T::from_f64(0.5);
        let (mut left, mut right) = (*bernstein, *bernstein);
        for n in 0..self.degree {
            // de Casteljau's algorithm: the ends of its rows are the coefficients of the halves
            for m in 0..self.degree - n {
                right[m] = (right[m] + right[m + 1]) * half;
            }
            left[n + 1] = right[0];
        }
        let middle = from + (to - from) * half;
        let of_left = self.first_zero(&left, (from, middle), noise);
        of_left.or_else(|| self.first_zero(&right, (middle, to), noise))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::{Constraint, Kinematics, Witness, rate_of, stays_positive};
    use crate::dual::Dual;

    /// A rate `1 - a theta + b theta^2`, with derivatives that change sign.
    fn proves_that_it_is_positive(a: f64, b: f64) -> bool {
        let constraint = Constraint {
            name: "slip",
            rate: &[(1, 1), (0, -1)],
        };
        let number = |value: f64| Dual::<f64, 1> {
            value,
            slopes: [-1e3 * value],
        };
        let state = |x: [f64; 2]| SVector::from(x.map(number));
        // backward
        let (start, terms) = (state([1.5, 0.5]), [state([-a, 0.0]), state([0.0, -b])]);
        let start = -rate_of(&constraint, &start);
        stays_positive(
            (start, -1.0),
            (&constraint, Witness::Slip, Kinematics::default()),
            &terms,
        )
    }

    #[test]
    fn bounds_of_a_slip_are_those_of_its_values() {
        for (a, b, expected) in [
            (0.5, 0.4, true),
            // positive by the Bernstein coefficients 1, 1 - a / 2, 1 - a + b alone
            (1.5, 0.6, true),
            (1.5, 0.4, false),
            (2.1, 2.0, false),
        ] {
            assert_eq!(proves_that_it_is_positive(a, b), expected, "{a} {b}");
        }
    }
}

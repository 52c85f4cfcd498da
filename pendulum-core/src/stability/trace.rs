//! Tracing of a curve, and location of its bifurcations.

use std::mem;

use nalgebra::DVector;

use super::branch::{Bifurcation, Branch, BranchEnd, BranchPoint};
use super::curve::{Curve, CurvePoint, Growth, Test, correct, first_tangent};
use super::{BifurcationKind, StabilityError};

/// Settings for tracing a curve. Lengths and parameters are scaled.
pub(super) struct Tracer<'c, C, const N: usize> {
    pub(super) curve: &'c C,
    /// Range of the parameter.
    pub(super) span: (f64, f64),
    /// Largest step size.
    pub(super) step: f64,
    /// Maximum number of points in each direction.
    pub(super) points: usize,
    /// Ratio of the original to the scaled parameter.
    pub(super) unit: f64,
}

/// Minimum cosine of the angle between successive tangents; larger turns shorten the step.
const TURN: f64 = 0.95;
/// Smallest step size relative to the largest.
const LEAST: f64 = 1e-6;
/// Offset of the next sample from the estimated root, relative to the bracket.
const MARGIN: f64 = 0.1;
/// Change of the scaled parameter below which the search for a bifurcation has converged.
const LOCATED: f64 = 1e-11;
/// Maximum distance, in points, between a bifurcation and an uncertain change of stability attributed to it.
const NEAR: usize = 2;
/// Safety factor of error estimates that compare with a more accurate result.
const SAFETY: f64 = 2.0;
/// A test function without zero.
const NEVER: Test = Test { value: 1.0, noise: 0.0 };

impl<C: Curve<N>, const N: usize> Tracer<'_, C, N> {
    /// Traces the branch through `u` in both directions.
    pub(super) fn branch(&self, u: DVector<f64>) -> Result<Branch<C::Solution>, StabilityError> {
        let tangent = first_tangent(self.curve, &u)?;
        let start = correct(self.curve, u.clone(), (&tangent, tangent.dot(&u)), &tangent)?;
        let (mut ahead, last) = self.walk(start.clone());
        let (places, first) = if last == BranchEnd::Closed {
            ahead.insert(0, start);
            (ahead, BranchEnd::Closed)
        } else {
            let (behind, first) = self.walk(start.clone().reverse());
            let mut places: Vec<_> = behind.into_iter().rev().map(CurvePoint::reverse).collect();
            places.push(start);
            places.append(&mut ahead);
            (places, first)
        };
        let bifurcations = self.bifurcations(&places);
        let point = |place: CurvePoint<C::Solution>| BranchPoint {
            parameter: place.parameter() * self.unit,
            solution: place.solution,
        };
        Ok(Branch {
            points: places.into_iter().map(point).collect(),
            bifurcations,
            ends: [first, last],
        })
    }

    /// Points after `start` in the direction of its tangent, and the reason for the end.
    fn walk(&self, start: CurvePoint<C::Solution>) -> (Vec<CurvePoint<C::Solution>>, BranchEnd) {
        let mut places: Vec<CurvePoint<C::Solution>> = Vec::new();
        let mut length = 0.1 * self.step;
        while places.len() < self.points {
            let last = places.last().unwrap_or(&start);
            let bound = if last.slope() < 0.0 { self.span.0 } else { self.span.1 };
            let left = (bound - last.parameter()) / last.slope();
            if left.abs() <= LEAST * self.step && last.slope() != 0.0 {
                return (places, BranchEnd::Span);
            }
            let next = match self.next(last, length, (bound, left)) {
                Ok(next) => next,
                Err(_) if length > LEAST * self.step => {
                    length *= 0.5;
                    continue;
                }
                Err(error) => return (places, BranchEnd::Failed(error)),
            };
            if next.tangent.dot(&last.tangent) < TURN && length > LEAST * self.step {
                length *= 0.5;
                continue;
            }
            if places.len() > 1 && self.passes(last, &next, &start) {
                // modulo full turns
                let mut end = start.clone();
                end.u = &last.u + self.curve.apart(&last.u, &end.u);
                places.push(end);
                return (places, BranchEnd::Closed);
            }
            if next.iterations <= 4 {
                length = (1.5 * length).min(self.step);
            }
            let at_bound = (next.parameter() - bound).abs() <= 1e-14 * (1.0 + bound.abs());
            places.push(next);
            if at_bound {
                return (places, BranchEnd::Span);
            }
        }
        (places, BranchEnd::Points)
    }

    /// Next point after `last`: at the distance `length`, or at the bound of the parameter if its distance `left` is
    /// smaller.
    fn next(
        &self,
        last: &CurvePoint<C::Solution>,
        length: f64,
        (bound, left): (f64, f64),
    ) -> Result<CurvePoint<C::Solution>, StabilityError> {
        let to_bound = |guess: DVector<f64>| {
            let mut parameter = DVector::zeros(guess.len());
            parameter[guess.len() - 1] = 1.0;
            correct(self.curve, guess, (&parameter, bound), &last.tangent)
        };
        let mut next = if left <= length {
            to_bound(&last.u + &last.tangent * left)?
        } else {
            self.at(last, length)?
        };
        // The curve may bend across the bound.
        if left > length && (next.parameter() - bound) * last.slope() > 0.0 {
            let part = (bound - last.parameter()) / (next.parameter() - last.parameter());
            next = to_bound(&last.u + (&next.u - &last.u) * part)?;
        }
        self.curve.joins(&last.u, &next.u)?;
        Ok(next)
    }

    /// Point at the distance `length` from `from`, along its tangent.
    fn at(&self, from: &CurvePoint<C::Solution>, length: f64) -> Result<CurvePoint<C::Solution>, StabilityError> {
        let target = from.tangent.dot(&from.u) + length;
        let guess = &from.u + &from.tangent * length;
        correct(self.curve, guess, (&from.tangent, target), &from.tangent)
    }

    /// True if the segment from `last` to `next` passes `place`, modulo full turns.
    fn passes(
        &self,
        last: &CurvePoint<C::Solution>,
        next: &CurvePoint<C::Solution>,
        place: &CurvePoint<C::Solution>,
    ) -> bool {
        let way = &next.u - &last.u;
        let to = self.curve.apart(&last.u, &place.u);
        let part = to.dot(&way) / way.norm_squared();
        (0.0..1.0).contains(&part)
            && (to - &way * part).norm() < 0.1 * way.norm()
            && place.tangent.dot(&last.tangent) > TURN
    }

    /// Bifurcations between the points of a branch.
    fn bifurcations(&self, places: &[CurvePoint<C::Solution>]) -> Vec<Bifurcation<C::Solution>> {
        let mut found = Findings::default();
        for (behind, pair) in places.windows(2).enumerate() {
            self.find(&pair[0], &pair[1], behind, &mut found);
        }
        let Findings {
            mut named,
            quiet,
            mut unnamed,
        } = found;
        // Growth below its uncertainty may become visible before or after the bifurcation that causes it
        for behind in quiet {
            let near = |other: &Bifurcation<C::Solution>| other.behind.abs_diff(behind) <= NEAR;
            if let Some(at) = unnamed.iter().position(near) {
                unnamed.remove(at);
            }
        }
        named.append(&mut unnamed);
        let rises = |behind: usize| places[behind + 1].parameter() >= places[behind].parameter();
        named.sort_by(|a, b| {
            let along = a.parameter.total_cmp(&b.parameter);
            let along = if rises(a.behind) { along } else { along.reverse() };
            a.behind.cmp(&b.behind).then(along)
        });
        named
    }

    /// Finds the bifurcations between two adjacent points. The number of growing modes changes by one if a real
    /// eigenvalue crosses the stability limit, and by two for a complex pair.
    fn find(
        &self,
        a: &CurvePoint<C::Solution>,
        b: &CurvePoint<C::Solution>,
        behind: usize,
        found: &mut Findings<C::Solution>,
    ) {
        let passes = |test: &dyn Fn(&CurvePoint<C::Solution>) -> Test| {
            let (a, b) = (test(a), test(b));
            a.is_negative() != b.is_negative() && (a.is_certain() || b.is_certain())
        };
        let bifurcation = |kind, located: Located<C::Solution>| Bifurcation {
            kind,
            parameter: located.parameter * self.unit,
            uncertainty: located.uncertainty * self.unit,
            solution: located.solution,
            behind,
        };
        let mut changed: Vec<usize> = (0..a.growths.len().min(b.growths.len()))
            .filter(|&i| passes(&growth(i, a, b)))
            .collect();
        let slope = |place: &CurvePoint<C::Solution>| Test {
            value: place.slope(),
            noise: 0.0,
        };
        let doubling = |place: &CurvePoint<C::Solution>| place.doubling.unwrap_or(NEVER);
        let mut real = Vec::new();
        if passes(&|place| place.crossing) {
            // prefer the test function without parameter derivatives if it changes sign as well
            let turns = passes(&|place| place.turning);
            let test = |place: &CurvePoint<C::Solution>| if turns { place.turning } else { place.crossing };
            real.push((BifurcationKind::Crossing, C::REAL_LIMIT, self.locate(a, b, test)));
        } else if passes(&slope) {
            real.push((BifurcationKind::Fold, C::REAL_LIMIT, self.locate(a, b, slope)));
        }
        if passes(&doubling) {
            real.push((BifurcationKind::PeriodDoubling, -1.0, self.locate(a, b, doubling)));
        }
        for (kind, limit, located) in real {
            match nearest(&changed, limit, &self.curve.growths(&located.solution)) {
                Some(nearest) => drop(changed.remove(nearest)),
                None => found.quiet.push(behind),
            }
            found.named.push(bifurcation(kind, located));
        }
        let mut changed = changed.into_iter().peekable();
        while let Some(i) = changed.next() {
            let located = self.locate(a, b, growth(i, a, b));
            let here = self.curve.growths(&located.solution)[i];
            let are_two = changed.next_if_eq(&(i + 1)).is_some();
            if are_two && here.value.im != 0.0 {
                found.named.push(bifurcation(self.curve.of_pair(&here), located));
            } else if [a, b].iter().all(|place| place.growths[i].is_certain()) {
                found.unnamed.push(bifurcation(BifurcationKind::Unnamed, located));
            }
        }
    }

    /// Root of a test function between two adjacent points.
    ///
    /// Method of false position, with samples offset from the estimated root by [`MARGIN`]. The bracket therefore
    /// shrinks from both ends, and no sample coincides with the root, where Newton's method could switch to a crossing
    /// curve.
    fn locate(
        &self,
        a: &CurvePoint<C::Solution>,
        b: &CurvePoint<C::Solution>,
        test: impl Fn(&CurvePoint<C::Solution>) -> Test,
    ) -> Located<C::Solution> {
        let origin = a.tangent.dot(&a.u);
        let mut low = (0.0, test(a), a.clone());
        let mut high = (a.tangent.dot(&b.u) - origin, test(b), b.clone());
        let zero = |low: &Sample<C::Solution>, high: &Sample<C::Solution>| {
            let part = low.1.value / (low.1.value - high.1.value);
            (part, between((low.0, &low.2), (high.0, &high.2), part, &a.tangent))
        };
        let (mut part, mut u) = zero(&low, &high);
        let (mut change, mut width, mut steepness) = (f64::INFINITY, high.0, 0.0);
        for evaluation in 1..=100 {
            // Every third evaluation bisects the bracket if it has not halved otherwise.
            let is_slow = evaluation % 3 == 0 && high.0 - low.0 > 0.5 * mem::replace(&mut width, high.0 - low.0);
            let aside = match part {
                _ if is_slow => 0.5,
                part if part < 0.5 => part + MARGIN,
                part => part - MARGIN,
            };
            let at = low.0 + (high.0 - low.0) * aside;
            let guess = between((low.0, &low.2), (high.0, &high.2), aside, &a.tangent);
            let Ok(place) = correct(self.curve, guess, (&a.tangent, origin + at), &low.2.tangent) else {
                break;
            };
            let value = test(&place);
            let end = if value.is_negative() == high.1.is_negative() {
                &mut high
            } else {
                &mut low
            };
            *end = (at, value, place);
            // slope of the test function with respect to the parameter, updated while the change exceeds the errors
            let rise = (high.1.value - low.1.value).abs();
            if steepness == 0.0 || rise > 10.0 * value.noise {
                steepness = rise / (high.2.parameter() - low.2.parameter()).abs();
            }
            let before = u[u.len() - 1];
            (part, u) = zero(&low, &high);
            let last = mem::replace(&mut change, (u[u.len() - 1] - before).abs());
            // An iterate stuck at one end of the bracket, as for a test that is flat on one side, must not count as
            // converged.
            let is_told = change.max(last) < LOCATED && (0.01..=0.99).contains(&part);
            if is_told || high.0 - low.0 < LOCATED {
                break;
            }
        }
        let parameter = u[u.len() - 1];
        let [of_test, apart] = self.errors(&u, &a.tangent, &test);
        let noise = low.1.noise.max(high.1.noise) + of_test;
        let by_noise = if noise == 0.0 { 0.0 } else { noise / steepness };
        Located {
            parameter,
            uncertainty: change + apart + low.2.blur + by_noise,
            solution: self.curve.solution(&u).unwrap_or(low.2.solution),
        }
    }

    /// Errors of the test function at its root, and of the parameter, caused by errors of the equations.
    fn errors(
        &self,
        u: &DVector<f64>,
        tangent: &DVector<f64>,
        test: impl Fn(&CurvePoint<C::Solution>) -> Test,
    ) -> [f64; 2] {
        let Some(finer) = self.curve.finer() else {
            return [0.0; 2];
        };
        let Ok(place) = correct(&finer, u.clone(), (tangent, tangent.dot(u)), tangent) else {
            return [f64::INFINITY; 2];
        };
        [test(&place).value, place.parameter() - u[u.len() - 1]].map(|error| SAFETY * error.abs())
    }
}

/// Excess of the `i`-th growth over the stability limit. If modes neither grow nor decay, as without friction, the
/// limit is raised by the uncertainty.
fn growth<P>(i: usize, a: &CurvePoint<P>, b: &CurvePoint<P>) -> impl Fn(&CurvePoint<P>) -> Test + use<P> {
    let are_certain = a.growths[i].is_certain() && b.growths[i].is_certain();
    let margin = if are_certain { 0.0 } else { 1.0 };
    move |place| {
        let Growth {
            excess,
            uncertainty,
            rounding,
            ..
        } = place.growths[i];
        Test {
            value: excess - margin * uncertainty,
            noise: rounding,
        }
    }
}

/// Index in `changed` of the growth whose eigenvalue or multiplier is closest to a real limit.
fn nearest(changed: &[usize], limit: f64, growths: &[Growth]) -> Option<usize> {
    let apart = |i: usize| {
        let growth = growths.get(changed[i]);
        growth.map_or(f64::INFINITY, |growth| (growth.value - limit).norm())
    };
    (0..changed.len()).min_by(|&m, &n| apart(m).total_cmp(&apart(n)))
}

/// Bifurcations along a branch, before changes of stability are matched.
struct Findings<P> {
    named: Vec<Bifurcation<P>>,
    /// Intervals in which a real eigenvalue crosses the limit without a significant change of stability.
    quiet: Vec<usize>,
    /// Changes of stability without an identified bifurcation.
    unnamed: Vec<Bifurcation<P>>,
}

impl<P> Default for Findings<P> {
    fn default() -> Self {
        Self {
            named: Vec::new(),
            quiet: Vec::new(),
            unnamed: Vec::new(),
        }
    }
}

/// A located bifurcation, with scaled parameter.
struct Located<P> {
    parameter: f64,
    uncertainty: f64,
    solution: P,
}

/// Distance along the segment, value of a test function, and point of the curve.
type Sample<P> = (f64, Test, CurvePoint<P>);

/// Point at the fraction `part` between two points of a curve, by cubic Hermite interpolation. `from` and `to` are
/// their distances along `normal`.
fn between<P>(
    (from, low): (f64, &CurvePoint<P>),
    (to, high): (f64, &CurvePoint<P>),
    part: f64,
    normal: &DVector<f64>,
) -> DVector<f64> {
    let slope = |place: &CurvePoint<P>| &place.tangent * ((to - from) / place.tangent.dot(normal));
    let rest = 1.0 - part;
    let way = &high.u - &low.u;
    &low.u + &way * part + ((slope(low) - &way) * rest - (slope(high) - &way) * part) * (part * rest)
}

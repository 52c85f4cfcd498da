//! Following a curve, and finding what happens on it.

use std::mem;

use nalgebra::DVector;

use super::branch::{Bifurcation, Branch, BranchEnd, BranchPoint};
use super::curve::{Curve, CurvePoint, Growth, Test, correct, first_tangent};
use super::{BifurcationKind, StabilityError};

/// How a curve is followed; lengths and parameters are scaled.
pub(super) struct Tracer<'c, C, const N: usize> {
    pub(super) curve: &'c C,
    /// The span of the parameter.
    pub(super) span: (f64, f64),
    /// The longest step.
    pub(super) step: f64,
    /// The points allowed in each direction.
    pub(super) points: usize,
    /// The parameter as it was given, over the scaled one.
    pub(super) unit: f64,
}

/// Steps are shortened where the curve turns by more, as the cosine of the angle.
const TURN: f64 = 0.95;
/// The shortest step, in parts of the longest.
const LEAST: f64 = 1e-6;
/// How far beside the place that is told the next is looked at, in parts of the bracket.
const MARGIN: f64 = 0.1;
/// Changes of the scaled parameter below this end the search for a bifurcation.
const LOCATED: f64 = 1e-11;
/// Changes of stability belong to a bifurcation that is so many places away at most, where they are not certain there.
const NEAR: usize = 2;
/// Errors are larger than they look beside smaller ones.
const SAFETY: f64 = 2.0;
/// A test that passes zero nowhere.
const NEVER: Test = Test { value: 1.0, noise: 0.0 };

impl<C: Curve<N>, const N: usize> Tracer<'_, C, N> {
    /// The branch through `u`, both ways.
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

    /// The places after `start`, in the direction of its tangent, and why there are no more.
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
                // on this side of full turns
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

    /// The place after `last`, at the distance `length`, or at the bound of the parameter if that is nearer; `left` is
    /// the distance to it.
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
        // The curve may bend beyond the bound.
        if left > length && (next.parameter() - bound) * last.slope() > 0.0 {
            let part = (bound - last.parameter()) / (next.parameter() - last.parameter());
            next = to_bound(&last.u + (&next.u - &last.u) * part)?;
        }
        self.curve.joins(&last.u, &next.u)?;
        Ok(next)
    }

    /// The place at the distance `length` from another, along its tangent.
    fn at(&self, from: &CurvePoint<C::Solution>, length: f64) -> Result<CurvePoint<C::Solution>, StabilityError> {
        let target = from.tangent.dot(&from.u) + length;
        let guess = &from.u + &from.tangent * length;
        correct(self.curve, guess, (&from.tangent, target), &from.tangent)
    }

    /// Whether the way from `last` to `next` leads through `place`, up to full turns.
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

    /// The bifurcations along the places of a branch.
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
        // growth that is no larger than its uncertainty shows before, or only after, what makes it
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

    /// Notes what happens between two neighbours. The number of motions that grow changes by one where a real
    /// eigenvalue passes the limit, and by two where a pair does.
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
            // located by the test that needs no derivatives by the parameter, if that changes its sign as well
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

    /// Where between two neighbours the test passes zero.
    ///
    /// The rule of false position, with a point to either side of where it tells: the two close in, and neither comes
    /// as near as the curve is known. Where another curve crosses, Newton's method might leave this one.
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
            // Each third halves the bracket, if it does not shrink otherwise.
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
            // how the test changes with the parameter, as long as more than its errors do so
            let rise = (high.1.value - low.1.value).abs();
            if steepness == 0.0 || rise > 10.0 * value.noise {
                steepness = rise / (high.2.parameter() - low.2.parameter()).abs();
            }
            let before = u[u.len() - 1];
            (part, u) = zero(&low, &high);
            let last = mem::replace(&mut change, (u[u.len() - 1] - before).abs());
            // What hugs an end of the bracket, as where a test is flat to one side, is not told by its changes.
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

    /// The errors that those of the equations cause in the test, where it is zero, and in the parameter.
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

/// How far the `i`-th of the growths is beyond the limit. Where motions neither grow nor decay, as without friction,
/// growth begins beyond the uncertainty.
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

/// The position in `changed` of the growth whose eigenvalue or multiplier is closest to a real limit.
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
    /// Behind which places real eigenvalues pass the limit without a change of stability that is certain.
    quiet: Vec<usize>,
    /// Changes of stability of which nothing is named.
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

/// A bifurcation that was located, with its parameter scaled.
struct Located<P> {
    parameter: f64,
    uncertainty: f64,
    solution: P,
}

/// A place on a curve behind its distance along the way, and the value of a test there.
type Sample<P> = (f64, Test, CurvePoint<P>);

/// The point at the part `part` of the way between two places on a curve, from the cubic with the tangents at both; the
/// numbers are their distances along `normal`.
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

//! Toggles: singularities of closed loops, where a loop is flat and assemblies branch. No step ends near a toggle, or
//! beyond one.

use nalgebra::SVector;

use crate::error::{AT_TOGGLE, Name, Reason};
use crate::method::scheme::StepFailure;
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};
use crate::system::System;

/// Minimum margin at the end of a step.
const LEAST: f64 = 1e-3;
/// Margin at the end of a step below which both of its ends are checked.
const NEAR: f64 = 0.25;
/// Number of steps over which a margin is extrapolated at its rate. If it reaches zero back from the end of a step,
/// both ends are checked; if it does so forward from the start, the step is rejected.
const REACH: f64 = 2.0;
/// Angle, in rad, whose sine is the margin. If it turns further than this within a step, the ends of [`PLACES`] parts
/// of the step are checked.
const TURN: f64 = 0.75;
/// Number of equal parts of a long step, whose ends are checked for a toggle.
const PLACES: usize = 16;
/// Minimum of a squared margin on the way, relative to the larger one at the ends, below which it may be zero.
const LOW: f64 = 0.1;

/// Projects the end of a step onto the constraints of its system. The end becomes NaN if a loop reaches its toggle on
/// the way.
#[inline(always)]
pub(super) fn end_step<S, T, const N: usize>(
    system: &S,
    start: (T, &SVector<T, N>),
    (t_new, x_new): (T, &mut SVector<T, N>),
) where
    S: System<T, N> + ?Sized,
    T: Lanes,
{
    system.project(t_new, x_new);
    stop_at_toggles(system, start, (t_new, x_new));
}

/// Sets the end of a step to NaN if a loop reaches its toggle on the way.
#[inline(always)]
pub(super) fn stop_at_toggles<S, T, const N: usize>(
    system: &S,
    start: (T, &SVector<T, N>),
    (t_new, x_new): (T, &mut SVector<T, N>),
) where
    S: System<T, N> + ?Sized,
    T: Lanes,
{
    let end = (t_new, &*x_new);
    let stopped = Way { system, start, end }.stopped();
    if stopped != 0 {
        let x = x_new[0];
        let nan = T::Scalar::from_f64(f64::NAN);
        x_new[0] = T::from_fn(|lane| if stopped & 1 << lane == 0 { x.lane(lane) } else { nan });
    }
}

/// Replaces the reason for which equations fail within a step from `(t, x)` by the toggle that causes it, if there is
/// one.
#[cold]
pub(crate) fn behind<S, T, const N: usize>(reason: Reason, system: &S, t: T, x: &SVector<T, N>) -> Reason
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    let (Reason::NonFinite { h: Some(h), .. } | Reason::NoConvergence { h }) = reason else {
        return reason;
    };
    let (mut found, mut least) = (reason, f64::INFINITY);
    system.margins(t, x, &mut |bodies, [margin, rate]| {
        let (margin, change) = (margin.to_f64(), h * rate.to_f64());
        let may_come = margin + REACH * change < 0.0 || room_to_turn(margin, change) < 0.0;
        if margin < least && (margin < AT_TOGGLE || may_come) {
            let reason = match bodies {
                [coordinate, ""] => Reason::HalfTurn {
                    coordinate: coordinate.into(),
                },
                _ => Reason::Toggle {
                    bodies: bodies.map(Name::from),
                    margin,
                },
            };
            (found, least) = (reason, margin);
        }
    });
    found
}

/// True if steps of this length from the time `t` stagnate before the end of the domain of the equations.
#[cold]
pub(crate) fn creeps<T: Float>(h: T, t: T) -> bool {
    h < T::EPSILON.sqrt() * t.abs()
}

/// Reports a failed attempt from `t` to `t_new`.
///
/// # Errors
/// The toggle that causes the failure, if there is one.
#[cold]
pub(crate) fn reached<S, T, const N: usize>(
    failure: StepFailure,
    system: &S,
    (t, t_new): (T, T),
    x: &SVector<T, N>,
) -> Result<(), Reason>
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    match behind(failure.reason((t_new - t).to_f64()), system, t, x) {
        toggle @ (Reason::Toggle { .. } | Reason::HalfTurn { .. }) => Err(toggle),
        _ => Ok(()),
    }
}

/// Path from the start of a step to its end.
struct Way<'a, S: ?Sized, T, const N: usize> {
    system: &'a S,
    start: (T, &'a SVector<T, N>),
    end: (T, &'a SVector<T, N>),
}

impl<S: System<T, N> + ?Sized, T: Lanes, const N: usize> Way<'_, S, T, N> {
    /// Lanes in which a loop reaches its toggle.
    #[inline(always)]
    fn stopped(&self) -> u64 {
        let ((t0, _), (t, x)) = (self.start, self.end);
        let mut roots = T::default();
        self.system.margins(t, x, &mut |_, [margin, rate]| {
            let change = (t - t0) * rate;
            let near = margin - T::from_f64(NEAR);
            let reached = margin - T::from_f64(REACH) * change;
            let least = (near - reached).select(near, reached);
            let turn = room_to_turn(margin, change);
            // NaN if one of them is negative
            roots += (least - turn).select(least, turn).sqrt();
        });
        if roots.all_finite() {
            return 0;
        }
        // lanes must be independent, so each of them is checked by its own values
        let in_doubt = lanes::<T>(|lane| !roots.lane(lane).is_finite());
        in_doubt & self.stopped_in_doubt()
    }

    /// Checks both ends of the step, and the path between them, in every lane.
    #[cold]
    fn stopped_in_doubt(&self) -> u64 {
        let [start, end] = [self.start, self.end].map(|(t, x)| (t, *x));
        let (mut stopped, mut n) = (0, 0);
        while let (Some(first), Some(last)) = (self.margin(n, &start), self.margin(n, &end)) {
            let long = lanes::<T>(|lane| [first, last].into_iter().any(|margin| turns(margin, lane)));
            stopped |= lanes::<T>(|lane| is_flat(last, lane) || reaches(first, lane));
            stopped |= !long & lanes::<T>(|lane| may_pass([first, last], lane));
            if long & !stopped != 0 {
                stopped |= long & self.stopped_between(n);
            }
            n += 1;
        }
        stopped
    }

    /// Lanes in which a loop reaches its toggle, in a step too long to be judged by its ends.
    #[cold]
    fn stopped_between(&self, n: usize) -> u64 {
        let part = T::from_f64(1.0 / PLACES as f64);
        let mut stopped = 0;
        let mut before: Option<[T; 2]> = None;
        for k in (0..=PLACES).rev() {
            let (t, mut x) = self.at(T::from_f64(k as f64) * part);
            self.system.project(t, &mut x);
            let Some([margin, change]) = self.margin(n, &(t, x)) else {
                continue;
            };
            let here = [margin, change * part];
            stopped |= lanes::<T>(|lane| is_flat(here, lane) || reaches(here, lane));
            if let Some(before) = before {
                stopped |= lanes::<T>(|lane| may_pass([before, here], lane));
            }
            before = Some(here);
        }
        stopped
    }

    /// State at a fraction `back` of the path from its end. Coordinates follow Hermite's cubic, since they may turn on
    /// the way.
    fn at(&self, back: T) -> (T, SVector<T, N>) {
        let ((t0, x0), (t1, x1)) = (self.start, self.end);
        let (h, ahead) = (t1 - t0, T::from_f64(1.0) - back);
        let mut x = x1 + (x0 - x1) * back;
        for slot in self.system.layout().into_iter().flat_map(|layout| layout.slots) {
            if slot.positions.len() == 1 && slot.rates.len() == 1 {
                let (k, rate) = (slot.positions.start, slot.rates.start);
                let way = x1[k] - x0[k];
                let [from_start, to_end] = [x0, x1].map(|x| h * x[rate] - way);
                let beside = from_start * back - to_end * ahead;
                x[k] += back * ahead * beside;
                x[rate] = (way - (ahead - back) * beside - back * ahead * (from_start + to_end)) / h;
            }
        }
        (t1 - h * back, x)
    }

    /// Margin of a loop, and its change within a step at its rate.
    fn margin(&self, number: usize, (t, x): &(T, SVector<T, N>)) -> Option<[T; 2]> {
        let h = self.end.0 - self.start.0;
        let (mut found, mut n) = (None, 0);
        self.system.margins(*t, x, &mut |_, [margin, rate]| {
            if n == number {
                found = Some([margin, h * rate]);
            }
            n += 1;
        });
        found
    }
}

/// Remaining angle, squared, by which a loop may turn before [`TURN`]; negative if there is none left. The margin is
/// the sine of the angle.
#[inline(always)]
fn room_to_turn<T: Real>(margin: T, change: T) -> T {
    T::from_f64(TURN * TURN) * (T::from_f64(1.0) - margin * margin) - change * change
}

/// True if a loop turns too far for its margins at the ends of a step to be sufficient.
fn turns<T: Lanes>([margin, change]: [T; 2], lane: usize) -> bool {
    room_to_turn(margin.lane(lane), change.lane(lane)) < T::Scalar::default()
}

/// True if a loop is too close to its toggle, or has no margin.
fn is_flat<T: Lanes>([margin, _]: [T; 2], lane: usize) -> bool {
    let margin = margin.lane(lane);
    margin < T::Scalar::from_f64(LEAST) || !margin.is_finite()
}

/// True if a margin falls so fast at the start of a step that it would reach zero soon after it, too close for the
/// methods to follow.
fn reaches<T: Lanes>([margin, change]: [T; 2], lane: usize) -> bool {
    let [margin, change] = [margin, change].map(|x| x.lane(lane).to_f64());
    margin + REACH * change < 0.0
}

/// True if a margin may reach zero between these ends. Its square, which is smooth there, is approximated by a cubic.
fn may_pass<T: Lanes>(ends: [[T; 2]; 2], lane: usize) -> bool {
    let ends = ends.map(|end| end.map(|x| x.lane(lane).to_f64()));
    let [(square0, slope0), (square1, slope1)] = ends.map(|[margin, change]| (margin * margin, 2.0 * margin * change));
    let rise = square1 - square0;
    let (a, b) = (slope0 + slope1 - 2.0 * rise, 3.0 * rise - 2.0 * slope0 - slope1);
    let root = libm::sqrt(b * b - 3.0 * a * slope0);
    let lowest = -slope0 / (b + root);
    let is_within = lowest > 0.0 && lowest < 1.0;
    is_within && square0 + lowest * (slope0 + lowest * (b + lowest * a)) < LOW * square0.max(square1)
}

/// Bit set of the lanes for which a condition holds.
#[inline(always)]
fn lanes<T: Lanes>(holds: impl Fn(usize) -> bool) -> u64 {
    (0..T::LANES).fold(0, |set, lane| set | u64::from(holds(lane)) << lane)
}

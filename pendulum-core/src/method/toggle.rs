//! Toggles of closed loops, where they are flat and other assemblies begin: no step ends near one, or beyond.

use nalgebra::SVector;

use crate::error::{AT_TOGGLE, Name, Reason};
use crate::method::scheme::StepFailure;
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};
use crate::system::System;

/// No step ends where a margin is less.
const LEAST: f64 = 1e-3;
/// Both ends of a step are looked at where a margin is less at the end,
const NEAR: f64 = 0.25;
/// or by its rate was zero within so many steps before. By that at the start it must not be zero within so many.
const REACH: f64 = 2.0;
/// So are places within, so many, where a margin is the sine of an angle that turns by more, in rad.
const TURN: f64 = 0.75;
const PLACES: usize = 16;
/// A margin may be zero on the way where its square falls below this part of the larger one at the ends.
const LOW: f64 = 0.1;

/// Puts the end of a step onto the constraints of its system; not a number where a loop comes to its toggle on the way.
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

/// Makes the end of a step not a number where a loop comes to its toggle on the way.
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

/// The toggle that is behind the reason for which equations end within a step from `(t, x)`, if there is one.
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

/// Whether steps of this length from the time `t` creep to where the equations end, and may never move the state there.
#[cold]
pub(crate) fn creeps<T: Float>(h: T, t: T) -> bool {
    h < T::EPSILON.sqrt() * t.abs()
}

/// Gives up after an attempt from `t` to `t_new` that failed.
///
/// # Errors
/// The toggle that is behind it, if there is one.
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

/// The way from the start of a step to its end.
struct Way<'a, S: ?Sized, T, const N: usize> {
    system: &'a S,
    start: (T, &'a SVector<T, N>),
    end: (T, &'a SVector<T, N>),
}

impl<S: System<T, N> + ?Sized, T: Lanes, const N: usize> Way<'_, S, T, N> {
    /// The lanes in which a loop comes to its toggle.
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
            // not a number where one of them is negative
            roots += (least - turn).select(least, turn).sqrt();
        });
        if roots.all_finite() {
            return 0;
        }
        // a lane must not depend on the others, so each of them answers for itself
        let in_doubt = lanes::<T>(|lane| !roots.lane(lane).is_finite());
        in_doubt & self.stopped_in_doubt()
    }

    /// Checks both ends of the step, and the way between them, in every lane.
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

    /// The lanes in which a loop comes to its toggle in a step that is too long to tell from its ends.
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

    /// A part of the way back: coordinates by Hermite's cubic, for they may turn on the way.
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

    /// The margin of a loop, and how much it would change within a step at its rate.
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

/// What is left of the angle by which a loop may turn, of which its margin is the sine: negative where there is nothing.
#[inline(always)]
fn room_to_turn<T: Real>(margin: T, change: T) -> T {
    T::from_f64(TURN * TURN) * (T::from_f64(1.0) - margin * margin) - change * change
}

/// Whether a loop turns by more than its margins at the ends of a step tell.
fn turns<T: Lanes>([margin, change]: [T; 2], lane: usize) -> bool {
    room_to_turn(margin.lane(lane), change.lane(lane)) < T::Scalar::default()
}

/// Whether a loop is too near to its toggle; also where it has no margin.
fn is_flat<T: Lanes>([margin, _]: [T; 2], lane: usize) -> bool {
    let margin = margin.lane(lane);
    margin < T::Scalar::from_f64(LEAST) || !margin.is_finite()
}

/// Whether a margin falls so fast where a step starts that it would be zero behind it, and so near there that the methods
/// cannot follow it.
fn reaches<T: Lanes>([margin, change]: [T; 2], lane: usize) -> bool {
    let [margin, change] = [margin, change].map(|x| x.lane(lane).to_f64());
    margin + REACH * change < 0.0
}

/// Whether a margin may be zero on a way with these ends: its square, which is smooth there, is taken for a cubic.
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

/// The lanes for which something holds.
#[inline(always)]
fn lanes<T: Lanes>(holds: impl Fn(usize) -> bool) -> u64 {
    (0..T::LANES).fold(0, |set, lane| set | u64::from(holds(lane)) << lane)
}

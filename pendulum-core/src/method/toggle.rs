//! Toggles of closed loops, where they are flat and other assemblies begin: no step ends near one, or beyond.

use nalgebra::SVector;

use crate::error::Reason;
use crate::method::scheme::Failure;
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};
use crate::system::System;

/// No step ends where a margin is less.
const LEAST: f64 = 1e-3;
/// The way is searched where a margin that changes evenly would have been zero within so many steps,
const REACH: f64 = 2.0;
/// or where it is the sine of an angle that turns by more within a step, in rad.
const TURN: f64 = 1.0;
/// At how many places a margin is looked at,
const PLACES: usize = 16;
/// and how many times the interval about the least of them is cut by a third.
const CUTS: usize = 20;
/// Where the equations end and a margin is less, that is why.
const NEAR: f64 = 0.1;

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
        let (margin, change) = (margin.to_f64(), -h * rate.to_f64());
        if margin < least && (margin < NEAR || may_pass(margin, change)) {
            (found, least) = (Reason::Toggle { bodies, margin }, margin);
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
    failure: Failure,
    system: &S,
    (t, t_new): (T, T),
    x: &SVector<T, N>,
) -> Result<(), Reason>
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    match behind(failure.reason((t_new - t).to_f64()), system, t, x) {
        toggle @ Reason::Toggle { .. } => Err(toggle),
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
            let [first, rest @ ..] = room(margin, (t - t0) * rate);
            let least = rest.into_iter().fold(first, |a, b| (a - b).select(a, b));
            // not a number where there is none
            roots += least.sqrt();
        });
        if roots.all_finite() { 0 } else { self.stopped_in_doubt() }
    }

    /// The same where a loop is at its toggle, or may have passed it.
    #[cold]
    fn stopped_in_doubt(&self) -> u64 {
        let ((t0, _), (t, x)) = (self.start, self.end);
        let (mut stopped, mut n) = (0, 0);
        while let Some([margin, rate]) = self.margin(n, t, x) {
            let change = (t - t0) * rate;
            stopped |= lanes::<T>(|lane| is_flat(margin.lane(lane)));
            let in_doubt = lanes::<T>(|lane| may_pass(margin.lane(lane), change.lane(lane)));
            if in_doubt & !stopped != 0 {
                stopped |= in_doubt & self.stopped_between(n);
            }
            n += 1;
        }
        stopped
    }

    /// The lanes in which a loop comes to its toggle between the ends.
    #[cold]
    fn stopped_between(&self, n: usize) -> u64 {
        let one = T::from_f64(1.0);
        let margin = |back: T| {
            let (t, mut x) = self.at(back);
            self.system.project(t, &mut x);
            self.margin(n, t, &x).map_or(one, |[margin, _]| margin)
        };
        let cut = T::from_f64(1.0 / PLACES as f64);
        let (mut place, mut least, mut stopped) = (T::default(), margin(T::default()), 0);
        for k in 1..PLACES {
            let next = T::from_f64(k as f64) * cut;
            let of_next = margin(next);
            stopped |= lanes::<T>(|lane| is_flat(of_next.lane(lane)));
            let is_less = of_next - least;
            (place, least) = (is_less.select(next, place), is_less.select(of_next, least));
        }
        let (mut near, mut far) = (place - cut, place + cut);
        near = near.select(T::default(), near);
        for _ in 0..CUTS {
            let third = (far - near) / T::from_f64(3.0);
            let (a, b) = (near + third, far - third);
            let (of_a, of_b) = (margin(a), margin(b));
            let is_near = of_a - of_b;
            stopped |= lanes::<T>(|lane| is_flat(of_a.lane(lane)));
            (near, far) = (is_near.select(near, a), is_near.select(b, far));
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
                let [from_start, to_end] = [x0, x1].map(|x| h * x[rate] - (x1[k] - x0[k]));
                x[k] += back * ahead * (from_start * back - to_end * ahead);
            }
        }
        (t1 - h * back, x)
    }

    /// The margin of a loop, and its rate.
    fn margin(&self, number: usize, t: T, x: &SVector<T, N>) -> Option<[T; 2]> {
        let (mut found, mut n) = (None, 0);
        self.system.margins(t, x, &mut |_, margin| {
            if n == number {
                found = Some(margin);
            }
            n += 1;
        });
        found
    }
}

/// What is positive of a margin, and of its change within a step, that neither is zero nor may have been.
#[inline(always)]
fn room<T: Real>(margin: T, change: T) -> [T; 3] {
    let turn = T::from_f64(TURN * TURN) * (T::from_f64(1.0) - margin * margin);
    [
        margin - T::from_f64(LEAST),
        margin - T::from_f64(REACH) * change,
        turn - change * change,
    ]
}

/// Whether a loop is too near to its toggle; also where there is no margin.
fn is_flat<T: Float>(margin: T) -> bool {
    margin < T::from_f64(LEAST) || !margin.is_finite()
}

/// Whether a margin that changes by so much within a step may have been zero.
fn may_pass<T: Float>(margin: T, change: T) -> bool {
    let [_, reach, turn] = room(margin, change);
    !(reach >= T::default() && turn >= T::default())
}

/// The lanes for which something holds.
#[inline(always)]
fn lanes<T: Lanes>(holds: impl Fn(usize) -> bool) -> u64 {
    (0..T::LANES).fold(0, |set, lane| set | u64::from(holds(lane)) << lane)
}

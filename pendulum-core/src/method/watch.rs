//! Following a trajectory: looking for events along its steps, and keeping what is wanted of them.

use nalgebra::SVector;

use crate::dense::Dense;
use crate::error::{Reason, SolveError};
use crate::event::{Direction, Event, Occurrence};
use crate::method::Stepper;
use crate::method::scheme::{NonFinite, Scheme};
use crate::method::zero::{dip, root};
use crate::real::Float;
use crate::solution::{Record, Solution};
use crate::system::System;

/// Where the event functions are looked at in each step, in fractions of it; the start is known from the step before. Those near the
/// ends show which way a function goes there.
const PLACES: [f64; 10] = [0.01, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 0.99, 1.0];
/// After a reset, the first step is looked at from this fraction of it on, in decades: what rebounds may come back at once.
const FIRST_PLACE: f64 = 1e-15;
/// Events within so many ulps of the time are simultaneous, and one that acts twice within them never ends.
const SIMULTANEOUS_ULPS: f64 = 4.0;
/// An event that acts twice within so many roots of an ulp of the time, and is then found on the far side, never ends either: heights
/// go with the square of the time between rebounds, and vanish among rounding errors.
const HURRIED: f64 = 4.0;

/// Goes on to the end, with events if there are any, and keeps the trajectory.
pub(super) fn collect<C, S, T, const N: usize>(
    mut stepper: Stepper<'_, C, S, T, N>,
    events: &[Event<'_, T, N>],
) -> Result<Solution<T, N>, SolveError<T, N>>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    let mut solution = Solution::start(stepper.t(), stepper.x());
    let ended = follow(&mut stepper, events, &mut solution);
    solution.set_statistics(stepper.statistics());
    match ended {
        Ok(()) => Ok(solution),
        Err(reason) => Err(SolveError {
            reason,
            solution: Box::new(solution),
        }),
    }
}

/// Goes on to the end, and keeps what `record` wants.
pub(crate) fn follow<C, S, T, const N: usize>(
    stepper: &mut Stepper<'_, C, S, T, N>,
    events: &[Event<'_, T, N>],
    record: &mut impl Record<T, N>,
) -> Result<(), Reason>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    let mut watch = Watch::new(events, stepper.t(), &stepper.x())?;
    while stepper.step()?.is_some() {
        let dense = stepper.dense();
        let found = watch.look(&dense);
        let acts = |found: &&Found<T>| matches!(found.what, What::Passage { .. }) && events[found.index].acts();
        let Some(cut) = found.iter().find(acts).map(|found| found.theta) else {
            if let Some(trouble) = found.iter().find_map(|found| found.trouble(&dense)) {
                return Err(trouble);
            }
            record.push(&dense);
            for Found { index, theta, .. } in found {
                record.note(Occurrence {
                    index,
                    t: dense.time(theta),
                    x: dense.at_fraction(theta),
                });
            }
            continue;
        };
        let (t, mut x) = (dense.time(cut), dense.at_fraction(cut));
        let scale = t.abs().max(dense.step().h.abs());
        let near = T::from_f64(SIMULTANEOUS_ULPS) * T::EPSILON * scale;
        let (mut ends, mut fired) = (false, Vec::new());
        record.push_part(&dense, cut);
        for found in found {
            let (index, time) = (found.index, dense.time(found.theta));
            if found.theta > cut && (time - t).abs() > near {
                break;
            }
            if let Some(trouble) = found.trouble(&dense) {
                return Err(trouble);
            }
            let event = &events[index];
            // Simultaneous events act one after the other: each sees what those before it did.
            let before = if found.theta < cut {
                dense.at_fraction(found.theta)
            } else {
                x
            };
            record.note(Occurrence {
                index,
                t: time,
                x: before,
            });
            if (time - t).abs() <= near {
                fired.push((found, (event.function)(t, &x)));
            }
            if !event.acts() {
                continue;
            }
            watch.check_progress(index, t, near)?;
            ends |= event.terminal;
            if let Some(reset) = &event.reset {
                x = reset(t, &x);
                NonFinite::check(&x).map_err(NonFinite::at_start)?;
                record.jump(t, x);
            }
        }
        if ends {
            return Ok(());
        }
        stepper.restart(t, x)?;
        watch.restart((t, scale), &x, &fired)?;
    }
    Ok(())
}

/// What is known of the events where the last step ended.
struct Watch<'w, 'e, T, const N: usize> {
    events: &'w [Event<'e, T, N>],
    seen: Vec<Seen<T>>,
    /// Whether the integration starts here, or anew.
    starts: bool,
}

/// What is known of an event.
#[derive(Clone, Copy)]
struct Seen<T> {
    side: Side<T>,
    value: T,
    /// Its largest size in the step before.
    largest: T,
    /// When it acted last.
    acted: Option<T>,
    /// The side that it must not be seen on next: it was there twice in no time.
    far: Option<bool>,
}

/// On which side of zero the function of an event is.
#[derive(Clone, Copy)]
enum Side<T> {
    /// At zero where the integration starts: an event, if it leaves in the right direction.
    AtStart,
    /// Within so much of zero, at an event that was noted: the side is that on which it is seen next.
    Leaving(T),
    Below,
    Above,
}

/// Something found within a step.
#[derive(Clone, Copy)]
struct Found<T> {
    index: usize,
    /// In fractions of the step.
    theta: T,
    what: What,
}

#[derive(Clone, Copy, PartialEq)]
enum What {
    /// The function passes zero, rising or falling.
    Passage { rises: bool },
    /// It is not a number.
    Undefined,
    /// It passes zero again and again.
    Accumulation,
}

impl<T: Float> Found<T> {
    /// The error that it is, unless it is none.
    fn trouble<const N: usize>(&self, dense: &Dense<'_, T, N>) -> Option<Reason> {
        let event = self.index;
        match self.what {
            What::Passage { .. } => None,
            What::Undefined => Some(Reason::EventNotFinite {
                event,
                t: dense.time(self.theta).to_f64(),
            }),
            What::Accumulation => Some(Reason::EventsAccumulate { event }),
        }
    }
}

impl<T: Float> Side<T> {
    fn of(value: T) -> Self {
        if value > T::default() {
            Self::Above
        } else if value < T::default() {
            Self::Below
        } else {
            Self::Leaving(T::default())
        }
    }
}

impl<'w, 'e, T: Float, const N: usize> Watch<'w, 'e, T, N> {
    fn new(events: &'w [Event<'e, T, N>], t: T, x: &SVector<T, N>) -> Result<Self, Reason> {
        let mut seen = Vec::with_capacity(events.len());
        for index in 0..events.len() {
            let value = Self::value(events, index, t, x)?;
            let side = match Side::of(value) {
                Side::Leaving(_) => Side::AtStart,
                side => side,
            };
            seen.push(Seen {
                side,
                value,
                largest: value.abs(),
                acted: None,
                far: None,
            });
        }
        Ok(Self {
            events,
            seen,
            starts: true,
        })
    }

    /// Goes on from the state `x` at `t`; `fired` are the events that were noted there, with their values before; `scale` is that
    /// of times.
    fn restart(&mut self, (t, scale): (T, T), x: &SVector<T, N>, fired: &[(Found<T>, T)]) -> Result<(), Reason> {
        for (index, seen) in self.seen.iter_mut().enumerate() {
            seen.value = Self::value(self.events, index, t, x)?;
            seen.side = Side::of(seen.value);
            seen.far = None;
            if let Some((found, before)) = fired.iter().find(|(found, _)| found.index == index) {
                let hurried = T::from_f64(HURRIED) * T::EPSILON.sqrt() * scale;
                if seen.acted.is_some_and(|acted| (t - acted).abs() <= hurried) {
                    seen.far = Some(found.what == What::Passage { rises: true });
                }
                seen.acted = Some(t);
                // Rounding errors may have left it on either side, but a jump did not.
                let noise = (before.abs() + before.abs()).min(T::EPSILON.sqrt() * seen.largest);
                if seen.value.abs() <= noise {
                    seen.side = Side::Leaving(noise);
                }
            }
        }
        self.starts = true;
        Ok(())
    }

    fn value(events: &[Event<'e, T, N>], index: usize, t: T, x: &SVector<T, N>) -> Result<T, Reason> {
        let value = (events[index].function)(t, x);
        if value.is_finite() {
            Ok(value)
        } else {
            Err(Reason::EventNotFinite {
                event: index,
                t: t.to_f64(),
            })
        }
    }

    /// An event that acts again and again within the resolution of time would never let it go on.
    fn check_progress(&self, index: usize, t: T, near: T) -> Result<(), Reason> {
        match self.seen[index].acted {
            Some(acted) if (t - acted).abs() <= near => Err(Reason::EventsAccumulate { event: index }),
            _ => Ok(()),
        }
    }

    /// All that is found in a step, in the order of time.
    fn look(&mut self, dense: &Dense<'_, T, N>) -> Vec<Found<T>> {
        let mut found = Vec::new();
        for index in 0..self.events.len() {
            self.look_at(index, dense, &mut found);
        }
        self.starts = false;
        // Finite, so there is an order; the sort keeps simultaneous events in theirs.
        found.sort_by(|a, b| a.theta.to_f64().total_cmp(&b.theta.to_f64()));
        found
    }

    fn look_at(&mut self, index: usize, dense: &Dense<'_, T, N>, found: &mut Vec<Found<T>>) {
        let event = &self.events[index];
        let seen = &mut self.seen[index];
        let value = |theta: T| (event.function)(dense.time(theta), &dense.at_fraction(theta));
        let mut note = |theta: T, from: Side<T>| {
            let counts = match from {
                Side::Above => event.direction != Direction::Rising,
                Side::Below => event.direction != Direction::Falling,
                Side::AtStart | Side::Leaving(_) => event.direction == Direction::Either,
            };
            found.extend(counts.then_some(Found {
                index,
                theta,
                what: What::Passage {
                    rises: matches!(from, Side::Below),
                },
            }));
        };
        seen.largest = seen.value.abs();
        // The two places before.
        let mut earlier: Option<(T, T)> = None;
        let mut last = (T::default(), seen.value);
        let mut decade = FIRST_PLACE;
        let decades = std::iter::from_fn(|| {
            let place = decade;
            decade *= 10.0;
            (self.starts && place < PLACES[0]).then_some(place)
        });
        for place in decades.chain(PLACES) {
            let theta = T::from_f64(place);
            let here = (theta, value(theta));
            if !here.1.is_finite() {
                found.push(Found {
                    index,
                    theta,
                    what: What::Undefined,
                });
                return;
            }
            seen.largest = seen.largest.max(here.1.abs());
            let side = Side::of(here.1);
            match (seen.side, side) {
                (Side::AtStart, Side::Leaving(_)) => {}
                (Side::AtStart, _) => {
                    // It came, as it were, from the other side.
                    let from = if matches!(side, Side::Above) {
                        Side::Below
                    } else {
                        Side::Above
                    };
                    note(T::default(), from);
                    seen.side = side;
                }
                (Side::Leaving(noise), _) => {
                    if here.1.abs() > noise {
                        seen.side = side;
                        if seen.far.take() == Some(here.1 > T::default()) {
                            found.push(Found {
                                index,
                                theta: T::default(),
                                what: What::Accumulation,
                            });
                            return;
                        }
                    }
                }
                (Side::Above, Side::Above) | (Side::Below, Side::Below) => {
                    if let Some(earlier) = earlier
                        && let Some(bottom) = dip(value, [earlier, last, here])
                    {
                        note(root(value, earlier, bottom), seen.side);
                        if bottom.1 != T::default() {
                            note(root(value, bottom, here), Side::of(bottom.1));
                        }
                    }
                }
                (Side::Above | Side::Below, _) => {
                    note(root(value, last, here), seen.side);
                    seen.side = side;
                }
            }
            earlier = Some(last);
            last = here;
        }
        if matches!(seen.side, Side::AtStart) {
            // It stays at zero.
            note(T::default(), Side::AtStart);
            seen.side = Side::Leaving(T::default());
        }
        seen.value = last.1;
    }
}

//! Search for events within a step.

use nalgebra::SVector;

use crate::dense::Dense;
use crate::error::Reason;
use crate::event::{Event, Missed, Occurrence};
use crate::method::scan::{Scan, Wanted};
use crate::method::side::{Change, Passage, Side};
use crate::method::zero::{dip, places, root};
use crate::real::{Float, ulps};

/// Spacing of two occurrences, in square roots of an ulp of t, below which an event never ends if its function is then
/// found on the far side: heights decrease with the square of the time between rebounds, and vanish among rounding
/// errors.
const HURRIED: f64 = 4.0;
/// Number of consecutive occurrences, each within the spacing [`HURRIED`], after which an event may never end: a reset
/// may lead back by a little more than rounding errors, such that time advances, but not noticeably.
const MOST_HURRIED: usize = 1000;
/// Number of such spacings before the end of the integration, above which the event is reported to accumulate.
const TOO_MANY: f64 = 1e7;

/// Occurrences of a kink that are closer than this, in ulps of t, are one.
const SAME_KINK_ULPS: f64 = 1000.0;

/// Events at the end of the last step.
pub(crate) struct Search<'w, 'e, T, const N: usize> {
    events: &'w [Event<'e, T, N>],
    seen: Vec<Seen<T>>,
    /// Those at the start of a step that may be searched again, and `starts` there.
    marked: (Vec<Seen<T>>, bool),
    /// False if kinks no longer end steps.
    pub(super) ends_at_kinks: bool,
    /// True at the start of the integration, or after a restart.
    starts: bool,
    /// Positions in a step at which all events are evaluated, with the states there.
    states: Vec<(T, SVector<T, N>)>,
    /// Positions at which one event is evaluated, with its values there.
    scan: Scan<T>,
    /// Events whose zeros may have been missed in the last step.
    missed: Vec<usize>,
}

/// State of an event.
#[derive(Clone, Copy)]
struct Seen<T> {
    side: Side<T>,
    value: T,
    /// Largest magnitude in the last step.
    largest: T,
    /// Largest magnitude in all steps.
    size: T,
    /// Time of the last occurrence that acted.
    acted: Option<T>,
    /// Number of consecutive occurrences, each shortly after the one before.
    hurried: usize,
}

/// A result of the search within a step.
#[derive(Clone, Copy)]
pub(crate) struct Found<T> {
    /// Index of the event.
    pub(super) index: usize,
    /// Position in fractions of the step.
    pub(super) theta: T,
    pub(super) what: What,
}

#[derive(Clone, Copy, PartialEq)]
pub(crate) enum What {
    /// The event function passes zero.
    Passage(Passage),
    /// The event function is not finite.
    Undefined,
    /// The event function passes zero again and again.
    Accumulation,
}

impl<T: Float> Found<T> {
    /// The occurrence of the event, or the error if there is one.
    pub(super) fn occurrence<const N: usize>(&self, dense: &Dense<'_, T, N>) -> Result<Occurrence<T, N>, Reason> {
        let (index, t) = (self.index, dense.time(self.theta));
        match self.what {
            What::Passage(_) => Ok(Occurrence {
                index,
                t,
                x: dense.located(self.theta),
            }),
            What::Undefined => Err(not_finite(index, t)),
            What::Accumulation => Err(Reason::EventsAccumulate { event: index }),
        }
    }
}

fn not_finite<T: Float>(event: usize, t: T) -> Reason {
    let t = t.to_f64();
    Reason::EventNotFinite { event, t }
}

/// Spacing below which two events are too close together, where `scale` is the size of times.
fn hurried<T: Float>(scale: T) -> T {
    T::from_f64(HURRIED) * T::EPSILON.sqrt() * scale
}

/// Maximum spacing of occurrences of a kink that are one, if `scale` is the size of times.
fn resolution<T: Float>(scale: T) -> T {
    ulps(SAME_KINK_ULPS, scale)
}

impl<'w, 'e, T: Float, const N: usize> Search<'w, 'e, T, N> {
    pub(crate) fn new(events: &'w [Event<'e, T, N>], t: T, x: &SVector<T, N>) -> Result<Self, Reason> {
        let mut seen = Vec::with_capacity(events.len());
        for index in 0..events.len() {
            let value = value(events, index, t, x)?;
            let side = if value == T::default() && events[index].occurs_at_start() {
                Side::AtStart
            } else {
                Side::of(value)
            };
            seen.push(Seen {
                side,
                value,
                largest: value.abs(),
                size: value.abs(),
                acted: None,
                hurried: 0,
            });
        }
        Ok(Self {
            events,
            seen,
            marked: (Vec::new(), false),
            ends_at_kinks: true,
            starts: true,
            states: Vec::new(),
            scan: Scan::default(),
            missed: Vec::new(),
        })
    }

    /// True if there are no events.
    pub(super) fn is_empty(&self) -> bool {
        self.events.is_empty()
    }

    /// Restarts from the state `x` at `t` towards `t1`. `fired` holds the events that occurred there, with their values
    /// before; `scale` is the size of times.
    pub(crate) fn restart(
        &mut self,
        (t, t1, scale): (T, T, T),
        x: &SVector<T, N>,
        fired: &[(Found<T>, T)],
    ) -> Result<(), Reason> {
        let hurried = hurried(scale);
        for (index, seen) in self.seen.iter_mut().enumerate() {
            seen.value = value(self.events, index, t, x)?;
            seen.side = Side::of(seen.value);
            if let Some((found, before)) = fired.iter().find(|(found, _)| found.index == index) {
                let since = seen.acted.map(|acted| (t - acted).abs());
                let soon = since.filter(|&since| since <= hurried);
                seen.hurried = soon.map_or(0, |_| seen.hurried + 1);
                let arrives_nowhere = |since: T| (t1 - t).abs() > since * T::from_f64(TOO_MANY);
                if self.events[index].changes() && seen.hurried >= MOST_HURRIED && soon.is_some_and(arrives_nowhere) {
                    return Err(Reason::EventsAccumulate { event: index });
                }
                // rounding errors may have left it on either side, but a jump did not
                let noise = (before.abs() + before.abs()).min(T::EPSILON.sqrt() * seen.largest);
                if seen.value.abs() <= noise {
                    let far = match found.what {
                        What::Passage(Passage::Rising) => Passage::Rising,
                        _ => Passage::Falling,
                    };
                    seen.side = Side::Leaving {
                        noise,
                        far: soon.is_some().then_some(far),
                    };
                }
                seen.acted = Some(t);
            }
        }
        self.starts = true;
        Ok(())
    }

    /// Rejects an event that acts repeatedly within the resolution of time: the integration would never continue.
    pub(super) fn check_progress(&self, index: usize, t: T, near: T) -> Result<(), Reason> {
        match self.seen[index].acted {
            Some(acted) if (t - acted).abs() <= near => Err(Reason::EventsAccumulate { event: index }),
            _ => Ok(()),
        }
    }

    /// True if the step ends at an event. It does not end at a kink whose last occurrence was so near that rounding
    /// errors may have caused this one.
    pub(super) fn acts(&self, found: &Found<T>, dense: &Dense<'_, T, N>) -> bool {
        let event = self.event(found);
        event.changes() || event.is_kink() && self.ends_at_kinks && !self.recurs(found, dense, hurried)
    }

    /// True if an event was acted on within a spacing, which depends on the size of times, before this occurrence.
    fn recurs(&self, found: &Found<T>, dense: &Dense<'_, T, N>, spacing: fn(T) -> T) -> bool {
        let t = dense.time(found.theta);
        let acted = self.seen[found.index].acted;
        acted.is_some_and(|acted| (t - acted).abs() <= spacing(dense.step().scale(t)))
    }

    /// Marks the start of a step, to [go back](Self::go_back) there.
    pub(super) fn mark(&mut self) {
        self.marked.0.clone_from(&self.seen);
        self.marked.1 = self.starts;
    }

    /// Goes back to the start of the step that was searched last, to search a part of it.
    pub(super) fn go_back(&mut self) {
        self.seen.clone_from(&self.marked.0);
        self.starts = self.marked.1;
    }

    /// True if steps may end at events where the method begins anew.
    pub(super) fn ends_steps(&self) -> bool {
        let ends = |event: &Event<'_, T, N>| event.begins_anew() && (self.ends_at_kinks || !event.is_kink());
        self.events.iter().any(ends)
    }

    /// The first event found in a step that acts, if the method begins anew there.
    pub(super) fn first_end(
        &self,
        found: &[Found<T>],
        dense: &Dense<'_, T, N>,
    ) -> Option<(&'w Event<'e, T, N>, Found<T>)> {
        let first = found.iter().find(|found| self.acts(found, dense))?;
        let begins_anew = matches!(first.what, What::Passage(_)) && self.event(first).begins_anew();
        begins_anew.then_some((&self.events[first.index], *first))
    }

    /// The event of a result.
    pub(super) fn event(&self, found: &Found<T>) -> &Event<'e, T, N> {
        &self.events[found.index]
    }

    /// Searches a step for all events, in the order of time.
    pub(super) fn look(&mut self, dense: &Dense<'_, T, N>) -> Vec<Found<T>> {
        let mut found = Vec::new();
        let at = |theta| (theta, dense.at_fraction(theta));
        self.states.clear();
        self.states.extend(places(self.starts).map(at));
        self.missed.clear();
        for index in 0..self.events.len() {
            self.look_at(index, dense, |theta, what| found.push(Found { index, theta, what }));
        }
        self.starts = false;
        // rounding errors at a kink that the last step ended at
        found.retain(|found| !(self.event(found).is_kink() && self.recurs(found, dense, resolution)));
        // the positions are finite, hence ordered; the stable sort keeps the order of simultaneous events
        found.sort_by(|a, b| a.theta.to_f64().total_cmp(&b.theta.to_f64()));
        found
    }

    /// Events that may have occurred unnoticed in a step, up to the time `to`.
    pub(super) fn missed(&self, dense: &Dense<'_, T, N>, to: T) -> impl Iterator<Item = Missed<T>> {
        let from = dense.step().t0;
        self.missed.iter().map(move |&index| Missed { index, from, to })
    }

    /// Searches for one event, and passes each result and its position, in fractions of the step, to `report`.
    fn look_at(&mut self, index: usize, dense: &Dense<'_, T, N>, mut report: impl FnMut(T, What)) {
        let event = &self.events[index];
        let (function, direction) = (&event.function, &event.direction);
        let seen = &mut self.seen[index];
        let value = |theta: T| function(dense.time(theta), &dense.located(theta));
        let mut note = |theta: T, passage: Passage| {
            if passage.counts(*direction) {
                report(theta, What::Passage(passage));
            }
        };
        let wanted = if event.changes() {
            Wanted::First(*direction)
        } else {
            Wanted::All
        };
        let at_places = self
            .states
            .iter()
            .map(|(theta, x)| (*theta, function(dense.time(*theta), x)));
        let is_resolved = self.scan.look(value, (seen.value, seen.size), at_places, wanted);
        if !is_resolved {
            self.missed.push(index);
        }
        seen.largest = seen.value.abs();
        // the last two samples
        let mut earlier: Option<(T, T)> = None;
        let mut last = (T::default(), seen.value);
        for &here in self.scan.samples() {
            let theta = here.0;
            if !here.1.is_finite() {
                return report(theta, What::Undefined);
            }
            seen.largest = seen.largest.max(here.1.abs());
            let (side, change) = seen.side.advance(here.1);
            seen.side = side;
            match change {
                Change::None => {}
                Change::Left(passage) => note(T::default(), passage),
                Change::Passed(passage) => note(root(value, last, here), passage),
                Change::SameSide => {
                    if let Some(earlier) = earlier
                        && let Some(bottom) = dip(value, [earlier, last, here])
                    {
                        note(root(value, earlier, bottom), side.left());
                        if bottom.1 != T::default() {
                            note(root(value, bottom, here), Side::of(bottom.1).left());
                        }
                    }
                }
                Change::Accumulated => return report(T::default(), What::Accumulation),
            }
            (earlier, last) = (Some(last), here);
        }
        if seen.side == Side::AtStart {
            note(T::default(), Passage::Resting);
            seen.side = Side::at_zero();
        }
        seen.value = last.1;
        seen.size = seen.size.max(seen.largest);
    }
}

fn value<T: Float, const N: usize>(
    events: &[Event<'_, T, N>],
    index: usize,
    t: T,
    x: &SVector<T, N>,
) -> Result<T, Reason> {
    let value = (events[index].function)(t, x);
    if value.is_finite() {
        Ok(value)
    } else {
        Err(not_finite(index, t))
    }
}

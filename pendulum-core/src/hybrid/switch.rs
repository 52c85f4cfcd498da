//! Mode switches: the end of one mode, and the choice of the next.

use nalgebra::SVector;

#[cfg(feature = "std")]
use super::in_mode::InMode;
use super::in_mode::ModeSwitch;
use super::kinematics::Kinematics;
use super::mode::{Mode, Status, bits, set_of};
use super::project::shift_rates;
use super::resolution::{AT_LIMIT, CONSISTENT};
use super::settled::Settled;
use super::settling::Settling;
use super::sizes::Gains;
use super::watch::ModeWatch;
use super::witness::{Witness, Witnesses};
use super::{Hold, Hybrid, MAX_CONSTRAINTS, project};
use crate::error::Reason;
use crate::layout::StateLayout;
use crate::real::{Float, Real, ulps};
#[cfg(feature = "std")]
use crate::system::System;

/// Determines the mode in which an integration starts from a state.
pub(crate) fn start<T: Float, const N: usize>(
    (system, layout): (&dyn Hybrid<T, N>, Option<StateLayout<'_>>),
    t: T,
    x: &SVector<T, N>,
) -> Result<Settled<T, N>, Reason> {
    let zero = [T::default(); MAX_CONSTRAINTS];
    let mut settling = Settling::new(system, (t, x), Gains::near((system, layout), t, x), &zero);
    let sizes = settling.sizes();
    let measures = system.measures(t, x);
    for (n, constraint) in system.constraints().iter().enumerate() {
        let [value, rate] = measures[n];
        let rests = rate.abs() <= ulps(AT_LIMIT, sizes.rates[n]);
        for (distance, limit, status) in settling.distances(n, &measures) {
            let slack = ulps(AT_LIMIT, sizes.values[n].max(limit.abs()));
            if distance.to_f64().is_nan() || distance < -slack {
                let (value, limit) = (value.to_f64(), limit.to_f64());
                let constraint = constraint.name.into();
                return Err(Reason::BeyondLimit {
                    constraint,
                    value,
                    limit,
                });
            }
            if distance <= slack {
                settling.touching[n] = status;
                settling.rest(n, rests);
            }
        }
        // away from limits only friction holds a rate, with its derivatives
        settling.rest(n, rate == T::default() && settling.has_friction(n));
    }
    let mut settled = finish(system, t, settling.settle(), &zero, &mut |_, _| {});
    // a rate of exactly zero keeps its derivatives where it is not held; where it is, a neighbour stops at once, by an
    // impulse that changes other rates
    if settled.x == *x && !x.iter().all(Real::is_constant) {
        settled.x = *x;
        let solved = (&system.response(t, x, &zero), settled.hold.solved);
        let rates = measures.map(|[_, rate]| rate);
        shift_rates(&mut settled.x, Kinematics::of(system), solved, &rates);
        project(system, &settled.hold, &settled.mode.0, t, &mut settled.x);
    }
    match settled.contradiction() {
        Some(n) => Err(Reason::ModesAccumulate {
            constraint: system.constraints()[n].name.into(),
        }),
        None => Ok(settled),
    }
}

/// Right-hand side at a state, in the mode in which a hybrid system starts from it.
#[cfg(feature = "std")]
pub(crate) fn rate<S, T, const N: usize>(system: &S, t: T, x: &SVector<T, N>) -> Result<SVector<T, N>, Reason>
where
    S: System<T, N> + ?Sized,
    T: Float,
{
    match system.hybrid() {
        Some(hybrid) => Ok(InMode::new(system, &start((hybrid, system.layout()), t, x)?.hold).rhs(t, x)),
        None => Ok(system.rhs(t, x)),
    }
}

/// Determines the mode after the one that ended. Calls `pass` for every transition, since impacts may follow each other
/// at once.
pub(crate) fn switch<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    (t, x): (T, &SVector<T, N>),
    (mode, hold): (&Mode, &Hold<T>),
    fired: Witnesses,
    watch: &ModeWatch<T, N>,
    mut pass: impl FnMut(&ModeSwitch<T, N>),
) -> Settled<T, N> {
    let settling = Settling::new(system, (t, x), watch.gains, &watch.reach);
    let settled = settling.at_the_end_of(mode, fired).settle();
    pass(&ModeSwitch {
        t,
        before: (*x, *mode, *hold),
        fired,
        impulses: settled.impulses,
        after: (settled.x, settled.hold),
    });
    finish(system, t, settled, &watch.reach, &mut |before, after| {
        pass(&ModeSwitch {
            t,
            before: (before.x, before.mode, before.hold),
            fired: before.next,
            impulses: after.impulses,
            after: (after.x, after.hold),
        });
    })
}

/// Constraint at whose end of the mode the motion has no derivatives: its time has none, or it closes together with
/// others, and not if the variables differ a little. None for numbers without derivatives.
pub(crate) fn without_derivatives<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    (t, x): (T, &SVector<T, N>),
    fired: Witnesses,
) -> Option<usize> {
    /// Largest derivative of a gap that closes at its own time, relative to those of the state.
    const ROUNDING: f64 = 1e-6;
    if !t.largest_slope().is_finite() {
        return Some(fired.first());
    }
    let closing = fired.filter(|(_, witness)| witness.is_gap());
    if closing.pairs().count() < 2 || x.iter().all(Real::is_constant) {
        return None;
    }
    let measures = system.measures(t, x);
    let largest = x.iter().map(Float::largest_slope).fold(0.0, f64::max);
    let mut closing = closing.pairs().map(|(n, _)| n);
    closing.find(|&n| measures[n][0].largest_slope() > ROUNDING * largest)
}

/// Follows impacts at the same instant, until nothing approaches or there are too many.
pub(super) fn finish<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    t: T,
    mut settled: Settled<T, N>,
    reach: &[T; MAX_CONSTRAINTS],
    pass: &mut dyn FnMut(&Settled<T, N>, &Settled<T, N>),
) -> Settled<T, N> {
    while !settled.next.is_empty() && !settled.series.is_too_long() {
        let settling = Settling::after(system, t, &settled, reach);
        let mut after = settling.at_the_end_of(&settled.mode, settled.next).settle();
        pass(&settled, &after);
        for (sum, before) in after.impulses.iter_mut().zip(settled.impulses) {
            *sum += before;
        }
        settled = after;
    }
    settled
}

impl<T: Float, const N: usize> Settling<'_, T, N> {
    /// Initializes the constraints that rest, touch or gave way at the end of a mode.
    fn at_the_end_of(mut self, mode: &Mode, fired: Witnesses) -> Self {
        let measures = self.system.measures(self.t, &self.x);
        let sizes = self.sizes();
        let mut still = 0;
        for n in 0..self.system.constraints().len() {
            let status = mode.0[n];
            self.rest(n, status.is_held());
            if status.is_held() {
                if status.touches() {
                    self.touching[n] = status;
                }
                for (force, next) in [
                    (Witness::Forward, Status::Forward),
                    (Witness::Backward, Status::Backward),
                ] {
                    if fired.has(n, force) {
                        self.forced[n] = Some(next);
                    }
                }
                continue;
            }
            self.rest(n, fired.has(n, Witness::Slip));
            for (distance, limit, status) in self.distances(n, &measures) {
                let slack = ulps(AT_LIMIT, self.reach[n].max(sizes.values[n]).max(limit.abs()));
                let gap = if status == Status::Low {
                    Witness::Low
                } else {
                    Witness::High
                };
                if fired.has(n, gap) || distance.abs() <= slack {
                    self.touching[n] = status;
                    still |= u8::from(measures[n][1].abs() <= ulps(AT_LIMIT, sizes.rates[n])) << n;
                }
            }
        }
        // between impacts at an instant, no time passes in which a contact could come to rest
        if still != 0 && self.series.is_empty() {
            self.resting |= still & !self.parting(mode);
        }
        self
    }

    /// Contacts that separate under the accelerations of a mode.
    fn parting(&self, mode: &Mode) -> u8 {
        let forces = core::array::from_fn(|n| self.slipping(n, mode.0[n]));
        let response = self.system.response(self.t, &self.x, &forces);
        let sizes = self.sizes_of_accelerations(&response);
        let parts = |&n: &usize| self.away(n) * response.accelerations[n] > ulps(CONSISTENT, sizes[n]);
        set_of(bits(self.touched()).filter(parts))
    }
}

//! Mode switches: the end of one mode, and the choice of the next.

use nalgebra::SVector;

use super::held::rhs;
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

/// Determines the mode in which an integration starts from a state, and the time at which it begins: the time of an
/// impact at the start depends on the variables of dual numbers. Calls `pass` for every impact.
pub(crate) fn start<T: Float, const N: usize>(
    (system, layout): (&dyn Hybrid<T, N>, Option<StateLayout<'_>>),
    mut t: T,
    x: &SVector<T, N>,
    mut pass: impl FnMut(&ModeSwitch<T, N>),
) -> Result<(T, Settled<T, N>), Reason> {
    let mut x = *x;
    let zero = [T::default(); MAX_CONSTRAINTS];
    let mut settling = Settling::new(system, (t, &x), Gains::near((system, layout), t, &x), &zero);
    let sizes = settling.sizes();
    let measures = system.measures(t, &x);
    let (mut approaching, mut delay) = (Witnesses::default(), None);
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
                let closing = -settling.away(n) * rate;
                if !rests && closing > T::default() {
                    approaching.insert(n, Witness::of_limit(status));
                    delay = delay.or(Some(distance / closing));
                }
            }
        }
        // away from limits only friction holds a rate, with its derivatives
        settling.rest(n, rate == T::default() && settling.has_friction(n));
    }
    let before = (!approaching.is_empty()).then(|| settling.before(approaching).settle());
    if let (Some(before), Some(delay)) = (&before, delay.filter(|delay| !delay.is_constant())) {
        // the slopes alone: the state is at the limit but for rounding errors
        let delay = delay - delay.without_slopes();
        x += rhs(system, &before.hold, t, &x) * delay;
        t += delay;
        if let Some(n) = without_derivatives(system, (t, &x), approaching) {
            let constraint = system.constraints()[n].name.into();
            return Err(Reason::NotDifferentiable { constraint });
        }
        (settling.t, settling.x) = (t, x);
    }
    let settled = settling.settle();
    if let Some(before) = before {
        pass(&passage(t, (x, before.mode, before.hold), approaching, &settled));
    }
    let mut settled = follow(system, t, settled, &zero, pass);
    // a rate of exactly zero keeps its derivatives where it is not held; where it is, a neighbour stops at once, by an
    // impulse that changes other rates
    if settled.x == x && !x.iter().all(Real::is_constant) {
        settled.x = x;
        let solved = (&system.response(t, &x, &zero), settled.hold.solved);
        let rates = measures.map(|[_, rate]| rate);
        shift_rates(&mut settled.x, Kinematics::of(system), solved, &rates);
        project(system, &settled.hold, &settled.mode.0, t, &mut settled.x);
    }
    match settled.contradiction() {
        Some(n) => Err(Reason::ModesAccumulate {
            constraint: system.constraints()[n].name.into(),
        }),
        None => Ok((t, settled)),
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
        Some(hybrid) => {
            let (_, settled) = start((hybrid, system.layout()), t, x, |_| {})?;
            Ok(InMode::new(system, &settled.hold).rhs(t, x))
        }
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
    pass(&passage(t, (*x, *mode, *hold), fired, &settled));
    follow(system, t, settled, &watch.reach, pass)
}

/// The switch from a mode, which these witnesses ended, to the next one.
fn passage<T: Float, const N: usize>(
    t: T,
    before: (SVector<T, N>, Mode, Hold<T>),
    fired: Witnesses,
    after: &Settled<T, N>,
) -> ModeSwitch<T, N> {
    ModeSwitch {
        t,
        before,
        fired,
        impulses: after.impulses,
        after: (after.x, after.hold),
    }
}

/// Follows impacts at the same instant, and calls `pass` for each.
fn follow<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    t: T,
    settled: Settled<T, N>,
    reach: &[T; MAX_CONSTRAINTS],
    mut pass: impl FnMut(&ModeSwitch<T, N>),
) -> Settled<T, N> {
    finish(system, t, settled, reach, &mut |before, after| {
        pass(&passage(t, (before.x, before.mode, before.hold), before.next, after));
    })
}

/// Constraint at whose end of the mode the motion has no derivatives: its time has none, as where it only touches its
/// limit, or it closes together with others, and not if the variables differ a little. None for numbers without
/// derivatives.
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
    if closing.is_empty() || t.is_constant() && x.iter().all(Real::is_constant) {
        return None;
    }
    let measures = system.measures(t, x);
    let grazing = grazing(system, (t, x), &measures);
    if let Some(n) = closing.pairs().map(|(n, _)| n).find(grazing) {
        return Some(n);
    }
    if closing.pairs().count() < 2 {
        return None;
    }
    let largest = x.iter().map(Float::largest_slope).fold(0.0, f64::max);
    let mut closing = closing.pairs().map(|(n, _)| n);
    closing.find(|&n| measures[n][0].largest_slope() > ROUNDING * largest)
}

/// True for a constraint whose rate turns before the gap is closed further than by rounding errors: whether it closes
/// is then not resolved.
fn grazing<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    (t, x): (T, &SVector<T, N>),
    measures: &[[T; 2]; MAX_CONSTRAINTS],
) -> impl Fn(&usize) -> bool {
    /// Depth up to which a gap is not resolved, in ulps of the sizes of its terms.
    const UNRESOLVED: f64 = 64.0;
    let zero = [T::default(); MAX_CONSTRAINTS];
    let accelerations = system.response(t, x, &zero).accelerations;
    let sizes = Settling::new(system, (t, x), Gains::near((system, None), t, x), &zero).sizes();
    move |&n| {
        let (rate, acceleration) = (measures[n][1], accelerations[n]);
        let turns = rate * acceleration < T::default();
        let depth = rate * rate / (T::from_f64(2.0) * acceleration.abs());
        turns && depth <= ulps(UNRESOLVED, sizes.values[n])
    }
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
    /// The same, before the impacts of contacts that approach.
    fn before(&self, approaching: Witnesses) -> Self {
        let mut before = Self::new(self.system, (self.t, &self.x), self.gains, &self.reach);
        (before.touching, before.resting) = (self.touching, self.resting);
        for (n, _) in approaching.pairs() {
            before.touching[n] = Status::Free;
        }
        before
    }

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
                if fired.has(n, Witness::of_limit(status)) || distance.abs() <= slack {
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

//! Transition of a state to the next mode: approaching contacts collide, resting constraints hold, low rebounds end.

use nalgebra::SVector;

use super::complementarity::{depends, independent};
use super::held::pin;
use super::kinematics::Kinematics;
use super::mode::{Status, bits, set_of};
use super::project::{apart, place_coordinates, shift_positions, shift_rates};
use super::resolution::AT_LIMIT;
use super::series::Series;
use super::settled::Settled;
use super::sizes::{Gains, Sizes};
use super::{Hybrid, Law, MAX_CONSTRAINTS};
use crate::real::{Float, ulps};

/// A state in transition to the next mode.
#[derive(Clone, Copy)]
pub(super) struct Settling<'a, T, const N: usize> {
    pub(super) system: &'a dyn Hybrid<T, N>,
    pub(super) laws: [Law<T>; MAX_CONSTRAINTS],
    pub(super) t: T,
    pub(super) x: SVector<T, N>,
    /// Limit that each constraint touches: `Low`, `High`, or else `Free`.
    pub(super) touching: [Status; MAX_CONSTRAINTS],
    /// Constraints whose rates are zero.
    pub(super) resting: u8,
    /// Status that a constraint must take because it gave way.
    pub(super) forced: [Option<Status>; MAX_CONSTRAINTS],
    /// Impulses so far.
    pub(super) impulses: [T; MAX_CONSTRAINTS],
    pub(super) gains: Gains<T, N>,
    /// Largest distance of each constraint from its limits since it was held there.
    pub(super) reach: [T; MAX_CONSTRAINTS],
    /// Impacts so far.
    pub(super) series: Series<T, N>,
    /// Contacts that may collide first, where an order is prescribed.
    pub(super) first: Option<u8>,
}

impl<'a, T: Float, const N: usize> Settling<'a, T, N> {
    pub(super) fn new(
        system: &'a dyn Hybrid<T, N>,
        (t, x): (T, &SVector<T, N>),
        gains: Gains<T, N>,
        reach: &[T; MAX_CONSTRAINTS],
    ) -> Self {
        Self {
            system,
            laws: system.laws(),
            t,
            x: *x,
            touching: [Status::Free; MAX_CONSTRAINTS],
            resting: 0,
            forced: [None; MAX_CONSTRAINTS],
            impulses: [T::default(); MAX_CONSTRAINTS],
            gains,
            reach: *reach,
            series: Series::none(),
            first: None,
        }
    }

    /// Continues after impacts that others follow at once.
    pub(super) fn after(
        system: &'a dyn Hybrid<T, N>,
        t: T,
        settled: &Settled<T, N>,
        reach: &[T; MAX_CONSTRAINTS],
    ) -> Self {
        Self {
            series: settled.series,
            ..Self::new(system, (t, &settled.x), settled.gains, reach)
        }
    }

    /// Sizes relative to which rounding errors are measured.
    pub(super) fn sizes(&self) -> Sizes<T> {
        self.gains.sizes(self.system, self.t, &self.x)
    }

    pub(super) fn rest(&mut self, n: usize, rests: bool) {
        self.resting |= u8::from(rests) << n;
    }

    /// For each limit of a constraint: the distance from it, the limit, and the status at it.
    pub(super) fn distances(
        &self,
        n: usize,
        measures: &[[T; 2]; MAX_CONSTRAINTS],
    ) -> impl Iterator<Item = (T, T, Status)> + use<T, N> {
        let (law, value) = (&self.laws[n], measures[n][0]);
        let low = law.low.map(|low| (value - low, low, Status::Low));
        let high = law.high.map(|high| (high - value, high, Status::High));
        [low, high].into_iter().flatten()
    }

    /// Direction away from a touched limit: 1 at a lower limit, -1 at an upper one, 0 elsewhere.
    pub(super) fn away(&self, n: usize) -> T {
        T::from_f64(match self.touching[n] {
            Status::Low => 1.0,
            Status::High => -1.0,
            _ => 0.0,
        })
    }

    pub(super) fn has_friction(&self, n: usize) -> bool {
        self.laws[n].sticking > T::default()
    }

    pub(super) fn settle(mut self) -> Settled<T, N> {
        self.place_at_limits();
        self.stand();
        self.collide();
        let mut delay = T::default();
        loop {
            let approaching = self.next();
            self.stand();
            let next = self.next_mode();
            let low = if approaching.is_empty() {
                self.low_rebounds(&next.accelerations)
            } else {
                0
            };
            if low == 0 {
                return Settled {
                    x: self.x,
                    mode: next.mode,
                    hold: next.hold,
                    delay,
                    impulses: self.impulses,
                    gains: self.gains,
                    sizes: next.sizes,
                    series: self.series,
                    next: approaching,
                };
            }
            delay = delay.max(self.lasting(low, next));
            self.halt(low);
        }
    }

    /// Constraints that touch a limit.
    pub(super) fn touched(&self) -> u8 {
        set_of((0..MAX_CONSTRAINTS).filter(|&n| self.touching[n].touches()))
    }

    /// Moves touching constraints onto their limits (coordinates exactly), without moving resting ones.
    fn place_at_limits(&mut self) {
        let constraints = self.system.constraints();
        if bits(self.touched()).any(|n| constraints[n].rate.is_empty()) {
            let response = self.system.response(self.t, &self.x, &[T::default(); MAX_CONSTRAINTS]);
            let solved = independent(&response.matrix, self.touched() | self.resting);
            let apart = apart(&self.laws, &self.touching, &self.system.measures(self.t, &self.x));
            shift_positions(&mut self.x, Kinematics::of(self.system), (&response, solved), &apart);
        }
        place_coordinates(self.system, &self.touching, self.t, &mut self.x);
    }

    /// Sets the rates of all resting constraints to zero, so that the choice of which of them to hold moves none of the
    /// others.
    pub(super) fn stand(&mut self) {
        let constraints = self.system.constraints();
        if bits(self.resting).all(|n| !constraints[n].rate.is_empty()) {
            return pin(self.system, self.resting, &mut self.x);
        }
        let sizes = self.sizes();
        pin(self.system, self.resting, &mut self.x);
        let response = self.system.response(self.t, &self.x, &[T::default(); MAX_CONSTRAINTS]);
        let solved = independent(&response.matrix, self.resting);
        let rates = self.system.measures(self.t, &self.x).map(|[_, rate]| rate);
        shift_rates(&mut self.x, Kinematics::of(self.system), (&response, solved), &rates);
        // constraints held by the others rest too
        for (n, [_, rate]) in self.system.measures(self.t, &self.x).into_iter().enumerate() {
            let rests = n < constraints.len() && rate.abs() <= ulps(AT_LIMIT, sizes.rates[n]);
            self.rest(n, rests && depends(&response.matrix, n, solved));
        }
        pin(self.system, self.resting, &mut self.x);
    }
}

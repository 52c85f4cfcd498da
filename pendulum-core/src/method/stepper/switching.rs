//! Mode switches of hybrid systems, on top of smooth steps.

use nalgebra::SVector;

use super::Stepper;
use crate::dense::{ABOUT_THE_END, Dense, Step};
use crate::error::Reason;
use crate::hybrid::{self, Ambiguity, Hybrid, InMode, Kinematics, Modes, Settled, Witnesses};
use crate::method::scheme::Scheme;
use crate::method::smooth::Steps;
use crate::real::{Float, ulps};
use crate::statistics::Statistics;
use crate::step_size::Tolerance;
use crate::system::System;

/// Number of mode switches after which their mean spacing is checked. The integration stops if the spacing is below the
/// larger of the limits that apply, see below. The rebounds of a ball end earlier.
const MANY_CHANGES: usize = 1000;
/// Minimum mean spacing of mode switches with steps of fixed length, in steps.
const HURRIED_OF_STEP: f64 = 1e-7;
/// Minimum mean spacing of mode switches within a tolerance, relative to the time to the end of the span.
const HURRIED_OF_REST: f64 = 1e-13;
/// Minimum mean spacing of mode switches, in ulps of t.
const HURRIED_ULPS: f64 = 4.0;
/// Minimum length of a retaken step, in ulps of t.
const SHORTEST_ULPS: f64 = 64.0;
/// Maximum number of times that a step is retaken to the end of its mode. It limits searches where modes end so close
/// together that each shorter step reveals another end first.
const MOST_RETAKEN: usize = 16;
/// Maximum growth of the step after one that was cut off where no mode ended.
const GROW_AGAIN: f64 = 8.0;
/// Change of the state by the order of impacts, in tolerances, above which it is reported.
const LEAST_AMBIGUITY: f64 = 10.0;

/// Outcome of cutting off a step.
enum Cut {
    /// The step ends where its mode ends, or before.
    Ended,
    /// The step remains as it was: the zero that its polynomial shows at its start is disproved.
    Stands,
    /// The step is shorter, but continues beyond the end that its polynomial showed: its mode may end within it.
    Goes,
}

impl<C, S, T, const N: usize> Stepper<'_, C, S, T, N>
where
    C: Scheme<S, T, N>,
    S: System<T, N> + ?Sized,
    T: Float,
{
    /// Cuts off the last step of a hybrid system where its mode ends.
    #[inline(always)]
    pub(super) fn look_for_the_end_of_the_mode(&mut self) -> Result<(), Reason> {
        let Some(hybrid) = self.system.hybrid() else {
            return Ok(());
        };
        (self.modes.cut, self.modes.is_dense) = (T::from_f64(1.0), false);
        self.find_dense();
        let step = (&self.smooth.last.x0, self.smooth.scheme.coefficients());
        let mode = (hybrid.constraints(), &self.modes.mode);
        if self.modes.hold.held == 0 && self.modes.watch.outlasts(mode, step) {
            return Ok(());
        }
        let mut disproved = Witnesses::default();
        for _ in 0..MOST_RETAKEN {
            let (dense, modes, work) = self.dense_and_mode();
            let scene = (hybrid, &modes.mode, &modes.hold);
            let Some((cut, fired)) = modes.watch.look(scene, &dense, disproved, work)? else {
                break;
            };
            match self.cut_off(hybrid, cut, fired) {
                Cut::Ended => break,
                Cut::Stands => disproved = disproved.or(fired),
                Cut::Goes => disproved = Witnesses::default(),
            }
        }
        Ok(())
    }

    /// Cuts off the last step where its polynomial shows that witnesses end the mode, or near there. The step is
    /// retaken, since ends of steps are more accurate than dense output.
    fn cut_off(&mut self, hybrid: &dyn Hybrid<T, N>, mut cut: T, mut fired: Witnesses) -> Cut {
        let (whole, scheme) = (self.smooth.last, self.smooth.scheme.clone());
        let (one, about_the_end) = (T::from_f64(1.0), T::from_f64(ABOUT_THE_END));
        let mut t = Dense::new(whole, &[]).time(cut);
        let (mut retaken, mut goes_on) = (0, false);
        let mut x = loop {
            if !self.retake(&whole, t) {
                (self.smooth.last, self.smooth.scheme) = (whole, scheme);
                self.modes.is_dense = true;
                cut = (t - whole.t0) / whole.h;
                break self.dense_and_mode().0.at_fraction(cut);
            }
            retaken += 1;
            let (dense, modes, work) = self.dense_and_mode();
            let time = |by: T| dense.step().t1 + by * dense.step().h;
            let scene = (hybrid, &modes.mode, &modes.hold);
            let is_in_reach = |by: T| by <= about_the_end || time(by) < whole.t1 && retaken < MOST_RETAKEN;
            let found = modes.watch.locate(scene, &dense, fired, work);
            let Some((by, first)) = found.filter(|&(by, _)| is_in_reach(by)) else {
                let end = dense.step().t1;
                if hybrid::disproves(scene, &Dense::new(whole, scheme.coefficients()), (end, fired)) {
                    (self.smooth.last, self.smooth.scheme) = (whole, scheme);
                    return Cut::Stands;
                }
                self.go_on_from(end);
                return if goes_on { Cut::Goes } else { Cut::Ended };
            };
            goes_on |= by > about_the_end;
            (t, cut, fired) = (time(by), one + by, first);
            if by.abs() <= about_the_end || retaken == MOST_RETAKEN {
                break dense.about_end(by);
            }
        };
        self.system.project(t, &mut x);
        // a mode that ends with the span does not move its end
        let end = self.smooth.t1;
        if t == end && !t.has_same_slopes(&end) {
            x += InMode::new(self.system, &self.modes.hold).rhs(t, &x) * (end - t);
            t = end;
        }
        let modes = &mut self.modes;
        (modes.cut, modes.fired) = (cut, fired);
        if modes.hold.held != 0 {
            hybrid::project(hybrid, &modes.hold, &fired.touching(&modes.mode), t, &mut x);
        }
        self.smooth.last = Step::new((self.smooth.last.t0, self.smooth.last.x0), (t, x));
        Cut::Ended
    }

    /// Continues from a time before the original end of a step, with steps that grow only gradually: a step as long as
    /// before would show the zero at its start that the shorter one has just disproved.
    fn go_on_from(&mut self, end: T) {
        self.smooth.go_to(end);
        if let Steps::Controlled { pace, .. } = &mut self.smooth.steps {
            pace.h = pace.h.min(T::from_f64(GROW_AGAIN) * (end - self.smooth.last.t0).abs());
        }
    }

    /// Dense output of the last step before it is cut off, with the modes and the statistics.
    fn dense_and_mode(&mut self) -> (Dense<'_, T, N>, &mut Modes<T, N>, &mut Statistics) {
        self.find_dense();
        (
            Dense::new(self.smooth.last, self.smooth.scheme.coefficients()),
            &mut self.modes,
            &mut self.smooth.statistics,
        )
    }

    /// Computes the dense output of the last step, if it is not available.
    fn find_dense(&mut self) {
        if !self.modes.is_dense {
            self.smooth.find_dense(self.system, &self.modes.hold);
        }
        self.modes.is_dense = true;
    }

    /// Lets a step end as it was taken: no mode ends within it.
    #[cfg(feature = "std")]
    pub(super) fn end_as_taken(&mut self) {
        (self.modes.cut, self.modes.fired) = (T::from_f64(1.0), Witnesses::default());
        if self.system.hybrid().is_some() {
            self.find_dense();
        }
    }

    /// Retakes a step to the time `t` within it. Returns false if that is impossible.
    pub(super) fn retake(&mut self, whole: &Step<T, N>, t: T) -> bool {
        if t == self.smooth.last.t1 {
            return true;
        }
        if (t - whole.t0).abs() <= ulps(SHORTEST_ULPS, whole.scale(t)) {
            return false;
        }
        self.modes.is_dense = false;
        self.smooth.last = Step::at_rest(whole.t0, whole.x0);
        self.smooth.scheme.go_back();
        self.begin().is_ok() && self.smooth.step_to(self.system, &self.modes, t).is_ok()
    }

    /// Switches to the mode after the one that has ended.
    pub(super) fn change_mode(&mut self) -> Result<(), Reason> {
        let Some(hybrid) = self.system.hybrid() else {
            return Ok(());
        };
        let Modes {
            mode,
            hold,
            fired,
            watch,
            changes: (count, since),
            ..
        } = self.modes;
        let (t, x) = (self.smooth.t(), self.smooth.x());
        if let Some(n) = hybrid::without_derivatives(hybrid, (t, &x), fired) {
            let constraint = hybrid.constraints()[n].name.into();
            return Err(Reason::NotDifferentiable { constraint });
        }
        let pass = |passage: &_| self.smooth.scheme.pass(self.system, passage);
        let settled = hybrid::switch(hybrid, (t, &x), (&mode, &hold), fired, &watch, pass);
        self.smooth.statistics.evaluations += 1;
        if let Some(n) = settled.contradiction() {
            let constraint = hybrid.constraints()[n].name.into();
            return Err(Reason::ModesAccumulate { constraint });
        }
        let changes = if count < MANY_CHANGES {
            (count + 1, since)
        } else {
            (1, t)
        };
        if count == MANY_CHANGES {
            let shortest = match &self.smooth.steps {
                Steps::Equal(grid) => T::from_f64(HURRIED_OF_STEP) * grid.h(),
                Steps::Controlled { .. } => T::from_f64(HURRIED_OF_REST) * (self.smooth.t1 - t),
            };
            let resolved = ulps(HURRIED_ULPS, self.smooth.last.scale(t));
            if t - since <= T::from_f64(MANY_CHANGES as f64) * shortest.max(resolved) {
                let constraint = hybrid.constraints()[fired.first()].name.into();
                return Err(Reason::ModesAccumulate { constraint });
            }
        }
        self.modes.changes = changes;
        self.smooth.go_to(t);
        self.enter(t, settled);
        self.begin().map(drop)
    }

    /// Sets the point and its mode.
    pub(super) fn enter(&mut self, t: T, settled: Settled<T, N>) {
        let ambiguity = settled
            .ambiguity()
            .and_then(|found| self.check_ambiguity(t, found, &settled.x));
        self.smooth.statistics.ambiguities += usize::from(ambiguity.is_some());
        let Settled {
            x,
            mode,
            hold,
            delay,
            impulses,
            gains,
            sizes,
            ..
        } = settled;
        (self.modes.mode, self.modes.hold, self.modes.from) = (mode, hold, (t + delay).min(self.smooth.t1));
        (self.modes.impulses, self.modes.ambiguity) = (impulses, ambiguity);
        self.modes.fired = Witnesses::default();
        let watched = self.system.hybrid().map(|hybrid| Witnesses::of(&mode, &hybrid.laws()));
        self.modes
            .watch
            .restart((&mode, watched.unwrap_or_default()), gains, sizes);
        self.smooth.last = Step::at_rest(t, x);
    }

    /// Reports the impacts at `t` whose order is ambiguous, from the differences of the state `x` after them. None if
    /// the differences are within the tolerance.
    fn check_ambiguity(
        &self,
        t: T,
        (set, differences): (u8, SVector<T, N>),
        x: &SVector<T, N>,
    ) -> Option<Ambiguity<T>> {
        let kinematics = Kinematics::of(self.system.hybrid()?);
        let matters = |difference: T, x: T| match &self.smooth.steps {
            Steps::Equal(_) => true,
            Steps::Controlled { control, .. } => {
                let Tolerance { rtol, atol } = control.tolerance;
                difference > T::from_f64(LEAST_AMBIGUITY) * (atol + rtol * x.abs())
            }
        };
        let mut rates = kinematics.rates();
        let difference = rates.clone().fold(T::default(), |most, k| most.max(differences[k]));
        let matters = rates.any(|k| matters(differences[k], x[k]));
        matters.then_some(Ambiguity { t, difference, set })
    }
}

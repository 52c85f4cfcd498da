//! State of the trajectories in the lanes. Decisions on all lanes also use vector registers.

use nalgebra::SVector;

use super::MOST_LANES;
use crate::hybrid::Modes;
use crate::method::{Accepted, Pace, Progress, StepControl};
use crate::real::Float;
use crate::real::lanes::Lanes;
use crate::statistics::Statistics;
use crate::step_size::PiController;

/// The trajectories in the lanes, each with its own time and step size.
pub(super) struct Members<T> {
    /// Index of the trajectory in each lane; [`FREE`] for an empty lane.
    index: [usize; MOST_LANES],
    pub(super) t: [T; MOST_LANES],
    /// End of the current step.
    pub(super) t_new: [T; MOST_LANES],
    /// Sizes of the next steps.
    pub(super) h: [T; MOST_LANES],
    pub(super) steps: [usize; MOST_LANES],
    /// -1 if the last attempt was accepted, otherwise 1.
    verdict: [T; MOST_LANES],
    alpha: [f64; MOST_LANES],
    last: [f64; MOST_LANES],
    most: [f64; MOST_LANES],
    /// Work of each trajectory in a lane that has not been reported; if they take the same steps, else none.
    work: Statistics,
}

/// Index of an empty lane.
const FREE: usize = usize::MAX;

impl<T: Float> Members<T> {
    pub(super) fn none() -> Self {
        Self {
            index: [FREE; MOST_LANES],
            t: [T::default(); MOST_LANES],
            t_new: [T::default(); MOST_LANES],
            h: [T::default(); MOST_LANES],
            steps: [0; MOST_LANES],
            verdict: [T::default(); MOST_LANES],
            alpha: [0.0; MOST_LANES],
            last: [0.0; MOST_LANES],
            most: [0.0; MOST_LANES],
            work: Statistics::default(),
        }
    }

    /// Counts work of all trajectories, in each the same.
    #[inline(always)]
    pub(super) fn count_alike(&mut self, work: &Statistics) {
        self.work.add(work);
    }

    /// Work of each trajectory, as far as it is [the same for all](Self::count_alike).
    pub(super) fn work_of_each(&self) -> &Statistics {
        &self.work
    }

    /// Begins to count anew, for other trajectories.
    pub(super) fn forget_work(&mut self) {
        self.work = Statistics::default();
    }

    /// Puts a trajectory into a lane, at its start.
    pub(super) fn enter(&mut self, lane: usize, index: usize, t: T, pace: Pace<T>) {
        (self.index[lane], self.steps[lane], self.verdict[lane]) = (index, 0, T::from_f64(-1.0));
        (self.t[lane], self.t_new[lane], self.h[lane]) = (t, t, pace.h);
        self.set_controller(lane, pace.controller);
    }

    /// Changes the order of the error estimate of a lane.
    pub(super) fn set_order(&mut self, lane: usize, order: usize) {
        let mut controller = self.controller(lane);
        controller.set_order(order);
        self.set_controller(lane, controller);
    }

    #[inline(always)]
    fn controller(&self, lane: usize) -> PiController {
        PiController {
            alpha: self.alpha[lane],
            last: self.last[lane],
            most: self.most[lane],
        }
    }

    #[inline(always)]
    fn set_controller(&mut self, lane: usize, PiController { alpha, last, most }: PiController) {
        (self.alpha[lane], self.last[lane], self.most[lane]) = (alpha, last, most);
    }

    /// Step size of the trajectory in a lane.
    pub(super) fn pace(&self, lane: usize) -> Pace<T> {
        Pace {
            h: self.h[lane],
            controller: self.controller(lane),
        }
    }

    /// Progress of the trajectory in a lane, in the state `x`.
    pub(super) fn progress<const N: usize>(&self, lane: usize, x: SVector<T, N>, modes: Modes<T, N>) -> Progress<T, N> {
        Progress {
            t: self.t[lane],
            x,
            pace: self.pace(lane),
            steps: self.steps[lane],
            modes,
        }
    }

    /// Empties a lane. Its time stays fixed from then on.
    pub(super) fn leave(&mut self, lane: usize) {
        (self.index[lane], self.t_new[lane]) = (FREE, self.t[lane]);
    }

    /// Index of the trajectory in a lane.
    #[inline(always)]
    pub(super) fn index(&self, lane: usize) -> Option<usize> {
        Some(self.index[lane]).filter(|&index| index != FREE)
    }

    /// Lanes in use, with the indices of their trajectories.
    #[inline(always)]
    pub(super) fn busy(&self, lanes: usize) -> impl Iterator<Item = (usize, usize)> {
        (0..lanes).filter_map(|lane| Some((lane, self.index(lane)?)))
    }

    /// Like [`busy`](Self::busy), for loops in which trajectories may leave.
    pub(super) fn busy_at_first(&self, lanes: usize) -> impl Iterator<Item = (usize, usize)> + use<T> {
        let index = self.index;
        (0..lanes).filter_map(move |lane| Some((lane, index[lane])).filter(|&(_, index)| index != FREE))
    }

    /// True if some lane is empty.
    #[inline(always)]
    pub(super) fn some_are_free(&self, lanes: usize) -> bool {
        self.index[..lanes]
            .iter()
            .fold(false, |some, &index| some | (index == FREE))
    }

    /// Plans a step to the time `t_new` in all lanes.
    pub(super) fn go_to(&mut self, t_new: T) {
        for (lane, end) in self.t_new.iter_mut().enumerate() {
            *end = if self.index[lane] == FREE { self.t[lane] } else { t_new };
        }
    }

    /// Advances all lanes to the ends of their steps.
    pub(super) fn accept_all(&mut self) {
        self.t = self.t_new;
        self.steps.iter_mut().for_each(|steps| *steps += 1);
    }

    /// True if some trajectory has reached `t1`.
    #[inline(always)]
    pub(super) fn some_arrive(&self, lanes: usize, t1: T) -> bool {
        self.t[..lanes].iter().fold(false, |some, &t| some | (t == t1))
    }

    /// Plans the next steps. Returns true if all of them are long enough.
    #[inline(always)]
    pub(super) fn plan<V: Lanes<Scalar = T>>(&mut self, control: &StepControl<T>, t1: T, proposed: Option<V>) -> bool {
        let mut some_refused = false;
        for lane in 0..V::LANES {
            let is_busy = self.index[lane] != FREE;
            let t = self.t[lane];
            let planned = control.planned(self.h[lane], (t, t1), self.steps[lane], self.proposal(lane, &proposed));
            self.h[lane] = planned.h;
            self.t_new[lane] = if is_busy { planned.end } else { t };
            some_refused |= is_busy & planned.is_refused;
        }
        !some_refused
    }

    /// Step size that the method proposes for a lane. After a rejection, the size already chosen.
    #[inline(always)]
    pub(super) fn proposal<V: Lanes<Scalar = T>>(&self, lane: usize, proposed: &Option<V>) -> Option<T> {
        proposed.as_ref().map(|h| {
            if self.is_accepted(lane) {
                h.lane(lane)
            } else {
                self.h[lane]
            }
        })
    }

    /// True if the last attempt in a lane was accepted.
    #[inline(always)]
    pub(super) fn is_accepted(&self, lane: usize) -> bool {
        self.verdict[lane] < T::default()
    }

    /// Lanes that accepted the last attempt.
    #[inline(always)]
    pub(super) fn accepted<V: Lanes<Scalar = T>>(&self) -> Accepted<V> {
        if (0..V::LANES).fold(true, |all, lane| all & self.is_accepted(lane)) {
            Accepted::All
        } else {
            Accepted::Negative(V::from_fn(|lane| self.verdict[lane]))
        }
    }

    /// Accepts or rejects the steps by the mean squares of their errors, and advances the accepted lanes. Returns true
    /// if the next step of every lane is long enough.
    #[inline(always)]
    pub(super) fn judge<V: Lanes<Scalar = T>>(
        &mut self,
        control: &StepControl<T>,
        errors: &V,
        method_proposes: bool,
    ) -> bool {
        // A plain array lets the loop vectorise.
        let mut mean_squares = [T::default(); MOST_LANES];
        let mean_squares = &mut mean_squares[..V::LANES];
        for (lane, mean_square) in mean_squares.iter_mut().enumerate() {
            *mean_square = errors.lane(lane);
        }
        let mut some_hopeless = false;
        for (lane, &mean_square) in mean_squares.iter().enumerate() {
            let (t, t_new) = (self.t[lane], self.t_new[lane]);
            let mut controller = self.controller(lane);
            let planned = (&mut controller, self.h[lane]);
            let judged = control.judged(planned, (t, t_new), mean_square, method_proposes);
            (self.last[lane], self.most[lane]) = (controller.last, controller.most);
            self.h[lane] = judged.h;
            self.steps[lane] += 1;
            self.t[lane] = if judged.is_accepted { t_new } else { t };
            self.verdict[lane] = T::from_f64(if judged.is_accepted { -1.0 } else { 1.0 });
            some_hopeless |= (self.index[lane] != FREE) & judged.is_hopeless;
        }
        !some_hopeless
    }
}

//! The traits of models, by the routines of a tape.

use nalgebra::{SMatrix, SVector};

use super::Model;
use super::model::{Role, into_places};
use crate::constraint::MAX_CONSTRAINTS;
use crate::error::NotAssembled;
use crate::layout::StateLayout;
use crate::real::lanes::Lanes;
use crate::real::{Float, Real};
use crate::shapes::{Shape, Shapes, placed};
use crate::system::{
    Canonical, Energy, Hybrid, HybridJacobian, Jacobian, Plant, PlantCanonical, PlantJacobian, System, assemble,
    by_sign,
};

/// Number of Newton corrections of dependent coordinates after a step, as in generated code.
const CORRECTIONS: usize = 3;
/// Maximum length of the last correction.
const LAST_CORRECTION: f64 = 1e-6;
/// Number of loops, or angles, whose margins are evaluated at a time.
const AT_A_TIME: usize = 8;

impl<T: Real, const N: usize, const HYBRID: bool> Model<T, N, HYBRID> {
    /// Forces along the constraints by friction against the signs of their rates.
    #[inline(always)]
    pub(super) fn sliding(&self, t: T, x: &SVector<T, N>) -> [T; MAX_CONSTRAINTS] {
        if HYBRID {
            by_sign(self, t, x)
        } else {
            [T::default(); MAX_CONSTRAINTS]
        }
    }

    /// True if the model has constraints.
    #[inline]
    pub(super) fn is_hybrid(&self) -> bool {
        HYBRID && !self.tape.constraints.is_empty()
    }

    /// Lengths of the state without padding, and of the list of constraints.
    pub(super) fn sizes(&self) -> [usize; 2] {
        [self.active, self.tape.constraints.len()]
    }

    /// Number, the result of a routine.
    fn number(&self, role: Role, t: T, x: &SVector<T, N>) -> T {
        let mut number = [T::default()];
        self.evaluate_into(self.needed(role), &self.lists(&t, x, &[]), &mut [&mut number]);
        number[0]
    }

    /// Vector, the results of a routine.
    #[inline(always)]
    pub(super) fn vector(&self, role: Role, t: T, x: &SVector<T, N>, forces: &[T]) -> SVector<T, N> {
        let mut vector = SVector::from([T::default(); N]);
        let results = &mut [vector.as_mut_slice()];
        self.evaluate_into(self.needed(role), &self.lists(&t, x, forces), results);
        vector
    }

    /// Writes the results of a routine to places, one after the other.
    pub(super) fn fill<'r>(
        &self,
        routine: usize,
        t: T,
        x: &SVector<T, N>,
        forces: &[T],
        places: impl Iterator<Item = &'r mut T>,
    ) where
        T: 'r,
    {
        self.each(routine, &self.lists(&t, x, forces), &mut into_places(places));
    }

    /// Reports `P` lists of results, all of the length `count`, entry by entry. There may be any number of entries: the
    /// routine runs again for every eight of them, which need no heap.
    pub(super) fn side_by_side<const P: usize>(
        &self,
        routine: usize,
        t: T,
        x: &SVector<T, N>,
        count: usize,
        tell: &mut dyn FnMut(usize, [T; P]),
    ) {
        for first in (0..count).step_by(AT_A_TIME) {
            let mut entries = [[T::default(); P]; AT_A_TIME];
            self.each(routine, &self.lists(&t, x, &[]), &mut |n, value| {
                let (list, entry) = (n / count, n % count);
                let entry = entry.checked_sub(first).and_then(|entry| entries.get_mut(entry));
                if let Some(place) = entry.and_then(|entry| entry.get_mut(list)) {
                    *place = value;
                }
            });
            for (n, entry) in (first..count).zip(entries) {
                tell(n, entry);
            }
        }
    }
}

impl<T: Float, const N: usize, const HYBRID: bool> Model<T, N, HYBRID> {
    /// Returns the state near `x` in which the loops are closed: the independent coordinates stay, the dependent ones
    /// follow. Without loops, `x` itself.
    ///
    /// # Errors
    /// If the loops do not close near `x`.
    pub fn assemble(&self, t: T, x: &SVector<T, N>) -> Result<SVector<T, N>, NotAssembled> {
        let Some(routine) = self.place(Role::LoopCorrections) else {
            return Ok(*x);
        };
        let (mut places, count) = ([0; N], self.tape.dependents().count());
        places
            .iter_mut()
            .zip(self.tape.dependents())
            .for_each(|(to, place)| *to = place);
        let corrections = |x: &SVector<T, N>| {
            let mut corrections = SVector::from([T::default(); N]);
            let results = &mut corrections.as_mut_slice()[..count];
            self.evaluate_into(routine, &self.lists(&t, x, &[]), &mut [results]);
            corrections
        };
        assemble(*x, self.tape.layout(), places, corrections, |x, tell| {
            self.gaps(t, x, tell)
        })
    }
}

impl<T: Real, const N: usize, const HYBRID: bool> System<T, N> for Model<T, N, HYBRID> {
    #[inline(always)]
    fn rhs(&self, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        if HYBRID {
            return self.eval(t, x, &by_sign(self, t, x));
        }
        self.vector(Role::Rhs, t, x, &[])
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rhs_into(&self, t: T, x: &SVector<T, N>, rates: &mut SVector<T, N>) {
        if HYBRID {
            *rates = self.rhs(t, x);
            return;
        }
        let (rates, padding) = rates.as_mut_slice().split_at_mut(self.active);
        self.evaluate_into(self.needed(Role::Rhs), &self.lists(&t, x, &[]), &mut [rates]);
        padding.fill(T::default());
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rhs_with(&self, memory: &mut Vec<T>, t: T, x: &SVector<T, N>, rates: &mut SVector<T, N>) {
        if HYBRID {
            *rates = self.rhs(t, x);
            return;
        }
        let (rates, padding) = rates.as_mut_slice().split_at_mut(self.active);
        self.evaluate_with(memory, self.needed(Role::Rhs), t, x, &mut [rates]);
        padding.fill(T::default());
    }

    #[inline(always)]
    fn active(&self) -> usize {
        self.active
    }

    fn layout(&self) -> Option<StateLayout<'_>> {
        Some(self.tape.layout())
    }

    #[inline]
    fn is_autonomous(&self) -> Option<bool> {
        Some(self.tape.autonomous && self.input_laws().next().is_none())
    }

    #[inline]
    fn project(&self, t: T, x: &mut SVector<T, N>) {
        self.tape.layout().normalise(x);
        let Some(routine) = self.place(Role::LoopCorrections) else {
            return;
        };
        let mut corrections = [T::default(); N];
        let corrections = &mut corrections[..self.tape.dependents().count()];
        for _ in 0..CORRECTIONS {
            self.evaluate_into(routine, &self.lists(&t, x, &[]), &mut [&mut *corrections]);
            for (place, &mut correction) in self.tape.dependents().zip(&mut *corrections) {
                x[place] += correction;
            }
        }
        // not a number if a correction is too long
        let longest = T::from_f64(LAST_CORRECTION * LAST_CORRECTION);
        for &mut correction in corrections {
            x[0] += T::from_f64(0.0) * (longest - correction * correction).sqrt();
        }
    }

    #[inline(always)]
    fn margins(&self, t: T, x: &SVector<T, N>, tell: &mut dyn FnMut([&str; 2], [T; 2])) {
        if let Some(routine) = self.place(Role::LoopMargins) {
            let loops = &self.tape.loops;
            self.side_by_side(routine, t, x, loops.len(), &mut |n, margin| tell(loops[n], margin));
        }
        if let Some(routine) = self.place(Role::TurnMargins) {
            let angles = &self.tape.uncounted;
            self.side_by_side(routine, t, x, angles.len(), &mut |n, margin| {
                tell([angles[n], ""], margin)
            });
        }
    }

    #[inline]
    fn gaps(&self, t: T, x: &SVector<T, N>, tell: &mut dyn FnMut([&str; 2], [T; 3])) {
        if let Some(routine) = self.place(Role::LoopGaps) {
            let (loops, open) = (&self.tape.loops, &self.tape.open_loops);
            self.side_by_side(routine, t, x, open.len(), &mut |n, gap| tell(loops[open[n]], gap));
        }
    }

    #[inline]
    fn each_output(&self, t: T, x: &SVector<T, N>, tell: &mut dyn FnMut(&str, T)) {
        if let Some(routine) = self.place(Role::Outputs) {
            let names = &self.tape.outputs;
            self.each(routine, &self.lists(&t, x, &[]), &mut |n, output| {
                tell(names[n], output)
            });
        }
    }

    #[inline]
    fn hybrid(&self) -> Option<&dyn Hybrid<T, N>> {
        self.is_hybrid().then_some(self)
    }
}

impl<T: Real, const N: usize, const HYBRID: bool> Jacobian<T, N> for Model<T, N, HYBRID> {
    #[inline]
    fn jacobian(&self, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        self.rhs_and_jacobian(t, x).1
    }

    #[inline(always)]
    fn rhs_and_jacobian(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SMatrix<T, N, N>) {
        self.eval_with_jacobian(t, x, &self.sliding(t, x))
    }

    #[inline(always)]
    fn time_derivative(&self, t: T, x: &SVector<T, N>) -> SVector<T, N>
    where
        T: Lanes,
    {
        self.eval_time_derivative(t, x, &self.sliding(t, x))
    }

    #[inline]
    fn hybrid_jacobian(&self) -> Option<&dyn HybridJacobian<T, N>> {
        self.is_hybrid().then_some(self)
    }
}

impl<T: Real, const N: usize, const HYBRID: bool> Energy<T, N> for Model<T, N, HYBRID> {
    fn kinetic(&self, t: T, x: &SVector<T, N>) -> T {
        self.number(Role::Kinetic, t, x)
    }

    fn potential(&self, t: T, x: &SVector<T, N>) -> T {
        self.number(Role::Potential, t, x)
    }
}

impl<const N: usize, const HYBRID: bool> Shapes<N> for Model<f64, N, HYBRID> {
    /// # Panics
    /// If the declaration does not ask for `shapes`.
    fn shapes(&self, t: f64, x: &SVector<f64, N>) -> Vec<Shape<'_>> {
        let name = &self.tape.name;
        let Some(code) = &self.tape.drawing else {
            panic!("the tape of `{name}` has no shapes: add `shapes` to its `generate`")
        };
        let mut numbers = vec![0.0; code.results.len()];
        self.write(code, &self.lists(&t, x, &[]), numbers.iter_mut());
        placed(&self.tape.outlines, &numbers)
    }
}

impl<T: Real, const N: usize, const HYBRID: bool> Canonical<T, N> for Model<T, N, HYBRID> {
    #[inline]
    fn canonical(&self, t: T, x: &SVector<T, N>) -> (SVector<T, N>, SVector<T, N>) {
        self.eval_canonical(t, x, &self.sliding(t, x))
    }

    #[inline]
    fn canonical_jacobian(&self, t: T, x: &SVector<T, N>) -> (SMatrix<T, N, N>, SMatrix<T, N, N>) {
        self.eval_canonical_jacobian(t, x, &self.sliding(t, x))
    }

    #[inline]
    fn hybrid_canonical(&self) -> Option<&dyn PlantCanonical<T, N, Given = [T; MAX_CONSTRAINTS]>> {
        self.is_hybrid().then_some(self)
    }
}

//! The traits of models, by the routines of a tape.

use nalgebra::{SMatrix, SVector};

use super::model::{Role, lists};
use super::source::Lists;
use super::{Given, Model};
use crate::constraint::{Constraint, Law, MAX_CONSTRAINTS, MeasureDerivatives, Response, ResponseDerivative};
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
    /// Arguments of a routine under forces along the constraints.
    #[inline(always)]
    fn under<'a>(&'a self, forces: &'a [T]) -> Given<'a, T> {
        Given {
            inputs: self.inputs(),
            forces,
            ..Given::default()
        }
    }

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
    fn sizes(&self) -> [usize; 2] {
        [self.active, self.tape.constraints.len()]
    }

    /// Number, the result of a routine.
    fn number(&self, role: Role, t: T, x: &SVector<T, N>) -> T {
        let mut number = [T::default()];
        self.evaluate(self.needed(role), t, x, &self.under(&[]), &mut number);
        number[0]
    }

    /// Vector, the results of a routine.
    #[inline(always)]
    fn vector(&self, role: Role, t: T, x: &SVector<T, N>, forces: &[T]) -> SVector<T, N> {
        let mut vector = SVector::from([T::default(); N]);
        self.evaluate(self.needed(role), t, x, &self.under(forces), vector.as_mut_slice());
        vector
    }

    /// Writes the results of a routine to places, one after the other.
    fn fill<'r>(&self, routine: usize, t: T, x: &SVector<T, N>, forces: &[T], places: impl Iterator<Item = &'r mut T>)
    where
        T: 'r,
    {
        let code = &self.tape.routines[routine].code;
        self.write(code, &lists(&t, x, &self.under(forces)), places);
    }

    /// Reports `P` lists of results, all of the length `count`, entry by entry. There may be any number of entries, and
    /// no heap: the routine runs again for every eight of them.
    fn side_by_side<const P: usize>(
        &self,
        routine: usize,
        t: T,
        x: &SVector<T, N>,
        count: usize,
        tell: &mut dyn FnMut(usize, [T; P]),
    ) {
        for first in (0..count).step_by(AT_A_TIME) {
            let mut entries = [[T::default(); P]; AT_A_TIME];
            self.each(routine, t, x, &self.under(&[]), &mut |n, value| {
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
            self.evaluate(routine, t, x, &self.under(&[]), results);
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
        self.evaluate_into(self.needed(Role::Rhs), t, x, &self.under(&[]), &mut [rates]);
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
    fn project(&self, t: T, x: &mut SVector<T, N>) {
        for places in self.tape.layout().quaternions() {
            let mut squares = places.clone().map(|place| x[place] * x[place]);
            let first = squares.next().unwrap_or_default();
            let norm = squares.fold(first, |sum, square| sum + square).sqrt();
            places.for_each(|place| x[place] /= norm);
        }
        let Some(routine) = self.place(Role::LoopCorrections) else {
            return;
        };
        let mut corrections = [T::default(); N];
        let corrections = &mut corrections[..self.tape.dependents().count()];
        for _ in 0..CORRECTIONS {
            self.evaluate(routine, t, x, &self.under(&[]), corrections);
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
            self.each(routine, t, x, &self.under(&[]), &mut |n, output| tell(names[n], output));
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
        self.write(code, &lists(&t, x, &self.under(&[])), numbers.iter_mut());
        placed(&self.tape.outlines, &numbers)
    }
}

impl<T: Real, const N: usize, const HYBRID: bool> Plant<T, N> for Model<T, N, HYBRID> {
    type Given = [T; MAX_CONSTRAINTS];

    #[inline(always)]
    fn eval(&self, t: T, x: &SVector<T, N>, forces: &[T; MAX_CONSTRAINTS]) -> SVector<T, N> {
        self.vector(Role::Rhs, t, x, forces)
    }

    #[inline]
    fn dof(&self) -> usize {
        self.tape.layout().rates()
    }

    #[inline]
    fn constraints(&self) -> &[Constraint<'_>] {
        &self.tape.constraints
    }

    fn laws(&self) -> [Law<T>; MAX_CONSTRAINTS] {
        let mut laws = [Law::default(); MAX_CONSTRAINTS];
        let numbers = laws.iter_mut().zip(&self.tape.limits).flat_map(|(law, &[low, high])| {
            law.low = low.then(T::default);
            law.high = high.then(T::default);
            let always = [
                &mut law.slipping,
                &mut law.sticking,
                &mut law.restitution,
                &mut law.slow,
            ];
            always.into_iter().chain(&mut law.low).chain(&mut law.high)
        });
        self.write(&self.tape.laws, &Lists::new(), numbers);
        laws
    }

    fn measures(&self, t: T, x: &SVector<T, N>) -> [[T; 2]; MAX_CONSTRAINTS] {
        let mut measures = [[T::default(); 2]; MAX_CONSTRAINTS];
        if let Some(routine) = self.place(Role::Measures) {
            let count = self.tape.constraints.len();
            self.side_by_side(routine, t, x, count, &mut |n, measure| measures[n] = measure);
        }
        measures
    }

    fn response(&self, t: T, x: &SVector<T, N>, forces: &[T; MAX_CONSTRAINTS]) -> Response<T, N> {
        let Some(routine) = self.place(Role::Response) else {
            return Response::new(self.eval(t, x, forces));
        };
        let mut response = Response::new(SVector::from([T::default(); N]));
        let places = places(&mut response, self.sizes());
        self.fill(routine, t, x, forces, places);
        symmetric(&mut response);
        response
    }
}

/// Entries of the active rows and columns of a matrix, column by column.
fn entries<T, const N: usize>(matrix: &mut SMatrix<T, N, N>, active: usize) -> impl Iterator<Item = &mut T> {
    let columns = matrix.data.0[..active].iter_mut();
    columns.flat_map(move |column| &mut column[..active])
}

/// Moves the entries of a matrix of `active` rows and columns, which follow one another, to their places in a larger
/// one.
fn spread<T: Real, const N: usize>(matrix: &mut SMatrix<T, N, N>, active: usize) {
    if active == N {
        return;
    }
    let entries = matrix.as_mut_slice();
    for column in (1..active).rev() {
        entries.copy_within(column * active..(column + 1) * active, column * N);
    }
    for column in 0..active {
        entries[column * N + active..(column + 1) * N].fill(T::default());
    }
}

/// Places of the results of a response; of its symmetric matrix, the upper triangle.
fn places<T, const N: usize>(
    response: &mut Response<T, N>,
    [active, constraints]: [usize; 2],
) -> impl Iterator<Item = &mut T> {
    let columns = response.columns[..constraints]
        .iter_mut()
        .flat_map(move |column| &mut column.as_mut_slice()[..active]);
    let rows = response.matrix[..constraints].iter_mut().enumerate();
    let triangle = rows.flat_map(move |(i, row)| &mut row[i..constraints]);
    response
        .rates
        .iter_mut()
        .take(active)
        .chain(&mut response.accelerations[..constraints])
        .chain(columns)
        .chain(triangle)
}

/// Sets the lower triangle of the matrix of a response to its upper one.
fn symmetric<T: Real, const N: usize>(response: &mut Response<T, N>) {
    for i in 0..MAX_CONSTRAINTS {
        for j in 0..i {
            response.matrix[i][j] = response.matrix[j][i];
        }
    }
}

impl<T: Real, const N: usize, const HYBRID: bool> PlantJacobian<T, N> for Model<T, N, HYBRID> {
    #[inline(always)]
    fn eval_with_jacobian(
        &self,
        t: T,
        x: &SVector<T, N>,
        forces: &[T; MAX_CONSTRAINTS],
    ) -> (SVector<T, N>, SMatrix<T, N, N>) {
        let (mut rhs, mut jacobian) = (
            SVector::from([T::default(); N]),
            SMatrix::<T, N, N>::from([[T::default(); N]; N]),
        );
        let results = &mut [&mut rhs.as_mut_slice()[..self.active], jacobian.as_mut_slice()];
        self.evaluate_into(self.needed(Role::Jacobian), t, x, &self.under(forces), results);
        spread(&mut jacobian, self.active);
        (rhs, jacobian)
    }

    #[inline]
    fn eval_time_derivative(&self, t: T, x: &SVector<T, N>, forces: &[T; MAX_CONSTRAINTS]) -> SVector<T, N>
    where
        T: Lanes,
    {
        match self.place(Role::TimeDerivative) {
            Some(_) => self.vector(Role::TimeDerivative, t, x, forces),
            // time does not occur
            None => SVector::from([T::default(); N]),
        }
    }

    fn response_derivative(&self, t: T, x: &SVector<T, N>, forces: &[T; MAX_CONSTRAINTS]) -> ResponseDerivative<T, N>
    where
        T: Lanes,
    {
        let ([active, count], zero) = (self.sizes(), T::default());
        let mut derivative = ResponseDerivative {
            response: Response::new(SVector::from([zero; N])),
            rates: SMatrix::from([[zero; N]; N]),
            accelerations: [SVector::from([zero; N]); MAX_CONSTRAINTS],
            rates_by_time: SVector::from([zero; N]),
            accelerations_by_time: [zero; MAX_CONSTRAINTS],
        };
        let places = places(&mut derivative.response, [active, count])
            .chain(entries(&mut derivative.rates, active))
            .chain(
                derivative.accelerations[..count]
                    .iter_mut()
                    .flat_map(|gradient| &mut gradient.as_mut_slice()[..active]),
            )
            .chain(derivative.rates_by_time.iter_mut().take(active))
            .chain(&mut derivative.accelerations_by_time[..count]);
        self.fill(self.needed(Role::ResponseDerivative), t, x, forces, places);
        symmetric(&mut derivative.response);
        derivative
    }

    fn measure_derivatives(&self, t: T, x: &SVector<T, N>) -> MeasureDerivatives<T, N> {
        let ([active, count], zero) = (self.sizes(), T::default());
        let (mut by_state, mut by_time) = (
            [[SVector::from([zero; N]); MAX_CONSTRAINTS]; 2],
            [[zero; MAX_CONSTRAINTS]; 2],
        );
        let of_state = by_state
            .iter_mut()
            .flat_map(|rows| &mut rows[..count])
            .flat_map(|row| &mut row.as_mut_slice()[..active]);
        let of_time = by_time.iter_mut().flat_map(|rows| &mut rows[..count]);
        self.fill(
            self.needed(Role::MeasureDerivatives),
            t,
            x,
            &[],
            of_state.chain(of_time),
        );
        MeasureDerivatives {
            by_state: core::array::from_fn(|n| [by_state[0][n], by_state[1][n]]),
            by_time: core::array::from_fn(|n| [by_time[0][n], by_time[1][n]]),
        }
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

impl<T: Real, const N: usize, const HYBRID: bool> PlantCanonical<T, N> for Model<T, N, HYBRID> {
    fn eval_canonical(&self, t: T, x: &SVector<T, N>, forces: &[T; MAX_CONSTRAINTS]) -> (SVector<T, N>, SVector<T, N>) {
        let [mut y, mut rates] = [SVector::from([T::default(); N]); 2];
        let results = &mut [&mut y.as_mut_slice()[..self.active], rates.as_mut_slice()];
        self.evaluate_into(self.needed(Role::Canonical), t, x, &self.under(forces), results);
        (y, rates)
    }

    fn eval_canonical_jacobian(
        &self,
        t: T,
        x: &SVector<T, N>,
        forces: &[T; MAX_CONSTRAINTS],
    ) -> (SMatrix<T, N, N>, SMatrix<T, N, N>) {
        let [mut of_y, mut of_rates] = [SMatrix::<T, N, N>::from([[T::default(); N]; N]); 2];
        let entries = self.active * self.active;
        let results = &mut [&mut of_y.as_mut_slice()[..entries], of_rates.as_mut_slice()];
        self.evaluate_into(self.needed(Role::CanonicalJacobian), t, x, &self.under(forces), results);
        spread(&mut of_y, self.active);
        spread(&mut of_rates, self.active);
        (of_y, of_rates)
    }
}

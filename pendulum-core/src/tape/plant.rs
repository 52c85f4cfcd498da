//! The functions of models with forces along constraints, by the routines of a tape.

use nalgebra::{SMatrix, SVector};

use super::Model;
use super::model::Role;
use super::source::Lists;
use crate::constraint::{Constraint, Law, MAX_CONSTRAINTS, MeasureDerivatives, Response, ResponseDerivative};
use crate::real::Real;
use crate::real::lanes::Lanes;
use crate::system::{Plant, PlantCanonical, PlantJacobian};

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
    fn orientations(&self) -> &[[usize; 2]] {
        &self.tape.orientations
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
        self.evaluate_into(self.needed(Role::Jacobian), &self.lists(&t, x, forces), results);
        spread(&mut jacobian, self.active);
        (rhs, jacobian)
    }

    #[inline]
    fn eval_time_derivative(&self, t: T, x: &SVector<T, N>, forces: &[T; MAX_CONSTRAINTS]) -> SVector<T, N>
    where
        T: Lanes,
    {
        let mut derivative = match self.place(Role::TimeDerivative) {
            Some(_) => self.vector(Role::TimeDerivative, t, x, forces),
            // time does not occur
            None => SVector::from([T::default(); N]),
        };
        for (rate, by_input) in self.input_rates(t, x) {
            derivative
                .iter_mut()
                .zip(&by_input)
                .for_each(|(sum, &by)| *sum += by * rate);
        }
        derivative
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
        if self.input_laws().next().is_none() {
            return derivative;
        }
        // As under a law in the number type: the rates of constraints are linear in the rates of the state.
        let measures = self.measure_derivatives(t, x).by_state;
        for (rate, by_input) in self.input_rates(t, x) {
            let sums = derivative.rates_by_time.iter_mut().zip(&by_input);
            sums.for_each(|(sum, &by)| *sum += by * rate);
            for ([_, slopes], sum) in measures[..count].iter().zip(&mut derivative.accelerations_by_time) {
                *sum += slopes
                    .iter()
                    .zip(&by_input)
                    .fold(zero, |sum, (&slope, &by)| sum + slope * by)
                    * rate;
            }
        }
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

impl<T: Real, const N: usize, const HYBRID: bool> PlantCanonical<T, N> for Model<T, N, HYBRID> {
    fn eval_canonical(&self, t: T, x: &SVector<T, N>, forces: &[T; MAX_CONSTRAINTS]) -> (SVector<T, N>, SVector<T, N>) {
        let [mut y, mut rates] = [SVector::from([T::default(); N]); 2];
        let results = &mut [&mut y.as_mut_slice()[..self.active], rates.as_mut_slice()];
        self.evaluate_into(self.needed(Role::Canonical), &self.lists(&t, x, forces), results);
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
        self.evaluate_into(
            self.needed(Role::CanonicalJacobian),
            &self.lists(&t, x, forces),
            results,
        );
        spread(&mut of_y, self.active);
        spread(&mut of_rates, self.active);
        (of_y, of_rates)
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

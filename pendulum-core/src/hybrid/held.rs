//! Equations of motion with some rates held at zero.

use nalgebra::{SMatrix, SVector};

use super::complementarity::{Factored, solve_negated};
use super::mode::bits;
use super::{Hold, Hybrid, HybridJacobian, MAX_CONSTRAINTS, Response};
use crate::real::Real;
use crate::real::lanes::Lanes;

/// Right-hand side of a hybrid system in a mode.
///
/// Neither it nor its derivatives are inlined, and they take a trait object, so systems that are not hybrid contain
/// none of this code.
#[inline(never)]
pub(crate) fn rhs<T: Real, const N: usize>(
    system: &dyn Hybrid<T, N>,
    hold: &Hold<T>,
    t: T,
    x: &SVector<T, N>,
) -> SVector<T, N> {
    if hold.held == 0 {
        return system.eval(t, x, &hold.forces);
    }
    held(system, hold, t, x).0
}

/// Like [`rhs`], but also returns its derivative with respect to the state.
#[inline(never)]
pub(crate) fn rhs_and_jacobian<T: Lanes, const N: usize>(
    system: &dyn HybridJacobian<T, N>,
    hold: &Hold<T>,
    t: T,
    x: &SVector<T, N>,
) -> (SVector<T, N>, SMatrix<T, N, N>) {
    if hold.held == 0 {
        return system.eval_with_jacobian(t, x, &hold.forces);
    }
    let (rates, forces) = held(system, hold, t, x);
    // derivatives at fixed forces first, as for friction; the changes of the holding forces are added below
    let derivative = system.response_derivative(t, x, &forces);
    let factored = Factored::of(&derivative.response.matrix, hold.solved);
    let mut jacobian = derivative.rates;
    for component in 0..N {
        let slopes = derivative.accelerations.map(|gradient| gradient[component]);
        let changes = factored.solve_negated(&slopes);
        let mut column = SVector::from(core::array::from_fn(|row| jacobian[(row, component)]));
        add(&mut column, &derivative.response, hold.solved, &changes);
        pin(system, hold.held, &mut column);
        for row in 0..N {
            jacobian[(row, component)] = column[row];
        }
    }
    (rates, jacobian)
}

/// Derivative of [`rhs`] with respect to the time.
#[inline(never)]
pub(crate) fn time_derivative<T: Lanes, const N: usize>(
    system: &dyn HybridJacobian<T, N>,
    hold: &Hold<T>,
    t: T,
    x: &SVector<T, N>,
) -> SVector<T, N> {
    let derivative = system.response_derivative(t, x, &forces(system, hold, t, x));
    let factored = Factored::of(&derivative.response.matrix, hold.solved);
    let changes = factored.solve_negated(&derivative.accelerations_by_time);
    let mut column = derivative.rates_by_time;
    add(&mut column, &derivative.response, hold.solved, &changes);
    pin(system, hold.held, &mut column);
    column
}

/// Right-hand side with holding forces, and all forces along the constraints.
#[inline(always)]
fn held<S, T, const N: usize>(
    system: &S,
    hold: &Hold<T>,
    t: T,
    x: &SVector<T, N>,
) -> (SVector<T, N>, [T; MAX_CONSTRAINTS])
where
    S: Hybrid<T, N> + ?Sized,
    T: Real,
{
    let response = system.response(t, x, &hold.forces);
    let forces = solve_negated(&response.matrix, hold.solved, &response.accelerations);
    let mut rates = response.rates;
    add(&mut rates, &response, hold.solved, &forces);
    pin(system, hold.held, &mut rates);
    (rates, with_solved(hold, &forces))
}

/// Merges the forces solved for into all forces along the constraints.
#[inline(always)]
fn with_solved<T: Real>(hold: &Hold<T>, forces: &[T; MAX_CONSTRAINTS]) -> [T; MAX_CONSTRAINTS] {
    let mut all = hold.forces;
    for n in bits(hold.solved) {
        all[n] = forces[n];
    }
    all
}

/// Power series of the forces along the constraints in a mode, for the power series of the motion.
///
/// The force coefficients of one order enter the same order of the constraints' second derivatives through the
/// constraint matrix at the start. Solving with it gives the coefficients that make the second derivatives vanish.
pub struct HeldSeries<T> {
    /// Forces at the start.
    pub forces: [T; MAX_CONSTRAINTS],
    held: u8,
    factored: Factored<T>,
}

impl<T: Real> HeldSeries<T> {
    /// Computes the forces at the start of a motion in a mode.
    #[inline(always)]
    pub fn new<S, const N: usize>(system: &S, hold: &Hold<T>, t: T, x: &SVector<T, N>) -> Self
    where
        S: Hybrid<T, N> + ?Sized,
    {
        // nothing is held in lanes
        if T::LANES > 1 || hold.held == 0 {
            return Self {
                forces: hold.forces,
                held: 0,
                factored: Factored::none(),
            };
        }
        let response = system.response(t, x, &hold.forces);
        let factored = Factored::of(&response.matrix, hold.solved);
        Self {
            forces: with_solved(hold, &factored.solve_negated(&response.accelerations)),
            held: hold.held,
            factored,
        }
    }

    /// Returns the force coefficients of the next order, from the coefficients of the constraints' second derivatives
    /// without them.
    #[inline(always)]
    pub fn next(&self, accelerations: &[T; MAX_CONSTRAINTS]) -> [T; MAX_CONSTRAINTS] {
        self.factored.solve_negated(accelerations)
    }

    /// Sets the rates of held constraints to exactly zero in a coefficient of the motion.
    #[inline(always)]
    pub fn pin<S, const N: usize>(&self, system: &S, x: &mut SVector<T, N>)
    where
        S: Hybrid<T, N> + ?Sized,
    {
        pin(system, self.held, x);
    }
}

/// Forces along the constraints in a mode, holding forces included.
#[inline(always)]
pub(crate) fn forces<S, T, const N: usize>(system: &S, hold: &Hold<T>, t: T, x: &SVector<T, N>) -> [T; MAX_CONSTRAINTS]
where
    S: Hybrid<T, N> + ?Sized,
    T: Real,
{
    if hold.held == 0 {
        return hold.forces;
    }
    let response = system.response(t, x, &hold.forces);
    with_solved(
        hold,
        &solve_negated(&response.matrix, hold.solved, &response.accelerations),
    )
}

/// Forces along the constraints for the [reduced] canonical equations. Holding forces along sums of components do not
/// enter these, and are omitted if nothing else is held.
#[inline(never)]
pub(crate) fn pressing<T, const N: usize>(
    system: &dyn Hybrid<T, N>,
    hold: &Hold<T>,
    t: T,
    x: &SVector<T, N>,
) -> [T; MAX_CONSTRAINTS]
where
    T: Real,
{
    let constraints = system.constraints();
    if bits(hold.held).all(|n| !constraints[n].rate.is_empty()) {
        return hold.forces;
    }
    forces(system, hold, t, x)
}

/// Reduces canonical variables and their rates, or the derivatives of both, by the momenta of held constraints: see
/// [`InMode`](super::InMode).
#[inline(never)]
pub(crate) fn reduced<T: Real, const N: usize, const K: usize>(
    system: &dyn Hybrid<T, N>,
    held: u8,
    x: &SMatrix<T, N, K>,
    (mut variables, mut rates): (SMatrix<T, N, K>, SMatrix<T, N, K>),
) -> (SMatrix<T, N, K>, SMatrix<T, N, K>) {
    let constraints = system.constraints();
    // in reverse order: a dependent component may itself determine others
    for n in (0..constraints.len()).rev().filter(|n| held & 1 << n != 0) {
        let Some((&(last, sign), others)) = constraints[n].rate.split_last() else {
            continue;
        };
        for column in 0..K {
            for of_momenta in [&mut variables, &mut rates] {
                for &(other, its) in others {
                    let follows = T::from_f64(-f64::from(its * sign)) * of_momenta[(last, column)];
                    of_momenta[(other, column)] += follows;
                }
            }
        }
    }
    for n in bits(held) {
        let Some(&(last, _)) = constraints[n].rate.last() else {
            continue;
        };
        for column in 0..K {
            let rate = constraints[n]
                .rate
                .iter()
                .map(|&(at, sign)| T::from_f64(f64::from(sign)) * x[(at, column)]);
            variables[(last, column)] = rate.fold(T::default(), |sum, term| sum + term);
            rates[(last, column)] = T::default();
        }
    }
    (variables, rates)
}

/// Adds the effect of forces along some constraints.
#[inline(always)]
pub(super) fn add<T: Real, const N: usize>(
    rates: &mut SVector<T, N>,
    response: &Response<T, N>,
    along: u8,
    forces: &[T; MAX_CONSTRAINTS],
) {
    for n in bits(along) {
        for component in 0..N {
            rates[component] += response.columns[n][component] * forces[n];
        }
    }
}

/// Sets the rates of held constraints to exactly zero in a state or in its derivative.
#[inline(always)]
pub(super) fn pin<S, T, const N: usize>(system: &S, held: u8, x: &mut SVector<T, N>)
where
    S: Hybrid<T, N> + ?Sized,
    T: Real,
{
    let constraints = system.constraints();
    for n in bits(held) {
        let Some((&(last, sign), others)) = constraints[n].rate.split_last() else {
            continue;
        };
        let mut sum = T::default();
        for &(other, its) in others {
            sum += T::from_f64(-f64::from(its * sign)) * x[other];
        }
        x[last] = sum;
    }
}

//! States moved to where they are held.

use nalgebra::SVector;

use super::complementarity::{independent, solve_negated};
use super::held::pin;
use super::mode::{Status, bits, set_of};
use super::{Hold, Hybrid, Law, MAX_CONSTRAINTS, Response};
use crate::real::Float;

/// Moves a state to where it is held: each rate to zero, and to its limit the position of whatever is `touching` one, be
/// it held there or not.
pub(crate) fn project<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    hold: &Hold<T>,
    touching: &[Status; MAX_CONSTRAINTS],
    t: T,
    x: &mut SVector<T, N>,
) {
    pin(system, hold.held, x);
    let constraints = system.constraints();
    if bits(hold.held).all(|n| !constraints[n].rate.is_empty()) {
        return;
    }
    let laws = system.laws();
    let response = system.response(t, x, &hold.forces);
    let touched = set_of((0..MAX_CONSTRAINTS).filter(|&n| touching[n].touches()));
    let placed = if touched & !hold.held == 0 {
        hold.solved
    } else {
        independent(&response.matrix, hold.held | touched)
    };
    // the second time for what is quadratic in the first
    for _ in 0..2 {
        let measures = system.measures(t, x);
        shift(x, N / 2, &response, placed, &apart(&laws, touching, &measures));
        let rates = system.measures(t, x).map(|[_, rate]| rate);
        shift(x, 0, &response, hold.solved, &rates);
    }
    pin(system, hold.held, x);
}

/// How far from its limit each constraint is that touches one.
pub(crate) fn apart<T: Float>(
    laws: &[Law<T>; MAX_CONSTRAINTS],
    touching: &[Status; MAX_CONSTRAINTS],
    measures: &[[T; 2]; MAX_CONSTRAINTS],
) -> [T; MAX_CONSTRAINTS] {
    core::array::from_fn(|n| {
        let limit = match touching[n] {
            Status::Low => laws[n].low,
            Status::High => laws[n].high,
            _ => None,
        };
        limit.map_or(T::default(), |limit| measures[n][0] - limit)
    })
}

/// Moves coordinates to the limits that they touch, to the last bit.
pub(crate) fn place_coordinates<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    touching: &[Status; MAX_CONSTRAINTS],
    t: T,
    x: &mut SVector<T, N>,
) {
    let apart = apart(&system.laws(), touching, &system.measures(t, x));
    for (n, constraint) in system.constraints().iter().enumerate() {
        if let Some(&(component, sign)) = constraint.rate.last() {
            x[component - N / 2] -= T::from_f64(f64::from(sign)) * apart[n];
        }
    }
}

/// Takes what some constraints have off positions or rates, which stand so far `before` the rates: a column holds what
/// a force does to the rates, and along it the least kinetic energy moves.
pub(super) fn shift<T: Float, const N: usize>(
    x: &mut SVector<T, N>,
    before: usize,
    response: &Response<T, N>,
    solved: u8,
    surplus: &[T; MAX_CONSTRAINTS],
) {
    let moves = solve_negated(&response.matrix, solved, surplus);
    for n in bits(solved) {
        for component in N / 2..N {
            x[component - before] += response.columns[n][component] * moves[n];
        }
    }
}

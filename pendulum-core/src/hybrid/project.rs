//! Projection of states onto held constraints.

use nalgebra::SVector;

use super::complementarity::{independent, solve_negated};
use super::held::pin;
use super::kinematics::Kinematics;
use super::mode::{Status, bits, set_of};
use super::{Hold, Hybrid, Law, MAX_CONSTRAINTS, Response};
use crate::real::Float;

/// Projects a state onto the constraints: sets held rates to zero, and moves each constraint that is `touching` a limit
/// onto it, even if it is not held there.
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
    let (laws, kinematics) = (system.laws(), Kinematics::of(system));
    let response = system.response(t, x, &hold.forces);
    let touched = set_of((0..MAX_CONSTRAINTS).filter(|&n| touching[n].touches()));
    let placed = if touched & !hold.held == 0 {
        hold.solved
    } else {
        independent(&response.matrix, hold.held | touched)
    };
    // the second pass removes the quadratic error of the first
    for _ in 0..2 {
        let measures = system.measures(t, x);
        shift_positions(x, kinematics, (&response, placed), &apart(&laws, touching, &measures));
        let rates = system.measures(t, x).map(|[_, rate]| rate);
        shift_rates(x, kinematics, (&response, hold.solved), &rates);
    }
    pin(system, hold.held, x);
}

/// Distance of each touching constraint from its limit.
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

/// Moves coordinates exactly onto the limits that they touch.
pub(crate) fn place_coordinates<T: Float, const N: usize>(
    system: &dyn Hybrid<T, N>,
    touching: &[Status; MAX_CONSTRAINTS],
    t: T,
    x: &mut SVector<T, N>,
) {
    let apart = apart(&system.laws(), touching, &system.measures(t, x));
    let kinematics = Kinematics::of(system);
    for (n, constraint) in system.constraints().iter().enumerate() {
        if let Some(&(component, sign)) = constraint.rate.last() {
            x[kinematics.position(component)] -= T::from_f64(f64::from(sign)) * apart[n];
        }
    }
}

/// Moves a state that is beyond limits onto them: coordinates by themselves, and gaps along the columns of the
/// response.
#[cfg(feature = "fit")]
pub(crate) fn place_inside<T: Float, const N: usize>(system: &dyn Hybrid<T, N>, t: T, x: &mut SVector<T, N>) {
    let (laws, constraints, kinematics) = (system.laws(), system.constraints(), Kinematics::of(system));
    // the second pass removes the quadratic error of the first
    for _ in 0..2 {
        let measures = system.measures(t, x);
        let beyond: [Status; MAX_CONSTRAINTS] = core::array::from_fn(|n| match measures[n][0] {
            value if laws[n].low.is_some_and(|low| value < low) => Status::Low,
            value if laws[n].high.is_some_and(|high| value > high) => Status::High,
            _ => Status::Free,
        });
        if !beyond.iter().any(|status| status.touches()) {
            return;
        }
        place_coordinates(system, &beyond, t, x);
        let gaps = (0..constraints.len()).filter(|&n| beyond[n].touches() && constraints[n].rate.is_empty());
        let response = system.response(t, x, &[T::default(); MAX_CONSTRAINTS]);
        let solved = independent(&response.matrix, set_of(gaps));
        let surplus = apart(&laws, &beyond, &system.measures(t, x));
        shift_positions(x, kinematics, (&response, solved), &surplus);
    }
}

/// Removes a surplus of the values of some constraints from the positions. The correction follows the columns of the
/// response, along which it takes the least kinetic energy.
pub(super) fn shift_positions<T: Float, const N: usize>(
    x: &mut SVector<T, N>,
    kinematics: Kinematics<'_>,
    (response, solved): (&Response<T, N>, u8),
    surplus: &[T; MAX_CONSTRAINTS],
) {
    let moves = solve_negated(&response.matrix, solved, surplus);
    for n in bits(solved) {
        kinematics.displace(x, |component| response.columns[n][component] * moves[n]);
    }
}

/// Like [`shift_positions`], but removes a surplus of rates.
pub(super) fn shift_rates<T: Float, const N: usize>(
    x: &mut SVector<T, N>,
    kinematics: Kinematics<'_>,
    (response, solved): (&Response<T, N>, u8),
    surplus: &[T; MAX_CONSTRAINTS],
) {
    let moves = solve_negated(&response.matrix, solved, surplus);
    for n in bits(solved) {
        for component in kinematics.rates() {
            x[component] += response.columns[n][component] * moves[n];
        }
    }
}

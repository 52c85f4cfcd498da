//! Transfer of tangents across mode switches.

use nalgebra::{SMatrix, SVector};

use super::complementarity::Factored;
use super::held::{forces, pin, rhs};
use super::mode::{Mode, bits, set_of};
use super::resolution::CONSISTENT;
use super::witness::{Witness, Witnesses};
use super::{Hold, HybridJacobian, MAX_CONSTRAINTS, ModeSwitch};
use crate::linear::image;
use crate::real::{Float, ulps};

/// Computes the saltation matrix `S`, which maps a tangent `v` before a mode switch to `S v` after it.
///
/// With the function `g` whose zero ends the mode, the jump `r` of the state, and the right-hand sides `f-` before and
/// `f+` after, it is `Dr + (f+ - Dr f- - dr/dt) Dg / (Dg f- + dg/dt)` (M. di Bernardo, C. J. Budd, A. R. Champneys, P.
/// Kowalczyk, "Piecewise-smooth Dynamical Systems" 2008, Sec. 2.5). If two modes end at the same time, `g` is the
/// function of the first.
pub(crate) fn saltation<T: Float, const N: usize>(
    system: &dyn HybridJacobian<T, N>,
    passage: &ModeSwitch<T, N>,
) -> SMatrix<T, N, N> {
    let ModeSwitch {
        t,
        before: (x, mode, hold),
        fired,
        after: (x_after, hold_after),
        ..
    } = passage;
    let slope = rhs(system, hold, *t, x);
    let slope_after = rhs(system, hold_after, *t, x_after);
    let (by_state, by_time) = jump(system, passage);
    let apart = slope_after - image(&by_state, &slope) - by_time;
    if apart.iter().all(|&apart| apart == T::default()) {
        return by_state;
    }
    // the sign of the function makes no difference
    let (gradient, by_time) = first(system, (*t, x), (mode, hold), *fired);
    let speed = (0..N).fold(by_time, |sum, n| sum + gradient[n] * slope[n]);
    let size = (0..N).fold(by_time.abs(), |sum, n| sum + (gradient[n] * slope[n]).abs());
    // neighbours of a trajectory that arrives at rest have no definite time of arrival
    if speed.abs() <= ulps(CONSISTENT, size) {
        return by_state;
    }
    SMatrix::from_fn(|i, j| by_state[(i, j)] + apart[i] * gradient[j] / speed)
}

/// Removes the components of tangents that would move held constraints, since neighbouring trajectories lose them at
/// once. The rates of all held constraints are fixed, but the position only where a limit pushes back harder than
/// friction could: friction holds a constraint in any position.
///
/// A neighbour at a small distance `d` from the limit reaches it after a time of the order of the root of `d`. The
/// pushes missing on its way and the pushes at its arrival cancel, but their delay moves it along the Lie bracket of
/// the motion `f` with the column `c` of the push, `Df c - Dc f`, whether it rebounds or not.
pub(crate) fn hold_tangents<T: Float, const N: usize>(
    system: &dyn HybridJacobian<T, N>,
    hold: &Hold<T>,
    (t, x): (T, &SVector<T, N>),
    tangents: &mut [SVector<T, N>],
) {
    let (laws, forces) = (system.laws(), forces(system, hold, t, x));
    let beyond_friction = T::from_f64(1.0 + AT_REST);
    let is_pressed = |&n: &usize| {
        let has_limit = laws[n].low.is_some() || laws[n].high.is_some();
        has_limit && forces[n].abs() > beyond_friction * laws[n].sticking
    };
    let pressed = set_of(bits(hold.solved).filter(is_pressed));
    let measures = system.measure_derivatives(t, x);
    let response = system.response(t, x, &hold.forces);
    let factored = Factored::of(&response.matrix, hold.solved);
    let take_off = |tangent: &mut SVector<T, N>, which: usize, held: u8, along: &[SVector<T, N>; MAX_CONSTRAINTS]| {
        let mut moving = [T::default(); MAX_CONSTRAINTS];
        for n in bits(held) {
            let slope = &measures.by_state[n][which];
            moving[n] = (0..N).fold(T::default(), |sum, i| sum + slope[i] * tangent[i]);
        }
        let changes = factored.solve_negated(&moving);
        for n in bits(hold.solved) {
            for component in 0..N {
                tangent[component] += along[n][component] * changes[n];
            }
        }
    };
    // positions first, since rates depend on them
    if pressed != 0 {
        let free = system.response_derivative(t, x, &[T::default(); MAX_CONSTRAINTS]);
        let mut brackets = response.columns;
        for n in bits(hold.solved) {
            let unit = core::array::from_fn(|m| T::from_f64(f64::from(u8::from(m == n))));
            let under = system.response_derivative(t, x, &unit);
            brackets[n] = image(&free.rates, &response.columns[n])
                - image(&(under.rates - free.rates), &response.rates)
                - (under.rates_by_time - free.rates_by_time);
        }
        for tangent in &mut *tangents {
            take_off(tangent, 0, pressed, &brackets);
        }
    }
    for tangent in tangents {
        take_off(tangent, 1, hold.solved, &response.columns);
        pin(system, hold.held, tangent);
    }
}

/// Margin of the largest friction force at rest for rounding errors, relative to the force.
const AT_REST: f64 = 1e-10;

/// Derivatives of the state after a jump with respect to the state before and to the time.
fn jump<T: Float, const N: usize>(
    system: &dyn HybridJacobian<T, N>,
    passage: &ModeSwitch<T, N>,
) -> (SMatrix<T, N, N>, SVector<T, N>) {
    let zero = T::default();
    let (t, x, impulses) = (passage.t, &passage.before.0, &passage.impulses);
    let mut by_state = SMatrix::from_fn(|i, j| T::from_f64(f64::from(u8::from(i == j))));
    let mut by_time = SVector::from_element(zero);
    let hit = set_of((0..MAX_CONSTRAINTS).filter(|&n| impulses[n] != zero));
    if hit == 0 {
        return (by_state, by_time);
    }
    // effects are linear in the impulses: evaluated as forces, they give the dependence on the state
    let (under, free) = (
        system.response_derivative(t, x, impulses),
        system.response_derivative(t, x, &[zero; MAX_CONSTRAINTS]),
    );
    let measures = system.measure_derivatives(t, x);
    let (rates, after) = (system.measures(t, x), system.measures(t, &passage.after.0));
    // removed share of the rate: 1 + e
    let taken = |n: usize| {
        let [_, rate] = rates[n];
        if rate == zero {
            zero
        } else {
            (rate - after[n][1]) / rate
        }
    };
    let factored = Factored::of(&under.response.matrix, hit);
    let column = |of_matrix: SVector<T, N>, of_rates: &dyn Fn(usize) -> T, of_accelerations: &dyn Fn(usize) -> T| {
        let asked: [T; MAX_CONSTRAINTS] = core::array::from_fn(|n| taken(n) * of_rates(n) + of_accelerations(n));
        let changes = factored.solve_negated(&asked);
        bits(hit).fold(of_matrix, |sum, n| sum + under.response.columns[n] * changes[n])
    };
    for j in 0..N {
        let of_matrix = SVector::from_fn(|i, _| under.rates[(i, j)] - free.rates[(i, j)]);
        let change = column(of_matrix, &|n| measures.by_state[n][1][j], &|n| {
            under.accelerations[n][j] - free.accelerations[n][j]
        });
        for i in 0..N {
            by_state[(i, j)] += change[i];
        }
    }
    by_time += column(
        under.rates_by_time - free.rates_by_time,
        &|n| measures.by_time[n][1],
        &|n| under.accelerations_by_time[n] - free.accelerations_by_time[n],
    );
    (by_state, by_time)
}

/// Derivatives, up to their sign, of the first witness that fired with respect to the state and to the time.
fn first<T: Float, const N: usize>(
    system: &dyn HybridJacobian<T, N>,
    (t, x): (T, &SVector<T, N>),
    (mode, hold): (&Mode, &Hold<T>),
    fired: Witnesses,
) -> (SVector<T, N>, T) {
    let n = fired.first();
    if mode.is_held(n) {
        let derivative = system.response_derivative(t, x, &forces(system, hold, t, x));
        let factored = Factored::of(&derivative.response.matrix, hold.solved);
        let of = |slopes: &[T; MAX_CONSTRAINTS]| factored.solve_negated(slopes)[n];
        let gradient = SVector::from_fn(|j, _| of(&derivative.accelerations.map(|gradient| gradient[j])));
        return (gradient, of(&derivative.accelerations_by_time));
    }
    // the rate of a slipping constraint, or the value of one that reaches a limit
    let which = usize::from(fired.has(n, Witness::Slip));
    let measures = system.measure_derivatives(t, x);
    (measures.by_state[n][which], measures.by_time[n][which])
}

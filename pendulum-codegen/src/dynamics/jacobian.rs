//! What the state Jacobian is solved from.
//!
//! With `r(x, qdd) = A qdd + bias - force` zero along the motion, `A d(qdd)/dx = -dr/dx` at fixed `qdd`: the same matrix as
//! that of the right-hand side, so one factorisation serves both.

use crate::expr::{Derivative, ExprId, Graph};
use crate::model::Coordinate;

use super::Dynamics;

/// The partial derivatives of `A qdd + bias - force` at fixed accelerations: one column of length `n` for each variable. The
/// accelerations stand in it as the symbols of the coordinates.
pub fn partials(g: &Graph, dynamics: &Dynamics, variables: &[ExprId]) -> Vec<Vec<ExprId>> {
    derived(g, &dynamics.balance, variables)
}

/// The derivatives of some expressions by some symbols: one column for each symbol.
pub fn derived(g: &Graph, rows: &[ExprId], symbols: &[ExprId]) -> Vec<Vec<ExprId>> {
    let column = |&symbol: &ExprId| {
        let mut derivative = Derivative::by(symbol);
        rows.iter().map(|&row| derivative.of(g, row)).collect()
    };
    symbols.iter().map(column).collect()
}

/// The [`partials`] by the state, from the derivatives of inverse dynamics that the recursion knows without deriving expressions; none
/// where it does not, or by other variables.
pub fn partials_by_recursion(
    g: &Graph,
    dynamics: &Dynamics,
    coordinates: &[Coordinate],
    variables: &[ExprId],
) -> Option<Vec<Vec<ExprId>>> {
    let tangent = dynamics.tangent.as_ref()?;
    let column = |&variable: &ExprId| {
        let of = |part: fn(&Coordinate) -> ExprId| coordinates.iter().position(|c| part(c) == variable);
        let (matrix, k) = match (of(|c| c.position), of(|c| c.rate)) {
            (Some(k), _) => (&tangent.by_position, k),
            (None, Some(k)) => (&tangent.by_rate, k),
            (None, None) => return None,
        };
        let mut derivative = Derivative::by(variable);
        let rows = matrix.iter().zip(&dynamics.force);
        let entry = |(row, &force): (&Vec<ExprId>, &ExprId)| {
            let of_force = derivative.of(g, force);
            g.sub(row[k], of_force)
        };
        Some(rows.map(entry).collect())
    };
    variables.iter().map(column).collect()
}

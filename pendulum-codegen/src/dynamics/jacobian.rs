//! What the state Jacobian is solved from.
//!
//! With `r(x, qdd) = A qdd + bias - force` zero along the motion, `A d(qdd)/dx = -dr/dx` at fixed `qdd`: the same matrix as
//! that of the right-hand side, so one factorisation serves both.

use crate::expr::{Derivative, ExprId, Graph};
use crate::model::Coordinate;

use super::Dynamics;

/// The partial derivatives of `A qdd + bias - force` at fixed accelerations: one column of length `n` for each variable. The
/// accelerations stand in it as the symbols of the coordinates.
pub fn partials(
    g: &mut Graph,
    dynamics: &Dynamics,
    coordinates: &[Coordinate],
    variables: &[ExprId],
) -> Vec<Vec<ExprId>> {
    let balance: Vec<ExprId> = dynamics
        .mass_matrix
        .iter()
        .zip(&dynamics.residual)
        .map(|(row, &residual)| {
            row.iter().zip(coordinates).fold(residual, |sum, (&entry, coordinate)| {
                let term = g.mul(entry, coordinate.acceleration);
                g.add(sum, term)
            })
        })
        .collect();
    let column = |g: &mut Graph, variable: ExprId| {
        let mut derivative = Derivative::by(variable);
        balance.iter().map(|&row| derivative.of(g, row)).collect()
    };
    variables.iter().map(|&variable| column(g, variable)).collect()
}

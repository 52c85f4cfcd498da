//! What the state Jacobian is solved from.
//!
//! With `r(x, qdd) = A qdd + bias - force` zero along the motion, `A d(qdd)/dx = -dr/dx` at fixed `qdd`: the same matrix as
//! that of the right-hand side, so one factorisation serves both.

use crate::expr::{Derivative, ExprId, Graph};

use super::Dynamics;

/// The partial derivatives of `A qdd + bias - force` at fixed accelerations: one column of length `n` for each variable. The
/// accelerations stand in it as the symbols of the coordinates.
pub fn partials(g: &mut Graph, dynamics: &Dynamics, variables: &[ExprId]) -> Vec<Vec<ExprId>> {
    let column = |&variable: &ExprId| {
        let mut derivative = Derivative::by(variable);
        dynamics.balance.iter().map(|&row| derivative.of(g, row)).collect()
    };
    variables.iter().map(column).collect()
}

//! Systems from which the state Jacobian is solved.
//!
//! With `r(x, qdd) = A qdd + bias - force` zero along the motion, `A d(qdd)/dx = -dr/dx` at fixed `qdd`. The
//! accelerations are solved with the same matrix, so one factorisation serves both.

use crate::expr::{Derivative, Expr};
use crate::model::Coordinate;

use super::Balance;

/// Partial derivatives of `A qdd + bias - force` at fixed accelerations: one column of length `n` for each variable.
/// The accelerations are the symbols of the coordinates.
pub(crate) fn partials<'g>(balance: &Balance<'g>, variables: &[Expr<'g>]) -> Vec<Vec<Expr<'g>>> {
    derived(&balance.rows, variables)
}

/// Derivatives of expressions with respect to symbols: one column for each symbol.
pub(crate) fn derived<'g>(rows: &[Expr<'g>], symbols: &[Expr<'g>]) -> Vec<Vec<Expr<'g>>> {
    let column = |&symbol: &Expr<'g>| {
        let mut derivative = Derivative::by(symbol);
        rows.iter().map(|&row| derivative.of(row)).collect()
    };
    symbols.iter().map(column).collect()
}

/// The [`partials`] with respect to the state, from the derivatives of inverse dynamics that the recursion provides
/// without differentiating expressions. Returns `None` if it provides none, or if a variable is not part of the state.
pub(crate) fn partials_by_recursion<'g>(
    balance: &Balance<'g>,
    coordinates: &[Coordinate<'g>],
    variables: &[Expr<'g>],
) -> Option<Vec<Vec<Expr<'g>>>> {
    let tangent = balance.tangent.as_ref()?;
    let column = |&variable: &Expr<'g>| {
        let of = |part: fn(&Coordinate<'g>) -> Expr<'g>| coordinates.iter().position(|c| part(c) == variable);
        let (matrix, k) = match (of(|c| c.position), of(|c| c.rate)) {
            (Some(k), _) => (&tangent.by_position, k),
            (None, Some(k)) => (&tangent.by_rate, k),
            (None, None) => return None,
        };
        let mut derivative = Derivative::by(variable);
        let rows = matrix.iter().zip(&tangent.force);
        Some(rows.map(|(row, &force)| row[k] - derivative.of(force)).collect())
    };
    variables.iter().map(column).collect()
}

//! Systems from which the state Jacobian is solved.
//!
//! With `r(x, qdd) = A qdd + bias - force` zero along the motion, `A d(qdd)/dx = -dr/dx` at fixed `qdd`. The
//! accelerations are solved with the same matrix, so one factorisation serves both.

use crate::expr::{Derivative, Expr};
use crate::model::{Coordinate, CoordinateId};

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

/// A coordinate or its rate, as a variable of the state.
#[derive(Clone, Copy, Debug)]
pub(super) enum StateVariable {
    Position(CoordinateId),
    Rate(CoordinateId),
}

impl StateVariable {
    /// Returns the coordinate or rate that a symbol stands for, if any.
    pub(super) fn of<'g>(coordinates: &[Coordinate<'g>], symbol: Expr<'g>) -> Option<Self> {
        let of = |part: fn(&Coordinate<'g>) -> Expr<'g>| {
            let at = coordinates.iter().position(|coordinate| part(coordinate) == symbol);
            at.map(CoordinateId::new)
        };
        of(|coordinate| coordinate.position)
            .map(Self::Position)
            .or_else(|| of(|coordinate| coordinate.rate).map(Self::Rate))
    }
}

/// The [`partials`], from the derivatives of inverse dynamics that the recursion provides without differentiating
/// expressions. Those with respect to quaternions are derived as expressions. Returns `None` if the recursion provides
/// none of them.
pub(crate) fn partials_by_recursion<'g>(
    balance: &Balance<'g>,
    coordinates: &[Coordinate<'g>],
    variables: &[Expr<'g>],
) -> Option<Vec<Vec<Expr<'g>>>> {
    let tangent = balance.tangent.as_ref()?;
    let known = |&variable: &Expr<'g>| StateVariable::of(coordinates, variable);
    let column = |variable: &Expr<'g>| {
        let mut derivative = Derivative::by(*variable);
        let (matrix, k) = match known(variable) {
            Some(StateVariable::Position(k)) => (&tangent.by_position, usize::from(k)),
            Some(StateVariable::Rate(k)) => (&tangent.by_rate, usize::from(k)),
            None => return balance.rows.iter().map(|&row| derivative.of(row)).collect(),
        };
        let rows = matrix.iter().zip(&tangent.force);
        rows.map(|(row, &force)| row[k] - derivative.of(force)).collect()
    };
    let is_any_known = variables.iter().any(|variable| known(variable).is_some());
    is_any_known.then(|| variables.iter().map(column).collect())
}

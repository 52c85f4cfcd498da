//! Motion in canonical variables: the coordinates and their momenta `p = A qd`.
//!
//! `dp/dt = A qdd + (dA/dt) qd`, where `A qdd` is the force less the bias, so there is nothing to solve and nothing to
//! divide by. The right-hand side is `dL/dq + Q` of Lagrange's equations: half of `(dA/dt) qd` cancels against the
//! bias, once both are in normal form.

use crate::expr::Expr;
use crate::model::{Coordinate, Model};

use super::{Balance, Lagrangian, derived};

/// Time derivatives of the momenta, as functions of the state.
pub(crate) fn momentum_rates<'g>(
    model: &Model<'g>,
    balance: &Balance<'g>,
    lagrangian: &Lagrangian<'g>,
) -> Vec<Expr<'g>> {
    let mut along_motion = model.along_motion();
    let rows = lagrangian.momentum.iter().zip(&balance.residual);
    rows.map(|(&momentum, &residual)| along_motion.of(momentum) - residual)
        .collect()
}

/// Derivatives of the momenta with respect to the state, column by column. The columns of the rates are the mass
/// matrix.
pub(crate) fn momentum_partials<'g>(
    coordinates: &[Coordinate<'g>],
    balance: &Balance<'g>,
    lagrangian: &Lagrangian<'g>,
) -> Vec<Vec<Expr<'g>>> {
    let positions: Vec<Expr<'g>> = coordinates.iter().map(|c| c.position).collect();
    let mut columns = derived(&lagrangian.momentum, &positions);
    columns.extend(balance.mass_matrix.iter().cloned());
    columns
}

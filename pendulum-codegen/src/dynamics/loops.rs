//! Wrenches of joints that close loops.

use crate::expr::{Derivative, Expr};
use crate::loops::Orthogonal;
use crate::model::{Model, Poses, Row};
use crate::screw::{Vec3, Wrench};

/// Wrench of the first body of each closing joint on the second, about the place of the joint on the second body, in
/// the ground frame: moment and force, loop by loop. Together the wrenches supply the forces `held` along the dependent
/// coordinates.
///
/// Forces `f` that keep `phi(q) = 0` act along the coordinates as `J^T f`. Components not determined by a motion, such
/// as forces out of the plane of a planar linkage, are zero; for redundant equations the `f` of minimum norm is taken.
pub(crate) fn loop_wrenches<'g>(model: &Model<'g>, held: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
    let of_loops: Vec<Vec<Row<'g>>> = model.closures.iter().map(|closure| closure.equations(model)).collect();
    let values: Vec<Expr<'g>> = of_loops.iter().flatten().map(|row| row.value).collect();
    let columns: Vec<Vec<Expr<'g>>> = model
        .dependents
        .iter()
        .map(|dependent| {
            let mut alone = Derivative::by(dependent.position).alone();
            let column: Vec<Expr<'g>> = values.iter().map(|&value| alone.of(value)).collect();
            model.with_drives(&column)
        })
        .collect();
    let mut forces = Orthogonal::new(&columns).solve_transposed(held).into_iter();
    let (poses, zero) = (Poses::new(model), Vec3::zero(model.graph));
    let wrenches = model.closures.iter().zip(of_loops).flat_map(|(closure, rows)| {
        let still = Wrench {
            moment: zero,
            force: zero,
        };
        let Wrench { moment, force } = rows
            .iter()
            .zip(&mut forces)
            .fold(still, |sum, (row, f)| sum - f * row.wrench);
        let carrier = closure.carrier(model);
        [moment, force].map(|v| poses.direction(carrier, v).0).concat()
    });
    model.with_drives(&wrenches.collect::<Vec<_>>())
}

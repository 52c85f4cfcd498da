//! Dynamics along joints, and in the coordinates of the scene.

use super::actions::{along_coordinates, is_wrench};
use super::{Dynamics, Tangent, balance, tangent};
use crate::expr::{Expr, ratio};
use crate::model::{Action, Combination, Model, index_types};

index_types! {
    /// A joint: of a body, or of a link.
    pub(super) JointId;
}

/// An entry of a matrix over the joints: row, column and value.
pub(super) type Entry<'g> = (JointId, JointId, Expr<'g>);

/// The dynamics along joints whose coordinates are `q_i = motions[i]` in those of the scene.
#[derive(Debug)]
pub(super) struct AlongJoints<'g> {
    pub(super) motions: Vec<Combination>,
    /// `A_ij` for `i <= j`.
    pub(super) mass_matrix: Vec<Entry<'g>>,
    /// What is taken when only the drives accelerate.
    pub(super) bias: Vec<Expr<'g>>,
    /// `A qd`
    pub(super) momenta: Vec<Expr<'g>>,
    /// What is known in a form that is shorter than `A` and `bias` written out.
    pub(super) inertial: Option<Inertial<'g>>,
    /// The bias, and `A qdd + bias`, less the wrenches that act on the links.
    pub(super) pushed: Option<[Vec<Expr<'g>>; 2]>,
}

/// What a recursion knows along the joints without a mass matrix.
#[derive(Debug)]
pub(super) struct Inertial<'g> {
    /// `A qdd + bias`.
    pub(super) forces: Vec<Expr<'g>>,
    /// Its derivatives.
    pub(super) tangent: tangent::Tangent<'g>,
}

impl<'g> AlongJoints<'g> {
    /// The dynamics in the coordinates of the scene. With `q = T theta` the mass matrix becomes `T^T A T`, a force `T^T tau`.
    pub(super) fn in_coordinates(self, model: &Model<'g>, potential: Expr<'g>) -> Dynamics<'g> {
        let Self {
            motions,
            mass_matrix,
            bias,
            momenta,
            inertial,
            pushed,
        } = self;
        let n = model.dof();
        let mass_matrix = {
            let both = mass_matrix.into_iter().flat_map(|(i, j, entry)| {
                let mirrored = (i != j).then_some((j, i, entry));
                std::iter::once((i, j, entry)).chain(mirrored)
            });
            pull_back_matrix(model, &motions, both)
        };
        let along = |list: Vec<Expr<'g>>| pull_back(model, motions.iter().zip(list));
        let (as_wrenches, others): (Vec<&Action<'g>>, Vec<_>) = model.actions.iter().partition(|a| is_wrench(a));
        let sum = |a: &[Expr<'g>], b: &[Expr<'g>]| -> Vec<Expr<'g>> { a.iter().zip(b).map(|(&a, &b)| a + b).collect() };
        let less =
            |a: &[Expr<'g>], b: &[Expr<'g>]| -> Vec<Expr<'g>> { a.iter().zip(b).map(|(&a, &b)| a - b).collect() };
        let of_joints = pull_back(model, model.bodies.iter().map(|body| (&body.motion, body.force)));
        let apart = sum(&of_joints, &along_coordinates(model, &others));
        let mut force = sum(&apart, &along_coordinates(model, &as_wrenches));
        let of_drives: Vec<Vec<Expr<'g>>> = mass_matrix[n..].iter().map(|row| row[..n].to_vec()).collect();
        let mass_matrix: Vec<Vec<Expr<'g>>> = mass_matrix[..n].iter().map(|row| row[..n].to_vec()).collect();
        let mut bias = along(bias);
        let (mut residual, mut balanced, tangent) = match inertial {
            Some(Inertial { forces, tangent }) => {
                let [residual, balance] = match pushed {
                    Some(pushed) => pushed.map(|left| less(&along(left), &apart)),
                    None => [less(&bias, &force), less(&along(forces), &force)],
                };
                let free = |matrix: Vec<Vec<Expr<'g>>>| matrix[..n].iter().map(|row| row[..n].to_vec()).collect();
                let tangent = Tangent {
                    by_position: free(pull_back_matrix(model, &motions, tangent.by_position)),
                    by_rate: free(pull_back_matrix(model, &motions, tangent.by_rate)),
                };
                (residual, balance, Some(tangent))
            }
            None => {
                let residual = less(&bias, &force);
                let rows = [&mass_matrix[..], &of_drives[..]].concat();
                let balanced = balance(&model.coordinates, &rows, &residual);
                (residual, balanced, None)
            }
        };
        let drive = balanced.split_off(n);
        let (momentum, kinetic) = if model.drives.is_empty() && tangent.is_none() {
            let momentum = momentum(model, &mass_matrix);
            let kinetic = kinetic(model, &momentum);
            (momentum, kinetic)
        } else if model.drives.is_empty() {
            let momentum = along(momenta);
            let kinetic = kinetic(model, &momentum);
            (momentum, kinetic)
        } else {
            let products = motions
                .iter()
                .zip(&momenta)
                .map(|(motion, &momentum)| model.rate_of(motion) * momentum);
            let products: Vec<Expr<'g>> = products.collect();
            let mut momentum = along(momenta);
            momentum.truncate(n);
            (momentum, ratio(1, 2) * model.graph.sum(products))
        };
        for list in [&mut bias, &mut force, &mut residual] {
            list.truncate(n);
        }
        let dynamics = Dynamics {
            mass_matrix,
            bias,
            force,
            residual,
            balance: balanced,
            drive,
            tangent,
            momentum,
            kinetic,
            potential,
        };
        dynamics.with_drives(model)
    }
}

/// `T^T tau`
fn pull_back<'g, 'm>(
    model: &Model<'g>,
    along_joints: impl Iterator<Item = (&'m Combination, Expr<'g>)>,
) -> Vec<Expr<'g>> {
    let mut pulled = vec![model.graph.zero(); model.dof() + model.drives.len()];
    for (motion, along) in along_joints {
        for (k, t) in motion.terms() {
            pulled[k] += t * along;
        }
    }
    pulled
}

/// `T^T M T`
fn pull_back_matrix<'g>(
    model: &Model<'g>,
    motions: &[Combination],
    entries: impl IntoIterator<Item = Entry<'g>>,
) -> Vec<Vec<Expr<'g>>> {
    let n = model.dof() + model.drives.len();
    let mut pulled = vec![vec![model.graph.zero(); n]; n];
    for (i, j, entry) in entries {
        for (k, t) in motions[i].terms() {
            for (l, u) in motions[j].terms() {
                pulled[k][l] += (t * u) * entry;
            }
        }
    }
    pulled
}

/// `A qd`
fn momentum<'g>(model: &Model<'g>, mass_matrix: &[Vec<Expr<'g>>]) -> Vec<Expr<'g>> {
    mass_matrix.iter().map(|row| times_rates(model, row)).collect()
}

/// Half of `qd . momentum`.
fn kinetic<'g>(model: &Model<'g>, momentum: &[Expr<'g>]) -> Expr<'g> {
    ratio(1, 2) * times_rates(model, momentum)
}

/// The scalar product with the rates.
fn times_rates<'g>(model: &Model<'g>, row: &[Expr<'g>]) -> Expr<'g> {
    let products: Vec<Expr<'g>> = row.iter().zip(&model.coordinates).map(|(&a, c)| a * c.rate).collect();
    model.graph.sum(products)
}

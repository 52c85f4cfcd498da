//! Dynamics along joints, and in the coordinates of the scene.

use super::{Dynamics, Tangent, balance, tangent};
use crate::expr::{Expr, ratio};
use crate::model::{Combination, Model, index_types};

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
    pub(super) bias: Vec<Expr<'g>>,
    /// What is known in a form that is shorter than `A` and `bias` written out.
    pub(super) inertial: Option<Inertial<'g>>,
}

/// What a recursion knows along the joints without a mass matrix.
#[derive(Debug)]
pub(super) struct Inertial<'g> {
    /// `A qdd + bias`.
    pub(super) forces: Vec<Expr<'g>>,
    /// Its derivatives.
    pub(super) tangent: tangent::Tangent<'g>,
    /// `A qd`.
    pub(super) momenta: Vec<Expr<'g>>,
}

impl<'g> AlongJoints<'g> {
    /// The dynamics in the coordinates of the scene. With `q = T theta` the mass matrix becomes `T^T A T`, a force `T^T tau`.
    pub(super) fn in_coordinates(self, model: &Model<'g>, potential: Expr<'g>) -> Dynamics<'g> {
        let Self {
            motions,
            mass_matrix,
            bias,
            inertial,
        } = self;
        let both = mass_matrix.into_iter().flat_map(|(i, j, entry)| {
            let mirrored = (i != j).then_some((j, i, entry));
            std::iter::once((i, j, entry)).chain(mirrored)
        });
        let mass_matrix = pull_back_matrix(model, &motions, both);
        let force = pull_back(model, model.bodies.iter().map(|body| (&body.motion, body.force)));
        let bias = pull_back(model, motions.iter().zip(bias));
        let less_forces =
            |list: &[Expr<'g>]| -> Vec<Expr<'g>> { list.iter().zip(&force).map(|(&x, &force)| x - force).collect() };
        let residual = less_forces(&bias);
        let (balance, tangent, momentum) = match inertial {
            Some(Inertial {
                forces,
                tangent,
                momenta,
            }) => {
                let [forces, momentum] = [forces, momenta].map(|along| pull_back(model, motions.iter().zip(along)));
                let tangent = Tangent {
                    by_position: pull_back_matrix(model, &motions, tangent.by_position),
                    by_rate: pull_back_matrix(model, &motions, tangent.by_rate),
                };
                (less_forces(&forces), Some(tangent), momentum)
            }
            None => {
                let momentum = momentum(model, &mass_matrix);
                (balance(&model.coordinates, &mass_matrix, &residual), None, momentum)
            }
        };
        let kinetic = kinetic(model, &momentum);
        Dynamics {
            mass_matrix,
            bias,
            force,
            residual,
            balance,
            tangent,
            momentum,
            kinetic,
            potential,
        }
    }
}

/// `T^T tau`
fn pull_back<'g, 'm>(
    model: &Model<'g>,
    along_joints: impl Iterator<Item = (&'m Combination, Expr<'g>)>,
) -> Vec<Expr<'g>> {
    let mut pulled = vec![model.graph.zero(); model.dof()];
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
    let n = model.dof();
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

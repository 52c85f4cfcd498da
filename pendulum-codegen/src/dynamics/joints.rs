//! Dynamics along joints, and its conversion to the coordinates of the scene.

use super::actions::{along_coordinates, is_wrench};
use super::joint::Entry;
use super::{Balance, Dynamics, Lagrangian, Reactions, Tangent, tangent};
use crate::expr::{Expr, ratio};
use crate::model::{Action, Combination, Floating, Model};

/// Dynamics along joints with coordinates `q_i = motions[i]` in terms of the coordinates of the scene.
#[derive(Debug)]
pub(super) struct AlongJoints<'g> {
    pub(super) motions: Vec<Combination>,
    /// `A_ij` for `i <= j`.
    pub(super) mass_matrix: Vec<Entry<'g>>,
    /// Forces required when only the drives accelerate.
    pub(super) bias: Vec<Expr<'g>>,
    /// `A qd`, if it is known in another form than this product. Required for scenes with drives.
    pub(super) momenta: Option<Vec<Expr<'g>>>,
    /// Inertial forces `A qdd + bias` in a form shorter than `A` and `bias` written out, if known.
    pub(super) inertial: Option<Vec<Expr<'g>>>,
    /// Derivatives of the inertial forces, if known.
    pub(super) tangent: Option<tangent::Tangent<'g>>,
    /// The bias, and `A qdd + bias`, each less the wrenches that act on the links.
    pub(super) pushed: Option<[Vec<Expr<'g>>; 2]>,
    /// Floating bodies; the forces of their slides are along their own axes.
    pub(super) floating: Vec<Floating<'g>>,
}

impl<'g> AlongJoints<'g> {
    /// Converts the dynamics to the coordinates of the scene. With `q = T theta` the mass matrix becomes `T^T A T`, a
    /// force `T^T tau`. The coordinates of drives stand behind the others until they are separated.
    pub(super) fn in_coordinates(self, model: &Model<'g>, potential: Expr<'g>) -> Dynamics<'g> {
        let n = model.dof();
        let matrix = pull_back_matrix(
            model,
            &self.motions,
            self.mass_matrix.iter().copied().flat_map(mirrored),
        );
        let [apart, force] = forces(model).map(|along| self.of_bodies(along));
        let held = match &self.pushed {
            _ if !model.generate.contains("loop_wrenches") => Vec::new(),
            Some([_, pushed]) => self.held(model, pushed, &apart),
            None => self.held(model, &self.inertial_forces(model), &force),
        };
        let [apart, force] = [apart, force].map(|along| free(model, along));
        let bias = self.pulled(model, &self.bias);
        let of_matrix = |residual: Vec<Expr<'g>>| {
            let rows = Balance::new(&model.coordinates, matrix.clone(), residual.clone()).rows;
            (residual, rows)
        };
        let (residual, mut rows) = match (&self.pushed, &self.inertial) {
            (Some([left, _]), None) => of_matrix(less(&self.pulled(model, left), &apart)),
            (Some(pushed), Some(_)) => pushed
                .each_ref()
                .map(|left| less(&self.pulled(model, left), &apart))
                .into(),
            (None, Some(inertial)) => (less(&bias, &force), less(&self.pulled(model, inertial), &force)),
            (None, None) => of_matrix(less(&bias, &force)),
        };
        let drive = rows.split_off(n);
        let (momentum, kinetic) = self.momentum_and_energy(model, &matrix);
        // this tangent leaves out changes through dependent coordinates
        let tangent = self.tangent.filter(|_| model.dependents.is_empty()).map(|tangent| {
            let [by_position, by_rate] = [tangent.by_position, tangent.by_rate]
                .map(|entries| of_state(model, &pull_back_matrix(model, &self.motions, entries)));
            Tangent {
                by_position,
                by_rate,
                force: force[..n].to_vec(),
            }
        });
        let dynamics = Dynamics {
            balance: Balance {
                mass_matrix: of_state(model, &matrix),
                residual: residual[..n].to_vec(),
                rows,
                tangent,
            },
            lagrangian: Lagrangian {
                bias: bias[..n].to_vec(),
                force: force[..n].to_vec(),
                momentum,
                kinetic,
                potential,
            },
            reactions: Reactions { drive, held },
        };
        dynamics.with_drives(model)
    }

    /// Rotates the forces of slides, among forces along all coordinates, to the axes of the floating bodies.
    fn of_bodies(&self, mut along: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
        self.floating.iter().for_each(|joint| joint.turn_forces(&mut along));
        along
    }

    /// Forces left to be supplied along the dependent coordinates: the forces `along` the joints, less the `force`
    /// along all coordinates.
    fn held(&self, model: &Model<'g>, along: &[Expr<'g>], force: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let all = pull_back(model, self.motions.iter().zip(along.iter().copied()));
        less(&all, force).split_off(model.independent())
    }

    /// Inertial forces `A qdd + bias` along the joints.
    fn inertial_forces(&self, model: &Model<'g>) -> Vec<Expr<'g>> {
        if let Some(inertial) = &self.inertial {
            return inertial.clone();
        }
        let mut forces = self.bias.clone();
        for (i, j, entry) in self.mass_matrix.iter().copied().flat_map(mirrored) {
            forces[i] += entry * model.own_acceleration_of(&self.motions[j]);
        }
        forces
    }

    fn pulled(&self, model: &Model<'g>, along: &[Expr<'g>]) -> Vec<Expr<'g>> {
        free(model, pull_back(model, self.motions.iter().zip(along.iter().copied())))
    }

    /// Momenta of the coordinates, and kinetic energy of all joints.
    fn momentum_and_energy(&self, model: &Model<'g>, matrix: &[Vec<Expr<'g>>]) -> (Vec<Expr<'g>>, Expr<'g>) {
        let n = model.dof();
        let momentum = match &self.momenta {
            Some(momenta) => self.pulled(model, momenta)[..n].to_vec(),
            None => matrix[..n].iter().map(|row| times_rates(model, row)).collect(),
        };
        let twice = match &self.momenta {
            Some(momenta) if !model.drives.is_empty() || !model.dependents.is_empty() => {
                let joints = self.motions.iter().zip(momenta);
                let products = joints.map(|(motion, &momentum)| model.rate_of(motion) * momentum);
                model.graph.sum(products.collect::<Vec<_>>())
            }
            _ => times_rates(model, &momentum),
        };
        (momentum, ratio(1, 2) * twice)
    }
}

/// Forces along all coordinates: without the actions that are wrenches on links, and with them.
fn forces<'g>(model: &Model<'g>) -> [Vec<Expr<'g>>; 2] {
    let (as_wrenches, others): (Vec<&Action<'g>>, Vec<_>) = model.actions.iter().partition(|a| is_wrench(a));
    let of_joints = pull_back(model, model.bodies.iter().map(|body| (&body.motion, body.force)));
    let sum = |a: &[Expr<'g>], b: &[Expr<'g>]| -> Vec<Expr<'g>> { a.iter().zip(b).map(|(&a, &b)| a + b).collect() };
    let apart = sum(&of_joints, &along_coordinates(model, &others));
    let all = sum(&apart, &along_coordinates(model, &as_wrenches));
    [apart, all]
}

fn less<'g>(a: &[Expr<'g>], b: &[Expr<'g>]) -> Vec<Expr<'g>> {
    a.iter().zip(b).map(|(&a, &b)| a - b).collect()
}

/// An entry and its mirror image across the diagonal.
fn mirrored<'g>((i, j, entry): Entry<'g>) -> impl Iterator<Item = Entry<'g>> {
    let mirrored = (i != j).then_some((j, i, entry));
    std::iter::once((i, j, entry)).chain(mirrored)
}

/// Rows and columns of the state coordinates in a matrix over all coordinates.
fn of_state<'g>(model: &Model<'g>, matrix: &[Vec<Expr<'g>>]) -> Vec<Vec<Expr<'g>>> {
    let n = model.dof();
    matrix[..n].iter().map(|row| row[..n].to_vec()).collect()
}

/// Pulls forces along the joints back to the coordinates, `T^T tau`.
fn pull_back<'g, 'm>(
    model: &Model<'g>,
    along_joints: impl Iterator<Item = (&'m Combination, Expr<'g>)>,
) -> Vec<Expr<'g>> {
    let mut pulled = vec![model.graph.zero(); model.all_coordinates().count()];
    for (motion, along) in along_joints {
        for (k, t) in motion.terms() {
            pulled[k] += t * along;
        }
    }
    pulled
}

/// Reduces forces along all coordinates to forces along the independent ones: `tau + N^T tau'`, where `N` holds the
/// slopes of the dependent coordinates.
pub(super) fn free<'g>(model: &Model<'g>, mut along: Vec<Expr<'g>>) -> Vec<Expr<'g>> {
    let of_dependents = along.split_off(model.independent());
    for (dependent, force) in model.loops.dependents.iter().zip(of_dependents) {
        for (sum, &slope) in along.iter_mut().zip(&dependent.slopes) {
            *sum += slope * force;
        }
    }
    along
}

/// Pulls a matrix over the joints back to the coordinates, `T^T M T`.
fn pull_back_matrix<'g>(
    model: &Model<'g>,
    motions: &[Combination],
    entries: impl IntoIterator<Item = Entry<'g>>,
) -> Vec<Vec<Expr<'g>>> {
    let n = model.all_coordinates().count();
    let mut pulled = vec![vec![model.graph.zero(); n]; n];
    for (i, j, entry) in entries {
        for (k, t) in motions[i].terms() {
            for (l, u) in motions[j].terms() {
                pulled[k][l] += (t * u) * entry;
            }
        }
    }
    // N^T M N, by columns and then by rows
    let mut rows: Vec<Vec<Expr<'g>>> = pulled.into_iter().map(|row| free(model, row)).collect();
    let of_dependents = rows.split_off(model.independent());
    for (dependent, row) in model.loops.dependents.iter().zip(of_dependents) {
        for (sums, &slope) in rows.iter_mut().zip(&dependent.slopes) {
            for (sum, &entry) in sums.iter_mut().zip(&row) {
                *sum += slope * entry;
            }
        }
    }
    rows
}

/// Dot product with the rates.
fn times_rates<'g>(model: &Model<'g>, row: &[Expr<'g>]) -> Expr<'g> {
    let products: Vec<Expr<'g>> = row.iter().zip(&model.coordinates).map(|(&a, c)| a * c.rate).collect();
    model.graph.sum(products)
}

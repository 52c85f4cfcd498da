//! Dynamics of a model: from screws to the mass matrix, the bias, the forces and the energy in its coordinates.

mod actions;
mod articulated;
mod articulated_inertia;
mod articulated_tangent;
#[cfg(test)]
mod base;
mod canonical;
mod coefficients;
mod flight;
mod frames;
mod jacobian;
mod joint;
mod joints;
mod kinematics;
mod links;
mod loops;
mod motion;
mod recursive;
mod solve;
mod tangent;

pub(crate) use articulated::Articulation;
pub(crate) use articulated_tangent::ArticulatedTangent;
#[cfg(test)]
pub(crate) use base::base_parameters;
pub(crate) use canonical::{momentum_partials, momentum_rates};
pub(crate) use coefficients::Coefficients;
pub(crate) use jacobian::{derived, partials, partials_by_recursion};
pub(crate) use kinematics::Kinematics;
pub(crate) use loops::loop_wrenches;
pub(crate) use solve::{Factored, Inverse, Solver};

use crate::expr::Expr;
use crate::model::{Action, BodyId, Coordinate, Floating, Model};
use joint::JointId;
use joints::AlongJoints;

/// Equations of motion `A qdd + bias = force`, in the coordinates of the scene.
#[derive(Clone, Debug)]
pub(crate) struct Dynamics<'g> {
    /// Equations from which the accelerations are solved.
    pub balance: Balance<'g>,
    /// Terms of the equations, the momenta and the energies.
    pub lagrangian: Lagrangian<'g>,
    /// Forces supplied by drives and closed loops.
    pub reactions: Reactions<'g>,
}

/// Equations `A qdd + residual = 0`.
#[derive(Clone, Debug)]
pub(crate) struct Balance<'g> {
    /// Mass matrix; symmetric.
    pub mass_matrix: Vec<Vec<Expr<'g>>>,
    /// Bias less the forces.
    pub residual: Vec<Expr<'g>>,
    /// `A qdd + residual`, zero along the motion, with the accelerations as the symbols of the coordinates.
    pub rows: Vec<Expr<'g>>,
    /// Derivatives of `rows`, if they are known in a form of their own.
    pub tangent: Option<Tangent<'g>>,
}

/// Terms of Lagrange's equations.
#[derive(Clone, Debug)]
pub(crate) struct Lagrangian<'g> {
    /// Velocity terms and gravity.
    pub bias: Vec<Expr<'g>>,
    /// Forces of the joints.
    pub force: Vec<Expr<'g>>,
    /// Momenta of the coordinates: `A qd`, the derivatives of the kinetic energy with respect to the rates.
    pub momentum: Vec<Expr<'g>>,
    /// Kinetic energy.
    pub kinetic: Expr<'g>,
    /// Potential energy.
    pub potential: Expr<'g>,
}

/// Forces supplied by joints, for accelerations as the symbols of the coordinates.
#[derive(Clone, Debug)]
pub(crate) struct Reactions<'g> {
    /// Forces of the drives along their joints.
    pub drive: Vec<Expr<'g>>,
    /// Forces of closed loops along the dependent coordinates; empty unless requested.
    pub held: Vec<Expr<'g>>,
}

/// Derivatives of `A qdd + bias - force` (rows) at fixed accelerations, which are the symbols of the coordinates.
#[derive(Clone, Debug)]
pub(crate) struct Tangent<'g> {
    /// Derivatives of `A qdd + bias` with respect to the coordinates.
    pub by_position: Vec<Vec<Expr<'g>>>,
    /// Derivatives of `A qdd + bias` with respect to the rates.
    pub by_rate: Vec<Vec<Expr<'g>>>,
    /// Forces, whose derivatives are taken as expressions.
    pub force: Vec<Expr<'g>>,
}

/// A collection of expressions in a fixed order.
pub(crate) trait Entries<'g>: Clone {
    /// References to the expressions, in order.
    fn places(&mut self) -> Vec<&mut Expr<'g>>;

    /// All expressions in one list, in order.
    fn entries(&self) -> Vec<Expr<'g>> {
        self.clone().places().into_iter().map(|place| *place).collect()
    }

    /// Replaces the expressions, in the order of [`Entries::entries`].
    #[must_use]
    fn with_entries(mut self, entries: Vec<Expr<'g>>) -> Self {
        for (place, entry) in self.places().into_iter().zip(entries) {
            *place = entry;
        }
        self
    }
}

impl<'g> Entries<'g> for Balance<'g> {
    fn places(&mut self) -> Vec<&mut Expr<'g>> {
        let tangent = self.tangent.iter_mut().flat_map(|tangent| {
            let matrices = tangent.by_position.iter_mut().chain(&mut tangent.by_rate);
            matrices.chain([&mut tangent.force])
        });
        let rows = self.mass_matrix.iter_mut().chain([&mut self.residual, &mut self.rows]);
        rows.chain(tangent).flatten().collect()
    }
}

impl<'g> Entries<'g> for Lagrangian<'g> {
    fn places(&mut self) -> Vec<&mut Expr<'g>> {
        let lists = [&mut self.bias, &mut self.force, &mut self.momentum]
            .into_iter()
            .flatten();
        lists.chain([&mut self.kinetic, &mut self.potential]).collect()
    }
}

impl<'g> Entries<'g> for Reactions<'g> {
    fn places(&mut self) -> Vec<&mut Expr<'g>> {
        self.drive.iter_mut().chain(&mut self.held).collect()
    }
}

impl<'g> Entries<'g> for Dynamics<'g> {
    fn places(&mut self) -> Vec<&mut Expr<'g>> {
        let parts = [self.balance.places(), self.lagrangian.places(), self.reactions.places()];
        parts.into_iter().flatten().collect()
    }
}

impl<'g> Balance<'g> {
    /// Writes out `A qdd + residual`.
    pub(crate) fn new(
        coordinates: &[Coordinate<'g>],
        mass_matrix: Vec<Vec<Expr<'g>>>,
        residual: Vec<Expr<'g>>,
    ) -> Self {
        let row = |(row, &residual): (&Vec<Expr<'g>>, &Expr<'g>)| {
            let terms = row.iter().zip(coordinates);
            terms.fold(residual, |sum, (&entry, coordinate)| {
                sum + entry * coordinate.acceleration
            })
        };
        Self {
            rows: mass_matrix.iter().zip(&residual).map(row).collect(),
            mass_matrix,
            residual,
            tangent: None,
        }
    }

    /// Upper triangle of the mass matrix, row by row.
    pub(crate) fn upper_triangle(&self) -> Vec<Expr<'g>> {
        let rows = self.mass_matrix.iter().enumerate();
        rows.flat_map(|(k, row)| row[k..].iter().copied()).collect()
    }
}

impl<'g> Dynamics<'g> {
    /// Computes the dynamics of a model from A, B and C (Williams 2023, Sec. 2): the definition to which other forms
    /// are proved equal.
    pub(crate) fn new(model: &Model<'g>) -> Self {
        let mut kinematics = Kinematics::new(model);
        let of_joints = || model.graph.sum(model.bodies.iter().map(|body| body.potential));
        let of_actions = || model.graph.sum(model.actions.iter().filter_map(Action::potential));
        if model.has_orientations() {
            // B requires rates of coordinates, which angular velocities are not
            let potential = kinematics.potential() + of_joints() + of_actions();
            return Self::recursive(model, potential, false);
        }
        let Coefficients { a, b, c } = Coefficients::new(model, &mut kinematics);
        let (g, bodies) = (model.graph, &model.bodies);
        let rates: Vec<Expr<'g>> = bodies.iter().map(|body| model.rate_of(&body.motion)).collect();
        let mut bias = vec![g.zero(); bodies.len()];
        for (i, entry) in c {
            bias[i] = entry;
        }
        for ((i, j, k), entry) in b {
            let times = if j == k { 1 } else { 2 };
            bias[i] += entry * (times * (rates[j] * rates[k]));
        }
        let momenta = (!model.drives.is_empty() || !model.dependents.is_empty()).then(|| {
            let driven: Vec<Expr<'g>> = bodies
                .iter()
                .map(|body| model.driven_acceleration_of(&body.motion))
                .collect();
            let mut momenta = vec![g.zero(); bodies.len()];
            for (&(i, j), &entry) in &a {
                let off_diagonal = (i != j).then_some((j, i));
                for (row, column) in off_diagonal.into_iter().chain([(i, j)]) {
                    bias[row] += entry * driven[column];
                    momenta[row] += entry * rates[column];
                }
            }
            momenta
        });
        let of_gravity = kinematics.potential();
        let potential = of_gravity + of_joints() + of_actions();
        let joint = |body: BodyId| JointId::new(body.into());
        let along = AlongJoints {
            motions: bodies.iter().map(|body| body.motion.clone()).collect(),
            mass_matrix: a
                .into_iter()
                .map(|((i, j), entry)| (joint(i), joint(j), entry))
                .collect(),
            bias,
            momenta,
            inertial: None,
            tangent: None,
            pushed: None,
            floating: Vec::new(),
        };
        along.in_coordinates(model, potential)
    }

    /// Computes the dynamics by recursion over links in base parameters; `potential` is the potential energy. If
    /// `pushed` is set, forces at points act as wrenches on the links.
    pub(crate) fn recursive(model: &Model<'g>, potential: Expr<'g>, pushed: bool) -> Self {
        // off the unit sphere of a quaternion all equations must use the same matrix and the same bias
        let by_recursion = !model.has_orientations();
        recursive::along_joints(model, pushed, &[], by_recursion).in_coordinates(model, potential)
    }

    /// Computes the equations of the accelerations, along their own axes for `floating` bodies. If `pushed` is set,
    /// forces at points act as wrenches on the links.
    pub(crate) fn along_bodies(model: &Model<'g>, pushed: bool, floating: &[Floating<'g>]) -> Balance<'g> {
        let along = recursive::along_joints(model, pushed, floating, false);
        along.in_coordinates(model, model.graph.zero()).balance
    }

    /// Computes the equations of [`articulated`] bodies: zero at their accelerations for quaternions of any length.
    pub(crate) fn balance_of_links(model: &Model<'g>, pushed: bool, floating: &[Floating<'g>]) -> Balance<'g> {
        let along = recursive::along_joints(model, pushed, floating, true);
        along.in_coordinates(model, model.graph.zero()).balance
    }

    /// Forces of actions along the coordinates, except for actions declared along a coordinate.
    pub(crate) fn scene_forces(model: &Model<'g>) -> Vec<Expr<'g>> {
        let actions = model
            .actions
            .iter()
            .filter(|action| !matches!(action, Action::Along(..)));
        let mut forces = joints::free(model, actions::along_coordinates(model, &actions.collect::<Vec<_>>()));
        forces.truncate(model.dof());
        model.with_drives(&forces)
    }

    /// True if some action is equivalent to wrenches on links.
    pub(crate) fn has_wrenches(model: &Model<'g>) -> bool {
        model.actions.iter().any(actions::is_wrench)
    }

    /// Replaces the symbols of the drives by their prescribed motion.
    fn with_drives(self, model: &Model<'g>) -> Self {
        if model.drives.is_empty() {
            return self;
        }
        let entries = model.with_drives(&self.entries());
        self.with_entries(entries)
    }
}

/// Computes the accelerations by the articulated-body algorithm, without a mass matrix. Returns them with the
/// articulation they follow from. The accelerations of `floating` bodies are along their own axes. If `pushed` is set,
/// forces at points act as wrenches on the links.
pub(crate) fn articulated<'g>(
    model: &Model<'g>,
    pushed: bool,
    floating: &[Floating<'g>],
) -> (Vec<Expr<'g>>, Articulation<'g>) {
    let (accelerations, articulation) = articulated::accelerations(model, pushed, floating);
    (model.with_drives(&accelerations), articulation)
}

//! The dynamics of a model: from screws to the mass matrix, the bias, the forces and the energy in its coordinates.

mod coefficients;
mod jacobian;
mod kinematics;
mod solve;

pub use coefficients::Coefficients;
pub use jacobian::partials;
pub use kinematics::Kinematics;
pub use solve::{Factored, Solver};

use crate::expr::{ExprId, ratio};
use crate::model::{Model, combine};
use crate::screw::sum;

/// `mass_matrix * qdd + bias = force`, in the coordinates of the scene.
#[derive(Clone, Debug)]
pub struct Dynamics {
    /// The mass matrix; symmetric.
    pub mass_matrix: Vec<Vec<ExprId>>,
    /// Velocity terms and gravity.
    pub bias: Vec<ExprId>,
    /// Forces of the joints.
    pub force: Vec<ExprId>,
    /// The bias less the forces.
    pub residual: Vec<ExprId>,
    /// Kinetic energy.
    pub kinetic: ExprId,
    /// Potential energy of gravity and springs.
    pub potential: ExprId,
}

impl Dynamics {
    /// The dynamics of a model, from A, B and C pulled back to its coordinates (Williams 2023, Sec. 2).
    pub fn new(model: &mut Model) -> Self {
        let mut kinematics = Kinematics::new(model);
        let coefficients = Coefficients::new(model, &mut kinematics);
        let n = model.dof();
        let zero = model.graph.zero();
        let mut dynamics = Self {
            mass_matrix: vec![vec![zero; n]; n],
            bias: vec![zero; n],
            force: vec![zero; n],
            residual: vec![zero; n],
            kinetic: zero,
            potential: kinematics.potential(&mut model.graph),
        };
        dynamics.pull_back(model, &coefficients);
        dynamics.energy(model);
        dynamics
    }

    /// With `q = T theta` the mass matrix becomes `T^T A T`, and a generalised force `T^T tau`.
    fn pull_back(&mut self, model: &mut Model, coefficients: &Coefficients) {
        let Model {
            graph: g,
            bodies,
            coordinates,
            ..
        } = model;
        for (&(i, j), &entry) in &coefficients.a {
            for &(k, t) in &bodies[i].motion {
                for &(l, u) in &bodies[j].motion {
                    let factor = g.integer(t * u);
                    let term = g.mul(factor, entry);
                    let sides: &[(usize, usize)] = if i == j { &[(k, l)] } else { &[(k, l), (l, k)] };
                    for &(k, l) in sides {
                        self.mass_matrix[k][l] = g.add(self.mass_matrix[k][l], term);
                    }
                }
            }
        }
        let rates: Vec<ExprId> = bodies
            .iter()
            .map(|b| combine(g, coordinates, &b.motion, |c| c.rate))
            .collect();
        let mut along_joints: Vec<ExprId> = (0..bodies.len())
            .map(|i| coefficients.c.get(&i).copied().unwrap_or(g.zero()))
            .collect();
        for (&(i, j, k), &entry) in &coefficients.b {
            let factor = g.integer(if j == k { 1 } else { 2 });
            let rates = g.mul(rates[j], rates[k]);
            let rates = g.mul(factor, rates);
            let term = g.mul(entry, rates);
            along_joints[i] = g.add(along_joints[i], term);
        }
        for (body, along) in bodies.iter().zip(along_joints) {
            for &(k, t) in &body.motion {
                let factor = g.integer(t);
                let (bias, force) = (g.mul(factor, along), g.mul(factor, body.force));
                self.bias[k] = g.add(self.bias[k], bias);
                self.force[k] = g.add(self.force[k], force);
            }
        }
        for (k, residual) in self.residual.iter_mut().enumerate() {
            *residual = g.sub(self.bias[k], self.force[k]);
        }
    }

    fn energy(&mut self, model: &mut Model) {
        let Model {
            graph: g,
            bodies,
            coordinates,
            ..
        } = model;
        let mut products = Vec::new();
        for (row, a) in self.mass_matrix.iter().zip(coordinates.iter()) {
            for (&entry, b) in row.iter().zip(coordinates.iter()) {
                let rates = g.mul(a.rate, b.rate);
                products.push(g.mul(entry, rates));
            }
        }
        let twice = sum(g, products);
        let half = g.number(ratio(1, 2));
        self.kinetic = g.mul(half, twice);
        let joints = sum(g, bodies.iter().map(|b| b.potential).collect::<Vec<_>>());
        self.potential = g.add(self.potential, joints);
    }
}

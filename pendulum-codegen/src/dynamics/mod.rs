//! The dynamics of a model: from screws to the mass matrix, the bias, the forces and the energy in its coordinates.

mod coefficients;
mod jacobian;
mod kinematics;
mod links;
mod recursive;
mod solve;

pub use coefficients::Coefficients;
pub use jacobian::partials;
pub use kinematics::Kinematics;
pub use solve::{Factored, Solver};

use crate::expr::{ExprId, Graph, ratio};
use crate::model::{Combination, Coordinate, Model, combine};
use crate::screw::sum;
use recursive::Recursive;

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
    /// `A qdd + bias - force`, zero along the motion, with the accelerations as the symbols of the coordinates.
    pub balance: Vec<ExprId>,
    /// Kinetic energy.
    pub kinetic: ExprId,
    /// Potential energy of gravity and springs.
    pub potential: ExprId,
}

impl Dynamics {
    /// The dynamics of a model from A, B and C (Williams 2023, Sec. 2): the definition that other forms are proved equal to.
    pub fn new(model: &mut Model) -> Self {
        let mut kinematics = Kinematics::new(model);
        let coefficients = Coefficients::new(model, &mut kinematics);
        let Model {
            graph: g,
            bodies,
            coordinates,
            ..
        } = model;
        let rates: Vec<ExprId> = bodies
            .iter()
            .map(|b| combine(g, coordinates, &b.motion, |c| c.rate))
            .collect();
        let mut along: Vec<ExprId> = vec![g.zero(); bodies.len()];
        for (&i, &entry) in &coefficients.c {
            along[i] = entry;
        }
        for (&(i, j, k), &entry) in &coefficients.b {
            let factor = g.integer(if j == k { 1 } else { 2 });
            let rates = g.mul(rates[j], rates[k]);
            let rates = g.mul(factor, rates);
            let term = g.mul(entry, rates);
            along[i] = g.add(along[i], term);
        }
        let motions: Vec<Combination> = bodies.iter().map(|body| body.motion.clone()).collect();
        let entries: Vec<_> = coefficients.a.iter().map(|(&(i, j), &entry)| (i, j, entry)).collect();
        let of_gravity = kinematics.potential(g);
        let of_joints = sum(g, bodies.iter().map(|b| b.potential).collect::<Vec<_>>());
        let potential = g.add(of_gravity, of_joints);
        Self::assemble(model, &motions, &entries, &along, None, potential)
    }

    /// The same dynamics by recursion over links in base parameters; `potential` is the potential energy of gravity and springs.
    pub fn recursive(model: &mut Model, potential: ExprId) -> Self {
        let Recursive {
            links,
            mass_matrix,
            bias,
            inertial,
        } = Recursive::new(model);
        let motions: Vec<Combination> = links.iter().map(|link| link.motion.clone()).collect();
        Self::assemble(model, &motions, &mass_matrix, &bias, Some(&inertial), potential)
    }

    /// The dynamics in the coordinates of the scene, from entries `(i, j, A_ij)` with `i <= j` and the bias along joints whose
    /// coordinates are `q_i = motions[i]`. With `q = T theta` the mass matrix becomes `T^T A T`, a force `T^T tau`. `inertial` is
    /// `A qdd + bias` along the joints, where a form of it is known that is shorter than the two written out.
    fn assemble(
        model: &mut Model,
        motions: &[Combination],
        entries: &[(usize, usize, ExprId)],
        bias: &[ExprId],
        inertial: Option<&[ExprId]>,
        potential: ExprId,
    ) -> Self {
        let Model {
            graph: g,
            bodies,
            coordinates,
            ..
        } = model;
        let (n, zero) = (coordinates.len(), g.zero());
        let mut mass_matrix = vec![vec![zero; n]; n];
        for &(i, j, entry) in entries {
            for &(k, t) in &motions[i] {
                for &(l, u) in &motions[j] {
                    let factor = g.integer(t * u);
                    let term = g.mul(factor, entry);
                    let sides: &[(usize, usize)] = if i == j { &[(k, l)] } else { &[(k, l), (l, k)] };
                    for &(k, l) in sides {
                        mass_matrix[k][l] = g.add(mass_matrix[k][l], term);
                    }
                }
            }
        }
        let forces = bodies.iter().map(|body| (&body.motion, body.force));
        let force = pull_back(g, n, forces);
        let bias = pull_back(g, n, motions.iter().zip(bias.iter().copied()));
        let less_forces = |g: &mut Graph, list: &[ExprId]| -> Vec<ExprId> {
            list.iter().zip(&force).map(|(&x, &force)| g.sub(x, force)).collect()
        };
        let residual = less_forces(g, &bias);
        let balance = match inertial {
            Some(inertial) => {
                let inertial = pull_back(g, n, motions.iter().zip(inertial.iter().copied()));
                less_forces(g, &inertial)
            }
            None => balance(g, &mass_matrix, &residual, coordinates),
        };
        let kinetic = kinetic(g, &mass_matrix, coordinates);
        Self {
            mass_matrix,
            bias,
            force,
            residual,
            balance,
            kinetic,
            potential,
        }
    }

    /// Every expression of the dynamics, in one list.
    pub fn entries(&self) -> Vec<ExprId> {
        let lists = [&self.bias, &self.force, &self.residual, &self.balance];
        let rows = self.mass_matrix.iter().chain(lists);
        rows.flatten().copied().chain([self.kinetic, self.potential]).collect()
    }

    /// The same dynamics with other expressions, in the order of [`Dynamics::entries`].
    #[must_use]
    pub fn with_entries(mut self, entries: Vec<ExprId>) -> Self {
        let lists = [&mut self.bias, &mut self.force, &mut self.residual, &mut self.balance];
        let places = self.mass_matrix.iter_mut().chain(lists).flatten();
        for (place, entry) in places.chain([&mut self.kinetic, &mut self.potential]).zip(entries) {
            *place = entry;
        }
        self
    }
}

/// `A qdd + residual`, written out.
pub(crate) fn balance(
    g: &mut Graph,
    mass_matrix: &[Vec<ExprId>],
    residual: &[ExprId],
    coordinates: &[Coordinate],
) -> Vec<ExprId> {
    let rows = mass_matrix.iter().zip(residual);
    rows.map(|(row, &residual)| {
        row.iter().zip(coordinates).fold(residual, |sum, (&entry, coordinate)| {
            let term = g.mul(entry, coordinate.acceleration);
            g.add(sum, term)
        })
    })
    .collect()
}

/// `T^T tau`
fn pull_back<'a>(
    g: &mut Graph,
    n: usize,
    along_joints: impl Iterator<Item = (&'a Combination, ExprId)>,
) -> Vec<ExprId> {
    let mut pulled = vec![g.zero(); n];
    for (motion, along) in along_joints {
        for &(k, t) in motion {
            let factor = g.integer(t);
            let term = g.mul(factor, along);
            pulled[k] = g.add(pulled[k], term);
        }
    }
    pulled
}

/// Half of `qd^T A qd`.
fn kinetic(g: &mut Graph, mass_matrix: &[Vec<ExprId>], coordinates: &[Coordinate]) -> ExprId {
    let mut twice = g.zero();
    for (row, a) in mass_matrix.iter().zip(coordinates) {
        for (&entry, b) in row.iter().zip(coordinates) {
            let rates = g.mul(a.rate, b.rate);
            let term = g.mul(entry, rates);
            twice = g.add(twice, term);
        }
    }
    let half = g.number(ratio(1, 2));
    g.mul(half, twice)
}

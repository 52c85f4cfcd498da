//! The dynamics of a model: from screws to the mass matrix, the bias, the forces and the energy in its coordinates.

mod articulated;
mod base;
mod canonical;
mod coefficients;
mod frames;
mod jacobian;
mod kinematics;
mod links;
mod recursive;
mod solve;
mod tangent;

pub use base::base_parameters;
pub use canonical::{momentum_partials, momentum_rates};
pub use coefficients::Coefficients;
pub use jacobian::{derived, partials, partials_by_recursion};
pub use kinematics::Kinematics;
pub use solve::{Factored, Solver};

use crate::expr::{ExprId, Graph, ratio};
use crate::model::{Combination, Coordinate, Model, combine};
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
    /// `A qdd + bias - force`, zero along the motion, with the accelerations as the symbols of the coordinates.
    pub balance: Vec<ExprId>,
    /// Derivatives of `A qdd + bias`, where they are known in a form of their own.
    pub tangent: Option<Tangent>,
    /// Momenta of the coordinates: `A qd`, the derivatives of the kinetic energy by the rates.
    pub momentum: Vec<ExprId>,
    /// Kinetic energy.
    pub kinetic: ExprId,
    /// Potential energy of gravity and springs.
    pub potential: ExprId,
}

/// Derivatives of `A qdd + bias` (rows) at fixed accelerations, which stand in them as the symbols of the coordinates.
#[derive(Clone, Debug)]
pub struct Tangent {
    /// By the coordinates.
    pub by_position: Vec<Vec<ExprId>>,
    /// By their rates.
    pub by_rate: Vec<Vec<ExprId>>,
}

/// An entry of a matrix over the joints: row, column and value.
type Entry = (usize, usize, ExprId);

/// The dynamics along joints whose coordinates are `q_i = motions[i]` in those of the scene.
#[derive(Debug)]
struct AlongJoints {
    motions: Vec<Combination>,
    /// `A_ij` for `i <= j`.
    mass_matrix: Vec<Entry>,
    bias: Vec<ExprId>,
    /// What is known in a form that is shorter than `A` and `bias` written out.
    inertial: Option<Inertial>,
}

/// What a recursion knows along the joints without a mass matrix.
#[derive(Debug)]
struct Inertial {
    /// `A qdd + bias`.
    forces: Vec<ExprId>,
    /// Its derivatives.
    tangent: tangent::Tangent,
    /// `A qd`.
    momenta: Vec<ExprId>,
}

impl Dynamics {
    /// The dynamics of a model from A, B and C (Williams 2023, Sec. 2): the definition that other forms are proved equal to.
    pub fn new(model: &Model) -> Self {
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
        let of_gravity = kinematics.potential(g);
        let of_joints = sum(g, bodies.iter().map(|b| b.potential).collect::<Vec<_>>());
        let potential = g.add(of_gravity, of_joints);
        let along = AlongJoints {
            motions: bodies.iter().map(|body| body.motion.clone()).collect(),
            mass_matrix: coefficients.a.iter().map(|(&(i, j), &entry)| (i, j, entry)).collect(),
            bias: along,
            inertial: None,
        };
        along.in_coordinates(model, potential)
    }

    /// The same dynamics by recursion over links in base parameters; `potential` is the potential energy of gravity and springs.
    pub fn recursive(model: &Model, potential: ExprId) -> Self {
        recursive::along_joints(model).in_coordinates(model, potential)
    }

    /// The accelerations by articulated bodies: without a mass matrix.
    pub fn articulated(model: &Model) -> Vec<ExprId> {
        articulated::accelerations(model)
    }

    /// Every expression of the dynamics, in one list.
    pub fn entries(&self) -> Vec<ExprId> {
        let mut copy = self.clone();
        copy.places().into_iter().map(|place| *place).collect()
    }

    /// The same dynamics with other expressions, in the order of [`Dynamics::entries`].
    #[must_use]
    pub fn with_entries(mut self, entries: Vec<ExprId>) -> Self {
        for (place, entry) in self.places().into_iter().zip(entries) {
            *place = entry;
        }
        self
    }

    fn places(&mut self) -> Vec<&mut ExprId> {
        let lists = [
            &mut self.bias,
            &mut self.force,
            &mut self.residual,
            &mut self.balance,
            &mut self.momentum,
        ];
        let tangent = self
            .tangent
            .iter_mut()
            .flat_map(|t| t.by_position.iter_mut().chain(&mut t.by_rate));
        let rows = self.mass_matrix.iter_mut().chain(lists).chain(tangent);
        rows.flatten().chain([&mut self.kinetic, &mut self.potential]).collect()
    }
}

impl AlongJoints {
    /// The dynamics in the coordinates of the scene. With `q = T theta` the mass matrix becomes `T^T A T`, a force `T^T tau`.
    fn in_coordinates(self, model: &Model, potential: ExprId) -> Dynamics {
        let Self {
            motions,
            mass_matrix,
            bias,
            inertial,
        } = self;
        let Model {
            graph: g,
            bodies,
            coordinates,
            ..
        } = model;
        let n = coordinates.len();
        let both = mass_matrix.iter().flat_map(|&(i, j, entry)| {
            let mirrored = (i != j).then_some((j, i, entry));
            std::iter::once((i, j, entry)).chain(mirrored)
        });
        let mass_matrix = pull_back_matrix(g, n, &motions, both);
        let forces = bodies.iter().map(|body| (&body.motion, body.force));
        let force = pull_back(g, n, forces);
        let bias = pull_back(g, n, motions.iter().zip(bias.iter().copied()));
        let less_forces = |g: &Graph, list: &[ExprId]| -> Vec<ExprId> {
            list.iter().zip(&force).map(|(&x, &force)| g.sub(x, force)).collect()
        };
        let residual = less_forces(g, &bias);
        let (balance, tangent, momentum) = match inertial {
            Some(Inertial {
                forces,
                tangent,
                momenta,
            }) => {
                let [forces, momenta] = [forces, momenta].map(|along| pull_back(g, n, motions.iter().zip(along)));
                let tangent = Tangent {
                    by_position: pull_back_matrix(g, n, &motions, tangent.by_position),
                    by_rate: pull_back_matrix(g, n, &motions, tangent.by_rate),
                };
                (less_forces(g, &forces), Some(tangent), momenta)
            }
            None => {
                let momentum = momentum(g, &mass_matrix, coordinates);
                (balance(g, &mass_matrix, &residual, coordinates), None, momentum)
            }
        };
        let kinetic = kinetic(g, &momentum, coordinates);
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

/// `A qdd + residual`, written out.
pub(crate) fn balance(
    g: &Graph,
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
fn pull_back<'a>(g: &Graph, n: usize, along_joints: impl Iterator<Item = (&'a Combination, ExprId)>) -> Vec<ExprId> {
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

/// `T^T M T`
fn pull_back_matrix(
    g: &Graph,
    n: usize,
    motions: &[Combination],
    entries: impl IntoIterator<Item = Entry>,
) -> Vec<Vec<ExprId>> {
    let mut pulled = vec![vec![g.zero(); n]; n];
    for (i, j, entry) in entries {
        for &(k, t) in &motions[i] {
            for &(l, u) in &motions[j] {
                let factor = g.integer(t * u);
                let term = g.mul(factor, entry);
                pulled[k][l] = g.add(pulled[k][l], term);
            }
        }
    }
    pulled
}

/// `A qd`
fn momentum(g: &Graph, mass_matrix: &[Vec<ExprId>], coordinates: &[Coordinate]) -> Vec<ExprId> {
    let row = |row: &Vec<ExprId>| {
        let terms: Vec<ExprId> = row.iter().zip(coordinates).map(|(&a, c)| g.mul(a, c.rate)).collect();
        sum(g, terms)
    };
    mass_matrix.iter().map(row).collect()
}

/// Half of `qd . momentum`.
fn kinetic(g: &Graph, momentum: &[ExprId], coordinates: &[Coordinate]) -> ExprId {
    let terms: Vec<ExprId> = momentum
        .iter()
        .zip(coordinates)
        .map(|(&p, c)| g.mul(p, c.rate))
        .collect();
    let (half, twice) = (g.number(ratio(1, 2)), sum(g, terms));
    g.mul(half, twice)
}

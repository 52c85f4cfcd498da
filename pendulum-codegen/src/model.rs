//! The typed scene: what a declaration means, without its text.

use std::collections::{BTreeSet, HashMap};

use crate::expr::{Definition, ExprId, Formula, Graph, Rational, ratio};
use crate::screw::{Mat3, SpatialInertia, Transform, Twist, Vec3};
use crate::units::Unit;

/// A scene.
#[derive(Debug)]
pub struct Model {
    /// The store of all its expressions.
    pub graph: Graph,
    /// Parameters.
    pub parameters: Vec<Parameter>,
    /// Inputs.
    pub inputs: Vec<Input>,
    /// Coordinates, in the order of their bodies in the text.
    pub coordinates: Vec<Coordinate>,
    /// The symbol of time.
    pub time: ExprId,
    /// Acceleration of gravity in the ground frame.
    pub gravity: Vec3,
    /// Each `let`, as it was written.
    pub lets: Vec<Definition>,
    /// Bodies, each behind the one that carries it.
    pub bodies: Vec<Body>,
    /// What the parameters must obey.
    pub rules: Vec<Rule>,
    /// What to generate, in the words of `generate`.
    pub outputs: BTreeSet<&'static str>,
}

/// A parameter: a number given when the model is built.
#[derive(Debug)]
pub struct Parameter {
    /// Name.
    pub name: String,
    /// Documentation.
    pub docs: Vec<String>,
    /// Unit.
    pub unit: Unit,
    /// Value where none is given.
    pub default: Option<f64>,
    /// Its symbol.
    pub symbol: ExprId,
}

/// An input: a number given at each evaluation.
#[derive(Debug)]
pub struct Input {
    /// Name.
    pub name: String,
    /// Documentation.
    pub docs: Vec<String>,
    /// Unit.
    pub unit: Unit,
    /// Its symbol.
    pub symbol: ExprId,
}

/// A coordinate and the symbols of its derivatives.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Name.
    pub name: String,
    /// The coordinate.
    pub position: ExprId,
    /// Its rate.
    pub rate: ExprId,
    /// Its second rate, where it is held fixed while other things vary.
    pub acceleration: ExprId,
}

/// A sum of coordinates with integer factors: pairs of coordinate and factor, sorted, without zeros.
pub type Combination = Vec<(usize, i64)>;

/// A rigid body and the joint that carries it.
#[derive(Debug)]
pub struct Body {
    /// Name.
    pub name: String,
    /// The body that carries it; none for ground.
    pub parent: Option<usize>,
    /// Where the joint frame sits in the parent's frame.
    pub placement: Transform,
    /// The joint's screw axis in the joint frame, normalised; none for a fixed joint.
    pub screw: Option<Twist>,
    /// The coordinate that this joint brings into the scene.
    pub coordinate: Option<usize>,
    /// The relative joint coordinate in terms of the scene's coordinates.
    pub motion: Combination,
    /// How the body is turned.
    pub heading: Heading,
    /// Inertia in the body frame.
    pub inertia: SpatialInertia,
    /// Force of the joint along its relative coordinate: friction, spring and torque.
    pub force: ExprId,
    /// The part of the force that is friction and spring.
    pub passive: ExprId,
    /// The rest of it, the torque, as it was written.
    pub torque: Option<Formula>,
    /// Potential energy of the joint.
    pub potential: ExprId,
}

/// The orientation of a body in its station: the rotation by `turn` about `axis`, behind the constant rotation `rest`.
///
/// A station is a frame in which a group of bodies turns about one axis only: the ground, or the body before the first
/// joint of the group. Parallel joints so become one rotation by a sum of angles.
#[derive(Clone, Debug)]
pub struct Heading {
    /// The body whose frame is the station; none for ground.
    pub station: Option<usize>,
    /// Unit vector of the axis in the station, unless nothing turns yet.
    pub axis: Option<Vec3>,
    /// The angle.
    pub turn: Combination,
    /// The orientation at angle zero.
    pub rest: Mat3,
}

/// A condition on parameters that `new` checks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rule {
    /// What is checked.
    pub value: ExprId,
    /// What it must be.
    pub requirement: Requirement,
    /// The parameter, or the expression of parameters, as text.
    pub name: String,
    /// The rule as a sentence: `the mass of `upper` must be positive`.
    pub text: String,
}

/// What a checked value must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Requirement {
    /// Above zero.
    Positive,
    /// Zero or above.
    NonNegative,
    /// Zero or above, up to rounding of a difference of numbers of this size.
    NonNegativeWithin(ExprId),
}

/// How much of a difference is rounding.
pub const ROUNDING: f64 = 1e-12;

impl Requirement {
    /// Whether a value obeys, where `scale` is the size that the rounding is measured by.
    pub fn allows(self, value: f64, scale: f64) -> bool {
        match self {
            Self::Positive => value > 0.0,
            Self::NonNegative => value >= 0.0,
            Self::NonNegativeWithin(_) => value >= -ROUNDING * scale,
        }
    }
}

impl Model {
    /// The number of degrees of freedom.
    pub fn dof(&self) -> usize {
        self.coordinates.len()
    }

    /// The coordinates, then their rates.
    pub fn state(&self) -> Vec<ExprId> {
        let rates = self.coordinates.iter().map(|c| c.rate);
        self.positions().into_iter().chain(rates).collect()
    }

    /// The coordinates.
    pub fn positions(&self) -> Vec<ExprId> {
        self.coordinates.iter().map(|c| c.position).collect()
    }

    /// How the positions change: the kinematic half of the right-hand side.
    pub fn kinematics(&self) -> Vec<ExprId> {
        self.coordinates.iter().map(|c| c.rate).collect()
    }

    /// The symbols of the inputs.
    pub fn input_symbols(&self) -> Vec<ExprId> {
        self.inputs.iter().map(|input| input.symbol).collect()
    }

    /// The names of the coordinates.
    pub fn coordinate_names(&self) -> Vec<&str> {
        self.coordinates
            .iter()
            .map(|c| c.name.trim_start_matches("r#"))
            .collect()
    }

    /// What each turning coordinate is in base angles: the absolute angles of parallel joints within their station.
    pub fn base_angles(&self) -> HashMap<ExprId, Vec<(ExprId, Rational)>> {
        let mut angles = HashMap::new();
        for body in &self.bodies {
            let Some(own) = body.coordinate else { continue };
            let turn = &body.heading.turn;
            let Some(&(_, factor)) = turn.iter().find(|(k, _)| *k == own) else {
                continue;
            };
            // turn = factor * own + others, where the others are the turn of the parent, or none for an absolute coordinate
            let others: Combination = turn.iter().copied().filter(|(k, _)| *k != own).collect();
            let mut shares = Vec::new();
            for (combination, sign) in [(turn.clone(), factor), (others, -factor)] {
                let Some(&(_, leading)) = combination.first() else {
                    continue;
                };
                let positive = plus_scaled(&Vec::new(), &combination, leading.signum());
                let angle = combine(&self.graph, &self.coordinates, &positive, |c| c.position);
                shares.push((angle, ratio(sign * leading.signum(), 1)));
            }
            angles.insert(self.coordinates[own].position, shares);
        }
        angles
    }
}

/// The value of a combination, for example of positions or of rates.
pub fn combine(
    graph: &Graph,
    coordinates: &[Coordinate],
    combination: &Combination,
    part: impl Fn(&Coordinate) -> ExprId,
) -> ExprId {
    let mut sum = graph.zero();
    for &(k, factor) in combination {
        let factor = graph.integer(factor);
        let term = graph.mul(factor, part(&coordinates[k]));
        sum = graph.add(sum, term);
    }
    sum
}

/// `a + factor * b`, sorted and without zeros.
pub fn plus_scaled(a: &Combination, b: &Combination, factor: i64) -> Combination {
    let mut sum: std::collections::BTreeMap<usize, i64> = a.iter().copied().collect();
    for (k, f) in b {
        *sum.entry(*k).or_default() += factor * f;
    }
    sum.into_iter().filter(|(_, f)| *f != 0).collect()
}

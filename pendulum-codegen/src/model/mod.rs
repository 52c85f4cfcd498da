//! The typed scene: what a declaration means, without its text.

mod action;
mod closure;
mod combination;
mod constraint;
mod dependent;
mod drive;
mod figure;
mod floating;
mod index;
mod loops;
mod output;
mod point;
mod pose;

use std::collections::BTreeSet;
use std::ops::Deref;

use num_traits::{One, Signed, Zero};

pub(crate) use action::{Action, Place, Push};
pub(crate) use closure::{Closure, Row, Tie};
pub(crate) use combination::Combination;
pub(crate) use constraint::{Constraint, Law, MAX_CONSTRAINTS};
pub(crate) use dependent::Dependence;

pub(crate) use drive::Drive;
pub(crate) use figure::Figure;
pub use figure::FigureKind;
pub(crate) use floating::Floating;
pub(crate) use index::index_types;
pub(crate) use index::{BodyId, CoordinateId};
pub(crate) use loops::{Gap, Loops, Slopes, Uncounted};
pub(crate) use output::{Event, Output, OutputShape};
pub(crate) use point::{Point, along_motion};
pub(crate) use pose::{Poses, between};

use crate::expr::{BaseAngles, Definition, Derivative, Expr, Formula, Graph, Level, ratio};
use crate::screw::{Mat3, SpatialInertia, Transform, Twist, Vec3};
use crate::units::Unit;

/// Bodies that hang on each other, and what moves them: the loops of a scene are open.
#[derive(Debug)]
pub(crate) struct Tree<'g> {
    /// The store of all its expressions.
    pub graph: &'g Graph,
    /// Parameters.
    pub parameters: Vec<Parameter<'g>>,
    /// Inputs.
    pub inputs: Vec<Input<'g>>,
    /// Coordinates, in the order of their bodies in the text.
    pub coordinates: Vec<Coordinate<'g>>,
    /// Joints that are driven: their coordinates are numbered behind those of the state.
    pub drives: Vec<Drive<'g>>,
    /// Coordinates that depend on those before, behind which they are numbered: in a tree those that are declared, in
    /// a model the angles and lengths by which its loops are closed.
    pub dependents: Vec<Coordinate<'g>>,
    /// The joints that close loops.
    pub closures: Vec<Closure<'g>>,
    /// The symbol of time.
    pub time: Expr<'g>,
    /// Acceleration of gravity in the ground frame.
    pub gravity: Vec3<'g>,
    /// Bodies, each after the one that carries it.
    pub bodies: Vec<Body<'g>>,
    /// Points of bodies.
    pub points: Vec<Point<'g>>,
    /// What acts on the scene beside its joints.
    pub actions: Vec<Action<'g>>,
    /// What to generate, in the words of `generate`.
    pub generate: BTreeSet<&'static str>,
}

/// A scene: a tree whose loops are closed, and what is asked of it.
#[derive(Debug)]
pub(crate) struct Model<'g> {
    /// Name.
    pub name: String,
    /// Documentation, line by line.
    pub docs: Vec<String>,
    /// Each `let`, as it was written.
    pub lets: Vec<Definition>,
    /// Bodies, and what moves them.
    pub tree: Tree<'g>,
    /// What closed loops make of the coordinates that depend.
    pub loops: Loops<'g>,
    /// The constraints: joints in the order of their bodies, then walls.
    pub constraints: Vec<Constraint<'g>>,
    /// Quantities to evaluate.
    pub outputs: Vec<Output<'g>>,
    /// Functions whose zeros are events.
    pub events: Vec<Event<'g>>,
    /// What the parameters must obey.
    pub rules: Vec<Rule<'g>>,
}

/// A model is a tree, and more.
impl<'g> Deref for Model<'g> {
    type Target = Tree<'g>;

    fn deref(&self) -> &Tree<'g> {
        &self.tree
    }
}

/// A parameter: a number given when the model is built.
#[derive(Debug)]
pub(crate) struct Parameter<'g> {
    /// Name.
    pub name: String,
    /// Documentation.
    pub docs: Vec<String>,
    /// Unit.
    pub unit: Unit,
    /// Value where none is given.
    pub default: Option<f64>,
    /// Its symbol.
    pub symbol: Expr<'g>,
}

/// An input: a number given at each evaluation.
#[derive(Debug)]
pub(crate) struct Input<'g> {
    /// Name.
    pub name: String,
    /// Documentation.
    pub docs: Vec<String>,
    /// Unit.
    pub unit: Unit,
    /// Its symbol.
    pub symbol: Expr<'g>,
}

/// A coordinate and the symbols of its derivatives.
#[derive(Clone, Debug)]
pub(crate) struct Coordinate<'g> {
    /// Name.
    pub name: String,
    /// The coordinate; the number 0 for a component of the angular velocity of an
    /// [orientation](Self::is_of_orientation).
    pub position: Expr<'g>,
    /// The components of the state that a unit of its rate changes, and how fast: a column of `K` in `q' = K(q) v`.
    pub changes: Vec<(Expr<'g>, Expr<'g>)>,
    /// Its rate.
    pub rate: Expr<'g>,
    /// Its second rate, where it is held fixed while other things vary.
    pub acceleration: Expr<'g>,
}

impl<'g> Coordinate<'g> {
    /// A coordinate whose position is one component of the state.
    pub(crate) fn plain(name: String, [position, rate, acceleration]: [Expr<'g>; 3]) -> Self {
        Self {
            name,
            position,
            changes: vec![(position, position.graph().one())],
            rate,
            acceleration,
        }
    }

    /// The component of the angular velocity of a body along one of its axes, for the unit quaternion from body to
    /// parent, `q' = q (0, w) / 2`. It is the rate of no coordinate, but its screw is that of a joint that turns.
    pub(crate) fn turn(
        name: String,
        quaternion: [Expr<'g>; 4],
        axis: usize,
        [rate, acceleration]: [Expr<'g>; 2],
    ) -> Self {
        let changes = by_turn(quaternion, axis).map(|x| ratio(1, 2) * x);
        Self {
            name,
            position: rate.graph().zero(),
            changes: quaternion.into_iter().zip(changes).collect(),
            rate,
            acceleration,
        }
    }

    /// Whether it is a component of the angular velocity of an orientation.
    pub(crate) fn is_of_orientation(&self) -> bool {
        self.changes.len() > 1
    }

    /// The derivative by the coordinate: where it is one of an angular velocity, that by a turn about its axis.
    pub(crate) fn derivative(&self) -> Derivative<'g> {
        Derivative::along(self.changes.iter().copied())
    }
}

/// `q (0, e)` for the unit vector `e` of an axis.
fn by_turn<'g>([w, x, y, z]: [Expr<'g>; 4], axis: usize) -> [Expr<'g>; 4] {
    match axis {
        0 => [-x, w, z, -y],
        1 => [-y, -z, w, x],
        _ => [-z, y, -x, w],
    }
}

/// The constants that a model has beside the places of its coordinates.
pub(crate) const FACTS: [&str; 8] = [
    "DOF",
    "COORDINATES",
    "COST",
    "LAYOUT",
    "EQUATIONS",
    "OUTPUTS",
    "EVENTS",
    "DRIVES",
];

/// The constants for the places of a coordinate and of its rate in the state: `THETA1` and `DOT_THETA1`, of `p.x` `P_X`
/// and `DOT_P_X`, and of an orientation the first of them.
pub(crate) fn places(coordinate: &str) -> [String; 2] {
    let name = coordinate.trim_start_matches("r#").replace('.', "_").to_uppercase();
    [name.clone(), format!("DOT_{name}")]
}

/// A rigid body and the joint that carries it.
#[derive(Debug)]
pub(crate) struct Body<'g> {
    /// Name.
    pub name: String,
    /// The body that carries it; none for ground.
    pub parent: Option<BodyId>,
    /// Where the joint frame sits in the parent's frame: constant, but for an orientation.
    pub placement: Transform<'g>,
    /// The joint's screw axis in the joint frame, normalised; none for a fixed joint.
    pub screw: Option<Twist<'g>>,
    /// Of the three joints of an orientation, in a row on bodies without mass, the angular velocity that each adds: all
    /// of it by the first, whose placement is turned by the quaternion, and none by the others.
    pub spin: Option<Vec3<'g>>,
    /// The coordinate that this joint brings into the scene; a driven one has one too.
    pub coordinate: Option<CoordinateId>,
    /// The relative joint coordinate in terms of the scene's coordinates.
    pub motion: Combination,
    /// How the body is turned.
    pub heading: Heading<'g>,
    /// Inertia in the body frame.
    pub inertia: SpatialInertia<'g>,
    /// How it looks.
    pub figures: Vec<Figure<'g>>,
    /// Force of the joint along its relative coordinate: friction, spring and torque, and whatever holds it.
    pub force: Expr<'g>,
    /// The part of the force that is friction and spring, and whatever holds the joint.
    pub passive: Expr<'g>,
    /// The rest of it, the torque, as it was written.
    pub torque: Option<Formula>,
    /// Potential energy of the joint.
    pub potential: Expr<'g>,
    /// Dry friction and stops of the joint.
    pub law: Option<Law<'g>>,
}

/// The orientation of a body in its station: the rotation by `turn` about `axis`, after the constant rotation `rest`.
///
/// A station is a frame in which a group of bodies turns about one axis only: the ground, or the body before the first
/// joint of the group. Parallel joints so become one rotation by a sum of angles.
#[derive(Clone, Debug)]
pub(crate) struct Heading<'g> {
    /// The body whose frame is the station; none for ground.
    pub station: Option<BodyId>,
    /// Unit vector of the axis in the station, unless nothing turns yet.
    pub axis: Option<Vec3<'g>>,
    /// The angle.
    pub turn: Combination,
    /// The orientation at angle zero: constant, but for an orientation by a quaternion.
    pub rest: Mat3<'g>,
}

impl Heading<'_> {
    /// Whether a quaternion turns it.
    pub(crate) fn turns_freely(&self) -> bool {
        let entries = self.rest.0.iter().flat_map(|row| row.0);
        entries.into_iter().any(|entry| entry.level() == Level::State)
    }
}

/// A condition on parameters that `new` checks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Rule<'g> {
    /// What is checked.
    pub value: Expr<'g>,
    /// What it must be.
    pub requirement: Requirement<'g>,
    /// The parameter, or the expression of parameters, as text.
    pub name: String,
    /// The rule as a sentence: `the mass of `upper` must be positive`.
    pub text: String,
}

/// What a checked value must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Requirement<'g> {
    /// Above zero.
    Positive,
    /// Zero or above.
    NonNegative,
    /// Zero or above, up to rounding of a difference of numbers of this size.
    NonNegativeWithin(Expr<'g>),
}

/// How much of a difference is rounding.
pub(crate) const ROUNDING: f64 = 1e-12;

impl<'g> Requirement<'g> {
    /// The number by whose size the rounding is measured.
    pub(crate) fn scale(self) -> Option<Expr<'g>> {
        match self {
            Self::NonNegativeWithin(scale) => Some(scale),
            Self::Positive | Self::NonNegative => None,
        }
    }

    /// Whether a value obeys, where `scale` is the size that the rounding is measured by.
    pub(crate) fn allows(self, value: f64, scale: f64) -> bool {
        match self {
            Self::Positive => value > 0.0,
            Self::NonNegative => value >= 0.0,
            Self::NonNegativeWithin(_) => value >= -ROUNDING * scale,
        }
    }
}

/// The positions of coordinates, and how fast they change along a motion.
pub(crate) fn changes<'g, 'm>(coordinates: impl Iterator<Item = &'m Coordinate<'g>>) -> Vec<(Expr<'g>, Expr<'g>)>
where
    'g: 'm,
{
    let mut all: Vec<(Expr<'g>, Expr<'g>)> = Vec::new();
    for coordinate in coordinates {
        for &(position, factor) in &coordinate.changes {
            let change = factor * coordinate.rate;
            match all.iter_mut().find(|(known, _)| *known == position) {
                Some((_, sum)) => *sum += change,
                None => all.push((position, change)),
            }
        }
    }
    all
}

impl<'g> Tree<'g> {
    /// Whether joints follow others.
    pub(crate) fn has_followers(&self) -> bool {
        let follows = |body: &Body<'g>| body.coordinate.is_none() && body.motion != Combination::default();
        self.bodies.iter().any(follows)
    }

    /// The components of the quaternions in the state.
    pub(crate) fn quaternions(&self) -> Vec<[Expr<'g>; 4]> {
        let of = |c: &Coordinate<'g>| c.changes.iter().map(|&(component, _)| component).collect::<Vec<_>>();
        let mut all: Vec<[Expr<'g>; 4]> = self.coordinates.iter().filter_map(|c| of(c).try_into().ok()).collect();
        all.dedup();
        all
    }

    /// The number of degrees of freedom.
    pub(crate) fn dof(&self) -> usize {
        self.coordinates.len()
    }

    /// The bodies and their positions, each after the one that carries it.
    pub(crate) fn bodies(&self) -> impl DoubleEndedIterator<Item = (BodyId, &Body<'g>)> {
        BodyId::all(self.bodies.len()).zip(&self.bodies)
    }

    /// Whether it has orientations: then positions outnumber rates.
    pub(crate) fn has_orientations(&self) -> bool {
        self.coordinates.iter().any(Coordinate::is_of_orientation)
    }

    /// The symbols of the inputs.
    pub(crate) fn input_symbols(&self) -> Vec<Expr<'g>> {
        self.inputs.iter().map(|input| input.symbol).collect()
    }

    /// The value of a combination of coordinates.
    pub(crate) fn position_of(&self, combination: &Combination) -> Expr<'g> {
        combination.of(self.graph, |k| self.coordinate(k).position)
    }

    /// The rate of a combination of coordinates.
    pub(crate) fn rate_of(&self, combination: &Combination) -> Expr<'g> {
        combination.of(self.graph, |k| self.coordinate(k).rate)
    }

    /// The second rate of a combination of coordinates.
    pub(crate) fn acceleration_of(&self, combination: &Combination) -> Expr<'g> {
        combination.of(self.graph, |k| self.coordinate(k).acceleration)
    }

    /// The names of the coordinates.
    pub(crate) fn coordinate_names(&self) -> Vec<&str> {
        self.coordinates
            .iter()
            .map(|c| c.name.trim_start_matches("r#"))
            .collect()
    }

    /// What each turning coordinate is in base angles: the absolute angles of parallel joints within their station.
    pub(crate) fn base_angles(&self) -> BaseAngles<'g> {
        let mut angles = BaseAngles::default();
        for body in &self.bodies {
            let Some(own) = body.coordinate.filter(|&own| self.is_free(own)) else {
                continue;
            };
            let turn = body.heading.turn.filtered(|k| !self.is_driven(k));
            let factor = turn.factor(own);
            // a body below may follow the coordinate: then it is its own base
            if !factor.abs().is_one() {
                continue;
            }
            // turn = factor * own + others, where the others are the turn of the parent, or none for an absolute
            // coordinate
            let sign = turn.leading_sign();
            let mut shares = vec![(self.position_of(&turn.scaled(sign)), &factor * ratio(sign, 1))];
            for (k, n) in turn.without(own).terms() {
                let other = self.coordinate(k).position;
                let itself = [(other, ratio(1, 1))];
                for (base, share) in angles.get(&other).map_or(&itself[..], |shares| shares) {
                    let share = -&factor * n * share;
                    match shares.iter_mut().find(|(known, _)| known == base) {
                        Some((_, sum)) => *sum += share,
                        None => shares.push((*base, share)),
                    }
                }
            }
            shares.retain(|(_, share)| !share.is_zero());
            angles.insert(self.coordinates[own].position, shares);
        }
        angles
    }
}

impl<'g> Model<'g> {
    /// The coordinates, then their rates.
    pub(crate) fn state(&self) -> Vec<Expr<'g>> {
        let rates = self.coordinates.iter().map(|c| c.rate);
        self.positions().into_iter().chain(rates).collect()
    }

    /// The positions: of orientations the four components of their quaternions, of other coordinates themselves. Behind
    /// them those of dependent coordinates that are known by their rates alone.
    pub(crate) fn positions(&self) -> Vec<Expr<'g>> {
        self.changes().into_iter().map(|(x, _)| x).collect()
    }

    /// How the positions change: the kinematic part of the right-hand side.
    pub(crate) fn kinematics(&self) -> Vec<Expr<'g>> {
        self.changes().into_iter().map(|(_, rate)| rate).collect()
    }

    fn changes(&self) -> Vec<(Expr<'g>, Expr<'g>)> {
        changes(
            self.coordinates
                .iter()
                .chain(self.in_state().map(|(_, coordinate)| coordinate)),
        )
    }

    /// The dependent coordinates that are known by their rates alone, so that their positions are in the state.
    pub(crate) fn in_state(&self) -> impl Iterator<Item = (CoordinateId, &Coordinate<'g>)> {
        let numbered = (self.independent()..).map(CoordinateId::new).zip(&self.dependents);
        let in_state = numbered
            .zip(&self.loops.dependents)
            .filter(|(_, slopes)| slopes.in_state);
        in_state.map(|(coordinate, _)| coordinate)
    }

    /// Whether positions outnumber rates.
    pub(crate) fn has_more_positions(&self) -> bool {
        self.has_orientations() || self.in_state().next().is_some()
    }

    /// Every name of the declaration that can stand in an expression, without the marks of raw identifiers.
    pub(crate) fn names(&self) -> BTreeSet<String> {
        let parameters = self.parameters.iter().map(|p| &p.name);
        let inputs = self.inputs.iter().map(|i| &i.name);
        let coordinates = self.coordinates.iter().map(|c| &c.name);
        let names = parameters.chain(inputs).chain(coordinates);
        let names = names.chain(self.lets.iter().map(|l| &l.name));
        let names = names.chain(self.points.iter().map(|p| &p.name));
        names.map(|name| name.trim_start_matches("r#").to_owned()).collect()
    }
}

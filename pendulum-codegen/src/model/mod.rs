//! The typed scene: what a declaration means, without its text.

mod action;
mod body;
mod closure;
mod combination;
mod constants;
mod constraint;
mod coordinate;
mod dependent;
mod drive;
mod figure;
mod floating;
mod index;
mod loops;
mod output;
mod point;
mod pose;
mod rule;

use std::collections::BTreeSet;
use std::ops::Deref;

use num_traits::{One, Signed, Zero};

pub(crate) use action::{Action, Place, Push};
pub(crate) use body::{Body, Heading};
pub(crate) use closure::{Closure, Row, Tie};
pub(crate) use combination::Combination;
pub(crate) use constants::{FACTS, places};
pub(crate) use constraint::{Constraint, Law, MAX_CONSTRAINTS};
pub(crate) use coordinate::{Coordinate, changes};
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
pub(crate) use rule::{ROUNDING, Requirement, Rule};

use crate::expr::{BaseAngles, Definition, Expr, Graph, ratio};
use crate::screw::Vec3;
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
    /// What was repaired in the file of a robot.
    pub repaired: Vec<String>,
    /// The largest force and rate of each coordinate, where the file of a robot gives any.
    pub most: Vec<[f64; 2]>,
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

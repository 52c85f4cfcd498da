//! The typed scene: the meaning of a declaration, independent of its source text.

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
use rustc_hash::FxHashMap;

pub(crate) use action::{Action, Place, Push};
pub(crate) use body::{Body, Heading};
pub(crate) use closure::{Closure, Row, Tie};
pub(crate) use combination::Combination;
pub(crate) use constants::{FACTS, constant, places};
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

use crate::expr::{BaseAngles, Definition, Expr, ExprId, Graph, SymbolKind, ratio};
use crate::screw::Vec3;
use crate::units::Unit;

/// The bodies of a scene and everything that moves them, as a tree: its loops are cut open.
#[derive(Debug)]
pub(crate) struct Tree<'g> {
    /// Graph that stores all expressions of the scene.
    pub graph: &'g Graph,
    /// Parameters.
    pub parameters: Vec<Parameter<'g>>,
    /// Inputs.
    pub inputs: Vec<Input<'g>>,
    /// First-order states.
    pub states: Vec<State<'g>>,
    /// Coordinates of the state, in the order of their bodies in the source.
    pub coordinates: Vec<Coordinate<'g>>,
    /// Driven joints, whose coordinates are numbered after those of the state.
    pub drives: Vec<Drive<'g>>,
    /// Dependent coordinates, numbered after those of the state and of the drives: in a tree the declared ones, in a
    /// model the angles and lengths that close its loops.
    pub dependents: Vec<Coordinate<'g>>,
    /// Joints that close loops.
    pub closures: Vec<Closure<'g>>,
    /// Symbol of time.
    pub time: Expr<'g>,
    /// Acceleration of gravity in the ground frame.
    pub gravity: Vec3<'g>,
    /// Bodies, each after its parent.
    pub bodies: Vec<Body<'g>>,
    /// Points of bodies.
    pub points: Vec<Point<'g>>,
    /// Forces, potentials and dissipation other than those of the joints.
    pub actions: Vec<Action<'g>>,
    /// Routines to generate, as named in `generate`.
    pub generate: BTreeSet<&'static str>,
}

/// A tree with its loops closed, together with its constraints, outputs, events and rules.
#[derive(Debug)]
pub(crate) struct Model<'g> {
    /// Name.
    pub name: String,
    /// Documentation, line by line.
    pub docs: Vec<String>,
    /// Descriptions of the repairs made to the robot's URDF file.
    pub repaired: Vec<String>,
    /// Effort and velocity limit of each coordinate, infinite if unlimited; empty if no URDF file gives any.
    pub most: Vec<[f64; 2]>,
    /// Definition of each `let`, as written.
    pub lets: Vec<Definition>,
    /// Bodies and everything that moves them.
    pub tree: Tree<'g>,
    /// Solution of the closed loops: derivatives of the dependent coordinates, margins and residuals.
    pub loops: Loops<'g>,
    /// Constraints: joints in the order of their bodies, then walls.
    pub constraints: Vec<Constraint<'g>>,
    /// Quantities to evaluate.
    pub outputs: Vec<Output<'g>>,
    /// Events at the zeros of functions.
    pub events: Vec<Event<'g>>,
    /// Conditions that the parameters must satisfy.
    pub rules: Vec<Rule<'g>>,
}

/// Gives access to the fields and methods of the underlying tree.
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
    /// Default value, if there is one.
    pub default: Option<f64>,
    /// Symbol in expressions.
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
    /// Symbol in expressions.
    pub symbol: Expr<'g>,
}

/// A first-order state: a component of the state that is neither a coordinate nor the rate of one.
#[derive(Debug)]
pub(crate) struct State<'g> {
    /// Name.
    pub name: String,
    /// Documentation.
    pub docs: Vec<String>,
    /// Unit.
    pub unit: Unit,
    /// Symbol in expressions.
    pub symbol: Expr<'g>,
    /// Time derivative.
    pub rate: Expr<'g>,
}

impl Model<'_> {
    /// Names of the angles whose turns forces take, and are not counted.
    pub(crate) fn uncounted(&self) -> impl Iterator<Item = &str> {
        self.loops.uncounted.iter().map(|own| own.coordinate.name.as_str())
    }
}

impl<'g> Tree<'g> {
    /// True if any joint follows other joints.
    pub(crate) fn has_followers(&self) -> bool {
        let follows = |body: &Body<'g>| body.coordinate.is_none() && body.motion != Combination::default();
        self.bodies.iter().any(follows)
    }

    /// Components of each quaternion in the state.
    pub(crate) fn quaternions(&self) -> Vec<[Expr<'g>; 4]> {
        let of = |c: &Coordinate<'g>| c.changes.iter().map(|&(component, _)| component).collect::<Vec<_>>();
        let mut all: Vec<[Expr<'g>; 4]> = self.coordinates.iter().filter_map(|c| of(c).try_into().ok()).collect();
        all.dedup();
        all
    }

    /// Number of degrees of freedom.
    pub(crate) fn dof(&self) -> usize {
        self.coordinates.len()
    }

    /// Iterates over the bodies and their indices, each body after its parent.
    pub(crate) fn bodies(&self) -> impl DoubleEndedIterator<Item = (BodyId, &Body<'g>)> {
        BodyId::all(self.bodies.len()).zip(&self.bodies)
    }

    /// True if the state has orientations, so that positions outnumber rates.
    pub(crate) fn has_orientations(&self) -> bool {
        self.coordinates.iter().any(Coordinate::is_of_orientation)
    }

    /// Symbols of the inputs.
    pub(crate) fn input_symbols(&self) -> Vec<Expr<'g>> {
        self.inputs.iter().map(|input| input.symbol).collect()
    }

    /// Position of a combination of coordinates.
    pub(crate) fn position_of(&self, combination: &Combination) -> Expr<'g> {
        combination.of(self.graph, |k| self.coordinate(k).position)
    }

    /// Rate of a combination of coordinates.
    pub(crate) fn rate_of(&self, combination: &Combination) -> Expr<'g> {
        combination.of(self.graph, |k| self.coordinate(k).rate)
    }

    /// Acceleration of a combination of coordinates.
    pub(crate) fn acceleration_of(&self, combination: &Combination) -> Expr<'g> {
        combination.of(self.graph, |k| self.coordinate(k).acceleration)
    }

    /// New symbols `name[0]`, `name[1]`, ..
    pub(crate) fn symbols(&self, name: &str, count: usize, kind: fn(usize) -> SymbolKind) -> Vec<Expr<'g>> {
        let symbol = |n: usize| self.graph.symbol(&format!("{name}[{n}]"), kind(n));
        (0..count).map(symbol).collect()
    }

    /// Names of the coordinates.
    pub(crate) fn coordinate_names(&self) -> Vec<&str> {
        self.coordinates
            .iter()
            .map(|c| c.name.trim_start_matches("r#"))
            .collect()
    }

    /// Base angles of each coordinate of a turning joint, with their factors: the absolute angles of parallel joints
    /// within their station.
    pub(crate) fn base_angles(&self) -> BaseAngles<'g> {
        let mut angles = BaseAngles::default();
        for body in &self.bodies {
            let Some(own) = body.coordinate.filter(|&own| self.is_free(own)) else {
                continue;
            };
            let turn = body.heading.turn.filtered(|k| !self.is_driven(k));
            let factor = turn.factor(own);
            // the factor is not 1 or -1 if a body below follows the coordinate, which is then its own base
            if !factor.abs().is_one() {
                continue;
            }
            // turn = factor * own + others, where the others are the turn of the parent, or zero for an absolute
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
    /// State vector: positions, then rates, then first-order states.
    pub(crate) fn state(&self) -> Vec<Expr<'g>> {
        let rates = self.coordinates.iter().map(|c| c.rate);
        let states = self.states.iter().map(|state| state.symbol);
        self.positions().into_iter().chain(rates).chain(states).collect()
    }

    /// State in which loops are assembled for the default parameters, orientations equal their reference frames, and
    /// everything else is zero.
    pub(crate) fn start(&self) -> Vec<f64> {
        let scalars = self.quaternions().into_iter().map(|[scalar, ..]| (scalar.id(), 1.0));
        let mut known: FxHashMap<ExprId, f64> = scalars.collect();
        known.extend(&self.loops.assembled);
        let value = |x: &Expr<'g>| known.get(&x.id()).copied().unwrap_or(0.0);
        self.state().iter().map(value).collect()
    }

    /// Time derivatives of the first-order states.
    pub(crate) fn state_rates(&self) -> Vec<Expr<'g>> {
        let rates: Vec<Expr<'g>> = self.states.iter().map(|state| state.rate).collect();
        self.with_drives(&rates)
    }

    /// Positions: the four quaternion components of each orientation, the value of every other coordinate, then the
    /// dependent coordinates that are part of the state.
    pub(crate) fn positions(&self) -> Vec<Expr<'g>> {
        self.changes().into_iter().map(|(x, _)| x).collect()
    }

    /// Time derivatives of the positions: the kinematic part of the right-hand side.
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

    /// Dependent coordinates without a closed form: only their rates are known, so their positions are part of the
    /// state.
    pub(crate) fn in_state(&self) -> impl Iterator<Item = (CoordinateId, &Coordinate<'g>)> {
        let numbered = (self.independent()..).map(CoordinateId::new).zip(&self.dependents);
        let in_state = numbered
            .zip(&self.loops.dependents)
            .filter(|(_, slopes)| slopes.in_state);
        in_state.map(|(coordinate, _)| coordinate)
    }

    /// True if positions outnumber rates.
    pub(crate) fn has_more_positions(&self) -> bool {
        self.has_orientations() || self.in_state().next().is_some()
    }

    /// All declared names that can stand in an expression, without the `r#` of raw identifiers.
    pub(crate) fn names(&self) -> BTreeSet<String> {
        let parameters = self.parameters.iter().map(|p| &p.name);
        let inputs = self.inputs.iter().map(|i| &i.name);
        let inputs = inputs.chain(self.states.iter().map(|state| &state.name));
        let coordinates = self.coordinates.iter().map(|c| &c.name);
        let names = parameters.chain(inputs).chain(coordinates);
        let names = names.chain(self.lets.iter().map(|l| &l.name));
        let names = names.chain(self.points.iter().map(|p| &p.name));
        names.map(|name| name.trim_start_matches("r#").to_owned()).collect()
    }
}

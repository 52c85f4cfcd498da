//! What each part of the state is, and the symmetries of the right-hand side.

use std::ops::Range;

use num_traits::Zero;
use rustc_hash::FxHashMap;

use crate::expr::{Binary, Expr, ExprId, Graph, Node, Normalizer, Rational, Unary, ratio};
use crate::model::{CoordinateId, Model, places};
use crate::screw::Twist;

/// What each part of the state is.
#[derive(Clone, Debug, PartialEq)]
pub struct StateLayout {
    /// The coordinates, in the order in which they stand in the state.
    pub slots: Vec<Slot>,
    /// Whether the right-hand side is known not to depend on time.
    pub autonomous: bool,
}

/// A coordinate and its place in the state.
#[derive(Clone, Debug, PartialEq)]
pub struct Slot {
    /// Name.
    pub name: String,
    /// What it measures.
    pub kind: SlotKind,
    /// Where its position stands in the state.
    pub positions: Range<usize>,
    /// Where its rate stands in the state: nowhere, if it depends on those of others.
    pub rates: Range<usize>,
    /// The constants that hold the two places, for a coordinate of one component: `THETA1` and `DOT_THETA1`.
    pub constants: [String; 2],
    /// Whether a full turn is known to leave everything as it was.
    pub periodic: bool,
    /// Whether the right-hand side is known not to depend on the position.
    pub cyclic: bool,
}

/// What a coordinate measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlotKind {
    /// An angle.
    Angle,
    /// A length.
    Length,
    /// An orientation: a unit quaternion, and three components of the angular velocity.
    Quaternion,
}

impl SlotKind {
    /// The unit of positions.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Angle => "rad",
            Self::Length => "m",
            Self::Quaternion => "1",
        }
    }

    /// The unit of rates.
    pub fn rate_unit(self) -> &'static str {
        match self {
            Self::Angle | Self::Quaternion => "rad/s",
            Self::Length => "m/s",
        }
    }
}

impl StateLayout {
    /// The layout of the state of a model with these roots of its right-hand side.
    ///
    /// A law for inputs may depend on anything, so with inputs no symmetry is known.
    pub(super) fn new<'g>(model: &Model<'g>, roots: &[Expr<'g>]) -> Self {
        let g = model.graph;
        let nodes = g.reachable(roots);
        let occurs = |symbol: Expr<'g>| nodes.binary_search(&symbol.id()).is_ok();
        let controlled = !model.inputs.is_empty();
        let names = model.coordinate_names();
        let mut slots: Vec<Slot> = Vec::new();
        let mut position = 0;
        let first_rate = model.positions().len();
        let mut k = 0;
        while k < model.dof() {
            let (id, coordinate) = (CoordinateId::new(k), &model.coordinates[k]);
            let (name, kind, count) = if coordinate.is_of_orientation() {
                (names[k].trim_end_matches(".x"), SlotKind::Quaternion, 3)
            } else {
                (names[k], kind(model, id), 1)
            };
            let symbols = coordinate.changes.iter().map(|(symbol, _)| *symbol);
            let is_angle = |symbol| returns(model, id) && repeats(g, &nodes, roots, symbol);
            slots.push(Slot {
                name: name.to_owned(),
                kind,
                positions: position..position + symbols.len(),
                rates: first_rate + k..first_rate + k + count,
                constants: places(name),
                periodic: !controlled && kind != SlotKind::Quaternion && is_angle(coordinate.position),
                cyclic: !controlled && !symbols.clone().any(occurs),
            });
            (position, k) = (position + symbols.len(), k + count);
        }
        for (id, coordinate) in model.in_state() {
            let name = coordinate.name.trim_start_matches("r#");
            let (kind, symbol) = (kind(model, id), coordinate.position);
            slots.push(Slot {
                name: name.to_owned(),
                kind,
                positions: position..position + 1,
                rates: first_rate + k..first_rate + k,
                constants: places(name),
                periodic: !controlled && returns(model, id) && repeats(g, &nodes, roots, symbol),
                cyclic: !controlled && !occurs(symbol),
            });
            position += 1;
        }
        Self {
            slots,
            autonomous: !controlled && !occurs(model.time),
        }
    }
}

impl StateLayout {
    /// The number of components of the state.
    pub fn len(&self) -> usize {
        self.slots
            .iter()
            .map(|slot| slot.positions.len() + slot.rates.len())
            .sum()
    }

    /// Whether the state has no components.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The names of the components of the state that are positions, then those of the rates without the mark of a rate.
    pub fn components(&self) -> [Vec<String>; 2] {
        let names = |slot: &Slot, axes: &[&str]| match slot.kind {
            SlotKind::Quaternion => axes.iter().map(|axis| format!("{}.{axis}", slot.name)).collect(),
            _ => vec![slot.name.clone()],
        };
        let rated = self.slots.iter().filter(|slot| !slot.rates.is_empty());
        let positions = self.slots.iter().flat_map(|slot| names(slot, &["w", "x", "y", "z"]));
        let rates = rated.flat_map(|slot| names(slot, &["x", "y", "z"]));
        [positions.collect(), rates.collect()]
    }

    /// Where the quaternions stand in the state.
    pub fn quaternions(&self) -> impl Iterator<Item = Range<usize>> {
        let slots = self.slots.iter().filter(|slot| slot.kind == SlotKind::Quaternion);
        slots.map(|slot| slot.positions.clone())
    }

    /// Where the dependent coordinates stand in the state, which have no rates there.
    pub fn dependents(&self) -> impl Iterator<Item = usize> {
        let slots = self.slots.iter().filter(|slot| slot.rates.is_empty());
        slots.map(|slot| slot.positions.start)
    }

    /// The number of degrees of freedom: of rates.
    pub fn dof(&self) -> usize {
        self.slots.iter().map(|slot| slot.rates.len()).sum()
    }
}

/// An angle where the joint of the coordinate turns, with or without sliding.
fn kind(model: &Model<'_>, coordinate: CoordinateId) -> SlotKind {
    let own = model.bodies.iter().find(|body| body.coordinate == Some(coordinate));
    match own.and_then(|body| body.screw) {
        Some(screw) if !screw.angular.is_zero() => SlotKind::Angle,
        _ => SlotKind::Length,
    }
}

/// Whether a full turn of the coordinate brings each body back to its place: every joint that it moves turns without
/// sliding, by whole turns.
fn returns(model: &Model<'_>, coordinate: CoordinateId) -> bool {
    let moves = model.bodies.iter().map(|body| (body.motion.factor(coordinate), body));
    moves
        .filter(|(factor, _)| !factor.is_zero())
        .filter_map(|(factor, body)| Some((factor, body.screw?)))
        .all(|(factor, screw)| factor.is_integer() && turns_only(model.graph, &screw))
}

/// Whether a normalised screw is a rotation: it has no component along its axis.
fn turns_only<'g>(g: &'g Graph, screw: &Twist<'g>) -> bool {
    if screw.angular.is_zero() || screw.linear.is_zero() {
        return !screw.angular.is_zero();
    }
    let pitch = screw.angular.dot(screw.linear);
    Normalizer::new(g, BUDGET).is_zero(pitch) == Ok(true)
}

/// How far the normal form of a pitch may grow.
const BUDGET: usize = 100_000;

/// Whether the roots are the same after a full turn of the coordinate.
///
/// For each node, operands first, this finds the turns by which it grows: 1 for the coordinate itself, 0 for the sine
/// of anything that grows by whole turns and for what is computed from such sines. `None` is for growth that depends on
/// the state or on parameters.
fn repeats(g: &Graph, nodes: &[ExprId], roots: &[Expr<'_>], coordinate: Expr<'_>) -> bool {
    let zero = ratio(0, 1);
    let mut growths: FxHashMap<ExprId, Option<Rational>> = FxHashMap::default();
    for &id in nodes {
        let of = |x: &ExprId| growths[x].clone();
        let growth = match g.node(id) {
            _ if id == coordinate.id() => Some(ratio(1, 1)),
            Node::Unary(Unary::Neg, x) => of(x).map(|x| -x),
            Node::Unary(Unary::Sin | Unary::Cos | Unary::Tan, x) => {
                of(x).filter(Rational::is_integer).map(|_| zero.clone())
            }
            Node::Binary(Binary::Add, a, b) => of(a).zip(of(b)).map(|(a, b)| a + b),
            Node::Binary(Binary::Sub, a, b) => of(a).zip(of(b)).map(|(a, b)| a - b),
            Node::Binary(Binary::Mul, a, b) => match (g.as_number(*a), g.as_number(*b)) {
                (Some(factor), _) => of(b).map(|b| factor * b),
                (_, Some(factor)) => of(a).map(|a| a * factor),
                _ => still([of(a), of(b)]),
            },
            _ => still(g.operands(id).map(|x| of(&x))),
        };
        growths.insert(id, growth);
    }
    roots.iter().all(|root| growths[&root.id()] == Some(zero.clone()))
}

/// The growth of an operation, in which anything but none is unknown.
fn still(operands: impl IntoIterator<Item = Option<Rational>>) -> Option<Rational> {
    let mut operands = operands.into_iter();
    operands
        .all(|growth| growth.is_some_and(|turns| turns.is_zero()))
        .then(|| ratio(0, 1))
}

//! Layout of the state, and the symmetries of the right-hand side.

use std::ops::Range;

use num_traits::Zero;
use rustc_hash::FxHashMap;

use crate::expr::{Binary, Expr, ExprId, Graph, Node, Normalizer, Rational, Unary, add, multiply, ratio};
use crate::model::{CoordinateId, Model, constant, places};
use crate::screw::Twist;

/// Layout of the state.
#[derive(Clone, Debug, PartialEq)]
pub struct StateLayout {
    /// Coordinates, in the order of the state.
    pub slots: Vec<Slot>,
    /// First-order states, which follow the rates of the coordinates.
    pub states: Vec<StateVariable>,
    /// True if the right-hand side is proven not to depend on time.
    pub autonomous: bool,
}

/// Coordinate and its indices in the state.
#[derive(Clone, Debug, PartialEq)]
pub struct Slot {
    /// Name.
    pub name: String,
    /// Quantity that the coordinate measures.
    pub kind: SlotKind,
    /// Indices of its position in the state.
    pub positions: Range<usize>,
    /// Indices of its rate in the state. Empty if the rate depends on those of other coordinates.
    pub rates: Range<usize>,
    /// Names of the constants for the two indices of a coordinate with one component: `THETA1` and `DOT_THETA1`.
    pub constants: [String; 2],
    /// True if a full turn is proven to leave the scene unchanged.
    pub periodic: bool,
    /// True if the right-hand side is proven not to depend on the position.
    pub cyclic: bool,
}

/// First-order state and its index in the state.
#[derive(Clone, Debug, PartialEq)]
pub struct StateVariable {
    /// Name.
    pub name: String,
    /// Documentation, line by line.
    pub docs: Vec<String>,
    /// Unit, as written in the declaration.
    pub unit: String,
    /// Index in the state.
    pub index: usize,
    /// Name of the constant for the index.
    pub constant: String,
}

/// Quantity that a coordinate measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlotKind {
    /// Angle.
    Angle,
    /// Length.
    Length,
    /// Orientation: a unit quaternion, and three components of the angular velocity.
    Quaternion,
}

impl SlotKind {
    /// Unit of positions.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Angle => "rad",
            Self::Length => "m",
            Self::Quaternion => "1",
        }
    }

    /// Unit of rates.
    pub fn rate_unit(self) -> &'static str {
        match self {
            Self::Angle | Self::Quaternion => "rad/s",
            Self::Length => "m/s",
        }
    }
}

impl StateLayout {
    /// Layout of the state of a model whose right-hand side has these roots.
    ///
    /// A control law may depend on anything, so a model with inputs has no proven symmetry.
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
        let states = (first_rate + k..).zip(&model.states);
        let states = states.map(|(index, state)| StateVariable {
            name: state.name.trim_start_matches("r#").to_owned(),
            docs: state.docs.clone(),
            unit: state.unit.text.clone(),
            index,
            constant: constant(&state.name),
        });
        Self {
            slots,
            states: states.collect(),
            autonomous: !controlled && !occurs(model.time),
        }
    }
}

impl StateLayout {
    /// Number of components of the state.
    pub fn len(&self) -> usize {
        let of_slots = self.slots.iter();
        let of_slots = of_slots.map(|slot| slot.positions.len() + slot.rates.len());
        of_slots.sum::<usize>() + self.states.len()
    }

    /// True if the state has no components.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Names of the position components of the state, then names of the rate components, without `dot`.
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

    /// Indices of the quaternions in the state.
    pub fn quaternions(&self) -> impl Iterator<Item = Range<usize>> {
        let slots = self.slots.iter().filter(|slot| slot.kind == SlotKind::Quaternion);
        slots.map(|slot| slot.positions.clone())
    }

    /// Indices of the dependent coordinates in the state, which have no rates there.
    pub fn dependents(&self) -> impl Iterator<Item = usize> {
        let slots = self.slots.iter().filter(|slot| slot.rates.is_empty());
        slots.map(|slot| slot.positions.start)
    }

    /// Number of degrees of freedom, which is the number of rates.
    pub fn dof(&self) -> usize {
        self.slots.iter().map(|slot| slot.rates.len()).sum()
    }
}

/// Returns an angle if the joint of the coordinate turns, with or without sliding, and a length otherwise.
fn kind(model: &Model<'_>, coordinate: CoordinateId) -> SlotKind {
    let own = model.bodies.iter().find(|body| body.coordinate == Some(coordinate));
    match own.and_then(|body| body.screw) {
        Some(screw) if !screw.angular.is_zero() => SlotKind::Angle,
        _ => SlotKind::Length,
    }
}

/// True if a full turn of the coordinate returns each body to its place: every joint that it moves turns without
/// sliding, by an integer factor.
fn returns(model: &Model<'_>, coordinate: CoordinateId) -> bool {
    let moves = model.bodies.iter().map(|body| (body.motion.factor(coordinate), body));
    moves
        .filter(|(factor, _)| !factor.is_zero())
        .filter_map(|(factor, body)| Some((factor, body.screw?)))
        .all(|(factor, screw)| factor.is_integer() && turns_only(model.graph, &screw))
}

/// True if a normalised screw is a pure rotation, of zero pitch.
fn turns_only<'g>(g: &'g Graph, screw: &Twist<'g>) -> bool {
    if screw.angular.is_zero() || screw.linear.is_zero() {
        return !screw.angular.is_zero();
    }
    let pitch = screw.angular.dot(screw.linear);
    Normalizer::new(g, BUDGET).is_zero(pitch) == Ok(true)
}

/// Maximum size of the normal form of a pitch.
const BUDGET: usize = 100_000;

/// True if a full turn of the coordinate leaves the roots unchanged.
///
/// For each node, operands first, this computes its growth in turns: 1 for the coordinate itself, 0 for the sine of an
/// argument that grows by whole turns and for expressions of such sines. `None` means that the growth depends on the
/// state or on parameters.
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
            Node::Binary(Binary::Add, a, b) => of(a).zip(of(b)).map(|(a, b)| add(&a, &b)),
            Node::Binary(Binary::Sub, a, b) => of(a).zip(of(b)).map(|(a, b)| add(&a, &-b)),
            Node::Binary(Binary::Mul, a, b) => match (g.as_number(*a), g.as_number(*b)) {
                (Some(factor), _) => of(b).map(|b| multiply(factor, &b)),
                (_, Some(factor)) => of(a).map(|a| multiply(&a, factor)),
                _ => still([of(a), of(b)]),
            },
            _ => still(g.operands(id).map(|x| of(&x))),
        };
        growths.insert(id, growth);
    }
    roots.iter().all(|root| growths[&root.id()] == Some(zero.clone()))
}

/// Growth of an operation that is unknown unless no operand grows.
fn still(operands: impl IntoIterator<Item = Option<Rational>>) -> Option<Rational> {
    let mut operands = operands.into_iter();
    operands
        .all(|growth| growth.is_some_and(|turns| turns.is_zero()))
        .then(|| ratio(0, 1))
}

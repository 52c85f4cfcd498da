//! The hash-consed graph.

use std::borrow::Borrow;
use std::cell::RefCell;
use std::collections::hash_map::Entry;
use std::hash::{Hash, Hasher};
use std::mem;

use elsa::FrozenVec;
use num_bigint::BigInt;
use num_traits::{One, Zero};
use rustc_hash::FxHashMap;

use super::{Binary, Expr, Rational, Unary};

/// Id of an expression: the index of its node in its graph. Operands always have smaller ids than their operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ExprId(u32);

impl ExprId {
    /// Index in the graph.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Id of a symbol of a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SymbolId(u32);

impl SymbolId {
    /// Index in the symbol table.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Quantity that a symbol stands for. The number is the index among the symbols of that kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum SymbolKind {
    /// A parameter of the scene, fixed when the model is built.
    Parameter(usize),
    /// A coordinate.
    Coordinate(usize),
    /// The rate of a coordinate.
    Rate(usize),
    /// The second derivative of a coordinate, where it is held fixed while other quantities vary.
    Acceleration(usize),
    /// A value given at each evaluation.
    Input(usize),
    /// A first-order state.
    State(usize),
    /// The force along a constraint.
    Force(usize),
    /// Time.
    Time,
    /// A component of the position of a point, before it is expressed in coordinates.
    Point(usize),
    /// The rate of a component of the position of a point.
    PointRate(usize),
    /// A quantity at one order of a power series in time.
    Coefficient(usize),
    /// A quantity that depends on others through the closure of a loop.
    Dependent(usize),
    /// The given weight of a component of the right-hand side.
    Weight(usize),
    /// A component of a given direction, in which the state and the inputs vary.
    Direction(usize),
    /// The multiplier of an equation of motion.
    Multiplier(usize),
    /// An entry of the right-hand side of one of several linear systems with the same matrix.
    Given(usize),
    /// An entry of the factored matrix of these systems.
    Factor(usize),
    /// An entry of their solutions.
    Solved(usize),
}

/// A named symbol.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Symbol {
    /// Printed name.
    pub name: String,
    /// Quantity that it stands for.
    pub kind: SymbolKind,
}

/// Highest level of the symbols that an expression depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// No symbols: the value is folded into the code.
    Constant,
    /// Parameters: the value is computed once, when the model is built.
    Parameter,
    /// The state, the time or the inputs.
    State,
}

/// A node: an operation on operands, or a leaf. The graph stores operands by id; [`Expr::node`] returns them as
/// expressions.
#[derive(Clone, Copy, Debug)]
pub enum Node<Operand = ExprId, Number = Rational> {
    /// An exact number.
    Number(Number),
    /// The ratio of a circle's circumference to its diameter.
    Pi,
    /// A symbol.
    Symbol(SymbolId),
    /// An operation of one operand.
    Unary(Unary, Operand),
    /// An operation of two operands.
    Binary(Binary, Operand, Operand),
    /// A constant power.
    Power(Operand, Number),
}

/// Compares numerators and denominators, since numbers are in lowest terms; the comparison of the library divides.
impl<Operand: PartialEq, Number: Borrow<Rational>> PartialEq for Node<Operand, Number> {
    fn eq(&self, other: &Self) -> bool {
        let same = |a: &Number, b: &Number| parts(a) == parts(b);
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => same(a, b),
            (Self::Pi, Self::Pi) => true,
            (Self::Symbol(a), Self::Symbol(b)) => a == b,
            (Self::Unary(op, a), Self::Unary(other, b)) => op == other && a == b,
            (Self::Binary(op, a, b), Self::Binary(other, c, d)) => op == other && a == c && b == d,
            (Self::Power(a, n), Self::Power(b, m)) => a == b && same(n, m),
            _ => false,
        }
    }
}

impl<Operand: Eq, Number: Borrow<Rational>> Eq for Node<Operand, Number> {}

impl<Operand: Hash, Number: Borrow<Rational>> Hash for Node<Operand, Number> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        mem::discriminant(self).hash(state);
        match self {
            Self::Number(number) => parts(number).hash(state),
            Self::Pi => {}
            Self::Symbol(symbol) => symbol.hash(state),
            Self::Unary(op, a) => (op, a).hash(state),
            Self::Binary(op, a, b) => (op, a, b).hash(state),
            Self::Power(a, number) => (a, parts(number)).hash(state),
        }
    }
}

fn parts(number: &impl Borrow<Rational>) -> [&BigInt; 2] {
    let number = number.borrow();
    [number.numer(), number.denom()]
}

/// Dependence of a symbol on expressions.
#[derive(Clone, Debug)]
struct Changes {
    /// True if the symbol stands for a sum, false if it is only tied to the others by a condition.
    is_sum: bool,
    /// Pairs of an expression and the factor of its change.
    terms: Vec<[ExprId; 2]>,
}

/// Store of all expressions of one scene: a shared arena that only grows. Equal expressions have equal ids.
#[derive(Default)]
pub struct Graph {
    nodes: FrozenVec<Box<Stored>>,
    ids: RefCell<FxHashMap<Node, ExprId>>,
    symbols: FrozenVec<Box<Symbol>>,
    /// Dependence of each symbol that depends on others.
    changes: RefCell<FxHashMap<ExprId, Changes>>,
}

/// A node with its most used properties, computed from its operands so that they need no traversal of the graph.
#[derive(Debug)]
struct Stored {
    node: Node,
    level: Level,
    /// Value in double precision, if it depends on no symbol.
    value: f64,
    /// Number of operations when written out.
    length: u64,
    /// Nesting depth of the operations.
    depth: usize,
}

impl Graph {
    /// An empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    /// Node of an expression.
    pub fn node(&self, id: ExprId) -> &Node {
        &self.nodes[id.index()].node
    }

    /// Expression of a node.
    pub fn expr(&self, id: ExprId) -> Expr<'_> {
        Expr::new(self, id)
    }

    /// Id of a node, if it has been built.
    pub fn find(&self, node: &Node) -> Option<ExprId> {
        self.ids.borrow().get(node).copied()
    }

    /// Highest level of the symbols that the expression depends on.
    pub fn level(&self, id: ExprId) -> Level {
        self.nodes[id.index()].level
    }

    /// Value in double precision, if the expression depends on no symbol.
    pub fn constant(&self, id: ExprId) -> Option<f64> {
        let stored = &self.nodes[id.index()];
        (stored.level == Level::Constant).then_some(stored.value)
    }

    /// Number of operations when written out, with nothing shared; saturates at `u64::MAX`.
    pub fn length(&self, id: ExprId) -> u64 {
        self.nodes[id.index()].length
    }

    /// Nesting depth of the operations.
    pub fn depth(&self, id: ExprId) -> usize {
        self.nodes[id.index()].depth
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// True if the graph has no nodes.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// All symbols, in the order of their declaration.
    pub fn symbols(&self) -> impl Iterator<Item = &Symbol> {
        self.symbols.iter()
    }

    /// Symbol with this id.
    pub fn name_and_kind(&self, id: SymbolId) -> &Symbol {
        &self.symbols[id.index()]
    }

    /// Declares a symbol. The `r#` of a raw identifier is dropped from its name.
    pub fn symbol(&self, name: &str, kind: SymbolKind) -> Expr<'_> {
        let id = SymbolId(self.symbols.len() as u32);
        self.symbols.push(Box::new(Symbol {
            name: name.replace("r#", ""),
            kind,
        }));
        self.intern(Node::Symbol(id))
    }

    /// Declares the dependence of a symbol on expressions, each with the factor of its change. `is_sum` marks a symbol
    /// that stands for a sum.
    pub fn set_changes<'g>(&'g self, symbol: Expr<'g>, terms: &[(Expr<'g>, Expr<'g>)], is_sum: bool) {
        let terms = terms.iter().map(|(x, factor)| [x.id(), factor.id()]).collect();
        self.changes.borrow_mut().insert(symbol.id(), Changes { is_sum, terms });
    }

    /// Dependence of a symbol on expressions, each with the factor of its change; empty if it depends on none. With
    /// `alone`, only symbols that stand for sums count.
    pub fn changes<'g>(&'g self, symbol: Expr<'g>, alone: bool) -> Vec<(Expr<'g>, Expr<'g>)> {
        let changes = self.changes.borrow();
        let changes = changes.get(&symbol.id()).filter(|changes| changes.is_sum || !alone);
        let terms = changes.into_iter().flat_map(|changes| &changes.terms);
        terms.map(|&[x, factor]| (self.expr(x), self.expr(factor))).collect()
    }

    /// Symbol of a node, if it is one.
    pub fn as_symbol(&self, id: ExprId) -> Option<&Symbol> {
        match self.node(id) {
            Node::Symbol(s) => Some(&self.symbols[s.index()]),
            _ => None,
        }
    }

    /// Symbols that the roots depend on, in the order in which they were built.
    pub fn symbols_of<'g>(&'g self, roots: &[Expr<'g>]) -> impl Iterator<Item = &'g Symbol> + use<'g> {
        self.reachable(roots).into_iter().filter_map(|id| self.as_symbol(id))
    }

    /// Value of a node, if it is a number.
    pub fn as_number(&self, id: ExprId) -> Option<&Rational> {
        match self.node(id) {
            Node::Number(n) => Some(n),
            _ => None,
        }
    }

    /// True if the expression is the number 0. To test whether its value is zero, use the normal form.
    pub fn is_zero(&self, id: ExprId) -> bool {
        self.as_number(id).is_some_and(Zero::is_zero)
    }

    pub(super) fn is_one(&self, id: ExprId) -> bool {
        self.as_number(id).is_some_and(One::is_one)
    }

    /// The operands of a node, in order.
    pub fn operands(&self, id: ExprId) -> impl Iterator<Item = ExprId> + use<> {
        operands(self.node(id))
    }

    /// All nodes that the roots need, operands before operations.
    pub fn reachable(&self, roots: &[impl Into<ExprId> + Copy]) -> Vec<ExprId> {
        let (mut needed, mut found) = (vec![0_u64; self.len().div_ceil(64)], Vec::new());
        for &root in roots {
            let index = root.into().index();
            needed[index / 64] |= 1 << (index % 64);
        }
        // operands have smaller ids than their operation
        for word in (0..needed.len()).rev() {
            while let Some(bit) = needed[word].checked_ilog2() {
                needed[word] ^= 1 << bit;
                let id = ExprId(64 * word as u32 + bit);
                found.push(id);
                for operand in self.operands(id) {
                    needed[operand.index() / 64] |= 1 << (operand.index() % 64);
                }
            }
        }
        found.reverse();
        found
    }

    pub(super) fn intern(&self, node: Node) -> Expr<'_> {
        let mut ids = self.ids.borrow_mut();
        let free = match ids.entry(node) {
            Entry::Occupied(known) => return self.expr(*known.get()),
            Entry::Vacant(free) => free,
        };
        let (node, id) = (free.key().clone(), ExprId(self.nodes.len() as u32));
        self.nodes.push(Box::new(self.stored(node)));
        self.expr(*free.insert(id))
    }

    fn stored(&self, node: Node) -> Stored {
        let level = self.level_of(&node);
        let value = match level {
            Level::Constant => self.value_of(&node, |x| self.nodes[x.index()].value, |_| f64::NAN),
            _ => f64::NAN,
        };
        let (mut length, mut depth) = (1_u64, 0);
        for operand in operands(&node) {
            length = length.saturating_add(self.length(operand));
            depth = depth.max(self.depth(operand) + 1);
        }
        Stored {
            node,
            level,
            value,
            length,
            depth,
        }
    }

    fn level_of(&self, node: &Node) -> Level {
        match node {
            Node::Number(_) | Node::Pi => Level::Constant,
            Node::Symbol(s) => match self.symbols[s.index()].kind {
                SymbolKind::Parameter(_) => Level::Parameter,
                _ => Level::State,
            },
            Node::Unary(_, a) | Node::Power(a, _) => self.level(*a),
            Node::Binary(_, a, b) => self.level(*a).max(self.level(*b)),
        }
    }

    /// Replaces subexpressions of the roots, and simplifies the operations on them.
    pub fn substitute<'g>(&'g self, roots: &[Expr<'g>], new: FxHashMap<Expr<'g>, Expr<'g>>) -> Vec<Expr<'g>> {
        let mut replaced = vec![None; self.len()];
        for (x, new) in new {
            replaced[x.id().index()] = Some(new);
        }
        for id in self.reachable(roots) {
            if replaced[id.index()].is_some() {
                continue;
            }
            let of = |operand: ExprId| replaced[operand.index()].expect("operands come first");
            let new = match *self.node(id) {
                Node::Number(_) | Node::Pi | Node::Symbol(_) => self.expr(id),
                Node::Unary(op, a) => of(a).apply(op),
                Node::Binary(op, a, b) => of(a).combine(op, of(b)),
                Node::Power(a, ref n) => of(a).power(n.clone()),
            };
            replaced[id.index()] = Some(new);
        }
        let of = |root: &Expr<'g>| replaced[root.id().index()].expect("roots are reachable");
        roots.iter().map(of).collect()
    }
}

fn operands(node: &Node) -> impl Iterator<Item = ExprId> + use<> {
    let (a, b) = match *node {
        Node::Number(_) | Node::Pi | Node::Symbol(_) => (None, None),
        Node::Unary(_, a) | Node::Power(a, _) => (Some(a), None),
        Node::Binary(_, a, b) => (Some(a), Some(b)),
    };
    a.into_iter().chain(b)
}

impl std::fmt::Debug for Graph {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Graph")
            .field("nodes", &self.len())
            .finish_non_exhaustive()
    }
}

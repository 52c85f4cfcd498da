//! The hash-consed graph and its smart constructors.

use std::collections::HashMap;

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Binary, Rational, Unary, ratio};

/// An expression: the number of its node in its graph. Operands always have smaller ids than their operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ExprId(u32);

impl ExprId {
    /// The position in the graph.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A symbol of a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SymbolId(u32);

impl SymbolId {
    /// The position in the symbol table.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What a symbol stands for. The number is the position among the symbols of that kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum SymbolKind {
    /// A parameter of the scene: fixed when the model is built.
    Parameter(usize),
    /// A coordinate.
    Coordinate(usize),
    /// The rate of a coordinate.
    Rate(usize),
    /// The second rate of a coordinate, where it is held fixed while other things vary.
    Acceleration(usize),
    /// A value given at each evaluation.
    Input(usize),
    /// Time.
    Time,
}

/// A named symbol.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Symbol {
    /// The name that is printed.
    pub name: String,
    /// What it stands for.
    pub kind: SymbolKind,
}

/// On what an expression depends, at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// On nothing: it is folded into the code.
    Constant,
    /// On parameters: it is computed once, when the model is built.
    Parameter,
    /// On the state, the time or the inputs.
    State,
}

/// A node: an operation on other nodes, or a leaf.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// An exact number.
    Number(Rational),
    /// The ratio of a circle's circumference to its diameter.
    Pi,
    /// A symbol.
    Symbol(SymbolId),
    /// An operation of one operand.
    Unary(Unary, ExprId),
    /// An operation of two operands.
    Binary(Binary, ExprId, ExprId),
    /// A constant power.
    Power(ExprId, Rational),
}

/// The store of all expressions of one scene. It only grows; equal expressions get equal ids.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    levels: Vec<Level>,
    ids: HashMap<Node, ExprId>,
    symbols: Vec<Symbol>,
}

impl Graph {
    /// An empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    /// The node of an expression.
    pub fn node(&self, id: ExprId) -> &Node {
        &self.nodes[id.index()]
    }

    /// The expression of a node, if it has been built.
    pub fn find(&self, node: &Node) -> Option<ExprId> {
        self.ids.get(node).copied()
    }

    /// On what the expression depends, at most.
    pub fn level(&self, id: ExprId) -> Level {
        self.levels[id.index()]
    }

    /// The number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether nothing has been built yet.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// All symbols, in the order of their declaration.
    pub fn symbols(&self) -> &[Symbol] {
        &self.symbols
    }

    /// Declares a symbol.
    pub fn symbol(&mut self, name: &str, kind: SymbolKind) -> ExprId {
        let id = SymbolId(self.symbols.len() as u32);
        self.symbols.push(Symbol {
            name: name.to_owned(),
            kind,
        });
        self.intern(Node::Symbol(id))
    }

    /// The symbol of a leaf, if it is one.
    pub fn as_symbol(&self, id: ExprId) -> Option<&Symbol> {
        match self.node(id) {
            Node::Symbol(s) => Some(&self.symbols[s.index()]),
            _ => None,
        }
    }

    /// The value of a leaf, if it is a number.
    pub fn as_number(&self, id: ExprId) -> Option<&Rational> {
        match self.node(id) {
            Node::Number(n) => Some(n),
            _ => None,
        }
    }

    /// Whether the expression is the number zero. Use the normal form to ask whether it is zero in value.
    pub fn is_zero(&self, id: ExprId) -> bool {
        self.as_number(id).is_some_and(Zero::is_zero)
    }

    fn is_one(&self, id: ExprId) -> bool {
        self.as_number(id).is_some_and(One::is_one)
    }

    /// The operands of a node, in order.
    pub fn operands(&self, id: ExprId) -> impl Iterator<Item = ExprId> + use<> {
        let (a, b) = match *self.node(id) {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => (None, None),
            Node::Unary(_, a) | Node::Power(a, _) => (Some(a), None),
            Node::Binary(_, a, b) => (Some(a), Some(b)),
        };
        a.into_iter().chain(b)
    }

    /// All nodes that the roots need, operands before operations.
    pub fn reachable(&self, roots: &[ExprId]) -> Vec<ExprId> {
        let mut seen = vec![false; self.len()];
        let mut stack = roots.to_vec();
        while let Some(id) = stack.pop() {
            if !std::mem::replace(&mut seen[id.index()], true) {
                stack.extend(self.operands(id));
            }
        }
        (0..self.len() as u32)
            .map(ExprId)
            .filter(|id| seen[id.index()])
            .collect()
    }

    fn intern(&mut self, node: Node) -> ExprId {
        if let Some(&id) = self.ids.get(&node) {
            return id;
        }
        let level = match &node {
            Node::Number(_) | Node::Pi => Level::Constant,
            Node::Symbol(s) => match self.symbols[s.index()].kind {
                SymbolKind::Parameter(_) => Level::Parameter,
                _ => Level::State,
            },
            Node::Unary(_, a) | Node::Power(a, _) => self.level(*a),
            Node::Binary(_, a, b) => self.level(*a).max(self.level(*b)),
        };
        let id = ExprId(self.nodes.len() as u32);
        self.nodes.push(node.clone());
        self.levels.push(level);
        self.ids.insert(node, id);
        id
    }

    /// An exact number.
    pub fn number(&mut self, value: Rational) -> ExprId {
        self.intern(Node::Number(value))
    }

    /// An integer.
    pub fn integer(&mut self, value: i64) -> ExprId {
        self.number(ratio(value, 1))
    }

    /// The number 0.
    pub fn zero(&mut self) -> ExprId {
        self.integer(0)
    }

    /// The number 1.
    pub fn one(&mut self) -> ExprId {
        self.integer(1)
    }

    /// The constant pi.
    pub fn pi(&mut self) -> ExprId {
        self.intern(Node::Pi)
    }

    /// The opposite of `x`.
    pub fn neg(&mut self, x: ExprId) -> ExprId {
        match self.node(x).clone() {
            Node::Number(n) => self.number(-n),
            Node::Unary(Unary::Neg, y) => y,
            Node::Binary(Binary::Sub, a, b) => self.sub(b, a),
            _ => self.intern(Node::Unary(Unary::Neg, x)),
        }
    }

    fn as_negated(&self, x: ExprId) -> Option<ExprId> {
        match *self.node(x) {
            Node::Unary(Unary::Neg, y) => Some(y),
            _ => None,
        }
    }

    /// `a + b`.
    pub fn add(&mut self, a: ExprId, b: ExprId) -> ExprId {
        match (self.as_number(a), self.as_number(b)) {
            (Some(x), Some(y)) => {
                let sum = x + y;
                return self.number(sum);
            }
            (Some(x), _) if x.is_zero() => return b,
            (_, Some(y)) if y.is_zero() => return a,
            _ => {}
        }
        match (self.as_negated(a), self.as_negated(b)) {
            (Some(x), Some(y)) => {
                let sum = self.add(x, y);
                self.neg(sum)
            }
            (None, Some(y)) => self.sub(a, y),
            (Some(x), None) => self.sub(b, x),
            (None, None) if a == b => {
                let two = self.integer(2);
                self.mul(two, a)
            }
            (None, None) => self.intern(Node::Binary(Binary::Add, a.min(b), a.max(b))),
        }
    }

    /// `a - b`.
    pub fn sub(&mut self, a: ExprId, b: ExprId) -> ExprId {
        if a == b {
            return self.zero();
        }
        match (self.as_number(a), self.as_number(b)) {
            (Some(x), Some(y)) => {
                let difference = x - y;
                return self.number(difference);
            }
            (Some(x), _) if x.is_zero() => return self.neg(b),
            (_, Some(y)) if y.is_zero() => return a,
            _ => {}
        }
        match (self.as_negated(a), self.as_negated(b)) {
            (Some(x), Some(y)) => self.sub(y, x),
            (None, Some(y)) => self.add(a, y),
            (Some(x), None) => {
                let sum = self.add(x, b);
                self.neg(sum)
            }
            (None, None) => self.intern(Node::Binary(Binary::Sub, a, b)),
        }
    }

    /// `a * b`.
    pub fn mul(&mut self, a: ExprId, b: ExprId) -> ExprId {
        if let (Some(x), Some(y)) = (self.as_number(a), self.as_number(b)) {
            let product = x * y;
            return self.number(product);
        }
        for (x, y) in [(a, b), (b, a)] {
            if let Some(number) = self.as_number(x) {
                if number.is_zero() {
                    return x;
                }
                if number.is_one() {
                    return y;
                }
                if number.is_negative() {
                    let positive = -number;
                    let positive = self.number(positive);
                    let product = self.mul(positive, y);
                    return self.neg(product);
                }
                // a number times a number times an expression
                if let Node::Binary(Binary::Mul, u, v) = *self.node(y)
                    && let Some(inner) = self.as_number(u)
                {
                    let folded = number * inner;
                    let folded = self.number(folded);
                    return self.mul(folded, v);
                }
            }
            if let Some(positive) = self.as_negated(x) {
                let product = self.mul(positive, y);
                return self.neg(product);
            }
        }
        let ((u, m), (v, n)) = (self.base_and_exponent(a), self.base_and_exponent(b));
        if u == v {
            return self.power(u, m + n);
        }
        // numbers first, whatever their ids
        let (a, b) = match (self.as_number(a).is_some(), self.as_number(b).is_some()) {
            (true, _) => (a, b),
            (_, true) => (b, a),
            _ => (a.min(b), a.max(b)),
        };
        self.intern(Node::Binary(Binary::Mul, a, b))
    }

    fn base_and_exponent(&self, x: ExprId) -> (ExprId, Rational) {
        match self.node(x) {
            Node::Power(base, exponent) => (*base, exponent.clone()),
            _ => (x, ratio(1, 1)),
        }
    }

    /// `a / b`. Division by the number zero stays as it is written, so that it shows as a non-finite value.
    pub fn div(&mut self, a: ExprId, b: ExprId) -> ExprId {
        if let Some(divisor) = self.as_number(b)
            && !divisor.is_zero()
        {
            let reciprocal = divisor.recip();
            let reciprocal = self.number(reciprocal);
            return self.mul(reciprocal, a);
        }
        if self.is_zero(a) && !self.is_zero(b) {
            return a;
        }
        if a == b && !self.is_zero(b) {
            return self.one();
        }
        match (self.as_negated(a), self.as_negated(b)) {
            (Some(x), Some(y)) => self.div(x, y),
            (Some(x), None) => {
                let quotient = self.div(x, b);
                self.neg(quotient)
            }
            (None, Some(y)) => {
                let quotient = self.div(a, y);
                self.neg(quotient)
            }
            (None, None) => self.intern(Node::Binary(Binary::Div, a, b)),
        }
    }

    /// `x^exponent` with a constant integer exponent.
    pub fn powi(&mut self, x: ExprId, exponent: i64) -> ExprId {
        self.power(x, ratio(exponent, 1))
    }

    /// The square root of `x`.
    pub fn sqrt(&mut self, x: ExprId) -> ExprId {
        self.power(x, ratio(1, 2))
    }

    /// `x^exponent` with a constant exponent.
    pub fn power(&mut self, x: ExprId, exponent: Rational) -> ExprId {
        if exponent.is_zero() || self.is_one(x) {
            return self.one();
        }
        if exponent.is_one() {
            return x;
        }
        if let (Some(base), true) = (self.as_number(x), exponent.is_integer()) {
            if let Some(n) = exponent.to_i32()
                && n.unsigned_abs() < 1000
                && !base.is_zero()
            {
                let value = num_traits::Pow::pow(base, n);
                return self.number(value);
            }
            if base.is_zero() && exponent.is_positive() {
                return x;
            }
        }
        if let Some(root) = self
            .as_number(x)
            .filter(|_| exponent.denom() == &2.into())
            .and_then(exact_sqrt)
        {
            let root = self.number(root);
            return self.power(root, exponent * ratio(2, 1));
        }
        if let (Some(positive), true) = (self.as_negated(x), exponent.is_integer()) {
            let power = self.power(positive, exponent.clone());
            let odd = (exponent.to_integer() % 2i32) != 0.into();
            return if odd { self.neg(power) } else { power };
        }
        if let (Node::Power(base, inner), true) = (self.node(x).clone(), exponent.is_integer()) {
            return self.power(base, inner * exponent);
        }
        self.intern(Node::Power(x, exponent))
    }

    /// The roots with some expressions replaced by others, simplified on the way up.
    pub fn substitute(&mut self, roots: &[ExprId], mut new: HashMap<ExprId, ExprId>) -> Vec<ExprId> {
        for id in self.reachable(roots) {
            if new.contains_key(&id) {
                continue;
            }
            let of = |x: ExprId| new[&x];
            let replaced = match self.node(id).clone() {
                Node::Number(_) | Node::Pi | Node::Symbol(_) => id,
                Node::Unary(op, a) => self.unary(op, of(a)),
                Node::Binary(op, a, b) => self.binary(op, of(a), of(b)),
                Node::Power(a, n) => self.power(of(a), n),
            };
            new.insert(id, replaced);
        }
        roots.iter().map(|id| new[id]).collect()
    }

    /// An operation exactly as given, without any simplification: for passes that have chosen the order of operations.
    pub(crate) fn exactly(&mut self, op: Binary, a: ExprId, b: ExprId) -> ExprId {
        self.intern(Node::Binary(op, a, b))
    }

    /// The opposite exactly as given.
    pub(crate) fn exactly_negated(&mut self, x: ExprId) -> ExprId {
        self.intern(Node::Unary(Unary::Neg, x))
    }

    /// `numerator / (x^2 + y^2)`.
    pub fn over_norm_squared(&mut self, numerator: ExprId, x: ExprId, y: ExprId) -> ExprId {
        let (x2, y2) = (self.powi(x, 2), self.powi(y, 2));
        let norm2 = self.add(x2, y2);
        self.div(numerator, norm2)
    }

    /// An operation of one operand.
    pub fn unary(&mut self, op: Unary, x: ExprId) -> ExprId {
        match op {
            Unary::Neg => self.neg(x),
            Unary::Sin | Unary::Cos => self.sine_or_cosine(op, x),
            Unary::Tan | Unary::Tanh if self.is_zero(x) => x,
            Unary::Exp if self.is_zero(x) => self.one(),
            Unary::Ln if self.is_one(x) => self.zero(),
            Unary::Abs if self.as_number(x).is_some() => {
                if self.as_number(x).is_some_and(Signed::is_negative) {
                    self.neg(x)
                } else {
                    x
                }
            }
            _ => self.intern(Node::Unary(op, x)),
        }
    }

    /// An operation of two operands.
    pub fn binary(&mut self, op: Binary, a: ExprId, b: ExprId) -> ExprId {
        match op {
            Binary::Add => self.add(a, b),
            Binary::Sub => self.sub(a, b),
            Binary::Mul => self.mul(a, b),
            Binary::Div => self.div(a, b),
            Binary::Atan2 => self.intern(Node::Binary(op, a, b)),
        }
    }

    fn sine_or_cosine(&mut self, op: Unary, x: ExprId) -> ExprId {
        if let Some(turns) = self.multiple_of_pi(x)
            && let Some(value) = self.exact_sine_or_cosine(op, &turns)
        {
            return value;
        }
        let opposite = match *self.node(x) {
            Node::Unary(Unary::Neg, y) => Some(y),
            // a - b and b - a have one sine and cosine between them
            Node::Binary(Binary::Sub, a, b) if a < b => Some(self.sub(b, a)),
            _ => None,
        };
        match (op, opposite) {
            (Unary::Cos, Some(y)) => self.intern(Node::Unary(Unary::Cos, y)),
            (_, Some(y)) => {
                let sine = self.intern(Node::Unary(Unary::Sin, y));
                self.neg(sine)
            }
            (_, None) => self.intern(Node::Unary(op, x)),
        }
    }

    /// `k` where the expression is `k pi`.
    fn multiple_of_pi(&self, x: ExprId) -> Option<Rational> {
        match self.node(x) {
            Node::Number(n) if n.is_zero() => Some(n.clone()),
            Node::Pi => Some(ratio(1, 1)),
            Node::Unary(Unary::Neg, y) => self.multiple_of_pi(*y).map(|k| -k),
            Node::Binary(Binary::Mul, a, b) if matches!(self.node(*b), Node::Pi) => self.as_number(*a).cloned(),
            _ => None,
        }
    }

    /// Sine and cosine of the angles whose values are square roots of rationals: multiples of 30 and 45 degrees.
    fn exact_sine_or_cosine(&mut self, op: Unary, turns: &Rational) -> Option<ExprId> {
        let quarter = ratio(1, 2);
        let turns = if op == Unary::Cos {
            turns + quarter
        } else {
            turns.clone()
        };
        let twelfths = turns * ratio(12, 1);
        if !twelfths.is_integer() {
            return None;
        }
        let two = ratio(24, 1);
        let k = (((&twelfths % &two) + &two) % &two).to_i64()?;
        let (negative, k) = (k >= 12, k % 12);
        let four_times_square = match k.min(12 - k) {
            0 => 0,
            2 => 1,
            3 => 2,
            4 => 3,
            6 => 4,
            _ => return None,
        };
        let square = self.number(ratio(four_times_square, 4));
        let value = self.sqrt(square);
        Some(if negative { self.neg(value) } else { value })
    }
}

fn exact_sqrt(x: &Rational) -> Option<Rational> {
    if x.is_negative() {
        return None;
    }
    let (n, d) = (x.numer().sqrt(), x.denom().sqrt());
    (&n * &n == *x.numer() && &d * &d == *x.denom()).then(|| Rational::new(n, d))
}

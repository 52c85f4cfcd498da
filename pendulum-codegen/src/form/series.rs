//! Recurrences of power series: from an expression to the coefficients that its value has along a motion.
//!
//! With `z = sum_k z_k h^k` each operation gives `z_k` from the coefficients of its operands (Jorba and Zou, "A software package for the
//! numerical integration of ODEs by means of high-order Taylor methods", Experimental Mathematics 2005; Griewank and Walther, "Evaluating
//! Derivatives" 2008, ch. 13). Linear ones need those of order `k` only. The others take sums `sum_j u_j v_(k-j)`, which are split here:
//! the interior `j = 1 .. k - 1` of all of them is a [`Slot`] each, all computed at once before anything else of order `k`, and the
//! ends, with `u_0` and `v_0`, are written out. For example `z = u v` is `z_k = sum + u_0 v_k + v_0 u_k`.

use std::collections::HashMap;

use num_traits::Signed;

use crate::expr::{Binary, ExprId, Graph, Level, Node, Rational, SymbolKind, Unary, ratio};
use crate::model::Model;

/// One side of a product of series.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Side {
    /// The value whose coefficients they are.
    pub value: ExprId,
    /// Whether coefficient `j` counts `j` times: the series of the derivative.
    pub weighted: bool,
}

/// The product of two series: its sum of order `k` takes coefficients `1 .. k - 1` of both.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Slot {
    /// Its coefficients from the first on.
    pub left: Side,
    /// Its coefficients from the last on.
    pub right: Side,
}

/// The symbols that stand for what is known when the coefficients of order `k` are computed.
#[derive(Clone, Debug)]
pub struct Symbols {
    /// The number `k`.
    pub order: ExprId,
    /// The number `1 / k`.
    pub over_order: ExprId,
    /// The coefficient of the time.
    pub time: ExprId,
    /// The coefficients of the coordinates, then of their rates.
    pub state: Vec<ExprId>,
    /// The sums of the slots.
    pub sums: Vec<ExprId>,
    /// What does not change from order to order.
    pub kept: Vec<ExprId>,
}

impl Symbols {
    /// Symbols for a model.
    pub(super) fn new(model: &Model) -> Self {
        let length = 2 * model.dof();
        let symbol = |name: &str, n: usize| model.graph.symbol(name, SymbolKind::Coefficient(n));
        Self {
            order: symbol("k", 0),
            over_order: symbol("1/k", 0),
            time: symbol("t[k]", 0),
            state: (0..length).map(|n| symbol("x[k]", n)).collect(),
            sums: Vec::new(),
            kept: Vec::new(),
        }
    }

    /// The symbol of number `n` in a list that grows.
    pub(super) fn of_list(g: &Graph, list: &mut Vec<ExprId>, name: &str, n: usize) -> ExprId {
        while list.len() <= n {
            list.push(g.symbol(name, SymbolKind::Coefficient(list.len())));
        }
        list[n]
    }
}

/// The coefficients of order `k` of expressions, in symbols, and the slots that they take.
#[derive(Debug)]
pub(super) struct Recurrences<'s> {
    symbols: &'s mut Symbols,
    /// The slots, in the order in which they were met.
    pub(super) slots: Vec<Slot>,
    known: HashMap<Slot, usize>,
    coefficients: HashMap<ExprId, ExprId>,
    /// Whether all coefficients but the first vanish.
    still: HashMap<ExprId, bool>,
}

impl<'s> Recurrences<'s> {
    /// No expressions yet, but the time and the state.
    pub(super) fn new(model: &Model, symbols: &'s mut Symbols) -> Self {
        let state = model.state().into_iter().zip(symbols.state.iter().copied());
        let coefficients = state.chain([(model.time, symbols.time)]).collect();
        Self {
            symbols,
            slots: Vec::new(),
            known: HashMap::new(),
            coefficients,
            still: HashMap::new(),
        }
    }

    /// Gives a value the coefficient that it turned out to have.
    pub(super) fn set(&mut self, value: ExprId, coefficient: ExprId) {
        self.coefficients.insert(value, coefficient);
    }

    /// Both sides of all slots, those included that they need in turn.
    pub(super) fn sides(&mut self, g: &Graph) -> [Vec<ExprId>; 2] {
        let (mut left, mut right) = (Vec::new(), Vec::new());
        let mut next = 0;
        while let Some(&slot) = self.slots.get(next) {
            left.push(self.side(g, slot.left));
            right.push(self.side(g, slot.right));
            next += 1;
        }
        [left, right]
    }

    fn side(&mut self, g: &Graph, Side { value, weighted }: Side) -> ExprId {
        let coefficient = self.coefficient(g, value);
        if weighted {
            g.mul(self.symbols.order, coefficient)
        } else {
            coefficient
        }
    }

    /// The coefficient of order `k` of an expression.
    pub(super) fn coefficient(&mut self, g: &Graph, x: ExprId) -> ExprId {
        if let Some(&known) = self.coefficients.get(&x) {
            return known;
        }
        let coefficient = if self.is_still(g, x) { g.zero() } else { self.rule(g, x) };
        self.coefficients.insert(x, coefficient);
        coefficient
    }

    /// Whether an expression does not change along a motion, or does so in jumps only.
    fn is_still(&mut self, g: &Graph, x: ExprId) -> bool {
        if let Some(&known) = self.still.get(&x) {
            return known;
        }
        let still = match g.node(x) {
            _ if g.level(x) < Level::State => true,
            Node::Symbol(_) => false,
            Node::Unary(Unary::Sign, _) => true,
            _ => g.operands(x).all(|operand| self.is_still(g, operand)),
        };
        self.still.insert(x, still);
        still
    }

    fn rule(&mut self, g: &Graph, z: ExprId) -> ExprId {
        match g.node(z).clone() {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => g.zero(),
            Node::Unary(op, u) => self.unary(g, op, z, u),
            Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => {
                let (a, b) = (self.coefficient(g, a), self.coefficient(g, b));
                g.binary(op, a, b)
            }
            Node::Binary(Binary::Mul, a, b) => self.product(g, a, b),
            Node::Binary(Binary::Div, a, b) => self.quotient(g, z, a, b),
            Node::Binary(Binary::Atan2, y, x) => self.angle(g, z, y, x),
            Node::Power(u, n) => self.power(g, z, u, &n),
        }
    }

    /// `u v`
    pub(super) fn product(&mut self, g: &Graph, u: ExprId, v: ExprId) -> ExprId {
        let ((p, u), (q, v)) = (scaled(g, u), scaled(g, v));
        let factor = g.mul(p, q);
        let (uk, vk) = (self.coefficient(g, u), self.coefficient(g, v));
        let sum = self.interior(g, plain(u), plain(v));
        // the factor goes to what is known early, and not to the whole, which would wait for it
        let [sum, u, v] = [sum, u, v].map(|early| g.mul(factor, early));
        let (first, second) = (g.mul(v, uk), g.mul(u, vk));
        let first = g.add(sum, first);
        g.add(first, second)
    }

    /// `z = a / b`, from `z b = a`.
    fn quotient(&mut self, g: &Graph, z: ExprId, a: ExprId, b: ExprId) -> ExprId {
        let (ak, bk) = (self.coefficient(g, a), self.coefficient(g, b));
        let sum = self.interior(g, plain(z), plain(b));
        let end = g.mul(z, bk);
        let rest = [sum, end].into_iter().fold(ak, |rest, term| g.sub(rest, term));
        let inverse = inverse(g, b);
        g.mul(rest, inverse)
    }

    /// A function `z` of `u`: from a differential equation that it solves, but for the square root, whose square is `u`.
    fn unary(&mut self, g: &Graph, op: Unary, z: ExprId, u: ExprId) -> ExprId {
        let uk = self.coefficient(g, u);
        match op {
            Unary::Neg => g.neg(uk),
            Unary::Sin | Unary::Cos => {
                let other = g.unary(if op == Unary::Sin { Unary::Cos } else { Unary::Sin }, u);
                let change = self.slope_times(g, u, other);
                if op == Unary::Sin { change } else { g.neg(change) }
            }
            Unary::Exp => self.slope_times(g, u, z),
            Unary::Ln => {
                let sum = self.over_order(g, rate(z), plain(u));
                let rest = g.sub(uk, sum);
                let inverse = inverse(g, u);
                g.mul(rest, inverse)
            }
            // z' = (1 +- z^2) u'
            Unary::Tan => {
                let square = g.powi(z, 2);
                let change = self.slope_times(g, u, square);
                g.add(uk, change)
            }
            Unary::Tanh => {
                let square = g.powi(z, 2);
                let change = self.slope_times(g, u, square);
                g.sub(uk, change)
            }
            Unary::Abs => {
                let sign = g.unary(Unary::Sign, u);
                g.mul(sign, uk)
            }
            Unary::Sign => g.zero(),
        }
    }

    /// `z = u^n`: products for whole `n`, `z^2 = u` for the root, and `z' u = n u' z` otherwise.
    fn power(&mut self, g: &Graph, z: ExprId, u: ExprId, n: &Rational) -> ExprId {
        if n.is_integer() && n.is_positive() {
            let half = (n / ratio(2, 1)).floor();
            let (a, b) = (g.power(u, half.clone()), g.power(u, n - half));
            return self.product(g, a, b);
        }
        if n.is_integer() {
            let (one, below) = (g.one(), g.power(u, -n));
            return self.quotient(g, z, one, below);
        }
        let uk = self.coefficient(g, u);
        if *n == ratio(1, 2) {
            let sum = self.interior(g, plain(z), plain(z));
            let (two, rest) = (g.integer(2), g.sub(uk, sum));
            let twice = g.mul(two, z);
            let inverse = inverse(g, twice);
            return g.mul(rest, inverse);
        }
        let (exponent, change) = (g.number(n.clone()), self.slope_times(g, u, z));
        let change = g.mul(exponent, change);
        let sum = self.over_order(g, rate(z), plain(u));
        let rest = g.sub(change, sum);
        let inverse = inverse(g, u);
        g.mul(rest, inverse)
    }

    /// `z = atan2(y, x)`, from `z' (x^2 + y^2) = x y' - y x'`.
    fn angle(&mut self, g: &Graph, z: ExprId, y: ExprId, x: ExprId) -> ExprId {
        let (y2, x2) = (g.powi(y, 2), g.powi(x, 2));
        let norm2 = g.add(y2, x2);
        let (rising, falling) = (self.slope_times(g, y, x), self.slope_times(g, x, y));
        let change = g.sub(rising, falling);
        let sum = self.over_order(g, rate(z), plain(norm2));
        let rest = g.sub(change, sum);
        let inverse = inverse(g, norm2);
        g.mul(rest, inverse)
    }

    /// The coefficient of order `k` of what has the derivative `u' v`.
    fn slope_times(&mut self, g: &Graph, u: ExprId, v: ExprId) -> ExprId {
        let sum = self.over_order(g, rate(u), plain(v));
        let uk = self.coefficient(g, u);
        let end = g.mul(v, uk);
        g.add(sum, end)
    }

    fn over_order(&mut self, g: &Graph, left: Side, right: Side) -> ExprId {
        let sum = self.interior(g, left, right);
        g.mul(self.symbols.over_order, sum)
    }

    /// The sum over `j = 1 .. k - 1`; constant factors stand before it, so that multiples have one slot between them.
    pub(super) fn interior(&mut self, g: &Graph, left: Side, right: Side) -> ExprId {
        if self.is_still(g, left.value) || self.is_still(g, right.value) {
            return g.zero();
        }
        let ((p, u), (q, v)) = (scaled(g, left.value), scaled(g, right.value));
        let slot = Slot {
            left: Side { value: u, ..left },
            right: Side { value: v, ..right },
        };
        let n = *self.known.entry(slot).or_insert(self.slots.len());
        if n == self.slots.len() {
            self.slots.push(slot);
        }
        let sum = Symbols::of_list(g, &mut self.symbols.sums, "sum", n);
        let factor = g.mul(p, q);
        g.mul(factor, sum)
    }
}

/// The series itself.
pub(super) fn plain(value: ExprId) -> Side {
    Side { value, weighted: false }
}

/// The series of the derivative.
fn rate(value: ExprId) -> Side {
    Side { value, weighted: true }
}

fn inverse(g: &Graph, x: ExprId) -> ExprId {
    let one = g.one();
    g.div(one, x)
}

/// A constant factor, and what it multiplies.
fn scaled(g: &Graph, x: ExprId) -> (ExprId, ExprId) {
    let is_constant = |g: &Graph, x: ExprId| g.level(x) < Level::State;
    if is_constant(g, x) {
        return (x, g.one());
    }
    let one = g.one();
    let (factor, rest) = match *g.node(x) {
        Node::Unary(Unary::Neg, rest) => (g.integer(-1), rest),
        Node::Binary(Binary::Mul, factor, rest) | Node::Binary(Binary::Mul, rest, factor) if is_constant(g, factor) => {
            (factor, rest)
        }
        Node::Binary(Binary::Div, rest, divisor) if is_constant(g, divisor) => (inverse(g, divisor), rest),
        Node::Binary(Binary::Div, factor, divisor) if is_constant(g, factor) && factor != one => {
            (factor, inverse(g, divisor))
        }
        _ => return (one, x),
    };
    let (inner, rest) = scaled(g, rest);
    (g.mul(factor, inner), rest)
}

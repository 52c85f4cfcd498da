//! Recurrences of power series: from an expression to the coefficients of its value along a motion.
//!
//! With `z = sum_k z_k h^k` each operation gives `z_k` from the coefficients of its operands (Jorba and Zou, "A
//! software package for the numerical integration of ODEs by means of high-order Taylor methods", Experimental
//! Mathematics 2005; Griewank and Walther, "Evaluating Derivatives" 2008, ch. 13). Linear operations need only the
//! coefficients of order `k`. The others need sums `sum_j u_j v_(k-j)`, which are split here. The interior part
//! `j = 1 .. k - 1` of each sum is a [`Slot`]; all slots are computed first at order `k`. The two end terms, with `u_0`
//! and `v_0`, are written out. For example `z = u v` becomes `z_k = sum + u_0 v_k + v_0 u_k`.

use num_traits::Signed;
use rustc_hash::FxHashMap;

use crate::expr::{Binary, Expr, Graph, Level, Node, Rational, SymbolKind, Unary, ratio};
use crate::model::Model;

/// One factor in a product of series.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Side<'g> {
    /// Value whose coefficients enter the product.
    pub value: Expr<'g>,
    /// True if coefficient `j` is multiplied by `j`, which gives the series of the derivative.
    pub weighted: bool,
}

/// Product of two series: its sum of order `k` takes coefficients `1 .. k - 1` of both.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Slot<'g> {
    /// Factor whose coefficients are taken in ascending order.
    pub left: Side<'g>,
    /// Factor whose coefficients are taken in descending order.
    pub right: Side<'g>,
}

/// Symbols for the quantities available when the coefficients of order `k` are computed.
#[derive(Clone, Debug)]
pub(crate) struct Symbols<'g> {
    /// The order `k`.
    pub order: Expr<'g>,
    /// The reciprocal `1 / k`.
    pub over_order: Expr<'g>,
    /// Coefficient of the time.
    pub time: Expr<'g>,
    /// Coefficients of the coordinates, then of their rates.
    pub state: Vec<Expr<'g>>,
    /// Coefficients of the constraint forces.
    pub forces: Vec<Expr<'g>>,
    /// Interior sums of the slots.
    pub sums: Vec<Expr<'g>>,
    /// Values of order 0 that every order reuses.
    pub kept: Vec<Expr<'g>>,
}

impl<'g> Symbols<'g> {
    /// Symbols for a model.
    pub(super) fn new(model: &Model<'g>) -> Self {
        let length = model.state().len();
        let symbol = |name: &str, n: usize| model.graph.symbol(name, SymbolKind::Coefficient(n));
        Self {
            order: symbol("k", 0),
            over_order: symbol("1/k", 0),
            time: symbol("t[k]", 0),
            state: (0..length).map(|n| symbol("x[k]", n)).collect(),
            forces: (0..model.constraints.len()).map(|n| symbol("force[k]", n)).collect(),
            sums: Vec::new(),
            kept: Vec::new(),
        }
    }

    /// Symbol number `n` of a list, extended if it is shorter.
    pub(super) fn of_list(g: &'g Graph, list: &mut Vec<Expr<'g>>, name: &str, n: usize) -> Expr<'g> {
        while list.len() <= n {
            list.push(g.symbol(name, SymbolKind::Coefficient(list.len())));
        }
        list[n]
    }
}

/// Symbolic coefficients of order `k` of expressions, and the slots they use.
#[derive(Debug)]
pub(super) struct Recurrences<'g, 's> {
    graph: &'g Graph,
    symbols: &'s mut Symbols<'g>,
    /// Slots, in the order in which they were first used.
    pub(super) slots: Vec<Slot<'g>>,
    known: FxHashMap<Slot<'g>, usize>,
    coefficients: FxHashMap<Expr<'g>, Expr<'g>>,
    /// True if all coefficients beyond order 0 vanish.
    still: FxHashMap<Expr<'g>, bool>,
}

impl<'g, 's> Recurrences<'g, 's> {
    /// Starts with the coefficients of the time, the state and the constraint forces.
    pub(super) fn new(model: &Model<'g>, symbols: &'s mut Symbols<'g>) -> Self {
        let state = model.state().into_iter().zip(symbols.state.iter().copied());
        let forces = model.force_symbols().into_iter().zip(symbols.forces.iter().copied());
        let coefficients = state.chain(forces).chain([(model.time, symbols.time)]).collect();
        Self {
            graph: model.graph,
            symbols,
            slots: Vec::new(),
            known: FxHashMap::default(),
            coefficients,
            still: FxHashMap::default(),
        }
    }

    /// Sets the coefficient of a value.
    pub(super) fn set(&mut self, value: Expr<'g>, coefficient: Expr<'g>) {
        self.coefficients.insert(value, coefficient);
    }

    /// Sets the coefficient of a value that has none.
    pub(super) fn set_first(&mut self, value: Expr<'g>, coefficient: Expr<'g>) {
        self.coefficients.entry(value).or_insert(coefficient);
    }

    /// Coefficients of both factors of every slot, including slots that these coefficients add.
    pub(super) fn sides(&mut self) -> [Vec<Expr<'g>>; 2] {
        let (mut left, mut right) = (Vec::new(), Vec::new());
        let mut next = 0;
        while let Some(&slot) = self.slots.get(next) {
            left.push(self.side(slot.left));
            right.push(self.side(slot.right));
            next += 1;
        }
        [left, right]
    }

    fn side(&mut self, Side { value, weighted }: Side<'g>) -> Expr<'g> {
        let coefficient = self.coefficient(value);
        if weighted {
            self.symbols.order * coefficient
        } else {
            coefficient
        }
    }

    /// Coefficient of order `k` of an expression.
    pub(super) fn coefficient(&mut self, x: Expr<'g>) -> Expr<'g> {
        if let Some(&known) = self.coefficients.get(&x) {
            return known;
        }
        let coefficient = if self.is_still(x) {
            self.graph.zero()
        } else {
            self.rule(x)
        };
        self.coefficients.insert(x, coefficient);
        coefficient
    }

    /// True if an expression is constant along a motion or changes only in jumps.
    fn is_still(&mut self, x: Expr<'g>) -> bool {
        if let Some(&known) = self.still.get(&x) {
            return known;
        }
        let still = match x.node() {
            _ if x.level() < Level::State => true,
            Node::Symbol(_) => false,
            Node::Unary(Unary::Sign, _) => true,
            _ => x.operands().all(|operand| self.is_still(operand)),
        };
        self.still.insert(x, still);
        still
    }

    fn rule(&mut self, z: Expr<'g>) -> Expr<'g> {
        match z.node() {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => self.graph.zero(),
            Node::Unary(op, u) => self.unary(op, z, u),
            Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => {
                self.coefficient(a).combine(op, self.coefficient(b))
            }
            Node::Binary(Binary::Mul, a, b) => self.product(a, b),
            Node::Binary(Binary::Div, a, b) => self.quotient(z, a, b),
            Node::Binary(Binary::Atan2, y, x) => self.angle(z, y, x),
            // near any point where they differ, the maximum or minimum equals one of its operands
            Node::Binary(op @ (Binary::Max | Binary::Min), a, b) => {
                let [left, right] = op.derivatives(a, b);
                left * self.coefficient(a) + right * self.coefficient(b)
            }
            Node::Power(u, n) => self.power(z, u, n),
        }
    }

    /// Coefficient of `u v`.
    pub(super) fn product(&mut self, u: Expr<'g>, v: Expr<'g>) -> Expr<'g> {
        let ((p, u), (q, v)) = (scaled(u), scaled(v));
        let factor = p * q;
        let (uk, vk) = (self.coefficient(u), self.coefficient(v));
        let sum = self.interior(plain(u), plain(v));
        // apply the constant factor to the operands that are available early; on the whole sum it would have to wait
        let [sum, u, v] = [sum, u, v].map(|early| factor * early);
        let (first, second) = (v * uk, u * vk);
        sum + first + second
    }

    /// Coefficient of `z = a / b`, from `z b = a`.
    fn quotient(&mut self, z: Expr<'g>, a: Expr<'g>, b: Expr<'g>) -> Expr<'g> {
        let (ak, bk) = (self.coefficient(a), self.coefficient(b));
        let sum = self.interior(plain(z), plain(b));
        let end = z * bk;
        (ak - sum - end) * b.recip()
    }

    /// Coefficient of a function `z = op(u)`, from the differential equation that it satisfies.
    fn unary(&mut self, op: Unary, z: Expr<'g>, u: Expr<'g>) -> Expr<'g> {
        let uk = self.coefficient(u);
        match op {
            Unary::Neg => -uk,
            Unary::Sin => self.slope_times(u, u.cos()),
            Unary::Cos => -self.slope_times(u, u.sin()),
            Unary::Exp => self.slope_times(u, z),
            Unary::Ln => (uk - self.over_order(rate(z), plain(u))) * u.recip(),
            // z' = (1 +- z^2) u'
            Unary::Tan => uk + self.slope_times(u, z.powi(2)),
            Unary::Tanh => uk - self.slope_times(u, z.powi(2)),
            Unary::Abs => u.apply(Unary::Sign) * uk,
            Unary::Sign => self.graph.zero(),
        }
    }

    /// Coefficient of `z = u^n`: by products for integer `n`, from `z^2 = u` for the root, and from `z' u = n u' z`
    /// otherwise.
    fn power(&mut self, z: Expr<'g>, u: Expr<'g>, n: &Rational) -> Expr<'g> {
        if n.is_integer() && n.is_positive() {
            let half = (n / ratio(2, 1)).floor();
            return self.product(u.power(half.clone()), u.power(n - half));
        }
        if n.is_integer() {
            return self.quotient(z, self.graph.one(), u.power(-n));
        }
        let uk = self.coefficient(u);
        if *n == ratio(1, 2) {
            return (uk - self.interior(plain(z), plain(z))) * (2 * z).recip();
        }
        let change = n.clone() * self.slope_times(u, z);
        (change - self.over_order(rate(z), plain(u))) * u.recip()
    }

    /// Coefficient of `z = atan2(y, x)`, from `z' (x^2 + y^2) = x y' - y x'`.
    fn angle(&mut self, z: Expr<'g>, y: Expr<'g>, x: Expr<'g>) -> Expr<'g> {
        let norm2 = y.powi(2) + x.powi(2);
        let change = self.slope_times(y, x) - self.slope_times(x, y);
        (change - self.over_order(rate(z), plain(norm2))) * norm2.recip()
    }

    /// Coefficient of order `k` of the function whose derivative is `u' v`.
    fn slope_times(&mut self, u: Expr<'g>, v: Expr<'g>) -> Expr<'g> {
        self.over_order(rate(u), plain(v)) + v * self.coefficient(u)
    }

    fn over_order(&mut self, left: Side<'g>, right: Side<'g>) -> Expr<'g> {
        self.symbols.over_order * self.interior(left, right)
    }

    /// Interior sum over `j = 1 .. k - 1`. Constant factors are moved in front of it, so that multiples share one slot.
    pub(super) fn interior(&mut self, left: Side<'g>, right: Side<'g>) -> Expr<'g> {
        if self.is_still(left.value) || self.is_still(right.value) {
            return self.graph.zero();
        }
        let ((p, u), (q, v)) = (scaled(left.value), scaled(right.value));
        let slot = Slot {
            left: Side { value: u, ..left },
            right: Side { value: v, ..right },
        };
        let n = *self.known.entry(slot).or_insert(self.slots.len());
        if n == self.slots.len() {
            self.slots.push(slot);
        }
        let sum = Symbols::of_list(self.graph, &mut self.symbols.sums, "sum", n);
        (p * q) * sum
    }
}

/// Factor with the coefficients of the series itself.
pub(super) fn plain(value: Expr<'_>) -> Side<'_> {
    Side { value, weighted: false }
}

/// Factor with the coefficients of the derivative.
fn rate(value: Expr<'_>) -> Side<'_> {
    Side { value, weighted: true }
}

/// Splits an expression into a constant factor and the remaining factor.
fn scaled(x: Expr<'_>) -> (Expr<'_>, Expr<'_>) {
    let is_constant = |x: Expr<'_>| x.level() < Level::State;
    let one = x.graph().one();
    if is_constant(x) {
        return (x, one);
    }
    let (factor, rest) = match x.node() {
        Node::Unary(Unary::Neg, rest) => (x.graph().integer(-1), rest),
        Node::Binary(Binary::Mul, factor, rest) | Node::Binary(Binary::Mul, rest, factor) if is_constant(factor) => {
            (factor, rest)
        }
        Node::Binary(Binary::Div, rest, divisor) if is_constant(divisor) => (divisor.recip(), rest),
        Node::Binary(Binary::Div, factor, divisor) if is_constant(factor) && factor != one => (factor, divisor.recip()),
        _ => return (one, x),
    };
    let (inner, rest) = scaled(rest);
    (factor * inner, rest)
}

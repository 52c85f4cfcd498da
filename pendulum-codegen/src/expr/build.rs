//! Smart constructors: each operation is simplified where this is always valid and never longer.

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Binary, Expr, Graph, MOST_BITS, Node, Rational, Unary, add, is_low, is_short, multiply, ratio};

impl Graph {
    /// An exact number.
    pub fn number(&self, value: Rational) -> Expr<'_> {
        self.intern(Node::Number(value))
    }

    /// An integer.
    pub fn integer(&self, value: i64) -> Expr<'_> {
        self.number(Rational::from_integer(value.into()))
    }

    /// The number 0.
    pub fn zero(&self) -> Expr<'_> {
        self.integer(0)
    }

    /// The number 1.
    pub fn one(&self) -> Expr<'_> {
        self.integer(1)
    }

    /// The constant pi.
    pub fn pi(&self) -> Expr<'_> {
        self.intern(Node::Pi)
    }
}

impl<'g> Expr<'g> {
    /// An operation of one operand.
    #[must_use]
    pub fn apply(self, op: Unary) -> Self {
        match op {
            Unary::Neg => self.negated(),
            Unary::Sin | Unary::Cos => self.sine_or_cosine(op),
            Unary::Tan | Unary::Tanh if self.is_zero() => self,
            Unary::Exp if self.is_zero() => self.graph().one(),
            Unary::Ln if self.is_one() => self.graph().zero(),
            Unary::Abs if self.as_number().is_some_and(Signed::is_negative) => -self,
            Unary::Abs if self.as_number().is_some() => self,
            _ => self.unary_node(op),
        }
    }

    /// An operation of two operands.
    #[must_use]
    pub fn combine(self, op: Binary, other: Self) -> Self {
        match op {
            Binary::Add => self.plus(other),
            Binary::Sub => self.minus(other),
            Binary::Mul => self.times(other),
            Binary::Div => self.over(other),
            Binary::Atan2 => self.exactly(op, other),
            Binary::Max | Binary::Min => self.extreme(op, other),
        }
    }

    /// The larger or the smaller of two values.
    fn extreme(self, op: Binary, other: Self) -> Self {
        match (self.as_number(), other.as_number()) {
            _ if self == other => self,
            (Some(a), Some(b)) => {
                if (a < b) == (op == Binary::Max) {
                    other
                } else {
                    self
                }
            }
            _ => self.exactly(op, other),
        }
    }

    /// An operation exactly as given, without simplification: for passes that have chosen the order of operations.
    pub(crate) fn exactly(self, op: Binary, other: Self) -> Self {
        self.graph().intern(Node::Binary(op, self.id(), other.id()))
    }

    /// The negation exactly as given, without simplification.
    pub(crate) fn exactly_negated(self) -> Self {
        self.unary_node(Unary::Neg)
    }

    fn unary_node(self, op: Unary) -> Self {
        self.graph().intern(Node::Unary(op, self.id()))
    }

    pub(super) fn negated(self) -> Self {
        match self.node() {
            Node::Number(n) => self.graph().number(-n),
            Node::Unary(Unary::Neg, y) => y,
            Node::Binary(Binary::Sub, a, b) => b - a,
            _ => self.exactly_negated(),
        }
    }

    fn plus(self, other: Self) -> Self {
        match (self.as_number(), other.as_number()) {
            (Some(x), _) if x.is_zero() => return other,
            (_, Some(y)) if y.is_zero() => return self,
            (Some(x), Some(y)) if let Some(sum) = short(add(x, y)) => return self.graph().number(sum),
            _ => {}
        }
        match (self.as_negated(), other.as_negated()) {
            (Some(x), Some(y)) => -(x + y),
            (None, Some(y)) => self - y,
            (Some(x), None) => other - x,
            (None, None) if self == other => 2 * self,
            (None, None) => self.min(other).exactly(Binary::Add, self.max(other)),
        }
    }

    fn minus(self, other: Self) -> Self {
        if self == other {
            return self.graph().zero();
        }
        match (self.as_number(), other.as_number()) {
            (Some(x), _) if x.is_zero() => return -other,
            (_, Some(y)) if y.is_zero() => return self,
            (Some(x), Some(y)) if let Some(difference) = short(add(x, &-y)) => return self.graph().number(difference),
            _ => {}
        }
        match (self.as_negated(), other.as_negated()) {
            (Some(x), Some(y)) => y - x,
            (None, Some(y)) => self + y,
            (Some(x), None) => -(x + other),
            (None, None) => self.exactly(Binary::Sub, other),
        }
    }

    fn times(self, other: Self) -> Self {
        let graph = self.graph();
        if let (Some(x), Some(y)) = (self.as_number(), other.as_number())
            && let Some(product) = short(multiply(x, y))
        {
            return graph.number(product);
        }
        for (x, y) in [(self, other), (other, self)] {
            if let Some(number) = x.as_number() {
                if number.is_zero() {
                    return x;
                }
                if number.is_one() {
                    return y;
                }
                if number.is_negative() {
                    return -(-number * y);
                }
                // a number times a number times an expression
                if let Node::Binary(Binary::Mul, u, v) = y.node()
                    && let Some(inner) = u.as_number()
                    && let Some(product) = short(number * inner)
                {
                    return product * v;
                }
            }
            if let Some(positive) = x.as_negated() {
                return -(positive * y);
            }
        }
        if self.base() == other.base() {
            let exponent = self.exponent() + other.exponent();
            if is_low(&exponent) {
                return self.base().power(exponent);
            }
        }
        // numbers first, whatever their ids
        let (a, b) = match (self.as_number().is_some(), other.as_number().is_some()) {
            (true, _) => (self, other),
            (_, true) => (other, self),
            _ => (self.min(other), self.max(other)),
        };
        a.exactly(Binary::Mul, b)
    }

    /// The base, if it is a power, or else the expression itself.
    fn base(self) -> Self {
        match self.node() {
            Node::Power(base, _) => base,
            _ => self,
        }
    }

    /// The exponent of the base.
    fn exponent(self) -> Rational {
        match self.node() {
            Node::Power(_, exponent) => exponent.clone(),
            _ => Rational::one(),
        }
    }

    /// The quotient. Division by the number zero is not simplified, so that it shows as a non-finite value.
    fn over(self, other: Self) -> Self {
        if let Some(divisor) = other.as_number()
            && !divisor.is_zero()
        {
            return divisor.recip() * self;
        }
        if self.is_zero() && !other.is_zero() {
            return self;
        }
        if self == other && !other.is_zero() {
            return self.graph().one();
        }
        match (self.as_negated(), other.as_negated()) {
            (Some(x), Some(y)) => x / y,
            (Some(x), None) => -(x / other),
            (None, Some(y)) => -(self / y),
            (None, None) => self.exactly(Binary::Div, other),
        }
    }

    /// A constant power.
    #[must_use]
    pub fn power(self, exponent: Rational) -> Self {
        let graph = self.graph();
        if exponent.is_zero() || self.is_one() {
            return graph.one();
        }
        if exponent.is_one() {
            return self;
        }
        if let (Some(base), true) = (self.as_number(), exponent.is_integer()) {
            if let Some(n) = exponent.to_i32()
                && u64::from(n.unsigned_abs()) * (base.numer().bits() + base.denom().bits()) <= MOST_BITS
                && !base.is_zero()
            {
                return graph.number(num_traits::Pow::pow(base, n));
            }
            if base.is_zero() && exponent.is_positive() {
                return self;
            }
        }
        if let Some(root) = self
            .as_number()
            .filter(|_| exponent.denom() == &2.into())
            .and_then(exact_sqrt)
        {
            return graph.number(root).power(exponent * ratio(2, 1));
        }
        if let (Some(positive), true) = (self.as_negated(), exponent.is_integer()) {
            let odd = (exponent.to_integer() % 2i32) != 0.into();
            let power = positive.power(exponent);
            return if odd { -power } else { power };
        }
        if let (Node::Power(base, inner), true) = (self.node(), exponent.is_integer())
            && is_low(&(inner * &exponent))
        {
            return base.power(inner * exponent);
        }
        graph.intern(Node::Power(self.id(), exponent))
    }

    fn sine_or_cosine(self, op: Unary) -> Self {
        if let Some(turns) = self.multiple_of_pi()
            && let Some(value) = self.graph().exact_sine_or_cosine(op, &turns)
        {
            return value;
        }
        let opposite = match self.node() {
            Node::Unary(Unary::Neg, y) => Some(y),
            // a - b and b - a share one sine and cosine
            Node::Binary(Binary::Sub, a, b) if a > b => Some(b - a),
            _ => None,
        };
        match (op, opposite) {
            (Unary::Cos, Some(y)) => y.unary_node(Unary::Cos),
            (_, Some(y)) => -y.unary_node(Unary::Sin),
            (_, None) => self.unary_node(op),
        }
    }

    /// Returns `k` if the expression is `k pi`.
    fn multiple_of_pi(self) -> Option<Rational> {
        match self.node() {
            Node::Number(n) if n.is_zero() => Some(n.clone()),
            Node::Pi => Some(ratio(1, 1)),
            Node::Unary(Unary::Neg, y) => y.multiple_of_pi().map(|k| -k),
            Node::Binary(Binary::Mul, a, b) if matches!(b.node(), Node::Pi) => a.as_number().cloned(),
            _ => None,
        }
    }
}

impl Graph {
    /// Exact sine and cosine of multiples of 30 and 45 degrees, whose values are square roots of rationals.
    fn exact_sine_or_cosine(&self, op: Unary, turns: &Rational) -> Option<Expr<'_>> {
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
        let value = self.number(ratio(four_times_square, 4)).sqrt();
        Some(if negative { -value } else { value })
    }
}

/// Returns the number, unless it is too long for exact arithmetic.
fn short(x: Rational) -> Option<Rational> {
    is_short(&x).then_some(x)
}

fn exact_sqrt(x: &Rational) -> Option<Rational> {
    if x.is_negative() {
        return None;
    }
    let (n, d) = (x.numer().sqrt(), x.denom().sqrt());
    (&n * &n == *x.numer() && &d * &d == *x.denom()).then(|| Rational::new(n, d))
}

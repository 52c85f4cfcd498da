//! Smart constructors: every operation is simplified where that is always right and never longer.

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Binary, ExprId, Graph, Node, Rational, Unary, ratio};

impl Graph {
    /// An exact number.
    pub fn number(&self, value: Rational) -> ExprId {
        self.intern(Node::Number(value))
    }

    /// An integer.
    pub fn integer(&self, value: i64) -> ExprId {
        self.number(ratio(value, 1))
    }

    /// The number 0.
    pub fn zero(&self) -> ExprId {
        self.integer(0)
    }

    /// The number 1.
    pub fn one(&self) -> ExprId {
        self.integer(1)
    }

    /// The constant pi.
    pub fn pi(&self) -> ExprId {
        self.intern(Node::Pi)
    }

    /// The opposite of `x`.
    pub fn neg(&self, x: ExprId) -> ExprId {
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
    pub fn add(&self, a: ExprId, b: ExprId) -> ExprId {
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
    pub fn sub(&self, a: ExprId, b: ExprId) -> ExprId {
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
    pub fn mul(&self, a: ExprId, b: ExprId) -> ExprId {
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
    pub fn div(&self, a: ExprId, b: ExprId) -> ExprId {
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
    pub fn powi(&self, x: ExprId, exponent: i64) -> ExprId {
        self.power(x, ratio(exponent, 1))
    }

    /// The square root of `x`.
    pub fn sqrt(&self, x: ExprId) -> ExprId {
        self.power(x, ratio(1, 2))
    }

    /// `x^exponent` with a constant exponent.
    pub fn power(&self, x: ExprId, exponent: Rational) -> ExprId {
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

    /// `numerator / (x^2 + y^2)`.
    pub fn over_norm_squared(&self, numerator: ExprId, x: ExprId, y: ExprId) -> ExprId {
        let (x2, y2) = (self.powi(x, 2), self.powi(y, 2));
        let norm2 = self.add(x2, y2);
        self.div(numerator, norm2)
    }

    /// An operation of one operand.
    pub fn unary(&self, op: Unary, x: ExprId) -> ExprId {
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
    pub fn binary(&self, op: Binary, a: ExprId, b: ExprId) -> ExprId {
        match op {
            Binary::Add => self.add(a, b),
            Binary::Sub => self.sub(a, b),
            Binary::Mul => self.mul(a, b),
            Binary::Div => self.div(a, b),
            Binary::Atan2 => self.intern(Node::Binary(op, a, b)),
        }
    }

    fn sine_or_cosine(&self, op: Unary, x: ExprId) -> ExprId {
        if let Some(turns) = self.multiple_of_pi(x)
            && let Some(value) = self.exact_sine_or_cosine(op, &turns)
        {
            return value;
        }
        let opposite = match *self.node(x) {
            Node::Unary(Unary::Neg, y) => Some(y),
            // a - b and b - a have one sine and cosine between them
            Node::Binary(Binary::Sub, a, b) if a > b => Some(self.sub(b, a)),
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
    fn exact_sine_or_cosine(&self, op: Unary, turns: &Rational) -> Option<ExprId> {
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

//! One row per operation: spelling, value, derivative, cost. Every other file reads the rows.

use super::{ExprId, Graph};

/// How an operation is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CostKind {
    /// An addition, subtraction or negation.
    Addition,
    /// A multiplication.
    Multiplication,
    /// A division.
    Division,
    /// A sine or a cosine; the two of one angle are a pair and count once.
    Sincos,
    /// Any other function call.
    Function,
}

macro_rules! unary {
    ($($(#[$doc:meta])* $name:ident: $spelling:literal, $cost:ident, $value:expr, $derivative:expr;)*) => {
        /// An operation of one operand.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Unary { $($(#[$doc])* $name),* }

        impl Unary {
            /// Every operation of one operand.
            pub const ALL: &[Unary] = &[$(Unary::$name),*];

            /// The name in declarations, in printed equations and as a method of the emitted number type.
            pub fn spelling(self) -> &'static str {
                match self { $(Unary::$name => $spelling),* }
            }

            /// How the operation is counted.
            pub fn cost(self) -> CostKind {
                match self { $(Unary::$name => CostKind::$cost),* }
            }

            /// The value in double precision.
            pub fn value(self, x: f64) -> f64 {
                let value: fn(f64) -> f64 = match self { $(Unary::$name => $value),* };
                value(x)
            }

            /// The derivative at `x`.
            pub fn derivative(self, graph: &Graph, x: ExprId) -> ExprId {
                let derivative: fn(&Graph, ExprId) -> ExprId = match self { $(Unary::$name => $derivative),* };
                derivative(graph, x)
            }
        }
    };
}

unary! {
    /// The opposite.
    Neg: "-", Addition, |x| -x, |g, _| g.integer(-1);
    /// The sine of an angle in radians.
    Sin: "sin", Sincos, f64::sin, |g, x| g.unary(Unary::Cos, x);
    /// The cosine of an angle in radians.
    Cos: "cos", Sincos, f64::cos, |g, x| { let s = g.unary(Unary::Sin, x); g.neg(s) };
    /// The tangent of an angle in radians.
    Tan: "tan", Function, f64::tan, |g, x| { let t = g.unary(Unary::Tan, x); let t2 = g.powi(t, 2); let one = g.one(); g.add(one, t2) };
    /// The natural exponential.
    Exp: "exp", Function, f64::exp, |g, x| g.unary(Unary::Exp, x);
    /// The natural logarithm.
    Ln: "ln", Function, f64::ln, |g, x| g.powi(x, -1);
    /// The hyperbolic tangent.
    Tanh: "tanh", Function, f64::tanh, |g, x| { let t = g.unary(Unary::Tanh, x); let t2 = g.powi(t, 2); let one = g.one(); g.sub(one, t2) };
    /// The absolute value.
    Abs: "abs", Function, f64::abs, |g, x| g.unary(Unary::Sign, x);
    /// The sign: -1, 0 or 1.
    Sign: "signum", Function, |x| if x == 0.0 { 0.0 } else { x.signum() }, |g, _| g.zero();
}

macro_rules! binary {
    ($($(#[$doc:meta])* $name:ident: $spelling:literal, $cost:ident, $value:expr, $left:expr, $right:expr;)*) => {
        /// An operation of two operands.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Binary { $($(#[$doc])* $name),* }

        impl Binary {
            /// The operator or the name of the function.
            pub fn spelling(self) -> &'static str {
                match self { $(Binary::$name => $spelling),* }
            }

            /// How the operation is counted.
            pub fn cost(self) -> CostKind {
                match self { $(Binary::$name => CostKind::$cost),* }
            }

            /// The value in double precision.
            pub fn value(self, a: f64, b: f64) -> f64 {
                let value: fn(f64, f64) -> f64 = match self { $(Binary::$name => $value),* };
                value(a, b)
            }

            /// The partial derivatives by the left and by the right operand.
            pub fn derivatives(self, graph: &Graph, a: ExprId, b: ExprId) -> [ExprId; 2] {
                type Partial = fn(&Graph, ExprId, ExprId) -> ExprId;
                let (left, right): (Partial, Partial) = match self { $(Binary::$name => ($left, $right)),* };
                [left(graph, a, b), right(graph, a, b)]
            }
        }
    };
}

binary! {
    /// Sum.
    Add: "+", Addition, |a, b| a + b, |g, _, _| g.one(), |g, _, _| g.one();
    /// Difference.
    Sub: "-", Addition, |a, b| a - b, |g, _, _| g.one(), |g, _, _| g.integer(-1);
    /// Product.
    Mul: "*", Multiplication, |a, b| a * b, |_, _, b| b, |_, a, _| a;
    /// Quotient.
    Div: "/", Division, |a, b| a / b, |g, _, b| g.powi(b, -1), |g, a, b| { let d = g.powi(b, -2); let n = g.neg(a); g.mul(n, d) };
    /// The angle of the point (right, left), as `left.atan2(right)`.
    Atan2: "atan2", Function, f64::atan2, |g, y, x| g.over_norm_squared(x, y, x), |g, y, x| { let n = g.neg(y); g.over_norm_squared(n, y, x) };
}

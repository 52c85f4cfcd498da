//! One row per operation: spelling, value, derivative, cost. Every other file takes them from here.

use super::Expr;

/// Class of an operation in operation counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CostKind {
    /// An addition, subtraction or negation.
    Addition,
    /// A multiplication.
    Multiplication,
    /// A division.
    Division,
    /// A sine or a cosine; both of one angle are a pair and count once.
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

            /// Class of the operation in operation counts.
            pub fn cost(self) -> CostKind {
                match self { $(Unary::$name => CostKind::$cost),* }
            }

            /// The value in double precision.
            pub fn value(self, x: f64) -> f64 {
                let value: fn(f64) -> f64 = match self { $(Unary::$name => $value),* };
                value(x)
            }

            /// The derivative at `x`.
            pub fn derivative(self, x: Expr<'_>) -> Expr<'_> {
                let derivative: fn(Expr<'_>) -> Expr<'_> = match self { $(Unary::$name => $derivative),* };
                derivative(x)
            }
        }
    };
}

unary! {
    /// The negation.
    Neg: "-", Addition, |x| -x, |x| x.graph().integer(-1);
    /// The sine of an angle in radians.
    Sin: "sin", Sincos, f64::sin, |x| x.cos();
    /// The cosine of an angle in radians.
    Cos: "cos", Sincos, f64::cos, |x| -x.sin();
    /// The tangent of an angle in radians.
    Tan: "tan", Function, f64::tan, |x| 1 + x.apply(Unary::Tan).powi(2);
    /// The natural exponential.
    Exp: "exp", Function, f64::exp, |x| x.apply(Unary::Exp);
    /// The natural logarithm.
    Ln: "ln", Function, f64::ln, |x| x.powi(-1);
    /// The hyperbolic tangent.
    Tanh: "tanh", Function, f64::tanh, |x| 1 - x.apply(Unary::Tanh).powi(2);
    /// The absolute value.
    Abs: "abs", Function, f64::abs, |x| x.apply(Unary::Sign);
    /// The sign: -1, 0 or 1.
    Sign: "signum", Function, |x| if x == 0.0 { 0.0 } else { x.signum() }, |x| x.graph().zero();
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

            /// Class of the operation in operation counts.
            pub fn cost(self) -> CostKind {
                match self { $(Binary::$name => CostKind::$cost),* }
            }

            /// The value in double precision.
            pub fn value(self, a: f64, b: f64) -> f64 {
                let value: fn(f64, f64) -> f64 = match self { $(Binary::$name => $value),* };
                value(a, b)
            }

            /// Partial derivatives with respect to the left and the right operand.
            pub fn derivatives<'g>(self, a: Expr<'g>, b: Expr<'g>) -> [Expr<'g>; 2] {
                type Partial = for<'g> fn(Expr<'g>, Expr<'g>) -> Expr<'g>;
                let (left, right): (Partial, Partial) = match self { $(Binary::$name => ($left, $right)),* };
                [left(a, b), right(a, b)]
            }
        }
    };
}

binary! {
    /// Sum.
    Add: "+", Addition, |a, b| a + b, |a, _| a.graph().one(), |a, _| a.graph().one();
    /// Difference.
    Sub: "-", Addition, |a, b| a - b, |a, _| a.graph().one(), |a, _| a.graph().integer(-1);
    /// Product.
    Mul: "*", Multiplication, |a, b| a * b, |_, b| b, |a, _| a;
    /// Quotient.
    Div: "/", Division, |a, b| a / b, |_, b| b.powi(-1), |a, b| -a * b.powi(-2);
    /// The angle of the point (right, left), `left.atan2(right)`.
    Atan2: "atan2", Function, f64::atan2, |y, x| x / (y.powi(2) + x.powi(2)), |y, x| -y / (y.powi(2) + x.powi(2));
    /// The larger of two; the left operand if they are equal, or if it is NaN.
    Max: "max", Function, |a, b| if a < b { b } else { a }, over, |a, b| over(b, a);
    /// The smaller of two; the left operand if they are equal, or if it is NaN.
    Min: "min", Function, |a, b| if a > b { b } else { a }, |a, b| over(b, a), over;
}

/// Derivative of the larger of two with respect to `a`: 1 if `a` is larger, 0 if `b` is larger, 1/2 if they are equal.
pub(crate) fn over<'g>(a: Expr<'g>, b: Expr<'g>) -> Expr<'g> {
    super::ratio(1, 2) * (1 + (a - b).apply(Unary::Sign))
}

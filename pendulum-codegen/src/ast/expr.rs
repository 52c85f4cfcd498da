//! Expressions and vectors.

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use syn::Ident;

use crate::expr::Rational;
use crate::units::Unit;

/// A part of the text, or why it cannot be read. The error is reported when lowering comes to it, in line with others
/// of the body.
pub(crate) type Read<T> = syn::Result<T>;

/// Three components.
#[derive(Debug)]
pub(crate) struct Vector {
    /// The components.
    pub components: [Expr; 3],
    /// The text.
    pub tokens: TokenStream,
}

/// An expression with its text.
#[derive(Debug)]
pub(crate) struct Expr {
    /// The outermost operation.
    pub kind: ExprKind,
    /// The text.
    pub tokens: TokenStream,
}

/// An operation of the language of expressions.
#[derive(Debug)]
pub(crate) enum ExprKind {
    /// A number, exactly.
    Number(Rational),
    /// `90 deg`.
    Measured(Box<Measured>),
    /// A name.
    Name(Ident),
    /// `point.x`: a point, an orientation or a position, and the word behind the dot.
    Component(Ident, Ident),
    /// `dot(orientation).x`, likewise.
    RateComponent(Ident, Ident),
    /// `function(arguments)`.
    Call(Ident, Vec<Expr>),
    /// `-a`.
    Neg(Box<Expr>),
    /// `a + b` and so on.
    Binary(Operator, Box<Expr>, Box<Expr>),
    /// `a^b`.
    Power(Box<Expr>, Box<Expr>),
}

/// A number with a unit.
#[derive(Debug)]
pub(crate) struct Measured {
    /// The number as it is written.
    pub digits: String,
    /// The number, exactly, in that unit.
    pub number: Rational,
    /// The unit.
    pub unit: Unit,
}

/// As it is written.
impl std::fmt::Display for Measured {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.digits, self.unit.text)
    }
}

/// An operator between two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operator {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
}

impl Expr {
    /// Whether an operation, or one of some names, stands in the expression.
    pub(super) fn uses(&self, names: &[&Ident], operation: &impl Fn(&ExprKind) -> bool) -> bool {
        let of = |e: &Self| e.uses(names, operation);
        let in_parts = match &self.kind {
            ExprKind::Name(name) => names.contains(&name),
            ExprKind::Call(_, arguments) => arguments.iter().any(of),
            ExprKind::Neg(a) => of(a),
            ExprKind::Binary(_, a, b) | ExprKind::Power(a, b) => of(a) || of(b),
            ExprKind::Number(_) | ExprKind::Measured(..) | ExprKind::Component(..) | ExprKind::RateComponent(..) => {
                false
            }
        };
        in_parts || operation(&self.kind)
    }
}

impl ToTokens for Expr {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.tokens.to_tokens(tokens);
    }
}

impl ToTokens for Vector {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.tokens.to_tokens(tokens);
    }
}

impl Expr {
    /// Where the expression begins.
    pub(crate) fn span(&self) -> Span {
        self.tokens
            .clone()
            .into_iter()
            .next()
            .map_or_else(Span::call_site, |token| token.span())
    }
}

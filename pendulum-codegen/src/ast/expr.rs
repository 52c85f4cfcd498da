//! Expressions and vectors.

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use syn::Ident;

use crate::expr::Rational;
use crate::units::Unit;

/// A parsed part of the declaration, or a syntax error in it. Lowering reports the error when it reaches this part, in
/// order with the other errors of the body.
pub(crate) type Read<T> = syn::Result<T>;

/// Vector of three components.
#[derive(Debug)]
pub(crate) struct Vector {
    pub components: [Expr; 3],
    /// Source text.
    pub tokens: TokenStream,
}

/// Expression with its source text.
#[derive(Debug)]
pub(crate) struct Expr {
    /// Outermost operation.
    pub kind: ExprKind,
    /// Source text.
    pub tokens: TokenStream,
}

/// An operation of the expression language.
#[derive(Debug)]
pub(crate) enum ExprKind {
    /// An exact number.
    Number(Rational),
    /// `90 deg`.
    Measured(Box<Measured>),
    /// A name.
    Name(Ident),
    /// `point.x`: the name of a point, orientation or position, and of its component.
    Component(Ident, Ident),
    /// `dot(orientation).x`: name and component as in `Component`.
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

/// Number with a unit.
#[derive(Debug)]
pub(crate) struct Measured {
    /// Digits as written.
    pub digits: String,
    /// Exact value in `unit`.
    pub number: Rational,
    pub unit: Unit,
}

/// Formats the number and its unit as written.
impl std::fmt::Display for Measured {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.digits, self.unit.text)
    }
}

/// Binary operator.
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
    /// True if the expression contains one of the names, or an operation for which `operation` holds.
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
    /// Returns the span of the first token.
    pub(crate) fn span(&self) -> Span {
        self.tokens
            .clone()
            .into_iter()
            .next()
            .map_or_else(Span::call_site, |token| token.span())
    }
}

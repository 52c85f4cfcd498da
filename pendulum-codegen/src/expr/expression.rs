//! Expressions as values with arithmetic operators.

use std::fmt;
use std::hash::{Hash, Hasher};

use super::{ExprId, Graph, Level, Node, Rational, Symbol, Unary, ratio};

/// An expression of a graph. Its operators and functions build other expressions of the same graph, simplified where
/// this is always valid and never longer.
///
/// Two expressions are equal exactly when they are the same node. They are ordered by the time they were built.
#[derive(Clone, Copy)]
pub struct Expr<'g> {
    graph: &'g Graph,
    id: ExprId,
}

impl<'g> Expr<'g> {
    pub(super) fn new(graph: &'g Graph, id: ExprId) -> Self {
        Self { graph, id }
    }

    /// Graph of the expression.
    pub fn graph(self) -> &'g Graph {
        self.graph
    }

    /// Id of the node.
    pub fn id(self) -> ExprId {
        self.id
    }

    /// Operation of the expression, with its operands as expressions.
    pub fn node(self) -> Node<Expr<'g>, &'g Rational> {
        let operand = |&id: &ExprId| self.graph.expr(id);
        match self.graph.node(self.id) {
            Node::Number(n) => Node::Number(n),
            Node::Pi => Node::Pi,
            Node::Symbol(s) => Node::Symbol(*s),
            Node::Unary(op, a) => Node::Unary(*op, operand(a)),
            Node::Binary(op, a, b) => Node::Binary(*op, operand(a), operand(b)),
            Node::Power(a, n) => Node::Power(operand(a), n),
        }
    }

    /// The operands, in order.
    pub fn operands(self) -> impl Iterator<Item = Self> + use<'g> {
        self.graph.operands(self.id).map(move |id| self.graph.expr(id))
    }

    /// Highest level of the symbols that it depends on.
    pub fn level(self) -> Level {
        self.graph.level(self.id)
    }

    /// Value, if it is a number.
    pub fn as_number(self) -> Option<&'g Rational> {
        self.graph.as_number(self.id)
    }

    /// Symbol, if it is one.
    pub fn as_symbol(self) -> Option<&'g Symbol> {
        self.graph.as_symbol(self.id)
    }

    /// Operand, if it is a negation.
    pub(super) fn as_negated(self) -> Option<Self> {
        match self.node() {
            Node::Unary(Unary::Neg, y) => Some(y),
            _ => None,
        }
    }

    /// True if it is the number 0. To test whether its value is zero, use the normal form.
    pub fn is_zero(self) -> bool {
        self.graph.is_zero(self.id)
    }

    /// True if it is the number 1.
    pub fn is_one(self) -> bool {
        self.graph.is_one(self.id)
    }

    /// Value in double precision, if it depends on no symbol.
    pub fn constant(self) -> Option<f64> {
        self.graph.constant(self.id)
    }

    /// The sine.
    #[must_use]
    pub fn sin(self) -> Self {
        self.apply(Unary::Sin)
    }

    /// The cosine.
    #[must_use]
    pub fn cos(self) -> Self {
        self.apply(Unary::Cos)
    }

    /// The integer power.
    #[must_use]
    pub fn powi(self, exponent: i64) -> Self {
        self.power(ratio(exponent, 1))
    }

    /// The square root.
    #[must_use]
    pub fn sqrt(self) -> Self {
        self.power(ratio(1, 2))
    }

    /// Number of operations when written out, with nothing shared; saturates at `u64::MAX`.
    pub fn length(self) -> u64 {
        self.graph.length(self.id)
    }

    /// Nesting depth of the operations.
    pub fn depth(self) -> usize {
        self.graph.depth(self.id)
    }

    /// The reciprocal, as a quotient.
    #[must_use]
    pub fn recip(self) -> Self {
        self.graph.one() / self
    }
}

impl From<Expr<'_>> for ExprId {
    fn from(x: Expr<'_>) -> Self {
        x.id
    }
}

impl PartialEq for Expr<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Eq for Expr<'_> {}

impl PartialOrd for Expr<'_> {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Expr<'_> {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.id.cmp(&other.id)
    }
}

impl Hash for Expr<'_> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.id.hash(state);
    }
}

impl fmt::Debug for Expr<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}", self.id.index())
    }
}

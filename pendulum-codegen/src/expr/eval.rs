//! Values in double precision: for folding constants, for checks and for tests.

use num_traits::ToPrimitive;

use super::{ExprId, Graph, Node, Rational, Symbol};

impl Graph {
    /// Returns the values of `roots`, in order, with the values of the symbols from `value`.
    pub fn evaluate(&self, roots: &[impl Into<ExprId> + Copy], mut value: impl FnMut(&Symbol) -> f64) -> Vec<f64> {
        self.evaluate_at(roots, |_, symbol| value(symbol))
    }

    /// Like [`evaluate`](Self::evaluate), but passes the id of each symbol to `value` too: several symbols may share a
    /// name.
    pub(crate) fn evaluate_at(
        &self,
        roots: &[impl Into<ExprId> + Copy],
        mut value: impl FnMut(ExprId, &Symbol) -> f64,
    ) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.len()];
        for id in self.reachable(roots) {
            values[id.index()] = self.value_of(self.node(id), |x| values[x.index()], |symbol| value(id, symbol));
        }
        roots.iter().map(|&root| values[root.into().index()]).collect()
    }

    /// Value of a node, from the values of its operands.
    pub(super) fn value_of(
        &self,
        node: &Node,
        of: impl Fn(ExprId) -> f64,
        mut symbol: impl FnMut(&Symbol) -> f64,
    ) -> f64 {
        match node {
            Node::Number(n) => nearest_f64(n),
            Node::Pi => std::f64::consts::PI,
            Node::Symbol(s) => symbol(self.name_and_kind(*s)),
            Node::Unary(op, a) => op.value(of(*a)),
            Node::Binary(op, a, b) => op.value(of(*a), of(*b)),
            Node::Power(a, n) => power(of(*a), n),
        }
    }
}

/// The double nearest to `x`.
pub(super) fn nearest_f64(x: &Rational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

fn power(base: f64, exponent: &Rational) -> f64 {
    match (exponent.denom().to_i32(), exponent.numer().to_i32()) {
        (Some(1), Some(n)) => base.powi(n),
        (Some(2), Some(n)) => base.sqrt().powi(n),
        _ => base.powf(nearest_f64(exponent)),
    }
}

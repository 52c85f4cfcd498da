//! Values in double precision: for folding constants, for checks and for tests.

use num_traits::ToPrimitive;

use super::{ExprId, Graph, Node, Rational, Symbol};

impl Graph {
    /// The values of `roots`, in their order, where `value` gives that of each symbol.
    pub fn evaluate(&self, roots: &[impl Into<ExprId> + Copy], mut value: impl FnMut(&Symbol) -> f64) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.len()];
        for id in self.reachable(roots) {
            let of = |x: ExprId| values[x.index()];
            values[id.index()] = match self.node(id) {
                Node::Number(n) => nearest_f64(n),
                Node::Pi => std::f64::consts::PI,
                Node::Symbol(s) => value(self.name_and_kind(*s)),
                Node::Unary(op, a) => op.value(of(*a)),
                Node::Binary(op, a, b) => op.value(of(*a), of(*b)),
                Node::Power(a, n) => power(of(*a), n),
            };
        }
        roots.iter().map(|&root| values[root.into().index()]).collect()
    }

    /// The value of an expression that depends on nothing.
    pub fn constant(&self, id: ExprId) -> Option<f64> {
        match self.node(id) {
            Node::Number(n) => Some(nearest_f64(n)),
            _ => (self.level(id) == super::Level::Constant).then(|| self.evaluate(&[id], |_| f64::NAN)[0]),
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

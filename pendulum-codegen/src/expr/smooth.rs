//! How smooth an expression is.

use rustc_hash::FxHashMap;

use super::{Binary, Expr, Node, Unary};

/// How many derivatives of smooth functions are counted.
const SMOOTH: i64 = 16;

impl Expr<'_> {
    /// How many continuous derivatives an expression is known to have where the state and the time vary: 0 for a corner, as `abs` has
    /// at zero, -1 for a jump, and many for what is smooth wherever it has a value.
    pub(crate) fn continuous_derivatives(self) -> i64 {
        let mut known: FxHashMap<Self, i64> = FxHashMap::default();
        for id in self.graph().reachable(&[self]) {
            let x = self.graph().expr(id);
            let least = x.operands().map(|operand| known[&operand]).min().unwrap_or(SMOOTH);
            let own = match x.node() {
                _ if x.level() < super::Level::State => SMOOTH,
                Node::Unary(Unary::Abs, _) => least.min(0),
                Node::Unary(Unary::Sign, _) => -1,
                // |u| |u| .. u: each factor that vanishes where `abs` has its corner takes the corner up by one
                Node::Binary(Binary::Mul, a, b) if is_abs_of(a, b) || is_abs_of(b, a) => least + 1,
                Node::Power(base, n) if matches!(base.node(), Node::Unary(Unary::Abs, _)) => {
                    let n = n.ceil().to_integer();
                    i64::try_from(n).map_or(SMOOTH, |n| (n - 1).min(SMOOTH))
                }
                _ => least,
            };
            known.insert(x, own);
        }
        known[&self]
    }
}

/// Whether `a` is a power of `|b|`.
fn is_abs_of(a: Expr<'_>, b: Expr<'_>) -> bool {
    match a.node() {
        Node::Unary(Unary::Abs, inner) => inner == b,
        Node::Power(base, _) => matches!(base.node(), Node::Unary(Unary::Abs, inner) if inner == b),
        _ => false,
    }
}

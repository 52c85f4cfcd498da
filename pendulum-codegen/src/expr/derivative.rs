//! Derivatives within the graph.

use rustc_hash::FxHashMap;

use super::{Binary, Expr, Node, Unary};

/// Derivative with respect to one symbol, or along a direction. Results are cached, so that shared subexpressions are
/// differentiated once.
#[derive(Debug)]
pub(crate) struct Derivative<'g> {
    by: Option<Expr<'g>>,
    /// If set, symbols that depend on others are held constant, unless they stand for a sum.
    alone: bool,
    known: FxHashMap<Expr<'g>, Expr<'g>>,
}

impl<'g> Derivative<'g> {
    /// Derivative with respect to the symbol `by`, including the symbols that depend on it.
    pub(crate) fn by(by: Expr<'g>) -> Self {
        Self {
            by: Some(by),
            alone: false,
            known: FxHashMap::default(),
        }
    }

    /// Holds symbols that depend on others constant, unless they stand for a sum.
    #[must_use]
    pub(crate) fn alone(self) -> Self {
        Self { alone: true, ..self }
    }

    /// Derivative along a direction: the sum of the derivatives with respect to some symbols, each times its component.
    pub(crate) fn along(components: impl IntoIterator<Item = (Expr<'g>, Expr<'g>)>) -> Self {
        Self {
            by: None,
            alone: false,
            known: components.into_iter().collect(),
        }
    }

    /// Derivative of `x`.
    pub(crate) fn of(&mut self, x: Expr<'g>) -> Expr<'g> {
        let graph = x.graph();
        if Some(x) == self.by {
            return graph.one();
        }
        if let Some(&known) = self.known.get(&x) {
            return known;
        }
        let derivative = match x.node() {
            Node::Symbol(_) => {
                let changes = graph.changes(x, self.alone).into_iter();
                let terms = changes.map(|(of, factor)| chain(self.of(of), || factor));
                graph.sum(terms.collect::<Vec<_>>())
            }
            Node::Number(_) | Node::Pi => graph.zero(),
            Node::Unary(Unary::Neg, a) => -self.of(a),
            Node::Unary(op, a) => chain(self.of(a), || op.derivative(a)),
            Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => self.of(a).combine(op, self.of(b)),
            Node::Binary(op, a, b) => {
                let (da, db) = (self.of(a), self.of(b));
                if da.is_zero() && db.is_zero() {
                    graph.zero()
                } else {
                    let [left, right] = op.derivatives(a, b);
                    left * da + right * db
                }
            }
            Node::Power(a, n) => chain(self.of(a), || n.clone() * a.power(n - super::ratio(1, 1))),
        };
        self.known.insert(x, derivative);
        derivative
    }
}

/// Chain rule; the derivative of the outer function is formed only if the inner derivative is not zero.
fn chain<'g>(inner: Expr<'g>, outer: impl FnOnce() -> Expr<'g>) -> Expr<'g> {
    if inner.is_zero() { inner } else { outer() * inner }
}

//! Derivatives within the graph.

use rustc_hash::FxHashMap;

use super::{Binary, Expr, Node, Unary};

/// The derivative by one symbol, or along a direction. It remembers what it has derived, so shared parts are derived
/// once.
#[derive(Debug)]
pub(crate) struct Derivative<'g> {
    by: Option<Expr<'g>>,
    /// Whether what depends on others keeps its value.
    alone: bool,
    known: FxHashMap<Expr<'g>, Expr<'g>>,
}

impl<'g> Derivative<'g> {
    /// The derivative by the symbol `by`, on which others may depend.
    pub(crate) fn by(by: Expr<'g>) -> Self {
        Self {
            by: Some(by),
            alone: false,
            known: FxHashMap::default(),
        }
    }

    /// The same, where what depends on others keeps its value.
    #[must_use]
    pub(crate) fn alone(self) -> Self {
        Self { alone: true, ..self }
    }

    /// The derivative along a direction: the sum of the derivatives by some symbols, each times its component.
    pub(crate) fn along(components: impl IntoIterator<Item = (Expr<'g>, Expr<'g>)>) -> Self {
        Self {
            by: None,
            alone: false,
            known: components.into_iter().collect(),
        }
    }

    /// The derivative of `x`.
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

/// The chain rule, where the derivative of the outer function is formed only if the inner one changes.
fn chain<'g>(inner: Expr<'g>, outer: impl FnOnce() -> Expr<'g>) -> Expr<'g> {
    if inner.is_zero() { inner } else { outer() * inner }
}

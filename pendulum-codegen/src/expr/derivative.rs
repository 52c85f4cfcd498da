//! Derivatives within the graph.

use std::collections::HashMap;

use super::{Binary, ExprId, Graph, Node, Unary};

/// The derivative by one symbol, or along a direction. It remembers what it has derived, so shared parts are derived once.
#[derive(Debug)]
pub struct Derivative {
    by: Option<ExprId>,
    known: HashMap<ExprId, ExprId>,
}

impl Derivative {
    /// The derivative by the symbol `by`.
    pub fn by(by: ExprId) -> Self {
        Self {
            by: Some(by),
            known: HashMap::new(),
        }
    }

    /// The derivative along a direction: the sum of the derivatives by some symbols, each times its component.
    pub fn along(components: impl IntoIterator<Item = (ExprId, ExprId)>) -> Self {
        Self {
            by: None,
            known: components.into_iter().collect(),
        }
    }

    /// The derivative of `x`.
    pub fn of(&mut self, graph: &Graph, x: ExprId) -> ExprId {
        if Some(x) == self.by {
            return graph.one();
        }
        if let Some(&known) = self.known.get(&x) {
            return known;
        }
        let derivative = match graph.node(x).clone() {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => graph.zero(),
            Node::Unary(Unary::Neg, a) => {
                let da = self.of(graph, a);
                graph.neg(da)
            }
            Node::Unary(op, a) => {
                let da = self.of(graph, a);
                self.chain(graph, da, |g| op.derivative(g, a))
            }
            Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => {
                let (da, db) = (self.of(graph, a), self.of(graph, b));
                graph.binary(op, da, db)
            }
            Node::Binary(op, a, b) => {
                let (da, db) = (self.of(graph, a), self.of(graph, b));
                if graph.is_zero(da) && graph.is_zero(db) {
                    graph.zero()
                } else {
                    let [left, right] = op.derivatives(graph, a, b);
                    let (left, right) = (graph.mul(left, da), graph.mul(right, db));
                    graph.add(left, right)
                }
            }
            Node::Power(a, n) => {
                let da = self.of(graph, a);
                self.chain(graph, da, |g| {
                    let lower = g.power(a, &n - super::ratio(1, 1));
                    let n = g.number(n);
                    g.mul(n, lower)
                })
            }
        };
        self.known.insert(x, derivative);
        derivative
    }

    fn chain(&self, graph: &Graph, inner: ExprId, outer: impl FnOnce(&Graph) -> ExprId) -> ExprId {
        if graph.is_zero(inner) {
            return inner;
        }
        let outer = outer(graph);
        graph.mul(outer, inner)
    }
}

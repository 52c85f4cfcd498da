//! Derivatives within the graph.

use rustc_hash::FxHashMap;

use super::{Binary, Expr, Graph, Node, Unary};

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

/// Gradient with respect to symbols of a sum of expressions, each with a weight that is held constant: by reverse
/// accumulation, so that its length does not grow with the number of symbols.
///
/// A. Griewank, A. Walther, "Evaluating Derivatives", 2nd ed. (2008), section 3.2.
pub(crate) fn gradient<'g>(terms: &[(Expr<'g>, Expr<'g>)], symbols: &[Expr<'g>]) -> Vec<Expr<'g>> {
    let Some(graph) = terms.first().map(|(x, _)| x.graph()) else {
        return symbols.iter().map(|symbol| symbol.graph().zero()).collect();
    };
    let roots: Vec<Expr<'g>> = terms.iter().map(|&(x, _)| x).collect();
    let order = depending(graph, &roots, symbols);
    // the weights of each expression so far
    let mut weights: FxHashMap<Expr<'g>, Vec<Expr<'g>>> = order.iter().map(|&x| (x, Vec::new())).collect();
    for (x, weight) in terms {
        weights.entry(*x).or_default().push(*weight);
    }
    for &x in order[symbols.len()..].iter().rev() {
        let weight = graph.sum(weights.remove(&x).unwrap_or_default());
        if !weight.is_zero() {
            for (operand, partial) in partials(x) {
                if let Some(weights) = weights.get_mut(&operand) {
                    weights.push(partial * weight);
                }
            }
        }
    }
    let of = |symbol: &Expr<'g>| graph.sum(weights.remove(symbol).unwrap_or_default());
    symbols.iter().map(of).collect()
}

/// The symbols, followed by all expressions within `roots` that depend on them, each after what it depends on.
fn depending<'g>(graph: &'g Graph, roots: &[Expr<'g>], symbols: &[Expr<'g>]) -> Vec<Expr<'g>> {
    let mut depends: FxHashMap<Expr<'g>, bool> = symbols.iter().map(|&symbol| (symbol, true)).collect();
    let mut order = symbols.to_vec();
    let mut stack = roots.to_vec();
    while let Some(&x) = stack.last() {
        if depends.contains_key(&x) {
            stack.pop();
            continue;
        }
        let operands: Vec<Expr<'g>> = match x.node() {
            Node::Symbol(_) => graph.changes(x, false).into_iter().map(|(of, _)| of).collect(),
            _ => x.operands().collect(),
        };
        let before = stack.len();
        stack.extend(operands.iter().filter(|operand| !depends.contains_key(operand)));
        if stack.len() == before {
            stack.pop();
            let own = operands.iter().any(|operand| depends[operand]);
            depends.insert(x, own);
            order.extend(own.then_some(x));
        }
    }
    order
}

/// Expressions that an expression depends on directly, each with the partial derivative.
fn partials<'g>(x: Expr<'g>) -> Vec<(Expr<'g>, Expr<'g>)> {
    match x.node() {
        Node::Symbol(_) => x.graph().changes(x, false),
        Node::Number(_) | Node::Pi => Vec::new(),
        Node::Unary(op, a) => vec![(a, op.derivative(a))],
        Node::Binary(op, a, b) => [a, b].into_iter().zip(op.derivatives(a, b)).collect(),
        Node::Power(a, n) => vec![(a, n.clone() * a.power(n - super::ratio(1, 1)))],
    }
}

/// Chain rule; the derivative of the outer function is formed only if the inner derivative is not zero.
fn chain<'g>(inner: Expr<'g>, outer: impl FnOnce() -> Expr<'g>) -> Expr<'g> {
    if inner.is_zero() { inner } else { outer() * inner }
}

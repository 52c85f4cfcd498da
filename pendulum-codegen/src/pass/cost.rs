//! Operation counts.

use std::collections::BTreeSet;

use num_traits::{Signed, ToPrimitive};

use crate::expr::{CostKind, Expr, ExprId, Graph, Level, Node, Unary};

/// Number of operations of one evaluation. Expressions of parameters alone are computed when the model is built, and
/// are not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions, subtractions and negations.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Angles whose sine, cosine or both are computed.
    pub sincos: usize,
    /// Other functions, square roots included.
    pub functions: usize,
    /// Length of the longest chain of dependent operations, in additions: a division counts 4, a sine-cosine pair 20,
    /// another function 10.
    pub chain: usize,
}

impl Operations {
    /// Counts the operations that the roots need, each shared one once.
    pub fn of<'g>(g: &'g Graph, roots: &[Expr<'g>]) -> Self {
        let mut operations = Self::default();
        let mut angles = BTreeSet::new();
        let reachable = g.reachable(roots);
        for &id in &reachable {
            if g.level(id) < Level::State {
                continue;
            }
            let kind = match g.node(id) {
                Node::Number(_) | Node::Pi | Node::Symbol(_) => continue,
                Node::Unary(Unary::Sin | Unary::Cos, angle) => {
                    angles.insert(*angle);
                    continue;
                }
                Node::Unary(op, _) => op.cost(),
                Node::Binary(op, ..) => op.cost(),
                Node::Power(_, n) if n.is_integer() => {
                    // written out as a product
                    let factors = n.abs().to_integer().to_usize().unwrap_or(usize::MAX);
                    operations.multiplications += factors.saturating_sub(1);
                    operations.divisions += usize::from(n.is_negative());
                    continue;
                }
                Node::Power(..) => CostKind::Function,
            };
            match kind {
                CostKind::Addition => operations.additions += 1,
                CostKind::Multiplication => operations.multiplications += 1,
                CostKind::Division => operations.divisions += 1,
                CostKind::Sincos | CostKind::Function => operations.functions += 1,
            }
        }
        operations.sincos = angles.len();
        operations.chain = chain(g, &reachable, roots);
        operations
    }

    /// Adds operations that take place `count` times side by side, after these.
    #[must_use]
    pub(crate) fn followed_by(self, count: usize, other: Self) -> Self {
        Self {
            additions: self.additions + count * other.additions,
            multiplications: self.multiplications + count * other.multiplications,
            divisions: self.divisions + count * other.divisions,
            sincos: self.sincos + count * other.sincos,
            functions: self.functions + count * other.functions,
            chain: self.chain + other.chain,
        }
    }

    /// Estimated time of an evaluation, in multiples of one addition among many independent ones. Forms of the same
    /// function are compared by it.
    ///
    /// Work is limited by throughput and a chain of dependent operations by latency; the smaller of the two hides
    /// behind the larger. A processor that looks ahead past the end of a short function overlaps its chain with other
    /// work. The weights are rounded from the times of generated functions (`bench/`, measurements `weights` and
    /// `scaling`): among others a division takes 5 to 10 additions, a sine-cosine pair 56 to 81, another function 30 to
    /// 70; an addition on the chain takes as long as about twelve independent ones.
    pub fn weight(&self) -> usize {
        /// Time of an addition on the chain, in independent additions.
        const WAIT: usize = 12;
        /// Look-ahead of the processor, in independent additions.
        const AHEAD: usize = 500;
        let sines_and_functions = work(CostKind::Sincos) * self.sincos + work(CostKind::Function) * self.functions;
        let work = self.arithmetic() + sines_and_functions;
        let chain = WAIT * self.chain * work / (work + AHEAD);
        // the larger of the two, and slightly more if they are of similar size: (work^8 + chain^8)^(1/8)
        let (larger, smaller) = (work.max(chain) as f64, work.min(chain) as f64);
        let more = 1.0 + (smaller / larger.max(1.0)).powi(8);
        (larger * more.sqrt().sqrt().sqrt()) as usize
    }

    /// Work without sines and functions, in additions. The forms of one function hardly differ in their sines.
    pub(crate) fn arithmetic(&self) -> usize {
        self.additions + self.multiplications + work(CostKind::Division) * self.divisions
    }
}

/// Length of the longest chain of dependent operations from the state to a root, in additions.
fn chain(g: &Graph, reachable: &[ExprId], roots: &[Expr<'_>]) -> usize {
    let mut ends = vec![0; reachable.last().map_or(0, |last| last.index() + 1)];
    for &id in reachable {
        let before = g.operands(id).map(|operand| ends[operand.index()]).max().unwrap_or(0);
        let own = match g.node(id) {
            _ if g.level(id) < Level::State => continue,
            Node::Number(_) | Node::Pi | Node::Symbol(_) | Node::Unary(Unary::Neg, _) => 0,
            Node::Unary(op, _) => waiting(op.cost()),
            Node::Binary(op, ..) => waiting(op.cost()),
            // mostly squares and square roots
            Node::Power(_, n) => waiting(if n.is_integer() {
                CostKind::Multiplication
            } else {
                CostKind::Division
            }),
        };
        ends[id.index()] = before + own;
    }
    roots.iter().map(|root| ends[root.id().index()]).max().unwrap_or(0)
}

/// Time of an operation among many independent ones, in additions.
pub(crate) fn work(kind: CostKind) -> usize {
    match kind {
        CostKind::Addition | CostKind::Multiplication => 1,
        CostKind::Division => 6,
        CostKind::Function => 30,
        CostKind::Sincos => 60,
    }
}

/// Latency of an operation, in additions.
pub(crate) fn waiting(kind: CostKind) -> usize {
    match kind {
        CostKind::Addition | CostKind::Multiplication => 1,
        CostKind::Division => 4,
        CostKind::Function => 10,
        CostKind::Sincos => 20,
    }
}

#[cfg(test)]
mod tests {
    use super::Operations;

    #[test]
    fn weights_grow_with_work_and_with_chains_of_any_length() {
        let of = |additions, chain| Operations {
            additions,
            chain,
            ..Operations::default()
        };
        let mut last = 0;
        for power in 1..9 {
            let weight = of(10_usize.pow(power), 5).weight();
            assert!(weight > last, "{weight} for 10^{power}");
            last = weight;
        }
        assert!(of(1000, 300).weight() > of(1000, 100).weight());
        // a chain that hides behind many operations
        assert_eq!(of(100_000, 10).weight(), 100_000);
    }
}

//! Counted operations.

use std::collections::BTreeSet;

use num_traits::{Signed, ToPrimitive};

use crate::expr::{CostKind, ExprId, Graph, Level, Node, Unary};

/// How many operations an evaluation takes. What depends on parameters alone is computed when the model is built, and is
/// not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions, subtractions and negations.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Angles of which the sine, the cosine or both are called.
    pub sincos: usize,
    /// Other functions, square roots included.
    pub functions: usize,
}

impl Operations {
    /// The operations that the roots need, each shared one once.
    pub fn of(g: &Graph, roots: &[ExprId]) -> Self {
        let mut operations = Self::default();
        let mut angles = BTreeSet::new();
        for id in g.reachable(roots) {
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
        operations
    }

    /// One number to choose by, in multiples of an addition. The weights are rounded from the times of generated functions with their
    /// own sines, by least squares and by one operation more (`bench/`, measurement `weights`): there a division takes 4 to 9
    /// additions, a sine-cosine pair 77 to 102, an exponential 30 to 70, and a square root 1 to 8, since others are computed meanwhile.
    pub fn weight(&self) -> usize {
        self.arithmetic() + 80 * self.sincos + 30 * self.functions
    }

    /// The part of the weight in which the forms of one function differ: they hardly do in their sines.
    pub(super) fn arithmetic(&self) -> usize {
        self.additions + self.multiplications + 6 * self.divisions
    }
}

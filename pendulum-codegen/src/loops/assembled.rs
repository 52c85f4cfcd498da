//! Numerical values in the assembled configuration of loops.

use rustc_hash::FxHashMap;

use super::Solver;
use crate::expr::{Expr, ExprId, Symbol, SymbolKind};

impl<'g> Solver<'g, '_> {
    /// Value of an expression in the assembled configuration.
    pub(super) fn number(&self, x: Expr<'g>) -> f64 {
        self.numbers([x])[0]
    }

    /// Values of expressions in the assembled configuration; parameters without a default count as 1.
    pub(super) fn numbers<const N: usize>(&self, values: [Expr<'g>; N]) -> [f64; N] {
        let all = self.numbers_of(&values);
        std::array::from_fn(|n| all[n])
    }

    pub(super) fn numbers_of(&self, values: &[Expr<'g>]) -> Vec<f64> {
        let values = self.dependence.written_out(self.graph, &self.tree.with_drives(values));
        let assembled: FxHashMap<ExprId, f64> = self.components().collect();
        let value = |id: ExprId, symbol: &Symbol| match symbol.kind {
            SymbolKind::Parameter(n) => self.tree.parameters[n].default.unwrap_or(1.0),
            _ => assembled.get(&id).copied().unwrap_or(0.0),
        };
        self.graph.evaluate_at(&values, value)
    }

    /// Components of positions in the assembled configuration. Those that are missing are zero.
    pub(super) fn components(&self) -> impl Iterator<Item = (ExprId, f64)> {
        let assembled = self.tree.all_coordinates().zip(&self.assembled);
        let free = self.free.iter().map(|(&component, &value)| (component, value));
        let assembled = assembled.map(|(coordinate, &value)| match &coordinate.changes[..] {
            // orientations equal their reference frames: the scalar part comes first
            [(scalar, _), _, ..] => (scalar.id(), 1.0),
            _ => (coordinate.position.id(), value),
        });
        assembled.chain(free)
    }

    /// True if all parameters have values, so that the loops can be assembled.
    pub(super) fn is_known(&self) -> bool {
        self.tree.parameters.iter().all(|parameter| parameter.default.is_some())
    }
}

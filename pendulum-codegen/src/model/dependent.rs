//! Dependent coordinates of closed loops.

use num_traits::ToPrimitive;
use rustc_hash::{FxHashMap, FxHashSet};

use super::{CoordinateId, Model, Tree};
use crate::expr::{Binary, Derivative, Expr, Graph, Node, Normalizer, Rational, Unary};

/// Values of the dependent coordinates in terms of the state, represented by symbols until they are written out.
///
/// Until then the symbols act as variables: forms are expanded in them, and derivatives account for their changes.
/// Their values contain roots and quotients in which no form could be expanded.
#[derive(Clone, Debug, Default)]
pub(crate) struct Dependence<'g> {
    /// Values of the symbols, in terms of the state.
    values: FxHashMap<Expr<'g>, Expr<'g>>,
    /// Cosines and sines of angles, in terms of the state.
    turns: FxHashMap<Expr<'g>, [Expr<'g>; 2]>,
    /// Angles that are sums of others, with integer factors for those that have a cosine and sine in `turns`.
    sums: FxHashMap<Expr<'g>, Vec<(Expr<'g>, Rational)>>,
    /// Definition of each symbol, as given.
    definitions: Vec<(Expr<'g>, Expr<'g>)>,
}

/// Maximum number of products of terms formed to normalise an angle.
const BUDGET: usize = 10_000;

impl<'g> Dependence<'g> {
    /// Sets the value of a symbol. The value may contain symbols that were set before.
    pub(crate) fn set(&mut self, symbol: Expr<'g>, value: Expr<'g>) {
        self.definitions.push((symbol, value));
        let value = self.written_out(symbol.graph(), &[value])[0];
        self.values.insert(symbol, value);
    }

    /// Sets the cosine and sine of an angle.
    pub(crate) fn set_turn(&mut self, angle: Expr<'g>, [cosine, sine]: [Expr<'g>; 2]) {
        self.set(angle, sine.combine(Binary::Atan2, cosine));
        let turn = self.written_out(angle.graph(), &[cosine, sine]);
        self.turns.insert(angle, [turn[0], turn[1]]);
    }

    /// Records an angle as a sum of other angles.
    pub(crate) fn set_sum(&mut self, angle: Expr<'g>, sum: Vec<(Expr<'g>, Rational)>) {
        self.sums.insert(angle, sum);
    }

    /// Definition of each symbol, in terms of the state and of earlier symbols.
    pub(crate) fn definitions(&self) -> impl Iterator<Item = (Expr<'g>, Expr<'g>)> {
        self.definitions
            .iter()
            .map(|&(symbol, value)| match self.sums.get(&symbol) {
                None => (symbol, value),
                // the angle equals the sum up to whole turns; its value may contain the angle itself
                Some(sum) => {
                    let graph = symbol.graph();
                    let sum = graph.sum(sum.iter().map(|(part, n)| n * *part));
                    let known = FxHashMap::from_iter([(symbol, sum)]);
                    (symbol, graph.substitute(&[value], known)[0])
                }
            })
    }

    /// Replaces the symbols by their values, so that the expressions depend on the state alone.
    pub(crate) fn written_out(&self, graph: &'g Graph, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
        if self.values.is_empty() && self.turns.is_empty() {
            return roots.to_vec();
        }
        let mut known = self.values.clone();
        for id in graph.reachable(roots) {
            let x = graph.expr(id);
            if let Node::Unary(op @ (Unary::Sin | Unary::Cos), angle) = x.node()
                && let Some([cosine, sine]) = self.turn(angle)
            {
                known.insert(x, if op == Unary::Sin { sine } else { cosine });
            }
        }
        graph.substitute(roots, known)
    }

    /// Cosine and sine of an angle that contains dependent angles, by the addition theorems; none if it contains none,
    /// or if its normal form is too large or has fractional multiples of them.
    fn turn(&self, angle: Expr<'g>) -> Option<[Expr<'g>; 2]> {
        let graph = angle.graph();
        let mut normalizer = Normalizer::new(graph, BUDGET);
        let depends = |x: &Expr<'g>| self.turns.contains_key(x) || self.sums.contains_key(x);
        if !graph.reachable(&[angle]).into_iter().any(|id| depends(&graph.expr(id))) {
            return None;
        }
        let whole = normalizer.normal(angle).ok()?;
        let mut rest = (*whole).clone();
        let mut parts: Vec<(Expr<'g>, Rational)> = Vec::new();
        for (monomial, factor) in whole.terms() {
            let &[(symbol, 1)] = monomial.powers() else { continue };
            let symbol = graph.expr(symbol);
            if !depends(&symbol) {
                continue;
            }
            rest.remove(monomial);
            match self.sums.get(&symbol) {
                Some(sum) => parts.extend(sum.iter().map(|(part, n)| (*part, n * factor))),
                None => parts.push((symbol, factor.clone())),
            }
        }
        let mut rest = normalizer.to_expr(&rest);
        let mut turns: Vec<([Expr<'g>; 2], i64)> = Vec::new();
        for (part, n) in parts {
            match self.turns.get(&part) {
                Some(&turn) => turns.push((turn, n.is_integer().then(|| n.to_i64()).flatten()?)),
                None => rest += n * part,
            }
        }
        let mut sum = [rest.cos(), rest.sin()];
        for ([cosine, sine], n) in turns {
            let sine = if n < 0 { -sine } else { sine };
            for _ in 0..n.unsigned_abs() {
                let [c, s] = sum;
                sum = [c * cosine - s * sine, s * cosine + c * sine];
            }
        }
        Some(sum)
    }
}

impl<'g> Tree<'g> {
    /// Symbols in the forces, except dependent angles that occur only within sines and cosines.
    pub(crate) fn turns_in_forces(&self, dependence: &Dependence<'g>) -> FxHashSet<Expr<'g>> {
        let of_joints = self.bodies.iter().flat_map(|body| [body.force, body.potential]);
        let mut actions = self.actions.clone();
        let of_actions = actions.iter_mut().flat_map(|action| action.expressions());
        let mut left: Vec<Expr<'g>> = of_joints.chain(of_actions.map(|x| *x)).collect();
        let mut seen = FxHashSet::default();
        while let Some(x) = left.pop() {
            if seen.insert(x) {
                match x.node() {
                    Node::Unary(Unary::Sin | Unary::Cos, angle) if dependence.turn(angle).is_some() => {}
                    _ => left.extend(x.operands()),
                }
            }
        }
        seen.retain(|x| x.as_symbol().is_some());
        seen
    }
}

impl<'g> Model<'g> {
    /// Derivative by a coordinate of the state, with the dependent coordinates following it.
    pub(crate) fn along(&self, k: CoordinateId) -> Derivative<'g> {
        let own = self.coordinate(k).changes.iter().copied();
        let dependents = self.dependents.iter().zip(&self.loops.dependents);
        let in_state = dependents.filter(|(_, slopes)| slopes.in_state);
        let dependents = in_state.map(|(coordinate, slopes)| (coordinate.position, slopes.slopes[usize::from(k)]));
        Derivative::along(own.chain(dependents))
    }

    /// Derivatives of a dependent coordinate by those of the state; none for an independent coordinate.
    pub(crate) fn slopes(&self, k: CoordinateId) -> Option<&[Expr<'g>]> {
        let n = usize::from(k).checked_sub(self.independent())?;
        Some(&self.loops.dependents[n].slopes[..self.dof()])
    }

    /// Replaces the symbols of dependent coordinates by their values.
    pub(crate) fn written_out(&self, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
        self.loops.dependence.written_out(self.graph, roots)
    }
}

//! Coordinates that depend on others, where loops are closed.

use num_traits::ToPrimitive;
use rustc_hash::{FxHashMap, FxHashSet};

use super::{CoordinateId, Model, Tree};
use crate::expr::{Binary, Derivative, Expr, Graph, Node, Normalizer, Rational, Unary};

/// What dependent coordinates are in the state: symbols that stand in expressions until these are written out.
///
/// Between, they are as good as variables: forms are expanded in them, and derivatives know how they
/// change. What they stand for has roots and quotients that no form could be expanded in.
#[derive(Clone, Debug, Default)]
pub(crate) struct Dependence<'g> {
    /// The values of symbols, in the state.
    values: FxHashMap<Expr<'g>, Expr<'g>>,
    /// Cosine and sine of angles, in the state.
    turns: FxHashMap<Expr<'g>, [Expr<'g>; 2]>,
    /// Angles as sums of others, with whole factors where these have a turn.
    sums: FxHashMap<Expr<'g>, Vec<(Expr<'g>, Rational)>>,
    /// What each symbol stands for, as it was given.
    definitions: Vec<(Expr<'g>, Expr<'g>)>,
}

/// How far the normal form of an angle may grow.
const BUDGET: usize = 10_000;

impl<'g> Dependence<'g> {
    /// Gives a symbol its value, which may hold what was given before.
    pub(crate) fn set(&mut self, symbol: Expr<'g>, value: Expr<'g>) {
        self.definitions.push((symbol, value));
        let value = self.written_out(symbol.graph(), &[value])[0];
        self.values.insert(symbol, value);
    }

    /// Gives an angle its cosine and sine.
    pub(crate) fn set_turn(&mut self, angle: Expr<'g>, [cosine, sine]: [Expr<'g>; 2]) {
        self.set(angle, sine.combine(Binary::Atan2, cosine));
        let turn = self.written_out(angle.graph(), &[cosine, sine]);
        self.turns.insert(angle, [turn[0], turn[1]]);
    }

    /// Says which sum an angle is.
    pub(crate) fn set_sum(&mut self, angle: Expr<'g>, sum: Vec<(Expr<'g>, Rational)>) {
        self.sums.insert(angle, sum);
    }

    /// What each symbol stands for, in the state and in symbols before it.
    pub(crate) fn definitions(&self) -> impl Iterator<Item = (Expr<'g>, Expr<'g>)> {
        self.definitions
            .iter()
            .map(|&(symbol, value)| match self.sums.get(&symbol) {
                None => (symbol, value),
                // but for whole turns it is that sum, in the value too
                Some(sum) => {
                    let graph = symbol.graph();
                    let sum = graph.sum(sum.iter().map(|(part, n)| n * *part));
                    let known = FxHashMap::from_iter([(symbol, sum)]);
                    (symbol, graph.substitute(&[value], known)[0])
                }
            })
    }

    /// The expressions in the state alone.
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

    /// Cosine and sine of an angle, where dependent angles are part of it.
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
    /// The symbols that stand in forces, but for angles of which these have the cosine and sine alone.
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
    /// The derivative by a coordinate of the state, where all that depends on it moves along.
    pub(crate) fn along(&self, k: CoordinateId) -> Derivative<'g> {
        let own = self.coordinate(k).changes.iter().copied();
        let dependents = self.dependents.iter().zip(&self.loops.dependents);
        let in_state = dependents.filter(|(_, slopes)| slopes.in_state);
        let dependents = in_state.map(|(coordinate, slopes)| (coordinate.position, slopes.slopes[usize::from(k)]));
        Derivative::along(own.chain(dependents))
    }

    /// The derivatives of a coordinate by those of the state, if it depends on them.
    pub(crate) fn slopes(&self, k: CoordinateId) -> Option<&[Expr<'g>]> {
        let n = usize::from(k).checked_sub(self.independent())?;
        Some(&self.loops.dependents[n].slopes[..self.dof()])
    }

    /// Expressions in which dependent coordinates are written out.
    pub(crate) fn written_out(&self, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
        self.loops.dependence.written_out(self.graph, roots)
    }
}

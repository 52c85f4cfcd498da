//! Shortest code for expressions of the state outside the dynamics: outputs, events, drawings, constraint values.

use rustc_hash::FxHashMap;

use super::closed::short_terms;
use super::{Basis, Candidate, Chosen, Form, Forms};
use crate::dynamics::derived;
use crate::expr::{Derivative, Expr, SymbolKind};
use crate::model::{Model, changes};
use crate::pass::Products;
use crate::pass::factor::factor;

/// Code for the values of expressions, in the shortest form.
pub(crate) fn values<'g>(forms: &mut Forms<'g>, model: &Model<'g>, values: &[Expr<'g>]) -> Chosen<'g> {
    let values = model.with_drives(values);
    forms.shortest(&values)
}

/// Code for the values of expressions in their declared form, without a search for a shorter one.
pub(crate) fn as_declared<'g>(forms: &Forms<'g>, model: &Model<'g>, values: &[Expr<'g>]) -> Chosen<'g> {
    forms.choose(vec![(Form::of(Basis::Declared), model.with_drives(values))])
}

/// Code for the time derivatives of expressions along the motion.
pub(crate) fn rates<'g>(forms: &mut Forms<'g>, model: &Model<'g>, values: &[Expr<'g>]) -> Chosen<'g> {
    let rates = along_motion(model, values);
    let mut symbols = model.graph.symbols_of(&rates);
    if !symbols.any(|symbol| matches!(symbol.kind, SymbolKind::Acceleration(_))) {
        return forms.shortest(&rates);
    }
    let accelerations = model.coordinates.iter().map(|c| c.acceleration);
    let solved: FxHashMap<_, _> = accelerations.zip(forms.accelerations().roots).collect();
    let rates = model.with_friction(&model.graph.substitute(&rates, solved));
    forms.choose(vec![(Form::of(Basis::Declared), rates)])
}

/// Code for the values and the time derivatives of expressions of the positions, in their declared form: values and
/// rates share most subexpressions there.
pub(crate) fn values_and_rates<'g>(forms: &mut Forms<'g>, model: &Model<'g>, values: &[Expr<'g>]) -> Chosen<'g> {
    let roots = [model.with_drives(values), along_motion(model, values)].concat();
    forms.choose(vec![(Form::of(Basis::Declared), roots)])
}

/// Time derivatives of expressions along the motion, with the accelerations as symbols.
fn along_motion<'g>(model: &Model<'g>, values: &[Expr<'g>]) -> Vec<Expr<'g>> {
    let directions = changes(model.all_coordinates()).into_iter();
    let directions = directions.chain(model.all_coordinates().map(|c| (c.rate, c.acceleration)));
    let directions = directions.chain(model.states.iter().map(|state| (state.symbol, state.rate)));
    let mut along = Derivative::along(directions.chain([(model.time, model.graph.one())]));
    let rates: Vec<Expr<'g>> = values.iter().map(|&value| along.of(value)).collect();
    model.with_drives(&rates)
}

/// Code for the values of expressions and their derivatives with respect to the state, column by column.
pub(crate) fn values_and_jacobian<'g>(forms: &mut Forms<'g>, model: &Model<'g>, values: &[Expr<'g>]) -> Chosen<'g> {
    let values = model.with_drives(values);
    let columns = derived(&values, &model.state()).concat();
    forms.shortest(&[values, columns].concat())
}

impl<'g> Forms<'g> {
    /// Returns the shortest code for expressions, either as declared or in closed form.
    fn shortest(&mut self, roots: &[Expr<'g>]) -> Chosen<'g> {
        let mut candidates: Vec<Candidate<'g>> = vec![(Form::of(Basis::Declared), roots.to_vec())];
        let terms = roots.iter().map(|&root| short_terms(&mut self.normalizer, root));
        if let Ok(terms) = terms.collect::<Result<Vec<_>, _>>() {
            let g = self.normalizer.graph();
            for products in Products::ALL {
                let factored = terms.iter().map(|terms| factor(g, terms, products));
                candidates.push((Form::of(Basis::Closed(products)), factored.collect()));
            }
        }
        self.choose(candidates)
    }
}

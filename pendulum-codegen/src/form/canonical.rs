//! Canonical equations: momenta in place of rates.

use super::written::Written;
use super::{Chosen, Forms, ways};
use crate::dynamics::{derived, momentum_partials, momentum_rates};
use crate::model::Model;

impl<'g> Forms<'g> {
    /// Returns the shortest code for the momenta, followed by their rates.
    pub(crate) fn canonical(&mut self, model: &Model<'g>) -> Chosen<'g> {
        let mut candidates = Vec::new();
        for (Written { form, balance, .. }, lagrangian) in self.forms.iter().zip(&self.lagrangians) {
            let rates = vec![momentum_rates(model, balance, lagrangian)];
            for (derivatives, rates) in ways(&mut self.normalizer, form.basis, rates) {
                let roots = lagrangian.momentum.iter().copied().chain(rates.into_iter().flatten());
                candidates.push((form.derived_by(derivatives), roots.collect()));
            }
        }
        self.choose(candidates)
    }

    /// Returns the shortest code for the derivatives of the momenta with respect to the state, column by column,
    /// followed by those of their rates.
    pub(crate) fn canonical_jacobian(&mut self, model: &Model<'g>) -> Chosen<'g> {
        let state = model.state();
        let mut candidates = Vec::new();
        for (Written { form, balance, .. }, lagrangian) in self.forms.iter().zip(&self.lagrangians) {
            let rates = vec![momentum_rates(model, balance, lagrangian)];
            let momenta = momentum_partials(&model.coordinates, balance, lagrangian);
            for (_, rates) in ways(&mut self.normalizer, form.basis, rates) {
                let columns = momenta.iter().cloned().chain(derived(&rates[0], &state)).collect();
                for (derivatives, columns) in ways(&mut self.normalizer, form.basis, columns) {
                    let roots = columns.into_iter().flatten().collect();
                    candidates.push((form.derived_by(derivatives), roots));
                }
            }
        }
        self.choose(candidates)
    }
}

//! Products of weights with the derivatives of the right-hand side, and the derivatives of these products along a
//! direction.
//!
//! The right-hand side consists of expressions of the variables `z` (state, parameters, inputs) and of accelerations
//! `a`, for which the equations of motion `r(z, a) = 0` are solved. With weights `w`, the Lagrangian
//!
//! ```text
//! L(z, a, l) = w . rhs(z, a) + l . r(z, a)
//! ```
//!
//! is stationary with respect to `a` for the multipliers `A l = -w . d(rhs)/da`, and its partial gradient with respect
//! to `z` is then the product `w . d(rhs)/dz`. Along a direction `v` of `z` the solutions change by `A da = -dr/dz v`
//! and `A dl = -(d2L/(da dz) v + d2L/da2 da)`. All use one factorisation of the mass matrix `A = dr/da`, which is
//! symmetric.

use rustc_hash::FxHashMap;

use super::routines::kinematics;
use super::solved::{System, of_coordinates};
use super::{Candidate, Chosen, Forms};
use crate::expr::{Derivative, Expr, SymbolKind, gradient};
use crate::model::Model;

/// Lagrangian of a weighted right-hand side, with accelerations and multipliers as symbols.
struct Lagrangian<'g> {
    /// Components of the right-hand side, with their weights.
    weighted: Vec<(Expr<'g>, Expr<'g>)>,
    /// Symbols of the unknown accelerations.
    accelerations: Vec<Expr<'g>>,
    /// Symbols of the multipliers.
    multipliers: Vec<Expr<'g>>,
}

/// Products of weights with the derivatives of the right-hand side: with respect to the state, to the parameters, and
/// to the inputs. Constraint forces follow the friction law of the right-hand side.
pub(crate) fn adjoint<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let parameters = model.parameters.iter().map(|parameter| parameter.symbol);
    let variables: Vec<Expr<'g>> = model
        .state()
        .into_iter()
        .chain(parameters)
        .chain(model.input_symbols())
        .collect();
    let lagrangian = Lagrangian::new(forms, model);
    let forces = model.force_symbols();
    let frictions = model.with_friction(&forces);
    lagrangian.solved(forms, model, |system| {
        let all = [&variables[..], &forces].concat();
        let mut products = gradient(&lagrangian.terms(system), &all);
        let of_forces = products.split_off(variables.len());
        let frictions: Vec<_> = frictions.iter().copied().zip(of_forces).collect();
        let more = gradient(&frictions, &variables);
        let products = products.into_iter().zip(more);
        products.map(|(product, more)| product + more).collect()
    })
}

/// Derivatives along a direction of the products of weights with the derivatives of the right-hand side with respect to
/// the state and the inputs.
pub(crate) fn hessian_product<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let variables = [model.state(), model.input_symbols()].concat();
    let direction = model.symbols("direction", variables.len(), SymbolKind::Direction);
    let lagrangian = Lagrangian::new(forms, model);
    lagrangian.solved(forms, model, |system| {
        let terms = lagrangian.terms(system);
        let mut changes: Vec<_> = variables.iter().copied().zip(direction.iter().copied()).collect();
        let along = |changes: &[(Expr<'g>, Expr<'g>)], of: &[Expr<'g>]| -> Vec<Expr<'g>> {
            let mut along = Derivative::along(changes.iter().copied());
            of.iter().map(|&x| along.of(x)).collect()
        };
        let of_accelerations = system.inverse.solve_negated(&along(&changes, system.rows));
        changes.extend(lagrangian.accelerations.iter().copied().zip(of_accelerations));
        let stationary = gradient(&terms, &lagrangian.accelerations);
        let of_multipliers = system.inverse.solve_negated(&along(&changes, &stationary));
        changes.extend(lagrangian.multipliers.iter().copied().zip(of_multipliers));
        along(&changes, &gradient(&terms, &variables))
    })
}

impl<'g> Lagrangian<'g> {
    fn new(forms: &Forms<'g>, model: &Model<'g>) -> Self {
        let accelerations: Vec<Expr<'g>> = model.coordinates.iter().map(|c| c.acceleration).collect();
        let (known, dependent) = kinematics(model);
        let of_coordinates = of_coordinates(forms.floating(), accelerations.clone());
        let rhs = [known, dependent, of_coordinates, model.state_rates()].concat();
        let weights = model.symbols("weights", rhs.len(), SymbolKind::Weight);
        Self {
            weighted: rhs.into_iter().zip(weights).collect(),
            multipliers: model.symbols("multiplier", accelerations.len(), SymbolKind::Multiplier),
            accelerations,
        }
    }

    /// Terms of the Lagrangian, each with its weight.
    fn terms(&self, system: &System<'_, 'g>) -> Vec<(Expr<'g>, Expr<'g>)> {
        let equations = system.rows.iter().copied().zip(self.multipliers.iter().copied());
        self.weighted.iter().copied().chain(equations).collect()
    }

    /// Shortest code for `roots`, functions of the accelerations and the multipliers of a linear system.
    fn solved(
        &self,
        forms: &Forms<'g>,
        model: &Model<'g>,
        roots: impl Fn(&System<'_, 'g>) -> Vec<Expr<'g>>,
    ) -> Chosen<'g> {
        let mut candidates: Vec<Candidate<'g>> = Vec::new();
        let forcing = gradient(&self.weighted, &self.accelerations);
        forms.each_system(|system| {
            let multipliers = system.inverse.solve_negated(&forcing);
            let accelerations = self.accelerations.iter().copied().zip(system.solved.iter().copied());
            let multipliers = self.multipliers.iter().copied().zip(multipliers);
            let solved: FxHashMap<Expr<'g>, Expr<'g>> = accelerations.chain(multipliers).collect();
            let roots = model.graph.substitute(&roots(&system), solved);
            candidates.push((system.form, model.with_friction(&model.with_drives(&roots))));
        });
        forms.choose(candidates)
    }
}

//! Torques as they were written.

use crate::expr::{Definition, Expr, Formula, Summand, ratio};
use crate::model::Model;

/// The forces along the coordinates: friction and springs as expressions, torques as formulas.
#[derive(Debug)]
pub(super) struct Torques<'g> {
    /// Friction and springs of each coordinate.
    pub(super) passive: Vec<Expr<'g>>,
    /// The torques of each coordinate.
    pub(super) rows: Vec<Vec<Summand>>,
    /// Torques that act on several coordinates, and so have names.
    pub(super) named: Vec<Definition>,
}

impl<'g> Torques<'g> {
    /// The forces of a scene. With `q = T theta` those along the joints become `T^T tau`.
    pub(super) fn new(model: &Model<'g>) -> Self {
        let g = model.graph;
        let mut passive = vec![g.zero(); model.dof()];
        let mut rows: Vec<Vec<Summand>> = vec![Vec::new(); model.dof()];
        let mut named = Vec::new();
        for body in &model.bodies {
            let name = format!("torque_{}", body.name.trim_start_matches("r#"));
            let torque = body.torque.as_ref().map(|torque| {
                if body.motion.terms().count() < 2 || torque.to_string().len() <= name.len() {
                    return torque.clone();
                }
                let name = free(model, name);
                named.push(Definition {
                    name: name.clone(),
                    formula: torque.clone(),
                });
                Formula::Name(name)
            });
            for (k, factor) in body.motion.terms() {
                passive[k] += factor * body.passive;
                let Some(torque) = torque.clone() else { continue };
                let size = factor.abs();
                let scaled = if size == 1 {
                    torque
                } else {
                    Formula::Product(vec![Formula::Number(ratio(size, 1)), torque])
                };
                rows[k].extend(scaled.into_terms(factor < 0));
            }
        }
        Self { passive, rows, named }
    }

    /// What the names in formulas stand for: each `let` that is used, in the order of the declaration, and then the torques.
    pub(super) fn definitions<'f>(
        &self,
        model: &Model<'_>,
        formulas: impl IntoIterator<Item = &'f Formula>,
    ) -> Vec<Definition> {
        let mut using: Vec<&Formula> = formulas.into_iter().collect();
        let mut used = Vec::new();
        // a definition uses only names before it
        for definition in model.lets.iter().chain(&self.named).rev() {
            if using.iter().any(|formula| formula.mentions(&definition.name)) {
                using.push(&definition.formula);
                used.push(definition.clone());
            }
        }
        used.reverse();
        used
    }
}

/// A name that the declaration does not have.
fn free(model: &Model<'_>, mut name: String) -> String {
    let taken = model.names();
    while taken.contains(&name) {
        name.push('_');
    }
    name
}

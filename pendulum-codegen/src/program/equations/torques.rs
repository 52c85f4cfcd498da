//! Torques as written in the declaration.

use num_traits::{One, Signed};
use rustc_hash::FxHashSet;

use crate::dynamics::Dynamics;
use crate::expr::{Definition, Expr, Formula, Normalizer, Printer, Summand};
use crate::form::expanded;
use crate::model::{Action, Model, Poses};
use crate::pass::Products;

/// Forces along the coordinates: friction and springs as expressions, torques as formulas.
#[derive(Debug)]
pub(super) struct Torques<'g> {
    /// Friction and springs of each coordinate.
    pub(super) passive: Vec<Expr<'g>>,
    /// Torques of each coordinate.
    pub(super) rows: Vec<Vec<Summand>>,
    /// Torques that act on several coordinates, and so have names.
    pub(super) named: Vec<Definition>,
    /// Laws of the drives, and positions of the points.
    points: Vec<Definition>,
}

impl<'g> Torques<'g> {
    /// Forces of a scene. With `q = T theta`, joint forces `tau` become `T^T tau` along the coordinates.
    pub(super) fn new(model: &Model<'g>) -> Self {
        let mut passive = Dynamics::scene_forces(model);
        let mut rows: Vec<Vec<Summand>> = vec![Vec::new(); model.dof()];
        let (mut named, printer) = (Vec::new(), Printer::that_computes(model.graph));
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
            for (k, factor) in body.motion.terms().filter(|(k, _)| model.is_free(*k)) {
                passive[k] += factor * body.passive;
                let Some(torque) = torque.clone() else { continue };
                let size = factor.abs();
                let scaled = if size.is_one() {
                    torque
                } else {
                    Formula::Product(vec![Formula::Number(size), torque])
                };
                rows[k].extend(scaled.into_terms(factor.is_negative()));
            }
            // dependent coordinates pass their forces on, times their slopes
            for (slopes, factor) in body
                .motion
                .terms()
                .filter_map(|(k, factor)| Some((model.slopes(k)?, factor)))
            {
                for ((sum, row), &slope) in passive.iter_mut().zip(&mut rows).zip(slopes) {
                    *sum += slope * (factor * body.passive);
                    let Some(torque) = torque.clone().filter(|_| !slope.is_zero()) else {
                        continue;
                    };
                    let (negative, slope) = match printer.formula((factor * slope).id()) {
                        Formula::Neg(slope) => (true, *slope),
                        slope => (false, slope),
                    };
                    row.extend(Formula::Product(vec![slope, torque]).into_terms(negative));
                }
            }
        }
        for action in &model.actions {
            if let Action::Along(k, _, force) = action {
                rows[*k].extend(force.clone().into_terms(false));
            }
        }
        Self {
            passive: model.with_drives(&passive),
            rows,
            named,
            points: points(model),
        }
    }

    /// Definitions of the names in formulas: each `let` that is used, in the order of the declaration, then the
    /// torques.
    pub(super) fn definitions<'f>(
        &self,
        model: &Model<'_>,
        formulas: impl IntoIterator<Item = &'f Formula>,
    ) -> Vec<Definition> {
        let mut mentioned: FxHashSet<&str> = formulas.into_iter().flat_map(Formula::names).collect();
        let mut used = Vec::new();
        // a definition uses only names before it
        for definition in model.lets.iter().chain(&self.named).rev() {
            if mentioned.contains(definition.name.as_str()) {
                mentioned.extend(definition.formula.names());
                used.push(definition.clone());
            }
        }
        used.reverse();
        let mentioned = |point: &&Definition| {
            let name = point.name.split('.').next().unwrap_or_default();
            mentioned.contains(point.name.as_str()) || mentioned.contains(name)
        };
        let points: Vec<Definition> = self.points.iter().filter(mentioned).cloned().collect();
        [points, used].concat()
    }
}

/// Laws of the drives, and the position of each point.
fn points(model: &Model<'_>) -> Vec<Definition> {
    /// Maximum size of the normal form of a position.
    const BUDGET: usize = 20_000;
    let mut normalizer = Normalizer::with_angles(model.graph, BUDGET, model.base_angles());
    let (printer, poses) = (Printer::that_computes(model.graph), Poses::new(model));
    let mut definitions = Vec::new();
    for drive in &model.drives {
        definitions.push(Definition {
            name: drive.coordinate.name.trim_start_matches("r#").to_owned(),
            formula: printer.short(drive.law[0].id()),
        });
    }
    for point in &model.points {
        let position = model.with_drives(&poses.point(point.place.body, point.place.at).0);
        let short = expanded(&mut normalizer, std::slice::from_ref(&position), Products::Expanded);
        let position = short.map_or(position, |columns| columns.concat());
        definitions.extend(["x", "y", "z"].into_iter().zip(position).map(|(axis, x)| Definition {
            name: format!("{}.{axis}", point.name.trim_start_matches("r#")),
            formula: printer.short(x.id()),
        }));
    }
    definitions
}

/// Extends a name until it differs from all names in the declaration.
fn free(model: &Model<'_>, mut name: String) -> String {
    let taken = model.names();
    while taken.contains(&name) {
        name.push('_');
    }
    name
}

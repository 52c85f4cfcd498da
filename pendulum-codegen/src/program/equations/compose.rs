//! The equations of a model in their shortest form.

use std::collections::BTreeSet;

use super::names::name_parts;
use super::torques::Torques;
use super::{Equations, Listing, Quantity, Row};
use crate::dynamics::Dynamics;
use crate::expr::{Expr, Formula, Normalizer, Printer, Term};
use crate::form::expanded;
use crate::model::Model;
use crate::pass::{Preference, nest};

/// How many products of terms the closed form of the text may take.
const BUDGET: usize = 100_000;

/// Equations of up to this many characters are written out: names would not make them plainer.
const SHORT: usize = 2_000;

/// Longer equations are hardly read, so a form of up to this many characters is taken where there is one.
const PAGE: usize = 4_800;

/// What a character counts for in each form: terms that are written out say more than nested ones, and a closed
/// form says more than a recursion.
const EXPANDED: usize = 24;
const FACTORED: usize = 27;
const RECURSIVE: usize = 40;

/// The equations of a scene; `closed` is its dynamics in closed form, if it is small enough to have it.
pub(crate) fn equations<'g>(model: &Model<'g>, dynamics: &Dynamics<'g>, closed: Option<&Dynamics<'g>>) -> Equations {
    let mut composer = Composer {
        model,
        closed,
        recursive: Dynamics::recursive(model, dynamics.potential),
        torques: Torques::new(model),
        normalizer: Normalizer::with_angles(model.graph, BUDGET, model.base_angles()),
    };
    Equations {
        coordinates: model.coordinate_names().into_iter().map(str::to_owned).collect(),
        short: composer.short(),
        full: composer.full(&dynamics.force),
    }
}

struct Composer<'m, 'g> {
    model: &'m Model<'g>,
    closed: Option<&'m Dynamics<'g>>,
    recursive: Dynamics<'g>,
    torques: Torques<'g>,
    normalizer: Normalizer<'g>,
}

impl<'g> Composer<'_, 'g> {
    /// The shortest form, or one nearly as short that shows more.
    fn short(&mut self) -> Listing {
        let passive = self.torques.passive.clone();
        let flat = self.expanded(&passive, Preference::Expanded);
        let flat = flat.map(|entries| self.listing(&entries, false, true));
        if let Some(flat) = flat.as_ref().filter(|flat| flat.to_string().len() <= SHORT) {
            return flat.clone();
        }
        let mut candidates: Vec<(usize, Listing)> = flat.into_iter().map(|flat| (EXPANDED, flat)).collect();
        for preference in Preference::ALL {
            let weight = if preference == Preference::Expanded {
                EXPANDED
            } else {
                FACTORED
            };
            let Some(entries) = self.expanded(&passive, preference) else {
                continue;
            };
            for entries in [nest(self.model.graph, &entries), entries] {
                candidates.push((weight, self.listing(&entries, true, true)));
            }
        }
        let recursive = self.by_recursion(&passive, true);
        candidates.extend(recursive.into_iter().map(|listing| (RECURSIVE, listing)));
        let weighed = candidates.into_iter().min_by_key(|(weight, listing)| {
            let length = listing.to_string().len();
            (length > PAGE, weight * length)
        });
        weighed.map(|(_, listing)| listing).unwrap_or_default()
    }

    /// The form in which torques are multiplied out.
    fn full(&mut self, force: &[Expr<'g>]) -> Listing {
        match self.expanded(force, Preference::Expanded) {
            Some(entries) => self.listing(&entries, false, false),
            None => self
                .by_recursion(force, false)
                .into_iter()
                .min_by_key(|listing| listing.to_string().len())
                .unwrap_or_default(),
        }
    }

    /// The recursion over the links, as it is and with its sums in order.
    fn by_recursion(&mut self, force: &[Expr<'g>], with_torques: bool) -> [Listing; 2] {
        let force = self
            .expanded_rows(force, Preference::Expanded)
            .unwrap_or_else(|| force.to_vec());
        let entries: Vec<Expr<'g>> = inertial(&self.recursive).chain(force).collect();
        [nest(self.model.graph, &entries), entries].map(|entries| self.listing(&entries, true, with_torques))
    }

    /// The entries in closed form: the upper triangle of the mass matrix, the bias, the forces.
    fn expanded(&mut self, force: &[Expr<'g>], preference: Preference) -> Option<Vec<Expr<'g>>> {
        let inertial: Vec<Expr<'g>> = match self.closed {
            Some(closed) if preference == Preference::Expanded => inertial(closed).collect(),
            _ => {
                let entries: Vec<Expr<'g>> = inertial(&self.recursive).collect();
                self.expanded_rows(&entries, preference)?
            }
        };
        Some(
            inertial
                .into_iter()
                .chain(self.expanded_rows(force, preference)?)
                .collect(),
        )
    }

    fn expanded_rows(&mut self, rows: &[Expr<'g>], preference: Preference) -> Option<Vec<Expr<'g>>> {
        let columns = expanded(&mut self.normalizer, &[rows.to_vec()], preference)?;
        columns.into_iter().next()
    }

    /// Entries as formulas, in which common parts may be named, and to whose forces torques may be added as they were written.
    fn listing(&self, entries: &[Expr<'g>], named: bool, with_torques: bool) -> Listing {
        let places = places(&self.model.coordinate_names());
        let labels = places
            .iter()
            .map(|(quantity, indices)| Formula::Entry(quantity.letter(), indices.clone()));
        let labelled: Vec<(Formula, Expr<'g>)> = labels.zip(entries.iter().copied()).collect();
        let (printer, parts) = if named {
            name_parts(self.model, &labelled, &self.taken())
        } else {
            (Printer::new(self.model.graph), Vec::new())
        };
        let mut known = BTreeSet::new();
        let mut listing = Listing::default();
        for (n, ((quantity, indices), &id)) in places.into_iter().zip(entries).enumerate() {
            let first = known.insert(id);
            let own = if id.is_zero() {
                Vec::new()
            } else if first {
                printer.definition(id.id()).into_terms(false)
            } else {
                printer.formula(id.id()).into_terms(false)
            };
            let row = (n + self.model.dof()).checked_sub(entries.len());
            let torque = row
                .filter(|_| with_torques)
                .map(|row| self.torques.rows[row].clone())
                .unwrap_or_default();
            let terms = joined(own, torque);
            if !terms.is_empty() {
                listing.rows.push(Row {
                    quantity,
                    indices,
                    formula: Formula::sum(terms),
                });
            }
        }
        if with_torques {
            listing.definitions = self
                .torques
                .definitions(self.model, listing.rows.iter().map(|row| &row.formula));
        }
        listing.definitions.extend(parts);
        listing
    }

    /// Names that no part may have.
    fn taken(&self) -> BTreeSet<String> {
        let model = self.model;
        let parameters = model.parameters.iter().map(|p| &p.name);
        let inputs = model.inputs.iter().map(|i| &i.name);
        let coordinates = model.coordinates.iter().map(|c| &c.name);
        let definitions = model.lets.iter().chain(&self.torques.named).map(|d| &d.name);
        let names = parameters.chain(inputs).chain(coordinates).chain(definitions);
        names.map(|name| name.replace("r#", "")).collect()
    }
}

/// The entries of the mass matrix and the bias.
fn inertial<'g>(dynamics: &Dynamics<'g>) -> impl Iterator<Item = Expr<'g>> {
    let upper = dynamics
        .mass_matrix
        .iter()
        .enumerate()
        .flat_map(|(i, row)| row[i..].iter());
    upper.chain(&dynamics.bias).copied()
}

/// The place of each entry.
fn places(names: &[&str]) -> Vec<(Quantity, Vec<String>)> {
    let owned = |indices: &[&str]| indices.iter().map(|&name| name.to_owned()).collect();
    let mut places = Vec::new();
    for (i, first) in names.iter().enumerate() {
        places.extend(
            names[i..]
                .iter()
                .map(|second| (Quantity::MassMatrix, owned(&[first, second]))),
        );
    }
    for quantity in [Quantity::Bias, Quantity::Force] {
        places.extend(names.iter().map(|name| (quantity, owned(&[name]))));
    }
    places
}

/// The terms of two sums, the second first where that spares a leading minus.
fn joined(mut first: Vec<Term>, second: Vec<Term>) -> Vec<Term> {
    if let (
        [
            Term {
                negative,
                formula: sum @ Formula::Sum(_),
            },
        ],
        false,
    ) = (&first[..], second.is_empty())
    {
        first = sum.clone().into_terms(*negative);
    }
    let negative = |terms: &[Term]| terms.first().is_none_or(|term| term.negative);
    if negative(&first) && !negative(&second) {
        second.into_iter().chain(first).collect()
    } else {
        first.into_iter().chain(second).collect()
    }
}

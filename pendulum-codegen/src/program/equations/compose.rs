//! Equations of a model in their shortest form.

use std::collections::BTreeSet;
use std::iter::{repeat, repeat_n};

use num_traits::Zero;
use rustc_hash::{FxHashMap, FxHashSet};

use super::names::name_parts;
use super::torques::Torques;
use super::{ConstraintForce, Equations, Extent, Listing, Row, RowKind};
use crate::dynamics::{Balance, Lagrangian};
use crate::expr::{Definition, Expr, Formula, Normalizer, Printer, Summand};
use crate::form::expanded;
use crate::model::{Constraint, Law, Model, State};
use crate::pass::{Products, nest};

/// Maximum number of products of terms in the closed form of the text.
const BUDGET: usize = 100_000;

/// Maximum length of equations that are always expanded, in characters: names would not make them plainer.
const SHORT: usize = 2_000;

/// Length of a readable page, in characters. A form within it is preferred to any longer one.
const PAGE: usize = 4_800;

/// Weight of a character in the expanded form, which is the easiest to read.
const EXPANDED: usize = 24;

/// Weight of a character in the factored form, with nested terms.
const FACTORED: usize = 27;

/// Weight of a character in the recursive form, which is the hardest to read.
const RECURSIVE: usize = 40;

/// Equations of a scene: its forces, and the other terms both by recursion and, if its code has one, in closed form.
/// The full form is left empty if it is not needed.
pub(crate) fn equations<'g>(
    model: &Model<'g>,
    force: &[Expr<'g>],
    extent: Extent,
    recursive: (&Balance<'g>, &Lagrangian<'g>),
    closed: Option<(&Balance<'g>, &Lagrangian<'g>)>,
) -> Equations {
    let mut composer = Composer {
        model,
        recursion: inertial(recursive),
        closed: closed.map(inertial),
        torques: Torques::new(model),
        normalizer: Normalizer::with_angles(model.graph, BUDGET, model.base_angles()),
    };
    if composer.closed.is_none() {
        composer.closed = composer.expanded(&composer.recursion.clone(), Products::Expanded);
    }
    Equations {
        constraint_forces: composer.constraint_forces(),
        closings: composer.closings(),
        states: composer.states(),
        coordinates: model.coordinate_names().into_iter().map(str::to_owned).collect(),
        driven: !model.drives.is_empty(),
        acted: !model.actions.is_empty(),
        short: composer.short(),
        full: match extent {
            Extent::Full => composer.full(force),
            _ => Listing::default(),
        },
    }
}

struct Composer<'m, 'g> {
    model: &'m Model<'g>,
    /// Mass matrix and bias, by recursion over the links.
    recursion: Vec<Expr<'g>>,
    /// Mass matrix and bias, expanded, unless they are too long.
    closed: Option<Vec<Expr<'g>>>,
    torques: Torques<'g>,
    normalizer: Normalizer<'g>,
}

impl<'g> Composer<'_, 'g> {
    /// Shortest form, or one nearly as short that is easier to read.
    fn short(&mut self) -> Listing {
        let force = self.shorter(&self.torques.passive.clone());
        let mut candidates = Vec::new();
        if let Some(closed) = self.closed.clone() {
            let entries = [&closed[..], &force].concat();
            if !self.is_endless(&entries) {
                let flat = Candidate::new(self.listing(&entries, false, true), EXPANDED);
                // expanded loop closures are hard to read
                if flat.length <= SHORT && self.model.dependents.is_empty() {
                    return flat.listing;
                }
                candidates.push(flat);
            }
            candidates.extend(self.named(&closed, &force, true, EXPANDED));
            if let Some(factored) = self.expanded(&self.recursion.clone(), Products::Factored) {
                candidates.extend(self.named(&factored, &force, true, FACTORED));
            }
        }
        candidates.extend(self.named(&self.recursion, &force, true, RECURSIVE));
        best(candidates)
    }

    /// Form with the torques multiplied out.
    fn full(&mut self, force: &[Expr<'g>]) -> Listing {
        let force = self.shorter(force);
        let entries = self.closed.as_ref().map(|closed| [closed, &force[..]].concat());
        match entries {
            Some(entries) if !self.is_endless(&entries) => self.listing(&entries, false, false),
            _ => best(self.named(&self.recursion, &force, false, RECURSIVE)),
        }
    }

    /// Expressions that vanish where loops are closed.
    fn closings(&mut self) -> Vec<Formula> {
        let rows = self.shorter(&self.model.with_drives(&self.model.loops.closings));
        let printer = Printer::that_computes(self.model.graph);
        rows.into_iter().map(|row| printer.short(row.id())).collect()
    }

    /// Time derivatives of the first-order states.
    fn states(&self) -> Vec<Definition> {
        let printer = Printer::that_computes(self.model.graph);
        let rates = self.model.states.iter().zip(self.model.state_rates());
        let definition = |(state, rate): (&State<'g>, Expr<'g>)| Definition {
            name: state.name.trim_start_matches("r#").to_owned(),
            formula: printer.short(rate.id()),
        };
        rates.map(definition).collect()
    }

    /// Forces along the constraints, and their laws.
    fn constraint_forces(&mut self) -> Vec<ConstraintForce> {
        let values = self.shorter(&self.model.with_drives(&self.model.constraint_values()));
        let printer = Printer::that_computes(self.model.graph);
        let formula = |x: Expr<'g>| printer.short(x.id());
        let constraint_force = |(constraint, value): (&Constraint<'g>, Expr<'g>)| {
            let Law {
                slipping,
                sticking,
                low,
                high,
                restitution,
                slow,
            } = constraint.law;
            let mut law = Vec::new();
            if !sticking.is_zero() {
                law.push(("dry friction of", formula(slipping)));
                law.extend((sticking != slipping).then(|| (", at rest up to", formula(sticking))));
            }
            let separator = if law.is_empty() {
                ["stops at", "a wall at the zero of"]
            } else {
                ["; stops at", ""]
            };
            match (low, high) {
                (Some(low), Some(high)) => law.extend([(separator[0], formula(low)), (" and", formula(high))]),
                (Some(_), None) => law.push((separator[1], formula(value))),
                _ => {}
            }
            if low.is_some() {
                law.push((", restitution", formula(restitution)));
                law.extend((!slow.is_zero()).then(|| (" from a rate of", formula(slow))));
            }
            ConstraintForce {
                force: formula(constraint.force),
                law,
            }
        };
        self.model
            .constraints
            .iter()
            .zip(values)
            .map(constraint_force)
            .collect()
    }

    /// Expands forces, unless the result is too long.
    fn forces(&mut self, force: &[Expr<'g>]) -> Vec<Expr<'g>> {
        self.expanded(force, Products::Expanded)
            .unwrap_or_else(|| force.to_vec())
    }

    /// Expands forces. If something acts beside the joints, a force is expanded only where this shortens it: a quotient
    /// by a sum would be repeated in every term.
    fn shorter(&mut self, force: &[Expr<'g>]) -> Vec<Expr<'g>> {
        if self.model.actions.is_empty() {
            return self.forces(force);
        }
        let pairs = self.forces(force).into_iter().zip(force.iter().copied());
        let shorter = |(written_out, own): (Expr<'g>, Expr<'g>)| {
            if written_out.length() <= own.length() {
                written_out
            } else {
                own
            }
        };
        pairs.map(shorter).collect()
    }

    /// Entries with names for repeated parts, both with nested sums and as they are.
    fn named(&self, inertial: &[Expr<'g>], force: &[Expr<'g>], with_torques: bool, weight: usize) -> [Candidate; 2] {
        let entries = [inertial, force].concat();
        [nest(self.model.graph, &entries), entries]
            .map(|entries| Candidate::new(self.listing(&entries, true, with_torques), weight))
    }

    fn expanded(&mut self, rows: &[Expr<'g>], products: Products) -> Option<Vec<Expr<'g>>> {
        let columns = expanded(&mut self.normalizer, &[rows.to_vec()], products)?;
        columns.into_iter().next()
    }

    /// Entries as formulas. Common parts may be named, and torques may be added to the forces as written.
    fn listing(&self, entries: &[Expr<'g>], named: bool, with_torques: bool) -> Listing {
        let places = places(&self.model.coordinate_names());
        let rows = places
            .iter()
            .map(|(kind, indices)| Formula::Entry(kind.letter(), indices.clone()));
        let mut labelled: Vec<(Formula, Expr<'g>)> = rows.zip(entries.iter().copied()).collect();
        labelled.extend(self.dependents(entries, with_torques));
        let (printer, parts) = if named {
            name_parts(self.model, &labelled, &self.taken())
        } else {
            (Printer::that_computes(self.model.graph), Vec::new())
        };
        let mut known = BTreeSet::new();
        let mut formulas = labelled.into_iter().map(|(label, x)| {
            let formula = match known.insert(x) {
                true => printer.definition(x.id()),
                false => printer.formula(x.id()),
            };
            (label, formula)
        });
        let torques = self.torques.rows.iter().filter(|_| with_torques);
        let forces = places.len() - self.model.dof();
        let torques = repeat_n(None, forces).chain(torques.map(Some)).chain(repeat(None));
        let mut listing = Listing::default();
        for (((kind, indices), (_, own)), torque) in places.into_iter().zip(&mut formulas).zip(torques) {
            let own = match own {
                Formula::Number(zero) if zero.is_zero() => Vec::new(),
                own => own.into_terms(false),
            };
            let terms = joined(own, torque.cloned().unwrap_or_default());
            if !terms.is_empty() {
                listing.rows.push(Row {
                    kind,
                    indices,
                    formula: Formula::sum(terms),
                });
            }
        }
        let dependents = formulas.map(|(label, formula)| Definition {
            name: label.to_string(),
            formula,
        });
        let dependents: Vec<Definition> = dependents.collect();
        if with_torques {
            let rows = listing.rows.iter().map(|row| &row.formula);
            listing.definitions = self.torques.definitions(self.model, rows);
        }
        listing.definitions.extend(dependents);
        listing.definitions.extend(parts);
        listing.definitions = in_order(listing.definitions);
        listing
    }

    /// True if an entry, or a quantity determined by closed loops, is too long to be written without names for repeated
    /// parts.
    fn is_endless(&self, entries: &[Expr<'g>]) -> bool {
        /// Maximum number of operations in an entry without named parts.
        const MOST: u64 = 10_000;
        let dependents = self.model.loops.dependence.definitions().map(|(_, value)| value);
        entries.iter().copied().chain(dependents).any(|x| x.length() > MOST)
    }

    /// Quantities determined by closed loops that entries mention, or their torques: names and values.
    fn dependents(&self, entries: &[Expr<'g>], with_torques: bool) -> Vec<(Formula, Expr<'g>)> {
        let names_of = |roots: &[Expr<'g>]| self.model.graph.symbols_of(roots).map(|symbol| symbol.name.clone());
        let mut mentioned: FxHashSet<String> = names_of(entries).collect();
        if with_torques {
            let rows: Vec<Formula> = self.torques.rows.iter().map(|row| Formula::sum(row.clone())).collect();
            let definitions = self.torques.definitions(self.model, &rows);
            let formulas = rows
                .iter()
                .chain(definitions.iter().map(|definition| &definition.formula));
            mentioned.extend(formulas.flat_map(Formula::mentions));
        }
        let of_state = self
            .model
            .loops
            .dependents
            .iter()
            .filter(|dependent| dependent.in_state);
        let solved = of_state.flat_map(|dependent| dependent.slopes.iter().chain([&dependent.drift]));
        // these are determined by linear equations alone
        let solved: FxHashSet<Expr<'g>> = solved.copied().collect();
        let printer = Printer::that_computes(self.model.graph);
        let mut found = Vec::new();
        let definitions: Vec<(Expr<'g>, Expr<'g>)> = self.model.loops.dependence.definitions().collect();
        for (symbol, value) in definitions.into_iter().rev() {
            let label = printer.formula(symbol.id());
            if mentioned.contains(&label.to_string()) && !solved.contains(&symbol) {
                mentioned.extend(names_of(&[value]));
                found.push((label, value));
            }
        }
        found.reverse();
        found
    }

    /// Names not available to parts.
    fn taken(&self) -> BTreeSet<String> {
        let mut taken = self.model.names();
        taken.extend(self.torques.named.iter().map(|torque| torque.name.clone()));
        let dependents = self.model.loops.dependence.definitions();
        taken.extend(dependents.filter_map(|(symbol, _)| Some(symbol.as_symbol()?.name.clone())));
        taken
    }
}

/// One way to write the equations.
struct Candidate {
    listing: Listing,
    /// Length of the text.
    length: usize,
    /// Weight of a character.
    weight: usize,
}

impl Candidate {
    fn new(listing: Listing, weight: usize) -> Self {
        let length = listing.to_string().len();
        Self {
            listing,
            length,
            weight,
        }
    }
}

/// Returns the candidate of the least weight. Candidates that fit on a page are preferred.
fn best(candidates: impl IntoIterator<Item = Candidate>) -> Listing {
    let best = candidates
        .into_iter()
        .min_by_key(|candidate| (candidate.length > PAGE, candidate.weight * candidate.length));
    best.map(|candidate| candidate.listing).unwrap_or_default()
}

/// Entries of the mass matrix, as its upper triangle, and of the bias.
fn inertial<'g>((balance, lagrangian): (&Balance<'g>, &Lagrangian<'g>)) -> Vec<Expr<'g>> {
    [balance.upper_triangle(), lagrangian.bias.clone()].concat()
}

/// Kind and indices of each entry.
fn places(names: &[&str]) -> Vec<(RowKind, Vec<String>)> {
    let owned = |indices: &[&str]| indices.iter().map(|&name| name.to_owned()).collect();
    let mut places = Vec::new();
    for (i, first) in names.iter().enumerate() {
        places.extend(
            names[i..]
                .iter()
                .map(|second| (RowKind::MassMatrix, owned(&[first, second]))),
        );
    }
    for kind in [RowKind::Bias, RowKind::Force] {
        places.extend(names.iter().map(|name| (kind, owned(&[name]))));
    }
    places
}

/// Concatenates the terms of two sums, with the second in front where this avoids a leading minus.
fn joined(mut first: Vec<Summand>, second: Vec<Summand>) -> Vec<Summand> {
    if let (
        [
            Summand {
                negative,
                formula: sum @ Formula::Sum(_),
            },
        ],
        false,
    ) = (&first[..], second.is_empty())
    {
        first = sum.clone().into_terms(*negative);
    }
    let negative = |terms: &[Summand]| terms.first().is_none_or(|term| term.negative);
    if negative(&first) && !negative(&second) {
        second.into_iter().chain(first).collect()
    } else {
        first.into_iter().chain(second).collect()
    }
}

/// Sorts definitions so that each follows those it needs, and keeps their order otherwise.
fn in_order(definitions: Vec<Definition>) -> Vec<Definition> {
    let names = definitions.iter().map(|definition| definition.name.clone());
    let places: FxHashMap<String, usize> = names.zip(0..).collect();
    let mut left: Vec<Option<Definition>> = definitions.into_iter().map(Some).collect();
    let mut order = Vec::new();
    (0..left.len()).for_each(|n| put_behind(n, &places, &mut left, &mut order));
    order
}

/// Appends a definition after those it needs, unless it was appended before.
fn put_behind(
    n: usize,
    places: &FxHashMap<String, usize>,
    left: &mut [Option<Definition>],
    order: &mut Vec<Definition>,
) {
    let Some(definition) = left[n].take() else { return };
    let mentions = definition.formula.mentions();
    let needed: BTreeSet<usize> = mentions.iter().filter_map(|name| places.get(name).copied()).collect();
    for m in needed {
        put_behind(m, places, left, order);
    }
    order.push(definition);
}

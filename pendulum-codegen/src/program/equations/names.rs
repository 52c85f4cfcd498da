//! Names for repeated parts.

use std::collections::BTreeSet;

use rustc_hash::FxHashMap;

use crate::expr::{
    Binary, Definition, Expr, ExprId, Formula, Graph, Level, Node, Precedence, Printer, SymbolKind, Unary,
};
use crate::model::Model;

/// Maximum number of operations in a plain expression that is left without a name.
const LONGEST_PLAIN: u64 = 100;

/// Names the repeated parts of the entries. Returns a printer that uses the names, and their definitions. Of two equal
/// entries the second refers to the first; likewise an entry that contains another refers to it.
pub(super) fn name_parts<'g>(
    model: &Model<'g>,
    entries: &[(Formula, Expr<'g>)],
    taken: &BTreeSet<String>,
) -> (Printer<'g>, Vec<Definition>) {
    let g = model.graph;
    let roots: Vec<ExprId> = entries.iter().map(|(_, root)| root.id()).collect();
    let reachable = g.reachable(&roots);
    let uses = uses(g, &reachable, &roots);
    let mut names = Names {
        graph: g,
        printer: Printer::that_computes(g),
        suffixes: suffixes(model),
        combinations: combinations(g, &reachable),
        adds_up: false,
        taken: taken.clone(),
        given: FxHashMap::default(),
        temporaries: 0,
    };
    names.adds_up = reachable
        .iter()
        .any(|&id| names.sum_of_symbols(id).is_some_and(|symbols| symbols.len() > 3));
    let mut named = Vec::new();
    for id in reachable {
        let count = uses.get(&id).copied().unwrap_or_default();
        let entry = entries.iter().find(|(_, root)| root.id() == id).map(|(entry, _)| entry);
        let is_leaf = g.operands(id).next().is_none();
        if is_leaf || g.level(id) == Level::Constant || count == 0 {
            continue;
        }
        match entry {
            Some(entry) => {
                if names.length(id) > entry.to_string().len() {
                    names.printer.name(id, entry.clone());
                }
            }
            None => named.extend(names.give(id, count).then_some(id)),
        }
    }
    named.sort_by_key(|&id| names.order(id));
    let definition = |&id: &ExprId| Definition {
        name: names.given[&id].clone(),
        formula: names.printer.definition(id),
    };
    let definitions = named.iter().map(definition).collect();
    (names.printer, definitions)
}

/// Number of uses of each expression: as an operand, or as an entry whose value is that of an earlier one.
fn uses(g: &Graph, reachable: &[ExprId], roots: &[ExprId]) -> FxHashMap<ExprId, usize> {
    let mut uses: FxHashMap<ExprId, usize> = FxHashMap::default();
    for operand in reachable.iter().flat_map(|&id| g.operands(id)) {
        *uses.entry(operand).or_default() += 1;
    }
    let mut seen = BTreeSet::new();
    for &root in roots.iter().filter(|root| !seen.insert(**root)) {
        *uses.entry(root).or_default() += 1;
    }
    uses
}

/// Suffix of each coordinate in composed names: its number, if all coordinates have distinct ones, or else its name.
fn suffixes(model: &Model<'_>) -> FxHashMap<ExprId, String> {
    let number = |name: &str| name.trim_start_matches(|c: char| !c.is_ascii_digit()).to_owned();
    let numbers: Vec<String> = model.coordinate_names().into_iter().map(number).collect();
    let distinct: BTreeSet<&String> = numbers.iter().collect();
    let numbered = distinct.len() == numbers.len()
        && numbers
            .iter()
            .all(|n| !n.is_empty() && n.len() < 3 && n.chars().all(|c| c.is_ascii_digit()));
    let suffix = |name: &str, number: &String| if numbered { number.clone() } else { format!("_{name}") };
    let coordinates = model.coordinates.iter().zip(model.coordinate_names()).zip(&numbers);
    coordinates
        .flat_map(|((coordinate, name), number)| {
            let suffix = suffix(name, number);
            [
                (coordinate.position.id(), suffix.clone()),
                (coordinate.rate.id(), suffix),
            ]
        })
        .collect()
}

struct Names<'g> {
    graph: &'g Graph,
    printer: Printer<'g>,
    suffixes: FxHashMap<ExprId, String>,
    combinations: FxHashMap<ExprId, Combination>,
    /// True if angles add up along a chain long enough to give them names of their own.
    adds_up: bool,
    taken: BTreeSet<String>,
    given: FxHashMap<ExprId, String>,
    temporaries: usize,
}

impl Names<'_> {
    fn length(&self, id: ExprId) -> usize {
        self.printer.definition(id).to_string().len()
    }

    /// Names an expression that is used `count` times, unless the text is shorter or plainer without the name.
    fn give(&mut self, id: ExprId, count: usize) -> bool {
        let meaning = self.meaning(id).filter(|name| !self.taken.contains(name));
        if count < 2 && meaning.is_none() {
            return false;
        }
        let formula = self.printer.definition(id);
        let name = match meaning {
            Some(name) if self.is_customary(id, count) => name,
            _ if self.graph.length(id) <= LONGEST_PLAIN && self.is_plain(id, &formula) => return false,
            meaning => {
                let name = meaning.unwrap_or_else(|| self.temporary());
                let brackets = if formula.precedence() == Precedence::Sum { 2 } else { 0 };
                let definition = formula.to_string().len();
                // ` = ` and the end of the line
                let with_name = (count + 1) * name.len() + definition + 4;
                if count < 2 || count * (definition + brackets) <= with_name {
                    return false;
                }
                name
            }
        };
        self.taken.insert(name.clone());
        self.printer.name(id, Formula::Name(name.clone()));
        self.given.insert(id, name);
        true
    }

    /// True if the expression customarily has a name: repeated sines and cosines, and angles that add up along a chain.
    fn is_customary(&self, id: ExprId, count: usize) -> bool {
        match self.sum_of_symbols(id) {
            Some(_) => self.adds_up,
            None => count > 1,
        }
    }

    /// True if the expression is plainer than a name for it: a product of names and calls, or a sum of coordinates.
    fn is_plain(&self, id: ExprId, formula: &Formula) -> bool {
        match formula {
            Formula::Sum(_) => self
                .combinations
                .get(&id)
                .is_some_and(|combination| !combination.are_rates),
            Formula::Call(..) => false,
            _ => is_product(formula),
        }
    }

    /// Sort key of definitions: angles, each with its sine and cosine, then rates, then the rest. Each follows those it
    /// needs.
    fn order(&self, id: ExprId) -> (u8, ExprId, ExprId) {
        match *self.graph.node(id) {
            Node::Unary(Unary::Sin | Unary::Cos, angle) if self.suffix_of_angle(angle).is_some() => (0, angle, id),
            _ => match self.sum_of_symbols(id) {
                Some(_) if !self.combinations[&id].are_rates => (0, id, id),
                Some(_) => (1, id, id),
                None => (2, id, id),
            },
        }
    }

    fn temporary(&mut self) -> String {
        loop {
            let name = format!("t{}", self.temporaries);
            if !self.taken.contains(&name) {
                return name;
            }
            self.temporaries += 1;
        }
    }

    /// Customary name of an expression: `s12` and `c12` for the sine and the cosine of an angle of the coordinates `q1`
    /// and `q2`, `w12` for the rate of their sum. Where angles add up along a chain, `a4` and `w4` for the sum up to
    /// `q4` and its rate.
    fn meaning(&self, id: ExprId) -> Option<String> {
        let g = self.graph;
        if let Node::Unary(op @ (Unary::Sin | Unary::Cos), angle) = *g.node(id) {
            let letter = if op == Unary::Sin { "s" } else { "c" };
            return Some(format!("{letter}{}", self.suffix_of_angle(angle)?));
        }
        let symbols = self.sum_of_symbols(id)?;
        let of_rates = self.combinations[&id].are_rates;
        match (of_rates, self.adds_up) {
            (false, false) => None,
            (_, true) => Some(format!(
                "{}{}",
                if of_rates { "w" } else { "a" },
                self.suffixes.get(symbols.last()?)?
            )),
            (true, false) => Some(format!("w{}", self.suffix(symbols)?)),
        }
    }

    fn suffix(&self, symbols: &[ExprId]) -> Option<String> {
        symbols
            .iter()
            .map(|symbol| self.suffixes.get(symbol).map(String::as_str))
            .collect()
    }

    fn suffix_of_angle(&self, angle: ExprId) -> Option<String> {
        /// Maximum length of a suffix: longer names are no shorter than the expression.
        const MOST: usize = 12;
        let suffix = match self.given.get(&angle) {
            Some(name) => name.strip_prefix('a')?.to_owned(),
            None => self.suffix(&self.combinations.get(&angle)?.symbols)?,
        };
        (suffix.len() <= MOST).then_some(suffix)
    }

    /// Symbols of a sum of at least two coordinates, or rates.
    fn sum_of_symbols(&self, id: ExprId) -> Option<&[ExprId]> {
        let combination = self.combinations.get(&id)?;
        (combination.only_added && combination.symbols.len() > 1).then_some(&combination.symbols)
    }
}

/// Coordinates, or rates, that are added and subtracted.
#[derive(Clone, Debug)]
struct Combination {
    symbols: Vec<ExprId>,
    only_added: bool,
    are_rates: bool,
}

/// Expressions that are combinations of coordinates or of rates.
fn combinations(g: &Graph, reachable: &[ExprId]) -> FxHashMap<ExprId, Combination> {
    let mut known: FxHashMap<ExprId, Combination> = FxHashMap::default();
    for &id in reachable {
        let combination = match *g.node(id) {
            Node::Symbol(s) => match g.name_and_kind(s).kind {
                kind @ (SymbolKind::Coordinate(_) | SymbolKind::Rate(_)) => Some(Combination {
                    symbols: vec![id],
                    only_added: true,
                    are_rates: matches!(kind, SymbolKind::Rate(_)),
                }),
                _ => None,
            },
            Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => match (known.get(&a), known.get(&b)) {
                (Some(a), Some(b)) if a.are_rates == b.are_rates => {
                    let mut symbols = [&a.symbols[..], &b.symbols].concat();
                    symbols.sort_unstable();
                    let only_added = a.only_added && b.only_added && op == Binary::Add;
                    Some(Combination {
                        symbols,
                        only_added,
                        are_rates: a.are_rates,
                    })
                }
                _ => None,
            },
            _ => None,
        };
        known.extend(combination.map(|combination| (id, combination)));
    }
    known
}

/// True if a formula has no sums outside the arguments of functions.
fn is_product(formula: &Formula) -> bool {
    match formula {
        Formula::Sum(_) => false,
        Formula::Call(..) => true,
        _ => formula.parts().into_iter().all(is_product),
    }
}

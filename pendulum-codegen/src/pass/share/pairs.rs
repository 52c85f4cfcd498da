//! The pair of operands that most sums, or products, share: found and taken out, again and again.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use rustc_hash::FxHashMap;

use super::parts::{Item, Operand, Parts, Ref};

/// Two operands of one sum or product, and whether their signs differ.
type Pair = (Ref, Ref, bool);

/// Up to this many operands of one sum or product all pairs are looked at. Of more, each operand makes pairs with those that are
/// near it.
const MOST_OPERANDS: usize = 64;

/// How many operands are near.
const NEAR: usize = 16;

/// Where pairs are looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Of {
    Sums,
    Products,
}

/// Takes out pairs of all sums, or of all products, until none stands in two places.
pub(super) fn share_pairs(parts: &mut Parts, of: Of) {
    let mut search = Search {
        parts,
        of,
        places: FxHashMap::default(),
        queue: BTreeSet::new(),
    };
    for item in 0..search.parts.items.len() {
        search.count(item, true, |_| true);
    }
    while let Some((_, Reverse(pair))) = search.queue.pop_last() {
        search.extract(pair);
    }
}

/// The state of a search.
struct Search<'p> {
    parts: &'p mut Parts,
    of: Of,
    /// In which items each pair stands, and how often.
    places: FxHashMap<Pair, BTreeMap<Ref, usize>>,
    /// Pairs that stand in two places or more; the most frequent last.
    queue: BTreeSet<(usize, Reverse<Pair>)>,
}

impl Of {
    fn item(self, operands: Vec<Operand>) -> Item {
        match self {
            Self::Sums => Item::Sum(operands),
            Self::Products => Item::Product(operands),
        }
    }
}

impl Search<'_> {
    fn operands(&self, item: Ref) -> Option<&Vec<Operand>> {
        match (&self.parts.items[item], self.of) {
            (Item::Sum(operands), Of::Sums) | (Item::Product(operands), Of::Products) => Some(operands),
            _ => None,
        }
    }

    /// The pairs of one item of which at least one operand is of interest, each with the number of times it can be taken out.
    fn pairs(&self, item: Ref, of_interest: impl Fn(Ref) -> bool) -> Vec<(Pair, usize)> {
        let Some(operands) = self.operands(item) else {
            return Vec::new();
        };
        let mut multiplicity: BTreeMap<Operand, usize> = BTreeMap::new();
        for &operand in operands {
            *multiplicity.entry(operand).or_default() += 1;
        }
        let distinct: Vec<(Operand, usize)> = multiplicity.into_iter().collect();
        let mut pairs: BTreeMap<Pair, usize> = BTreeMap::new();
        let near = if distinct.len() > MOST_OPERANDS {
            NEAR
        } else {
            MOST_OPERANDS
        };
        for (n, &((a, minus_a), count_a)) in distinct.iter().enumerate() {
            let a_matters = of_interest(a);
            if a_matters && self.of == Of::Products && count_a > 1 && !self.parts.constant[a] {
                pairs.insert((a, a, false), count_a / 2);
            }
            for &((b, minus_b), count_b) in distinct[n + 1..].iter().take(near) {
                if a != b && (a_matters || of_interest(b)) && !(self.parts.constant[a] && self.parts.constant[b]) {
                    *pairs.entry((a, b, minus_a != minus_b)).or_default() += count_a.min(count_b);
                }
            }
        }
        pairs.into_iter().collect()
    }

    /// Adds pairs of an item to the count, or takes them off.
    fn count(&mut self, item: Ref, add: bool, of_interest: impl Fn(Ref) -> bool) {
        for (pair, times) in self.pairs(item, of_interest) {
            let places = self.places.entry(pair).or_default();
            let before: usize = places.values().sum();
            if add {
                places.insert(item, times);
            } else {
                places.remove(&item);
            }
            let after: usize = places.values().sum();
            self.queue.remove(&(before, Reverse(pair)));
            if after >= 2 {
                self.queue.insert((after, Reverse(pair)));
            }
        }
    }

    fn extract(&mut self, pair: Pair) {
        let (a, b, opposite) = pair;
        let places: Vec<Ref> = self
            .places
            .get(&pair)
            .into_iter()
            .flat_map(|places| places.keys().copied())
            .collect();
        let whole = self.of.item(vec![(a, false), (b, opposite)]);
        let whole = self.parts.item(whole, false);
        for item in places {
            if item == whole {
                continue;
            }
            let Some(mut operands) = self.operands(item).cloned() else {
                continue;
            };
            // other pairs stay as they are, unless only near operands make pairs, and others come near
            let is_long = operands.len() > MOST_OPERANDS;
            let changes = |operand: Ref| is_long || [a, b, whole].contains(&operand);
            self.count(item, false, changes);
            for minus in [false, true] {
                let (first, second) = ((a, minus), (b, minus != opposite));
                while let Some((i, j)) = positions(&operands, first, second) {
                    operands.remove(i.max(j));
                    operands.remove(i.min(j));
                    operands.push((whole, minus));
                }
            }
            operands.sort_unstable();
            self.parts.items[item] = self.of.item(operands);
            self.count(item, true, changes);
        }
    }
}

/// Where two different operands stand.
fn positions(operands: &[Operand], first: Operand, second: Operand) -> Option<(usize, usize)> {
    let i = operands.iter().position(|operand| *operand == first)?;
    let j = operands
        .iter()
        .enumerate()
        .position(|(n, operand)| n != i && *operand == second)?;
    Some((i, j))
}

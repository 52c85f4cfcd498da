//! Repeated extraction of the pair of operands that most sums, or products, share.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use rustc_hash::FxHashMap;

use super::parts::{Item, Operand, Parts, Ref};

/// Two operands of one sum or product; the flag is true if their signs differ.
type Pair = (Ref, Ref, bool);

/// Maximum number of operands of a sum or product before it is split: the number of pairs grows with its square.
const MOST_OPERANDS: usize = 64;

/// Kind of items whose pairs are shared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Of {
    Sums,
    Products,
}

/// Extracts pairs from all sums, or from all products, until no pair occurs twice.
pub(super) fn share_pairs(parts: &mut Parts, of: Of) {
    split(parts, of);
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

/// Splits sums with too many operands into sums of sums, and products likewise. Equal leading operands give equal
/// parts.
fn split(parts: &mut Parts, of: Of) {
    let mut item = 0;
    while item < parts.items.len() {
        while let Some(operands) = of.operands(&parts.items[item])
            && operands.len() > MOST_OPERANDS
        {
            let operands = operands.clone();
            let chunks = operands.chunks(MOST_OPERANDS / 2).map(|chunk| match of {
                Of::Sums => parts.sum(chunk.to_vec()),
                Of::Products => (parts.product(chunk.iter().map(|(factor, _)| *factor).collect()), false),
            });
            let mut chunks: Vec<Operand> = chunks.collect();
            chunks.sort_unstable();
            parts.items[item] = of.item(chunks);
        }
        item += 1;
    }
}

/// State of the search.
struct Search<'p> {
    parts: &'p mut Parts,
    of: Of,
    /// Items that contain each pair, with its count in each, and its total count.
    places: FxHashMap<Pair, (BTreeMap<Ref, usize>, usize)>,
    /// Pairs with a total count of at least 2, most frequent last.
    queue: BTreeSet<(usize, Reverse<Pair>)>,
}

impl Of {
    fn operands(self, item: &Item) -> Option<&Vec<Operand>> {
        match (item, self) {
            (Item::Sum(operands), Self::Sums) | (Item::Product(operands), Self::Products) => Some(operands),
            _ => None,
        }
    }

    fn item(self, operands: Vec<Operand>) -> Item {
        match self {
            Self::Sums => Item::Sum(operands),
            Self::Products => Item::Product(operands),
        }
    }
}

impl Search<'_> {
    fn operands(&self, item: Ref) -> Option<&Vec<Operand>> {
        self.of.operands(&self.parts.items[item])
    }

    /// Pairs of an item with at least one operand of interest, each with the number of times it can be extracted.
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
        for (n, &((a, minus_a), count_a)) in distinct.iter().enumerate() {
            let a_matters = of_interest(a);
            if a_matters && self.of == Of::Products && count_a > 1 && !self.parts.constant[a] {
                pairs.insert((a, a, false), count_a / 2);
            }
            for &((b, minus_b), count_b) in &distinct[n + 1..] {
                if a != b && (a_matters || of_interest(b)) && !(self.parts.constant[a] && self.parts.constant[b]) {
                    *pairs.entry((a, b, minus_a != minus_b)).or_default() += count_a.min(count_b);
                }
            }
        }
        pairs.into_iter().collect()
    }

    /// Adds the pairs of an item to the counts, or subtracts them.
    fn count(&mut self, item: Ref, add: bool, of_interest: impl Fn(Ref) -> bool) {
        for (pair, times) in self.pairs(item, of_interest) {
            let (places, count) = self.places.entry(pair).or_default();
            let before = *count;
            let replaced = if add {
                places.insert(item, times)
            } else {
                places.remove(&item)
            };
            *count = *count + if add { times } else { 0 } - replaced.unwrap_or(0);
            let after = *count;
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
            .flat_map(|(places, _)| places.keys().copied())
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
            // only pairs with these operands change
            let changes = |operand: Ref| [a, b, whole].contains(&operand);
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

/// Positions of two different operands.
fn positions(operands: &[Operand], first: Operand, second: Operand) -> Option<(usize, usize)> {
    let i = operands.iter().position(|operand| *operand == first)?;
    let j = operands
        .iter()
        .enumerate()
        .position(|(n, operand)| n != i && *operand == second)?;
    Some((i, j))
}

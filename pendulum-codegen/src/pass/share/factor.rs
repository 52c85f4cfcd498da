//! Extraction of common factors from the terms of a sum.

use std::collections::BTreeMap;

use super::parts::{Item, Operand, Parts, Ref};

/// Rewrites `f x + f y + z` as `f (x + y) + z` in every sum, most frequent factor first. Products with other uses are
/// left unchanged.
pub(super) fn factor_sums(parts: &mut Parts, roots: &[Operand]) {
    let places = parts.count_places(roots);
    let mut item = 0;
    while item < parts.items.len() {
        while let Some(sum) = factored(parts, &places, item) {
            parts.items[item] = sum;
        }
        item += 1;
    }
}

/// Extracts the most frequent factor of a sum. Returns `None` if no two terms share a factor.
fn factored(parts: &mut Parts, places: &[usize], item: Ref) -> Option<Item> {
    let Item::Sum(operands) = &parts.items[item] else {
        return None;
    };
    let factor = most_frequent_factor(parts, places, operands)?;
    let (with, mut rest): (Vec<Operand>, Vec<Operand>) = operands
        .iter()
        .partition(|(operand, _)| own_factors(parts, places, *operand).contains(&(factor, false)));
    let mut inside = Vec::new();
    for (operand, minus) in with {
        let mut others: Vec<Ref> = own_factors(parts, places, operand)
            .iter()
            .map(|(other, _)| *other)
            .collect();
        if let Some(at) = others.iter().position(|other| *other == factor) {
            others.remove(at);
        }
        inside.push((parts.product(others), minus));
    }
    let (inside, minus) = parts.sum(inside);
    rest.push((parts.product(vec![factor, inside]), minus));
    rest.sort_unstable();
    Some(Item::Sum(rest))
}

/// Factors of a product that is used once; empty for any other item. New products count as used once.
fn own_factors<'p>(parts: &'p Parts, places: &[usize], item: Ref) -> &'p [Operand] {
    match &parts.items[item] {
        Item::Product(factors) if places.get(item).is_none_or(|&places| places == 1) => factors,
        _ => &[],
    }
}

fn most_frequent_factor(parts: &Parts, places: &[usize], operands: &[Operand]) -> Option<Ref> {
    let mut counts: BTreeMap<Ref, usize> = BTreeMap::new();
    for (operand, _) in operands {
        let mut factors: Vec<Ref> = own_factors(parts, places, *operand)
            .iter()
            .map(|(factor, _)| *factor)
            .collect();
        factors.dedup();
        for factor in factors {
            *counts.entry(factor).or_default() += 1;
        }
    }
    let best = counts
        .into_iter()
        .max_by_key(|&(factor, count)| (count, std::cmp::Reverse(factor)));
    best.filter(|&(_, count)| count >= 2).map(|(factor, _)| factor)
}

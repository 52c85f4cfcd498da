//! Values as sums and products of numbered operands, without duplicates.

use rustc_hash::FxHashMap;

use crate::expr::{Binary, ExprId, Rational, Unary};

/// Index of an item.
pub(super) type Ref = usize;

/// An operand; the flag is true if it is negated. Factors of a product are never negated: the sign goes to the product.
pub(super) type Operand = (Ref, bool);

/// A decomposed value.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Item {
    Leaf(ExprId),
    Sum(Vec<Operand>),
    Product(Vec<Operand>),
    Unary(Unary, Ref),
    Quotient(Ref, Ref),
    /// A function of two arguments that is not an operator, such as `atan2`.
    Function(Binary, Ref, Ref),
    Power(Ref, Rational),
}

/// All items, without duplicates.
#[derive(Debug, Default)]
pub(super) struct Parts {
    pub(super) items: Vec<Item>,
    /// True for each item independent of the state.
    pub(super) constant: Vec<bool>,
    refs: FxHashMap<Item, Ref>,
}

impl Parts {
    /// Returns the index of an item, which is added if it is new.
    pub(super) fn item(&mut self, item: Item, constant: bool) -> Ref {
        if let Some(&known) = self.refs.get(&item) {
            return known;
        }
        self.items.push(item.clone());
        self.constant.push(constant);
        self.refs.insert(item, self.items.len() - 1);
        self.items.len() - 1
    }

    /// Sum of operands; a single operand is returned as it is.
    pub(super) fn sum(&mut self, mut operands: Vec<Operand>) -> Operand {
        operands.sort_unstable();
        match operands[..] {
            [only] => only,
            _ => {
                let constant = operands.iter().all(|(item, _)| self.constant[*item]);
                (self.item(Item::Sum(operands), constant), false)
            }
        }
    }

    /// Product of factors; a single factor is returned as it is.
    pub(super) fn product(&mut self, mut factors: Vec<Ref>) -> Ref {
        factors.sort_unstable();
        match factors[..] {
            [only] => only,
            _ => {
                let constant = factors.iter().all(|item| self.constant[*item]);
                self.item(
                    Item::Product(factors.into_iter().map(|item| (item, false)).collect()),
                    constant,
                )
            }
        }
    }

    /// Number of uses of each item, counted from the roots.
    pub(super) fn count_places(&self, roots: &[Operand]) -> Vec<usize> {
        let mut places = vec![0; self.items.len()];
        let mut stack: Vec<Ref> = roots.iter().map(|(item, _)| *item).collect();
        while let Some(item) = stack.pop() {
            places[item] += 1;
            if places[item] == 1 {
                match &self.items[item] {
                    Item::Leaf(_) => {}
                    Item::Sum(operands) | Item::Product(operands) => {
                        stack.extend(operands.iter().map(|(item, _)| *item));
                    }
                    Item::Unary(_, a) | Item::Power(a, _) => stack.push(*a),
                    Item::Quotient(a, b) | Item::Function(_, a, b) => stack.extend([*a, *b]),
                }
            }
        }
        places
    }
}

//! Values as sums and products of operands, numbered and without repetition.

use rustc_hash::FxHashMap;

use crate::expr::{Binary, ExprId, Rational, Unary};

/// The number of an item.
pub(super) type Ref = usize;

/// An operand, and whether it counts negative. Factors of a product are never negative: the product is.
pub(super) type Operand = (Ref, bool);

/// A value taken apart.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Item {
    Leaf(ExprId),
    Sum(Vec<Operand>),
    Product(Vec<Operand>),
    Unary(Unary, Ref),
    Quotient(Ref, Ref),
    /// A function of two: no operator.
    Function(Binary, Ref, Ref),
    Power(Ref, Rational),
}

/// All items, without repetition.
#[derive(Debug, Default)]
pub(super) struct Parts {
    pub(super) items: Vec<Item>,
    /// Items that do not depend on the state.
    pub(super) constant: Vec<bool>,
    refs: FxHashMap<Item, Ref>,
}

impl Parts {
    /// The number of an item, which is new or known.
    pub(super) fn item(&mut self, item: Item, constant: bool) -> Ref {
        if let Some(&known) = self.refs.get(&item) {
            return known;
        }
        self.items.push(item.clone());
        self.constant.push(constant);
        self.refs.insert(item, self.items.len() - 1);
        self.items.len() - 1
    }

    /// The sum of operands; a single one is itself.
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

    /// The product of factors; a single one is itself.
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

    /// How often each item is used, from the roots on.
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

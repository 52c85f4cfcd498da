//! Smoothness of expressions.

use num_traits::ToPrimitive;
use rustc_hash::{FxHashMap, FxHashSet};

use super::{Binary, Expr, Level, Node, Rational, SymbolKind, Unary, ratio};

/// Number of continuous derivatives counted for a smooth function.
const SMOOTH: i64 = 16;

/// Maximum number of factors of a product to examine: shared factors can make it very long.
const MOST: usize = 1000;

impl<'g> Expr<'g> {
    /// Guaranteed number of continuous derivatives with respect to the symbols of some kinds: 0 for a corner, as `abs`
    /// has at zero, -1 for a jump, and `SMOOTH` for an expression that is smooth wherever it has a value. Points where
    /// the argument of a root, a quotient or an angle vanishes are ignored.
    pub(crate) fn continuous_derivatives(self, by: impl Fn(SymbolKind) -> bool) -> i64 {
        let mut known: FxHashMap<Self, i64> = FxHashMap::default();
        let mut varying: FxHashSet<Self> = FxHashSet::default();
        for id in self.graph().reachable(&[self]) {
            let x = self.graph().expr(id);
            let by_symbol = x.as_symbol().is_some_and(|symbol| by(symbol.kind));
            let varies = by_symbol || x.operands().any(|operand| varying.contains(&operand));
            let own = if !varies {
                SMOOTH
            } else {
                varying.insert(x);
                match x.node() {
                    Node::Unary(Unary::Sign, _) => -1,
                    Node::Binary(Binary::Max | Binary::Min, ..) => of_operands(x, &known).min(0),
                    Node::Unary(Unary::Abs, _) | Node::Binary(Binary::Mul, ..) | Node::Power(..) => {
                        of_product(x, &known)
                    }
                    _ => of_operands(x, &known),
                }
            };
            known.insert(x, own);
        }
        known[&self]
    }
}

fn of_operands<'g>(x: Expr<'g>, known: &FxHashMap<Expr<'g>, i64>) -> i64 {
    x.operands().map(|operand| known[&operand]).min().unwrap_or(SMOOTH)
}

/// Number of continuous derivatives of a product: one less than `p + n`, rounded up, for each `|u|^p u^n` in it, unless
/// `p` is even.
fn of_product<'g>(product: Expr<'g>, known: &FxHashMap<Expr<'g>, i64>) -> i64 {
    let mut factors: Vec<(Expr<'g>, Rational, Rational)> = Vec::new();
    collect(product, &ratio(1, 1), &mut factors, &mut { MOST });
    let of_factor = |(base, size, power): &(Expr<'g>, Rational, Rational)| {
        let even = (size / ratio(2, 1)).is_integer();
        let own = if even {
            SMOOTH
        } else {
            (size + power).ceil().to_integer().to_i64().map_or(SMOOTH, |n| n - 1)
        };
        own.min(known.get(base).copied().unwrap_or(SMOOTH))
    };
    factors.iter().map(of_factor).min().unwrap_or(SMOOTH).min(SMOOTH)
}

/// Collects the varying factors of a product: the base, the power of its absolute value, and its own power.
fn collect<'g>(x: Expr<'g>, power: &Rational, factors: &mut Vec<(Expr<'g>, Rational, Rational)>, budget: &mut usize) {
    if x.level() < Level::State || *budget == 0 {
        return;
    }
    *budget -= 1;
    let (base, is_size, power) = match x.node() {
        Node::Unary(Unary::Neg, inner) => return collect(inner, power, factors, budget),
        Node::Binary(Binary::Mul, a, b) => {
            collect(a, power, factors, budget);
            return collect(b, power, factors, budget);
        }
        Node::Unary(Unary::Abs, inner) => (inner, true, power.clone()),
        // a root of a square is an absolute value
        Node::Power(inner, n) if !power.is_integer() && (n / ratio(2, 1)).is_integer() => (inner, true, power * n),
        Node::Power(inner, n) => return collect(inner, &(power * n), factors, budget),
        _ => (x, false, power.clone()),
    };
    let place = match factors.iter().position(|(known, ..)| *known == base) {
        Some(place) => place,
        None => {
            factors.push((base, ratio(0, 1), ratio(0, 1)));
            factors.len() - 1
        }
    };
    let (_, size, own) = &mut factors[place];
    if is_size {
        *size += power;
    } else {
        *own += power;
    }
}

//! Collects products of sines and cosines into sums of angles: `cos a cos b + sin a sin b` becomes `cos(a - b)`.

use std::collections::BTreeSet;

use num_traits::One;

use crate::expr::{Expr, Graph, Level, Monomial, Node, Normalizer, Poly, Rational, TooLarge, Unary, ratio};

/// Maximum number of terms of a polynomial to rewrite. A longer closed form has no use: recursive forms are far
/// shorter.
const MOST_TERMS: usize = 200;

/// Maximum number of angles whose sines and cosines occur in one product.
const MOST_ANGLES: usize = 16;

/// Rewrites a normal form in sums and differences of its angles wherever this leaves fewer terms. The result is equal
/// in value and shorter, but no longer canonical.
pub(crate) fn collect(normalizer: &mut Normalizer<'_>, poly: &Poly) -> Result<Poly, TooLarge> {
    if is_large(normalizer.graph(), poly) {
        return Err(TooLarge);
    }
    let mut poly = poly.clone();
    while let Some(shorter) = step(normalizer, &poly)? {
        poly = shorter;
    }
    Ok(poly)
}

/// Like [`collect`], but replaces squares first, which finds `cos b sin(a - b)` in `sin a - cos(a - b) sin b`.
pub(crate) fn collect_squares_first(normalizer: &mut Normalizer<'_>, poly: &Poly) -> Result<Poly, TooLarge> {
    if is_large(normalizer.graph(), poly) {
        return Err(TooLarge);
    }
    let mut poly = poly.clone();
    while let Some(shorter) = squares(normalizer.graph(), &poly) {
        poly = shorter;
    }
    collect(normalizer, &poly)
}

fn is_large(graph: &Graph, poly: &Poly) -> bool {
    poly.len() > MOST_TERMS
        || poly
            .terms()
            .any(|(monomial, _)| angles_of(graph, monomial).len() > MOST_ANGLES)
}

/// An angle with its sine and cosine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Angle<'g> {
    angle: Expr<'g>,
    sine: Expr<'g>,
    cosine: Expr<'g>,
}

fn step(normalizer: &mut Normalizer<'_>, poly: &Poly) -> Result<Option<Poly>, TooLarge> {
    let graph = normalizer.graph();
    for (monomial, coefficient) in poly.terms() {
        let angles = angles_of(graph, monomial);
        for (n, &a) in angles.iter().enumerate() {
            for &b in &angles[n + 1..] {
                for (x, y) in [(a, b), (b, a)] {
                    if let Some(shorter) = pair(normalizer, poly, (monomial, coefficient), x, y)? {
                        return Ok(Some(shorter));
                    }
                }
            }
        }
    }
    Ok(squares(graph, poly))
}

fn squares(graph: &Graph, poly: &Poly) -> Option<Poly> {
    for (monomial, coefficient) in poly.terms() {
        for a in angles_of(graph, monomial) {
            if let Some(shorter) = square(poly, (monomial, coefficient), a) {
                return Some(shorter);
            }
        }
    }
    None
}

fn angles_of<'g>(graph: &'g Graph, monomial: &Monomial) -> Vec<Angle<'g>> {
    let mut angles = BTreeSet::new();
    for &(atom, _) in monomial.powers() {
        if let Node::Unary(Unary::Sin | Unary::Cos, angle) = graph.expr(atom).node()
            && angle.level() == Level::State
        {
            let (sine, cosine) = (angle.sin(), angle.cos());
            angles.insert(Angle { angle, sine, cosine });
        }
    }
    angles.into_iter().collect()
}

/// Merges two terms by the addition theorems, starting from `cos x cos y` or `sin x cos y`.
fn pair<'g>(
    normalizer: &mut Normalizer<'g>,
    poly: &Poly,
    (monomial, coefficient): (&Monomial, &Rational),
    x: Angle<'g>,
    y: Angle<'g>,
) -> Result<Option<Poly>, TooLarge> {
    let cases = [
        // cos x cos y +- sin x sin y = cos(x -+ y)
        (x.cosine, y.cosine, x.sine, y.sine, Unary::Cos, true),
        // sin x cos y +- cos x sin y = sin(x +- y)
        (x.sine, y.cosine, x.cosine, y.sine, Unary::Sin, false),
    ];
    for (p, q, r, s, op, opposite) in cases {
        if monomial.power_of(p) < 1 || monomial.power_of(q) < 1 {
            continue;
        }
        let rest = monomial.times_power(p, -1).times_power(q, -1);
        let partner = rest.times_power(r, 1).times_power(s, 1);
        let Some(other) = poly.coefficient(&partner) else {
            continue;
        };
        let same = if other == coefficient {
            true
        } else if *other == -coefficient {
            false
        } else {
            continue;
        };
        let angle = if same == opposite {
            x.angle - y.angle
        } else {
            x.angle + y.angle
        };
        let angle = normalizer.normal(angle)?;
        let whole = normalizer.to_expr(&angle).apply(op);
        let whole = match whole.node() {
            Node::Unary(Unary::Neg, positive) => Poly::term(Monomial::atom(positive), ratio(-1, 1)),
            _ => Poly::atom(whole),
        };
        let new = normalizer.product(&Poly::term(rest, coefficient.clone()), &whole)?;
        if let Some(shorter) = shorter(poly, &[monomial, &partner], &new) {
            return Ok(Some(shorter));
        }
    }
    Ok(None)
}

/// Replaces `1 - sin^2` by `cos^2`.
fn square(poly: &Poly, (monomial, coefficient): (&Monomial, &Rational), a: Angle<'_>) -> Option<Poly> {
    if monomial.power_of(a.sine) < 2 {
        return None;
    }
    let rest = monomial.times_power(a.sine, -2);
    let other = poly.coefficient(&rest).filter(|other| **other == -coefficient)?;
    let new = Poly::term(rest.times_power(a.cosine, 2), other.clone());
    shorter(poly, &[monomial, &rest], &new)
}

/// Returns the polynomial with the terms `without` replaced by `new`, if this leaves fewer terms.
fn shorter(poly: &Poly, without: &[&Monomial], new: &Poly) -> Option<Poly> {
    let mut replaced = poly.clone();
    for monomial in without {
        replaced.remove(monomial);
    }
    replaced.add_scaled(new, &Rational::one());
    (replaced.len() < poly.len()).then_some(replaced)
}

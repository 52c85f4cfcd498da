//! Uniform plates with any simple outline.

use syn::Ident;

use super::Lower;
use crate::error::{Code, Reported};
use crate::expr::{Expr, Level, Normalizer, Unary, ratio};
use crate::model::{Requirement, Rule};
use crate::screw::{SpatialInertia, Symmetric3, Vec3};

/// Maximum number of products of terms formed to normalise expressions of the corners.
const BUDGET: usize = 10_000;

impl<'g> Lower<'g> {
    /// Inertia of a uniform polygon in the xy plane, as a sum over the triangles between its sides and the origin
    /// (Green's theorem).
    pub(super) fn uniform_plate(
        &mut self,
        owner: &Ident,
        mass: Expr<'g>,
        corners: &[(Expr<'g>, Expr<'g>)],
        tokens: &proc_macro2::TokenStream,
    ) -> Result<SpatialInertia<'g>, Reported> {
        if corners.len() < 3 {
            return Err(self.errors.on(
                Code::DegenerateSolid,
                tokens,
                format_args!("a plate of `{owner}` has {} corners", corners.len()),
                "a plate needs at least three corners",
            ));
        }
        let numbers: Vec<_> = corners.iter().map(|&(x, y)| x.constant().zip(y.constant())).collect();
        if !may_be_simple(&numbers) {
            return Err(self.errors.on(
                Code::DegenerateSolid,
                tokens,
                format_args!("the sides of a plate of `{owner}` cross or touch"),
                "list the corners in order around the plate, each once",
            ));
        }
        let mut sums = [self.graph.zero(); 6]; // 2 area, 6 area (x, y), 12 integrals of (x^2, y^2), 24 of xy
        for (n, &(x0, y0)) in corners.iter().enumerate() {
            let (x1, y1) = corners[(n + 1) % corners.len()];
            let twice = x0 * y1 - x1 * y0;
            let (sx, sy) = (x0 + x1, y0 + y1);
            // a^2 + a b + b^2 = (a + b)^2 - a b, in a form without cancellation
            let (xx, yy) = (x0.powi(2) + x1 * sx, y0.powi(2) + y1 * sy);
            let xy = x0 * y0 + x1 * y1 + sx * sy;
            for (total, factor) in sums.iter_mut().zip([self.graph.one(), sx, sy, xx, yy, xy]) {
                *total += twice * factor;
            }
        }
        let [twice_area, x, y, xx, yy, xy] = sums;
        if Normalizer::new(self.graph, BUDGET).is_zero(twice_area) == Ok(true) {
            return Err(self.errors.on(
                Code::DegenerateSolid,
                tokens,
                format_args!("a plate of `{owner}` has no area"),
                "list the corners in order around the plate, each once",
            ));
        }
        self.require_simple(owner, corners, twice_area);
        let density = mass / twice_area;
        let part = |total: Expr<'g>, share: i64| ratio(1, share) * (density * total);
        // fractions of twice the area: 2/6 for the first moments, 2/12 and 2/24 for the second ones
        let (x, y, xx, yy, xy) = (part(x, 3), part(y, 3), part(xx, 6), part(yy, 6), part(xy, 12));
        let zero = self.graph.zero();
        Ok(SpatialInertia {
            mass,
            moment: Vec3([x, y, zero]),
            about_origin: Symmetric3([yy, xx, xx + yy, -xy, zero, zero]),
        })
    }
}

impl<'g> Lower<'g> {
    /// Adds a rule for each pair of sides that might cross for some parameters.
    fn require_simple(&mut self, owner: &Ident, corners: &[(Expr<'g>, Expr<'g>)], twice_area: Expr<'g>) {
        let mut normalizer = Normalizer::new(self.graph, BUDGET);
        for ends in sides_apart(corners.len()) {
            let [a, b, c, d] = ends.map(|k| corners[k]);
            if [a, b, c, d]
                .iter()
                .all(|(x, y)| x.level().max(y.level()) == Level::Constant)
            {
                continue; // sides with constant corners were checked before
            }
            // two sides cross if the ends of each lie on both sides of the other: then even the larger product is
            // negative
            let sides = [[turn(a, b, c), turn(a, b, d)], [turn(c, d, a), turn(c, d, b)]];
            let same = |[p, q]: &[Expr<'g>; 2]| normalizer.is_zero(*p - *q) == Ok(true);
            if sides.iter().any(same) {
                continue;
            }
            let [u, v] = sides.map(|[p, q]| p * q);
            let larger = ratio(1, 2) * (u + v + (u - v).apply(Unary::Abs));
            self.rule(Rule {
                value: larger,
                requirement: Requirement::NonNegativeWithin(twice_area.powi(2)),
                name: format!("plate of {owner}"),
                text: format!("the sides of a plate of `{owner}` must not cross"),
            });
        }
    }
}

/// Twice the signed area of a triangle, positive if its corners turn left.
fn turn<'g>(a: (Expr<'g>, Expr<'g>), b: (Expr<'g>, Expr<'g>), c: (Expr<'g>, Expr<'g>)) -> Expr<'g> {
    (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)
}

/// Ends of each pair of sides of a polygon without a common corner.
fn sides_apart(n: usize) -> impl Iterator<Item = [usize; 4]> {
    let pairs = (0..n).flat_map(move |i| (i + 2..n).map(move |j| [i, i + 1, j, (j + 1) % n]));
    pairs.filter(|[a, .., d]| a != d)
}

/// True if no two sides of a polygon meet except at a common corner, as far as its corners are constant.
fn may_be_simple(corners: &[Option<(f64, f64)>]) -> bool {
    let turn = |a: (f64, f64), b: (f64, f64), c: (f64, f64)| (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
    let between = |a: (f64, f64), b: (f64, f64), p: (f64, f64)| {
        p.0 >= a.0.min(b.0) && p.0 <= a.0.max(b.0) && p.1 >= a.1.min(b.1) && p.1 <= a.1.max(b.1)
    };
    let meet = |ends: [usize; 4]| {
        let [Some(a), Some(b), Some(c), Some(d)] = ends.map(|k| corners[k]) else {
            return false;
        };
        let [p, q, r, s] = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)];
        (p * q < 0.0 && r * s < 0.0)
            || (p == 0.0 && between(a, b, c))
            || (q == 0.0 && between(a, b, d))
            || (r == 0.0 && between(c, d, a))
            || (s == 0.0 && between(c, d, b))
    };
    let all: Option<Vec<_>> = corners.iter().copied().collect();
    let has_area = all.is_none_or(|corners| {
        let fan = corners.windows(2).map(|side| turn(corners[0], side[0], side[1]));
        fan.sum::<f64>().is_normal()
    });
    let next = corners.iter().cycle().skip(1);
    let repeated = corners
        .iter()
        .zip(next)
        .any(|(corner, next)| corner.is_some() && corner == next);
    has_area && !repeated && !sides_apart(corners.len()).any(meet)
}

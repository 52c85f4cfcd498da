//! Values modulo a prime, at points that have nothing special: whether an expression vanishes identically.
//!
//! A polynomial that is not zero vanishes at a random point with a probability of its degree over the prime (Schwartz
//! and Zippel), whatever the size of its numbers. Sine and cosine of an angle are a random point of the circle, so that
//! their squares add up to 1 and the addition theorems hold; a root is one of two; other functions are random numbers,
//! the same for the same argument. So what vanishes here by these rules vanishes everywhere, and nothing is rounded.

use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive};

use super::{Binary, Expr, ExprId, Graph, MOST_POWER, Node, Rational, Unary};

/// A Mersenne prime. It is 3 modulo 4, so -1 is no square, and `x^((P + 1) / 4)` is a root of `x` wherever there is
/// one.
const P: u64 = (1 << 61) - 1;

/// The cosine and the sine of an angle.
type Turn = [u64; 2];

impl Graph {
    /// The values of some expressions modulo a prime, at a point that `seed` chooses; none where one of them has no
    /// value there: a root of what is no square, or a quotient by zero.
    pub(crate) fn evaluate_modulo(&self, roots: &[Expr<'_>], seed: u64) -> Option<Vec<u64>> {
        let reachable = self.reachable(roots);
        let is_angle = self.angles(&reachable);
        let mut values = vec![0; self.len()];
        let mut turns: Vec<Turn> = vec![[1, 0]; self.len()];
        for id in reachable {
            let of = |x: ExprId| values[x.index()];
            let own = match self.node(id) {
                Node::Number(n) => of_number(n)?,
                Node::Pi => random(seed, 0, 0),
                Node::Symbol(s) => random(seed, 1, s.index() as u64),
                Node::Unary(Unary::Neg, a) => minus(0, of(*a)),
                Node::Unary(Unary::Cos, a) => turns[a.index()][0],
                Node::Unary(Unary::Sin, a) => turns[a.index()][1],
                Node::Unary(Unary::Abs, a) => root(times(of(*a), of(*a)))?,
                Node::Unary(op, a) => random(seed, 2 + *op as u64, of(*a)),
                Node::Binary(Binary::Add, a, b) => plus(of(*a), of(*b)),
                Node::Binary(Binary::Sub, a, b) => minus(of(*a), of(*b)),
                Node::Binary(Binary::Mul, a, b) => times(of(*a), of(*b)),
                Node::Binary(Binary::Div, a, b) => times(of(*a), inverse(of(*b))?),
                Node::Binary(Binary::Atan2, a, b) => random(seed, of(*a), of(*b)),
                Node::Power(a, n) => match (n.numer().to_i64(), n.denom().to_u64()) {
                    (Some(n), Some(1)) => power_of(of(*a), n)?,
                    (Some(n), Some(2)) => power_of(root(of(*a))?, n)?,
                    _ => random(seed, of_number(n)?, of(*a)),
                },
            };
            values[id.index()] = own;
            if is_angle[id.index()] {
                turns[id.index()] = match self.summands(id) {
                    Some([(a, m), (b, n)]) => joined(multiple(turns[a.index()], m), multiple(turns[b.index()], n)),
                    None => turn(seed, own),
                };
            }
        }
        Some(roots.iter().map(|root| values[root.id().index()]).collect())
    }

    /// For each node whether it is an angle, or a part of one that is a sum.
    fn angles(&self, reachable: &[ExprId]) -> Vec<bool> {
        let mut is_angle = vec![false; self.len()];
        for &id in reachable.iter().rev() {
            match *self.node(id) {
                Node::Unary(Unary::Sin | Unary::Cos, angle) => is_angle[angle.index()] = true,
                _ if is_angle[id.index()] => {
                    for (part, _) in self.summands(id).into_iter().flatten() {
                        is_angle[part.index()] = true;
                    }
                }
                _ => {}
            }
        }
        is_angle
    }

    /// What an angle is the sum of, with whole factors.
    fn summands(&self, id: ExprId) -> Option<[(ExprId, i64); 2]> {
        match *self.node(id) {
            Node::Binary(Binary::Add, a, b) => Some([(a, 1), (b, 1)]),
            Node::Binary(Binary::Sub, a, b) => Some([(a, 1), (b, -1)]),
            Node::Unary(Unary::Neg, a) => Some([(a, -1), (a, 0)]),
            Node::Binary(Binary::Mul, a, b) => {
                let n = self.as_number(a).filter(|n| n.is_integer())?.to_i64()?;
                (n.abs() <= MOST_POWER).then_some([(b, n), (b, 0)])
            }
            _ => None,
        }
    }
}

/// Whether a symmetric matrix is singular for all values of its symbols: the place of a pivot that vanishes when it is
/// eliminated from the last row on. None where it is not, or where that is not known.
pub(crate) fn vanishing_pivot(matrix: &[Vec<Expr<'_>>]) -> Option<usize> {
    /// In how many points a pivot must vanish: a root is one of two, which may fit by chance.
    const ENOUGH: usize = 8;
    /// In how many it is looked for: half of them have no root of some number.
    const MOST: u64 = 64;
    let n = matrix.len();
    let entries: Vec<Expr<'_>> = matrix.iter().flatten().copied().collect();
    let graph = entries.first()?.graph();
    let points = (0..MOST).filter_map(|seed| graph.evaluate_modulo(&entries, seed));
    let pivots: Vec<usize> = points
        .map(|values| zero_pivot(values.chunks(n).map(<[u64]>::to_vec).collect()))
        .take(ENOUGH)
        .collect::<Option<_>>()?;
    pivots.last().copied().filter(|_| pivots.len() == ENOUGH)
}

fn zero_pivot(mut a: Vec<Vec<u64>>) -> Option<usize> {
    for k in (0..a.len()).rev() {
        let Some(over_pivot) = inverse(a[k][k]) else {
            return Some(k);
        };
        let last = std::mem::take(&mut a[k]);
        for row in &mut a[..k] {
            let factor = times(row[k], over_pivot);
            for (entry, own) in row.iter_mut().zip(&last[..k]) {
                *entry = minus(*entry, times(factor, *own));
            }
        }
    }
    None
}

fn plus(x: u64, y: u64) -> u64 {
    (x + y) % P
}

fn minus(x: u64, y: u64) -> u64 {
    (x + P - y) % P
}

fn times(x: u64, y: u64) -> u64 {
    (u128::from(x) * u128::from(y) % u128::from(P)) as u64
}

fn power(mut x: u64, mut n: u64) -> u64 {
    let mut power = 1;
    while n > 0 {
        if n % 2 == 1 {
            power = times(power, x);
        }
        x = times(x, x);
        n /= 2;
    }
    power
}

fn inverse(x: u64) -> Option<u64> {
    (x != 0).then(|| power(x, P - 2))
}

fn power_of(x: u64, n: i64) -> Option<u64> {
    let base = if n < 0 { inverse(x)? } else { x };
    Some(power(base, n.unsigned_abs()))
}

fn root(x: u64) -> Option<u64> {
    let root = power(x, P.div_ceil(4));
    (times(root, root) == x).then_some(root)
}

fn of_number(n: &Rational) -> Option<u64> {
    let modulo = |n: &BigInt| {
        let size = (n.magnitude() % P).to_u64().unwrap_or(0);
        if n.is_negative() { minus(0, size) } else { size }
    };
    Some(times(modulo(n.numer()), inverse(modulo(n.denom()))?))
}

/// A number without a pattern, the same for the same arguments (splitmix64, Steele et al. 2014).
fn random(seed: u64, kind: u64, value: u64) -> u64 {
    [kind, value].into_iter().fold(seed, |state, part| {
        let z = state.wrapping_add(part).wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }) % P
}

/// The point of the circle for an angle that is no sum.
fn turn(seed: u64, angle: u64) -> Turn {
    if angle == 0 {
        return [1, 0];
    }
    let t = random(seed, P, angle);
    let square = times(t, t);
    // -1 is no square
    let over = power(plus(1, square), P - 2);
    [times(minus(1, square), over), times(plus(t, t), over)]
}

fn joined([c, s]: Turn, [other_c, other_s]: Turn) -> Turn {
    [
        minus(times(c, other_c), times(s, other_s)),
        plus(times(s, other_c), times(c, other_s)),
    ]
}

fn multiple([c, s]: Turn, n: i64) -> Turn {
    let once = if n < 0 { [c, minus(0, s)] } else { [c, s] };
    (0..n.abs()).fold([1, 0], |sum, _| joined(sum, once))
}

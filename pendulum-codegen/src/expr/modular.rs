//! Values modulo primes at random points, to test whether an expression vanishes identically.
//!
//! A nonzero polynomial vanishes at a random point with a probability of at most its degree over the prime (Schwartz
//! and Zippel), whatever the size of its numbers. Sine and cosine of an angle are a random point of the circle, so
//! their squares add up to 1 and the addition theorems hold; a quaternion is a random point of the sphere; a root is
//! one of two; any other function is a random number, equal for equal arguments. An expression that vanishes here by
//! these rules vanishes everywhere, but for a chance of about 1e-16 at each point, and nothing is rounded.

use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive};
use rustc_hash::FxHashMap;

use super::{Binary, Expr, ExprId, Graph, MOST_POWER, Node, Rational, Unary};

/// The numbers modulo a prime, and a point that gives symbols their values.
///
/// The prime is 3 modulo 4, so -1 is not a square, and `x^((p + 1) / 4)` is a root of `x` if there is one. A number
/// without a root modulo one prime has a root modulo another.
#[derive(Clone, Copy, Debug)]
struct Field {
    p: u64,
    seed: u64,
}

/// First kind of random numbers of binary functions, beyond the kinds of unary ones.
const BINARY: u64 = 100;
/// Kind of random numbers of powers.
const POWER: u64 = 99;
/// Kind of random numbers of quaternions.
const QUATERNION: u64 = 102;

/// Cosine and sine of an angle.
type Turn = [u64; 2];

impl Graph {
    /// Values of expressions at a point of a field. Returns `None` if one of them has no value there: the root of a
    /// non-square, or a quotient by zero.
    fn evaluate_modulo(&self, roots: &[Expr<'_>], quaternions: &[[Expr<'_>; 4]], field: Field) -> Option<Vec<u64>> {
        let reachable = self.reachable(roots);
        let is_angle = self.angles(&reachable);
        let mut given = FxHashMap::default();
        for (n, quaternion) in quaternions.iter().enumerate() {
            let components = field.quaternion(n as u64)?;
            given.extend(quaternion.iter().map(|component| component.id()).zip(components));
        }
        let mut values = vec![0; self.len()];
        let mut turns: Vec<Turn> = vec![[1, 0]; self.len()];
        for id in reachable {
            let of = |x: ExprId| values[x.index()];
            let own = match self.node(id) {
                _ if given.contains_key(&id) => given[&id],
                Node::Number(n) => field.of_number(n)?,
                Node::Pi => field.random(0, 0),
                Node::Symbol(s) => field.random(1, s.index() as u64),
                Node::Unary(Unary::Neg, a) => field.minus(0, of(*a)),
                Node::Unary(Unary::Cos, a) => turns[a.index()][0],
                Node::Unary(Unary::Sin, a) => turns[a.index()][1],
                Node::Unary(Unary::Abs, a) => field.root(field.times(of(*a), of(*a)))?,
                Node::Unary(op, a) => field.random(2 + *op as u64, of(*a)),
                Node::Binary(Binary::Add, a, b) => field.plus(of(*a), of(*b)),
                Node::Binary(Binary::Sub, a, b) => field.minus(of(*a), of(*b)),
                Node::Binary(Binary::Mul, a, b) => field.times(of(*a), of(*b)),
                Node::Binary(Binary::Div, a, b) => field.times(of(*a), field.inverse(of(*b))?),
                Node::Binary(op, a, b) => field.random(field.random(BINARY + *op as u64, of(*a)), of(*b)),
                Node::Power(a, n) => match (n.numer().to_i64(), n.denom().to_u64()) {
                    (Some(n), Some(1)) => field.power_of(of(*a), n)?,
                    (Some(n), Some(2)) => field.power_of(field.root(of(*a))?, n)?,
                    _ => field.random(field.random(POWER, field.of_number(n)?), of(*a)),
                },
            };
            values[id.index()] = own;
            if is_angle[id.index()] {
                turns[id.index()] = match self.summands(id) {
                    Some([(a, m), (b, n)]) => {
                        field.joined(field.multiple(turns[a.index()], m), field.multiple(turns[b.index()], n))
                    }
                    None => field.turn(own),
                };
            }
        }
        Some(roots.iter().map(|root| values[root.id().index()]).collect())
    }

    /// Marks each node that is an angle or a part of an angle that is a sum.
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

    /// Summands of an angle, with integer factors.
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

/// Returns the index of a pivot that vanishes for all values of the symbols in the elimination of a symmetric matrix
/// from the last row on, which makes the matrix singular. Returns `None` if there is no such pivot, or if this cannot
/// be decided. The `quaternions` among the symbols are of unit length.
pub(crate) fn vanishing_pivot(matrix: &[Vec<Expr<'_>>], quaternions: &[[Expr<'_>; 4]]) -> Option<usize> {
    // the whole matrix first; blocks at its end may have fewer roots
    known_pivot(matrix, quaternions, 0).unwrap_or_else(|| {
        let blocks = (1..matrix.len()).rev();
        let known = blocks.filter_map(|first| known_pivot(matrix, quaternions, first));
        known.flatten().next()
    })
}

/// Index of the vanishing pivot in the block of a matrix from row `first` on, `Some(None)` if there is none; `None` if
/// this cannot be decided.
fn known_pivot(matrix: &[Vec<Expr<'_>>], quaternions: &[[Expr<'_>; 4]], first: usize) -> Option<Option<usize>> {
    /// Number of points at which a pivot must vanish: a root is one of two and may fit by chance.
    const ENOUGH: usize = 8;
    /// Maximum number of points to try: at half of them some number has no root.
    const MOST: u64 = 64;
    let rows = matrix[first..].iter();
    let entries: Vec<Expr<'_>> = rows.flat_map(|row| &row[first..]).copied().collect();
    let Some(graph) = entries.first().map(|entry| entry.graph()) else {
        return Some(None);
    };
    let zero_pivot = |seed| {
        let field = Field::new(seed);
        let values = graph.evaluate_modulo(&entries, quaternions, field)?;
        let rows = values.chunks(matrix.len() - first).map(<[u64]>::to_vec);
        Some(field.zero_pivot(rows.collect()))
    };
    let mut pivots = (0..MOST).filter_map(zero_pivot);
    let mut vanishing = None;
    for _ in 0..ENOUGH {
        vanishing = pivots.next()?;
        if vanishing.is_none() {
            break;
        }
    }
    Some(vanishing.map(|k| first + k))
}

impl Field {
    /// Field and point chosen by `seed`.
    fn new(seed: u64) -> Self {
        let mut p = (1 << 61) - 1 - (seed << 20);
        while !is_prime(p) {
            p -= 4;
        }
        Self { p, seed }
    }

    /// Index of the first pivot that is zero, if any.
    fn zero_pivot(self, mut a: Vec<Vec<u64>>) -> Option<usize> {
        for k in (0..a.len()).rev() {
            let Some(over_pivot) = self.inverse(a[k][k]) else {
                return Some(k);
            };
            let last = std::mem::take(&mut a[k]);
            for row in &mut a[..k] {
                let factor = self.times(row[k], over_pivot);
                for (entry, own) in row.iter_mut().zip(&last[..k]) {
                    *entry = self.minus(*entry, self.times(factor, *own));
                }
            }
        }
        None
    }

    fn plus(self, x: u64, y: u64) -> u64 {
        (x + y) % self.p
    }

    fn minus(self, x: u64, y: u64) -> u64 {
        (x + self.p - y) % self.p
    }

    fn times(self, x: u64, y: u64) -> u64 {
        times(x, y, self.p)
    }

    fn inverse(self, x: u64) -> Option<u64> {
        (x != 0).then(|| power(x, self.p - 2, self.p))
    }

    fn power_of(self, x: u64, n: i64) -> Option<u64> {
        let base = if n < 0 { self.inverse(x)? } else { x };
        Some(power(base, n.unsigned_abs(), self.p))
    }

    fn root(self, x: u64) -> Option<u64> {
        let root = power(x, self.p.div_ceil(4), self.p);
        (self.times(root, root) == x).then_some(root)
    }

    fn of_number(self, n: &Rational) -> Option<u64> {
        let modulo = |n: &BigInt| {
            let size = (n.magnitude() % self.p).to_u64().unwrap_or(0);
            if n.is_negative() { self.minus(0, size) } else { size }
        };
        Some(self.times(modulo(n.numer()), self.inverse(modulo(n.denom()))?))
    }

    /// Pseudorandom number, equal for equal arguments (splitmix64, Steele et al. 2014).
    fn random(self, kind: u64, value: u64) -> u64 {
        [kind, value].into_iter().fold(self.seed, |state, part| {
            let z = state.wrapping_add(part).wrapping_add(0x9e37_79b9_7f4a_7c15);
            let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ (z >> 31)
        }) % self.p
    }

    /// Point of the circle for an angle that is not a sum.
    fn turn(self, angle: u64) -> Turn {
        if angle == 0 {
            return [1, 0];
        }
        let t = self.random(self.p, angle);
        let square = self.times(t, t);
        // 1 + t^2 has an inverse, since -1 is not a square
        let over = power(self.plus(1, square), self.p - 2, self.p);
        [
            self.times(self.minus(1, square), over),
            self.times(self.plus(t, t), over),
        ]
    }

    /// Random point of the unit sphere in four dimensions, by stereographic projection.
    fn quaternion(self, number: u64) -> Option<[u64; 4]> {
        let place = [0, 1, 2].map(|axis| self.random(QUATERNION, 3 * number + axis));
        let square = place.iter().fold(0, |sum, &x| self.plus(sum, self.times(x, x)));
        let over = self.inverse(self.plus(1, square))?;
        let [x, y, z] = place.map(|x| self.times(self.plus(x, x), over));
        Some([self.times(self.minus(1, square), over), x, y, z])
    }

    fn joined(self, [c, s]: Turn, [other_c, other_s]: Turn) -> Turn {
        [
            self.minus(self.times(c, other_c), self.times(s, other_s)),
            self.plus(self.times(s, other_c), self.times(c, other_s)),
        ]
    }

    fn multiple(self, [c, s]: Turn, n: i64) -> Turn {
        let once = if n < 0 { [c, self.minus(0, s)] } else { [c, s] };
        (0..n.abs()).fold([1, 0], |sum, _| self.joined(sum, once))
    }
}

/// Miller-Rabin test, with bases that decide it for all 64-bit numbers (J. Sorenson, J. Webster 2017).
fn is_prime(n: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    let twos = (n - 1).trailing_zeros();
    let is_witness = |&base: &u64| {
        let mut x = power(base, (n - 1) >> twos, n);
        let passes = x == 1
            || (0..twos).any(|_| {
                let is_last = x == n - 1;
                x = times(x, x, n);
                is_last
            });
        !passes
    };
    !BASES.iter().any(is_witness)
}

fn times(x: u64, y: u64, p: u64) -> u64 {
    (u128::from(x) * u128::from(y) % u128::from(p)) as u64
}

fn power(mut x: u64, mut n: u64, p: u64) -> u64 {
    let mut power = 1;
    while n > 0 {
        if n % 2 == 1 {
            power = times(power, x, p);
        }
        x = times(x, x, p);
        n /= 2;
    }
    power
}

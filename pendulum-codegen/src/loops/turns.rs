//! Angles that follow from triangles, counted with their whole turns.
//!
//! A triangle gives the cosine and the sine of an angle, but springs and outputs need its value. In a triangle
//! `r1 + r2 = m` the angles of the sides against `m` never pass half a turn, because the triangle is never flat. The
//! argument of `m`, a sum of vectors, is the argument of the longest vector, a sum of known angles, plus the angle
//! between `m` and this vector. The latter is less than a quarter turn if the longest vector is longer than all others
//! together. All whole turns are therefore turns of known angles.

use std::f64::consts::TAU;

use super::Solver;
use super::meeting::{Aside, Solution, Unknown};
use super::plane::Piece;
use super::triangle::{Side, Triangle};
use crate::expr::{Binary, Expr, Level, Rational, ratio};
use crate::model::{Combination, Coordinate, CoordinateId, Uncounted};
use crate::screw::Vec2;

/// An angle, counted with its whole turns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counted<'g> {
    pub(super) angle: Expr<'g>,
    /// 1 if whole turns are counted, 0 if the angle is known only modulo a whole turn. A constant, since it depends on
    /// lengths only.
    pub(super) holds: Expr<'g>,
}

/// Vectors that turn together.
struct Group<'g> {
    turn: Combination,
    /// Sum of the vectors of constant length.
    still: Vec2<Expr<'g>>,
    /// Vectors that slide: a unit vector and the length of the slide for each.
    slides: Vec<(Vec2<Expr<'g>>, Expr<'g>)>,
}

impl<'g> Solver<'g, '_> {
    /// Value of a declared coordinate, within half a turn of its guess: in the assembled configuration, or in every
    /// state if its turns are not counted.
    pub(super) fn value(&mut self, coordinate: &Coordinate<'g>, near: Expr<'g>, sum: &Combination) -> Expr<'g> {
        let Counted { angle, holds } = self.turned(sum);
        let [guess, start] = self.numbers([near, angle]);
        let turns = Rational::from_float(((guess - start) / TAU).round()).unwrap_or_default();
        let counted = angle + ratio(2, 1) * turns * self.graph.pi();
        let beside = coordinate.position - near;
        let within = near + beside.sin().combine(Binary::Atan2, beside.cos());
        if holds.is_one() {
            return counted;
        }
        let half = (ratio(1, 2) * (1 + beside.cos())).sqrt();
        self.uncounted.push(Uncounted {
            coordinate: coordinate.clone(),
            margin: holds + (1 - holds) * half,
        });
        holds * counted + (1 - holds) * within
    }

    /// Angles of the turning sides.
    pub(super) fn counted_sides(&self, triangle: &Triangle<'g>, solution: &Solution<'g>) -> [Option<Counted<'g>>; 2] {
        let known = || self.argument(&self.groups(&triangle.known, &Combination::default(), -1));
        let one = self.graph.one();
        std::array::from_fn(|n| {
            let Unknown::Turn(_, aside) = solution.sides[n].unknown else {
                return None;
            };
            let beside = Counted {
                angle: aside.angle(),
                holds: one,
            };
            let sides = &triangle.sides;
            Some(match (&sides[0], &sides[n]) {
                (Side::Sliding(_, piece), Side::Turning(angle, _)) if self.rebased(&piece.turn) == *angle => {
                    known().minus(self.along(piece.vector)).minus(beside)
                }
                (Side::Sliding(_, piece), Side::Turning(angle, pieces)) => {
                    let slide = self.turned(&self.rebased(&piece.turn)).plus(self.along(piece.vector));
                    slide.plus(beside).minus(self.argument(&self.groups(pieces, angle, 1)))
                }
                (_, Side::Turning(angle, pieces)) => known()
                    .plus(beside)
                    .minus(self.argument(&self.groups(pieces, angle, 1))),
                (_, Side::Sliding(..)) => return None,
            })
        })
    }

    /// A sum of angles.
    pub(super) fn turned(&self, sum: &Combination) -> Counted<'g> {
        let holds = sum.terms().filter_map(|(k, _)| Some(self.counted(k)?.holds));
        let angle = |k: CoordinateId| self.counted(k).map_or(self.coordinate(k).position, |own| own.angle);
        Counted {
            angle: sum.of(self.graph, angle),
            holds: holds.fold(self.graph.one(), |all, own| all * own),
        }
    }

    fn counted(&self, k: CoordinateId) -> Option<Counted<'g>> {
        self.declared_as(k).and_then(|n| self.counted[n])
    }

    /// Groups pieces by the angle that they turn by, in a frame that turns by some angle.
    fn groups(&self, pieces: &[Piece<'g>], frame: &Combination, sign: i64) -> Vec<Group<'g>> {
        let mut groups: Vec<Group<'g>> = Vec::new();
        for piece in pieces {
            let turn = self.rebased(&piece.turn).plus_scaled(-1, frame);
            let vector = piece.vector.times(self.graph.integer(sign));
            let at = groups.iter().position(|group| group.turn == turn).unwrap_or_else(|| {
                groups.push(Group {
                    turn,
                    still: Vec2::zero(self.graph),
                    slides: Vec::new(),
                });
                groups.len() - 1
            });
            let group = &mut groups[at];
            match piece.slide {
                None => group.still = group.still + vector,
                Some(k) => group.slides.push((vector, self.coordinate(k).position)),
            }
        }
        groups.retain(|group| !group.slides.is_empty() || group.still.0.iter().any(|x| !x.is_zero()));
        groups
    }

    /// Argument of a sum of vectors.
    fn argument(&self, groups: &[Group<'g>]) -> Counted<'g> {
        match groups {
            [own] => match own.slides[..] {
                [] => self.turned(&own.turn).plus(self.along(own.still)),
                // a vector that ends on a line does not wind around the origin
                [(along, length)] => {
                    let (ahead, across) = (own.still.dot(along) + length, along.cross(own.still));
                    let aside = Aside::new(ahead, across, self.number(ahead) < 0.0);
                    let beside = Counted {
                        angle: aside.angle(),
                        holds: self.graph.one(),
                    };
                    self.turned(&own.turn).plus(self.along(along)).plus(beside)
                }
                _ => self.uncounted(),
            },
            _ if groups.iter().all(|group| group.slides.is_empty()) => self.led(groups),
            _ => self.uncounted(),
        }
    }

    fn uncounted(&self) -> Counted<'g> {
        let zero = self.graph.zero();
        Counted {
            angle: zero,
            holds: zero,
        }
    }

    /// Argument of a sum of vectors of constant lengths, which follows the longest of them.
    fn led(&self, groups: &[Group<'g>]) -> Counted<'g> {
        let (zero, one) = (self.graph.zero(), self.graph.one());
        let mut leads: Vec<Expr<'g>> = Vec::new();
        let squares: Vec<Expr<'g>> = groups.iter().map(|group| group.still.dot(group.still)).collect();
        for (n, &square) in squares.iter().enumerate() {
            let free = one - self.graph.sum(leads.iter().copied());
            leads.push(match squares[..] {
                // one of two vectors is the longer
                [_, _] if n == 1 => free,
                [_, other] => at_least_zero(square - other),
                _ => {
                    let all = self.graph.sum(squares.iter().map(|square| square.sqrt()));
                    free * at_least_zero(2 * square.sqrt() - all)
                }
            });
        }
        let (mut angle, mut holds, mut are_counted) = (zero, zero, true);
        let (mut leader, mut sum) = (Vec2::zero(self.graph), Vec2::zero(self.graph));
        for (group, &leads) in groups.iter().zip(&leads) {
            let turn = group.turn.of(self.graph, |k| self.coordinate(k).position);
            let vector = group.still.turned([turn.cos(), turn.sin()]);
            (leader, sum) = (leader + vector.times(leads), sum + vector);
            let own = self.turned(&group.turn).plus(self.along(group.still));
            (angle, holds) = (angle + leads * own.angle, holds + leads * own.holds);
            are_counted &= own.holds.is_one();
        }
        // one of two vectors leads, whatever their lengths
        if groups.len() == 2 && are_counted {
            holds = one;
        }
        let beside = leader.cross(sum).combine(Binary::Atan2, leader.dot(sum));
        Counted {
            angle: angle + beside,
            holds,
        }
    }

    /// Direction of a constant vector, without a jump near the default parameters.
    fn along(&self, vector: Vec2<Expr<'g>>) -> Counted<'g> {
        let Vec2([x, y]) = vector;
        let [in_x, in_y] = self.numbers(vector.0);
        let quarters = |n: i64| ratio(n, 2) * self.graph.pi();
        let (start, ahead, across) = match in_x.abs() >= in_y.abs() {
            true if in_x >= 0.0 => (0, x, y),
            true => (2, -x, -y),
            false if in_y >= 0.0 => (1, y, -x),
            false => (-1, -y, x),
        };
        let is_along = across.is_zero() && ahead.constant().is_some();
        let beside = if is_along {
            across
        } else {
            across.combine(Binary::Atan2, ahead)
        };
        Counted {
            angle: quarters(start) + beside,
            holds: self.graph.one(),
        }
    }
}

impl<'g> Counted<'g> {
    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            angle: self.angle + other.angle,
            holds: self.holds * other.holds,
        }
    }

    fn minus(self, other: Self) -> Self {
        Self {
            angle: self.angle - other.angle,
            holds: self.holds * other.holds,
        }
    }
}

/// Returns 1 if a constant is not negative, else 0.
fn at_least_zero(x: Expr<'_>) -> Expr<'_> {
    if let Some(number) = x.constant().filter(|_| x.level() == Level::Constant) {
        return x.graph().integer(i64::from(number >= 0.0));
    }
    // the angle of the point (x, 0), since equations are printed in the language of declarations, which has no sign
    1 - x.graph().zero().combine(Binary::Atan2, x) / x.graph().pi()
}

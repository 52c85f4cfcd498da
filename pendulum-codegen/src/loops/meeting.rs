//! Intersection of the two unknown sides of a triangle `r1 + r2 = m`, in closed form.
//!
//! Sides of known lengths meet where two circles intersect: with `L = m . m` and `a = 1/2 + (r1^2 - r2^2) / (2 L)` the
//! first is `a m + h m'`, `h = +-sqrt(r1^2 / L - a^2)`, where `m'` is `m` after a quarter turn. A sliding side ends
//! where a line intersects a circle.

use super::{Cause, ROUNDING, Solver};
use crate::expr::{Binary, Expr, ratio};
use crate::screw::Vec2;

/// A solved triangle.
pub(super) struct Solution<'g> {
    pub(super) sides: [Solved<'g>; 2],
    /// Reciprocal of the determinant of the columns of the sides.
    pub(super) inverse: Expr<'g>,
    /// Sine of the angle between these columns.
    pub(super) margin: Expr<'g>,
}

/// A solved side.
pub(super) struct Solved<'g> {
    /// The side, with the length by which it slides.
    pub(super) vector: Vec2<Expr<'g>>,
    pub(super) unknown: Unknown<'g>,
    /// Displacement of the end per unit of the unknown.
    pub(super) column: Vec2<Expr<'g>>,
    /// Value of the unknown in the assembled configuration.
    pub(super) assembled: f64,
}

/// The unknown of a side.
#[derive(Clone, Copy)]
pub(super) enum Unknown<'g> {
    /// Cosine and sine of its angle, and the position of the side relative to a known vector.
    Turn([Expr<'g>; 2], Aside<'g>),
    /// Length by which it slides.
    Length(Expr<'g>),
}

/// Position of a side relative to the vector that it meets, or along which the other side slides. The angle between
/// them never passes half a turn.
#[derive(Clone, Copy)]
pub(super) struct Aside<'g> {
    ahead: Expr<'g>,
    across: Expr<'g>,
    /// True if the side points backwards whenever the triangle is not flat.
    is_behind: bool,
}

impl<'g> Aside<'g> {
    pub(super) fn new(ahead: Expr<'g>, across: Expr<'g>, is_behind: bool) -> Self {
        Self {
            ahead,
            across,
            is_behind,
        }
    }

    pub(super) fn angle(self) -> Expr<'g> {
        let Self { ahead, across, .. } = self;
        match self.is_behind {
            true => across.graph().pi() + (-across).combine(Binary::Atan2, -ahead),
            false => across.combine(Binary::Atan2, ahead),
        }
    }
}

impl<'g> Solution<'g> {
    /// Rates of the unknowns that bring the end back, while everything else moves it by `push`.
    pub(super) fn answers(&self, push: Vec2<Expr<'g>>) -> [Expr<'g>; 2] {
        let [first, second] = self.sides.each_ref().map(|side| side.column);
        [-(push.cross(second) * self.inverse), push.cross(first) * self.inverse]
    }
}

impl<'g> Solver<'g, '_> {
    /// Solves a triangle with two turning sides: the intersection of two circles.
    pub(super) fn circles(
        &self,
        m: Vec2<Expr<'g>>,
        [a, b]: [Vec2<Expr<'g>>; 2],
        guesses: [f64; 2],
    ) -> Result<Solution<'g>, Cause> {
        let [to, first, second] = [m, a, b].map(|v| Vec2(self.numbers(v.0)));
        let (length, radii) = (to.norm(), [first.norm(), second.norm()]);
        let share = 0.5 + (radii[0].powi(2) - radii[1].powi(2)) / (2.0 * length.powi(2));
        let height = ((radii[0] / length).powi(2) - share.powi(2)).max(0.0).sqrt();
        let assemblies = Assemblies {
            miss: (length - radii[0] - radii[1]).max((radii[0] - radii[1]).abs() - length),
            height,
            unknowns: |sign: f64| {
                let one = to.times(share) + to.quarter().times(sign * height);
                [first.angle_to(one), second.angle_to(to - one)]
            },
            distance: |angles: [f64; 2]| {
                let off = angles.iter().zip(guesses);
                off.map(|(angle, guess)| turned_by(angle - guess)).sum()
            },
        };
        let (sign, assembled) = self.nearest(assemblies)?;

        let l = self.shorter(m.dot(m));
        let [a2, b2] = [a, b].map(|v| self.shorter(v.dot(v)));
        let over = l.recip();
        let share = ratio(1, 2) + (ratio(1, 2) * (a2 - b2)) * over;
        let height = (a2 * over - share.powi(2)).sqrt();
        let signed = if sign < 0.0 { -height } else { height };
        let one = m.times(share) + m.quarter().times(signed);
        let two = m - one;
        let (vectors, turns) = ([one, two], [a.turn_to(one), b.turn_to(two)]);
        let asides = [(share, signed), (1 - share, -signed)].map(|(ahead, across)| Aside::new(ahead, across, false));
        Ok(Solution {
            sides: [0, 1].map(|n| Solved {
                vector: vectors[n],
                unknown: Unknown::Turn(turns[n], asides[n]),
                column: vectors[n].quarter(),
                assembled: assembled[n],
            }),
            inverse: -(signed * l).recip(),
            margin: height * l / (a2 * b2).sqrt(),
        })
    }

    /// Solves a triangle with a side that slides along `e`, and a side `a` that turns: the intersection of a line with
    /// a circle. If the slide is on the turning side, this side is `a + s e` before it turns, and only its length is
    /// known, equal to the length of `m`. Otherwise `m - s e` has the length of `a`.
    pub(super) fn slide(
        &self,
        m: Vec2<Expr<'g>>,
        e: Vec2<Expr<'g>>,
        a: Vec2<Expr<'g>>,
        slides_on_side: bool,
        guesses: [f64; 2],
    ) -> Result<Solution<'g>, Cause> {
        let (start, radius) = if slides_on_side { (a, m) } else { (m, a) };
        let (sign, assembled) = self.nearest_slide([start, e, radius], slides_on_side, guesses)?;
        let square = self.shorter(radius.dot(radius));
        let root = (square - start.cross(e).powi(2)).sqrt();
        let signed = if sign < 0.0 { -root } else { root };
        let length = if slides_on_side {
            signed - a.dot(e)
        } else {
            m.dot(e) + signed
        };
        let aside = if slides_on_side {
            Aside::new(signed, e.cross(a), sign < 0.0)
        } else {
            Aside::new(-signed, e.cross(m), sign > 0.0)
        };
        let (turn, along, arm, vectors) = if slides_on_side {
            let whole = a + e.times(length);
            let turn = [whole.dot(m) / square, whole.cross(m) / square];
            let along = e.turned(turn);
            (turn, along, m, [along.times(length), a.turned(turn)])
        } else {
            let turning = m - e.times(length);
            (a.turn_to(turning), e, turning, [e.times(length), turning])
        };
        let sliding = Solved {
            vector: vectors[0],
            unknown: Unknown::Length(length),
            column: along,
            assembled: assembled[0],
        };
        let turning = Solved {
            vector: vectors[1],
            unknown: Unknown::Turn(turn, aside),
            column: arm.quarter(),
            assembled: assembled[1],
        };
        let inverse = signed.recip();
        Ok(Solution {
            sides: [sliding, turning],
            inverse: if slides_on_side { inverse } else { -inverse },
            margin: root / square.sqrt(),
        })
    }

    /// Selects the end nearer to the guess, of the chord that a circle cuts off a line. Returns the sign of this end,
    /// and the length and the angle there.
    fn nearest_slide(
        &self,
        [start, e, radius]: [Vec2<Expr<'g>>; 3],
        slides_on_side: bool,
        guesses: [f64; 2],
    ) -> Result<(f64, [f64; 2]), Cause> {
        let [start, along, arm] = [start, e, radius].map(|v| Vec2(self.numbers(v.0)));
        let (off, radius) = (start.cross(along).abs(), arm.norm());
        let height = (radius.powi(2) - off.powi(2)).max(0.0).sqrt();
        let forward = if slides_on_side { -1.0 } else { 1.0 };
        self.nearest(Assemblies {
            miss: off - radius,
            height: height / radius,
            unknowns: |sign: f64| {
                let length = forward * start.dot(along) + sign * height;
                let end = start - along.times(forward * length);
                [length, forward * arm.angle_to(end)]
            },
            distance: |[length, angle]: [f64; 2]| (length - guesses[0]).abs() / radius + turned_by(angle - guesses[1]),
        })
    }

    /// Returns the sign of the assembly nearer to a guess, and its unknowns, if both assemblies exist.
    fn nearest(
        &self,
        assemblies: Assemblies<impl Fn(f64) -> [f64; 2], impl Fn([f64; 2]) -> f64>,
    ) -> Result<(f64, [f64; 2]), Cause> {
        /// Smallest significant difference of distances, and smallest significant height, relative to the size of the
        /// triangle.
        const LEAST: f64 = 1e-6;
        let Assemblies {
            miss,
            height,
            unknowns,
            distance,
        } = assemblies;
        if self.is_known() && miss > 0.0 {
            return Err(if miss < ROUNDING {
                Cause::AtToggle
            } else {
                Cause::TooShort { by: miss }
            });
        }
        let both = [1.0, -1.0].map(|sign| (sign, unknowns(sign)));
        let [first, second] = both.map(|(_, unknowns)| distance(unknowns));
        if (first - second).abs() > LEAST {
            Ok(both[usize::from(second < first)])
        } else if self.is_known() && height < LEAST {
            Err(Cause::AtToggle)
        } else {
            Err(Cause::Undecided)
        }
    }
}

/// The two assemblies of a triangle, in numbers.
struct Assemblies<U, D> {
    /// Length by which the sides are too short to meet.
    miss: f64,
    /// Height of the triangle relative to its size. At zero the triangle is flat and both assemblies coincide.
    height: f64,
    /// Unknowns in the assembly of a sign.
    unknowns: U,
    /// Distance of unknowns from the guesses.
    distance: D,
}

/// Distance of an angle from the nearest whole number of turns, in rad.
fn turned_by(angle: f64) -> f64 {
    angle.sin().atan2(angle.cos()).abs()
}

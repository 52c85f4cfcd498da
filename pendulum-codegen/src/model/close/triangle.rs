//! Loops that fall apart into triangles: what follows from the state, in closed form.
//!
//! A loop with two unknown angles, or with an angle and a length, is a triangle of two unknown sides `r1 + r2 = m`, where `-m` is the sum of
//! all that is known. Sides of known lengths meet where two circles do: with `L = m . m` and `a = 1/2 + (r1^2 - r2^2) / (2 L)` the first
//! is `a m + h m'`, `h = +-sqrt(r1^2 / L - a^2)`, where `m'` is `m` after a quarter of a turn. A side that slides ends where a line meets
//! a circle. Rates follow by Cramer's rule from two equations, whose determinant vanishes where the triangle is flat: at its toggle.

use num_traits::{One, Signed, ToPrimitive};

use super::{Open, Solver};
use crate::expr::{Derivative, Expr, Rational, SymbolKind, ratio};
use crate::model::closure::{Loop, Piece};
use crate::model::{Combination, Coordinate, CoordinateId, Dependent};
use crate::screw::Vec2;

/// Two unknown sides, and what is known. If one of them slides, it is the first.
pub(super) struct Triangle<'g> {
    sides: [Side<'g>; 2],
    known: Vec<Piece<'g>>,
    /// The two declared coordinates that it determines, each in the unknowns of the two sides. These take their numbers.
    places: [(CoordinateId, Combination); 2],
}

#[derive(Clone)]
enum Side<'g> {
    /// Pieces that turn together, by the unknown angle of the first of them.
    Turning(Combination, Vec<Piece<'g>>),
    /// A piece that slides by an unknown length.
    Sliding(CoordinateId, Piece<'g>),
}

/// A triangle that is solved.
struct Solution<'g> {
    /// The sides, with the lengths by which they slide.
    sides: [Vec2<'g>; 2],
    /// Cosine and sine of the angle of a side that turns.
    turns: [Option<[Expr<'g>; 2]>; 2],
    /// How far a side slides.
    length: Option<Expr<'g>>,
    /// What each unknown moves the end by, for each unit.
    columns: [Vec2<'g>; 2],
    /// One over what the columns span.
    inverse: Expr<'g>,
    /// The sine of the angle between the columns.
    margin: Expr<'g>,
    /// The unknowns where the loop is assembled.
    assembled: [f64; 2],
}

impl<'g> Solution<'g> {
    /// The rates of the unknowns that bring the end back, where all else moves it by `push`.
    fn answers(&self, push: Vec2<'g>) -> [Expr<'g>; 2] {
        let [first, second] = self.columns;
        [-(push.cross(second) * self.inverse), push.cross(first) * self.inverse]
    }
}

impl<'g> Solver<'g, '_> {
    /// A triangle among the loops that are left, or among sums and differences of two of them, and which of them it closes.
    pub(super) fn next(&self, loops: &[Option<Loop<'g>>], left: &[usize]) -> Option<(usize, Triangle<'g>)> {
        let in_plane = left
            .iter()
            .enumerate()
            .filter_map(|(at, &n)| Some((at, loops[n].as_ref()?)));
        let in_plane: Vec<(usize, &Loop<'g>)> = in_plane.collect();
        let alone = in_plane.iter().map(|&(at, own)| (at, own.clone()));
        let pairs = in_plane.iter().enumerate().flat_map(|(n, &(at, own))| {
            let others = in_plane[..n].iter().flat_map(|&(_, other)| [(other, 1), (other, -1)]);
            others.map(move |(other, sign)| (at, own.joined(other, sign)))
        });
        alone
            .chain(pairs)
            .find_map(|(at, around)| Some((at, self.triangle(&around)?)))
    }

    /// The loop as a triangle, if it is one.
    fn triangle(&self, around: &Loop<'g>) -> Option<Triangle<'g>> {
        let mut turning: Vec<(Combination, Side<'g>)> = Vec::new();
        let (mut sides, mut known) = (Vec::new(), Vec::new());
        for piece in &around.0 {
            let turn = self.rebased(&piece.turn);
            let (piece, unknown) = (piece.clone(), self.unknown_part(&turn));
            let slides = piece.slide.filter(|&k| self.is_unknown(k));
            if let Some(k) = slides {
                sides.push(Side::Sliding(k, piece.clone()));
            }
            if unknown == Combination::default() {
                known.extend(slides.is_none().then_some(piece));
                continue;
            }
            let own = slides.is_none().then_some(piece);
            match turning.iter_mut().find(|(known, _)| *known == unknown) {
                Some((_, Side::Turning(_, pieces))) => pieces.extend(own),
                _ => turning.push((unknown, Side::Turning(turn, own.into_iter().collect()))),
            }
        }
        sides.extend(turning.into_iter().map(|(_, side)| side));
        let sides = <[Side<'g>; 2]>::try_from(sides).ok()?;
        // what slides does so along what is known, or along the other side, without turning on it
        let fits = match &sides {
            [Side::Sliding(_, piece), Side::Turning(angle, _)] => {
                let turn = self.rebased(&piece.turn);
                self.unknown_part(&turn) == Combination::default() || turn == *angle
            }
            [Side::Turning(..), Side::Turning(..)] => true,
            _ => false,
        };
        let places = self.in_unknowns(&sides).filter(|_| fits)?;
        Some(Triangle { sides, known, places })
    }

    /// The two declared coordinates that a triangle of these sides determines.
    fn in_unknowns(&self, sides: &[Side<'g>; 2]) -> Option<[(CoordinateId, Combination); 2]> {
        let sums = sides.each_ref().map(|side| match side {
            Side::Turning(angle, _) => angle.clone(),
            Side::Sliding(k, _) => Combination::one(*k),
        });
        let mut numbers: Vec<CoordinateId> = Vec::new();
        for (k, _) in sums.iter().flat_map(Combination::terms) {
            if self.is_unknown(k) && !numbers.contains(&k) {
                numbers.push(k);
            }
        }
        let &[first, second] = &numbers[..] else { return None };
        let [[a, b], [c, d]] = sums.each_ref().map(|sum| [first, second].map(|k| sum.factor(k)));
        let determinant = &a * &d - &b * &c;
        if !determinant.abs().is_one() {
            return None;
        }
        // unknown - what is known in it = factors . declared
        let bare = |k: CoordinateId, sum: &Combination| {
            Combination::one(k).plus_scaled(-1, &sum.filtered(|k| !self.is_unknown(k)))
        };
        let (u, v) = (bare(first, &sums[0]), bare(second, &sums[1]));
        let of = |p: Rational, q: Rational| {
            let with_u = Combination::default().plus_multiple(&(p * &determinant), &u);
            with_u.plus_multiple(&(q * &determinant), &v)
        };
        Some([(first, of(d, -b)), (second, of(-c, a))])
    }

    /// Closes a loop by its triangle.
    pub(super) fn solve(&mut self, number: usize, triangle: &Triangle<'g>) -> Result<(), Open> {
        let places = &triangle.places;
        let guesses = triangle.sides.each_ref().map(|side| match side {
            Side::Turning(angle, _) => angle
                .terms()
                .map(|(k, n)| n.to_f64().unwrap_or(f64::NAN) * self.assembled[usize::from(k)])
                .sum(),
            Side::Sliding(k, _) => self.assembled[usize::from(*k)],
        });
        let solution = self.solution(triangle, guesses).map_err(|miss| match miss {
            Miss::Short(by) => Open::TooShort(number, by, "m"),
            Miss::Undecided => Open::Undecided(number),
        })?;
        let free = self.model.independent();
        for (n, side) in triangle.sides.iter().enumerate() {
            let place = usize::from(places[n].0);
            self.assembled[place] = solution.assembled[n];
            let coordinate = self.unknown(place, side);
            if let Some(turn) = solution.turns[n] {
                let turn = turn.map(|x| self.model.with_drives(&[x])[0]);
                self.following.set_turn(coordinate.position, turn);
            }
            if let (Side::Sliding(..), Some(length)) = (side, solution.length) {
                self.following
                    .set(coordinate.position, self.model.with_drives(&[length])[0]);
            }
            let (slopes, drift) = (vec![self.graph.zero(); free], self.graph.zero());
            self.dependents[place - free] = Some(Dependent {
                coordinate,
                slopes,
                drift,
                in_state: false,
            });
        }
        for (k, combination) in places {
            self.combinations[usize::from(*k) - free] = Some(combination.clone());
        }
        // at fixed unknowns, the end moves with all else
        let pushes = (0..free).map(|j| self.velocity(triangle, &solution, |k| self.slope(k, j), false));
        let slopes: Vec<[Expr<'g>; 2]> = pushes.map(|push| solution.answers(push)).collect();
        let columns = [0, 1].map(|n| slopes.iter().map(|slope| slope[n]).collect::<Vec<_>>());
        let of_parameters = self
            .pushes_of_parameters(triangle)
            .into_iter()
            .map(|(parameter, push)| (parameter, solution.answers(push)));
        let of_parameters: Vec<(Expr<'g>, [Expr<'g>; 2])> = of_parameters.collect();
        for (side, ((k, _), column)) in places.iter().zip(columns).enumerate() {
            let n = usize::from(*k) - free;
            let of_parameters = of_parameters
                .iter()
                .map(|&(parameter, answers)| (parameter, answers[side]));
            let of_parameters: Vec<(Expr<'g>, Expr<'g>)> = of_parameters
                .map(|(parameter, slope)| (parameter, self.named(&self.slope_name_of(n, parameter), slope)))
                .collect();
            let slopes = column.into_iter().enumerate();
            let named = slopes
                .map(|(j, slope)| self.named(&self.slope_name(n, j), slope))
                .collect();
            self.set_slopes(n, named, of_parameters);
        }
        let bend = self.velocity(triangle, &solution, |k| self.drift(k), true);
        for ((k, _), drift) in places.iter().zip(solution.answers(bend)) {
            let n = usize::from(*k) - free;
            let named = self.named(&self.drift_name(n), drift);
            self.set_drift(n, named);
        }
        for (k, _) in places {
            self.set_declared(usize::from(*k) - free);
        }
        self.margins[number] = self.model.with_drives(&[solution.margin])[0];
        Ok(())
    }

    /// How the end moves with each parameter that is derived by, at fixed unknowns.
    fn pushes_of_parameters(&self, triangle: &Triangle<'g>) -> Vec<(Expr<'g>, Vec2<'g>)> {
        let parameters = self.parameters();
        if parameters.is_empty() {
            return Vec::new();
        }
        let of_sides = triangle.sides.iter().flat_map(|side| match side {
            Side::Turning(_, pieces) => &pieces[..],
            Side::Sliding(_, piece) => std::slice::from_ref(piece),
        });
        let vectors = triangle.known.iter().chain(of_sides).map(|piece| self.vector(piece));
        let sum = vectors.fold(Vec2::zero(self.graph), |sum, vector| sum + vector);
        let push = |parameter| (parameter, Vec2(sum.0.map(|x| Derivative::by(parameter).of(x))));
        parameters.into_iter().map(push).collect()
    }

    /// The symbols of the unknown of a side.
    fn unknown(&self, place: usize, side: &Side<'g>) -> Coordinate<'g> {
        let declared = &self.declared[place - self.model.independent()].coordinate;
        let body = match side {
            Side::Sliding(..) => return declared.clone(),
            Side::Turning(_, pieces) => pieces.iter().find_map(|piece| piece.body),
        };
        let name = match body {
            Some(body) => format!("angle_{}", self.model.bodies[body].name.trim_start_matches("r#")),
            None => declared.name.clone(),
        };
        let position = self.graph.symbol(&name, SymbolKind::Coordinate(place));
        let rate = self.graph.symbol(&format!("dot({name})"), SymbolKind::Rate(place));
        Coordinate::plain(name, [position, rate, self.graph.zero()])
    }

    /// The vector of a piece, without the length by which it slides.
    fn direction(&self, piece: &Piece<'g>) -> Vec2<'g> {
        let turn = self.rebased(&piece.turn);
        let angle = turn.of(self.graph, |k| self.coordinate(k).position);
        piece.vector.turned([angle.cos(), angle.sin()])
    }

    /// The vector of a piece.
    pub(super) fn vector(&self, piece: &Piece<'g>) -> Vec2<'g> {
        let direction = self.direction(piece);
        piece
            .slide
            .map_or(direction, |k| self.coordinate(k).position * direction)
    }

    /// The sum of the changes of all pieces where coordinates change by `by`; with the terms in products of rates if `bends`.
    fn velocity(
        &self,
        triangle: &Triangle<'g>,
        solution: &Solution<'g>,
        by: impl Fn(CoordinateId) -> Expr<'g>,
        bends: bool,
    ) -> Vec2<'g> {
        let mut sum = Vec2::zero(self.graph);
        let rate = |turn: &Combination| turn.of(self.graph, |k| self.coordinate(k).rate);
        let mut add = |turn: &Combination, slide: Option<CoordinateId>, direction: Vec2<'g>, vector: Vec2<'g>| {
            let turn = self.rebased(turn);
            sum = sum + turn.of(self.graph, &by) * vector.quarter();
            if let Some(k) = slide {
                sum = sum + by(k) * direction;
            }
            if bends {
                let turns = rate(&turn);
                sum = sum - turns.powi(2) * vector;
                if let Some(k) = slide {
                    sum = sum + (2 * turns * self.coordinate(k).rate) * direction.quarter();
                }
            }
        };
        for piece in &triangle.known {
            add(&piece.turn, piece.slide, self.direction(piece), self.vector(piece));
        }
        for (side, &vector) in triangle.sides.iter().zip(&solution.sides) {
            match side {
                Side::Sliding(_, piece) => add(&piece.turn, piece.slide, self.direction(piece), vector),
                Side::Turning(_, pieces) => match &pieces[..] {
                    // one vector that is known, or pieces that move on the side
                    [first, others @ ..]
                        if others
                            .iter()
                            .chain([first])
                            .all(|piece| piece.turn == first.turn && piece.slide.is_none()) =>
                    {
                        add(&first.turn, None, vector, vector);
                    }
                    _ => {
                        for piece in pieces {
                            add(&piece.turn, piece.slide, self.direction(piece), self.vector(piece));
                        }
                    }
                },
            }
        }
        sum
    }

    /// The triangle in closed form, in the assembly that is nearest to the guesses.
    fn solution(&self, triangle: &Triangle<'g>, guesses: [f64; 2]) -> Result<Solution<'g>, Miss> {
        let known = triangle.known.iter().map(|piece| self.vector(piece));
        let target = -known.fold(Vec2::zero(self.graph), |sum, piece| sum + piece);
        match &triangle.sides {
            [Side::Sliding(_, piece), Side::Turning(angle, pieces)] => {
                let side = self.on_side(angle, pieces);
                if self.rebased(&piece.turn) == *angle {
                    self.slide_on_side(target, piece.vector, side, guesses)
                } else {
                    self.slide_beside(target, self.direction(piece), side, guesses)
                }
            }
            sides => {
                let sides = sides.each_ref().map(|side| match side {
                    Side::Turning(angle, pieces) => self.on_side(angle, pieces),
                    Side::Sliding(_, piece) => piece.vector,
                });
                self.circles(target, sides, guesses)
            }
        }
    }

    /// The sum of pieces in the frame that turns by an angle.
    fn on_side(&self, angle: &Combination, pieces: &[Piece<'g>]) -> Vec2<'g> {
        let pieces = pieces.iter().map(|piece| {
            let beside = self.rebased(&piece.turn).plus_scaled(-1, angle);
            let beside = beside.of(self.graph, |k| self.coordinate(k).position);
            let vector = piece.vector.turned([beside.cos(), beside.sin()]);
            piece.slide.map_or(vector, |k| self.coordinate(k).position * vector)
        });
        pieces.fold(Vec2::zero(self.graph), |sum, piece| sum + piece)
    }

    /// Two sides that turn: where two circles meet.
    fn circles(&self, m: Vec2<'g>, [a, b]: [Vec2<'g>; 2], guesses: [f64; 2]) -> Result<Solution<'g>, Miss> {
        let [to, first, second] = [m, a, b].map(|v| self.numbers(v.0));
        let (length, radii) = (norm(to), [norm(first), norm(second)]);
        let miss = (length - radii[0] - radii[1]).max((radii[0] - radii[1]).abs() - length);
        let share = 0.5 + (radii[0].powi(2) - radii[1].powi(2)) / (2.0 * length.powi(2));
        let height = ((radii[0] / length).powi(2) - share.powi(2)).max(0.0).sqrt();
        let assembled = |sign: f64| {
            let one = [
                share * to[0] - sign * height * to[1],
                share * to[1] + sign * height * to[0],
            ];
            [between(first, one), between(second, [to[0] - one[0], to[1] - one[1]])]
        };
        let (sign, assembled) = self.nearest(miss, assembled, |one| {
            one.iter()
                .zip(guesses)
                .map(|(angle, guess)| turned_by(angle - guess))
                .sum()
        })?;
        let l = self.shorter(m.dot(m));
        let [a2, b2] = [a, b].map(|v| self.shorter(v.dot(v)));
        let over = l.recip();
        let share = ratio(1, 2) + (ratio(1, 2) * (a2 - b2)) * over;
        let height = (a2 * over - share.powi(2)).sqrt();
        let signed = if sign < 0.0 { -height } else { height };
        let one = share * m + signed * m.quarter();
        let two = m - one;
        Ok(Solution {
            sides: [one, two],
            turns: [Some(a.turn_to(one)), Some(b.turn_to(two))],
            length: None,
            columns: [one.quarter(), two.quarter()],
            inverse: -(signed * l).recip(),
            margin: height * l / (a2 * b2).sqrt(),
            assembled,
        })
    }

    /// A side `a` that turns, and a known direction to slide along: where a line meets a circle.
    fn slide_beside(&self, m: Vec2<'g>, e: Vec2<'g>, a: Vec2<'g>, guesses: [f64; 2]) -> Result<Solution<'g>, Miss> {
        let [to, along, side] = [m, e, a].map(|v| self.numbers(v.0));
        let (off, radius) = (cross(to, along), norm(side));
        let height = (radius.powi(2) - off.powi(2)).max(0.0).sqrt();
        let assembled = |sign: f64| {
            let length = to[0] * along[0] + to[1] * along[1] + sign * height;
            [
                length,
                between(side, [to[0] - length * along[0], to[1] - length * along[1]]),
            ]
        };
        let (sign, assembled) = self.nearest(off.abs() - radius, assembled, |[length, angle]| {
            (length - guesses[0]).abs() / radius + turned_by(angle - guesses[1])
        })?;
        let a2 = self.shorter(a.dot(a));
        let root = (a2 - m.cross(e).powi(2)).sqrt();
        let signed = if sign < 0.0 { -root } else { root };
        let length = m.dot(e) + signed;
        let turning = m - length * e;
        Ok(Solution {
            sides: [length * e, turning],
            turns: [None, Some(a.turn_to(turning))],
            length: Some(length),
            columns: [e, turning.quarter()],
            inverse: -signed.recip(),
            margin: root / a2.sqrt(),
            assembled,
        })
    }

    /// A side `a + s e` that turns, and whose length changes with `s`.
    fn slide_on_side(&self, m: Vec2<'g>, e: Vec2<'g>, a: Vec2<'g>, guesses: [f64; 2]) -> Result<Solution<'g>, Miss> {
        let [to, along, base] = [m, e, a].map(|v| self.numbers(v.0));
        let (off, radius) = (cross(base, along), norm(to));
        let height = (radius.powi(2) - off.powi(2)).max(0.0).sqrt();
        let assembled = |sign: f64| {
            let length = sign * height - (base[0] * along[0] + base[1] * along[1]);
            [
                length,
                between([base[0] + length * along[0], base[1] + length * along[1]], to),
            ]
        };
        let (sign, assembled) = self.nearest(off.abs() - radius, assembled, |[length, angle]| {
            (length - guesses[0]).abs() / radius + turned_by(angle - guesses[1])
        })?;
        let m2 = self.shorter(m.dot(m));
        let root = (m2 - a.cross(e).powi(2)).sqrt();
        let signed = if sign < 0.0 { -root } else { root };
        let length = signed - a.dot(e);
        let whole = a + length * e;
        let turn = [whole.dot(m) / m2, whole.cross(m) / m2];
        Ok(Solution {
            sides: [length * e.turned(turn), a.turned(turn)],
            turns: [None, Some(turn)],
            length: Some(length),
            columns: [e.turned(turn), m.quarter()],
            inverse: signed.recip(),
            margin: root / m2.sqrt(),
            assembled,
        })
    }

    /// The sign of the assembly that is nearer to a guess, if both exist.
    fn nearest(
        &self,
        miss: f64,
        assembled: impl Fn(f64) -> [f64; 2],
        distance: impl Fn([f64; 2]) -> f64,
    ) -> Result<(f64, [f64; 2]), Miss> {
        /// The least difference that says anything.
        const LEAST: f64 = 1e-6;
        if self.is_known() && miss > 0.0 {
            return Err(Miss::Short(miss));
        }
        let both = [1.0, -1.0].map(|sign| (sign, assembled(sign)));
        let [first, second] = both.map(|(_, unknowns)| distance(unknowns));
        if (first - second).abs() > LEAST {
            Ok(both[usize::from(second < first)])
        } else {
            Err(Miss::Undecided)
        }
    }
}

/// Why a triangle has no assembly that a guess tells.
enum Miss {
    Short(f64),
    Undecided,
}

fn norm([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

fn cross([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    a * d - b * c
}

/// The angle from one vector to another.
fn between(a: [f64; 2], b: [f64; 2]) -> f64 {
    cross(a, b).atan2(a[0] * b[0] + a[1] * b[1])
}

/// How far an angle is from a whole number of turns.
fn turned_by(angle: f64) -> f64 {
    angle.sin().atan2(angle.cos()).abs()
}

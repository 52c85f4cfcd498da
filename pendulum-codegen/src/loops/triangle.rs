//! Loops that decompose into triangles, solved in closed form.
//!
//! A loop with two unknown angles, or with an angle and a length, is a triangle of two unknown sides `r1 + r2 = m`,
//! where `-m` is the sum of all known vectors. Rates are solved by Cramer's rule from two equations. Their determinant
//! vanishes where the triangle is flat: at its singularity (toggle).

use num_traits::{One, Signed, ToPrimitive};

use super::meeting::{Solution, Solved, Unknown};
use super::plane::{Loop, Piece};
use super::{Cause, Dependent, Open, Solver};
use crate::expr::{Derivative, Expr, Rational, SymbolKind};
use crate::model::{Combination, Coordinate, CoordinateId, Slopes};
use crate::screw::Vec2;

/// Two unknown sides, and the known vectors. If one of the sides slides, it is the first.
pub(super) struct Triangle<'g> {
    pub(super) sides: [Side<'g>; 2],
    pub(super) known: Vec<Piece<'g>>,
    /// The two declared coordinates that it determines, each in terms of the unknowns of the two sides. The unknowns
    /// take over their indices.
    places: [(CoordinateId, Combination); 2],
}

pub(super) enum Side<'g> {
    /// Pieces that turn together, by the unknown angle of the first piece.
    Turning(Combination, Vec<Piece<'g>>),
    /// A piece that slides by an unknown length.
    Sliding(CoordinateId, Piece<'g>),
}

/// A moving vector.
struct Moving<'g> {
    turn: Combination,
    slide: Option<CoordinateId>,
    /// Unit vector along which it slides.
    direction: Vec2<Expr<'g>>,
    vector: Vec2<Expr<'g>>,
}

impl<'g> Side<'g> {
    fn pieces(&self) -> &[Piece<'g>] {
        match self {
            Self::Turning(_, pieces) => pieces,
            Self::Sliding(_, piece) => std::slice::from_ref(piece),
        }
    }

    /// The unknown, together with the known coordinates in its sum.
    fn unknown(&self) -> Combination {
        match self {
            Self::Turning(angle, _) => angle.clone(),
            Self::Sliding(k, _) => Combination::one(*k),
        }
    }
}

impl<'g> Solver<'g, '_> {
    /// Finds a triangle among the remaining loops, or among sums and differences of two of them. Returns the position
    /// in `left` of the loop that it closes, and the triangle.
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

    /// Converts the loop to a triangle, if it is one.
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
        // a slide must be along known vectors, or along the other side without turning on it
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

    /// The two declared coordinates determined by a triangle of these sides, in terms of the unknowns of the sides.
    fn in_unknowns(&self, sides: &[Side<'g>; 2]) -> Option<[(CoordinateId, Combination); 2]> {
        let sums = sides.each_ref().map(Side::unknown);
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
        // unknown - its known part = factors . declared
        let alone = |k: CoordinateId, sum: &Combination| {
            Combination::one(k).plus_scaled(-1, &sum.filtered(|k| !self.is_unknown(k)))
        };
        let (u, v) = (alone(first, &sums[0]), alone(second, &sums[1]));
        let of = |p: Rational, q: Rational| {
            let with_u = Combination::default().plus_multiple(&(p * &determinant), &u);
            with_u.plus_multiple(&(q * &determinant), &v)
        };
        Some([(first, of(d, -b)), (second, of(-c, a))])
    }

    /// Closes a loop by its triangle.
    pub(super) fn solve(&mut self, number: usize, triangle: &Triangle<'g>) -> Result<(), Open> {
        let guesses = triangle.sides.each_ref().map(|side| {
            let terms = side.unknown();
            let guess = terms
                .terms()
                .map(|(k, n)| n.to_f64().unwrap_or(f64::NAN) * self.assembled[usize::from(k)]);
            guess.sum::<f64>()
        });
        let solution = self.solution(triangle, guesses);
        let solution = solution.map_err(|cause| Open { number, cause })?;
        self.set_unknowns(triangle, &solution);
        self.set_rates(triangle, &solution);
        for (k, _) in &triangle.places {
            self.set_declared(usize::from(*k) - self.tree.independent());
        }
        self.margins[number] = self.tree.with_drives(&[solution.margin])[0];
        Ok(())
    }

    /// Defines the symbols of the unknowns and their values.
    fn set_unknowns(&mut self, triangle: &Triangle<'g>, solution: &Solution<'g>) {
        let free = self.tree.independent();
        let counted = self.counted_sides(triangle, solution);
        let sides = triangle.sides.iter().zip(&solution.sides).zip(counted);
        for (((side, solved), counted), (k, combination)) in sides.zip(&triangle.places) {
            let place = usize::from(*k);
            self.assembled[place] = solved.assembled;
            let coordinate = self.unknown(place, side);
            match solved.unknown {
                Unknown::Turn(turn, _) => {
                    let turn = turn.map(|x| self.tree.with_drives(&[x])[0]);
                    self.dependence.set_turn(coordinate.position, turn);
                }
                Unknown::Length(length) => {
                    let length = self.tree.with_drives(&[length])[0];
                    self.dependence.set(coordinate.position, length);
                }
            }
            self.dependents[place - free] = Some(Dependent {
                coordinate,
                slopes: Slopes {
                    slopes: vec![self.graph.zero(); free],
                    drift: self.graph.zero(),
                    in_state: false,
                },
            });
            self.combinations[place - free] = Some(combination.clone());
            self.counted[place - free] = counted;
        }
    }

    /// Sets the rates and accelerations of the unknowns: with fixed unknowns the end moves with everything else, and
    /// the unknowns bring it back.
    fn set_rates(&mut self, triangle: &Triangle<'g>, solution: &Solution<'g>) {
        let free = self.tree.independent();
        let numbers = triangle.places.each_ref().map(|(k, _)| usize::from(*k) - free);
        let pushes = (0..free).map(|j| self.velocity(triangle, solution, |k| self.slope(k, j), false));
        let slopes: Vec<[Expr<'g>; 2]> = pushes.map(|push| solution.answers(push)).collect();
        let pushes = self.pushes_of_parameters(triangle).into_iter();
        let of_parameters: Vec<(Expr<'g>, [Expr<'g>; 2])> = pushes
            .map(|(parameter, push)| (parameter, solution.answers(push)))
            .collect();
        for (side, n) in numbers.into_iter().enumerate() {
            let mut named_of_parameters = Vec::new();
            for &(parameter, slopes) in &of_parameters {
                let name = self.slope_name_of(n, parameter);
                named_of_parameters.push((parameter, self.named(&name, slopes[side])));
            }
            let slopes = slopes.iter().enumerate();
            let named = slopes
                .map(|(j, slopes)| self.named(&self.slope_name(n, j), slopes[side]))
                .collect();
            self.set_slopes(n, named, named_of_parameters);
        }
        let bend = self.velocity(triangle, solution, |k| self.drift(k), true);
        for (n, drift) in numbers.into_iter().zip(solution.answers(bend)) {
            let named = self.named(&self.drift_name(n), drift);
            self.set_drift(n, named);
        }
    }

    /// Displacement of the end per unit of each parameter with generated derivatives, at fixed unknowns.
    fn pushes_of_parameters(&self, triangle: &Triangle<'g>) -> Vec<(Expr<'g>, Vec2<Expr<'g>>)> {
        let parameters = self.parameters();
        if parameters.is_empty() {
            return Vec::new();
        }
        let pieces = triangle
            .known
            .iter()
            .chain(triangle.sides.iter().flat_map(Side::pieces));
        let sum = Vec2::sum(self.graph, pieces.map(|piece| self.vector(piece)));
        let push = |parameter| (parameter, Vec2(sum.0.map(|x| Derivative::by(parameter).of(x))));
        parameters.into_iter().map(push).collect()
    }

    /// Symbols of the unknown of a side.
    fn unknown(&self, place: usize, side: &Side<'g>) -> Coordinate<'g> {
        let declared = &self.declared[place - self.tree.independent()].coordinate;
        let body = match side {
            Side::Sliding(..) => return declared.clone(),
            Side::Turning(_, pieces) => pieces.iter().find_map(|piece| piece.body),
        };
        let name = match body {
            Some(body) => format!("angle_{}", self.tree.bodies[body].name.trim_start_matches("r#")),
            None => declared.name.clone(),
        };
        let position = self.graph.symbol(&name, SymbolKind::Coordinate(place));
        let rate = self.graph.symbol(&format!("dot({name})"), SymbolKind::Rate(place));
        Coordinate::plain(name, [position, rate, self.graph.zero()])
    }

    /// Vector of a piece, without the length by which it slides.
    fn direction(&self, piece: &Piece<'g>) -> Vec2<Expr<'g>> {
        let turn = self.rebased(&piece.turn);
        let angle = turn.of(self.graph, |k| self.coordinate(k).position);
        piece.vector.turned([angle.cos(), angle.sin()])
    }

    /// Vector of a piece.
    pub(super) fn vector(&self, piece: &Piece<'g>) -> Vec2<Expr<'g>> {
        self.slid(piece, self.direction(piece))
    }

    /// Multiplies the direction of a piece by the length by which it slides.
    fn slid(&self, piece: &Piece<'g>, direction: Vec2<Expr<'g>>) -> Vec2<Expr<'g>> {
        piece
            .slide
            .map_or(direction, |k| direction.times(self.coordinate(k).position))
    }

    /// Sum of the changes of all pieces for the changes `by` of the coordinates. If `bends` is set, terms in products
    /// of rates are included.
    fn velocity(
        &self,
        triangle: &Triangle<'g>,
        solution: &Solution<'g>,
        by: impl Fn(CoordinateId) -> Expr<'g>,
        bends: bool,
    ) -> Vec2<Expr<'g>> {
        let mut sum = Vec2::zero(self.graph);
        let mut add = |moving: Moving<'g>| sum = self.with_change(sum, &moving, &by, bends);
        let moving = |piece: &Piece<'g>, vector: Vec2<Expr<'g>>| Moving {
            turn: self.rebased(&piece.turn),
            slide: piece.slide,
            direction: self.direction(piece),
            vector,
        };
        for piece in &triangle.known {
            add(moving(piece, self.vector(piece)));
        }
        for (side, &Solved { vector, .. }) in triangle.sides.iter().zip(&solution.sides) {
            match side {
                Side::Sliding(_, piece) => add(moving(piece, vector)),
                Side::Turning(_, pieces) if moves_as_one(pieces) => add(Moving {
                    turn: self.rebased(&pieces[0].turn),
                    slide: None,
                    direction: vector,
                    vector,
                }),
                Side::Turning(_, pieces) => pieces.iter().for_each(|piece| add(moving(piece, self.vector(piece)))),
            }
        }
        sum
    }

    /// Adds the change of a vector to a sum.
    fn with_change(
        &self,
        mut sum: Vec2<Expr<'g>>,
        moving: &Moving<'g>,
        by: impl Fn(CoordinateId) -> Expr<'g>,
        bends: bool,
    ) -> Vec2<Expr<'g>> {
        let Moving {
            turn,
            slide,
            direction,
            vector,
        } = moving;
        let turned = turn.of(self.graph, &by);
        sum = sum + vector.quarter().times(turned);
        if let Some(k) = *slide {
            sum = sum + direction.times(by(k));
        }
        if bends {
            let turns = turn.of(self.graph, |k| self.coordinate(k).rate);
            sum = sum - vector.times(turns.powi(2));
            if let Some(k) = *slide {
                let twice = 2 * turns * self.coordinate(k).rate;
                sum = sum + direction.quarter().times(twice);
            }
        }
        sum
    }

    /// Solves the triangle in closed form, in the assembly nearest to the guesses.
    fn solution(&self, triangle: &Triangle<'g>, guesses: [f64; 2]) -> Result<Solution<'g>, Cause> {
        let known = triangle.known.iter().map(|piece| self.vector(piece));
        let target = -Vec2::sum(self.graph, known);
        match &triangle.sides {
            [Side::Sliding(_, piece), Side::Turning(angle, pieces)] => {
                let side = self.on_side(angle, pieces);
                let slides_on_side = self.rebased(&piece.turn) == *angle;
                let along = if slides_on_side {
                    piece.vector
                } else {
                    self.direction(piece)
                };
                self.slide(target, along, side, slides_on_side, guesses)
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

    /// Sum of pieces in the frame that turns by an angle.
    fn on_side(&self, angle: &Combination, pieces: &[Piece<'g>]) -> Vec2<Expr<'g>> {
        let pieces = pieces.iter().map(|piece| {
            let beside = self.rebased(&piece.turn).plus_scaled(-1, angle);
            let beside = beside.of(self.graph, |k| self.coordinate(k).position);
            self.slid(piece, piece.vector.turned([beside.cos(), beside.sin()]))
        });
        Vec2::sum(self.graph, pieces)
    }
}

/// True if the pieces of a side are fixed relative to each other.
fn moves_as_one(pieces: &[Piece<'_>]) -> bool {
    let first = pieces.first();
    first.is_some_and(|first| {
        pieces
            .iter()
            .all(|piece| piece.turn == first.turn && piece.slide.is_none())
    })
}

//! Coordinates and their derivatives.

use crate::expr::{Derivative, Expr, ratio};

/// A coordinate, with the symbols of its derivatives.
#[derive(Clone, Debug)]
pub(crate) struct Coordinate<'g> {
    /// Name.
    pub name: String,
    /// Position; the number 0 for a component of the angular velocity of an [orientation](Self::is_of_orientation).
    pub position: Expr<'g>,
    /// Components of the state that a unit of its rate changes, and their rates of change: a column of `K` in
    /// `q' = K(q) v`.
    pub changes: Vec<(Expr<'g>, Expr<'g>)>,
    /// Rate.
    pub rate: Expr<'g>,
    /// Acceleration, as an independent variable.
    pub acceleration: Expr<'g>,
}

impl<'g> Coordinate<'g> {
    /// Creates a coordinate whose position is one component of the state.
    pub(crate) fn plain(name: String, [position, rate, acceleration]: [Expr<'g>; 3]) -> Self {
        Self {
            name,
            position,
            changes: vec![(position, position.graph().one())],
            rate,
            acceleration,
        }
    }

    /// Creates the component of the angular velocity of a body along one of its axes, for the unit quaternion from body
    /// to parent, `q' = q (0, w) / 2`. It is not the rate of any coordinate, but it has the screw of a revolute joint.
    pub(crate) fn turn(
        name: String,
        quaternion: [Expr<'g>; 4],
        axis: usize,
        [rate, acceleration]: [Expr<'g>; 2],
    ) -> Self {
        let changes = by_turn(quaternion, axis).map(|x| ratio(1, 2) * x);
        Self {
            name,
            position: rate.graph().zero(),
            changes: quaternion.into_iter().zip(changes).collect(),
            rate,
            acceleration,
        }
    }

    /// True for a component of the angular velocity of an orientation.
    pub(crate) fn is_of_orientation(&self) -> bool {
        self.changes.len() > 1
    }

    /// Derivative by the coordinate; for a component of an angular velocity, the derivative by a rotation about its
    /// axis.
    pub(crate) fn derivative(&self) -> Derivative<'g> {
        Derivative::along(self.changes.iter().copied())
    }
}

/// `q (0, e)` for the unit vector `e` along an axis
fn by_turn<'g>([w, x, y, z]: [Expr<'g>; 4], axis: usize) -> [Expr<'g>; 4] {
    match axis {
        0 => [-x, w, z, -y],
        1 => [-y, -z, w, x],
        _ => [-z, y, -x, w],
    }
}

/// Positions of coordinates, with their time derivatives along a motion.
pub(crate) fn changes<'g, 'm>(coordinates: impl Iterator<Item = &'m Coordinate<'g>>) -> Vec<(Expr<'g>, Expr<'g>)>
where
    'g: 'm,
{
    let mut all: Vec<(Expr<'g>, Expr<'g>)> = Vec::new();
    for coordinate in coordinates {
        for &(position, factor) in &coordinate.changes {
            let change = factor * coordinate.rate;
            match all.iter_mut().find(|(known, _)| *known == position) {
                Some((_, sum)) => *sum += change,
                None => all.push((position, change)),
            }
        }
    }
    all
}

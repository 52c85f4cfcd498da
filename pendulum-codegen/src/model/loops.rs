//! What closed loops make of the coordinates that depend on others.

use super::{Coordinate, Dependence};
use crate::expr::Expr;

/// What closed loops make of the coordinates that depend on others.
#[derive(Clone, Debug, Default)]
pub(crate) struct Loops<'g> {
    /// How each of these coordinates changes.
    pub dependents: Vec<Slopes<'g>>,
    /// What the symbols of these stand for.
    pub dependence: Dependence<'g>,
    /// For each closed loop how far it is from its toggle, where it is zero: the sine of the angle between the two
    /// sides of a triangle; of loops that are solved together the volume that the directions of the dependent
    /// coordinates span.
    pub margins: Vec<Expr<'g>>,
    /// What vanishes where loops are closed that have no closed form.
    pub closings: Vec<Expr<'g>>,
    /// What Newton's method adds to the dependent coordinates in the state.
    pub corrections: Vec<Expr<'g>>,
    /// How far these loops are from being closed.
    pub gaps: Vec<Gap<'g>>,
    /// The angles whose turns forces take, and are not counted.
    pub uncounted: Vec<Uncounted<'g>>,
}

/// How a coordinate changes that depends on those of the state and of the drives.
#[derive(Clone, Debug)]
pub(crate) struct Slopes<'g> {
    /// Its derivatives by the coordinates of the state, then by those of the drives.
    pub slopes: Vec<Expr<'g>>,
    /// Its second rate where none of these accelerates.
    pub drift: Expr<'g>,
    /// Whether its position is a component of the state: no closed form of it is known, only its rate.
    pub in_state: bool,
}

/// How far a loop is from being closed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gap<'g> {
    /// The number of the loop.
    pub number: usize,
    /// The distance between its ends, in m, along the directions in which they are tied.
    pub distance: Expr<'g>,
    /// The angle between its frames, or their axes, in rad.
    pub angle: Expr<'g>,
    /// The sum of the lengths around it, in m.
    pub size: Expr<'g>,
}

/// An angle that is known within half a turn of its guess.
#[derive(Clone, Debug)]
pub(crate) struct Uncounted<'g> {
    pub coordinate: Coordinate<'g>,
    /// The cosine of half the angle from its guess: 0 where it would leave that half turn. 1 where its turns are
    /// counted, which depends on lengths.
    pub margin: Expr<'g>,
}

//! Solutions of closed loops.

use rustc_hash::FxHashMap;

use super::{Coordinate, Dependence};
use crate::expr::{Expr, ExprId};

/// Solution of the closed loops: dependent coordinates, margins and residuals.
#[derive(Clone, Debug, Default)]
pub(crate) struct Loops<'g> {
    /// Derivatives of each dependent coordinate.
    pub dependents: Vec<Slopes<'g>>,
    /// Values of the symbols of dependent coordinates.
    pub dependence: Dependence<'g>,
    /// Margin of each closed loop, which vanishes at its singularity (toggle): the sine of the angle between two sides
    /// of a triangle or, for loops that are solved together, the volume spanned by the directions of the dependent
    /// coordinates.
    pub margins: Vec<Expr<'g>>,
    /// Residuals of the loops that have no closed form.
    pub closings: Vec<Expr<'g>>,
    /// Newton corrections of the dependent coordinates that are part of the state.
    pub corrections: Vec<Expr<'g>>,
    /// Closure errors of the loops that have no closed form.
    pub gaps: Vec<Gap<'g>>,
    /// Angles whose whole turns affect forces but are not counted.
    pub uncounted: Vec<Uncounted<'g>>,
    /// Components of positions in the assembled configuration. Those that are missing are zero.
    pub assembled: FxHashMap<ExprId, f64>,
}

/// Derivatives of a dependent coordinate.
#[derive(Clone, Debug)]
pub(crate) struct Slopes<'g> {
    /// Derivatives by the coordinates of the state, then by those of the drives.
    pub slopes: Vec<Expr<'g>>,
    /// Acceleration if none of these coordinates accelerates.
    pub drift: Expr<'g>,
    /// True if the position is a component of the state, because only its rate has a closed form.
    pub in_state: bool,
}

/// Closure error of a loop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gap<'g> {
    /// Index of the loop.
    pub number: usize,
    /// Distance between its ends along the directions in which they are tied, in m.
    pub distance: Expr<'g>,
    /// Angle between its frames, or between their axes, in rad.
    pub angle: Expr<'g>,
    /// Sum of the lengths around the loop, in m.
    pub size: Expr<'g>,
}

/// An angle that is determined only within half a turn of its guess.
#[derive(Clone, Debug)]
pub(crate) struct Uncounted<'g> {
    pub coordinate: Coordinate<'g>,
    /// Cosine of half the angle from its guess: 0 where the angle would leave this half turn, 1 where its turns are
    /// counted. The lengths decide whether they are.
    pub margin: Expr<'g>,
}

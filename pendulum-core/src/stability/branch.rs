//! Results of continuation: branches of solutions and their bifurcations.

use super::StabilityError;

/// Solutions along a parameter, and the bifurcations between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch<P> {
    pub(super) points: Vec<BranchPoint<P>>,
    pub(super) bifurcations: Vec<Bifurcation<P>>,
    pub(super) ends: [BranchEnd; 2],
}

/// A solution on a branch.
#[derive(Clone, Debug, PartialEq)]
pub struct BranchPoint<P> {
    /// Value of the parameter.
    pub parameter: f64,
    /// Solution at this parameter.
    pub solution: P,
}

/// A point on a branch where the number of solutions or their stability changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Bifurcation<P> {
    /// Kind of the bifurcation.
    pub kind: BifurcationKind,
    /// Value of the parameter at the bifurcation.
    pub parameter: f64,
    /// Error bound of the parameter, from integration and rounding errors and from the last correction of the root
    /// search. Infinite if the search failed or the errors could not be measured.
    pub uncertainty: f64,
    /// Solution at the bifurcation.
    pub solution: P,
    /// Index of the last point of the branch before the bifurcation.
    pub behind: usize,
}

/// Kinds of bifurcations.
///
/// Yu. A. Kuznetsov, "Elements of Applied Bifurcation Theory", 4th ed. (2023), chapters 3 to 5.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BifurcationKind {
    /// The branch turns back: two solutions collide and vanish (fold, or saddle-node).
    Fold,
    /// Another branch crosses, at a pitchfork or a transcritical bifurcation. To follow it, start the continuation from
    /// a solution beside this branch.
    Crossing,
    /// A pair of eigenvalues of an equilibrium crosses the imaginary axis: flutter begins or ends, and a periodic orbit
    /// branches off.
    Hopf {
        /// Imaginary part of the pair, in rad/s.
        angular_frequency: f64,
    },
    /// A multiplier of a periodic orbit crosses -1: an orbit of twice the period branches off.
    PeriodDoubling,
    /// A pair of multipliers of a periodic orbit crosses the unit circle (Neimark-Sacker): an invariant torus branches
    /// off.
    Torus {
        /// Argument of the pair, in rad per period.
        angle: f64,
    },
    /// The stability changes, but no test function identifies the bifurcation: see the eigenvalues or multipliers of
    /// the solution.
    Unnamed,
}

/// Reason for the end of a branch.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum BranchEnd {
    /// The parameter reached an end of its span.
    Span,
    /// The branch is closed, up to full turns; the first point equals the last.
    Closed,
    /// The maximum number of points was reached.
    Points,
    /// The step failed at its minimum size, with this error: for example at a periodic orbit that shrinks to an
    /// equilibrium, or at the limit of the domain of the equations.
    Failed(StabilityError),
}

impl<P> Branch<P> {
    /// Points in the order of the branch, including the start of the continuation. From the start, the parameter
    /// increases toward the last point until the branch turns.
    #[must_use]
    pub fn points(&self) -> &[BranchPoint<P>] {
        &self.points
    }

    /// Bifurcations in the order of the branch.
    #[must_use]
    pub fn bifurcations(&self) -> &[Bifurcation<P>] {
        &self.bifurcations
    }

    /// Reasons for the ends of the branch, at its first and last point.
    #[must_use]
    pub fn ends(&self) -> [BranchEnd; 2] {
        self.ends.clone()
    }
}

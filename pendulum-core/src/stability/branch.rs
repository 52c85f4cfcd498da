//! What continuation gives: branches of solutions, and what happens on them.

use super::StabilityError;

/// Solutions along a parameter, with the places where their number or their stability changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch<P> {
    pub(super) points: Vec<BranchPoint<P>>,
    pub(super) bifurcations: Vec<Bifurcation<P>>,
    pub(super) ends: [BranchEnd; 2],
}

/// A solution on a branch.
#[derive(Clone, Debug, PartialEq)]
pub struct BranchPoint<P> {
    /// The parameter.
    pub parameter: f64,
    /// The solution there.
    pub solution: P,
}

/// A place on a branch where the number of solutions or their stability changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Bifurcation<P> {
    /// What happens.
    pub kind: BifurcationKind,
    /// The parameter at which it does.
    pub parameter: f64,
    /// The largest error of the parameter: by errors of the integration or of rounding, and by the last change of its
    /// search. Infinite where the search failed, or errors could not be measured.
    pub uncertainty: f64,
    /// The solution there.
    pub solution: P,
    /// It lies behind the point of this index, and before the next.
    pub behind: usize,
}

/// What happens at a bifurcation.
///
/// Yu. A. Kuznetsov, "Elements of Applied Bifurcation Theory", 4th ed. (2023), chapters 3 to 5.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BifurcationKind {
    /// The branch turns back: two solutions meet and vanish.
    Fold,
    /// Another branch crosses, at a pitchfork or a transcritical bifurcation; it is followed from a start beside this
    /// one.
    Crossing,
    /// An equilibrium begins to flutter, or ceases to: a pair of eigenvalues passes the imaginary axis, and a periodic
    /// orbit is born.
    Hopf {
        /// The frequency of the pair, in rad/s.
        angular_frequency: f64,
    },
    /// A multiplier of a periodic orbit passes -1: an orbit of twice its period is born.
    PeriodDoubling,
    /// A pair of multipliers of a periodic orbit passes the unit circle (Neimark and Sacker): motion on a torus is
    /// born.
    Torus {
        /// The angle of the pair, in rad a period.
        angle: f64,
    },
    /// The stability changes in a way that no test identifies: see the eigenvalues or multipliers of the solution.
    Unnamed,
}

/// Why a branch ends.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum BranchEnd {
    /// The parameter comes to an end of its span.
    Span,
    /// The branch comes back to where it began, full turns not counted; the first point is the last.
    Closed,
    /// There are as many points as were allowed.
    Points,
    /// The shortest step failed, for this reason: at a periodic orbit that shrinks to an equilibrium, or where the
    /// equations come to an end.
    Failed(StabilityError),
}

impl<P> Branch<P> {
    /// The points in the order of the branch. That where the search began is among them; from there the parameter rises
    /// toward the last, until the branch turns.
    #[must_use]
    pub fn points(&self) -> &[BranchPoint<P>] {
        &self.points
    }

    /// The bifurcations in the order of the branch.
    #[must_use]
    pub fn bifurcations(&self) -> &[Bifurcation<P>] {
        &self.bifurcations
    }

    /// Why the branch ends at its first point, and at its last.
    #[must_use]
    pub fn ends(&self) -> [BranchEnd; 2] {
        self.ends.clone()
    }
}

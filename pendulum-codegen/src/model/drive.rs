//! Driven joints.

use super::{Combination, Coordinate, CoordinateId, Model};
use crate::expr::Expr;

/// A joint that is driven: its coordinate is a function of time, and no part of the state.
#[derive(Clone, Debug)]
pub(crate) struct Drive<'g> {
    /// What stands for the coordinate and its derivatives until their values are put in.
    pub coordinate: Coordinate<'g>,
    /// The coordinate and its first two derivatives as functions of time.
    pub law: [Expr<'g>; 3],
}

impl<'g> Model<'g> {
    /// A coordinate of the state, or that of a drive.
    pub(crate) fn coordinate(&self, k: CoordinateId) -> &Coordinate<'g> {
        match usize::from(k).checked_sub(self.dof()) {
            Some(drive) => &self.drives[drive].coordinate,
            None => &self.coordinates[k],
        }
    }

    /// The coordinates of the state, then those of the drives.
    pub(crate) fn all_coordinates(&self) -> impl Iterator<Item = &Coordinate<'g>> {
        self.coordinates
            .iter()
            .chain(self.drives.iter().map(|drive| &drive.coordinate))
    }

    /// Whether a coordinate is that of a drive.
    pub(crate) fn is_driven(&self, k: CoordinateId) -> bool {
        usize::from(k) >= self.dof()
    }

    /// The second rate of a combination of coordinates where those of the state do not accelerate.
    pub(crate) fn driven_acceleration_of(&self, combination: &Combination) -> Expr<'g> {
        let zero = self.graph.zero();
        let own = |k| match self.is_driven(k) {
            true => self.coordinate(k).acceleration,
            false => zero,
        };
        combination.of(self.graph, own)
    }

    /// Expressions in which the laws of the drives stand in the place of their symbols.
    pub(crate) fn with_drives(&self, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
        if self.drives.is_empty() {
            return roots.to_vec();
        }
        let laws = self.drives.iter().flat_map(|Drive { coordinate: c, law }| {
            let symbols = [c.position, c.rate, c.acceleration];
            symbols.into_iter().zip(*law)
        });
        self.graph.substitute(roots, laws.collect())
    }
}

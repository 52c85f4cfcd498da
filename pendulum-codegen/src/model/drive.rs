//! Driven joints.

use super::{Combination, Coordinate, CoordinateId, Model, Slopes, Tree};
use crate::expr::Expr;

/// A driven joint: its coordinate is a function of time and not part of the state.
#[derive(Clone, Debug)]
pub(crate) struct Drive<'g> {
    /// Symbols of the coordinate and of its derivatives, until their values are substituted.
    pub coordinate: Coordinate<'g>,
    /// Coordinate and its first two derivatives, as functions of time.
    pub law: [Expr<'g>; 3],
}

impl<'g> Tree<'g> {
    /// Number of independent coordinates: those of the state and of the drives. Dependent coordinates are numbered
    /// after them.
    pub(crate) fn independent(&self) -> usize {
        self.dof() + self.drives.len()
    }

    /// The coordinate of number `k`, which belongs to the state or to a drive, or depends on these.
    pub(crate) fn coordinate(&self, k: CoordinateId) -> &Coordinate<'g> {
        let (dof, independent, k) = (self.dof(), self.independent(), usize::from(k));
        if k < dof {
            &self.coordinates[k]
        } else if k < independent {
            &self.drives[k - dof].coordinate
        } else {
            &self.dependents[k - independent]
        }
    }

    /// All coordinates: those of the state, those of the drives, then the dependent ones.
    pub(crate) fn all_coordinates(&self) -> impl Iterator<Item = &Coordinate<'g>> {
        self.coordinates
            .iter()
            .chain(self.drives.iter().map(|drive| &drive.coordinate))
            .chain(&self.dependents)
    }

    /// True for a coordinate of the state.
    pub(crate) fn is_free(&self, k: CoordinateId) -> bool {
        usize::from(k) < self.dof()
    }

    /// True for the coordinate of a drive.
    pub(crate) fn is_driven(&self, k: CoordinateId) -> bool {
        (self.dof()..self.independent()).contains(&usize::from(k))
    }

    /// Replaces the symbols of the drives by their laws.
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

impl<'g> Model<'g> {
    /// Acceleration of a combination of coordinates if the coordinates of the state do not accelerate.
    pub(crate) fn driven_acceleration_of(&self, combination: &Combination) -> Expr<'g> {
        combination.of(self.graph, |k| self.driven_acceleration(k))
    }

    /// Acceleration of a coordinate if the coordinates of the state do not accelerate.
    pub(crate) fn driven_acceleration(&self, k: CoordinateId) -> Expr<'g> {
        if self.is_free(k) {
            return self.graph.zero();
        }
        let Some(n) = usize::from(k).checked_sub(self.independent()) else {
            return self.coordinate(k).acceleration;
        };
        let Slopes { slopes, drift, .. } = &self.loops.dependents[n];
        let of_drives = slopes[self.dof()..].iter().zip(&self.drives);
        of_drives.fold(*drift, |sum, (&slope, drive)| {
            sum + slope * drive.coordinate.acceleration
        })
    }

    /// Acceleration of a combination of coordinates if only the coordinates of the state accelerate.
    pub(crate) fn own_acceleration_of(&self, combination: &Combination) -> Expr<'g> {
        combination.of(self.graph, |k| match self.slopes(k) {
            Some(slopes) => {
                let terms = slopes.iter().zip(&self.coordinates);
                self.graph
                    .sum(terms.map(|(&slope, c)| slope * c.acceleration).collect::<Vec<_>>())
            }
            None if self.is_free(k) => self.coordinate(k).acceleration,
            None => self.graph.zero(),
        })
    }
}

//! Driven joints.

use super::{Combination, Coordinate, CoordinateId, Model, Slopes, Tree};
use crate::expr::Expr;

/// A joint that is driven: its coordinate is a function of time, and no part of the state.
#[derive(Clone, Debug)]
pub(crate) struct Drive<'g> {
    /// What stands for the coordinate and its derivatives until their values are put in.
    pub coordinate: Coordinate<'g>,
    /// The coordinate and its first two derivatives as functions of time.
    pub law: [Expr<'g>; 3],
}

impl<'g> Tree<'g> {
    /// How many coordinates depend on no others: those of the state and of the drives. The others are numbered behind
    /// them.
    pub(crate) fn independent(&self) -> usize {
        self.dof() + self.drives.len()
    }

    /// A coordinate of the state, of a drive, or one that depends on these.
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

    /// The coordinates of the state, then those of the drives, then the dependent ones.
    pub(crate) fn all_coordinates(&self) -> impl Iterator<Item = &Coordinate<'g>> {
        self.coordinates
            .iter()
            .chain(self.drives.iter().map(|drive| &drive.coordinate))
            .chain(&self.dependents)
    }

    /// Whether a coordinate is one of the state.
    pub(crate) fn is_free(&self, k: CoordinateId) -> bool {
        usize::from(k) < self.dof()
    }

    /// Whether a coordinate is that of a drive.
    pub(crate) fn is_driven(&self, k: CoordinateId) -> bool {
        (self.dof()..self.independent()).contains(&usize::from(k))
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

impl<'g> Model<'g> {
    /// The second rate of a combination of coordinates where those of the state do not accelerate.
    pub(crate) fn driven_acceleration_of(&self, combination: &Combination) -> Expr<'g> {
        combination.of(self.graph, |k| self.driven_acceleration(k))
    }

    /// The second rate of a coordinate where those of the state do not accelerate.
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

    /// The second rate of a combination of coordinates where only those of the state accelerate.
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

//! Constraints: dry friction and stops of joints, and walls.

use num_traits::ToPrimitive;

use super::{Combination, CoordinateId, Model};
use crate::expr::{Expr, Rational, Unary};

/// Maximum number of constraints of a scene: the core stores one bit for each.
pub(crate) const MAX_CONSTRAINTS: usize = 8;

/// A constraint of the motion: a function of the state, with limits or with dry friction against its rate.
#[derive(Clone, Debug)]
pub(crate) struct Constraint<'g> {
    /// Name of the joint coordinate, or of the wall.
    pub name: String,
    /// Coordinate that the joint adds to the scene; none for a wall.
    pub coordinate: Option<CoordinateId>,
    /// Relative joint coordinate, as a combination of the coordinates of the scene; empty for a wall.
    pub motion: Combination,
    /// Constrained function of the state.
    pub value: Expr<'g>,
    /// The value as declared, in terms of the symbols of points.
    pub declared: Expr<'g>,
    /// Symbol of the constraint force.
    pub force: Expr<'g>,
    /// Friction, limits and restitution.
    pub law: Law<'g>,
}

/// Friction and impact parameters. Those that are omitted are zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Law<'g> {
    /// Friction force while slipping.
    pub slipping: Expr<'g>,
    /// Maximum friction force while sticking.
    pub sticking: Expr<'g>,
    /// Lower limit of the value.
    pub low: Option<Expr<'g>>,
    /// Upper limit of the value.
    pub high: Option<Expr<'g>>,
    /// Coefficient of restitution: rate after an impact, relative to the rate before.
    pub restitution: Expr<'g>,
    /// Minimum rate of an impact that rebounds.
    pub slow: Expr<'g>,
}

impl<'g> Law<'g> {
    /// All its expressions.
    pub(crate) fn numbers(&self) -> Vec<Expr<'g>> {
        let ends = [self.slipping, self.sticking, self.restitution, self.slow];
        ends.into_iter().chain(self.low).chain(self.high).collect()
    }
}

impl<'g> Constraint<'g> {
    /// Indices of the components of the state whose sum is the rate, with their signs; empty if the rate is anything
    /// else. The joint's own coordinate comes last and occurs in no earlier constraint, because joints are listed after
    /// those below them.
    pub(crate) fn rate(&self, model: &Model<'g>) -> Vec<(usize, i8)> {
        let Some(own) = self.coordinate else { return Vec::new() };
        let rate = self.motion.without(own);
        let own_factor = self.motion.factor(own);
        let terms = rate.terms().chain([(own, &own_factor)]);
        let first_rate = model.positions().len();
        let component = |(k, factor): (CoordinateId, &Rational)| {
            let sign = factor
                .is_integer()
                .then(|| factor.to_i8())
                .flatten()
                .filter(|sign| sign.abs() == 1)?;
            model.is_free(k).then_some((first_rate + usize::from(k), sign))
        };
        terms.map(component).collect::<Option<_>>().unwrap_or_default()
    }
}

impl<'g> Model<'g> {
    /// True if there are constraints.
    pub(crate) fn is_hybrid(&self) -> bool {
        !self.constraints.is_empty()
    }

    /// Symbols of the constraint forces.
    pub(crate) fn force_symbols(&self) -> Vec<Expr<'g>> {
        self.constraints.iter().map(|constraint| constraint.force).collect()
    }

    /// Values of the constraints.
    pub(crate) fn constraint_values(&self) -> Vec<Expr<'g>> {
        self.constraints.iter().map(|constraint| constraint.value).collect()
    }

    /// Rates of the constraints.
    pub(crate) fn constraint_rates(&self) -> Vec<Expr<'g>> {
        let mut along = self.along_motion();
        self.constraint_values()
            .into_iter()
            .map(|value| along.of(value))
            .collect()
    }

    /// Functions that decide when a mode ends: the rates, then the values that have limits.
    pub(crate) fn watched(&self) -> Vec<Expr<'g>> {
        let rates = self.constraint_rates().into_iter();
        let limited = self
            .constraints
            .iter()
            .filter(|constraint| constraint.law.low.is_some());
        let watched: Vec<Expr<'g>> = rates.chain(limited.map(|constraint| constraint.value)).collect();
        self.with_drives(&watched)
    }

    /// Replaces the force of each constraint by the slipping friction, opposite in sign to the rate.
    pub(crate) fn with_friction(&self, roots: &[Expr<'g>]) -> Vec<Expr<'g>> {
        if !self.is_hybrid() {
            return roots.to_vec();
        }
        let rates = self.with_drives(&self.constraint_rates());
        let forces = self.constraints.iter().zip(rates);
        let forces =
            forces.map(|(constraint, rate)| (constraint.force, -constraint.law.slipping * rate.apply(Unary::Sign)));
        self.graph.substitute(roots, forces.collect())
    }
}

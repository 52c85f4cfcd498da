//! Constraints: dry friction and stops of joints, and walls.

use num_traits::ToPrimitive;

use super::{Combination, CoordinateId, Model};
use crate::expr::{Expr, Rational, Unary};

/// The most constraints of a scene: the core keeps a bit for each.
pub(crate) const MAX_CONSTRAINTS: usize = 8;

/// A constraint of the motion: a value that the state determines, with friction against its rate, or limits.
#[derive(Clone, Debug)]
pub(crate) struct Constraint<'g> {
    /// The coordinate of a joint, or the name of a wall.
    pub name: String,
    /// The coordinate that a joint brings into the scene; none for a wall.
    pub coordinate: Option<CoordinateId>,
    /// A joint's own coordinate in those of the scene; nothing for a wall.
    pub motion: Combination,
    /// The value.
    pub value: Expr<'g>,
    /// The symbol of the force along it.
    pub force: Expr<'g>,
    /// Its numbers.
    pub law: Law<'g>,
}

/// What friction and impacts do. Numbers that are left out are zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Law<'g> {
    /// The friction force while it slips.
    pub slipping: Expr<'g>,
    /// The largest friction force at rest.
    pub sticking: Expr<'g>,
    /// The least value.
    pub low: Option<Expr<'g>>,
    /// The largest value.
    pub high: Option<Expr<'g>>,
    /// How much of the rate remains after an impact.
    pub restitution: Expr<'g>,
    /// Below this rate nothing rebounds.
    pub slow: Expr<'g>,
}

impl<'g> Law<'g> {
    /// Its numbers, one after the other.
    pub(crate) fn numbers(&self) -> Vec<Expr<'g>> {
        let ends = [self.slipping, self.sticking, self.restitution, self.slow];
        ends.into_iter().chain(self.low).chain(self.high).collect()
    }
}

impl<'g> Constraint<'g> {
    /// The components of the state whose sum is the rate, with their signs; empty where the rate is anything else. The
    /// joint's own coordinate stands last, and in no constraint before, as a joint is listed after those below it.
    pub(crate) fn rate(&self, model: &Model<'g>) -> Vec<(usize, i8)> {
        let Some(own) = self.coordinate else { return Vec::new() };
        let rate = self.motion.without(own);
        let own_factor = self.motion.factor(own);
        let terms = rate.terms().chain([(own, &own_factor)]);
        let component = |(k, factor): (CoordinateId, &Rational)| {
            let sign = factor
                .is_integer()
                .then(|| factor.to_i8())
                .flatten()
                .filter(|sign| sign.abs() == 1)?;
            model.is_free(k).then_some((model.dof() + usize::from(k), sign))
        };
        terms.map(component).collect::<Option<_>>().unwrap_or_default()
    }
}

impl<'g> Model<'g> {
    /// Whether there are constraints.
    pub(crate) fn is_hybrid(&self) -> bool {
        !self.constraints.is_empty()
    }

    /// The symbols of the forces along the constraints.
    pub(crate) fn force_symbols(&self) -> Vec<Expr<'g>> {
        self.constraints.iter().map(|constraint| constraint.force).collect()
    }

    /// The values of the constraints.
    pub(crate) fn constraint_values(&self) -> Vec<Expr<'g>> {
        self.constraints.iter().map(|constraint| constraint.value).collect()
    }

    /// Their rates.
    pub(crate) fn constraint_rates(&self) -> Vec<Expr<'g>> {
        let mut along = self.along_motion();
        self.constraint_values()
            .into_iter()
            .map(|value| along.of(value))
            .collect()
    }

    /// What decides when a mode ends: rates, and the values that have limits.
    pub(crate) fn watched(&self) -> Vec<Expr<'g>> {
        let rates = self.constraint_rates().into_iter();
        let limited = self
            .constraints
            .iter()
            .filter(|constraint| constraint.law.low.is_some());
        let watched: Vec<Expr<'g>> = rates.chain(limited.map(|constraint| constraint.value)).collect();
        self.with_drives(&watched)
    }

    /// Expressions in which friction acts by the sign of each rate, and nothing else along the constraints.
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

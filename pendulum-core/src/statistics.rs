//! Counted work.

/// How much work an integration was.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
#[non_exhaustive]
pub struct Statistics {
    /// Evaluations of the right-hand side, those for the first step size included.
    pub evaluations: usize,
    /// Steps that were accepted.
    pub accepted: usize,
    /// Steps that were tried and rejected.
    pub rejected: usize,
    /// Evaluations of the Jacobian, by implicit methods.
    pub jacobians: usize,
    /// Matrices that implicit methods factored, real and complex.
    pub factorizations: usize,
    /// Iterations in which implicit methods solved for their stages.
    pub iterations: usize,
    /// Accepted steps that [`Auto`](crate::Auto) left to its implicit method.
    pub stiff: usize,
    /// How often [`Auto`](crate::Auto) changed between its methods.
    pub switches: usize,
    /// Impacts at the same time whose order decides how the motion goes on, and could not be resolved: see
    /// [`Ambiguity`](crate::hybrid::Ambiguity).
    pub ambiguities: usize,
}

#[cfg(feature = "std")]
impl Statistics {
    /// Adds the work of another.
    pub(crate) fn add(&mut self, other: &Self) {
        self.evaluations += other.evaluations;
        self.accepted += other.accepted;
        self.rejected += other.rejected;
        self.jacobians += other.jacobians;
        self.factorizations += other.factorizations;
        self.iterations += other.iterations;
        self.stiff += other.stiff;
        self.switches += other.switches;
        self.ambiguities += other.ambiguities;
    }
}

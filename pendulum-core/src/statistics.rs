//! Work counts.

/// Amount of work of an integration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
#[non_exhaustive]
pub struct Statistics {
    /// Number of evaluations of the right-hand side, including those for the first step size.
    pub evaluations: usize,
    /// Number of accepted steps.
    pub accepted: usize,
    /// Number of rejected steps.
    pub rejected: usize,
    /// Number of evaluations of the Jacobian, by implicit methods.
    pub jacobians: usize,
    /// Number of matrices factored by implicit methods, real and complex.
    pub factorizations: usize,
    /// Number of iterations in which implicit methods solved for their stages.
    pub iterations: usize,
    /// Number of accepted steps that [`Auto`](crate::Auto) took with its implicit method.
    pub stiff: usize,
    /// Number of switches of [`Auto`](crate::Auto) between its methods.
    pub switches: usize,
    /// Number of simultaneous impacts whose order affects the motion afterwards, and could not be resolved: see
    /// [`Ambiguity`](crate::hybrid::Ambiguity).
    pub ambiguities: usize,
}

#[cfg(feature = "std")]
impl Statistics {
    /// Adds the work of another integration.
    #[inline]
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

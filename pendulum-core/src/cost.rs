//! Counted operations: what a generated function costs, known when it is generated.

use std::fmt;

/// The operations of one evaluation of a generated function.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Operations {
    /// Additions, subtractions and negations.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Sine-cosine pairs, each counted once.
    pub sincos: usize,
    /// Other functions: `tan`, `exp`, `ln`, `sqrt`, `tanh`, `atan2`, `powf`, `abs`, `signum`.
    pub functions: usize,
}

impl Operations {
    /// No operations.
    pub const ZERO: Self = Self {
        additions: 0,
        multiplications: 0,
        divisions: 0,
        sincos: 0,
        functions: 0,
    };

    /// Additions and multiplications together: the figure by which forward dynamics are usually compared.
    #[must_use]
    pub const fn flops(&self) -> usize {
        self.additions + self.multiplications
    }
}

/// Lists what there is, e.g. "21 additions, 12 multiplications, 1 division, 2 sine-cosine pairs".
impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows = [
            (self.additions, "addition"),
            (self.multiplications, "multiplication"),
            (self.divisions, "division"),
            (self.sincos, "sine-cosine pair"),
            (self.functions, "other function"),
        ];
        let mut separator = "";
        for (count, name) in rows.into_iter().filter(|&(count, _)| count > 0) {
            let plural = if count == 1 { "" } else { "s" };
            write!(f, "{separator}{count} {name}{plural}")?;
            separator = ", ";
        }
        if separator.is_empty() {
            f.write_str("no operations")?;
        }
        Ok(())
    }
}

/// The operations of each function of a generated model; [`Operations::ZERO`] for functions that were not asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Cost {
    /// [`System::rhs`](crate::System::rhs).
    pub rhs: Operations,
    /// [`Jacobian::jacobian`](crate::Jacobian::jacobian).
    pub jacobian: Operations,
    /// [`Controlled::input_jacobian`](crate::Controlled::input_jacobian).
    pub input_jacobian: Operations,
    /// [`Energy::kinetic`](crate::Energy::kinetic).
    pub kinetic: Operations,
    /// [`Energy::potential`](crate::Energy::potential).
    pub potential: Operations,
    /// The mass matrix.
    pub mass_matrix: Operations,
    /// The bias: all forces that stand beside `A qdd` in the equations of motion.
    pub bias: Operations,
}

impl Cost {
    /// A model without functions.
    pub const ZERO: Self = Self {
        rhs: Operations::ZERO,
        jacobian: Operations::ZERO,
        input_jacobian: Operations::ZERO,
        kinetic: Operations::ZERO,
        potential: Operations::ZERO,
        mass_matrix: Operations::ZERO,
        bias: Operations::ZERO,
    };
}

#[cfg(test)]
mod tests {
    use super::Operations;

    #[test]
    fn operations_are_listed_with_their_plurals() {
        let operations = Operations {
            additions: 21,
            multiplications: 12,
            divisions: 1,
            sincos: 2,
            ..Operations::ZERO
        };
        assert_eq!(
            operations.to_string(),
            "21 additions, 12 multiplications, 1 division, 2 sine-cosine pairs"
        );
        assert_eq!(operations.flops(), 33);
        assert_eq!(Operations::ZERO.to_string(), "no operations");
    }
}

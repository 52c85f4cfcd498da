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
    /// The longest chain of operations that wait for each other, in additions: a division counts 4, a sine-cosine pair 20, another
    /// function 10. However many units a processor has, an evaluation takes this long.
    pub chain: usize,
}

impl Operations {
    /// No operations.
    pub const ZERO: Self = Self::new(0, 0, 0, 0, 0, 0);

    /// Counts in the order of the fields.
    #[must_use]
    pub const fn new(
        additions: usize,
        multiplications: usize,
        divisions: usize,
        sincos: usize,
        functions: usize,
        chain: usize,
    ) -> Self {
        Self {
            additions,
            multiplications,
            divisions,
            sincos,
            functions,
            chain,
        }
    }

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

/// What one generated function takes, and what it would have taken in other forms.
///
/// The generator writes each function in every form of the dynamics that it knows, and keeps that of the least weight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct FunctionCost {
    /// Its operations.
    pub operations: Operations,
    /// The form that it is written in, for example "recursion, L^T D L".
    pub form: &'static str,
    /// The best of each other kind of form and its operations, from the least weight on: the time that operations and their longest
    /// chain are expected to take. Forms of more than twice the operations were not searched for common parts, and are counted
    /// as they stood.
    pub others: &'static [(&'static str, Operations)],
}

impl FunctionCost {
    /// A function that was not asked for.
    pub const ZERO: Self = Self {
        operations: Operations::ZERO,
        form: "",
        others: &[],
    };

    /// Additions and multiplications together.
    #[must_use]
    pub const fn flops(&self) -> usize {
        self.operations.flops()
    }
}

/// Lists the operations; the alternate form `{:#}` is a table of all forms.
impl fmt::Display for FunctionCost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !f.alternate() {
            return self.operations.fmt(f);
        }
        write!(
            f,
            "{}: {}, longest chain {}",
            self.form, self.operations, self.operations.chain
        )?;
        for (form, operations) in self.others {
            write!(f, "\n{form}: {operations}, longest chain {}", operations.chain)?;
        }
        Ok(())
    }
}

/// The cost of each function of a generated model; [`FunctionCost::ZERO`] for functions that were not asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Cost {
    /// [`System::rhs`](crate::System::rhs).
    pub rhs: FunctionCost,
    /// [`Jacobian::rhs_and_jacobian`](crate::Jacobian::rhs_and_jacobian): the Jacobian together with the right-hand side.
    pub jacobian: FunctionCost,
    /// [`Jacobian::time_derivative`](crate::Jacobian::time_derivative), where the time occurs.
    pub time_derivative: FunctionCost,
    /// [`Controlled::input_jacobian`](crate::Controlled::input_jacobian).
    pub input_jacobian: FunctionCost,
    /// [`Energy::kinetic`](crate::Energy::kinetic).
    pub kinetic: FunctionCost,
    /// [`Energy::potential`](crate::Energy::potential).
    pub potential: FunctionCost,
    /// The mass matrix.
    pub mass_matrix: FunctionCost,
    /// The bias: velocity terms and gravity.
    pub bias: FunctionCost,
    /// The momenta of the coordinates.
    pub momentum: FunctionCost,
    /// [`Canonical::canonical`](crate::Canonical::canonical).
    pub canonical: FunctionCost,
    /// [`Canonical::canonical_jacobian`](crate::Canonical::canonical_jacobian).
    pub canonical_jacobian: FunctionCost,
    /// The forces that accelerations take.
    pub inverse_dynamics: FunctionCost,
    /// The derivatives of the accelerations by the parameters.
    pub parameter_jacobian: FunctionCost,
    /// One order of [`TaylorSeries::series`](crate::TaylorSeries::series), without the sums of the products of series.
    pub taylor: FunctionCost,
    /// The number of these products: for order `k` each takes `k - 1` multiplications and additions.
    pub taylor_products: usize,
}

impl Cost {
    /// A model without functions.
    pub const ZERO: Self = Self {
        rhs: FunctionCost::ZERO,
        jacobian: FunctionCost::ZERO,
        time_derivative: FunctionCost::ZERO,
        input_jacobian: FunctionCost::ZERO,
        kinetic: FunctionCost::ZERO,
        potential: FunctionCost::ZERO,
        mass_matrix: FunctionCost::ZERO,
        bias: FunctionCost::ZERO,
        momentum: FunctionCost::ZERO,
        canonical: FunctionCost::ZERO,
        canonical_jacobian: FunctionCost::ZERO,
        inverse_dynamics: FunctionCost::ZERO,
        parameter_jacobian: FunctionCost::ZERO,
        taylor: FunctionCost::ZERO,
        taylor_products: 0,
    };
}

/// A line for each function that was asked for; the alternate form `{:#}` has one for each form of it.
impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let functions = [
            ("rhs", &self.rhs),
            ("jacobian", &self.jacobian),
            ("time_derivative", &self.time_derivative),
            ("input_jacobian", &self.input_jacobian),
            ("kinetic", &self.kinetic),
            ("potential", &self.potential),
            ("mass_matrix", &self.mass_matrix),
            ("bias", &self.bias),
            ("momentum", &self.momentum),
            ("canonical", &self.canonical),
            ("canonical_jacobian", &self.canonical_jacobian),
            ("inverse_dynamics", &self.inverse_dynamics),
            ("parameter_jacobian", &self.parameter_jacobian),
            ("taylor, each order", &self.taylor),
        ];
        let mut separator = "";
        for (name, cost) in functions.into_iter().filter(|(_, cost)| !cost.form.is_empty()) {
            write!(f, "{separator}{name}: ")?;
            cost.fmt(f)?;
            separator = "\n";
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{FunctionCost, Operations};

    #[test]
    fn operations_are_listed_with_their_plurals() {
        let operations = Operations::new(21, 12, 1, 2, 0, 33);
        assert_eq!(
            operations.to_string(),
            "21 additions, 12 multiplications, 1 division, 2 sine-cosine pairs"
        );
        assert_eq!(operations.flops(), 33);
        assert_eq!(Operations::ZERO.to_string(), "no operations");
    }

    #[test]
    fn every_form_has_a_line() {
        const COST: FunctionCost = FunctionCost {
            operations: Operations::ZERO,
            form: "recursion",
            others: &[("closed form", Operations::new(2, 0, 0, 0, 0, 1))],
        };
        assert_eq!(COST.to_string(), "no operations");
        assert_eq!(
            format!("{COST:#}"),
            "recursion: no operations, longest chain 0\nclosed form: 2 additions, longest chain 1"
        );
        let all = super::Cost {
            bias: COST,
            ..super::Cost::ZERO
        };
        assert_eq!(all.to_string(), "bias: no operations");
    }
}

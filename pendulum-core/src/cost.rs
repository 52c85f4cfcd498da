//! Operation counts of generated functions, determined when they are generated.

use core::fmt;
use core::ops::Index;

/// Operation counts of one evaluation of a generated function.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Operations {
    /// Number of additions, subtractions and negations.
    pub additions: usize,
    /// Number of multiplications.
    pub multiplications: usize,
    /// Number of divisions.
    pub divisions: usize,
    /// Number of sine-cosine pairs, each counted once.
    pub sincos: usize,
    /// Number of other functions: `tan`, `exp`, `ln`, `sqrt`, `tanh`, `atan2`, `powf`, `abs`, `signum`.
    pub functions: usize,
    /// Length of the longest chain of dependent operations, in additions: a division counts 4, a sine-cosine pair 20,
    /// another function 10. An evaluation takes at least this long, however many units a processor has.
    pub chain: usize,
}

impl Operations {
    /// No operations.
    pub const ZERO: Self = Self::new(0, 0, 0, 0, 0, 0);

    /// Creates counts, in the order of the fields.
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

    /// Adds `others`, with both chains one after the other.
    #[must_use]
    pub const fn and(self, others: Self) -> Self {
        Self {
            additions: self.additions + others.additions,
            multiplications: self.multiplications + others.multiplications,
            divisions: self.divisions + others.divisions,
            sincos: self.sincos + others.sincos,
            functions: self.functions + others.functions,
            chain: self.chain + others.chain,
        }
    }

    /// Repeats the operations `count` times, one after the other.
    #[must_use]
    pub const fn times(self, count: usize) -> Self {
        Self {
            additions: self.additions * count,
            multiplications: self.multiplications * count,
            divisions: self.divisions * count,
            sincos: self.sincos * count,
            functions: self.functions * count,
            chain: self.chain * count,
        }
    }

    /// Replaces the length of the chain.
    pub(crate) const fn with_chain(self, chain: usize) -> Self {
        Self { chain, ..self }
    }

    /// Maximum of both counts of each kind: an upper bound of either.
    #[must_use]
    pub const fn or(self, others: Self) -> Self {
        const fn larger(a: usize, b: usize) -> usize {
            if a > b { a } else { b }
        }
        Self {
            additions: larger(self.additions, others.additions),
            multiplications: larger(self.multiplications, others.multiplications),
            divisions: larger(self.divisions, others.divisions),
            sincos: larger(self.sincos, others.sincos),
            functions: larger(self.functions, others.functions),
            chain: larger(self.chain, others.chain),
        }
    }

    /// Additions and multiplications together: the figure by which forward dynamics are usually compared.
    #[must_use]
    pub const fn flops(&self) -> usize {
        self.additions + self.multiplications
    }
}

/// Lists the nonzero counts, e.g. "21 additions, 12 multiplications, 1 division, 2 sine-cosine pairs".
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

/// Cost of one generated function, and its cost in other forms.
///
/// The generator writes each function in every available form of the dynamics, and keeps the form of the least weight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct FunctionCost {
    /// Form of the function, for example "recursion, L^T D L".
    pub form: &'static str,
    /// Operation counts.
    pub operations: Operations,
    /// Number of products of series, if the function is one order of a power series. These are extra: for order `k`
    /// each takes `k - 1` multiplications and additions.
    pub products: Option<usize>,
    /// Best of each other kind of form, ordered by weight: the expected time of the operations and their longest chain.
    /// Forms with more than twice the operations were not searched for common subexpressions, and are counted as they
    /// were.
    pub others: &'static [FunctionCost],
}

impl FunctionCost {
    /// Creates the cost of a function in one form.
    #[must_use]
    pub const fn new(form: &'static str, operations: Operations) -> Self {
        Self {
            form,
            operations,
            products: None,
            others: &[],
        }
    }

    /// Turns it into the cost of one order of a power series with this number of products of series.
    #[must_use]
    pub const fn with_products(mut self, products: usize) -> Self {
        self.products = Some(products);
        self
    }

    /// Sets the costs of other forms.
    #[must_use]
    pub const fn with_others(mut self, others: &'static [Self]) -> Self {
        self.others = others;
        self
    }

    /// Additions and multiplications together.
    #[must_use]
    pub const fn flops(&self) -> usize {
        self.operations.flops()
    }

    /// Operations of a power series of this order, of a state of `n` components, if the cost is for one order. The
    /// start of the series is not included: it takes about as many operations as the right-hand side, which it computes
    /// in another form.
    ///
    /// ```
    /// use pendulum_core::{FunctionCost, Operations};
    ///
    /// let each_order = FunctionCost::new("closed form", Operations::new(28, 37, 0, 0, 0, 12)).with_products(12);
    /// // orders 2 and 3, with two terms of each product, and each component over its order
    /// assert_eq!(each_order.series(3, 4).multiplications, 2 * (37 + 2 * 12 + 4));
    /// ```
    #[must_use]
    pub const fn series(&self, order: usize, n: usize) -> Operations {
        let products = match self.products {
            Some(products) => products,
            None => 0,
        };
        let mut operations = Operations::ZERO;
        let mut k = 1;
        while k < order {
            // `Products::sums`, then `Newest::add`
            let terms = k.saturating_sub(3);
            let sums = Operations::new(terms + 3, terms + 2, 0, 0, 0, terms + 4);
            let sums = sums.times(products).with_chain(sums.chain);
            // division by the order
            let next = Operations::new(0, n, 1, 0, 0, 5);
            operations = operations.and(sums).and(self.operations).and(next);
            k += 1;
        }
        operations
    }

    fn write_counts(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.operations)?;
        match self.products {
            Some(1) => write!(f, ", 1 product of series"),
            Some(products) => write!(f, ", {products} products of series"),
            None => Ok(()),
        }
    }
}

/// Lists the operations; the alternate form `{:#}` is a table of all forms.
impl fmt::Display for FunctionCost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !f.alternate() {
            return self.write_counts(f);
        }
        let mut separator = "";
        for form in core::iter::once(self).chain(self.others) {
            write!(f, "{separator}{}: ", form.form)?;
            form.write_counts(f)?;
            write!(f, ", longest chain {}", form.operations.chain)?;
            separator = "\n";
        }
        Ok(())
    }
}

/// The cost of each function of a generated model, by its name.
///
/// The names are `rhs`, `jacobian` (with the right-hand side), `time_derivative` (if time occurs), `input_jacobian`,
/// `kinetic`, `potential`, `mass_matrix`, `bias`, `momentum`, `canonical`, `canonical_jacobian`, `inverse_dynamics`,
/// `parameter_jacobian`, `adjoint`, `hessian_product` and `taylor` (one order of the series), as far as they were
/// generated.
///
/// ```
/// # pendulum_core::mechanism! {
/// #     pub Swing {
/// #         gravity: [0, -9.81, 0],
/// #         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
/// #     }
/// # }
/// assert_eq!(Swing::COST["rhs"].flops(), 1);
/// assert_eq!(Swing::COST["rhs"].operations.sincos, 1);
/// assert!(Swing::COST.get("mass_matrix").is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Cost {
    functions: &'static [(&'static str, FunctionCost)],
}

impl Cost {
    /// Creates the costs from pairs of a function's name and cost.
    #[must_use]
    pub const fn new(functions: &'static [(&'static str, FunctionCost)]) -> Self {
        Self { functions }
    }

    /// Cost of a function; `None` if it was not generated.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&'static FunctionCost> {
        self.iter().find(|(known, _)| *known == name).map(|(_, cost)| cost)
    }

    /// Generated functions and their costs.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, &'static FunctionCost)> + use<> {
        self.functions.iter().map(|(name, cost)| (*name, cost))
    }
}

impl Index<&str> for Cost {
    type Output = FunctionCost;

    /// Cost of a function.
    ///
    /// # Panics
    /// If the function was not generated; [`Cost::get`] returns `None` instead.
    #[track_caller]
    fn index(&self, name: &str) -> &FunctionCost {
        self.get(name).unwrap_or_else(|| {
            let known = fmt::from_fn(|f| {
                let mut known = self.iter().map(|(known, _)| known);
                f.write_str(known.next().unwrap_or("nothing"))?;
                known.try_for_each(|known| write!(f, ", {known}"))
            });
            panic!("`{name}` was not generated; there are costs of: {known}")
        })
    }
}

/// Writes a line for each function; the alternate form `{:#}` has a line for each form of it.
impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut separator = "";
        for (name, cost) in self.iter() {
            let each_order = if cost.products.is_some() { ", each order" } else { "" };
            write!(f, "{separator}{name}{each_order}: ")?;
            cost.fmt(f)?;
            separator = "\n";
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Cost, FunctionCost, Operations};

    const COST: Cost = Cost::new(&[
        (
            "bias",
            FunctionCost::new("recursion", Operations::ZERO)
                .with_others(&[FunctionCost::new("closed form", Operations::new(2, 0, 0, 0, 0, 1))]),
        ),
        (
            "taylor",
            FunctionCost::new("recursion", Operations::new(1, 1, 0, 0, 0, 2)).with_products(12),
        ),
    ]);

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
    fn every_function_has_a_line_and_in_the_table_every_form() {
        assert_eq!(
            COST.to_string(),
            "bias: no operations\ntaylor, each order: 1 addition, 1 multiplication, 12 products of series"
        );
        assert_eq!(
            format!("{COST:#}"),
            "bias: recursion: no operations, longest chain 0\nclosed form: 2 additions, longest chain 1\n\
             taylor, each order: recursion: 1 addition, 1 multiplication, 12 products of series, longest chain 2"
        );
    }

    #[test]
    fn costs_are_found_by_name() {
        assert_eq!(COST["taylor"].flops(), 2);
        assert!(COST.get("rhs").is_none());
        assert!(COST.iter().map(|(name, _)| name).eq(["bias", "taylor"]));
    }

    #[test]
    #[should_panic(expected = "`rhs` was not generated; there are costs of: bias, taylor")]
    fn a_missing_function_is_named_with_those_that_there_are() {
        let _ = COST["rhs"];
    }
}

//! Likelihood of measurements, and comparison of models by it.

use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Likelihood of measurements under a fitted model with normal noise.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Likelihood {
    /// Natural logarithm of the likelihood; NaN with a robust loss, which has none.
    pub logarithm: f64,
    /// Number of unknowns: free parameters, starts, and estimated noise.
    pub unknowns: usize,
    /// Number of measured values.
    pub values: usize,
}

/// Comparison of a model with a fuller one, of which it is a special case.
///
/// S. S. Wilks, Annals of Mathematical Statistics 9 (1938), for the test; H. Akaike (1974) and G. Schwarz (1978) for
/// the criteria.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// Twice the difference of the logarithms.
    pub statistic: f64,
    /// Number of further unknowns.
    pub degrees: usize,
    /// Probability of a statistic at least as large if the simpler model is true. Small values speak for the fuller
    /// model.
    pub p_value: f64,
    /// Akaike's criterion of the fuller model minus the one of the simpler model. Negative values speak for the fuller
    /// model.
    pub aic: f64,
    /// Schwarz's Bayesian criterion, as [`aic`](Self::aic). It asks for more evidence, the more values there are.
    pub bic: f64,
}

impl Likelihood {
    /// Compares the model with a fuller one that was fitted to the same measurements, in the same windows. Of a
    /// parameter that is at a bound in the simpler model, such as dry friction of zero, the probability is at most the
    /// one given.
    ///
    /// Residuals that are [correlated](super::Warning::Correlated) hold less evidence than these figures say.
    #[must_use]
    pub fn compare(&self, fuller: &Self) -> Comparison {
        let statistic = 2.0 * (fuller.logarithm - self.logarithm);
        let degrees = fuller.unknowns.saturating_sub(self.unknowns);
        let chi_squared = ChiSquared::new(degrees as f64);
        Comparison {
            statistic,
            degrees,
            p_value: chi_squared.map_or(f64::NAN, |chi_squared| chi_squared.sf(statistic.max(0.0))),
            aic: 2.0 * degrees as f64 - statistic,
            bic: libm::log(self.values as f64) * degrees as f64 - statistic,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Likelihood;

    #[test]
    fn a_comparison_has_the_probability_of_chi_squared() {
        let of = |logarithm, unknowns| Likelihood {
            logarithm,
            unknowns,
            values: 100,
        };
        let comparison = of(10.0, 3).compare(&of(12.0, 5));
        assert_eq!((comparison.statistic, comparison.degrees), (4.0, 2));
        // with two degrees the probability is exp(-statistic/2)
        assert!((comparison.p_value - (-2_f64).exp()).abs() < 1e-12);
        assert!(comparison.aic == 0.0 && comparison.bic > 0.0);
        assert!(of(10.0, 3).compare(&of(12.0, 3)).p_value.is_nan());
    }
}

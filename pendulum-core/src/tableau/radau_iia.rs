//! The tableaus Radau IIA.

mod order13;
mod order5;
mod order9;

use super::eigenpairs::Eigenpairs;
pub(crate) use order5::TABLEAU as RADAU_IIA_5;
pub(crate) use order9::TABLEAU as RADAU_IIA_9;
pub(crate) use order13::TABLEAU as RADAU_IIA_13;

/// Coefficients of a Radau IIA method, whose last stage is the end of the step.
#[derive(Clone, Copy, Debug)]
pub struct RadauTableau<const STAGES: usize, const PAIRS: usize> {
    /// Times of the stages, in fractions of a step.
    pub(crate) c: [f64; STAGES],
    /// Stage coefficients; the last row contains the weights of the step.
    pub(crate) a: [[f64; STAGES]; STAGES],
    pub(crate) modes: Eigenpairs<STAGES, PAIRS>,
    /// Coefficients of the Lagrange polynomials without constant term, which are 1 at one of the times and 0 at the
    /// others: one row per power, one column per time.
    pub(crate) powers: [[f64; STAGES]; STAGES],
}

/// Numbers of stages, and of pairs of complex eigenvalues, with a tableau.
pub trait HasRadauTableau<const STAGES: usize, const PAIRS: usize> {
    /// Tableau.
    const TABLEAU: RadauTableau<STAGES, PAIRS>;
}

#[cfg(test)]
mod tests {
    use super::{RadauTableau, order5, order9, order13};

    /// Largest errors of the identities that hold for exact coefficients: of `a`, of the eigenvectors, and of the
    /// polynomials.
    fn worst<const STAGES: usize, const PAIRS: usize>(table: &RadauTableau<STAGES, PAIRS>) -> [f64; 3] {
        let (mut collocation, mut lagrange) = (0.0_f64, 0.0_f64);
        for (i, c) in table.c.into_iter().enumerate() {
            for k in 1..=STAGES as i32 {
                let moment: f64 = table.a[i].iter().zip(table.c).map(|(a, c)| a * c.powi(k - 1)).sum();
                collocation = collocation.max((moment - c.powi(k) / f64::from(k)).abs());
            }
            for j in 0..STAGES {
                let powers = (1..).zip(&table.powers);
                let value: f64 = powers.map(|(power, row)| row[j] * c.powi(power)).sum();
                lagrange = lagrange.max((value - f64::from(u8::from(i == j))).abs());
            }
        }
        // the weights integrate exactly up to degree 2 s - 2
        for k in 1..2 * STAGES as i32 {
            let moment: f64 = table.a[STAGES - 1]
                .iter()
                .zip(table.c)
                .map(|(a, c)| a * c.powi(k - 1))
                .sum();
            collocation = collocation.max((moment - 1.0 / f64::from(k)).abs());
        }
        [collocation, table.modes.residual(&table.a), lagrange]
    }

    #[test]
    fn the_coefficients_collocate_and_the_eigenvectors_are_theirs() {
        let within = |found: [f64; 3], most: [f64; 3]| {
            let is_within = found.iter().zip(&most).all(|(found, most)| found <= most);
            assert!(is_within, "{found:?}, and not {most:?}");
        };
        // some rounding errors of numbers up to 1, of eigenvectors, and of the coefficients of polynomials
        within(worst(&order5::TABLEAU), [3e-16, 2e-15, 2e-14]);
        within(worst(&order9::TABLEAU), [3e-16, 1e-14, 1e-12]);
        within(worst(&order13::TABLEAU), [3e-16, 1e-13, 2e-11]);
    }
}

//! Simpler models, with their costs and errors.

use std::fmt;

/// A simpler declaration, with its errors.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Simpler {
    /// Changes of the declaration, one or two: `without the friction of `arm``.
    pub changes: Vec<String>,
    /// The simpler declaration. Values of parameters in the question are its defaults; inputs stay inputs. The default
    /// of a parameter that fixes a joint is where the joint is at the first start; motions from other starts have other
    /// values. A linear model has states such as `theta_rate`, outputs such as `end_x` and the inputs that act to first
    /// order, about their values in the question; it has neither dry friction, stops nor walls.
    pub declaration: String,
    /// Errors that are predicted before the model runs, to first order in the change, in the order of
    /// [`Answer::outputs`]: the largest at 200 times, relative to the largest size of the output. Infinite if they
    /// could not be computed.
    pub predicted: Vec<f64>,
    /// Errors of its motions.
    pub observed: Vec<f64>,
    /// Costs.
    pub cost: Cost,
}

/// Cost of the motions of a model. In operations, a division counts 4, a sine with its cosine 20 and another function
/// 10, as in [`Operations::chain`](pendulum_core::cost::Operations::chain).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Cost {
    /// Operations of an evaluation of the right-hand side.
    pub operations: usize,
    /// Evaluations for a motion, on average.
    pub evaluations: f64,
    /// Operations for a motion, on average: those of the right-hand side, and of Jacobians where the motion is stiff.
    pub total: f64,
}

/// A change that leads to no model.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Refused {
    /// Changes of the declaration.
    pub changes: Vec<String>,
    /// Reason.
    pub reason: String,
}

/// Simpler models for a question.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Answer {
    /// Names of the outputs and components that were compared.
    pub outputs: Vec<String>,
    /// Largest size of each in the motions of the full model; 1 for one that stays at zero, whose errors are absolute.
    pub sizes: Vec<f64>,
    /// Largest error that was asked for.
    pub error: f64,
    /// Cost of the full model.
    pub full: Cost,
    /// Simpler models, the cheapest first.
    pub simpler: Vec<Simpler>,
    /// Changes that lead to no model.
    pub refused: Vec<Refused>,
}

impl Simpler {
    /// Largest of the errors that were observed.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.observed.iter().copied().fold(0.0, f64::max)
    }
}

impl Answer {
    /// The cheapest model that keeps within the error and costs less than the full one; `None` if the full one is the
    /// simplest.
    #[must_use]
    pub fn simplest(&self) -> Option<&Simpler> {
        let does = |simpler: &&Simpler| simpler.largest() <= self.error && simpler.cost.total < self.full.total;
        self.simpler.iter().find(does)
    }
}

/// A table: the full model, then the simpler ones by their cost, with the predicted and the observed error of each
/// output.
impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let full = ("the full model".to_owned(), self.full, String::new());
        let errors = |simpler: &Simpler| -> String {
            let pairs = simpler.predicted.iter().zip(&simpler.observed);
            pairs
                .map(|(predicted, observed)| format!("  {predicted:>8.1e} {observed:>8.1e}"))
                .collect()
        };
        let rows = self
            .simpler
            .iter()
            .map(|own| (own.changes.join(", "), own.cost, errors(own)));
        let rows: Vec<_> = std::iter::once(full).chain(rows).collect();
        let width = rows.iter().map(|(name, ..)| name.chars().count()).max().unwrap_or(0);
        write!(f, "{:width$}  operations  evaluations  operations", "")?;
        for output in &self.outputs {
            write!(f, "  {output:>17}")?;
        }
        write!(f, "\n{:width$}  of one      in a motion  in a motion", "")?;
        for _ in &self.outputs {
            write!(f, "  predicted  observed")?;
        }
        for (name, cost, errors) in &rows {
            let Cost {
                operations,
                evaluations,
                total,
            } = cost;
            write!(
                f,
                "\n{name:width$}  {operations:>10}  {evaluations:>11.0}  {total:>11.0}{errors}"
            )?;
        }
        let simplest = match self.simplest() {
            Some(simplest) => simplest.changes.join(", "),
            None => "the full model; nothing can be left out".to_owned(),
        };
        write!(f, "\nsimplest within {:e}: {simplest}", self.error)?;
        for refused in &self.refused {
            write!(f, "\nno model {}: {}", refused.changes.join(", "), refused.reason)?;
        }
        Ok(())
    }
}

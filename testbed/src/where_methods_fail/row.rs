//! A case with its claims.

use std::fmt::Display;

use pendulum_core::Reason;

/// Case in which some methods fail.
#[derive(Debug)]
pub struct Row {
    /// True if the table of the book has the first claim.
    pub in_book: bool,
    pub case: &'static str,
    pub claims: Vec<Claim>,
    /// Methods that do not fail there.
    pub survives: &'static str,
}

/// Predicted and observed value of a quantity.
#[derive(Debug)]
pub struct Claim {
    pub what: String,
    pub predicted: String,
    pub observed: String,
    /// True if the two agree as closely as required.
    pub holds: bool,
}

/// Amount of work of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Size {
    /// Seconds in unoptimised builds.
    Small,
    /// Enough to show the effect clearly.
    Full,
}

impl Size {
    /// Size for tests in the current build.
    pub const fn of_build() -> Self {
        if cfg!(debug_assertions) {
            Self::Small
        } else {
            Self::Full
        }
    }
}

impl Row {
    /// True if all claims hold.
    pub fn holds(&self) -> bool {
        self.claims.iter().all(|claim| claim.holds)
    }
}

impl Claim {
    /// Numbers whose difference must not exceed the fraction `within` of the predicted one.
    pub fn close(what: impl Into<String>, predicted: f64, observed: f64, within: f64) -> Self {
        Self {
            what: what.into(),
            predicted: number(predicted),
            observed: number(observed),
            holds: (observed - predicted).abs() <= within * predicted.abs(),
        }
    }

    /// Observed number that must not exceed `most`.
    pub fn at_most(what: impl Into<String>, most: f64, observed: f64) -> Self {
        Self {
            what: what.into(),
            predicted: format!("≤ {}", number(most)),
            observed: number(observed),
            holds: observed <= most,
        }
    }

    /// Observed number that must not be below `least`.
    pub fn at_least(what: impl Into<String>, least: f64, observed: f64) -> Self {
        Self {
            what: what.into(),
            predicted: format!("≥ {}", number(least)),
            observed: number(observed),
            holds: observed >= least,
        }
    }

    /// Numbers whose ratio must not exceed `factor`, in either direction.
    pub fn alike(what: impl Into<String>, predicted: f64, observed: f64, factor: f64) -> Self {
        Self {
            holds: (observed / predicted).ln().abs() <= factor.ln(),
            ..Self::close(what, predicted, observed, f64::NAN)
        }
    }

    /// Outcomes that must be equal.
    pub fn same(what: impl Into<String>, predicted: impl Display, observed: impl Display) -> Self {
        let (predicted, observed) = (predicted.to_string(), observed.to_string());
        Self {
            what: what.into(),
            holds: predicted == observed,
            predicted,
            observed,
        }
    }
}

/// Formats a number as an integer, or with four significant digits.
pub fn number(value: f64) -> String {
    let decades = value.abs().log10().floor();
    if value.fract() == 0.0 && value.abs() < 1e6 {
        format!("{value}")
    } else if (-3.0..6.0).contains(&decades) {
        format!("{value:.*}", (3.0 - decades).max(0.0) as usize)
    } else {
        format!("{value:.2e}")
    }
}

/// Name of a reason, without its numbers.
pub fn kind(reason: Reason) -> String {
    let kind = match reason {
        Reason::InvalidInput { .. } => "InvalidInput",
        Reason::NonFinite { .. } => "NonFinite",
        Reason::StepUnderflow { .. } => "StepUnderflow",
        Reason::NoConvergence { .. } => "NoConvergence",
        Reason::CostNotFinite => "CostNotFinite",
        Reason::EventNotFinite { .. } => "EventNotFinite",
        Reason::EventsAccumulate { .. } => "EventsAccumulate",
        Reason::TooManySteps { .. } => "TooManySteps",
        Reason::Jump { .. } => "Jump",
        _ => "another",
    };
    kind.to_owned()
}

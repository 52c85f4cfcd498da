//! A case, and what comes of it.

use std::fmt::Display;

use pendulum_core::Reason;

/// A case in which some methods fail.
#[derive(Debug)]
pub struct Row {
    pub case: &'static str,
    pub claims: Vec<Claim>,
    /// What does not fail there.
    pub survives: &'static str,
}

/// What was predicted of one quantity, and what was observed.
#[derive(Debug)]
pub struct Claim {
    pub what: String,
    pub predicted: String,
    pub observed: String,
    /// Whether the two agree as well as they should.
    pub holds: bool,
}

/// How much work a row may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Size {
    /// Seconds where nothing is optimised.
    Small,
    /// As much as makes the point.
    Full,
}

impl Size {
    /// What a test takes.
    pub const fn of_build() -> Self {
        if cfg!(debug_assertions) {
            Self::Small
        } else {
            Self::Full
        }
    }
}

impl Row {
    /// Whether all claims hold.
    pub fn holds(&self) -> bool {
        self.claims.iter().all(|claim| claim.holds)
    }
}

impl Claim {
    /// Two numbers that differ by no more than the part `within` of the predicted one.
    pub fn close(what: impl Into<String>, predicted: f64, observed: f64, within: f64) -> Self {
        Self {
            what: what.into(),
            predicted: number(predicted),
            observed: number(observed),
            holds: (observed - predicted).abs() <= within * predicted.abs(),
        }
    }

    /// An observed number that is no larger than `most`.
    pub fn at_most(what: impl Into<String>, most: f64, observed: f64) -> Self {
        Self {
            what: what.into(),
            predicted: format!("≤ {}", number(most)),
            observed: number(observed),
            holds: observed <= most,
        }
    }

    /// An observed number that is no smaller than `least`.
    pub fn at_least(what: impl Into<String>, least: f64, observed: f64) -> Self {
        Self {
            what: what.into(),
            predicted: format!("≥ {}", number(least)),
            observed: number(observed),
            holds: observed >= least,
        }
    }

    /// Two numbers of which neither is more than `factor` times the other.
    pub fn alike(what: impl Into<String>, predicted: f64, observed: f64, factor: f64) -> Self {
        Self {
            holds: (observed / predicted).ln().abs() <= factor.ln(),
            ..Self::close(what, predicted, observed, f64::NAN)
        }
    }

    /// Outcomes that are the same.
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

/// Four significant digits, or an integer.
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

/// The kind of a reason, without its numbers.
pub fn kind(reason: Reason) -> String {
    let kind = match reason {
        Reason::InvalidInput { .. } => "InvalidInput",
        Reason::NonFinite { .. } => "NonFinite",
        Reason::StepUnderflow { .. } => "StepUnderflow",
        Reason::NoConvergence { .. } => "NoConvergence",
        Reason::EventNotFinite { .. } => "EventNotFinite",
        Reason::EventsAccumulate { .. } => "EventsAccumulate",
        Reason::TooManySteps { .. } => "TooManySteps",
        _ => "another",
    };
    kind.to_owned()
}

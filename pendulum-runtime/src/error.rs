//! Errors. Each message states the fact and a remedy.

use std::fmt;

#[cfg(feature = "full")]
use pendulum_core::accuracy::TuneError;
#[cfg(feature = "full")]
use pendulum_core::fit::FitError;
use pendulum_core::stability::StabilityError;
use pendulum_core::tape::ModelError;
use pendulum_core::{NotAssembled, OutsideSpan, Reason, SampleError};

use crate::declaration::DeclarationError;

/// Reason why there is no result.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// The declaration is wrong.
    Declaration(DeclarationError),
    /// There is no such name.
    Unknown {
        /// Kind of the thing: `parameter`, `method` and so on.
        what: &'static str,
        /// The name.
        name: String,
        /// Known names, the most similar first.
        known: Vec<String>,
    },
    /// A list has the wrong length.
    Length {
        /// The list.
        what: String,
        /// Its length.
        given: usize,
        /// The right length.
        needed: usize,
    },
    /// The state, or the list of parameters, is too long for this crate.
    TooLong {
        /// The list.
        what: &'static str,
        /// Its length.
        length: usize,
        /// Maximum length.
        most: usize,
    },
    /// These parameters have no default, and no value is given.
    NoValue {
        /// Their names.
        parameters: Vec<String>,
    },
    /// The declaration does not ask for a function.
    NotGenerated {
        /// Name of the task that needs the function.
        what: String,
        /// Word of `generate` that asks for it.
        word: &'static str,
    },
    /// A setting is invalid.
    Setting {
        /// The setting.
        what: String,
        /// Rule that its values keep.
        rule: String,
    },
    /// The parameters are impossible.
    Model(ModelError),
    /// An integration could not start.
    Integration(Reason),
    /// The loops of the mechanism do not close.
    NotAssembled(NotAssembled),
    /// A time lies outside of the motion.
    OutsideSpan(OutsideSpan),
    /// Stability could not be determined.
    Stability(StabilityError),
    /// Measured values are invalid.
    Sample(SampleError),
    /// A fit could not begin.
    #[cfg(feature = "full")]
    Fit(FitError),
    /// No method keeps within an error.
    #[cfg(feature = "full")]
    Tune(TuneError),
}

impl Error {
    /// An unknown name among these.
    pub(crate) fn unknown<'n>(what: &'static str, name: &str, known: impl IntoIterator<Item = &'n str>) -> Self {
        let lower = name.to_lowercase();
        let mut known: Vec<String> = known.into_iter().map(str::to_owned).collect();
        known.sort_by_cached_key(|own| strsim::damerau_levenshtein(&own.to_lowercase(), &lower));
        let name = name.to_owned();
        Self::Unknown { what, name, known }
    }

    /// Index of a name among known ones, or an error that names the most similar one.
    pub(crate) fn index_of<'n>(
        what: &'static str,
        name: &str,
        known: impl Iterator<Item = &'n str> + Clone,
    ) -> Result<usize, Self> {
        let found = known.clone().position(|own| own == name);
        found.ok_or_else(|| Self::unknown(what, name, known))
    }

    /// Checks the length of a list.
    pub(crate) fn check_length(what: &str, given: usize, needed: usize) -> Result<(), Self> {
        let what = what.to_owned();
        (given == needed)
            .then_some(())
            .ok_or(Self::Length { what, given, needed })
    }

    /// An invalid setting.
    pub(crate) fn setting(what: &str, rule: impl Into<String>) -> Self {
        let (what, rule) = (what.to_owned(), rule.into());
        Self::Setting { what, rule }
    }

    /// The message in one line.
    #[cfg(feature = "full")]
    pub(crate) fn in_one_line(&self) -> String {
        match self {
            Self::Declaration(wrong) => format!("{} [{}]", wrong.problems[0].message, wrong.problems[0].code),
            _ => self.to_string(),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Declaration(error) => error.fmt(f),
            Self::Unknown { what, name, known } if known.is_empty() => {
                write!(f, "there is no {what} `{name}`: the mechanism has none")
            }
            Self::Unknown { what, name, known } => {
                write!(f, "there is no {what} `{name}`")?;
                if strsim::damerau_levenshtein(&name.to_lowercase(), &known[0].to_lowercase()) <= 1 + name.len() / 3 {
                    write!(f, "; did you mean `{}`?", known[0])?;
                }
                write!(f, " [known: {}]", known.join(", "))?;
                match *what {
                    "function" => f.write_str("; there are those that `generate: [..]` in the declaration asks for"),
                    _ => Ok(()),
                }
            }
            Self::Length { what, given, needed } => write!(f, "{what} has {given} entries, and {needed} are needed"),
            Self::TooLong { what, length, most } => {
                write!(f, "{what} has {length} entries, and at most {most} are supported; ")?;
                f.write_str("declare less, or compile the declaration as `mechanism!`, which has no limit")
            }
            Self::NoValue { parameters } => {
                let names = parameters.join("`, `");
                write!(f, "give values of `{names}`, which have no defaults in the declaration")
            }
            Self::NotGenerated { what, word } => {
                write!(
                    f,
                    "{what} needs `{word}`: add it to `generate: [..]` in the declaration"
                )
            }
            Self::Setting { what, rule } => write!(f, "{what}: {rule}"),
            Self::Model(error) => error.fmt(f),
            Self::Integration(reason) => reason.fmt(f),
            Self::NotAssembled(error) => error.fmt(f),
            Self::OutsideSpan(error) => error.fmt(f),
            Self::Stability(error) => error.fmt(f),
            Self::Sample(error) => error.fmt(f),
            #[cfg(feature = "full")]
            Self::Fit(error) => error.fmt(f),
            #[cfg(feature = "full")]
            Self::Tune(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for Error {}

/// Conversions of the errors of other parts.
macro_rules! from {
    ($($(#[$if:meta])? $error:ident => $variant:ident)*) => { $(
        $(#[$if])?
        impl From<$error> for Error {
            fn from(error: $error) -> Self {
                Self::$variant(error)
            }
        }
    )* };
}

from! {
    DeclarationError => Declaration
    ModelError => Model
    Reason => Integration
    NotAssembled => NotAssembled
    OutsideSpan => OutsideSpan
    StabilityError => Stability
    SampleError => Sample
    #[cfg(feature = "full")]
    FitError => Fit
    #[cfg(feature = "full")]
    TuneError => Tune
}

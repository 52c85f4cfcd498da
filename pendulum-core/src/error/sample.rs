//! The error of samples that cannot be a function of time.

use std::error::Error;

use super::{debug_as_display, messages};

/// Samples that are not a function of time.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum SampleError {
    /// There are fewer samples than needed.
    TooFew {
        /// Number of samples.
        given: usize,
        /// Minimum number of samples.
        least: usize,
    },
    /// A list has another number of entries than there are times.
    Length {
        /// Name of the list.
        name: String,
        /// Number of its entries.
        given: usize,
        /// Number of times.
        times: usize,
    },
    /// A time is infinite or NaN.
    Time {
        /// Index of the time.
        index: usize,
        /// The time.
        t: f64,
    },
    /// A time does not come after the time before it.
    Order {
        /// Index of the time.
        index: usize,
        /// The time before it, and the time.
        t: [f64; 2],
    },
    /// A value is infinite or NaN.
    Value {
        /// Name of the list.
        name: String,
        /// Index of the value.
        index: usize,
        /// The value.
        value: f64,
    },
    /// A standard deviation is not positive.
    Noise {
        /// Name of the list.
        name: String,
        /// The standard deviation.
        deviation: f64,
    },
}

impl SampleError {
    /// Checks that there are enough times, that they are finite, and that they ascend.
    pub(crate) fn check_times(times: &[f64], least: usize) -> Result<(), Self> {
        if let Some((index, &t)) = times.iter().enumerate().find(|(_, t)| !t.is_finite()) {
            return Err(Self::Time { index, t });
        }
        if let Some(n) = times.windows(2).position(|pair| pair[0] >= pair[1]) {
            return Err(Self::Order {
                index: n + 1,
                t: [times[n], times[n + 1]],
            });
        }
        if times.len() < least {
            return Err(Self::TooFew {
                given: times.len(),
                least,
            });
        }
        Ok(())
    }

    /// Checks the number of values.
    pub(crate) fn check_length(name: &str, given: usize, times: usize) -> Result<(), Self> {
        if given == times {
            return Ok(());
        }
        Err(Self::Length {
            name: name.to_owned(),
            given,
            times,
        })
    }
}

debug_as_display! { [] SampleError; }

messages! {
    [] SampleError;
    Self::TooFew { given, least } => "there are {given} samples: at least {least} are needed";
    Self::Length { name, given, times } => "`{name}` has {given} values for {times} times: give one for each time";
    Self::Time { index, t } => "the time of sample {index} is {t}: remove the sample";
    Self::Order { index, t: [before, t] } =>
        "the times of samples {first} and {index} are {before} and {t}: times must ascend; sort the samples, and \
         remove those of equal time",
        first = index - 1;
    Self::Value { name, index, value } => "sample {index} of `{name}` is {value}: values must be finite";
    Self::Noise { name, deviation } =>
        "the standard deviation of the noise of `{name}` is {deviation}: it must be positive and finite";
}

impl Error for SampleError {}

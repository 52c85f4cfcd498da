//! Measured outputs.

use crate::error::SampleError;

/// Outputs of a scene, measured at ascending times.
///
/// A column has the name of an output of the scene, or of a component of its state, such as `theta` or `dot(theta)`:
/// the names in `Name::OUTPUTS` and of `Name::LAYOUT.components()`. Values that are NaN are missing. Offsets and scales
/// of sensors are parameters of the scene, in its outputs: `output encoder: gain*theta + offset`.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    pub(super) times: Vec<f64>,
    pub(super) columns: Vec<Column>,
}

/// A measured output.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Column {
    pub(super) name: String,
    /// NaN where missing.
    pub(super) values: Vec<f64>,
    /// Standard deviation of the noise; `None` if it is to be estimated.
    pub(super) noise: Option<f64>,
}

impl Measurement {
    /// A measurement at these times, without outputs yet.
    ///
    /// # Errors
    /// If a time is not finite, or the times do not ascend.
    pub fn new(times: &[f64]) -> Result<Self, SampleError> {
        SampleError::check_times(times, 1)?;
        Ok(Self {
            times: times.to_vec(),
            columns: Vec::new(),
        })
    }

    /// Adds the values of an output, with noise of unknown standard deviation, which the fit estimates.
    ///
    /// # Errors
    /// If there are more or fewer values than times, or if one is infinite.
    pub fn output(self, name: &str, values: &[f64]) -> Result<Self, SampleError> {
        self.column(name, values, None)
    }

    /// Adds the values of an output, with noise of a known standard deviation, in the unit of the output. The weight of
    /// a value is the inverse of the square of this deviation.
    ///
    /// # Errors
    /// Errors of [`output`](Self::output), and if the deviation is not positive.
    pub fn output_with_noise(self, name: &str, values: &[f64], deviation: f64) -> Result<Self, SampleError> {
        if !(deviation > 0.0 && deviation.is_finite()) {
            return Err(SampleError::Noise {
                name: name.to_owned(),
                deviation,
            });
        }
        self.column(name, values, Some(deviation))
    }

    fn column(mut self, name: &str, values: &[f64], noise: Option<f64>) -> Result<Self, SampleError> {
        SampleError::check_length(name, values.len(), self.times.len())?;
        if let Some((index, &value)) = values.iter().enumerate().find(|(_, value)| value.is_infinite()) {
            let name = name.to_owned();
            return Err(SampleError::Value { name, index, value });
        }
        self.columns.push(Column {
            name: name.to_owned(),
            values: values.to_vec(),
            noise,
        });
        Ok(self)
    }

    /// The samples from the time `from` to the time `to`, both included: to fit one part, and predict another.
    #[must_use]
    pub fn between(&self, from: f64, to: f64) -> Self {
        let first = self.times.partition_point(|&t| t < from);
        let end = self.times.partition_point(|&t| t <= to).max(first);
        let columns = self.columns.iter().map(|column| Column {
            name: column.name.clone(),
            values: column.values[first..end].to_vec(),
            noise: column.noise,
        });
        Self {
            times: self.times[first..end].to_vec(),
            columns: columns.collect(),
        }
    }

    /// Every `step`-th sample, the first one included. Samples farther apart than the correlation of the residuals give
    /// [honest](super::Warning::Correlated) deviations and likelihoods.
    ///
    /// # Panics
    /// If `step` is zero.
    #[must_use]
    pub fn every(&self, step: usize) -> Self {
        let columns = self.columns.iter().map(|column| Column {
            name: column.name.clone(),
            values: column.values.iter().copied().step_by(step).collect(),
            noise: column.noise,
        });
        Self {
            times: self.times.iter().copied().step_by(step).collect(),
            columns: columns.collect(),
        }
    }

    /// Times of the samples.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Names of the measured outputs.
    pub fn names(&self) -> impl ExactSizeIterator<Item = &str> {
        self.columns.iter().map(|column| column.name.as_str())
    }

    /// Values of the measured outputs, in the order of [`names`](Self::names); NaN where missing.
    pub fn values(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.columns.iter().map(|column| column.values.as_slice())
    }
}

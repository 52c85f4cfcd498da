//! Errors of simpler models: predicted, and observed.

use nalgebra::DVector;
use pendulum_core::Reason;

use super::candidate::Candidate;
use super::{Cost, Question};
use crate::error::Error;
use crate::method::Method;
use crate::model::Model;
use crate::motion::{Motion, Stopped};
use crate::solve::Options;
use crate::worker::Cancel;

/// Number of intervals between the samples of a motion.
const INTERVALS: usize = 200;
/// Number of intervals over which an error spreads as at their beginning.
const TOGETHER: usize = 4;

/// Absolute tolerance over the relative one, unless the largest component of all states is smaller, which takes its
/// place.
const ABSOLUTE: f64 = 1e-3;
/// Fraction of the assumed size below which motions from rest are integrated again, with their own size.
const MUCH_SMALLER: f64 = 0.1;
/// Smallest size that counts: others are rounding errors.
const LEAST: f64 = 1e-200;

/// Motions of the full model.
pub(super) struct Full {
    pub(super) cost: Cost,
    /// Largest size of each output that is compared.
    pub(super) sizes: Vec<f64>,
    times: Vec<f64>,
    motions: Vec<Samples>,
    tolerance: f64,
    /// Absolute tolerance over the relative one.
    absolute: f64,
    is_stiff: bool,
}

/// States of a motion at the samples, and what is compared.
struct Samples {
    states: Vec<Vec<f64>>,
    outputs: Vec<Vec<f64>>,
}

impl Full {
    /// Integrates from each start. The outputs of these numbers are compared.
    pub(super) fn new(
        model: &Model,
        question: &Question,
        compared: &[usize],
        cancel: &Cancel<'_>,
    ) -> Result<Self, Error> {
        let size_of = |states: &[Vec<f64>]| states.iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
        let mut absolute = match size_of(&question.starts) {
            0.0 => ABSOLUTE,
            size => size.min(ABSOLUTE),
        };
        loop {
            let full = Self::within(absolute, (model, question, compared), cancel)?;
            let sizes = full.motions.iter().map(|motion| size_of(&motion.states));
            let size = sizes.fold(0.0, f64::max);
            if size < LEAST || size >= MUCH_SMALLER * absolute {
                return Ok(full);
            }
            absolute = size;
        }
    }

    /// Integrates with this absolute tolerance over the relative one.
    fn within(
        absolute: f64,
        (model, question, compared): (&Model, &Question, &[usize]),
        cancel: &Cancel<'_>,
    ) -> Result<Self, Error> {
        let times = (0..=INTERVALS).map(|n| question.horizon * (n as f64 / INTERVALS as f64));
        let mut full = Self {
            cost: Cost::new(model),
            sizes: vec![0.0; compared.len()],
            times: times.collect(),
            motions: Vec::new(),
            tolerance: 1e-3 * question.error,
            absolute,
            is_stiff: false,
        };
        for start in &question.starts {
            let motion = full
                .solve(model, start, cancel)
                .map_err(|stopped| Error::setting("the motion of the full model by `Auto`", stopped.to_string()))?;
            full.cost.add(model, &motion, question.starts.len());
            full.is_stiff |= motion.statistics().jacobians > 0;
            let samples = Samples::new(model, &motion, compared)?;
            for (size, n) in full.sizes.iter_mut().zip(0..) {
                *size = samples
                    .outputs
                    .iter()
                    .map(|outputs| outputs[n].abs())
                    .fold(*size, f64::max);
            }
            full.motions.push(samples);
        }
        // an output that stays at zero, up to the tolerance, has absolute errors, in the units of the motion's size
        let noise = full.absolute * full.tolerance;
        full.sizes
            .iter_mut()
            .filter(|size| **size <= noise)
            .for_each(|size| *size = absolute / ABSOLUTE);
        Ok(full)
    }

    /// A method with the tolerances of the motions.
    fn method(&self, name: &str) -> Result<Method, Error> {
        let method = Method::new(name)?;
        Ok(method.rtol(self.tolerance).atol(self.absolute * self.tolerance))
    }

    fn solve(&self, model: &Model, start: &[f64], cancel: &Cancel<'_>) -> Result<Motion, Stopped> {
        let method = self.method("Auto")?;
        let options = Options {
            times: Some(self.times.clone()),
            cancel: Some(cancel),
            ..Options::default()
        };
        let motion = model.solve_with(&method, [0.0, self.times[INTERVALS]], start, &options)?;
        match motion.t().len() > INTERVALS {
            true => Ok(motion),
            false => Err(Reason::Cancelled.into()),
        }
    }

    /// Largest errors of a simpler model to first order in the change, without its motions: with `y` the part of the
    /// full state that it has and `F` its flow over an interval, `e' = F(y) - y' + DF(y) e`.
    pub(super) fn predicted(
        &self,
        simpler: &Candidate,
        question: &Question,
        cancel: &Cancel<'_>,
    ) -> Result<Vec<f64>, Error> {
        let method = self.method(if self.is_stiff { "Rodas5P" } else { "Vern9" })?;
        let mut largest = vec![0.0; self.sizes.len()];
        for (full, start) in self.motions.iter().zip(&question.starts) {
            let model = simpler.at(start)?;
            let components: Vec<&str> = model.components().iter().map(|own| own.name.as_str()).collect();
            let mut error = DVector::zeros(components.len());
            for first in (0..INTERVALS).step_by(TOGETHER) {
                let last = (first + TOGETHER).min(INTERVALS);
                let begin = simpler.part_of(&full.states[first]);
                let flow = model.sensitivity_unless(&method, &self.times[first..=last], &begin, &components, cancel)?;
                let mut next = error.clone();
                for n in first + 1..=last {
                    let y = DVector::from_vec(simpler.part_of(&full.states[n]));
                    let defect = DVector::from_column_slice(&flow.x[n - first]) - &y;
                    next = &flow.derivatives[n - first] * &error + defect;
                    let outputs = chosen(&model, self.times[n], (y + &next).as_slice(), &simpler.compared)?;
                    self.compare(&outputs, &full.outputs[n], &mut largest);
                }
                error = next;
            }
        }
        Ok(largest)
    }

    /// Largest errors of the motions of a simpler model, and their cost.
    pub(super) fn observed(
        &self,
        simpler: &Candidate,
        question: &Question,
        cancel: &Cancel<'_>,
    ) -> Result<(Vec<f64>, Cost), Stopped> {
        let mut largest = vec![0.0; self.sizes.len()];
        let mut cost = Cost::new(&simpler.model);
        for (full, start) in self.motions.iter().zip(&question.starts) {
            let model = simpler.at(start)?;
            let motion = self.solve(&model, &simpler.part_of(start), cancel)?;
            cost.add(&model, &motion, question.starts.len());
            let own = Samples::new(&model, &motion, &simpler.compared)?;
            for (own, full) in own.outputs.iter().zip(&full.outputs) {
                self.compare(own, full, &mut largest);
            }
        }
        Ok((largest, cost))
    }

    /// Raises the largest errors to those of a sample.
    fn compare(&self, own: &[f64], full: &[f64], largest: &mut [f64]) {
        for (n, largest) in largest.iter_mut().enumerate() {
            let error = (own[n] - full[n]).abs() / self.sizes[n];
            // `max` would ignore NaN
            *largest = largest.max(if error.is_nan() { f64::INFINITY } else { error });
        }
    }
}

impl Samples {
    fn new(model: &Model, motion: &Motion, compared: &[usize]) -> Result<Self, Error> {
        let states: Vec<Vec<f64>> = (0..motion.t().len()).map(|n| motion.state(n).to_vec()).collect();
        let outputs = states
            .iter()
            .zip(motion.t())
            .map(|(x, &t)| chosen(model, t, x, compared));
        Ok(Self {
            outputs: outputs.collect::<Result<_, _>>()?,
            states,
        })
    }
}

/// Outputs of these numbers.
fn chosen(model: &Model, t: f64, x: &[f64], compared: &[usize]) -> Result<Vec<f64>, Error> {
    let all = model.outputs_at(t, x)?;
    Ok(compared.iter().map(|&n| all[n]).collect())
}

/// Operations of a function of a model, with the weights of [`Cost`].
fn operations(model: &Model, name: &str) -> usize {
    let function = model.functions().iter().find(|function| function.name == name);
    let weights = [1, 1, 4, 20, 10];
    function.map_or(0, |function| {
        function
            .operations
            .iter()
            .zip(weights)
            .map(|(count, weight)| count * weight)
            .sum()
    })
}

impl Cost {
    /// Cost of a model before its first motion.
    fn new(model: &Model) -> Self {
        Self {
            operations: operations(model, "rhs"),
            evaluations: 0.0,
            total: 0.0,
        }
    }

    /// Adds one of as many motions to the average.
    fn add(&mut self, model: &Model, motion: &Motion, motions: usize) {
        let statistics = motion.statistics();
        let of_rhs = self.operations * statistics.evaluations;
        let of_jacobians = operations(model, "jacobian") * statistics.jacobians;
        self.evaluations += statistics.evaluations as f64 / motions as f64;
        self.total += (of_rhs + of_jacobians) as f64 / motions as f64;
    }
}

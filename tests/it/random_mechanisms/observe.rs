//! Outputs and events against the oracle.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use super::compare::{By, Comparison, largest};
use super::evaluate::Evaluator;

/// Expected values of all outputs, component by component.
struct Observed {
    values: Vec<f64>,
    rates: Vec<f64>,
    /// Magnitude of the terms of the rates, and their change if accelerations are rounded.
    of_rates: Vec<f64>,
    /// Derivatives with respect to each component of the state.
    by_state: Vec<Vec<f64>>,
}

impl Comparison<'_> {
    pub(super) fn observed(&self, program: &Evaluator<'_>, note: &mut impl FnMut(&'static str, f64)) {
        let (t, q, qd) = (self.place.t, self.q(), self.qd());
        for (n, theirs) in self.oracle.events(t, q, qd).into_iter().enumerate() {
            let ours = program.routine(&format!("e{n}"), self.place).expect("an event");
            note("event", error(&ours[0], &[theirs], &[0.0]));
        }
        let outputs = self.oracle.outputs(t, q, qd);
        if outputs.is_empty() {
            return;
        }
        let right = self.right(outputs.concat());
        let mut compare = |names: [&str; 3], range: Range<usize>| {
            let zeros = vec![0.0; range.len()];
            let [own, rate, both] = names.map(|name| program.routine(name, self.place).expect("an output"));
            let (values, rates) = (&right.values[range.clone()], &right.rates[range.clone()]);
            note(
                "output",
                error(&own[0], values, &zeros).max(error(&both[0], values, &zeros)),
            );
            note("output_rate", error(&rate[0], rates, &right.of_rates[range.clone()]));
            let columns = both[1].chunks(range.len()).zip(&right.by_state);
            let columns = columns.map(|(ours, theirs)| error(ours, &theirs[range.clone()], &zeros));
            note("output_jacobian", largest(columns));
        };
        let mut first = 0;
        for (n, output) in outputs.iter().enumerate() {
            let names = ["", "_rate", "_and_jacobian"].map(|end| format!("o{n}{end}"));
            compare(names.each_ref().map(String::as_str), first..first + output.len());
            first += output.len();
        }
        compare(["outputs", "output_rates", "outputs_and_jacobian"], 0..first);
    }

    /// Expected results for outputs with these values.
    fn right(&self, values: Vec<f64>) -> Observed {
        let (t, n, q, qd) = (self.place.t, self.n, self.q(), self.qd());
        let slopes = |by: By| -> Vec<f64> {
            let (oracle, time, state) = self.seeded(by);
            let outputs = oracle.outputs(time, &state[..n], &state[n..]);
            outputs.into_iter().flatten().map(|value| value.slope).collect()
        };
        let by_state: Vec<Vec<f64>> = (0..2 * n).map(|j| slopes(By::State(j))).collect();
        let by_time = slopes(By::Time);
        let qdd = self.oracle.accelerations(t, q, qd);
        let (along, rounded) = ([qd, &qdd].concat(), self.rounding(&qdd));
        let sum = |i: usize| by_time[i] + (0..2 * n).map(|j| by_state[j][i] * along[j]).sum::<f64>();
        let size = |i: usize| {
            let terms = (0..2 * n).map(|j| (by_state[j][i] * along[j]).abs()).sum::<f64>();
            terms + (0..n).map(|k| by_state[n + k][i].abs() * rounded[k]).sum::<f64>()
        };
        Observed {
            rates: (0..values.len()).map(sum).collect(),
            of_rates: (0..values.len()).map(size).collect(),
            by_state,
            values,
        }
    }

    /// Change of the accelerations if their forces change by their own magnitude. Times the unit roundoff, this is the
    /// attainable accuracy of the accelerations.
    fn rounding(&self, qdd: &[f64]) -> Vec<f64> {
        let matrix = DMatrix::from_fn(self.n, self.n, |i, j| self.mass_matrix[i][j]);
        let inverse = matrix.try_inverse().expect("a regular mass matrix").abs();
        let forces = self
            .spread(qdd)
            .into_iter()
            .zip(&self.size)
            .map(|(spread, size)| spread + size);
        let forces = DVector::from_iterator(self.n, forces);
        (inverse * forces).iter().copied().collect()
    }
}

/// Largest error, relative to the component, to 1, and to the further terms `more` of its sum.
fn error(ours: &[f64], theirs: &[f64], more: &[f64]) -> f64 {
    assert_eq!(ours.len(), theirs.len(), "all components");
    let rows = ours.iter().zip(theirs).zip(more);
    largest(rows.map(|((ours, theirs), more)| (ours - theirs).abs() / (1.0 + theirs.abs() + more)))
}

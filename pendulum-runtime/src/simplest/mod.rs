//! The simplest model that answers a question.

mod answer;
mod candidate;
mod change;
mod errors;
mod linear;
mod outline;

use rayon::prelude::*;

use crate::declaration::Declaration;
use crate::error::Error;
use crate::model::Model;
use crate::worker;
pub use answer::{Answer, Cost, Refused, Simpler};
use candidate::{Candidate, Origin};
use errors::Full;

/// Smallest error that can be asked for: reference motions keep a thousandth of it.
const LEAST: f64 = 1e-9;

/// What a model is needed for.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// Initial states, at the time 0, with the components of the model; at least one.
    pub starts: Vec<Vec<f64>>,
    /// Time up to which motions are followed, in s.
    pub horizon: f64,
    /// Outputs and components of the state that matter, by name; all outputs if empty, or all components if there are
    /// no outputs.
    pub outputs: Vec<String>,
    /// Largest error of each of them at any time, relative to its largest size in all motions.
    pub error: f64,
    /// Values of parameters; the others have their defaults.
    pub values: Vec<(String, f64)>,
    /// Values of inputs; the others are zero.
    pub inputs: Vec<(String, f64)>,
}

impl Default for Question {
    /// An error of 1 % within 10 s, without starts.
    fn default() -> Self {
        Self {
            starts: Vec::new(),
            horizon: 10.0,
            outputs: Vec::new(),
            error: 0.01,
            values: Vec::new(),
            inputs: Vec::new(),
        }
    }
}

/// Finds the simplest declaration that answers a question. Tries a linear model about the equilibrium nearest to each start,
/// the removal of each friction, each joint fixed where it starts, each spring of a joint rigid, and all pairs of these.
///
/// The error of each is predicted before it runs: with `y` the part of the full motion that the simpler model has, and
/// `F` its flow from one sample to the next, `e' = F(y) - y' + DF(y) e`, which is exact to first order in the change.
/// Then it runs, by `Auto` with a thousandth of the error as tolerance.
///
/// What a file of a robot declares is left as it is, and so are balls and free joints.
///
/// ```
/// use pendulum_runtime::{Declaration, Question, simplest};
///
/// let declaration = Declaration::new("pub Pendulum {
///     gravity: [0, -9.81, 0],
///     body bob on ground {
///         mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta, friction: 1e-4,
///     }
/// }");
/// let question = Question { starts: vec![vec![0.02, 0.0]], horizon: 5.0, ..Question::default() };
/// let answer = simplest(&declaration, &question)?;
/// let simplest = answer.simplest().expect("small motion is linear");
/// assert_eq!(simplest.changes, ["linear about theta = 0"]);
/// // a pendulum loses A^2/16 of each radian of its phase
/// let expected = 0.02_f64.powi(2) / 16.0 * 9.81_f64.sqrt() * 5.0;
/// assert!((simplest.predicted[0] - expected).abs() < 0.2 * expected);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the declaration or the question is invalid, or if the full model cannot be integrated.
pub fn simplest(declaration: &Declaration, question: &Question) -> Result<Answer, Error> {
    simplest_unless(declaration, question, &|| false)
}

/// Like [`simplest`], unless `cancel` becomes true: models that were not compared until then are refused.
///
/// # Errors
/// See [`simplest`].
pub fn simplest_unless(
    declaration: &Declaration,
    question: &Question,
    cancel: &(dyn Fn() -> bool + Sync),
) -> Result<Answer, Error> {
    question.check()?;
    let plain = question.model(declaration.clone(), &|_| true)?;
    let outputs = question.outputs(&plain)?;
    let origin = Origin::new(declaration, question, &plain, &outputs)?;
    let full = Full::new(&origin.model, question, &origin.compared, cancel)?;

    let singles = origin.changes();
    // no change: the linear models of the declaration itself
    let mut all = vec![Vec::new()];
    for (n, first) in singles.iter().enumerate() {
        all.push(vec![first.clone()]);
        let others = singles[n + 1..].iter();
        let pairs = others.filter(|other| !first.covers(other) && !other.covers(first));
        all.extend(pairs.map(|other| vec![first.clone(), other.clone()]));
    }
    let compared = |candidate: Candidate| -> Result<Simpler, Refused> {
        let refused = |reason: String| Refused {
            changes: candidate.changes.clone(),
            reason,
        };
        if cancel() {
            return Err(refused("it was not tried before the search was cancelled".to_owned()));
        }
        let predicted = full.predicted(&candidate, question, cancel);
        let observed = full.observed(&candidate, question, cancel);
        let (observed, cost) = observed.map_err(|stopped| refused(format!("by `Auto`, {stopped}")))?;
        Ok(Simpler {
            predicted: predicted.unwrap_or_else(|_| vec![f64::INFINITY; observed.len()]),
            changes: candidate.changes,
            declaration: candidate.text,
            observed,
            cost,
        })
    };
    let tried: Vec<Result<Simpler, Refused>> = worker::on_all(|| {
        let candidates = all.into_par_iter().flat_map_iter(|changes| origin.candidates(&changes));
        candidates.map(|candidate| candidate.and_then(compared)).collect()
    });
    let (mut simpler, mut refused) = (Vec::new(), Vec::new());
    for one in tried {
        match one {
            Ok(one) => simpler.push(one),
            Err(one) => refused.push(one),
        }
    }
    simpler.sort_by(|a: &Simpler, b| a.cost.total.total_cmp(&b.cost.total));
    Ok(Answer {
        outputs,
        sizes: full.sizes,
        error: question.error,
        full: full.cost,
        simpler,
        refused,
    })
}

impl Question {
    fn check(&self) -> Result<(), Error> {
        let wrong = |what: &str, rule: String| {
            let what = what.to_owned();
            Err(Error::Setting { what, rule })
        };
        if self.starts.is_empty() {
            return wrong(
                "starts",
                "give at least one initial state, such as `model.state(&[..])`".to_owned(),
            );
        }
        if !(self.horizon > 0.0 && self.horizon.is_finite()) {
            return wrong("horizon", format!("a time after 0 is needed, not {:?}", self.horizon));
        }
        if !(LEAST..1.0).contains(&self.error) {
            let rule = format!(
                "{:?} is not between {LEAST:?} and 1: reference motions in double precision allow no smaller one",
                self.error
            );
            return wrong("error", rule);
        }
        Ok(())
    }

    /// The model of a declaration, with the values of parameters and inputs.
    /// Those that are not there are left out.
    fn model(&self, declaration: Declaration, is_there: &dyn Fn(&str) -> bool) -> Result<Model, Error> {
        fn of<'a>(all: &'a [(String, f64)], is_there: &dyn Fn(&str) -> bool) -> Vec<(&'a str, f64)> {
            let there = all.iter().filter(|(name, _)| is_there(name));
            there.map(|(name, value)| (name.as_str(), *value)).collect()
        }
        let model = Model::declared(&declaration.also(["jacobian"]), &of(&self.values, is_there))?;
        model.with_inputs(&of(&self.inputs, is_there))
    }

    /// Names of what is compared.
    fn outputs(&self, model: &Model) -> Result<Vec<String>, Error> {
        self.starts.iter().try_for_each(|start| model.check_state(start))?;
        let components = || model.components().iter().map(|own| own.name.as_str());
        let declared = || model.outputs().iter().copied();
        let all: Vec<String> = match model.outputs().is_empty() {
            true => components().map(str::to_owned).collect(),
            false => declared().map(str::to_owned).collect(),
        };
        if self.outputs.is_empty() {
            return Ok(all);
        }
        for name in &self.outputs {
            let mut known = declared().chain(components());
            if !known.any(|own| own == name) {
                return Err(Error::unknown(
                    "output or component",
                    name,
                    declared().chain(components()),
                ));
            }
        }
        Ok(self.outputs.clone())
    }
}

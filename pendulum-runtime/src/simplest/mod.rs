//! The simplest model that answers a question.

mod answer;
mod candidate;
mod change;
mod errors;
mod linear;
mod outline;

use std::collections::BTreeSet;

use pendulum_core::inputs::TimeTable;
use rayon::prelude::*;

use crate::declaration::Declaration;
use crate::error::Error;
use crate::model::Model;
use crate::worker;
pub use answer::{Answer, Cost, Refused, Simpler};
use candidate::{Candidate, Origin};
use change::Change;
use errors::Full;
use outline::Outline;

/// Smallest error that can be asked for: reference motions keep a thousandth of it.
const LEAST: f64 = 1e-9;

/// Purpose of a model: the motions and outputs that matter, and the largest error.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// Initial states, at the time 0, with the components of the model; at least one.
    pub starts: Vec<Vec<f64>>,
    /// Time up to which motions are followed, in s.
    pub horizon: f64,
    /// Outputs and components of the state that matter, by name, such as `tip.y`, or `tip` for all components of a
    /// point; all outputs if empty, or all components if there are no outputs.
    pub outputs: Vec<String>,
    /// Largest error of each of them, at 200 times between 0 and the horizon, relative to its largest size in all
    /// motions.
    pub error: f64,
    /// Values of parameters; the others have their defaults.
    pub values: Vec<(String, f64)>,
    /// Values of inputs; the others are zero.
    pub inputs: Vec<(String, f64)>,
    /// Inputs that follow samples; linear models are about their values in `inputs`.
    pub laws: Vec<(String, TimeTable<1>)>,
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
            laws: Vec::new(),
        }
    }
}

/// Finds the simplest declaration that answers a question. Tries a linear model about the equilibrium nearest to each
/// start, the removal of each friction, each joint fixed where it starts, each spring of a joint rigid, and all pairs
/// of these.
///
/// The error of each is predicted before it runs, to first order in the change: with `y` the part of the full motion
/// that the simpler model has, and `F` its flow from one sample to the next, `e' = F(y) - y' + DF(y) e`. Near impacts
/// and mode switches that move in time, this is rough. Then it runs, by `Auto` with a thousandth of the error as
/// tolerance. Where the two agree, the error is small and regular: it grows in proportion to what was left out.
///
/// Balls, free joints and springs between points are left as they are. The bodies of a robot from a file are written
/// out, unless the declaration changes its links.
///
/// ```
/// use pendulum_runtime::{Declaration, Question, simplest};
///
/// let declaration = Declaration::new("pub Pendulum {
///     gravity: [0, -9.81, 0],
///     body bob on ground {
///         mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta, friction: 0.02,
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
    let plain = question.model(declaration.clone(), None)?;
    let outputs = question.outputs(&plain)?;
    let origin = Origin::new(declaration, question, &plain, &outputs)?;
    let full = Full::new(&origin.model, question, &origin.compared, cancel)?;

    let compared = |candidate: Candidate| -> Result<Simpler, Refused> {
        let refused = |reason: String| Refused {
            changes: candidate.changes.clone(),
            reason,
        };
        let predicted = full.predicted(&candidate, question, cancel);
        let observed = full.observed(&candidate, question, cancel);
        if cancel() {
            return Err(refused("the search was cancelled before it was compared".to_owned()));
        }
        let (observed, cost) = observed.map_err(|stopped| refused(format!("by `Auto`, {stopped}")))?;
        Ok(Simpler {
            predicted: predicted.unwrap_or_else(|_| vec![f64::INFINITY; observed.len()]),
            changes: candidate.changes,
            declaration: candidate.text,
            observed,
            cost,
        })
    };
    let all_of = |changes: &[Vec<Change>]| -> Vec<Vec<Result<Simpler, Refused>>> {
        let candidates = changes.par_iter().map(|changes| origin.candidates(changes));
        let each = candidates.map(|found| found.into_par_iter().map(|one| one.and_then(compared)).collect());
        worker::on_all(|| each.collect())
    };
    // no change: the linear models of the declaration itself
    let mut singles = vec![Vec::new()];
    singles.extend(origin.changes().into_iter().map(|change| vec![change]));
    let of_singles = all_of(&singles);
    let worked: Vec<&Change> = singles
        .iter()
        .zip(&of_singles)
        .filter(|(_, found)| matches!(found.last(), Some(Ok(_))))
        .filter_map(|(changes, _)| changes.first())
        .collect();
    let mut pairs = Vec::new();
    for (n, &first) in worked.iter().enumerate() {
        let others = worked[n + 1..].iter();
        let others = others.filter(|other| !first.covers(other) && !other.covers(first));
        pairs.extend(others.map(|&other| vec![first.clone(), other.clone()]));
    }
    let tried = of_singles.into_iter().chain(all_of(&pairs)).flatten();
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
        let wrong = |what: &str, rule: String| Err(Error::setting(what, rule));
        if self.starts.is_empty() {
            return wrong(
                "starts",
                "give at least one initial state, such as `model.state(&[..])`".to_owned(),
            );
        }
        if !(self.horizon > 0.0 && self.horizon.is_finite()) {
            return wrong("horizon", format!("a time after 0 is needed, not {:?}", self.horizon));
        }
        if !self.starts.iter().flatten().all(|x| x.is_finite()) {
            return wrong("starts", "their components must be finite".to_owned());
        }
        if !(self.error > 0.0 && self.error < 1.0) {
            return wrong(
                "error",
                format!("a number between 0 and 1 is needed, not {:?}", self.error),
            );
        }
        if self.error < LEAST {
            let rule = format!(
                "{:?} is below {LEAST:?}, the smallest that reference motions in double precision allow",
                self.error
            );
            return wrong("error", rule);
        }
        Ok(())
    }

    /// The model of a declaration, with the values of parameters and inputs. With an outline of it, those that it no
    /// longer has are left out.
    fn model(&self, declaration: Declaration, outline: Option<&Outline>) -> Result<Model, Error> {
        fn those<V: Clone>(all: &[(String, V)], are_there: impl Fn(&str) -> bool) -> Vec<(&str, V)> {
            let named = all.iter().map(|(name, value)| (name.as_str(), value.clone()));
            named.filter(|(name, _)| are_there(name)).collect()
        }
        let values = those(&self.values, |name| {
            outline.is_none_or(|outline| outline.has_parameter(name))
        });
        let has_input = |name: &str| outline.is_none_or(|outline| outline.has_input(name));
        Model::declared(&declaration.also(["jacobian"]), &values)?
            .with_inputs(&those(&self.inputs, has_input))?
            .with_laws(&those(&self.laws, has_input))
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
        let mut found: Vec<String> = Vec::new();
        for name in &self.outputs {
            let is_part = |own: &&str| {
                own.strip_prefix(name.as_str())
                    .is_some_and(|rest| rest.starts_with('.'))
            };
            let known = || declared().chain(components());
            let new: Vec<&str> = match known().find(|own| own == name) {
                Some(own) => vec![own],
                None => declared().filter(is_part).collect(),
            };
            if new.is_empty() {
                return Err(Error::unknown("output or component", name, known()));
            }
            found.extend(new.into_iter().map(str::to_owned));
        }
        let mut seen = BTreeSet::new();
        found.retain(|name| seen.insert(name.clone()));
        Ok(found)
    }
}

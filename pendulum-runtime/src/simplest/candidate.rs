//! From changes of a declaration to models.

use super::change::{Change, Lost};
use super::outline::{Outline, Part};
use super::{Question, Refused, linear};
use crate::declaration::Declaration;
use crate::error::Error;
use crate::model::Model;
use crate::worker;

/// Codes of errors for what has no effect, and for forces between bodies that no longer move.
const IDLE: [&str; 2] = ["M105", "M501"];

/// Most parts in a row that are left out since a change leaves them without effect.
const MOST_IDLE: usize = 20;

/// Prefix of outputs for components of the state that are compared.
const COMPARED: &str = "compared_";

/// The full model, from which simpler ones are made.
pub(super) struct Origin<'q> {
    declaration: &'q Declaration,
    question: &'q Question,
    /// The declaration with an output for each component that is compared.
    outline: Outline,
    pub(super) model: Model,
    /// Outputs that are compared.
    pub(super) compared: Vec<usize>,
}

/// A simpler model.
pub(super) struct Candidate {
    /// Changes, in words.
    pub(super) changes: Vec<String>,
    /// Declaration, without the outputs for comparison.
    pub(super) text: String,
    pub(super) model: Model,
    /// Outputs that are compared.
    pub(super) compared: Vec<usize>,
    /// Component of the full state for each of its own.
    part: Vec<usize>,
    /// Parameters at which joints are fixed, each with the components of the full state that add up to its value, and signs.
    fixed: Vec<(String, Vec<(usize, f64)>)>,
}

impl<'q> Origin<'q> {
    /// Adds an output for each component of `names` to a declaration whose model is `plain`.
    pub(super) fn new(
        declaration: &'q Declaration,
        question: &'q Question,
        plain: &Model,
        names: &[String],
    ) -> Result<Self, Error> {
        let own = |(n, name): (usize, &String)| match plain.outputs().contains(&name.as_str()) {
            true => (name.clone(), String::new()),
            false => (format!("{COMPARED}{n}"), format!("\noutput {COMPARED}{n}: {name},")),
        };
        let (outputs, added): (Vec<String>, Vec<String>) = names.iter().enumerate().map(own).unzip();
        let outline = worker::alone(|| {
            let plain = Outline::new(declaration.text().to_owned());
            Outline::new(plain.with(vec![(plain.begin..plain.begin, added.concat())]))
        });
        let model = question.model(declaration.with_text(&outline.text), &|_| true)?;
        let compared = outputs
            .iter()
            .filter_map(|name| model.outputs().iter().position(|own| own == name));
        Ok(Self {
            declaration,
            question,
            compared: compared.collect(),
            outline,
            model,
        })
    }

    /// All single changes.
    pub(super) fn changes(&self) -> Vec<Change> {
        Change::all(&self.outline)
    }

    /// The models with some changes: one, unless there are no changes, and after at most one change the linear ones.
    pub(super) fn candidates(&self, changes: &[Change]) -> Vec<Result<Candidate, Refused>> {
        let words: Vec<String> = changes.iter().map(ToString::to_string).collect();
        let refused = |changes: &[String], reason| {
            let changes = changes.to_vec();
            Err(Refused { changes, reason })
        };
        let changed = match self.changed(changes, &words) {
            Ok(changed) => changed,
            Err(reason) => return vec![refused(&words, reason)],
        };
        let mut all = Vec::new();
        if changes.len() < 2 {
            match self.linear(&changed) {
                Ok(linear) => all.extend(linear.into_iter().map(Ok)),
                Err(reason) => {
                    let words: Vec<String> = std::iter::once("linear".to_owned()).chain(words).collect();
                    all.push(refused(&words, reason));
                }
            }
        }
        if !changes.is_empty() {
            all.push(Ok(changed));
        }
        all
    }

    /// Makes changes one after the other, and compiles the text.
    fn changed(&self, changes: &[Change], words: &[String]) -> Result<Candidate, String> {
        let mut outline = self.outline.clone();
        let mut fixed = Vec::new();
        for change in changes {
            let value = |lost: &Lost| value(&self.place_of(lost), &self.question.starts[0]);
            let (text, lost) = change.make(&outline, value)?;
            outline = worker::alone(|| Outline::new(text));
            fixed.extend(lost.and_then(|lost| Some((lost.parameter.clone()?, self.place_of(&lost)))));
        }
        let (outline, model) = self.compiled(outline)?;
        // without the outputs for comparison, a name may have lost its use
        let added = outline.of("output").filter(|output| output.rest.starts_with(COMPARED));
        let plain = outline.with(added.map(|output| outline.without(output)).collect());
        let (plain, _) = self.compiled(worker::alone(|| Outline::new(plain)))?;
        let names = self.compared.iter().map(|&n| self.model.outputs()[n]);
        let compared = names.filter_map(|name| model.outputs().iter().position(|own| *own == name));
        let part = model.components().iter().map(|own| self.component(&own.name));
        Ok(Candidate {
            changes: words.to_vec(),
            compared: compared.collect(),
            text: plain.text,
            part: part
                .collect::<Option<_>>()
                .ok_or("its state has components of its own")?,
            fixed,
            model,
        })
    }

    /// Compiles a text. Parts that have no effect after a change are left out.
    fn compiled(&self, mut outline: Outline) -> Result<(Outline, Model), String> {
        for _ in 0..MOST_IDLE {
            let is_there = |name: &str| outline.gives(name);
            let error = match self
                .question
                .model(self.declaration.with_text(&outline.text), &is_there)
            {
                Ok(model) => return Ok((outline, model)),
                Err(error) => error,
            };
            let Error::Declaration(wrong) = &error else {
                return Err(error.to_string());
            };
            let idle = wrong
                .problems
                .iter()
                .filter(|problem| IDLE.contains(&problem.code.as_str()));
            let idle: Vec<&Part> = idle
                .filter_map(|problem| outline.around(problem.line, problem.column))
                .collect();
            if idle.is_empty() {
                let first = &wrong.problems[0];
                return Err(format!("{} [{}]", first.message, first.code));
            }
            let text = outline.with(idle.iter().map(|part| outline.without(part)).collect());
            outline = worker::alone(|| Outline::new(text));
        }
        Err("too many parts of it have no effect".to_owned())
    }

    /// Models that are linear about the equilibria of another one, or why there are none.
    fn linear(&self, of: &Candidate) -> Result<Vec<Candidate>, String> {
        let starts: Vec<Vec<f64>> = self.question.starts.iter().map(|start| of.part_of(start)).collect();
        let mut all = Vec::new();
        for x in linear::equilibria(&of.model, &starts)? {
            let is_declared = |n: &&usize| !of.model.outputs()[**n].starts_with(COMPARED);
            let declared: Vec<usize> = of.compared.iter().filter(is_declared).copied().collect();
            let measured = Declaration::new(&linear::declaration(&of.model, &x, &of.compared)?);
            let model = Model::declared(&measured.also(["jacobian"]), &[]).map_err(|error| error.to_string())?;
            let about = format!("linear about {}", linear::name(&of.model, &x));
            all.push(Candidate {
                changes: std::iter::once(about).chain(of.changes.iter().cloned()).collect(),
                text: linear::declaration(&of.model, &x, &declared)?,
                compared: (0..of.compared.len()).collect(),
                part: of.part.clone(),
                fixed: Vec::new(),
                model,
            });
        }
        Ok(all)
    }

    fn component(&self, name: &str) -> Option<usize> {
        self.model.components().iter().position(|own| own.name == name)
    }

    /// Components of the full state that add up to where a joint is fixed, with signs.
    fn place_of(&self, lost: &Lost) -> Vec<(usize, f64)> {
        let own = self.component(&lost.coordinate).map(|n| (n, 1.0));
        let from = lost
            .from
            .as_ref()
            .and_then(|from| self.component(from))
            .map(|n| (n, -1.0));
        own.into_iter().chain(from).collect()
    }
}

fn value(of: &[(usize, f64)], start: &[f64]) -> f64 {
    of.iter().map(|&(n, sign)| sign * start[n]).sum()
}

impl Candidate {
    /// The model for a start of the full model: its joints are fixed where they are there.
    pub(super) fn at(&self, start: &[f64]) -> Result<Model, Error> {
        let values = self.fixed.iter().map(|(name, of)| (name.as_str(), value(of, start)));
        self.model.with(&values.collect::<Vec<_>>())
    }

    /// Its part of a state of the full model.
    pub(super) fn part_of(&self, full: &[f64]) -> Vec<f64> {
        self.part.iter().map(|&n| full[n]).collect()
    }
}

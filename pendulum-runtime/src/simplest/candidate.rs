//! From changes of a declaration to models.

use super::change::{Change, Lost};
use super::outline::{Edit, Outline, Part};
use super::{Question, Refused, linear};
use crate::declaration::Declaration;
use crate::error::Error;
use crate::model::Model;

/// Codes of errors for what has no effect, and for forces between bodies that no longer move.
const IDLE_CODES: [&str; 2] = ["M105", "M501"];

/// Most parts in a row that are left out since a change leaves them without effect.
const MOST_IDLE: usize = 20;

/// The full model, from which simpler ones are made.
pub(super) struct Origin<'q> {
    declaration: &'q Declaration,
    question: &'q Question,
    /// The declaration with the values of parameters as their defaults, and with an output for each component that is
    /// compared.
    outline: Outline,
    /// Names of these outputs.
    added: Vec<String>,
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
    /// Declaration with them.
    measured: Outline,
    pub(super) model: Model,
    /// Outputs that are compared.
    pub(super) compared: Vec<usize>,
    /// Component of the full state for each of its own.
    part: Vec<usize>,
    /// Parameters at which joints are fixed, each with the components of the full state that add up to its value, and
    /// their signs.
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
        let own = |reason: String| Error::setting("the declaration", reason);
        let written = Self::written(declaration, question).map_err(own)?;
        let output = |(n, name): (usize, &String)| match plain.outputs().contains(&name.as_str()) {
            true => name.clone(),
            false => written.fresh(format!("compared_{n}")),
        };
        let outputs: Vec<String> = names.iter().enumerate().map(output).collect();
        let (added, items): (Vec<String>, Vec<String>) = outputs
            .iter()
            .zip(names)
            .filter(|(output, name)| output != name)
            .map(|(output, name)| (output.clone(), format!("\n    output {output}: {name},")))
            .unzip();
        let text = written.with(vec![(written.begin..written.begin, items.concat())]);
        let outline = Outline::new(text).map_err(own)?;
        let model = question.model(declaration.with_text(&outline.text), None)?;
        let compared = outputs
            .iter()
            .filter_map(|name| model.outputs().iter().position(|own| own == name));
        Ok(Self {
            declaration,
            question,
            compared: compared.collect(),
            outline,
            added,
            model,
        })
    }

    /// The text of a declaration, with the bodies of a robot and with the values of parameters as their defaults, where
    /// that is possible.
    fn written(declaration: &Declaration, question: &Question) -> Result<Outline, String> {
        let replaced = |outline: Outline, edits: Vec<Edit>| match Outline::new(outline.with(edits)) {
            Ok(next) if question.model(declaration.with_text(&next.text), None).is_ok() => next,
            _ => outline,
        };
        let mut outline = Outline::new(declaration.text().to_owned())?;
        let robot = outline.of("robot").next().zip(declaration.robot_bodies());
        if let Some(edit) = robot.map(|(robot, bodies)| (robot.place.clone(), bodies)) {
            outline = replaced(outline, vec![edit]);
        }
        let parameters = outline.of("params").flat_map(|params| &params.fields);
        let with_value = |own: &Part| {
            let (_, value) = question.values.iter().find(|(name, _)| *name == own.word)?;
            Some(match outline.default_of(own) {
                Some(place) => (place, format!(" {value:?}")),
                None => (own.own.end..own.own.end, format!(" = {value:?}")),
            })
        };
        let values: Vec<Edit> = parameters.filter_map(with_value).collect();
        Ok(if values.is_empty() {
            outline
        } else {
            replaced(outline, values)
        })
    }

    /// All single changes.
    pub(super) fn changes(&self) -> Vec<Change> {
        Change::all(&self.outline)
    }

    /// The models with some changes: after at most one change the linear ones, then, unless there are no changes, the
    /// one with these alone.
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
        let mut ordered: Vec<&Change> = changes.iter().collect();
        ordered.sort_by_key(|change| change.order(&self.outline));
        for change in ordered {
            let value = |lost: &Lost| value(&self.place_of(lost), &self.question.starts[0]);
            let (text, lost) = change.make(&outline, value)?;
            outline = Outline::new(text)?;
            fixed.extend(lost.and_then(|lost| Some((lost.parameter.clone()?, self.place_of(&lost)))));
        }
        let (outline, model) = self.compiled(outline)?;
        let text = match self.added.is_empty() {
            true => outline.text.clone(),
            false => {
                // without the outputs for comparison, a name may have lost its use
                let added = outline.of("output").filter(|output| self.is_added(output.name()));
                let plain = outline.with(added.map(|output| outline.without(output)).collect());
                self.compiled(Outline::new(plain)?)?.0.text
            }
        };
        // a parameter that drops out is replaced by its value
        fixed.retain(|(name, _)| model.parameters().iter().any(|own| own.name == *name));
        let place = |name: &str| model.outputs().iter().position(|own| *own == name);
        let compared = self.compared.iter().map(|&n| place(self.model.outputs()[n]));
        let part = model.components().iter().map(|own| self.component(&own.name));
        Ok(Candidate {
            changes: words.to_vec(),
            compared: compared
                .collect::<Option<_>>()
                .ok_or("an output that is compared has no effect")?,
            text,
            measured: outline,
            part: part
                .collect::<Option<_>>()
                .ok_or("its state has components of its own")?,
            fixed,
            model,
        })
    }

    fn is_added(&self, output: &str) -> bool {
        self.added.iter().any(|own| own == output)
    }

    /// Compiles a text. Parts that have no effect after a change are left out; a parameter that is still used, but
    /// drops out, is replaced by its value.
    fn compiled(&self, mut outline: Outline) -> Result<(Outline, Model), String> {
        for _ in 0..MOST_IDLE {
            let error = match self
                .question
                .model(self.declaration.with_text(&outline.text), Some(&outline))
            {
                Ok(model) => return Ok((outline, model)),
                Err(error) => error,
            };
            let Error::Declaration(wrong) = &error else {
                return Err(error.in_one_line());
            };
            let idle = wrong
                .problems
                .iter()
                .filter(|problem| IDLE_CODES.contains(&problem.code.as_str()));
            let idle: Vec<&Part> = idle
                .filter_map(|problem| outline.idle(problem.line, problem.column))
                .collect();
            if idle.is_empty() {
                return Err(error.in_one_line());
            }
            let mut edits: Vec<_> = idle.iter().map(|part| outline.without(part)).collect();
            let parameters = outline.of("params").flat_map(|params| &params.fields);
            for own in parameters.filter(|own| idle.iter().any(|part| part.place == own.place)) {
                if let Some(place) = outline.default_of(own) {
                    let value = outline.text[place].trim();
                    let value = match outline.unit_of(own).map(|place| &outline.text[place]) {
                        None | Some("1") => format!("({value})"),
                        Some(unit) => match unit.strip_prefix("1/") {
                            Some(below) => format!("(({value})/(1 {below}))"),
                            None => format!("(({value})*(1 {unit}))"),
                        },
                    };
                    edits.extend(outline.uses(&own.word, own).map(|place| (place, value.clone())));
                }
            }
            outline = Outline::new(outline.with(edits))?;
        }
        Err("too many parts of it have no effect".to_owned())
    }

    /// Models that are linear about the equilibria of another one, or why there are none.
    fn linear(&self, of: &Candidate) -> Result<Vec<Candidate>, String> {
        let starts: Vec<Vec<f64>> = self.question.starts.iter().map(|start| of.part_of(start)).collect();
        // for an equilibrium: inputs may depend on time, and parameters do not
        let as_parameter = |input: &Part| {
            let value = self.question.inputs.iter().find(|(name, _)| name == input.name());
            let value = value.map_or(0.0, |(_, value)| *value);
            let text = &of.measured.text[input.own.clone()];
            let unit = text.split_once("input").map_or(text, |(_, rest)| rest.trim());
            let equals = if of.measured.is_without_units() { "=" } else { " =" };
            (input.place.clone(), format!("params {{ {unit} {equals} {value:?} }}"))
        };
        let inputs: Vec<_> = of.measured.of("input").map(as_parameter).collect();
        let model = match inputs.is_empty() {
            true => of.model.clone(),
            false => self.compiled(Outline::new(of.measured.with(inputs))?)?.1,
        };
        let mut all = Vec::new();
        for x in linear::equilibria(&model, &starts)? {
            let measured = linear::declaration(&of.model, &x, &of.compared).map_err(|error| error.in_one_line())?;
            let outline = Outline::new(measured)?;
            let outputs = outline.of("output").zip(&of.compared);
            let added = outputs.filter(|(_, n)| self.is_added(model.outputs()[**n]));
            let text = outline.with(added.map(|(output, _)| outline.without(output)).collect());
            let own = self.question.model(Declaration::new(&outline.text), Some(&outline));
            let about = format!("linear about {}", linear::name(&model, &x));
            all.push(Candidate {
                changes: std::iter::once(about).chain(of.changes.iter().cloned()).collect(),
                text,
                measured: outline,
                compared: (0..of.compared.len()).collect(),
                part: of.part.clone(),
                fixed: Vec::new(),
                model: own.map_err(|error| error.in_one_line())?,
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

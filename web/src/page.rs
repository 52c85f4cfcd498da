//! Answers to requests.

use std::collections::BTreeMap;

use pendulum_runtime::{
    Declaration, Error, Event, Function as OwnFunction, Method, Model, Options, Quantity as OwnQuantity, ShapeKind,
    Sources, Stopped,
};

use crate::crowd::Crowd;
use crate::message::{About, Answer, Component, Function, Moved, Place, Quantity, Request, Section, Settings, Shape};
use crate::{drag, frames, start};

/// Value of a parameter that has no default.
const ASSUMED: f64 = 1.0;
/// Code of the error that a file cannot be read.
const NO_FILE: &str = "M801";

/// A mechanism, and motions of it.
#[derive(Debug, Default)]
pub struct Page {
    model: Option<Model>,
    declaration: Declaration,
    crowd: Option<Crowd>,
}

impl Page {
    /// Answers a request in JSON, as JSON and numbers.
    pub fn answer_json(&mut self, request: &[u8]) -> (String, Vec<f64>) {
        let (answer, numbers) = match serde_json::from_slice(request) {
            Ok(request) => self.answer(request),
            Err(error) => (refused(&error), Vec::new()),
        };
        let text = serde_json::to_string(&answer).unwrap_or_default();
        (text, numbers)
    }

    /// Answers a request, with numbers such as frames.
    pub fn answer(&mut self, request: Request) -> (Answer, Vec<f64>) {
        let mut numbers = Vec::new();
        let answer = self.try_answer(request, &mut numbers);
        (answer.unwrap_or_else(|error| refused(&error)), numbers)
    }

    fn try_answer(&mut self, request: Request, numbers: &mut Vec<f64>) -> Result<Answer, Error> {
        let mechanism = || {
            self.model.as_ref().ok_or_else(|| Error::Setting {
                what: "there is no mechanism yet".to_owned(),
                rule: "declare one".to_owned(),
            })
        };
        Ok(match request {
            Request::Declare { text, files, method } => self.declare(&text, files, &method)?,
            Request::Describe => self.describe()?,
            Request::Code { language } => self.code(&language)?,
            Request::Set { values, inputs } => {
                let model = mechanism()?;
                let names = model.inputs().iter().map(|input| input.name.as_str());
                let inputs: Vec<(&str, f64)> = names.zip(inputs).collect();
                let changed = model.with_values(&values)?.with_inputs(&inputs)?;
                self.crowd = None;
                self.model = Some(changed);
                Answer::Done
            }
            Request::Look { t, x } => {
                let model = mechanism()?;
                let x = drag::placed(model, t, x)?;
                frames::push(numbers, model, t, &x)?;
                Answer::State { x }
            }
            Request::Move {
                by,
                span,
                x,
                frames,
                section,
            } => {
                let model = mechanism()?;
                let options = Options {
                    times: Some(frames::times(span, frames)),
                    events: section.map(|section| passage(model, section)).into_iter().collect(),
                    ..Options::default()
                };
                let mut moved = moved(model, &method(&by)?, span, &x, &options, numbers)?;
                if let Some(section) = section {
                    moved.passages.retain(|(_, x)| is_upward(model, section, x));
                }
                Answer::Frames(moved)
            }
            Request::Near { t, x, by } => {
                let x = drag::near(mechanism()?, t, &x, by)?;
                Answer::State { x }
            }
            Request::Gather { t, x, count, spread } => {
                self.crowd = Some(Crowd::new(mechanism()?, t, &x, count, spread)?);
                Answer::Done
            }
            Request::MoveAll { span, frames } => match &mut self.crowd {
                Some(crowd) => Answer::Frames(crowd.go(mechanism()?, span, frames, numbers)?),
                None => Answer::Refused {
                    why: "gather the motions first".to_owned(),
                },
            },
            Request::Drag {
                t,
                x,
                shape,
                point,
                to,
                view,
            } => {
                let model = mechanism()?;
                let x = drag::dragged(model, t, &x, (shape, point), to, view)?;
                frames::push(numbers, model, t, &x)?;
                Answer::State { x }
            }
        })
    }

    fn declare(&mut self, text: &str, files: BTreeMap<String, String>, method: &str) -> Result<Answer, Error> {
        let method = Method::new(method)?;
        let words = ["energy", "shapes"].into_iter().chain(method.word());
        let mut declaration = Declaration::new(text).also(words);
        for (name, text) in &files {
            declaration = declaration.file(name, text);
        }
        let mut notes = Vec::new();
        let motion = declaration.clone().only_motion();
        let model = match Model::declared(&motion, &[]) {
            Err(Error::NoValue { parameters }) => {
                let names = parameters.join("`, `");
                let have = if parameters.len() > 1 {
                    "have no defaults"
                } else {
                    "has no default"
                };
                notes.push(format!("`{names}` {have} in the declaration: {ASSUMED} is assumed"));
                let values: Vec<(&str, f64)> = parameters.iter().map(|name| (name.as_str(), ASSUMED)).collect();
                Model::declared(&motion, &values)
            }
            model => model,
        };
        let model = match model {
            Ok(model) => model,
            Err(Error::Declaration(errors)) => {
                let problems = errors.problems.into_iter().map(place).collect();
                return Ok(Answer::Problems { problems });
            }
            Err(error) => return Err(error),
        };
        notes.extend(model.repaired().iter().cloned());
        let about = about(&model, &method, notes)?;
        self.declaration = declaration;
        self.crowd = None;
        self.model = Some(model);
        Ok(Answer::Mechanism(Box::new(about)))
    }

    /// Compiles the declaration anew, with all that it lists.
    fn describe(&self) -> Result<Answer, Error> {
        let values = self.model.as_ref().map(|model| {
            let names = model.parameters().iter().map(|own| own.name.as_str());
            names.zip(model.values().iter().copied()).collect::<Vec<_>>()
        });
        let model = Model::declared(&self.declaration, &values.unwrap_or_default())?;
        let function = |own: &OwnFunction| Function {
            name: own.name.clone(),
            docs: own.docs.clone(),
            form: own.form.clone(),
            operations: own.operations,
        };
        Ok(Answer::Description {
            latex: model.latex().to_owned(),
            functions: model.functions().iter().map(function).collect(),
        })
    }

    fn code(&self, language: &str) -> Result<Answer, Error> {
        let text = match language {
            "c" => {
                let Sources { name, header, source } = self.declaration.c()?;
                format!("/* {name}.h */\n\n{header}\n/* {name}.c */\n\n{source}")
            }
            "rust" => formatted(self.declaration.rust()?),
            _ => {
                let (what, rule) = (
                    format!("`{language}` is not printed"),
                    "ask for `rust` or `c`".to_owned(),
                );
                return Err(Error::Setting { what, rule });
            }
        };
        Ok(Answer::Code { text })
    }
}

/// Rust formatted for reading.
fn formatted(items: String) -> String {
    syn::parse_file(&items).map_or(items, |file| prettyplease::unparse(&file))
}

fn refused(why: &impl ToString) -> Answer {
    Answer::Refused { why: why.to_string() }
}

/// Method with its settings.
fn method(settings: &Settings) -> Result<Method, Error> {
    let mut method = Method::new(&settings.method)?;
    if let Some(h) = settings.h {
        method = method.h(h);
    }
    if let Some(tolerance) = settings.tolerance {
        method = method.rtol(tolerance).atol(tolerance);
    }
    Ok(method)
}

/// The passage of a section. That of an angle is a zero of a sine, which [half a turn](is_upward) away falls.
fn passage(model: &Model, Section { component, value }: Section) -> Event<'static> {
    let periodic = is_periodic(model, component);
    let past = move |_: f64, x: &[f64]| {
        let past = x.get(component).map_or(f64::NAN, |x| x - value);
        if periodic { past.sin() } else { past }
    };
    Event::new(past).rising()
}

fn is_periodic(model: &Model, component: usize) -> bool {
    model.components().get(component).is_some_and(|own| own.periodic)
}

/// True if a state lies on the section, not half a turn from it.
fn is_upward(model: &Model, Section { component, value }: Section, x: &[f64]) -> bool {
    !is_periodic(model, component) || (x[component] - value).cos() > 0.0
}

/// Integrates, and adds frames.
fn moved(
    model: &Model,
    method: &Method,
    span: [f64; 2],
    x: &[f64],
    options: &Options<'_>,
    numbers: &mut Vec<f64>,
) -> Result<Moved, Error> {
    let (motion, stopped) = match model.solve_with(method, span, x, options) {
        Ok(motion) => (motion, None),
        Err(Stopped {
            error,
            motion: Some(motion),
            ..
        }) => (*motion, Some(error.to_string())),
        Err(Stopped { error, .. }) => return Err(*error),
    };
    for (n, &t) in motion.t().iter().enumerate() {
        frames::push(numbers, model, t, motion.state(n))?;
    }
    let statistics = motion.statistics();
    Ok(Moved {
        width: numbers.len() / motion.t().len().max(1),
        t: motion.end().0,
        x: motion.end().1.to_vec(),
        stopped,
        modes: motion.modes().to_vec(),
        passages: motion
            .occurrences()
            .iter()
            .map(|passage| (passage.t, passage.x.clone()))
            .collect(),
        warnings: motion.warnings().to_vec(),
        evaluations: statistics.evaluations,
        steps: statistics.accepted,
        accuracy: None,
    })
}

fn about(model: &Model, method: &Method, mut notes: Vec<String>) -> Result<About, Error> {
    let quantity = |(own, &value): (&OwnQuantity, &f64)| Quantity {
        name: own.name.clone(),
        unit: own.unit.clone(),
        docs: own.docs.clone(),
        value,
    };
    let start = start::start(model);
    let shapes = frames::shapes(model, 0.0, &start)?;
    let is_drawn = |wall: &str| {
        shapes
            .iter()
            .any(|shape| shape.kind == ShapeKind::Wall && shape.name == wall)
    };
    let is_joint = |name: &str| model.components().iter().any(|own| own.name == name);
    let others = model.constraints().filter(|name| !is_joint(name) && !is_drawn(name));
    notes.extend(others.map(|wall| format!("`{wall}` is not drawn: only flat walls at rest are")));
    Ok(About {
        name: model.name().to_owned(),
        docs: model.docs().to_owned(),
        parameters: model.parameters().iter().zip(model.values()).map(quantity).collect(),
        inputs: model.inputs().iter().zip(model.inputs_now()).map(quantity).collect(),
        components: model
            .components()
            .iter()
            .map(|own| Component {
                name: own.name.clone(),
                unit: own.unit.clone(),
                periodic: own.periodic,
            })
            .collect(),
        constraints: model.constraints().map(str::to_owned).collect(),
        shapes: shapes
            .iter()
            .map(|shape| Shape {
                kind: format!("{:?}", shape.kind),
                name: shape.name.to_owned(),
                body: shape.body.to_owned(),
                points: shape.points.len(),
                moves: frames::moves(shape),
            })
            .collect(),
        has_energy: model.energy(0.0, &start).is_ok(),
        has_fixed_steps: method.is_fixed(),
        start,
        notes,
    })
}

fn place(problem: pendulum_runtime::Problem) -> Place {
    let (message, help) = if problem.code == NO_FILE {
        // the page has no folders, and what the system says of a browser helps nobody
        let file = problem.message.split(" cannot be read").next().unwrap_or_default();
        let help = "open it by the button `Robot file`, and write its name without a folder";
        (format!("{file} is not open"), help.to_owned())
    } else {
        (problem.message, problem.help)
    };
    Place {
        line: problem.line,
        column: problem.column,
        width: problem.width,
        code: problem.code,
        message,
        help,
    }
}

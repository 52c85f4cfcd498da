//! The model description.

use std::collections::BTreeSet;

use super::super::c::template::{fill, lines};
use super::TOOL;
use super::units::definition;
use crate::program::{Program, Role, Slot, SlotKind};
use crate::units::Unit;

/// Variable of the model, of type `Float64`.
#[derive(Default)]
struct Variable {
    name: String,
    /// Value reference.
    reference: usize,
    causality: &'static str,
    /// Relation of the start value to the initial one; empty if FMI prescribes it.
    initial: &'static str,
    start: Option<f64>,
    unit: String,
    docs: Vec<String>,
    /// Reference of the state whose derivative it is.
    derivative_of: Option<usize>,
}

/// State as a variable, and its derivative.
struct State {
    name: String,
    unit: String,
    docs: Vec<String>,
    /// True for a coordinate that follows others.
    depends: bool,
    /// Name and unit of the derivative; none if it is itself the state of this index.
    derivative: Result<usize, (String, String)>,
}

/// Prints the model description, for a model whose functions have a prefix.
pub(super) fn description(program: &Program, identifier: &str, token: &str) -> String {
    let states = states(program);
    let first = [
        1,
        program.parameters.len(),
        program.inputs.len(),
        states.len(),
        states.len(),
        program.outputs.len(),
    ];
    let first: Vec<usize> = first
        .iter()
        .scan(0, |sum, count| {
            *sum += count;
            Some(*sum)
        })
        .collect();
    let [parameter, input, state, derivative, output, event] = first[..] else {
        return String::new();
    };
    let derivative_of = |n: usize| match states[n].derivative {
        Ok(place) => state + place,
        Err(_) => derivative + n,
    };
    let mut variables: Vec<Variable> = Vec::new();
    variables.extend(program.parameters.iter().enumerate().map(|(n, own)| Variable {
        name: plain(&own.name),
        reference: parameter + n,
        causality: "parameter",
        start: Some(own.default.unwrap_or(f64::NAN)),
        unit: own.unit.clone(),
        docs: own.docs.clone(),
        ..Variable::default()
    }));
    variables.extend(program.inputs.iter().enumerate().map(|(n, own)| Variable {
        name: plain(&own.name),
        reference: input + n,
        causality: "input",
        start: Some(0.0),
        unit: own.unit.clone(),
        docs: own.docs.clone(),
        ..Variable::default()
    }));
    variables.extend(states.iter().zip(&program.start).enumerate().map(|(n, (own, start))| {
        Variable {
            name: own.name.clone(),
            reference: state + n,
            causality: "output",
            initial: if own.depends { "approx" } else { "exact" },
            start: Some(*start),
            unit: own.unit.clone(),
            docs: own.docs.clone(),
            derivative_of: states
                .iter()
                .position(|other| other.derivative == Ok(n))
                .map(|of| state + of),
        }
    }));
    variables.extend(states.iter().enumerate().filter_map(|(n, own)| {
        let (name, unit) = own.derivative.clone().err()?;
        Some(Variable {
            name,
            reference: derivative + n,
            causality: "local",
            initial: "calculated",
            unit,
            derivative_of: Some(state + n),
            ..Variable::default()
        })
    }));
    variables.extend(
        program
            .outputs
            .iter()
            .zip(&program.output_units)
            .enumerate()
            .map(|(n, (name, unit))| Variable {
                name: name.replace(' ', ""),
                reference: output + n,
                causality: "output",
                initial: "calculated",
                unit: unit.clone(),
                ..Variable::default()
            }),
    );
    variables.extend(program.events.iter().enumerate().map(|(n, own)| Variable {
        name: plain(&own.name),
        reference: event + n,
        causality: "local",
        initial: "calculated",
        ..Variable::default()
    }));
    // last, so that it makes way for a declared `time`
    variables.push(Variable {
        name: "time".to_owned(),
        causality: "independent",
        unit: "s".to_owned(),
        ..Variable::default()
    });
    let mut taken = BTreeSet::new();
    for variable in &mut variables {
        while !taken.insert(variable.name.clone()) {
            variable.name.push('_');
        }
    }

    let units: BTreeSet<&str> = variables.iter().map(|variable| variable.unit.as_str()).collect();
    let has_derivatives = program.with_role(Role::Jacobian).is_some();
    let known: Vec<usize> = (state..derivative)
        .chain((!program.layout.autonomous).then_some(0))
        .collect();
    let outputs = variables.iter().filter(|variable| variable.causality == "output");
    let outputs = outputs.map(|own| match own.reference {
        itself if itself < derivative => element("Output", itself, Some(&[itself])),
        computed => element("Output", computed, Some(&known)),
    });
    let rates = (0..states.len()).map(|n| match derivative_of(n) {
        rate if rate < derivative => element("ContinuousStateDerivative", rate, Some(&[rate])),
        rate => element("ContinuousStateDerivative", rate, None),
    });
    let is_rate = |own: &Variable| own.derivative_of.is_some() && own.initial == "calculated";
    let unknown = variables
        .iter()
        .filter(|own| own.causality == "output" && own.initial != "exact" || is_rate(own));
    let initial = unknown.map(|own| element("InitialUnknown", own.reference, None));
    let indicators = (event..event + program.events.len()).map(|n| element("EventIndicator", n, None));
    let structured = variables.iter().all(|variable| variable.name.is_ascii());
    let values = [
        ("name", program.name.clone()),
        ("identifier", identifier.to_owned()),
        ("token", token.to_owned()),
        ("docs", escaped(&program.docs.join(" "))),
        ("tool", TOOL.to_owned()),
        ("naming", if structured { "structured" } else { "flat" }.to_owned()),
        ("has_derivatives", has_derivatives.to_string()),
        ("units", lines(units.into_iter().filter_map(definition))),
        ("variables", lines(variables.iter().map(Variable::element))),
        (
            "structure",
            lines(outputs.chain(rates).chain(initial).chain(indicators)),
        ),
    ];
    fill(include_str!("templates/description.xml"), &values)
}

/// States, in the order of the state vector.
fn states(program: &Program) -> Vec<State> {
    let layout = &program.layout;
    let names = |slot: &Slot| match slot.kind {
        SlotKind::Quaternion => ["w", "x", "y", "z"]
            .map(|axis| format!("{}.{axis}", slot.name))
            .to_vec(),
        SlotKind::Angle | SlotKind::Length => vec![slot.name.clone()],
    };
    let positions = layout.slots.iter().flat_map(|slot| {
        names(slot).into_iter().enumerate().map(move |(n, name)| State {
            unit: slot.kind.unit().to_owned(),
            docs: Vec::new(),
            depends: slot.rates.is_empty(),
            derivative: match slot.kind {
                SlotKind::Angle | SlotKind::Length if !slot.rates.is_empty() => Ok(slot.rates.start + n),
                SlotKind::Angle | SlotKind::Length => Err((format!("der({name})"), slot.kind.rate_unit().to_owned())),
                SlotKind::Quaternion => Err((format!("der({name})"), "1/s".to_owned())),
            },
            name,
        })
    });
    let rates = layout
        .slots
        .iter()
        .filter(|slot| !slot.rates.is_empty())
        .flat_map(|slot| {
            let names: Vec<[String; 2]> = match slot.kind {
                SlotKind::Quaternion => ["x", "y", "z"]
                    .map(|axis| format!("{}.omega.{axis}", slot.name))
                    .map(|name| [name.clone(), format!("der({name})")])
                    .to_vec(),
                SlotKind::Angle | SlotKind::Length => {
                    vec![[format!("der({})", slot.name), format!("der({},2)", slot.name)]]
                }
            };
            names.into_iter().map(|[name, derivative]| State {
                name,
                unit: slot.kind.rate_unit().to_owned(),
                docs: Vec::new(),
                depends: false,
                derivative: Err((derivative, format!("{}^2", slot.kind.rate_unit()))),
            })
        });
    let own = layout.states.iter().map(|own| State {
        name: own.name.clone(),
        unit: own.unit.clone(),
        docs: own.docs.clone(),
        depends: false,
        derivative: Err((
            format!("der({})", own.name),
            Unit::of(&own.unit).map_or_else(String::new, |unit| unit.rate()),
        )),
    });
    positions.chain(rates).chain(own).collect()
}

impl Variable {
    fn element(&self) -> String {
        let mut text = format!(
            "<Float64 name=\"{}\" valueReference=\"{}\" causality=\"{}\"",
            escaped(&self.name),
            self.reference,
            self.causality
        );
        let variability = match self.causality {
            "parameter" => "fixed",
            _ => "continuous",
        };
        let mut add = |key: &str, value: &str| {
            if !value.is_empty() {
                text += &format!(" {key}=\"{value}\"");
            }
        };
        add("variability", variability);
        add("initial", self.initial);
        add("start", &self.start.map_or_else(String::new, number));
        add(
            "unit",
            if definition(&self.unit).is_some() {
                &self.unit
            } else {
                ""
            },
        );
        add(
            "derivative",
            &self.derivative_of.map_or_else(String::new, |of| of.to_string()),
        );
        add("description", &escaped(&self.docs.join(" ")));
        text + "/>"
    }
}

/// Element of the model structure, with the references that its variable depends on: on all if they are not known.
fn element(kind: &str, reference: usize, known: Option<&[usize]>) -> String {
    let known = known.map_or_else(String::new, |known| {
        let known: Vec<String> = known.iter().map(usize::to_string).collect();
        format!(" dependencies=\"{}\"", known.join(" "))
    });
    format!("<{kind} valueReference=\"{reference}\"{known}/>")
}

/// Number in the notation of XML.
fn number(value: f64) -> String {
    if value.is_nan() {
        "NaN".to_owned()
    } else {
        format!("{value:?}")
    }
}

/// Name without the mark of a raw identifier.
fn plain(name: &str) -> String {
    name.trim_start_matches("r#").to_owned()
}

/// Text of an attribute.
fn escaped(text: &str) -> String {
    text.trim()
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
        .replace(|c: char| c.is_control(), " ")
}

//! The model description.

use std::collections::BTreeSet;

use super::super::c::template::{fill, lines};
use super::TOOL;
use super::units::definition;
use super::variables::{References, State, Variable, states, variables};
use crate::program::{Program, Role};

/// Prints the model description, for a model whose functions have a prefix.
pub(super) fn description(program: &Program, identifier: &str, token: &str) -> String {
    let states = states(program);
    let first = References::of(program);
    let variables = variables(program, &states, &first);
    let units: BTreeSet<&str> = variables.iter().map(|variable| variable.unit.as_str()).collect();
    let structured = variables.iter().all(|variable| variable.name.is_ascii());
    let values = [
        ("name", program.name.clone()),
        ("identifier", identifier.to_owned()),
        ("token", token.to_owned()),
        ("docs", escaped(&program.docs.join(" "))),
        ("tool", TOOL.to_owned()),
        ("naming", if structured { "structured" } else { "flat" }.to_owned()),
        (
            "has_derivatives",
            program.with_role(Role::Jacobian).is_some().to_string(),
        ),
        ("units", lines(units.into_iter().filter_map(definition))),
        ("variables", lines(variables.iter().map(Variable::element))),
        ("structure", structure(program, &states, &variables, &first)),
    ];
    fill(include_str!("templates/description.xml"), &values)
}

/// The model structure: what outputs and derivatives depend on, initial unknowns, and event indicators.
fn structure(program: &Program, states: &[State], variables: &[Variable], first: &References) -> String {
    let known: Vec<usize> = (first.state..first.derivative)
        .chain((!program.layout.autonomous).then_some(0))
        .collect();
    let outputs = variables.iter().filter(|variable| variable.causality == "output");
    let outputs = outputs.map(|own| match own.reference {
        itself if itself < first.derivative => element("Output", itself, Some(&[itself])),
        computed => element("Output", computed, Some(&known)),
    });
    let rates = states.iter().enumerate().map(|(n, own)| match own.derivative {
        Ok(place) => element(
            "ContinuousStateDerivative",
            first.state + place,
            Some(&[first.state + place]),
        ),
        Err(_) => element("ContinuousStateDerivative", first.derivative + n, None),
    });
    let is_rate = |own: &Variable| own.derivative_of.is_some() && own.initial == "calculated";
    let unknown = variables
        .iter()
        .filter(|own| own.causality == "output" && own.initial != "exact" || is_rate(own));
    let initial = unknown.map(|own| element("InitialUnknown", own.reference, None));
    let events = first.event..first.event + program.events.len();
    let indicators = events.map(|n| element("EventIndicator", n, None));
    lines(outputs.chain(rates).chain(initial).chain(indicators))
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

/// Text of an attribute.
fn escaped(text: &str) -> String {
    text.trim()
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
        .replace(|c: char| c.is_control(), " ")
}

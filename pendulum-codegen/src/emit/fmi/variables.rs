//! The variables of a model.

use std::collections::BTreeSet;

use crate::program::{Program, Quantity, Slot, SlotKind};
use crate::units::Unit;

/// Variable of the model, of type `Float64`.
#[derive(Default)]
pub(super) struct Variable {
    pub(super) name: String,
    /// Value reference.
    pub(super) reference: usize,
    pub(super) causality: &'static str,
    /// Relation of the start value to the initial one; empty if FMI prescribes it.
    pub(super) initial: &'static str,
    pub(super) start: Option<f64>,
    pub(super) unit: String,
    pub(super) docs: Vec<String>,
    /// Reference of the state whose derivative it is.
    pub(super) derivative_of: Option<usize>,
}

/// State as a variable, and its derivative.
pub(super) struct State {
    pub(super) name: String,
    pub(super) unit: String,
    pub(super) docs: Vec<String>,
    /// True for a coordinate that follows others.
    pub(super) depends: bool,
    /// Name and unit of the derivative; none if it is itself the state of this index.
    pub(super) derivative: Result<usize, (String, String)>,
}

/// First value references of each kind of variable. The time has reference 0.
pub(super) struct References {
    parameter: usize,
    input: usize,
    pub(super) state: usize,
    pub(super) derivative: usize,
    output: usize,
    pub(super) event: usize,
}

impl References {
    pub(super) fn of(program: &Program) -> Self {
        let (parameter, states) = (1, program.layout.len());
        let input = parameter + program.parameters.len();
        let state = input + program.inputs.len();
        let derivative = state + states;
        let output = derivative + states;
        Self {
            parameter,
            input,
            state,
            derivative,
            output,
            event: output + program.outputs.len(),
        }
    }
}

/// All variables, each with a name of its own.
pub(super) fn variables(program: &Program, states: &[State], first: &References) -> Vec<Variable> {
    let outputs = program.outputs.iter().zip(&program.output_units).enumerate();
    let outputs = outputs.map(|(n, (name, unit))| Variable {
        name: name.replace(' ', ""),
        reference: first.output + n,
        causality: "output",
        initial: "calculated",
        unit: unit.clone(),
        ..Variable::default()
    });
    let events = program.events.iter().enumerate().map(|(n, own)| Variable {
        name: plain(&own.name),
        reference: first.event + n,
        causality: "local",
        initial: "calculated",
        ..Variable::default()
    });
    let time = Variable {
        name: "time".to_owned(),
        causality: "independent",
        unit: "s".to_owned(),
        ..Variable::default()
    };
    let mut variables: Vec<Variable> = quantities(&program.parameters, first.parameter, ("parameter", f64::NAN))
        .chain(quantities(&program.inputs, first.input, ("input", 0.0)))
        .chain(of_states(states, &program.start, first))
        .chain(derivatives(states, first))
        .chain(outputs)
        .chain(events)
        // last, so that it makes way for a declared `time`
        .chain([time])
        .collect();
    let mut taken = BTreeSet::new();
    for variable in &mut variables {
        while !taken.insert(variable.name.clone()) {
            variable.name.push('_');
        }
    }
    variables
}

/// Parameters or inputs, with the start value of those without a default.
fn quantities(
    all: &[Quantity],
    first: usize,
    (causality, start): (&'static str, f64),
) -> impl Iterator<Item = Variable> {
    all.iter().enumerate().map(move |(n, own)| Variable {
        name: plain(&own.name),
        reference: first + n,
        causality,
        start: Some(own.default.unwrap_or(start)),
        unit: own.unit.clone(),
        docs: own.docs.clone(),
        ..Variable::default()
    })
}

fn of_states(states: &[State], start: &[f64], first: &References) -> impl Iterator<Item = Variable> {
    states.iter().zip(start).enumerate().map(|(n, (own, start))| {
        let of = states.iter().position(|other| other.derivative == Ok(n));
        Variable {
            name: own.name.clone(),
            reference: first.state + n,
            causality: "output",
            initial: if own.depends { "approx" } else { "exact" },
            start: Some(*start),
            unit: own.unit.clone(),
            docs: own.docs.clone(),
            derivative_of: of.map(|of| first.state + of),
        }
    })
}

/// Derivatives that are no states themselves.
fn derivatives(states: &[State], first: &References) -> impl Iterator<Item = Variable> {
    states.iter().enumerate().filter_map(|(n, own)| {
        let (name, unit) = own.derivative.clone().err()?;
        Some(Variable {
            name,
            reference: first.derivative + n,
            causality: "local",
            initial: "calculated",
            unit,
            derivative_of: Some(first.state + n),
            ..Variable::default()
        })
    })
}

/// States, in the order of the state vector.
pub(super) fn states(program: &Program) -> Vec<State> {
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

/// Name without the mark of a raw identifier.
fn plain(name: &str) -> String {
    name.trim_start_matches("r#").to_owned()
}

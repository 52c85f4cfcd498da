//! Routines for outputs and events.

use super::routine::{Argument, Head, Role, Shape};
use super::table::ROUTINES;
use crate::expr::{Expr, SymbolKind};
use crate::form::{self, Chosen, Forms};
use crate::model::{self, Model, Output, OutputShape};

/// Names of functions that a model may have beside its routines.
const OTHERS: [&str; 16] = [
    "new",
    "cast",
    "params",
    "with_params",
    "layout",
    "energy",
    "gather",
    "workspace",
    "series",
    "with_inputs",
    "with_law",
    "rhs_and_jacobian",
    "events",
    "outputs",
    "output_rates",
    "outputs_and_jacobian",
];

/// True if some model may have a function of this name, regardless of its declaration. Names of constraint routines
/// count only if `is_hybrid`.
pub(crate) fn is_function(name: &str, is_hybrid: bool) -> bool {
    let with = name.strip_suffix("_with").unwrap_or(name);
    let mut rows = ROUTINES.iter().filter(|row| is_hybrid || !row.is_of_constraints());
    OTHERS.contains(&with) || rows.any(|row| row.name == with)
}

/// Names of the functions of an output: its value, its rate, and its value with derivatives.
pub(crate) fn functions_of_output(name: &impl ToString) -> [String; 3] {
    let name = name.to_string();
    let plain = name.trim_start_matches("r#").to_owned();
    [name, format!("{plain}_rate"), format!("{plain}_and_jacobian")]
}

/// Function of a model whose zeros are events.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Event {
    /// Name of the event.
    pub name: String,
    /// True if the motion has a kink at the event, where a step should end.
    pub is_kink: bool,
}

impl Event {
    pub(super) fn of(event: &model::Event<'_>) -> Self {
        Self {
            name: event.name.clone(),
            is_kink: event.is_kink,
        }
    }
}

/// Name of the event at which `clamp` number `n` saturates.
pub(crate) fn saturation(n: usize) -> String {
    format!("saturation_{}", n + 1)
}

/// Names of the functions of an event: its value, and the event for a root search.
pub(crate) fn functions_of_event(name: &impl ToString) -> [String; 2] {
    let name = name.to_string();
    let plain = name.trim_start_matches("r#").to_owned();
    [name, format!("{plain}_event")]
}

/// Observed values: one output, or all of them.
pub(super) struct Observed<'g> {
    /// Names of the three functions.
    names: [String; 3],
    docs: String,
    /// Subject of a sentence: `` `height` ``.
    of_which: String,
    shape: Shape<usize>,
    values: Vec<Expr<'g>>,
}

/// Routines of the outputs and events of a model.
pub(super) fn routines<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Vec<(Head, Chosen<'g>)> {
    let mut routines = Vec::new();
    for observed in Observed::each_and_all(&model.outputs) {
        // the rate of a rate depends on the accelerations, and those on the inputs, as may the rate of a state
        let takes_inputs = !model.inputs.is_empty() && has_rates(model, &observed.values);
        let values = observed.values.clone();
        let chosen = [form::values, form::rates, form::values_and_jacobian].map(|form| form(forms, model, &values));
        routines.extend(
            observed
                .heads(takes_inputs, model.state().len())
                .into_iter()
                .zip(chosen),
        );
    }
    for event in &model.events {
        let head = Head::of_event(&event.name, &event.docs);
        routines.push((head, form::values(forms, model, &[event.value])));
    }
    routines
}

impl<'g> Observed<'g> {
    /// Each output, followed by all of them together. Empty if there are no outputs.
    pub(super) fn each_and_all(outputs: &[Output<'g>]) -> Vec<Self> {
        let mut each: Vec<Self> = outputs.iter().map(Self::one).collect();
        let values: Vec<Expr<'g>> = outputs.iter().flat_map(|output| output.values.clone()).collect();
        if !outputs.is_empty() {
            each.push(Self {
                names: ["outputs", "output_rates", "outputs_and_jacobian"].map(str::to_owned),
                docs: "All outputs, in the order of `OUTPUTS`.".to_owned(),
                of_which: "all outputs".to_owned(),
                shape: Shape::Vector(each.iter().map(|own| own.shape.len()).sum()),
                values,
            });
        }
        each
    }

    fn one(output: &Output<'g>) -> Self {
        let of_which = format!("`{}`", output.name.trim_start_matches("r#"));
        let first = format!("Output {of_which}.");
        Self {
            names: functions_of_output(&output.name),
            docs: [&[first][..], &output.docs].concat().join("\n"),
            of_which,
            shape: match output.shape {
                OutputShape::Scalar => Shape::Scalar,
                OutputShape::Vector(n) => Shape::Vector(n),
                OutputShape::Point => Shape::Vector(3),
                OutputShape::Rotation => Shape::Matrix(3, 3),
            },
            values: output.values.clone(),
        }
    }

    /// Functions for the values, for their rates, and for the values with their derivatives with respect to the state.
    pub(super) fn heads(self, takes_inputs: bool, state: usize) -> [Head; 3] {
        let Self {
            names: [own, rate, both],
            docs,
            of_which,
            shape,
            ..
        } = self;
        let of_rate = format!("Rate of {of_which} along the motion.");
        let of_both = format!(
            "Value of {of_which}, and its derivatives with respect to the state: one row for each component, \
             with the components of a matrix in column-major order."
        );
        let inputs = takes_inputs.then_some(Argument::Inputs).into_iter().collect();
        let jacobian = Shape::Matrix(shape.len(), state);
        [
            Head::of_function(own, docs, Vec::new(), vec![shape]),
            Head::of_function(rate, of_rate, inputs, vec![shape]),
            Head::of_function(both, of_both, Vec::new(), vec![shape, jacobian]),
        ]
    }
}

impl Head {
    /// Function whose zeros are an event.
    pub(super) fn of_event(name: &str, docs: &[String]) -> Self {
        let first = format!(
            "Function whose zeros are the event `{}`.",
            name.trim_start_matches("r#")
        );
        let docs = [&[first][..], docs].concat().join("\n");
        Self::of_function(name.to_owned(), docs, Vec::new(), vec![Shape::Scalar])
    }

    fn of_function(name: String, doc: String, arguments: Vec<Argument>, shapes: Vec<Shape<usize>>) -> Self {
        Self {
            name,
            role: Role::Function,
            doc,
            arguments,
            shapes,
        }
    }
}

/// True if expressions depend on rates or first-order states.
fn has_rates<'g>(model: &Model<'g>, values: &[Expr<'g>]) -> bool {
    let values = model.with_drives(values);
    let mut symbols = model.graph.symbols_of(&values);
    symbols.any(|symbol| matches!(symbol.kind, SymbolKind::Rate(_) | SymbolKind::State(_)))
}

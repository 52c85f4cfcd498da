//! Outputs and events as routines.

use super::routine::{Argument, Head, ROUTINES, Shape};
use crate::expr::{Expr, SymbolKind};
use crate::form::{self, Chosen, Forms};
use crate::model::{Model, Output, OutputShape};

/// Functions that every model may have beside its routines.
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

/// Whether a model may have a function of this name, whatever else its scene declares; some only where there are
/// constraints.
pub(crate) fn is_function(name: &str, is_hybrid: bool) -> bool {
    let with = name.strip_suffix("_with").unwrap_or(name);
    let mut rows = ROUTINES.iter().filter(|row| is_hybrid || !row.is_of_constraints());
    OTHERS.contains(&with) || rows.any(|row| row.name == with)
}

/// The functions of an output: its value, its rate, and both its value and its derivatives.
pub(crate) fn functions_of_output(name: &impl ToString) -> [String; 3] {
    let name = name.to_string();
    let plain = name.trim_start_matches("r#").to_owned();
    [name, format!("{plain}_rate"), format!("{plain}_and_jacobian")]
}

/// The functions of an event: its value, and what finds its zeros.
pub(crate) fn functions_of_event(name: &impl ToString) -> [String; 2] {
    let name = name.to_string();
    let plain = name.trim_start_matches("r#").to_owned();
    [name, format!("{plain}_event")]
}

/// Values of one kind: of an output, or of all of them.
struct Observed<'g> {
    /// The names of its three functions.
    names: [String; 3],
    docs: String,
    /// In a sentence: `` `height` ``.
    of_which: String,
    shape: Shape<usize>,
    values: Vec<Expr<'g>>,
}

/// The routines of the outputs and events of a model.
pub(super) fn routines<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Vec<(Head, Chosen<'g>)> {
    let mut routines = Vec::new();
    for observed in model.outputs.iter().map(Observed::one).chain(Observed::all(model)) {
        routines.extend(observed.routines(forms, model));
    }
    for event in &model.events {
        let first = format!("What passes zero at event `{}`.", event.name.trim_start_matches("r#"));
        let docs = [&[first][..], &event.docs].concat().join("\n");
        let head = head(event.name.clone(), docs, Vec::new(), vec![Shape::Scalar]);
        routines.push((head, form::values(forms, model, &[event.value])));
    }
    routines
}

impl<'g> Observed<'g> {
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

    /// All outputs together, if there are any.
    fn all(model: &Model<'g>) -> Option<Self> {
        let values: Vec<Expr<'g>> = model.outputs.iter().flat_map(|output| output.values.clone()).collect();
        (!values.is_empty()).then(|| Self {
            names: ["outputs", "output_rates", "outputs_and_jacobian"].map(str::to_owned),
            docs: "All outputs, in the order of `OUTPUTS`.".to_owned(),
            of_which: "all outputs".to_owned(),
            shape: Shape::Vector(values.len()),
            values,
        })
    }

    /// Values, rates, and values with their derivatives by the state.
    fn routines(self, forms: &mut Forms<'g>, model: &Model<'g>) -> [(Head, Chosen<'g>); 3] {
        let Self {
            names: [own, rate, both],
            docs,
            of_which,
            shape,
            values,
        } = self;
        let of_rate = format!("The rate of {of_which} along the motion.");
        let of_both = format!(
            "The value of {of_which}, and its derivatives by the state: a row for each component, column by column for a matrix."
        );
        // accelerations are in the rate of a rate, and what inputs do is in them
        let inputs = !model.inputs.is_empty() && has_rates(model, &values);
        let inputs = inputs.then_some(Argument::Inputs).into_iter().collect();
        let jacobian = Shape::Matrix(values.len(), model.state().len());
        [
            (
                head(own, docs, Vec::new(), vec![shape]),
                form::values(forms, model, &values),
            ),
            (
                head(rate, of_rate, inputs, vec![shape]),
                form::rates(forms, model, &values),
            ),
            (
                head(both, of_both, Vec::new(), vec![shape, jacobian]),
                form::values_and_jacobian(forms, model, &values),
            ),
        ]
    }
}

fn head(name: String, doc: String, arguments: Vec<Argument>, shapes: Vec<Shape<usize>>) -> Head {
    Head {
        name,
        doc,
        arguments,
        shapes,
    }
}

/// Whether expressions depend on the rates of the state.
fn has_rates<'g>(model: &Model<'g>, values: &[Expr<'g>]) -> bool {
    let values = model.with_drives(values);
    let mut symbols = model.graph.symbols_of(&values);
    symbols.any(|symbol| matches!(symbol.kind, SymbolKind::Rate(_)))
}

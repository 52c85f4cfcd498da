//! Outputs and events as routines.

use super::routine::{Argument, Head, ROUTINES, Shape};
use crate::expr::SymbolKind;
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

/// Whether a model may have a function of this name, whatever its scene declares.
pub(crate) fn is_function(name: &str) -> bool {
    let with = name.strip_suffix("_with").unwrap_or(name);
    OTHERS.contains(&with) || ROUTINES.iter().any(|row| row.name == with)
}

/// The functions of an output: its value, its rate, and both its value and its derivatives.
pub(crate) fn functions_of_output(name: &impl ToString) -> Vec<String> {
    let name = name.to_string();
    let plain = name.trim_start_matches("r#").to_owned();
    vec![name, format!("{plain}_rate"), format!("{plain}_and_jacobian")]
}

/// The functions of an event: its value, and what finds its zeros.
pub(crate) fn functions_of_event(name: &impl ToString) -> Vec<String> {
    let name = name.to_string();
    let plain = name.trim_start_matches("r#").to_owned();
    vec![name, format!("{plain}_event")]
}

/// The routines of the outputs and events of a model.
pub(super) fn routines<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Vec<(Head, Chosen<'g>)> {
    let mut routines = Vec::new();
    for output in &model.outputs {
        let names = functions_of_output(&output.name);
        let of_one = format!("`{}`", output.name.trim_start_matches("r#"));
        let docs = [vec![format!("Output {of_one}.")], output.docs.clone()]
            .concat()
            .join("\n");
        let outputs = std::slice::from_ref(output);
        routines.extend(family(forms, model, outputs, names, [docs, of_one]));
    }
    if !model.outputs.is_empty() {
        let names = ["outputs", "output_rates", "outputs_and_jacobian"]
            .map(str::to_owned)
            .into();
        let docs = "All outputs, in the order of `OUTPUTS`.".to_owned();
        routines.extend(family(
            forms,
            model,
            &model.outputs,
            names,
            [docs, "all outputs".to_owned()],
        ));
    }
    for event in &model.events {
        let plain = event.name.trim_start_matches("r#");
        let docs = [
            vec![format!("What passes zero at event `{plain}`.")],
            event.docs.clone(),
        ]
        .concat();
        let head = Head {
            name: event.name.clone(),
            doc: docs.join("\n"),
            arguments: Vec::new(),
            shapes: vec![Shape::Scalar],
        };
        routines.push((head, form::values(forms, model, &[event.value])));
    }
    routines
}

/// Values, rates, and values with their derivatives by the state.
fn family<'g>(
    forms: &mut Forms<'g>,
    model: &Model<'g>,
    outputs: &[Output<'g>],
    names: Vec<String>,
    [docs, of_which]: [String; 2],
) -> Vec<(Head, Chosen<'g>)> {
    let values: Vec<_> = outputs
        .iter()
        .flat_map(|output| output.values.iter().copied())
        .collect();
    let shape = match outputs {
        [one] if names[0] == one.name => match one.shape {
            OutputShape::Scalar => Shape::Scalar,
            OutputShape::Vector(n) => Shape::Vector(n),
            OutputShape::Place => Shape::Vector(3),
            OutputShape::Rotation => Shape::Matrix(3, 3),
        },
        _ => Shape::Vector(values.len()),
    };
    let rate = form::rates(forms, model, &values);
    let of_inputs = model.graph.reachable(&rate.roots).into_iter().any(|id| {
        model
            .graph
            .as_symbol(id)
            .is_some_and(|symbol| matches!(symbol.kind, SymbolKind::Input(_)))
    });
    let docs = [
        docs,
        format!("The rate of {of_which} along the motion."),
        format!(
            "The value of {of_which}, and its derivatives by the state: a row for each component, in the order of columns for a matrix."
        ),
    ];
    let chosen = [
        form::values(forms, model, &values),
        rate,
        form::values_and_jacobian(forms, model, &values),
    ];
    let arguments = [vec![], if of_inputs { vec![Argument::Inputs] } else { vec![] }, vec![]];
    let shapes = [
        vec![shape],
        vec![shape],
        vec![shape, Shape::Matrix(values.len(), model.state().len())],
    ];
    let heads = names.into_iter().zip(docs).zip(arguments.into_iter().zip(shapes));
    let heads = heads.map(|((name, doc), (arguments, shapes))| Head {
        name,
        doc,
        arguments,
        shapes,
    });
    heads.zip(chosen).collect()
}

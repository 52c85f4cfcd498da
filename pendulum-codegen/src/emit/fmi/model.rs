//! The header that describes a model to the functions of FMI.

use super::super::c::names::function;
use super::super::c::template::{fill, lines};
use crate::program::{Program, Role};

/// Prints the header, for a model whose functions have a prefix.
pub(super) fn model(program: &Program, name: &str, token: &str) -> String {
    let layout = &program.layout;
    let has = |role| program.with_role(role).is_some();
    let (inputs, outputs) = (program.inputs.len(), program.outputs.len());
    let (loops, turns, gaps) = (program.loops.len(), program.uncounted.len(), program.open_loops.len());
    let counts = counts(program);
    let most = counts[..5].iter().map(|(_, count)| *count).max().unwrap_or_default();
    // calls of functions that take the inputs
    let (given, argument) = match inputs {
        0 => (String::new(), ""),
        _ => {
            let values = list((0..inputs).map(|n| format!("u[{n}]")));
            (format!("const {name}_inputs given = {{{values}}};\n"), "&given, ")
        }
    };
    let call = |function: &str, arguments: &str| format!("{name}_{function}(m, t, x, {arguments});\n");
    let when = |holds: bool, code: String| if holds { code } else { String::new() };
    let events = program.events.iter().enumerate();
    let events = events.map(|(n, event)| format!("out[{n}] = {name}_{}(m, t, x);", function(&event.name)));
    let derivatives = [
        given.clone(),
        "double rates[LENGTH(STATES)], values[LENGTH(OUTPUTS)];\n(void)rates, (void)values;\n".to_owned(),
        call("rhs_and_jacobian", &format!("{argument}rates, by_state")),
        when(inputs > 0, call("input_jacobian", &format!("{argument}by_inputs"))),
        when(outputs > 0, call("outputs_and_jacobian", "values, of_outputs")),
    ];
    let corrects = has(Role::LoopCorrections);
    let of_loops = when(loops > 0, call("loop_margins", "out, out + MARGINS"));
    let of_turns = call("turn_margins", &format!("out + {loops}, out + MARGINS + {loops}"));
    let mut values = counts.map(|(key, count)| (key, count.to_string())).to_vec();
    values.extend([
        ("name", name.to_owned()),
        ("scene", program.name.clone()),
        ("token", token.to_owned()),
        ("most", most.to_string()),
        ("start", list(starts(program))),
        (
            "quaternion_places",
            list(layout.quaternions().map(|places| places.start.to_string())),
        ),
        (
            "dependent_places",
            list(layout.dependents().map(|place| place.to_string())),
        ),
        ("margin_names", list(margin_names(program))),
        ("params", list((0..program.parameters.len()).map(|n| format!("p[{n}]")))),
        ("rhs", given + &call("rhs", &format!("{argument}out"))),
        ("outputs_code", when(outputs > 0, call("outputs", "out"))),
        ("events_code", lines(events)),
        ("derivatives", when(has(Role::Jacobian), derivatives.concat())),
        ("project", project(program, name)),
        ("corrections", when(corrects, call("loop_corrections", "out"))),
        (
            "gaps_code",
            when(gaps > 0, call("loop_gaps", "out, out + GAPS, out + 2 * GAPS")),
        ),
        ("margins_code", of_loops + &when(turns > 0, of_turns)),
    ]);
    fill(include_str!("templates/fmi3-model.h"), &values)
}

/// Sizes of the model.
fn counts(program: &Program) -> [(&'static str, usize); 10] {
    let layout = &program.layout;
    [
        ("parameters", program.parameters.len()),
        ("inputs", program.inputs.len()),
        ("states", layout.len()),
        ("outputs", program.outputs.len()),
        ("events", program.events.len()),
        ("quaternions", layout.quaternions().count()),
        ("dependents", layout.dependents().count()),
        ("gaps", program.open_loops.len()),
        ("margins", program.loops.len() + program.uncounted.len()),
        ("has_jacobian", usize::from(program.with_role(Role::Jacobian).is_some())),
    ]
}

/// Call of the projection onto the invariants of the state, if there are any.
fn project(program: &Program, name: &str) -> String {
    let has_quaternions = program.layout.quaternions().next().is_some();
    match (program.with_role(Role::LoopCorrections), has_quaternions) {
        (Some(_), _) => format!("{name}_project(m, t, x);\n"),
        (None, true) => format!("{name}_project(x);\n"),
        (None, false) => String::new(),
    }
}

/// Start values of the parameters and of the state.
fn starts(program: &Program) -> impl Iterator<Item = String> {
    let starts = program.parameters.iter().map(|p| p.default.unwrap_or(f64::NAN));
    starts.chain(program.start.iter().copied()).map(literal)
}

/// Names of what has a margin, for messages, as literals.
fn margin_names(program: &Program) -> impl Iterator<Item = String> {
    let loops = program
        .loops
        .iter()
        .map(|[a, b]| format!("the loop of `{a}` and `{b}`"));
    let angles = program
        .uncounted
        .iter()
        .map(|name| format!("the angle `{name}`, whose turns are not counted,"));
    loops.chain(angles).map(|name| format!("{name:?}"))
}

/// Elements of an array. C has none without elements.
fn list(elements: impl Iterator<Item = String>) -> String {
    let elements: Vec<String> = elements.collect();
    match elements.is_empty() {
        true => "0".to_owned(),
        false => elements.join(", "),
    }
}

fn literal(value: f64) -> String {
    if value.is_nan() {
        "NAN".to_owned()
    } else {
        format!("{value:?}")
    }
}

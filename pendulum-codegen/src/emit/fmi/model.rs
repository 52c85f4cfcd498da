//! The header that describes a model to the functions of FMI.

use super::super::c::names::function;
use super::super::c::template::{fill, lines};
use crate::program::{Program, Role};

/// Prints the header, for a model whose functions have a prefix.
pub(super) fn model(program: &Program, name: &str, token: &str) -> String {
    let layout = &program.layout;
    let has = |role| program.with_role(role).is_some();
    let (inputs, outputs) = (program.inputs.len(), program.outputs.len());
    let (loops, turns) = (program.loops.len(), program.uncounted.len());
    let (margins, gaps) = (loops + turns, program.open_loops.len());
    let counts = [
        ("parameters", program.parameters.len()),
        ("inputs", inputs),
        ("states", layout.len()),
        ("outputs", outputs),
        ("events", program.events.len()),
        ("quaternions", layout.quaternions().count()),
        ("dependents", layout.dependents().count()),
        ("gaps", gaps),
        ("margins", margins),
        ("has_jacobian", usize::from(has(Role::Jacobian))),
    ];
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
    let project = match (corrects, layout.quaternions().next().is_some()) {
        (true, _) => format!("{name}_project(m, t, x);\n"),
        (false, true) => format!("{name}_project(x);\n"),
        (false, false) => String::new(),
    };
    let of_loops = when(loops > 0, call("loop_margins", "out, out + MARGINS"));
    let of_turns = call("turn_margins", &format!("out + {loops}, out + MARGINS + {loops}"));
    let starts = program.parameters.iter().map(|p| p.default.unwrap_or(f64::NAN));
    let starts = starts.chain(program.start.iter().copied()).map(literal);
    let names = program
        .loops
        .iter()
        .map(|[a, b]| format!("the loop of `{a}` and `{b}`"));
    let names = names.chain(
        program
            .uncounted
            .iter()
            .map(|name| format!("the angle `{name}`, whose turns are not counted,")),
    );
    let mut values = counts.map(|(key, count)| (key, count.to_string())).to_vec();
    values.extend([
        ("name", name.to_owned()),
        ("scene", program.name.clone()),
        ("token", token.to_owned()),
        ("most", most.to_string()),
        ("start", list(starts)),
        (
            "quaternion_places",
            list(layout.quaternions().map(|places| places.start.to_string())),
        ),
        (
            "dependent_places",
            list(layout.dependents().map(|place| place.to_string())),
        ),
        (
            "margin_names",
            match margins {
                0 => "0".to_owned(),
                _ => list(names.map(|name| format!("{name:?}"))),
            },
        ),
        ("params", list((0..program.parameters.len()).map(|n| format!("p[{n}]")))),
        ("rhs", given + &call("rhs", &format!("{argument}out"))),
        ("outputs_code", when(outputs > 0, call("outputs", "out"))),
        ("events_code", lines(events)),
        ("derivatives", when(has(Role::Jacobian), derivatives.concat())),
        ("project", project),
        ("corrections", when(corrects, call("loop_corrections", "out"))),
        (
            "gaps_code",
            when(gaps > 0, call("loop_gaps", "out, out + GAPS, out + 2 * GAPS")),
        ),
        ("margins_code", of_loops + &when(turns > 0, of_turns)),
    ]);
    fill(include_str!("templates/fmi3-model.h"), &values)
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

//! A program as a tape: lists of operations, as text, which `pendulum_core::tape` runs without a compiler.

mod code;

use code::Code;

use crate::program::{Argument, Block, Condition, Constraint, Program, Quantity, Routine, Rule, Shape, Slot, SlotKind};

/// Version of the format.
const VERSION: usize = 2;

/// Prints a program as a tape, which the module `tape` of the crate `pendulum-core` runs without a compiler. Results
/// equal those of the Rust code bit for bit.
///
/// A tape is text. Each line has a keyword and fields, separated by tabs; numbers in a field are separated by spaces.
/// Its first line has the version of the format. Lines of the model follow: its parameters, inputs, state, constraints
/// and so on. Then come its routines, as operations on numbered registers: `mul_add` with the registers `7 1 2 3` sets
/// register 7 to the product of registers 1 and 2 plus register 3. Some operations join two, such as
/// `mul_add_then_mul_add`, so that the value between them needs no register.
pub fn tape(program: &Program) -> String {
    let slots = program.layout.slots.iter().map(slot);
    let states = program.layout.states.iter();
    let states = states.map(|state| line(&["state", &state.name, &state.unit]));
    let autonomous = program.layout.autonomous.then(|| line(&["autonomous"]));
    let routines = program.routines.iter().map(routine);
    let loops = program.loops.iter().map(|[a, b]| line(&["loop", a, b]));
    let head = [
        line(&["pendulum tape", &VERSION.to_string()]),
        line(&["name", &program.name]),
    ];
    let texts = |keyword, names: &[String]| -> String { names.iter().map(|name| line(&[keyword, name])).collect() };
    let events = program.events.iter();
    let events = events.map(|event| line(&["event", &event.name, if event.is_kink { "kink" } else { "smooth" }]));
    let parts: [String; 16] = [
        head.concat(),
        program
            .parameters
            .iter()
            .map(|own| quantity("parameter", own))
            .collect(),
        program.inputs.iter().map(|own| quantity("input", own)).collect(),
        slots.chain(states).chain(autonomous).collect(),
        loops.collect(),
        line(&["open_loops", &list(&program.open_loops)]),
        texts("uncounted", &program.uncounted),
        texts("output", &program.outputs),
        events.collect(),
        program.constraints.iter().map(constraint).collect(),
        program.rules.iter().map(rule).collect(),
        texts("constant", &program.constants_text),
        code("checked", &program.checked) + &code("constants", &program.constants) + &code("laws", &program.laws),
        routines.collect(),
        series(program),
        drawing(program),
    ];
    parts.concat()
}

/// Fields, separated by tabs. A field has no tabs and line breaks of its own.
fn line(fields: &[&str]) -> String {
    let fields: Vec<String> = fields
        .iter()
        .map(|field| field.replace(['\t', '\n', '\r'], " "))
        .collect();
    fields.join("\t") + "\n"
}

fn list(numbers: &[usize]) -> String {
    let numbers: Vec<String> = numbers.iter().map(usize::to_string).collect();
    numbers.join(" ")
}

fn quantity(keyword: &str, own: &Quantity) -> String {
    let default = own.default.map(|value| format!("{value:?}")).unwrap_or_default();
    line(&[keyword, &own.name, &own.unit, &default])
}

fn slot(slot: &Slot) -> String {
    let kind = match slot.kind {
        SlotKind::Angle => "angle",
        SlotKind::Length => "length",
        SlotKind::Quaternion => "quaternion",
    };
    let symmetries = [(slot.periodic, "periodic"), (slot.cyclic, "cyclic")];
    let symmetries = symmetries.iter().filter(|(holds, _)| *holds).map(|(_, name)| *name);
    let [positions, rates] = [&slot.positions, &slot.rates].map(|range| list(&[range.start, range.end]));
    line(&[
        "slot",
        &slot.name,
        kind,
        &positions,
        &rates,
        &symmetries.collect::<Vec<_>>().join(" "),
    ])
}

fn constraint(own: &Constraint) -> String {
    let limits = [(own.low, "low"), (own.high, "high")];
    let limits = limits.iter().filter(|(exists, _)| *exists).map(|(_, name)| *name);
    let rate = own.rate.iter().map(|(component, sign)| format!("{component} {sign}"));
    line(&[
        "constraint",
        &own.name,
        &rate.collect::<Vec<_>>().join(" "),
        &limits.collect::<Vec<_>>().join(" "),
    ])
}

fn rule(rule: &Rule) -> String {
    let value = rule.value;
    let (condition, values) = match rule.condition {
        Condition::Positive => ("positive", vec![value]),
        Condition::NonNegative => ("non_negative", vec![value]),
        Condition::NonNegativeWithin(scale) => ("non_negative_within", vec![value, scale]),
    };
    line(&[
        "rule",
        condition,
        &list(&values),
        &rule.name,
        &rule.text,
        &list(&rule.parameters),
    ])
}

fn code(name: &str, block: &Block) -> String {
    line(&["code", name]) + &Code::new(block).lines()
}

fn routine(routine: &Routine) -> String {
    let arguments = routine.arguments.iter().map(|argument| match argument {
        Argument::Inputs => "inputs",
        Argument::Accelerations => "accelerations",
        Argument::Forces => "forces",
        Argument::Weights => "weights",
        Argument::Direction => "direction",
    });
    let shapes = routine.shapes.iter().map(|shape| match shape {
        Shape::Scalar => "scalar".to_owned(),
        Shape::Vector(n) => format!("vector {n}"),
        Shape::Matrix(n, m) => format!("matrix {n} {m}"),
        Shape::Symmetric(n) => format!("symmetric {n}"),
    });
    let (arguments, shapes) = (arguments.collect::<Vec<_>>(), shapes.collect::<Vec<_>>());
    line(&["routine", &routine.name, &arguments.join(" "), &shapes.join(", ")]) + &Code::new(&routine.block).lines()
}

/// Outlines, and the code of their points and radii.
fn drawing(program: &Program) -> String {
    let Some(drawing) = &program.drawing else {
        return String::new();
    };
    let outlines = drawing.outlines.iter().map(|outline| {
        let kind = format!("{:?}", outline.kind);
        let radius = if outline.radius { "radius" } else { "" };
        let points = outline.points.to_string();
        line(&["outline", &outline.name, &outline.body, &kind, &points, radius])
    });
    outlines.collect::<String>() + &code("drawing", &drawing.block)
}

fn series(program: &Program) -> String {
    let Some(series) = &program.series else {
        return String::new();
    };
    let sizes = line(&["series", &series.products.to_string(), &series.kept.to_string()]);
    let carried = series
        .before
        .results
        .get(program.constraints.len()..)
        .unwrap_or_default();
    let codes = [
        Code::new(&series.start),
        Code::new(&series.before),
        Code::after(&series.order, carried),
    ];
    sizes + &codes.map(|code| code.lines()).concat()
}

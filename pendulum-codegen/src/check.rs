//! Physical checks of the whole model.

use rustc_hash::FxHashSet;

use crate::dynamics::{Dynamics, Entries, derived};
use crate::error::{Code, Errors};
use crate::expr::{ExprId, Normalizer, SymbolKind, vanishing_pivot};
use crate::lower::Spans;
use crate::model::{CoordinateId, Model};

/// Checks the model: rejects a mass matrix that is singular in every state for all parameters, walls whose gap cannot
/// change, and parameters and inputs without effect. New errors are added to `errors`.
pub(crate) fn check(
    model: &Model<'_>,
    spans: &Spans,
    dynamics: &Dynamics<'_>,
    mut errors: Errors,
) -> Result<(), Errors> {
    if needs_inertia(model)
        && let Some(k) = vanishing_pivot(&dynamics.balance.mass_matrix, &model.quaternions()).map(CoordinateId::new)
        && let Some(n) = model.bodies.iter().position(|body| body.coordinate == Some(k))
    {
        let (body, coordinate) = (&model.bodies[n], &model.coordinates[k].name);
        let fact = match coordinate.split_once('.').filter(|_| body.spin.is_some()) {
            Some((orientation, axis)) => format!(
                "the orientation `{orientation}` has no inertia about {axis}, \
                 so the mass matrix is singular in every state"
            ),
            None => format!("coordinate `{coordinate}` has no inertia, so the mass matrix is singular in every state"),
        };
        let name = &body.name;
        let help = if body.spin.is_some() {
            format!(
                "give `{name}` an `inertia` about all axes, or solids that have one: \
                 a point has none, and a rod none along itself"
            )
        } else if body.inertia.mass.is_zero() && errors.is_in_file(spans.bodies[n]) {
            format!(
                "write `repair` after the path to fix joints that move no mass, or change `body {name}` in the \
                 scene: give it mass or make the joint `fixed`"
            )
        } else if body.inertia.mass.is_zero() {
            format!("give `{name}` mass or make the joint `fixed`")
        } else {
            format!(
                "other joints move the mass of `{name}` in the same way as its own joint: check the position of its \
                 mass, and its joint axis"
            )
        };
        errors.at(Code::SingularMassMatrix, spans.bodies[n], fact, help);
    }
    report_walls(model, spans, &mut errors);
    if errors.is_empty() {
        report_without_effect(model, spans, dynamics, &mut errors);
    }
    errors.finish(())
}

/// Reports walls whose gap depends on no coordinate.
fn report_walls(model: &Model<'_>, spans: &Spans, errors: &mut Errors) {
    /// Maximum number of products of terms in the normal form of a derivative.
    const BUDGET: usize = 10_000;
    let walls = model
        .constraints
        .iter()
        .filter(|constraint| constraint.coordinate.is_none());
    for (wall, &span) in walls.zip(&spans.walls) {
        let vanishes = |x| Normalizer::new(model.graph, BUDGET).is_zero(x) == Ok(true);
        let slopes = derived(&[wall.value], &model.positions());
        if slopes.concat().into_iter().all(vanishes) {
            let fact = format_args!(
                "the gap of wall `{}` depends on no coordinate, so no force can keep it open",
                wall.name
            );
            errors.at(
                Code::NoGap,
                span,
                fact,
                "build it from coordinates, or from points whose positions depend on coordinates",
            );
        }
    }
}

/// True if the generated code needs accelerations: for any routine but `shapes`, or for an output that contains a rate.
fn needs_inertia(model: &Model<'_>) -> bool {
    let outputs = model.outputs.iter().flat_map(|output| output.values.iter().copied());
    let outputs: Vec<_> = outputs.collect();
    let mut symbols = model.graph.symbols_of(&outputs);
    model.generate.iter().any(|word| *word != "shapes") || symbols.any(|s| matches!(s.kind, SymbolKind::Rate(_)))
}

/// Reports parameters and inputs that affect no equation of motion, energy, output, event or constraint, and no check
/// of the parameters.
fn report_without_effect(model: &Model<'_>, spans: &Spans, dynamics: &Dynamics<'_>, errors: &mut Errors) {
    let checked = model.rules.iter().map(|rule| rule.value);
    let outputs = model.outputs.iter().flat_map(|output| output.values.iter().copied());
    let drawn = model.points.iter().filter(|_| model.generate.contains("shapes"));
    let observed = outputs
        .chain(drawn.flat_map(|point| point.place.at.0))
        .chain(model.events.iter().map(|event| event.value))
        .chain(
            model
                .constraints
                .iter()
                .flat_map(|c| [vec![c.value], c.law.numbers()].concat()),
        )
        .collect::<Vec<_>>();
    let mut dynamics = dynamics.clone();
    if !model.generate.contains("drive_forces") {
        dynamics.reactions.drive.clear();
    }
    let roots = dynamics.entries().into_iter().chain(checked).chain(model.state_rates());
    let roots: Vec<_> = roots.chain(model.with_drives(&observed)).collect();
    let roots = model.written_out(&roots);
    let read: FxHashSet<ExprId> = model.graph.reachable(&roots).into_iter().collect();
    let parameters = model.parameters.iter().map(|p| ("parameter", &p.name, p.symbol));
    let inputs = model.inputs.iter().map(|input| ("input", &input.name, input.symbol));
    let spans = spans.parameters.iter().chain(&spans.inputs);
    for ((kind, name, symbol), span) in parameters.chain(inputs).zip(spans) {
        if !read.contains(&symbol.id()) {
            let fact = format_args!("{kind} `{name}` has no effect");
            let help =
                "it drops out of the equations of motion: remove it, or check the axes and points where it is used";
            errors.at(Code::Unused, *span, fact, help);
        }
    }
}

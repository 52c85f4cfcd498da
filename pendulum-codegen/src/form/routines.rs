//! Expressions computed by each routine: one function for each row of the table of routines.

use rustc_hash::FxHashMap;

use super::{Chosen, Forms};
use crate::dynamics::{self, Balance, Reactions, derived};
use crate::expr::Expr;
use crate::model::{Gap, Model};

/// Position rates, accelerations and rates of the first-order states.
pub(crate) fn rhs<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let (known, dependent) = kinematics(model);
    let beside = [&dependent[..], &model.state_rates()].concat();
    let chosen = forms.accelerations_and(&beside);
    chosen
        .with(|mut accelerations| {
            let mut rates = accelerations.split_off(model.dof());
            let of_states = rates.split_off(dependent.len());
            [known, rates, accelerations, of_states].concat()
        })
        .counted(model)
}

/// Rates of the positions: first those given directly by the rates of the state, then those of dependent coordinates.
pub(super) fn kinematics<'g>(model: &Model<'g>) -> (Vec<Expr<'g>>, Vec<Expr<'g>>) {
    let mut known = model.kinematics();
    let dependent = known.split_off(known.len() - model.in_state().count());
    (known, dependent)
}

/// Right-hand side, followed by its derivatives with respect to the state, column by column.
pub(crate) fn jacobian<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let state = model.state();
    let (known, dependent) = kinematics(model);
    let beside = [&dependent[..], &model.state_rates()].concat();
    let with_derivatives = [beside.clone(), derived(&beside, &state).concat()].concat();
    let chosen = forms.jacobian(model, &state, true, &with_derivatives);
    let chosen = chosen.with(|mut accelerations| {
        let mut columns = accelerations.split_off(model.dof());
        let mut rates = columns.split_off(state.len() * model.dof());
        let of_rates = rates.split_off(beside.len());
        let of_states = rates.split_off(dependent.len());
        let columns = stacked(model, &derived(&known, &state), &columns, &of_rates);
        [known, rates, accelerations, of_states, columns].concat()
    });
    chosen.counted(model)
}

/// Margin of each closed loop from its singularity (toggle), followed by the rates of the margins.
pub(crate) fn loop_margins<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    super::values_and_rates(forms, model, &model.loops.margins)
}

/// Margin of each uncounted angle from the point where its turns would have to be counted, followed by the rates of the
/// margins.
pub(crate) fn turn_margins<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let margins: Vec<Expr<'g>> = model.loops.uncounted.iter().map(|own| own.margin).collect();
    super::values_and_rates(forms, model, &margins)
}

/// Newton corrections of the dependent coordinates in the state.
pub(crate) fn loop_corrections<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    super::values(forms, model, &model.loops.corrections)
}

/// Closure errors of the loops: distances, then angles, then sizes.
pub(crate) fn loop_gaps<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let part = |part: fn(&Gap<'g>) -> Expr<'g>| model.loops.gaps.iter().map(part);
    let parts = part(|gap| gap.distance)
        .chain(part(|gap| gap.angle))
        .chain(part(|gap| gap.size));
    super::as_declared(forms, model, &parts.collect::<Vec<_>>())
}

/// Derivative of the right-hand side with respect to time.
pub(crate) fn time_derivative<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    by(forms, model, &[model.time])
}

/// Derivatives of the right-hand side with respect to the inputs, column by column.
pub(crate) fn input_jacobian<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    by(forms, model, &model.input_symbols())
}

fn by<'g>(forms: &mut Forms<'g>, model: &Model<'g>, variables: &[Expr<'g>]) -> Chosen<'g> {
    let (known, dependent) = kinematics(model);
    let beside = [dependent, model.state_rates()].concat();
    let chosen = forms.jacobian(model, variables, false, &derived(&beside, variables).concat());
    chosen.with(|mut columns| {
        let of_rates = columns.split_off(variables.len() * model.dof());
        stacked(model, &derived(&known, variables), &columns, &of_rates)
    })
}

/// Derivatives of the right-hand side with respect to the parameters, column by column. The constraint forces follow
/// the friction law of the right-hand side.
pub(crate) fn parameter_jacobian<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let parameters: Vec<Expr<'g>> = model.parameters.iter().map(|parameter| parameter.symbol).collect();
    let (forces, dof) = (model.force_symbols(), model.dof());
    let slopes = derived(&model.with_friction(&forces), &parameters);
    let (known, dependent) = kinematics(model);
    let beside = [dependent, model.state_rates()].concat();
    let [known, beside] = [known, beside].map(|rows| derived(&rows, &parameters));
    forms.solutions(model, &[&parameters[..], &forces].concat(), |way| {
        let (fixed, by_forces) = way.columns.split_at(parameters.len() * dof);
        let columns = slopes.iter().enumerate().flat_map(|(n, slopes)| {
            (0..dof).map(move |row| {
                let of_forces = slopes.iter().enumerate();
                of_forces.fold(fixed[n * dof + row], |sum, (force, &slope)| {
                    sum + by_forces[force * dof + row] * slope
                })
            })
        });
        let columns = stacked(model, &known, &columns.collect::<Vec<_>>(), &beside.concat());
        model.with_friction(&columns)
    })
}

/// Kinetic energy.
pub(crate) fn kinetic<'g>(forms: &mut Forms<'g>, _: &Model<'g>) -> Chosen<'g> {
    forms.term(|lagrangian| vec![lagrangian.kinetic])
}

/// Potential energy.
pub(crate) fn potential<'g>(forms: &mut Forms<'g>, _: &Model<'g>) -> Chosen<'g> {
    forms.term(|lagrangian| vec![lagrangian.potential])
}

/// Upper triangle of the mass matrix, row by row.
pub(crate) fn mass_matrix<'g>(forms: &mut Forms<'g>, _: &Model<'g>) -> Chosen<'g> {
    forms.of_balance(Balance::upper_triangle)
}

/// Bias forces.
pub(crate) fn bias<'g>(forms: &mut Forms<'g>, _: &Model<'g>) -> Chosen<'g> {
    forms.term(|lagrangian| lagrangian.bias.clone())
}

/// Momenta of the coordinates.
pub(crate) fn momentum<'g>(forms: &mut Forms<'g>, _: &Model<'g>) -> Chosen<'g> {
    forms.term(|lagrangian| lagrangian.momentum.clone())
}

/// Generalised forces required for given accelerations.
pub(crate) fn inverse_dynamics<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    // inputs and constraint forces are results of inverse dynamics, not arguments
    let zero = model.graph.zero();
    let given = model.input_symbols().into_iter().chain(model.force_symbols());
    let without: FxHashMap<_, _> = given.map(|symbol| (symbol, zero)).collect();
    forms.of_balance(|balance| model.graph.substitute(&balance.rows, without.clone()))
}

/// Forces supplied by the drives.
pub(crate) fn drive_forces<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    along_motion(forms, model, |reactions| reactions.drive.clone())
}

/// Wrenches of the joints that close loops.
pub(crate) fn loop_wrenches<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    along_motion(forms, model, |reactions| {
        dynamics::loop_wrenches(model, reactions.held.clone())
    })
}

/// Forces at the accelerations of the right-hand side, with constraint forces that follow its friction law.
fn along_motion<'g>(
    forms: &mut Forms<'g>,
    model: &Model<'g>,
    forces: impl Fn(&Reactions<'g>) -> Vec<Expr<'g>>,
) -> Chosen<'g> {
    let symbols = model.coordinates.iter().map(|c| c.acceleration);
    let solved: FxHashMap<_, _> = symbols.zip(forms.accelerations().roots).collect();
    forms.of_reactions(|reactions| {
        let forces = model.graph.substitute(&forces(reactions), solved.clone());
        model.with_friction(&forces)
    })
}

/// Positions and momenta, followed by the rates of both.
pub(crate) fn canonical<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let chosen = forms.canonical(model);
    chosen.with(|mut momenta| {
        let rates = momenta.split_off(model.dof());
        [model.positions(), momenta, model.kinematics(), rates].concat()
    })
}

/// Derivatives of the canonical variables with respect to the state, column by column, followed by those of their
/// rates.
pub(crate) fn canonical_jacobian<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let state = model.state();
    let chosen = forms.canonical_jacobian(model);
    chosen.with(|mut momenta| {
        let rates = momenta.split_off(state.len() * model.dof());
        let [positions, kinematics] = [model.positions(), model.kinematics()].map(|rows| derived(&rows, &state));
        [
            stacked(model, &positions, &momenta, &[]),
            stacked(model, &kinematics, &rates, &[]),
        ]
        .concat()
    })
}

/// Stacks blocks of columns in the order of the state: `known`, the rates of positions that are given directly; those
/// of dependent coordinates, the first rows of `beside`; `accelerations`; and those of first-order states, the other
/// rows of `beside`.
pub(super) fn stacked<'g>(
    model: &Model<'g>,
    known: &[Vec<Expr<'g>>],
    accelerations: &[Expr<'g>],
    beside: &[Expr<'g>],
) -> Vec<Expr<'g>> {
    let (dof, rows) = (model.dof(), beside.len() / known.len().max(1));
    let dependent = rows.saturating_sub(model.states.len());
    let column = |(n, known): (usize, &Vec<Expr<'g>>)| {
        let (of_dependent, of_states) = beside[n * rows..(n + 1) * rows].split_at(dependent);
        let accelerations = &accelerations[n * dof..(n + 1) * dof];
        [known, of_dependent, accelerations, of_states].concat()
    };
    known.iter().enumerate().flat_map(column).collect()
}

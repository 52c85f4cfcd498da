//! Response to constraint forces, from one factored mass matrix with the constraint gradients as further right-hand
//! sides.

use rustc_hash::FxHashMap;

use super::routines::stacked;
use super::solved::{Way, of_coordinates};
use super::{Basis, Candidate, Chosen, Form, Forms, expanded};
use crate::dynamics::{Entries, Inverse, derived};
use crate::expr::{Derivative, Expr, Normalizer};
use crate::model::{Coordinate, CoordinateId, Floating, Model, changes};

/// Coefficients of the constraints' second derivatives `J qdd + h`, where the rates are `J qd + w`.
#[derive(Clone, Debug)]
pub(super) struct Rows<'g> {
    /// Rows of `J`: gradients with respect to the coordinates.
    gradients: Vec<Vec<Expr<'g>>>,
    /// Entries of `h`: second derivatives at zero acceleration of the coordinates.
    drifts: Vec<Expr<'g>>,
}

impl<'g> Rows<'g> {
    pub(super) fn new(model: &Model<'g>) -> Self {
        let values = model.constraint_values();
        let along = |k: usize| {
            let mut along = model.along(CoordinateId::new(k));
            values.iter().map(|&value| along.of(value)).collect()
        };
        let gradients: Vec<Vec<Expr<'g>>> = (0..model.dof()).map(along).collect();
        let rates = model.constraint_rates();
        let still = |(k, c): (usize, &Coordinate<'g>)| (c.rate, model.driven_acceleration(CoordinateId::new(k)));
        let directions = changes(model.all_coordinates())
            .into_iter()
            .chain(model.all_coordinates().enumerate().map(still));
        let mut along = Derivative::along(directions.chain([(model.time, model.graph.one())]));
        let drifts: Vec<Expr<'g>> = rates.into_iter().map(|rate| along.of(rate)).collect();
        let gradient = |n: usize| gradients.iter().map(|column| column[n]).collect::<Vec<_>>();
        Self {
            gradients: (0..values.len()).map(|n| model.with_drives(&gradient(n))).collect(),
            drifts: model.with_drives(&drifts),
        }
    }

    /// Copies in the form of each basis of the dynamics; the first one is as it was built.
    fn on_each_basis(self, forms: &mut Forms<'g>) -> Vec<(Basis, Self)> {
        let written = forms.forms.iter().chain(&forms.oriented);
        let mut all = vec![(Basis::Shared, self)];
        for basis in written.map(|written| written.form.basis) {
            if matches!(basis, Basis::Closed(_)) && all.iter().all(|(known, _)| *known != basis) {
                all.push((basis, all[0].1.on(&mut forms.normalizer, basis)));
            }
        }
        all
    }

    /// Copy in the form of a basis.
    fn on(&self, normalizer: &mut Normalizer<'g>, basis: Basis) -> Self {
        let columns = [&self.gradients[..], std::slice::from_ref(&self.drifts)].concat();
        let short = match basis {
            Basis::Closed(products) => expanded(normalizer, &columns, products),
            _ => None,
        };
        let mut gradients = short.unwrap_or(columns);
        let drifts = gradients.pop().unwrap_or_default();
        Self { gradients, drifts }
    }

    /// Second derivatives `J qdd + h` of the constraints at given accelerations.
    pub(super) fn accelerations(&self, of_state: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let rows = self.gradients.iter().zip(&self.drifts);
        rows.map(|(gradient, &drift)| dot(gradient, of_state) + drift).collect()
    }

    /// Right-hand side and second derivatives of the constraints at given accelerations, then the change of each for a
    /// unit of every constraint force. The changes of the second derivatives are an upper triangle.
    fn response(
        &self,
        model: &Model<'g>,
        floating: &[Floating<'g>],
        mobility: &dyn Inverse<'g>,
        accelerations: &[Expr<'g>],
    ) -> Vec<Expr<'g>> {
        let positions = model.kinematics();
        let still = vec![model.graph.zero(); positions.len()];
        let column = |gradient: &Vec<Expr<'g>>| {
            let mut against: Vec<Expr<'g>> = gradient.iter().map(|&x| -x).collect();
            floating.iter().for_each(|joint| joint.turn_forces(&mut against));
            let mut column = mobility.solve_negated(&against);
            floating
                .iter()
                .for_each(|joint| joint.differentiate(&mut column, &still));
            column
        };
        let columns: Vec<Vec<Expr<'g>>> = self.gradients.iter().map(column).collect();
        let mut roots = [&positions, accelerations, &model.state_rates()].concat();
        roots.extend(self.accelerations(accelerations));
        let of_states = vec![model.graph.zero(); model.states.len()];
        roots.extend(
            columns
                .iter()
                .flat_map(|column| [&still[..], column, &of_states].concat()),
        );
        for (n, gradient) in self.gradients.iter().enumerate() {
            roots.extend(columns[n..].iter().map(|column| dot(gradient, column)));
        }
        roots
    }
}

fn dot<'g>(a: &[Expr<'g>], b: &[Expr<'g>]) -> Expr<'g> {
    let products = a.iter().zip(b).map(|(&a, &b)| a * b);
    a[0].graph().sum(products.collect::<Vec<_>>())
}

/// Rows on the basis of a form.
fn rows_on<'a, 'g>(bases: &'a [(Basis, Rows<'g>)], form: Form) -> &'a Rows<'g> {
    let own = bases.iter().find(|(basis, _)| *basis == form.basis);
    &own.unwrap_or(&bases[0]).1
}

/// Values of the constraints, followed by their rates.
pub(crate) fn measures<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let both = [model.constraint_values(), model.constraint_rates()];
    super::values(forms, model, &both.concat())
}

/// Gradients of the constraint values and of their rates with respect to the state, followed by the time derivatives of
/// both.
pub(crate) fn measure_derivatives<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let both = [model.constraint_values(), model.constraint_rates()].map(|values| model.with_drives(&values));
    let gradients = both
        .iter()
        .flatten()
        .flat_map(|&value| derived(&[value], &model.state()).concat());
    let by_time = both.iter().flat_map(|values| derived(values, &[model.time]).concat());
    super::values(forms, model, &gradients.chain(by_time).collect::<Vec<_>>())
}

/// Response to constraint forces.
pub(crate) fn response<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let bases = Rows::new(model).on_each_basis(forms);
    let mut candidates: Vec<Candidate<'g>> = Vec::new();
    forms.each_system(|system| {
        let accelerations = of_coordinates(&forms.floating, system.solved);
        let rows = rows_on(&bases, system.form);
        let roots = rows.response(model, &forms.floating, system.mobility, &accelerations);
        candidates.push((system.form, roots));
    });
    forms.choose(candidates)
}

/// Response, followed by three derivatives: of the right-hand side with respect to the state, of each constraint's
/// second derivative with respect to the state, and of both with respect to time.
pub(crate) fn response_derivative<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Chosen<'g> {
    let (graph, state) = (model.graph, model.state());
    let bases = Rows::new(model).on_each_basis(forms);
    let (floating, rows) = (forms.floating.clone(), &bases[0].1);
    let symbols: Vec<Expr<'g>> = model.coordinates.iter().map(|c| c.acceleration).collect();
    let all = [&rows.gradients.concat()[..], &rows.drifts].concat();
    let has_time = forms.has_time(model) || graph.reachable(&all).contains(&model.time.id());
    let variables = [&state[..], &[model.time][..usize::from(has_time)]].concat();
    forms.solutions(model, &variables, |way: &Way<'_, 'g>| {
        let rows = rows_on(&bases, way.form);
        let of_states = derived(&model.state_rates(), &variables).concat();
        let rates = stacked(
            model,
            &derived(&model.kinematics(), &variables),
            &way.columns,
            &of_states,
        );
        let known: FxHashMap<_, _> = symbols.iter().copied().zip(way.accelerations.iter().copied()).collect();
        // chain rule: the partial derivative at fixed accelerations, plus `J` times the derivative of the accelerations
        let fixed = derived(&rows.accelerations(&symbols), &variables);
        let fixed = fixed.iter().map(|column| graph.substitute(column, known.clone()));
        let changes = fixed.zip(way.columns.chunks(model.dof())).map(|(fixed, change)| {
            let rows = fixed.into_iter().zip(&rows.gradients);
            rows.map(|(fixed, gradient)| fixed + dot(gradient, change)).collect()
        });
        let mut changes: Vec<Vec<Expr<'g>>> = changes.collect();
        let (by_state, by_time) = rates.split_at(state.len() * state.len());
        let still = || vec![graph.zero(); state.len() + rows.drifts.len()];
        let by_time = changes
            .split_off(state.len())
            .pop()
            .map_or_else(still, |of_rows| [by_time, &of_rows].concat());
        let gradients = (0..rows.drifts.len()).flat_map(|row| changes.iter().map(move |column| column[row]));
        let mut roots = rows.response(model, &floating, way.mobility, &way.accelerations);
        roots.extend(by_state.iter().copied().chain(gradients).chain(by_time));
        roots
    })
}

impl<'g> Forms<'g> {
    /// True if the equations of motion depend on time.
    fn has_time(&self, model: &Model<'g>) -> bool {
        let form = self.forms.first().map(|written| written.balance.entries());
        form.is_some_and(|entries| model.graph.reachable(&entries).contains(&model.time.id()))
    }
}

//! Everything a printer needs of a scene, independent of the output language.

mod blank;
mod block;
mod build;
pub(crate) mod dependence;
mod drawing;
pub(crate) mod equations;
pub(crate) mod layout;
mod output;
mod routine;
mod schedule;
mod series;
mod sizes;
mod table;

use std::collections::BTreeSet;

use rustc_hash::FxHashMap;

pub use block::{Block, Coefficient, Columns, Let, Local, MultiplyAdd, Signs, SinCos, Term, Variable};
pub(crate) use build::NotFinite;
pub use drawing::{Drawing, Outline};
pub(crate) use equations::Extent;
pub use equations::{ConstraintForce, Equations, Listing, Row, RowKind};
pub use layout::{Slot, SlotKind, StateLayout, StateVariable};
pub use output::Event;
pub(crate) use output::{functions_of_event, functions_of_output, is_function, saturation};
pub use routine::{Argument, Cost, Role, Routine, Shape};
pub use series::{Series, Tangents};
pub(crate) use table::words;

pub use crate::expr::{Binary, Definition, Formula, Summand, Unary};
pub use crate::model::FigureKind;
pub(crate) use crate::model::ROUNDING;
pub use crate::pass::Operations;

use crate::dynamics::Dynamics;
use crate::expr::{Expr, ExprId, Graph, Level, Printer, SymbolKind};
use crate::form::{Chosen, Forms};
use crate::model::{self, Model, Output, Requirement};
use build::block;
use drawing::Sketch;
use routine::Head;
use sizes::Counts;
use table::{ROUTINES, Request};

/// Scene ready for printing in a language.
#[derive(Clone, Debug)]
pub struct Program {
    /// Name of the scene.
    pub name: String,
    /// Documentation of the scene, line by line.
    pub docs: Vec<String>,
    /// Parameters, in the order of their declaration.
    pub parameters: Vec<Quantity>,
    /// Inputs, in the order of their declaration.
    pub inputs: Vec<Quantity>,
    /// Layout of the state.
    pub layout: StateLayout,
    /// State in which loops are assembled for the default parameters, orientations equal their reference frames, and
    /// everything else is zero.
    pub start: Vec<f64>,
    /// Conditions on the parameters.
    pub rules: Vec<Rule>,
    /// Values that the rules check, as functions of the parameters.
    pub checked: Block,
    /// Constants of the model, computed from the parameters once when the model is built.
    pub constants: Block,
    /// Each constant as text.
    pub constants_text: Vec<String>,
    /// Functions that can be evaluated.
    pub routines: Vec<Routine>,
    /// Names of the components of all outputs.
    pub outputs: Vec<String>,
    /// Their units; empty where a unit is not determined.
    pub output_units: Vec<String>,
    /// Events.
    pub events: Vec<Event>,
    /// Bodies that close each loop.
    pub loops: Vec<[String; 2]>,
    /// Indices of the loops without a closed form.
    pub open_loops: Vec<usize>,
    /// Names of the angles whose turns are not counted although forces depend on them.
    pub uncounted: Vec<String>,
    /// Bodies whose joints are driven.
    pub drives: Vec<String>,
    /// Repairs made to the file of a robot.
    pub repaired: Vec<String>,
    /// Maximum force and rate of each coordinate, if the file of a robot gives any.
    pub most: Vec<[f64; 2]>,
    /// Constraints.
    pub constraints: Vec<Constraint>,
    /// Law of each constraint: kinetic friction, static friction, restitution and the rate below which it is zero, then
    /// the limits that exist.
    pub laws: Block,
    /// Drawing of the scene, if requested.
    pub drawing: Option<Drawing>,
    /// Power series of the motion, if requested.
    pub series: Option<Series>,
    /// Equations of motion.
    pub equations: Equations,
}

/// Parameter or input.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Name.
    pub name: String,
    /// Documentation, line by line.
    pub docs: Vec<String>,
    /// Unit, as written in the declaration.
    pub unit: String,
    /// Default value of a parameter.
    pub default: Option<f64>,
}

/// Constraint: dry friction and stops of a joint, or a wall.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Constraint {
    /// Coordinate of the joint, or name of the wall.
    pub name: String,
    /// Components of the state, with signs, that add up to the rate. Empty if the rate is no such sum.
    pub rate: Vec<(usize, i8)>,
    /// True if the constraint has a lower limit.
    pub low: bool,
    /// True if the constraint has an upper limit.
    pub high: bool,
}

/// Condition on the parameters, checked when the model is built.
#[derive(Clone, Debug)]
pub struct Rule {
    /// Index of the checked value.
    pub value: usize,
    /// Condition that the value must meet.
    pub condition: Condition,
    /// Text of the parameter, or of the expression of parameters.
    pub name: String,
    /// The rule as a sentence.
    pub text: String,
    /// Parameters in the expression of the value. Empty if the value is a parameter itself.
    pub parameters: Vec<usize>,
}

/// Condition on a checked value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Above zero.
    Positive,
    /// Zero or above.
    NonNegative,
    /// Zero or above, up to the rounding error of a difference of numbers as large as another checked value.
    NonNegativeWithin(usize),
}

/// Number of values in a law without limits: kinetic friction, static friction, restitution, and the rate below which
/// the restitution is zero.
pub(crate) const LAW: usize = 4;
/// Message for a parameter that is not finite.
pub(crate) const FINITE_PARAMETER: &str = "a parameter must be finite";
/// Message for a constant that is not finite.
pub(crate) const FINITE_CONSTANT: &str = "a constant of the equations is not finite: a coordinate has no inertia, \
                                          a divisor is zero, or a number is too large";

impl Program {
    /// Generates the program of a scene, with its equations as text to an extent.
    ///
    /// # Errors
    ///
    /// Returns the first constant without a finite value.
    pub(crate) fn new<'g>(model: &Model<'g>, dynamics: &Dynamics<'g>, extent: Extent) -> Result<Self, NotFinite> {
        let g = model.graph;
        let mut forms = Forms::new(model, dynamics);
        let chosen = chosen(&mut forms, model);
        let deciding = match chosen.iter().find(|(head, _)| head.role == Role::Rhs) {
            Some((_, rhs)) => rhs.roots.clone(),
            None => {
                let (balance, _) = forms.closed().unwrap_or((&dynamics.balance, &dynamics.lagrangian));
                model.written_out(&[&balance.rows[..], &model.state_rates()].concat())
            }
        };
        let layout = StateLayout::new(model, &[deciding, model.written_out(&model.watched())].concat());
        let series = model.generate.contains("taylor").then(|| forms.taylor(model));
        let sketch = model
            .generate
            .contains("shapes")
            .then(|| Sketch::new(&mut forms, model));
        let of_series = series.iter().flat_map(|series| {
            let of_tangents = series.tangents.iter().map(|tangents| &tangents.constants);
            [&series.start, &series.order].into_iter().chain(of_tangents)
        });
        let of_sketch = sketch.iter().map(|sketch| &sketch.chosen.roots);
        let laws: Vec<Expr<'g>> = model.constraints.iter().flat_map(|c| c.law.numbers()).collect();
        let lists = chosen.iter().flat_map(|(_, chosen)| {
            let columns = chosen.columns.iter();
            columns.map(|columns| &columns.given).chain([&chosen.roots])
        });
        let constants = constants(g, lists.chain(of_series).chain(of_sketch).chain([&laws]));
        let known = known(model, &chosen, &constants);
        let routines = chosen
            .into_iter()
            .map(|(head, chosen)| Routine::new(model, head, chosen, &known));
        let printer = Printer::new(g);
        let (rules, checked) = rules(model);
        let of_parameters = parameters(model);
        let force = &dynamics.lagrangian.force;
        let equations = match extent {
            Extent::None => Equations::default(),
            _ => equations::equations(model, force, extent, forms.recursive(), forms.closed()),
        };
        Ok(Self {
            name: model.name.clone(),
            docs: model.docs.clone(),
            parameters: model.parameters.iter().map(Quantity::of_parameter).collect(),
            inputs: model.inputs.iter().map(Quantity::of_input).collect(),
            layout,
            start: model.start(),
            rules,
            checked: block(g, &checked, &of_parameters)?,
            constants: block(g, &constants, &of_parameters)?,
            constants_text: constants.iter().map(|constant| printer.print(constant.id())).collect(),
            routines: routines.collect::<Result<_, _>>()?,
            outputs: model.outputs.iter().flat_map(Output::labels).collect(),
            output_units: model.outputs.iter().flat_map(|output| output.units.clone()).collect(),
            events: model.events.iter().map(Event::of).collect(),
            loops: model.closures.iter().map(|closure| closure.bodies(model)).collect(),
            open_loops: model.loops.gaps.iter().map(|gap| gap.number).collect(),
            uncounted: model.uncounted().map(str::to_owned).collect(),
            drives: model.drives.iter().map(|drive| drive.coordinate.name.clone()).collect(),
            repaired: model.repaired.clone(),
            most: model.most.clone(),
            constraints: model.constraints.iter().map(|c| Constraint::new(model, c)).collect(),
            laws: block(g, &laws, &known)?,
            drawing: sketch.map(|sketch| sketch.finish(model, &known)).transpose()?,
            series: series.map(|series| Series::new(model, series, &known)).transpose()?,
            equations,
        })
    }

    /// Routine with a role other than [`Role::Function`].
    pub fn with_role(&self, role: Role) -> Option<&Routine> {
        self.routines.iter().find(|routine| routine.role == role)
    }

    /// Routine of the given name.
    pub fn routine(&self, name: &str) -> Option<&Routine> {
        self.routines.iter().find(|routine| routine.name == name)
    }
}

impl Constraint {
    fn new<'g>(model: &Model<'g>, constraint: &model::Constraint<'g>) -> Self {
        Self {
            name: constraint.name.clone(),
            rate: constraint.rate(model),
            low: constraint.law.low.is_some(),
            high: constraint.law.high.is_some(),
        }
    }

    /// Number of values in the law of the constraint.
    fn numbers(&self) -> usize {
        LAW + usize::from(self.low) + usize::from(self.high)
    }
}

impl Quantity {
    fn of_parameter(parameter: &model::Parameter<'_>) -> Self {
        Self {
            name: parameter.name.clone(),
            docs: parameter.docs.clone(),
            unit: parameter.unit.text.clone(),
            default: parameter.default,
        }
    }

    fn of_input(input: &model::Input<'_>) -> Self {
        Self {
            name: input.name.clone(),
            docs: input.docs.clone(),
            unit: input.unit.text.clone(),
            default: None,
        }
    }
}

/// Routines that a scene requests, each in the form of the least weight.
fn chosen<'g>(forms: &mut Forms<'g>, model: &Model<'g>) -> Vec<(Head, Chosen<'g>)> {
    let mut request = Request {
        counts: Counts::of(model),
        words: &model.generate,
        time_occurs: false,
    };
    let mut chosen = Vec::new();
    // the right-hand side is first; it decides if there is a time derivative
    for row in ROUTINES {
        if (row.wanted)(&request, row.word) {
            let own = (row.form)(forms, model);
            let reads_time = || model.graph.reachable(&own.roots).contains(&model.time.id());
            request.time_occurs |= row.role == Role::Rhs && reads_time();
            chosen.push((row.head(&request.counts), own));
        }
    }
    chosen.extend(output::routines(forms, model));
    chosen
}

/// Largest expressions of parameters read by the routines.
fn constants<'g, 'a>(g: &'g Graph, lists: impl Iterator<Item = &'a Vec<Expr<'g>>>) -> Vec<Expr<'g>>
where
    'g: 'a,
{
    let mut constants = BTreeSet::new();
    for roots in lists {
        let reachable = g.reachable(roots).into_iter().map(|id| g.expr(id));
        let of_state = reachable.filter(|x| x.level() == Level::State);
        let read = of_state.flat_map(Expr::operands).chain(roots.iter().copied());
        constants.extend(read.filter(|x| x.level() == Level::Parameter));
    }
    constants.into_iter().collect()
}

/// Expressions available to the routines, as variables.
fn known<'g>(model: &Model<'g>, chosen: &[(Head, Chosen<'g>)], constants: &[Expr<'g>]) -> FxHashMap<ExprId, Variable> {
    let state = model.state().into_iter().enumerate();
    let accelerations = model.coordinates.iter().map(|c| c.acceleration).enumerate();
    let inputs = model.input_symbols().into_iter().enumerate();
    let forces = model.force_symbols().into_iter().enumerate();
    let constants = constants.iter().copied().enumerate();
    let state = state.map(|(n, x)| (x.id(), Variable::State(n)));
    let accelerations = accelerations.map(|(n, x)| (x.id(), Variable::Acceleration(n)));
    let inputs = inputs.map(|(n, x)| (x.id(), Variable::Input(n)));
    let forces = forces.map(|(n, x)| (x.id(), Variable::Force(n)));
    let constants = constants.map(|(n, x)| (x.id(), Variable::Constant(n)));
    let all = state.chain(accelerations).chain(inputs).chain(forces).chain(constants);
    let read = chosen.iter().flat_map(|(_, chosen)| {
        let solution = chosen.columns.iter().flat_map(|columns| &columns.solution);
        let roots: Vec<Expr<'g>> = chosen.roots.iter().chain(solution).copied().collect();
        model.graph.reachable(&roots)
    });
    let given = read.filter_map(|id| match model.graph.as_symbol(id)?.kind {
        SymbolKind::Weight(n) => Some((id, Variable::Weight(n))),
        SymbolKind::Direction(n) => Some((id, Variable::Direction(n))),
        SymbolKind::Given(n) => Some((id, Variable::Given(n))),
        SymbolKind::Factor(n) => Some((id, Variable::Factor(n))),
        SymbolKind::Solved(n) => Some((id, Variable::Solved(n))),
        _ => None,
    });
    all.chain(given).chain([(model.time.id(), Variable::Time)]).collect()
}

/// Parameters as variables: the only ones available when the model is built.
fn parameters(model: &Model<'_>) -> FxHashMap<ExprId, Variable> {
    let parameters = model.parameters.iter().enumerate();
    parameters
        .map(|(n, p)| (p.symbol.id(), Variable::Parameter(n)))
        .collect()
}

/// Rules, and the values that they check.
fn rules<'g>(model: &Model<'g>) -> (Vec<Rule>, Vec<Expr<'g>>) {
    let mut checked = Vec::new();
    let rules = model.rules.iter().map(|rule| {
        let value = checked.len();
        checked.push(rule.value);
        let condition = match rule.requirement {
            Requirement::Positive => Condition::Positive,
            Requirement::NonNegative => Condition::NonNegative,
            Requirement::NonNegativeWithin(scale) => {
                checked.push(scale);
                Condition::NonNegativeWithin(value + 1)
            }
        };
        let read = model.graph.reachable(&[rule.value]);
        let parameters = model.parameters.iter().map(|parameter| parameter.symbol);
        let parameters = parameters
            .enumerate()
            .filter(|(_, symbol)| *symbol != rule.value && read.contains(&symbol.id()));
        Rule {
            value,
            parameters: parameters.map(|(n, _)| n).collect(),
            condition,
            name: rule.name.clone(),
            text: rule.text.clone(),
        }
    });
    let rules = rules.collect();
    (rules, checked)
}

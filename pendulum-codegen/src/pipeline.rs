//! The whole path on one screen: tokens, syntax tree, model, dynamics, short forms, code.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use proc_macro2::TokenStream;

use crate::ast::Scene;
use crate::dynamics::Dynamics;
use crate::error::Errors;
use crate::expr::{Expr, Graph, Level, Node};
use crate::form::{Chosen, Forms, Taylor};
use crate::lower::Lowered;
use crate::model::{Model, Output};
use crate::{check, emit, lower, parse};

/// A function of the generated model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Function {
    /// The accelerations, for the right-hand side.
    Rhs,
    /// The accelerations, and behind them their derivatives by the state, column by column.
    Jacobian,
    /// Their derivatives by the time, where it occurs.
    TimeDerivative,
    /// Their derivatives by the inputs, column by column.
    InputJacobian,
    /// Kinetic energy.
    Kinetic,
    /// Potential energy.
    Potential,
    /// The upper triangle of the mass matrix, row by row.
    MassMatrix,
    /// The bias.
    Bias,
    /// The momenta of the coordinates.
    Momentum,
    /// The momenta, and behind them their rates.
    Canonical,
    /// The derivatives of the momenta by the state, column by column, and behind them those of their rates.
    CanonicalJacobian,
    /// The forces that accelerations take, which stand in them as the symbols of the coordinates.
    InverseDynamics,
    /// The derivatives of the accelerations by the parameters, column by column.
    ParameterJacobian,
}

impl Function {
    /// The name of the generated function.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rhs => "rhs",
            Self::Jacobian => "jacobian",
            Self::TimeDerivative => "time_derivative",
            Self::InputJacobian => "input_jacobian",
            Self::Kinetic => "kinetic",
            Self::Potential => "potential",
            Self::MassMatrix => "mass_matrix",
            Self::Bias => "bias",
            Self::Momentum => "momentum",
            Self::Canonical => "canonical",
            Self::CanonicalJacobian => "canonical_jacobian",
            Self::InverseDynamics => "inverse_dynamics",
            Self::ParameterJacobian => "parameter_jacobian",
        }
    }
}

/// All that is known of a scene when its code is written.
#[derive(Debug)]
pub struct Program<'g> {
    /// The scene and its expressions.
    pub model: Model<'g>,
    /// The code of each function.
    pub functions: BTreeMap<Function, Chosen<'g>>,
    /// The code of the Taylor series, where it was asked for.
    pub taylor: Option<Taylor<'g>>,
    /// What is computed once, when the model is built: everything that depends on parameters alone.
    pub constants: Vec<Expr<'g>>,
    /// The equations of motion as text.
    pub equations: String,
}

/// Expands a declaration into items, or into its compile errors and a stand-in for the items.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let (scene, errors) = parse::parse(tokens);
    let Some(scene) = scene else {
        return errors.to_compile_errors();
    };
    let graph = Graph::new();
    match compile(&graph, &scene, errors) {
        Ok(program) => emit::items(&scene.head, &program),
        Err(errors) => {
            let mut tokens = errors.to_compile_errors();
            tokens.extend(emit::stub(&scene));
            tokens
        }
    }
}

/// The program of a declaration with its expressions in a graph, or all that is wrong with it.
pub fn program(graph: &Graph, tokens: TokenStream) -> Result<Program<'_>, Errors> {
    let (scene, errors) = parse::parse(tokens);
    match scene {
        Some(scene) => compile(graph, &scene, errors),
        None => Err(errors),
    }
}

/// The meaning of a declaration with its expressions in a graph, or all that is wrong with it. Physical checks that need the dynamics
/// are not made yet.
pub fn model(graph: &Graph, tokens: TokenStream) -> Result<Model<'_>, Errors> {
    let (scene, errors) = parse::parse(tokens);
    match scene {
        Some(scene) => lower::lower(graph, &scene, errors).map(|lowered| lowered.model),
        None => Err(errors),
    }
}

fn compile<'g>(graph: &'g Graph, scene: &Scene, errors: Errors) -> Result<Program<'g>, Errors> {
    let Lowered { model, spans } = lower::lower(graph, scene, errors)?;
    let dynamics = Dynamics::new(&model);
    check::check(&model, &spans, &dynamics)?;
    let mut forms = Forms::new(&model, &dynamics);
    let functions = functions(&model, &mut forms);
    let taylor = model.outputs.contains(&Output::Taylor).then(|| forms.taylor(&model));
    let constants = constants(graph, &functions, taylor.as_ref());
    let equations = match forms.closed() {
        Some(closed) => emit::equations(&model, closed, true),
        None => emit::equations(&model, &dynamics, false),
    };
    Ok(Program {
        model,
        functions,
        taylor,
        constants,
        equations,
    })
}

/// What a function reads off the dynamics.
type Part<'g, 'a> = dyn Fn(&Dynamics<'g>) -> Vec<Expr<'g>> + 'a;

fn functions<'g>(model: &Model<'g>, forms: &mut Forms<'g>) -> BTreeMap<Function, Chosen<'g>> {
    let wants = |model: &Model<'g>, output| model.outputs.contains(&output);
    let controlled = !model.inputs.is_empty();
    // a Jacobian without its right-hand side, or an input without the derivative by it, is no use to anybody
    let jacobian = wants(model, Output::Jacobian) || (controlled && wants(model, Output::Rhs));
    let brings_rhs = [Output::Rhs, Output::Canonical, Output::Taylor];
    let rhs = jacobian || brings_rhs.into_iter().any(|output| wants(model, output));
    let mut functions = BTreeMap::new();
    let mut is_autonomous = true;
    if rhs {
        let accelerations = forms.accelerations();
        is_autonomous = !model.graph.reachable(&accelerations.roots).contains(&model.time.id());
        functions.insert(Function::Rhs, accelerations);
    }
    let inputs: Vec<Expr<'g>> = model.inputs.iter().map(|input| input.symbol).collect();
    let parameters = model.parameters.iter().map(|parameter| parameter.symbol).collect();
    let derivatives = [
        (Function::Jacobian, jacobian, model.state()),
        // a law for inputs depends on time in its own way: nothing of it is known here
        (
            Function::TimeDerivative,
            jacobian && !controlled && !is_autonomous,
            vec![model.time],
        ),
        (Function::InputJacobian, jacobian && controlled, inputs.clone()),
        (
            Function::ParameterJacobian,
            wants(model, Output::ParameterJacobian),
            parameters,
        ),
    ];
    for (function, _, variables) in derivatives.into_iter().filter(|(_, wanted, _)| *wanted) {
        let with_accelerations = function == Function::Jacobian;
        functions.insert(function, forms.jacobian(model, &variables, with_accelerations));
    }
    if wants(model, Output::Canonical) {
        functions.insert(Function::Canonical, forms.canonical(model));
        functions.insert(Function::CanonicalJacobian, forms.canonical_jacobian(model));
    }
    // what inputs do is asked of inverse dynamics, not given
    let zero = model.graph.zero();
    let without_inputs: HashMap<_, _> = inputs.into_iter().map(|input| (input, zero)).collect();
    let upper = |row: (usize, &Vec<Expr<'g>>)| row.1[row.0..].to_vec();
    let parts: [(Function, Output, &Part<'g, '_>); 6] = [
        (Function::Kinetic, Output::Energy, &|d| vec![d.kinetic]),
        (Function::Potential, Output::Energy, &|d| vec![d.potential]),
        (Function::MassMatrix, Output::MassMatrix, &|d| {
            d.mass_matrix.iter().enumerate().flat_map(upper).collect()
        }),
        (Function::Bias, Output::Bias, &|d| d.bias.clone()),
        (Function::Momentum, Output::Momentum, &|d| d.momentum.clone()),
        (Function::InverseDynamics, Output::InverseDynamics, &|d| {
            model.graph.substitute(&d.balance, without_inputs.clone())
        }),
    ];
    for (function, output, part) in parts {
        if wants(model, output) {
            functions.insert(function, forms.part(part));
        }
    }
    functions
}

/// The expressions of parameters that the functions read.
fn constants<'g>(
    g: &'g Graph,
    functions: &BTreeMap<Function, Chosen<'g>>,
    taylor: Option<&Taylor<'g>>,
) -> Vec<Expr<'g>> {
    let mut constants = BTreeSet::new();
    let of_series = taylor.into_iter().flat_map(|taylor| [&taylor.start, &taylor.order]);
    for roots in functions.values().map(|chosen| &chosen.roots).chain(of_series) {
        let reachable = g.reachable(roots).into_iter().map(|id| g.expr(id));
        let of_state = reachable.filter(|x| x.level() == Level::State);
        let read = of_state.flat_map(Expr::operands).chain(roots.iter().copied());
        constants.extend(read.filter(|x| x.level() == Level::Parameter));
    }
    debug_assert!(constants.iter().all(|x| !matches!(x.node(), Node::Number(_))));
    constants.into_iter().collect()
}

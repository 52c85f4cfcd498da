//! The whole path on one screen: tokens, syntax tree, model, dynamics, short forms, code.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::TokenStream;

use crate::ast::Scene;
use crate::dynamics::Dynamics;
use crate::error::Errors;
use crate::expr::{ExprId, Level, Node};
use crate::model::{Model, Output};
use crate::pass::{Chosen, Forms};
use crate::{check, emit, lower, parse};

/// A function of the generated model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Function {
    /// The accelerations, for the right-hand side.
    Rhs,
    /// Their derivatives by the state, column by column.
    Jacobian,
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
}

/// All that is known of a scene when its code is written.
#[derive(Debug)]
pub struct Program {
    /// The scene and its expressions.
    pub model: Model,
    /// The code of each function.
    pub functions: BTreeMap<Function, Chosen>,
    /// What is computed once, when the model is built: everything that depends on parameters alone.
    pub constants: Vec<ExprId>,
    /// The equations of motion as text.
    pub equations: String,
}

/// Expands a declaration into items, or into its compile errors and a stand-in for the items.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let (scene, errors) = parse::parse(tokens);
    let Some(scene) = scene else {
        return errors.to_compile_errors();
    };
    match compile(&scene, errors) {
        Ok(program) => emit::items(&scene, &program),
        Err(errors) => {
            let mut tokens = errors.to_compile_errors();
            tokens.extend(emit::stub(&scene));
            tokens
        }
    }
}

/// The program of a declaration, or all that is wrong with it.
pub fn program(tokens: TokenStream) -> Result<Program, Errors> {
    let (scene, errors) = parse::parse(tokens);
    match scene {
        Some(scene) => compile(&scene, errors),
        None => Err(errors),
    }
}

/// The meaning of a declaration, or all that is wrong with it. Physical checks that need the dynamics are not made yet.
pub fn model(tokens: TokenStream) -> Result<Model, Errors> {
    let (scene, errors) = parse::parse(tokens);
    match scene {
        Some(scene) => lower::lower(&scene, errors),
        None => Err(errors),
    }
}

fn compile(scene: &Scene, errors: Errors) -> Result<Program, Errors> {
    let mut model = lower::lower(scene, errors)?;
    let dynamics = Dynamics::new(&mut model);
    check::check(scene, &model, &dynamics)?;
    let mut forms = Forms::new(&mut model, &dynamics);
    let functions = functions(&mut model, &mut forms);
    let constants = constants(&model, &functions);
    let equations = match forms.closed() {
        Some(closed) => emit::equations(&model, closed, true),
        None => emit::equations(&model, &dynamics, false),
    };
    Ok(Program {
        model,
        functions,
        constants,
        equations,
    })
}

fn functions(model: &mut Model, forms: &mut Forms) -> BTreeMap<Function, Chosen> {
    let wants = |output| model.outputs.contains(&output);
    let controlled = !model.inputs.is_empty();
    // a Jacobian without its right-hand side, or an input without the derivative by it, is no use to anybody
    let jacobian = wants(Output::Jacobian) || (controlled && wants(Output::Rhs));
    let rhs = wants(Output::Rhs) || jacobian;
    let (energy, mass_matrix, bias) = (wants(Output::Energy), wants(Output::MassMatrix), wants(Output::Bias));
    let mut functions = BTreeMap::new();
    if rhs {
        functions.insert(Function::Rhs, forms.accelerations(&mut model.graph));
    }
    if jacobian {
        let state = model.state();
        functions.insert(Function::Jacobian, forms.jacobian(model, &state));
    }
    if jacobian && controlled {
        let inputs: Vec<_> = model.inputs.iter().map(|input| input.symbol).collect();
        functions.insert(Function::InputJacobian, forms.jacobian(model, &inputs));
    }
    let g = &mut model.graph;
    if energy {
        functions.insert(Function::Kinetic, forms.part(g, |dynamics| vec![dynamics.kinetic]));
        functions.insert(Function::Potential, forms.part(g, |dynamics| vec![dynamics.potential]));
    }
    if mass_matrix {
        let upper = |row: (usize, &Vec<ExprId>)| row.1[row.0..].to_vec();
        let part = |d: &Dynamics| d.mass_matrix.iter().enumerate().flat_map(upper).collect();
        functions.insert(Function::MassMatrix, forms.part(g, part));
    }
    if bias {
        functions.insert(Function::Bias, forms.part(g, |dynamics| dynamics.bias.clone()));
    }
    functions
}

/// The expressions of parameters that the functions read.
fn constants(model: &Model, functions: &BTreeMap<Function, Chosen>) -> Vec<ExprId> {
    let g = &model.graph;
    let mut constants = BTreeSet::new();
    for chosen in functions.values() {
        let of_state = g
            .reachable(&chosen.roots)
            .into_iter()
            .filter(|&id| g.level(id) == Level::State);
        let read = of_state
            .flat_map(|id| g.operands(id))
            .chain(chosen.roots.iter().copied());
        constants.extend(read.filter(|&id| g.level(id) == Level::Parameter));
    }
    debug_assert!(constants.iter().all(|&id| !matches!(g.node(id), Node::Number(_))));
    constants.into_iter().collect()
}

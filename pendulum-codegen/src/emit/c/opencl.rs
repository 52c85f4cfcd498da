//! The right-hand side as OpenCL C, for kernels that integrate.

use super::Scene;
use super::block::{Calls, statements};
use super::functions::functions;
use super::model::fields;
use super::template::lines;
use crate::program::{Program, Role};

/// Prints the right-hand side of a program and its constants as OpenCL C.
///
/// Numbers have the type `pendulum_real`: `float` if `PENDULUM_SINGLE` is defined, else `double`. The functions are
///
/// ```c
/// void scene_new(scene_model *model, const scene_params *params);
/// void scene_rhs(const scene_model *model, pendulum_real t, const pendulum_real x[], pendulum_real out[]);
/// ```
///
/// where `scene_params` holds the `SCENE_PARAMETERS` parameters in the order of their declaration, and states have
/// `SCENE_LENGTH` components. Parameters are not checked; the model in Rust checks them. In double precision, results
/// equal those of the Rust code bit for bit if `sqrt` and `fabs` are the only platform functions called.
pub fn opencl(program: &Program) -> String {
    let scene = Scene::new(program, "scene".to_owned());
    let mut calls = Calls::new();
    let (code, constants) = scene.plain_code(&program.constants, &mut calls);
    let rhs = program.with_role(Role::Rhs).into_iter();
    let rhs: String = rhs.map(|routine| scene.routine(routine, &mut calls)).collect();
    let values = [
        ("count", program.parameters.len().to_string()),
        ("functions", functions_for_kernels(&calls)),
        ("parameters", fields(&program.parameters, &scene.parameters)),
        ("code", code + &statements(&constants, |n| format!("k[{n}]"))),
        ("rhs", rhs),
    ];
    let text = scene.fill(include_str!("templates/kernel.cl"), &values);
    let (head, body) = text.split_at(text.find("#define").unwrap_or(0));
    head.to_owned() + &body.replace("double", "pendulum_real")
}

/// Called functions. Those of the platform are built into OpenCL C.
fn functions_for_kernels(calls: &Calls) -> String {
    let functions = functions(calls).map(|(name, code)| match name {
        "Pendulum_sincos" => include_str!("templates/sincos.cl"),
        // the types are in the file of the function
        "Pendulum_pair" => "",
        _ => code,
    });
    let built_in = |line: &&str| line.starts_with("extern");
    lines(
        functions
            .flat_map(str::lines)
            .filter(|line| !built_in(line))
            .map(str::to_owned),
    )
}

//! FMUs against the Rust code: compiled, linked to a program, and driven by the functions of FMI.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use nalgebra::SVector;
use pendulum_codegen::program::Program;
use pendulum_codegen::{Fmu, NoFmu, fmu};
use pendulum_core::Controlled;
use pendulum_core::prelude::*;
use pendulum_core::system::PlantJacobian;
use testbed::random::Random;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};
use testbed::source::{SCENES, declaration};

use crate::c_code::{folder, output};
use crate::emitted_c::{self, Coupled, CoupledParams};

mechanism! {
    /// A pole on a cart, with two inputs, outputs, an event and a kink.
    pub Pole {
        params { l: m = 0.6, tau: s = 0.3 }
        input push: N,
        input twist: N m,
        gravity: [0, -9.81, 0],
        state lag { unit: N, rate: (push - lag)/tau }
        point tip on pole at [0, -l, 0],
        output tip: tip,
        output speed: dot(tip.x),
        event passes: tip.x - 0.1,
        body cart on ground {
            mass: 2, joint: prismatic(x), coordinate: s, friction: 0.2,
            torque: lag + 0.1*sin(2 rad/s*t) + 1 N/m*clamp(s, -1, 1),
        }
        body pole on cart {
            solids: [rod(0.4, [0, 0, 0], [0, -l, 0])], joint: revolute(z), coordinate: theta, friction: 0.01,
            torque: twist*cos(theta),
        }
    }
}

mechanism! {
    /// A body in flight with a ball joint.
    pub Flying {
        gravity: [0, 0, -9.81],
        body craft on ground {
            mass: 3, com: [0.1, 0.1, -0.1], inertia: [0.3, 0.25, 0.2],
            joint: free at [1, 0, 0], orientation: craft, position: at,
        }
        body bob on craft { mass: 0.7, com: [0, 0, -0.4], inertia: [0.01, 0.02, 0.015], joint: ball, orientation: bob }
    }
}

mechanism! {
    /// A crank-rocker whose rocker comes to its toggle if the crank is turned.
    pub Rockers {
        gravity: [0, -9.81, 0],
        body crank on ground {
            mass: 0.5, com: [0.3, 0, 0], inertia: 0.002, joint: revolute(z), coordinate: theta near 0.8,
        }
        body coupler on crank {
            mass: 1.1, com: [0.25, 0, 0], inertia: 0.02,
            joint: revolute(z) at [0.5, 0, 0], coordinate: phi depends near -0.3,
        }
        body rocker on ground {
            mass: 0.9, com: [0.2, 0, 0], inertia: 0.01, joint: revolute(z) at [0.6, 0, 0],
            coordinate: psi depends near 1.6,
        }
        close coupler at [0.3, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

/// Source of this file, with its declarations.
const OWN: &str = include_str!("fmus.rs");

/// Length of a communication step, in s.
const STEP: f64 = 0.05;

#[test]
fn functions_and_derivatives_are_those_of_rust() {
    let Some(driver) = driver(OWN, "Pole", 0) else { return };
    let model = Pole::new(PoleParams::default()).expect("physical");
    let mut random = Random::new(3);
    let lists: Vec<Vec<f64>> = (0..200)
        .map(|_| (0..1 + 2 * (5 + 2)).map(|_| random.between(-2.0, 2.0)).collect())
        .collect();
    let results = numbers(&driver, &lists);
    assert_eq!(results.len(), 200 * (20 + 8 + 2 + 2));
    for (given, found) in lists.iter().zip(results.chunks(32)) {
        let (t, x) = (given[0], SVector::<f64, 5>::from_column_slice(&given[1..6]));
        let u = PoleInputs {
            push: given[6],
            twist: given[7],
        };
        let by_inputs = model.input_jacobian(t, &x, &u);
        let (rates, (_, by_state)) = (model.eval(t, &x, &u), model.eval_with_jacobian(t, &x, &u));
        let (outputs, of_outputs) = model.outputs_and_jacobian(t, &x);
        let (seed, own) = (
            SVector::<f64, 5>::from_column_slice(&given[8..13]),
            SVector::from([given[13], given[14]]),
        );
        let expected = [
            rates.as_slice(),
            outputs.as_slice(),
            &[model.passes(t, &x), model.saturation_1(t, &x)],
            (by_state * seed + by_inputs * own).as_slice(),
            (of_outputs * seed).as_slice(),
            seed.as_slice(),
            (by_state.transpose() * seed).as_slice(),
            (by_inputs.transpose() * seed).as_slice(),
        ]
        .concat();
        assert_eq!(expected.len(), found.len());
        for (n, (expected, found)) in expected.iter().zip(found).enumerate() {
            // products are summed in another order
            let allowed = if n < 11 { 0.0 } else { 1e-12 * (1.0 + expected.abs()) };
            assert!((expected - found).abs() <= allowed, "{n}: {expected}, not {found}");
        }
    }
}

#[test]
fn co_simulation_ends_where_rust_does() {
    let exact = Vern9::new().rtol(1e-12).atol(1e-12);

    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    let start = [0.0, 4.0_f64.to_radians(), 0.0, 0.0];
    let end = exact.solve(&model, 0.0, 20.0, start).expect("regular").end();
    ends(SCENES, "DoublePendulum", &start, 400, end.as_slice(), 1e-8);

    let model = Pole::new(PoleParams::default()).expect("physical");
    let pushed = model.with_inputs(|_, _| PoleInputs { push: 3.0, twist: -0.5 });
    let start = [0.2, 1.0, -0.5, 0.1, 0.0];
    let end = exact.solve(&pushed, 0.0, 5.0, start).expect("regular").end();
    ends(
        OWN,
        "Pole",
        &[0.2, 1.0, -0.5, 0.1, 0.0, 3.0, -0.5],
        100,
        end.as_slice(),
        1e-8,
    );

    // guesses of the dependent coordinates, which the FMU assembles
    let model = Coupled::new(CoupledParams {}).expect("physical");
    let guess = [0.9, 0.1, -0.7, 0.6, 1.5];
    let start = model.assemble(0.0, guess).expect("it closes");
    let end = exact.solve(&model, 0.0, 2.0, start).expect("regular").end();
    ends(emitted_c::OWN, "Coupled", &guess, 40, end.as_slice(), 1e-7);

    let model = Flying::new(FlyingParams {}).expect("physical");
    let mut start = [0.0; 20];
    [start[3], start[7]] = [1.0; 2];
    for (n, x) in start[11..].iter_mut().enumerate() {
        *x = 0.5 * (n as f64) - 2.0;
    }
    let end = exact.solve(&model, 0.0, 2.0, start).expect("regular").end();
    ends(OWN, "Flying", &start, 40, end.as_slice(), 1e-7);
}

#[test]
fn errors_have_the_messages_of_rust() {
    // a motion into a toggle ends there
    let Some(driver) = driver(OWN, "Rockers", 100) else {
        return;
    };
    let message = failure(&driver, &[0.8, 3.0, 1e-8]);
    assert!(
        message.contains("the loop of `coupler` and `rocker` at t = 0."),
        "{message}"
    );
    assert!(message.contains("singularity (toggle)"), "{message}");
    let model = Rockers::new(RockersParams {}).expect("physical");
    let error = Rk45::new().solve(&model, 0.0, 5.0, [0.8, 3.0]).expect_err("a toggle");
    assert!(error.to_string().contains("toggle"), "{error}");
}

#[test]
fn parameters_are_checked() {
    // the first parameter, which has no default, is not set
    let text = "pub Bare { params { m: kg, l: m = 1 } gravity: [0, -9.81, 0],
        body b on ground { mass: m, com: [0, -l, 0], joint: revolute(z), coordinate: a } }";
    let program = pendulum_codegen::program(text.parse().expect("tokens")).expect("no errors");
    let Some(driver) = compiled(&program, 1) else { return };
    let message = failure(&driver, &[0.0, 0.0, 1e-8]);
    assert!(message.contains("`m`: a parameter must be finite"), "{message}");
}

#[test]
fn models_without_an_fmu_are_refused() {
    let body = "mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a";
    let refused = |items: &str, fields: &str| {
        let text = format!("pub Bob {{ gravity: [0, -9.81, 0], {items} body b on ground {{ {body}, {fields} }} }}");
        let program = pendulum_codegen::program(text.parse().expect("tokens")).expect("no errors");
        fmu(&program)
    };
    assert_eq!(
        refused("", "dry_friction: 0.1, stop: [-1, 1]"),
        Err(NoFmu::SwitchesModes(vec!["a".to_owned()]))
    );
    let wall = "point p on b at [0, -1, 0], wall floor { gap: p.y + 2 m, restitution: 0.5 }";
    let error = refused(wall, "").expect_err("a wall");
    assert_eq!(error, NoFmu::SwitchesModes(vec!["floor".to_owned()]));
    assert!(error.to_string().contains("a stiff spring"), "{error}");
    assert_eq!(refused("generate: [energy],", ""), Err(NoFmu::NoRightHandSide));
    let floating = declaration(emitted_c::OWN, "Landing").parse().expect("tokens");
    let floating = pendulum_codegen::program(floating).expect("no errors");
    assert_eq!(
        fmu(&floating),
        Err(NoFmu::SwitchesModes(vec!["a".to_owned(), "floor".to_owned()]))
    );
}

#[test]
fn tokens_are_those_of_the_model() {
    let of = |source: &str| {
        let program = pendulum_codegen::program(source.parse().expect("tokens")).expect("no errors");
        fmu(&program).expect("an FMU")
    };
    let text = declaration(OWN, "Rockers");
    assert_eq!(of(text), of(text));
    let other = of(&text.replace("mass: 0.9", "mass: 0.91"));
    assert_ne!(token(&of(text)), token(&other));
}

/// Compares the end of a co-simulation with the state that Rust finds.
fn ends(source: &str, name: &str, given: &[f64], steps: usize, expected: &[f64], tolerance: f64) {
    let Some(driver) = driver(source, name, steps) else {
        return;
    };
    let found = numbers(&driver, &[[given, &[1e-12]].concat()]);
    assert_eq!(found.len(), expected.len());
    for (expected, found) in expected.iter().zip(&found) {
        let error = (expected - found).abs();
        assert!(error < tolerance, "{name}: {expected}, not {found}: {error:e}");
    }
}

/// Program that drives the FMU of a declaration: it evaluates it if there are no steps, and simulates these otherwise.
fn driver(source: &str, name: &str, steps: usize) -> Option<PathBuf> {
    let tokens = declaration(source, name).parse().expect("tokens");
    compiled(&pendulum_codegen::program(tokens).expect("no errors"), steps)
}

fn compiled(program: &Program, steps: usize) -> Option<PathBuf> {
    let fmu = fmu(program).expect("an FMU");
    let folder = folder(&format!("fmu_{}_{steps}", fmu.identifier))?;
    let sources = write(&fmu, &folder);
    let main = include_str!("fmus/drive.c").replace("\"TOKEN\"", &format!("{:?}", token(&fmu)));
    fs::write(folder.join("drive.c"), main).expect("a file");
    let mut command = Command::new("cc");
    command.args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-O1"]);
    for (name, count) in [
        ("PARAMETERS", program.parameters.len()),
        ("INPUTS", program.inputs.len()),
        ("STATES", program.layout.len()),
        ("OUTPUTS", program.outputs.len()),
        ("EVENTS", program.events.len()),
        ("STEPS", steps),
    ] {
        command.arg(format!("-D{name}={count}"));
    }
    command.arg(format!("-DH={STEP}"));
    command.args(sources).args(["drive.c", "-lm", "-o", "drive"]);
    let status = command.current_dir(&folder).status().expect("a compiler");
    assert!(status.success(), "{} does not compile", fmu.name);
    Some(folder.join("drive"))
}

/// Writes the sources, and returns the names of those to compile.
fn write(fmu: &Fmu, folder: &Path) -> Vec<String> {
    let sources = fmu
        .files
        .iter()
        .filter_map(|(path, text)| Some((path.strip_prefix("sources/")?, text)));
    let written = sources.map(|(name, text)| {
        fs::write(folder.join(name), text).expect("a file");
        name.to_owned()
    });
    let mut written: Vec<String> = written.collect();
    written.retain(|name| name.ends_with(".c"));
    written
}

/// Instantiation token in the model description.
fn token(fmu: &Fmu) -> String {
    let (_, description) = &fmu.files[0];
    let (_, rest) = description.split_once("instantiationToken=\"").expect("a token");
    rest.split_once('"').expect("its end").0.to_owned()
}

fn numbers(driver: &Path, given: &[Vec<f64>]) -> Vec<f64> {
    let bytes = output(driver, given);
    bytes
        .as_chunks()
        .0
        .iter()
        .map(|bytes| f64::from_le_bytes(*bytes))
        .collect()
}

/// Messages of a run that fails.
fn failure(driver: &Path, given: &[f64]) -> String {
    let numbers = driver.with_extension("numbers");
    let bytes: Vec<u8> = given.iter().flat_map(|number| number.to_le_bytes()).collect();
    fs::write(&numbers, bytes).expect("a file");
    let given = fs::File::open(numbers).expect("a file");
    let output = Command::new(driver).stdin(given).output().expect("it runs");
    assert!(!output.status.success());
    String::from_utf8(output.stderr).expect("text")
}

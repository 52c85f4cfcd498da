//! Robots from URDF files.

use std::path::{Path, PathBuf};

use pendulum_codegen::program::Program;
use serde_json::Value;
use testbed::source::{ROBOTS, declaration};

use crate::random_mechanisms::evaluate::{Evaluator, Place};

/// Largest error over largest entry: rounding errors of some thousand operations.
const TOLERANCE: f64 = 1e-11;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../testbed/data/urdf")
}

fn program(declaration: &str) -> Program {
    let tokens = declaration.parse().expect("tokens");
    pendulum_codegen::program_in(&folder(), tokens).unwrap_or_else(|errors| panic!("{declaration}\n{errors}"))
}

/// A robot declared by hand gives the same code, except for the documentation of the file.
fn equals_the_declared_one(name: &str) {
    let by_hand = declaration(ROBOTS, name);
    let (head, bodies) = by_hand.split_once("        generate: [").expect("a list");
    let (_, bodies) = bodies.split_once("],\n").expect("its end");
    let scene = |items: &str| {
        let text = format!("{head} generate: [rhs, jacobian, energy, mass_matrix], {items}");
        pendulum_codegen::expand_in(&folder(), text.parse().expect("tokens")).to_string()
    };
    let from_file = scene(&format!("robot: urdf(\"declared/{}.urdf\"), }}", name.to_lowercase()));
    let from_file = without(&from_file, "# [doc = \"\"] # [doc = \" Links and joints from", "\"]");
    let from_file = without(&from_file, "# [doc = r\" The largest force along each joint", "] ;");
    let from_file = without(&from_file, "# [doc = r\" The largest rate of each joint", "] ;");
    assert!(from_file == scene(bodies), "{name} differs");
}

/// Code without its part from `start` up to the next `end`.
fn without(code: &str, start: &str, end: &str) -> String {
    let (before, rest) = code.split_once(start).expect(start);
    let (_, after) = rest.split_once(end).expect(end);
    format!("{before}{}", after.trim_start())
}

#[test]
#[ignore = "takes long"]
fn robots_give_the_code_of_those_declared_by_hand() {
    equals_the_declared_one("Ur5");
    equals_the_declared_one("Panda");
}

/// Compares mass matrix, bias, energies and acceleration with Pinocchio; see `testbed/data/urdf/reference.py`.
fn equals_pinocchio(name: &str, changes: &str) {
    let text = std::fs::read_to_string(folder().join("reference.json")).expect("reference data");
    let robot = &serde_json::from_str::<Value>(&text).expect("valid JSON")[name];
    let program = program(&format!(
        "pub Robot {{
            gravity: [0, 0, -9.81],
            generate: [rhs, energy, mass_matrix, bias],
            robot: urdf(\"{name}.urdf\"),
            {changes}
        }}"
    ));
    let coordinates: Vec<&str> = program.layout.slots.iter().map(|slot| slot.name.as_str()).collect();
    let expected: Vec<String> = serde_json::from_value(robot["coordinates"].clone()).expect("names");
    assert_eq!(coordinates, expected, "{name}");
    let model = Evaluator::new(&program, &[]);
    let mut potentials = Vec::new();
    for sample in robot["samples"].as_array().expect("a list") {
        let numbers = |key: &str| -> Vec<f64> { serde_json::from_value(sample[key].clone()).expect("numbers") };
        let (positions, rates) = (numbers("q"), numbers("qd"));
        let n = rates.len();
        let place = Place {
            t: 0.0,
            state: [&positions[..], &rates].concat(),
            accelerations: Vec::new(),
            inputs: Vec::new(),
        };
        let of = |routine: &str| model.routine(routine, &place).expect("a routine").concat();
        let close = |what: &str, ours: &[f64], reference: &[f64]| {
            assert_eq!(ours.len(), reference.len(), "{what} of {name}");
            let size = reference.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            let errors = ours.iter().zip(reference).map(|(a, b)| (a - b).abs());
            let error = errors.fold(0.0, f64::max) / size;
            assert!(
                error < TOLERANCE,
                "{what} of {name}: error {error:e}\n{ours:?}\n{reference:?}"
            );
        };
        let matrix: Vec<Vec<f64>> = serde_json::from_value(sample["mass_matrix"].clone()).expect("rows");
        let entry = |k: usize| matrix[(k / n).max(k % n)][(k / n).min(k % n)];
        close(
            "mass matrix",
            &of("mass_matrix"),
            &(0..n * n).map(entry).collect::<Vec<_>>(),
        );
        close("bias", &of("bias"), &numbers("bias"));
        close(
            "kinetic energy",
            &of("kinetic"),
            &[sample["kinetic"].as_f64().expect("a number")],
        );
        close("acceleration", &of("rhs")[positions.len()..], &numbers("acceleration"));
        potentials.push((of("potential")[0], sample["potential"].as_f64().expect("a number")));
    }
    // the zero of the potential energy is arbitrary
    let (first, reference) = potentials[0];
    let size = potentials.iter().fold(0.0, |size: f64, (_, x)| size.max(x.abs()));
    for (ours, potential) in &potentials[1..] {
        let (ours, reference) = (ours - first, potential - reference);
        assert!(
            (ours - reference).abs() < TOLERANCE * size,
            "{name}: {ours} {reference}"
        );
    }
}

macro_rules! pinocchio {
    ($($name:ident $(: $changes:literal)?,)*) => { $(
        #[test]
        fn $name() {
            equals_pinocchio(stringify!($name), concat!($($changes)?));
        }
    )* };
}

pinocchio! {
    asr_twodof,
    baxter,
    double_pendulum,
    finger_edu,
    flying,
    geared,
    hextilt_arm,
    kinova,
    made_up,
    panda_with_hand,
    so100,
    solo12: "body base_link on ground { joint: free, orientation: base_orientation, position: base_position }",
    ur3,
    ur5,
    ur10,
    xarm7,
}

//! The number of base parameters equals the rank of the regressor, the matrix that maps all inertial parameters to the
//! forces of a motion.

use rustc_hash::FxHashMap;

use nalgebra::DMatrix;

use super::{dynamics, numbers};
use crate::dynamics::base_parameters;
use crate::expr::Graph;

/// Joint with its placement, and its parent.
type Joint = (&'static str, Option<usize>);

/// Minimum ratio of a nonzero singular value to the largest. Rounding errors are near 1e-16, and nonzero values exceed
/// 1e-6 here.
const RANK: f64 = 1e-10;

/// Scene whose bodies have ten inertial parameters each.
fn scene(gravity: &str, joints: &[Joint]) -> String {
    let (mut params, mut bodies) = (String::new(), String::new());
    for (n, (joint, parent)) in joints.iter().enumerate() {
        params += &format!("m{n}: kg, hx{n}: kg m, hy{n}: kg m, hz{n}: kg m,");
        params += &["xx", "yy", "zz", "xy", "xz", "yz"]
            .map(|name| format!("i{name}{n}: kg m^2,"))
            .concat();
        let parent = parent.map_or("ground".to_owned(), |parent| format!("b{parent}"));
        bodies += &format!(
            "body b{n} on {parent} {{ mass: m{n}, com: [hx{n}/m{n}, hy{n}/m{n}, hz{n}/m{n}],
                inertia: [ixx{n}, iyy{n}, izz{n}, ixy{n}, ixz{n}, iyz{n}] about joint, joint: {joint}, \
                    coordinate: q{n} }}"
        );
    }
    format!("pub Scene {{ params {{ {params} }} gravity: {gravity}, {bodies} }}")
}

/// Number of base parameters, and the rank of the regressor.
fn counts(gravity: &str, joints: &[Joint]) -> (usize, usize) {
    let graph = Graph::new();
    let (model, dynamics) = dynamics(&graph, &scene(gravity, joints));
    let count = base_parameters(&model).len();
    let names: Vec<String> = model.parameters.iter().map(|p| p.name.clone()).collect();
    let mut next = numbers(5);
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for _ in 0..4 * joints.len() {
        let mut state = FxHashMap::default();
        let mut forces = |moved: Option<&str>| {
            model.graph.evaluate(&dynamics.balance.rows, |symbol| {
                if names.contains(&symbol.name) {
                    // the forces are linear in the ten parameters, so a difference is a derivative; a mass must not be
                    // zero
                    let base = if symbol.name.starts_with('m') { 1.0 } else { 0.0 };
                    return base + if moved == Some(&symbol.name) { 1.0 } else { 0.0 };
                }
                *state.entry(symbol.name.clone()).or_insert_with(|| 4.0 * next() - 2.0)
            })
        };
        let base = forces(None);
        let columns: Vec<Vec<f64>> = names.iter().map(|name| forces(Some(name))).collect();
        for (row, base) in base.iter().enumerate() {
            rows.push(columns.iter().map(|column| column[row] - base).collect());
        }
    }
    let regressor = DMatrix::from_fn(rows.len(), names.len(), |i, j| rows[i][j]);
    let singular = regressor.singular_values();
    let rank = singular.iter().filter(|&&value| value > RANK * singular[0]).count();
    (count, rank)
}

fn chain(joints: &[&'static str]) -> Vec<Joint> {
    let parents = (0..joints.len()).map(|n| n.checked_sub(1));
    joints.iter().copied().zip(parents).collect()
}

#[test]
fn a_double_pendulum_has_six() {
    let joints = chain(&["revolute(z)", "revolute(z) at [0, -1, 0]"]);
    assert_eq!(counts("[0, -9.8, 0]", &joints), (6, 6));
    // without gravity across the axes only the moment of inertia of the upper plate matters
    assert_eq!(counts("[0, 0, -9.8]", &joints), (4, 4));
}

#[test]
fn an_arm_of_three_joints_has_fifteen() {
    let joints = chain(&[
        "revolute(z)",
        "revolute(y) at [0, 0, 0.4]",
        "revolute(y) at [0.5, 0, 0]",
    ]);
    assert_eq!(counts("[0, 0, -9.81]", &joints), (15, 15));
}

#[test]
fn ur5_has_thirty_six() {
    let joints = chain(&[
        "revolute(z) at [0, 0, 0.089159]",
        "revolute(y) at [0, 0.13585, 0] rpy [0, pi/2, 0]",
        "revolute(y) at [0, -0.1197, 0.425]",
        "revolute(y) at [0, 0, 0.39225] rpy [0, pi/2, 0]",
        "revolute(z) at [0, 0.093, 0]",
        "revolute(y) at [0, 0, 0.09465]",
    ]);
    assert_eq!(counts("[0, 0, -9.81]", &joints), (36, 36));
}

#[test]
fn a_tree_has_those_of_its_branches() {
    let joints = [
        ("revolute(x)", None),
        ("revolute(-x) at [0.1, 0.2, 0]", Some(0)),
        ("revolute([0, 1, 2]) at [0, 0.1, 0.3]", Some(0)),
        ("revolute(x) at [0, 0, 0.5]", Some(1)),
        ("revolute(y) at [0.2, 0, 0]", Some(3)),
    ];
    let (count, rank) = counts("[0, 0, -9.81]", &joints);
    assert_eq!(count, rank);
    assert_eq!(count, 3 + 3 + 7 + 3 + 7);
}

#[test]
fn slides_have_a_mass() {
    let joints = chain(&["prismatic(x)", "prismatic([1, 2, 0])", "revolute(z) at [0.1, 0, 0]"]);
    assert_eq!(counts("[0, 0, -9.81]", &joints), (1 + 1 + 3, 5));
    let joints = chain(&["prismatic(z)", "revolute(z)"]);
    assert_eq!(counts("[0, 0, -9.81]", &joints), (1 + 1, 2));
    let joints = chain(&["revolute(z)", "revolute(x) at [0, 0, 1]", "prismatic([0, 1, 0])"]);
    let (count, rank) = counts("[0, 0, -9.81]", &joints);
    assert!(count >= rank, "{count} for {rank}");
    // the sign of the axis does not matter
    let [up, down] =
        ["prismatic(z)", "prismatic(-z)"].map(|slide| counts("[0, 0, -9.81]", &chain(&["revolute(z)", slide])));
    assert_eq!(up, down);
}

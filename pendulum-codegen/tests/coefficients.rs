//! A, B and C of spatial scenes: B against the Christoffel symbols of A, C against the slope of the potential energy.

mod common;

use common::numbers;
use pendulum_codegen::dynamics::{Coefficients, Kinematics};
use pendulum_codegen::expr::{Derivative, ExprId};
use pendulum_codegen::model::Model;

const SCENES: [&str; 3] = [
    // skew axes, every kind of joint, frames turned against each other
    "pub Arm {
        gravity: [1, -2, -9.81],
        body a on ground { mass: 2, com: [0.1, 0.2, 0.3], inertia: [0.3, 0.4, 0.5, 0.01, 0.02, 0.03],
            joint: revolute([1, 2, -1]) at [0.1, 0, 0.4], coordinate: q1 }
        body b on a { mass: 1.5, com: [0, -0.3, 0.1], inertia: [0.2, 0.3, 0.25, -0.02, 0.01, 0],
            joint: helical([0, 1, 1], 0.2) at [0.3, 0.1, 0] rpy [0.4, -0.7, 1.1], coordinate: q2 }
        body c on b { mass: 0.7, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1],
            joint: screw([0.3, 0, 1, 0.2, -0.5, 0.1]) at [0, 0, 0.5], coordinate: q3 }
        body d on c { mass: 0.5, com: [0, 0.1, 0.2], inertia: [0.05, 0.06, 0.07],
            joint: prismatic([1, 1, 0]) rpy [0, 0.3, 0], coordinate: q4 }
    }",
    // branches, parallel and opposite axes, a fixed joint between
    "pub Tree {
        gravity: [0, 0, -9.81],
        body trunk on ground { mass: 4, com: [0, 0.05, -0.3], inertia: [0.3, 0.2, 0.1], joint: revolute(x), coordinate: q1 }
        body left on trunk { mass: 1, com: [0.1, 0, -0.2], inertia: [0.02, 0.03, 0.02],
            joint: revolute(-x) at [0.2, 0, -0.5], coordinate: q2 }
        body bracket on trunk { mass: 0.2, com: [0, 0.1, 0], joint: fixed at [0, 0.2, 0] rpy [pi/2, 0, pi/3] }
        body right on bracket { mass: 0.7, com: [0, 0.1, -0.1], inertia: [0.02, 0.03, 0.02],
            joint: revolute(y) at [-0.2, 0, 0.1], coordinate: q3 }
        body hand on left { mass: 0.5, com: [0, 0.02, -0.1], inertia: [0.01, 0.02, 0.02],
            joint: revolute(x) at [0, 0, -0.4], coordinate: q4 }
    }",
    // a planar chain with a slider between parallel axes
    "pub Chain {
        gravity: [0, -9.81, 0],
        body a on ground { mass: 1, com: [0, -0.5, 0], inertia: 0.1, joint: revolute(z), coordinate: q1 }
        body b on a { mass: 2, com: [0.1, -0.2, 0], inertia: 0.2, joint: prismatic([1, -2, 0]) at [0, -1, 0], coordinate: q2 }
        body c on b { mass: 1, com: [0, -0.5, 0], inertia: 0.1, joint: revolute(-z) at [0.1, 0, 0], coordinate: q3 }
        body d on c { mass: 1, com: [0.2, -0.5, 0], inertia: 0.1, joint: revolute(z) at [0, -1, 0], coordinate: q4 }
    }",
];

struct Case {
    model: Model,
    coefficients: Coefficients,
    potential: ExprId,
    /// The body behind each coordinate.
    bodies: Vec<usize>,
}

fn cases() -> Vec<Case> {
    let case = |text: &str| {
        let mut model =
            pendulum_codegen::model(text.parse().expect("tokens")).unwrap_or_else(|errors| panic!("{errors}"));
        let mut kinematics = Kinematics::new(&mut model);
        let coefficients = Coefficients::new(&mut model, &mut kinematics);
        let potential = kinematics.potential(&model.graph);
        let bodies = (0..model.dof())
            .map(|k| {
                model
                    .bodies
                    .iter()
                    .position(|b| b.coordinate == Some(k))
                    .expect("a body for each coordinate")
            })
            .collect();
        Case {
            model,
            coefficients,
            potential,
            bodies,
        }
    };
    SCENES.into_iter().map(case).collect()
}

impl Case {
    fn a(&mut self, i: usize, j: usize) -> ExprId {
        let (i, j) = (self.bodies[i], self.bodies[j]);
        self.coefficients
            .a
            .get(&(i.min(j), i.max(j)))
            .copied()
            .unwrap_or_else(|| self.model.graph.zero())
    }

    fn b(&mut self, i: usize, j: usize, k: usize) -> ExprId {
        let [i, j, k] = [i, j, k].map(|n| self.bodies[n]);
        self.coefficients
            .b
            .get(&(i, j.min(k), j.max(k)))
            .copied()
            .unwrap_or_else(|| self.model.graph.zero())
    }

    fn slope(&mut self, of: ExprId, by: usize) -> ExprId {
        let by = self.model.coordinates[by].position;
        Derivative::by(by).of(&mut self.model.graph, of)
    }

    /// Two lists of expressions have the same values wherever they are evaluated.
    fn assert_equal(&self, ours: &[ExprId], theirs: &[ExprId]) {
        for seed in 0..20 {
            let mut next = numbers(100 * seed);
            let all = [ours, theirs].concat();
            let values = self.model.graph.evaluate(&all, |_| 3.0 * next());
            let (ours, theirs) = values.split_at(ours.len());
            let scale = theirs.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            for (n, (x, y)) in ours.iter().zip(theirs).enumerate() {
                assert!(
                    (x - y).abs() <= 1e-13 * scale,
                    "{x} is not {y}: number {n} of {}",
                    ours.len()
                );
            }
        }
    }
}

/// Eq. 18, completed: `B_ijk = (dA_ij/dq_k + dA_ik/dq_j - dA_jk/dq_i) / 2`. So `A' - 2 B qd` is skew.
#[test]
fn b_is_the_christoffel_symbols_of_a() {
    for mut case in cases() {
        let n = case.model.dof();
        let (mut ours, mut theirs) = (Vec::new(), Vec::new());
        for i in 0..n {
            for j in 0..n {
                for k in j..n {
                    let (ij, ik, jk) = (case.a(i, j), case.a(i, k), case.a(j, k));
                    let [first, second, third] = [(ij, k), (ik, j), (jk, i)].map(|(entry, by)| case.slope(entry, by));
                    let sum = case.model.graph.add(first, second);
                    let twice = case.model.graph.sub(sum, third);
                    let b = case.b(i, j, k);
                    ours.push(case.model.graph.add(b, b));
                    theirs.push(twice);
                }
            }
        }
        case.assert_equal(&ours, &theirs);
    }
}

#[test]
fn the_rate_of_a_less_twice_b_is_skew() {
    for mut case in cases() {
        let n = case.model.dof();
        let rates: Vec<ExprId> = case.model.coordinates.iter().map(|c| c.rate).collect();
        let mut entry = |i: usize, j: usize| {
            let mut sum = case.model.graph.zero();
            for (k, &rate) in rates.iter().enumerate() {
                let (a, b) = (case.a(i, j), case.b(i, j, k));
                let slope = case.slope(a, k);
                let g = &mut case.model.graph;
                let twice = g.add(b, b);
                let difference = g.sub(slope, twice);
                let term = g.mul(difference, rate);
                sum = g.add(sum, term);
            }
            sum
        };
        let pairs: Vec<(usize, usize)> = (0..n).flat_map(|i| (0..=i).map(move |j| (i, j))).collect();
        let upper: Vec<ExprId> = pairs.iter().map(|&(i, j)| entry(i, j)).collect();
        let lower: Vec<ExprId> = pairs.iter().map(|&(i, j)| entry(j, i)).collect();
        let negated: Vec<ExprId> = lower.into_iter().map(|x| case.model.graph.neg(x)).collect();
        case.assert_equal(&upper, &negated);
    }
}

/// Eq. 19 with its sign: a body lifted against gravity gains energy.
#[test]
fn c_is_the_slope_of_the_potential_energy() {
    for mut case in cases() {
        let ours: Vec<ExprId> = case
            .bodies
            .clone()
            .iter()
            .map(|body| case.coefficients.c[body])
            .collect();
        let potential = case.potential;
        let theirs: Vec<ExprId> = (0..case.model.dof()).map(|k| case.slope(potential, k)).collect();
        case.assert_equal(&ours, &theirs);
    }
}

#[test]
fn a_is_positive_definite() {
    for mut case in cases() {
        let n = case.model.dof();
        let entries: Vec<ExprId> = (0..n)
            .flat_map(|i| (0..n).map(move |j| (i, j)))
            .map(|(i, j)| case.a(i, j))
            .collect();
        for seed in 0..20 {
            let mut next = numbers(77 * seed);
            let mut a: Vec<f64> = case.model.graph.evaluate(&entries, |_| 3.0 * next());
            // Gauss without pivoting: a symmetric matrix is positive definite exactly when every pivot is positive
            for k in 0..n {
                assert!(a[k * n + k] > 0.0, "pivot {k} is {}", a[k * n + k]);
                for i in k + 1..n {
                    let factor = a[i * n + k] / a[k * n + k];
                    for j in 0..n {
                        a[i * n + j] -= factor * a[k * n + j];
                    }
                }
            }
        }
    }
}

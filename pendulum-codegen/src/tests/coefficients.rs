//! A, B and C of spatial scenes: B against the Christoffel symbols of A, C against the gradient of the potential
//! energy.

use super::{model, numbers};
use crate::dynamics::{Coefficients, Kinematics};
use crate::expr::{Derivative, Expr, Graph};
use crate::model::{BodyId, CoordinateId, Model};

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
        body trunk on ground { mass: 4, com: [0, 0.05, -0.3], inertia: [0.3, 0.2, 0.1], joint: revolute(x), \
            coordinate: q1 }
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
        body b on a { mass: 2, com: [0.1, -0.2, 0], inertia: 0.2, joint: prismatic([1, -2, 0]) at [0, -1, 0], \
            coordinate: q2 }
        body c on b { mass: 1, com: [0, -0.5, 0], inertia: 0.1, joint: revolute(-z) at [0.1, 0, 0], coordinate: q3 }
        body d on c { mass: 1, com: [0.2, -0.5, 0], inertia: 0.1, joint: revolute(z) at [0, -1, 0], coordinate: q4 }
    }",
];

struct Case<'g> {
    model: Model<'g>,
    coefficients: Coefficients<'g>,
    potential: Expr<'g>,
    /// Body of each coordinate.
    bodies: Vec<BodyId>,
}

impl<'g> Case<'g> {
    fn new(graph: &'g Graph, scene: &str) -> Self {
        let model = model(graph, scene);
        let mut kinematics = Kinematics::new(&model);
        let coefficients = Coefficients::new(&model, &mut kinematics);
        let potential = kinematics.potential();
        let body = |k: CoordinateId| model.bodies().find(|(_, body)| body.coordinate == Some(k));
        let bodies = CoordinateId::all(model.dof()).map(|k| body(k).expect("a body for each coordinate").0);
        Self {
            bodies: bodies.collect(),
            model,
            coefficients,
            potential,
        }
    }

    fn a(&self, i: usize, j: usize) -> Expr<'g> {
        let (i, j) = (self.bodies[i], self.bodies[j]);
        let entry = self.coefficients.a.get(&(i.min(j), i.max(j)));
        entry.copied().unwrap_or(self.model.graph.zero())
    }

    fn b(&self, i: usize, j: usize, k: usize) -> Expr<'g> {
        let [i, j, k] = [i, j, k].map(|n| self.bodies[n]);
        let entry = self.coefficients.b.get(&(i, j.min(k), j.max(k)));
        entry.copied().unwrap_or(self.model.graph.zero())
    }

    fn slope(&self, of: Expr<'g>, by: usize) -> Expr<'g> {
        Derivative::by(self.model.coordinates[by].position).of(of)
    }

    /// Asserts that two lists of expressions agree at random values of their symbols.
    fn assert_equal(&self, ours: &[Expr<'g>], theirs: &[Expr<'g>]) {
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

/// Runs a test on each scene.
fn for_each_case(test: impl Fn(&Case<'_>)) {
    for scene in SCENES {
        let graph = Graph::new();
        test(&Case::new(&graph, scene));
    }
}

/// Eq. 18, completed: `B_ijk = (dA_ij/dq_k + dA_ik/dq_j - dA_jk/dq_i) / 2`. So `A' - 2 B qd` is skew.
#[test]
fn b_is_the_christoffel_symbols_of_a() {
    for_each_case(|case| {
        let n = case.model.dof();
        let (mut ours, mut theirs) = (Vec::new(), Vec::new());
        for i in 0..n {
            for j in 0..n {
                for k in j..n {
                    let [first, second, third] =
                        [(i, j, k), (i, k, j), (j, k, i)].map(|(i, j, by)| case.slope(case.a(i, j), by));
                    ours.push(2 * case.b(i, j, k));
                    theirs.push(first + second - third);
                }
            }
        }
        case.assert_equal(&ours, &theirs);
    });
}

#[test]
fn the_rate_of_a_less_twice_b_is_skew() {
    for_each_case(|case| {
        let n = case.model.dof();
        let entry = |i: usize, j: usize| {
            let rates = case.model.coordinates.iter().map(|c| c.rate).enumerate();
            let terms = rates.map(|(k, rate)| (case.slope(case.a(i, j), k) - 2 * case.b(i, j, k)) * rate);
            case.model.graph.sum(terms)
        };
        let pairs: Vec<(usize, usize)> = (0..n).flat_map(|i| (0..=i).map(move |j| (i, j))).collect();
        let upper: Vec<Expr<'_>> = pairs.iter().map(|&(i, j)| entry(i, j)).collect();
        let negated: Vec<Expr<'_>> = pairs.iter().map(|&(i, j)| -entry(j, i)).collect();
        case.assert_equal(&upper, &negated);
    });
}

/// Eq. 19 with its sign: a body lifted against gravity gains energy.
#[test]
fn c_is_the_slope_of_the_potential_energy() {
    for_each_case(|case| {
        let ours: Vec<Expr<'_>> = case.bodies.iter().map(|body| case.coefficients.c[body]).collect();
        let theirs: Vec<Expr<'_>> = (0..case.model.dof()).map(|k| case.slope(case.potential, k)).collect();
        case.assert_equal(&ours, &theirs);
    });
}

#[test]
fn a_is_positive_definite() {
    for_each_case(|case| {
        let n = case.model.dof();
        let entries: Vec<Expr<'_>> = (0..n)
            .flat_map(|i| (0..n).map(move |j| (i, j)))
            .map(|(i, j)| case.a(i, j))
            .collect();
        for seed in 0..20 {
            let mut next = numbers(77 * seed);
            let mut a: Vec<f64> = case.model.graph.evaluate(&entries, |_| 3.0 * next());
            // Gaussian elimination without pivoting: a symmetric matrix is positive definite exactly if every pivot is
            // positive
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
    });
}

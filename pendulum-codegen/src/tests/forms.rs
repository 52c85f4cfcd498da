//! Every form of the dynamics agrees with A, B and C.

use super::{dynamics, numbers};
use crate::dynamics::{ArticulatedTangent, Dynamics, Entries, articulated, derived, partials, partials_by_recursion};
use crate::expr::{Expr, Graph};
use crate::form::{Forms, jacobian};

const SCENES: [&str; 11] = [
    // every kind of joint on skew axes
    "pub Arm {
        gravity: [1, -2, -9.81],
        body a on ground { mass: 2, com: [0.1, 0.2, 0.3], inertia: [0.3, 0.4, 0.5, 0.01, 0.02, 0.03],
            joint: revolute([1, 2, -1]) at [0.1, 0, 0.4], coordinate: q1 }
        body b on a { mass: 1.5, com: [0, -0.3, 0.1], inertia: [0.2, 0.3, 0.25, -0.02, 0.01, 0],
            joint: helical([0, 1, 1], 0.2) at [0.3, 0.1, 0] rpy [0.4, -0.7, 1.1], coordinate: q2 }
        body c on b { mass: 0.7, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1],
            joint: screw([0.3, 0, 1, 0.2, -0.5, 0.1]) at [0, 0, 0.5], coordinate: q3 }
        body d on c { mass: 0.5, com: [0, 0.1, 0.2], inertia: [0.05, 0.06, 0.07, 0.01, 0, 0.02],
            joint: prismatic([1, 1, 0]) rpy [0, 0.3, 0], coordinate: q4 }
        body e on d { mass: 0.5, com: [0, 0.1, 0.2], inertia: [0.05, 0.06, 0.07],
            joint: revolute(y) at [0.1, 0.2, 0.3], coordinate: q5 }
    }",
    // branches inside and outside a group of parallel axes, opposite axes, constant turns and fixed bodies between them
    "pub Tree {
        gravity: [0, 3, -9.81],
        body base on ground { mass: 1, com: [0.1, 0, 0], joint: fixed rpy [0.2, 0, 0] }
        body trunk on base { mass: 4, com: [0, 0.05, -0.3], inertia: [0.3, 0.2, 0.1], joint: revolute(x), \
            coordinate: q1 }
        body left on trunk { mass: 1, com: [0.1, 0, -0.2], inertia: [0.02, 0.03, 0.02],
            joint: revolute(-x) at [0.2, 0, -0.5] rpy [0.5, 0, 0], coordinate: q2 }
        body bracket on trunk { mass: 0.2, com: [0, 0.1, 0], joint: fixed at [0, 0.2, 0] rpy [pi/2, 0, pi/3] }
        body right on bracket { mass: 0.7, com: [0, 0.1, -0.1], inertia: [0.02, 0.03, 0.02, 0.001, 0.002, 0.003],
            joint: revolute(y) at [-0.2, 0, 0.1], coordinate: q3 }
        body hand on left { mass: 0.5, com: [0, 0.02, -0.1], inertia: [0.01, 0.02, 0.02, 0, 0.001, 0],
            joint: revolute(x) at [0.1, 0.3, -0.4], coordinate: q4 }
        body slider on left { mass: 0.4, com: [0.1, 0.02, -0.1], inertia: [0.01, 0.02, 0.02],
            joint: prismatic([0, 1, 1]) at [0.1, 0.3, -0.4], coordinate: q5 }
        body nail on slider { mass: 0.3, com: [0.1, 0.2, -0.1], joint: fixed at [0, 0, 0.3] rpy [0, 0.4, 0] }
        body wheel on hand { mass: 0.4, com: [0.1, 0.02, -0.1], inertia: [0.01, 0.02, 0.02],
            joint: revolute([0, 1, 2]) at [0.1, 0.3, -0.4], coordinate: q6 }
    }",
    // symbolic inertia passed on across skew axes
    "pub Symbols {
        params { m1: kg, m2: kg, m3: kg, x: m, y: m, z: m, a: kg m^2, b: kg m^2, c: kg m^2, d: kg m^2, l: m, g: m/s^2 }
        gravity: [0, 0, -g],
        body first on ground { mass: m1, com: [x, y, z], inertia: [a, b, c, d, 0, 0], joint: revolute(z), \
            coordinate: q1 }
        body second on first { mass: m2, com: [y, z, x], inertia: [b, c, a, 0, d, 0],
            joint: revolute([0, 3, 4]) at [l, 0, z], coordinate: q2 }
        body other on first { mass: m3, com: [z, x, y], inertia: [c, a, b, 0, 0, d], joint: revolute(x) at [0, l, 0], \
            coordinate: q3 }
        body tip on other { mass: m2, com: [x, 0, z], inertia: [c, b, b], joint: prismatic(x) at [0, 0, l], \
            coordinate: q4 }
    }",
    // parameters, absolute and relative angles, friction and springs
    "pub Chain {
        params { m: kg, l: m, k: N m, c: N m s }
        gravity: [0, -9.81, 0],
        body a on ground { mass: m, com: [0.1, -l, 0], inertia: 0.1, joint: revolute(z), coordinate: q1, friction: c }
        body b on a { mass: 2, com: [0.1, -0.2, 0], inertia: 0.2, joint: prismatic([1, -2, 0]) at [0, -l, 0], \
            coordinate: q2 }
        body d on b { mass: m, com: [0, -l, 0], inertia: 0.1, joint: revolute(-z) at [0.1, 0, 0], coordinate: q3, \
            spring: (k, 1) }
        body e on d { mass: 1, com: [0.2, -0.5, 0], inertia: 0.1, joint: revolute(z) at [0, -1, 0], \
            coordinate: q4 absolute }
    }",
    "pub Slides {
        gravity: [1, 2, 3],
        body a on ground { mass: 1, com: [0.1, 0.2, 0.3], inertia: [0.1, 0.1, 0.1], joint: prismatic([1, 2, 2]), \
            coordinate: q1 }
        body b on a { mass: 2, com: [0.1, 0.2, 0.3], inertia: [0.1, 0.1, 0.1], joint: prismatic(y), coordinate: q2 }
    }",
    "pub Screws {
        gravity: [1, 2, 3],
        body a on ground { mass: 1, com: [0.1, 0.2, 0.3], inertia: [0.1, 0.2, 0.2], joint: helical(x, 0.3), \
            coordinate: q1 }
        body b on a { mass: 2, com: [0.1, 0.2, 0.3], inertia: [0.1, 0.1, 0.15], \
            joint: helical(x, -0.1) at [0, 0.2, 0], coordinate: q2 }
        body c on b { mass: 2, com: [0.1, 0.2, 0.3], inertia: [0.1, 0.1, 0.15], joint: revolute(-x) at [1, 0.2, 0], \
            coordinate: q3 }
    }",
    // every kind of force between joints, on bodies behind skew, fixed and opposite joints
    "pub Pushed {
        gravity: [1, -2, -9.81],
        point nail on ground at [1, 2, 3],
        point elbow on a at [0.3, 0, 0.1], point hand on c at [0, 0.2, 0.4], point horn on b at [0.1, 0, 0],
        force on hand: [elbow.y, t, dot(hand.x)],
        force on horn: [1, dot(q2), horn.z] in b,
        force on elbow: [0.3, 1, hand.x] in c,
        force q2: -0.2*dot(q1)^3,
        spring between hand and nail: (3, 0.7),
        spring between elbow and nail: (2, 0),
        damper between nail and horn: 0.4,
        damper between hand and elbow: 0.3,
        potential: 0.2*hand.z^4 + cos(q1)*t,
        dissipation: 0.1*(dot(q2) + dot(hand.y))^2,
        body a on ground { mass: 2, com: [0.1, 0.2, 0.3], inertia: [0.3, 0.4, 0.5, 0.01, 0.02, 0.03],
            joint: revolute([1, 2, -1]) at [0.1, 0, 0.4], coordinate: q1 }
        body b on a { mass: 1.5, com: [0, -0.3, 0.1], inertia: [0.2, 0.3, 0.25],
            joint: helical([0, 1, 1], 0.2) at [0.3, 0.1, 0] rpy [0.4, -0.7, 1.1], coordinate: q2 }
        body c on b { mass: 0.7, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1], \
            joint: fixed at [0, 0.2, 0.5] rpy [1, 0.2, 0] }
        body d on a { mass: 0.5, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1], joint: prismatic(-y) at [0, 0.2, 0.5], \
            coordinate: q3 }
    }",
    // drives below, between and above free joints, absolute angles on driven ones
    "pub Driven {
        params { w: rad/s, l: m }
        gravity: [1, -9.81, 0],
        point tip on e at [0, -l, 0],
        force on tip: [dot(tip.x), 1, 0],
        force q4: -dot(q4),
        body rail on ground { mass: 0.3, joint: prismatic([1, 2, 0]), motion: l*sin(w*t) }
        body crank on rail { mass: 0.4, com: [0.1, 0.2, 0], inertia: 0.2, joint: revolute(z) at [0, l, 0], \
            motion: w*t + t^2 }
        body a on crank { mass: 1, com: [0.1, -l, 0], inertia: 0.1, joint: revolute(z), coordinate: q1 absolute, \
            friction: 0.2 }
        body b on a { mass: 2, com: [0.1, -0.2, 0], inertia: 0.2, joint: prismatic([1, -2, 0]) at [0, -l, 0], \
            motion: cos(t) }
        body d on b { mass: 1, com: [0, -l, 0], inertia: 0.1, joint: revolute(-z) at [0.1, 0, 0], coordinate: q3, \
            spring: (3, 1) }
        body e on d { mass: 1, com: [0.2, -0.5, 0], inertia: 0.1, joint: revolute(z) at [0, -1, 0], \
            coordinate: q4 absolute }
        body f on e { mass: 1, com: [0.2, -0.5, 0], inertia: 0.1, joint: revolute(-z) at [0, -1, 0], motion: sin(t) }
    }",
    "pub Space {
        gravity: [1, -2, -9.81],
        body a on ground { mass: 2, com: [0.1, 0.2, 0.3], inertia: [0.3, 0.4, 0.5, 0.01, 0.02, 0.03],
            joint: revolute([1, 2, -1]) at [0.1, 0, 0.4], coordinate: q1 }
        body b on a { mass: 1.5, com: [0, -0.3, 0.1], inertia: [0.2, 0.3, 0.25, -0.02, 0.01, 0],
            joint: helical([0, 1, 1], 0.2) at [0.3, 0.1, 0] rpy [0.4, -0.7, 1.1], motion: sin(t) + t^2 }
        body c on b { mass: 0.7, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1],
            joint: screw([0.3, 0, 1, 0.2, -0.5, 0.1]) at [0, 0, 0.5], coordinate: q3 }
        body d on c { mass: 0.5, com: [0, 0.1, 0.2], inertia: [0.05, 0.06, 0.07, 0.01, 0, 0.02],
            joint: prismatic([1, 1, 0]) rpy [0, 0.3, 0], motion: cos(2*t) }
        body e on d { mass: 0.5, com: [0, 0.1, 0.2], inertia: [0.05, 0.06, 0.07],
            joint: revolute(y) at [0.1, 0.2, 0.3], coordinate: q5 }
    }",
    // branches with drives at their ends and below them; one drive is constant
    "pub Branches {
        gravity: [0, 3, -9.81],
        point hand on wheel at [0.1, 0, 0.2],
        force on hand: [1, dot(hand.y), 0] in left,
        body trunk on ground { mass: 4, com: [0, 0.05, -0.3], inertia: [0.3, 0.2, 0.1], joint: revolute(x), \
            motion: t + sin(t) }
        body left on trunk { mass: 1, com: [0.1, 0, -0.2], inertia: [0.02, 0.03, 0.02],
            joint: revolute(-x) at [0.2, 0, -0.5] rpy [0.5, 0, 0], coordinate: q2 }
        body bracket on trunk { mass: 0.2, com: [0, 0.1, 0], joint: revolute(y) at [0, 0.2, 0] rpy [pi/2, 0, pi/3], \
            motion: 0.4 }
        body right on bracket { mass: 0.7, com: [0, 0.1, -0.1], inertia: [0.02, 0.03, 0.02, 0.001, 0.002, 0.003],
            joint: revolute(y) at [-0.2, 0, 0.1], coordinate: q3 }
        body hand on left { mass: 0.5, com: [0, 0.02, -0.1], inertia: [0.01, 0.02, 0.02, 0, 0.001, 0],
            joint: helical(x, 0.2) at [0.1, 0.3, -0.4], motion: cos(3*t) }
        body slider on right { mass: 0.4, com: [0.1, 0.02, -0.1], inertia: [0.01, 0.02, 0.02],
            joint: prismatic([0, 1, 1]) at [0.1, 0.3, -0.4], motion: t^2 }
        body wheel on hand { mass: 0.4, com: [0.1, 0.02, -0.1], inertia: [0.01, 0.02, 0.02],
            joint: revolute([0, 1, 2]) at [0.1, 0.3, -0.4], coordinate: q6 }
    }",
    // joints that follow others: one parallel, one sliding, and one that follows two
    "pub Following {
        gravity: [1, -2, -9.81],
        point tip on d at [0.1, 0.2, 0.3],
        force on tip: [0, dot(tip.x), 1],
        body a on ground { mass: 2, com: [0.1, 0.2, 0.3], inertia: [0.3, 0.4, 0.5, 0.01, 0.02, 0.03],
            joint: revolute([1, 2, -1]) at [0.1, 0, 0.4], coordinate: q1, friction: 0.1 }
        body b on a { mass: 1.5, com: [0, -0.3, 0.1], inertia: [0.2, 0.3, 0.25, -0.02, 0.01, 0],
            joint: revolute([-1, -2, 1]) at [0.3, 0.1, 0], motion: 0.3 - 2*q1, spring: (3, 0.5) }
        body c on b { mass: 0.7, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1],
            joint: helical([0.3, 0, 1], 0.2) at [0, 0, 0.5] rpy [0.4, -0.7, 1.1], coordinate: q3 }
        body d on c { mass: 0.5, com: [0, 0.1, 0.2], inertia: [0.05, 0.06, 0.07, 0.01, 0, 0.02],
            joint: prismatic([1, 1, 0]) rpy [0, 0.3, 0], motion: q3 - 0.1, torque: -0.3*qd }
        body e on b { mass: 0.3, com: [0, 0.1, 0.2], inertia: [0.05, 0.06, 0.07], joint: revolute(y) at [0, 0.2, 0], \
            motion: q1 + 3*q3 }
    }",
];

/// Forces at points either along the coordinates or as wrenches on links.
const WAYS: [bool; 2] = [false, true];

#[test]
fn the_recursion_is_a_b_and_c() {
    for scene in SCENES {
        let graph = Graph::new();
        let (model, dynamics) = dynamics(&graph, scene);
        for pushed in WAYS {
            let recursive = Dynamics::recursive(&model, dynamics.lagrangian.potential, pushed);
            let [ours, theirs] = [recursive, dynamics.clone()].map(|mut dynamics| {
                dynamics.balance.tangent = None;
                dynamics.entries()
            });
            agree(&graph, &ours, &theirs, scene);
        }
    }
}

#[test]
fn articulated_bodies_move_by_a_b_and_c() {
    for scene in SCENES {
        let graph = Graph::new();
        let (model, dynamics) = dynamics(&graph, scene);
        if model.has_followers() {
            // the articulated-body algorithm needs joints that move independently
            continue;
        }
        for pushed in WAYS {
            let (accelerations, _) = articulated(&model, pushed, &[]);
            let symbols = model.coordinates.iter().map(|c| c.acceleration);
            let known = symbols.zip(accelerations).collect();
            let left = graph.substitute(&dynamics.balance.rows, known);
            let zero = vec![graph.zero(); left.len()];
            // the remainder of A qdd + bias - force, beside the bias
            let zero: Vec<Expr<'_>> = zero
                .into_iter()
                .chain(dynamics.lagrangian.bias.iter().copied())
                .collect();
            let left: Vec<Expr<'_>> = left
                .into_iter()
                .chain(dynamics.lagrangian.bias.iter().copied())
                .collect();
            agree(&graph, &left, &zero, scene);
        }
    }
}

#[test]
fn the_derivatives_of_the_recursion_are_those_of_its_expressions() {
    for scene in SCENES {
        let graph = Graph::new();
        let (model, dynamics) = dynamics(&graph, scene);
        let state = model.state();
        let derived = partials(&dynamics.balance, &state);
        for pushed in WAYS {
            let recursive = Dynamics::recursive(&model, dynamics.lagrangian.potential, pushed);
            let known = partials_by_recursion(&recursive.balance, &model.coordinates, &state).expect("a tangent");
            agree(&graph, &known.concat(), &derived.concat(), scene);
        }
    }
}

#[test]
fn the_derivatives_of_articulated_bodies_are_those_of_their_accelerations() {
    for scene in SCENES {
        let graph = Graph::new();
        let (model, dynamics) = dynamics(&graph, scene);
        if model.has_followers() {
            continue;
        }
        let (state, symbols) = (model.state(), model.coordinates.iter().map(|c| c.acceleration));
        let (accelerations, _) = articulated(&model, false, &[]);
        let recursive = Dynamics::recursive(&model, dynamics.lagrangian.potential, false);
        let tangent = ArticulatedTangent::new(&model, &[]);
        let columns = tangent.columns(&recursive.balance, &model.coordinates, &state);
        let columns = model.with_drives(&columns.expect("a tangent").concat());
        let columns = graph.substitute(&columns, symbols.zip(accelerations.iter().copied()).collect());
        agree(&graph, &columns, &derived(&accelerations, &state).concat(), scene);
    }
}

/// Declaration of planar links in a row.
fn chain(links: usize) -> String {
    let body = |k: usize| {
        let parent = k
            .checked_sub(1)
            .map_or("ground".to_owned(), |below| format!("b{below}"));
        let at = if k == 0 { "0" } else { "-0.5" };
        format!(
            "body b{k} on {parent} {{ mass: 1.1, com: [0, -0.2, 0], inertia: 0.03, joint: revolute(z) at [0, {at}, 0], \
             coordinate: q{k}, friction: 0.01 }}",
        )
    };
    let bodies: String = (0..links).map(body).collect();
    format!("pub Chain {{ gravity: [0, -9.81, 0], generate: [rhs, jacobian], {bodies} }}")
}

/// The length of derivatives by articulated bodies grows with the square of the number of links.
#[test]
fn the_jacobian_of_a_long_chain_is_short() {
    let operations = |links: usize| {
        let graph = Graph::new();
        let (model, dynamics) = dynamics(&graph, &chain(links));
        let mut forms = Forms::new(&model, &dynamics);
        jacobian(&mut forms, &model).operations.arithmetic() as f64
    };
    let [short, long] = [10, 20].map(operations);
    assert!(short <= 4400.0 && long / short <= 4.0, "{short} and {long} operations");
}

#[test]
fn the_documentation_names_long_functions() {
    let code = |links: usize| crate::expand(chain(links).parse().expect("tokens")).to_string();
    let advice = "They take long to compile";
    assert!(!code(3).contains(advice));
    let code = code(27);
    assert!(code.contains(advice) && code.contains("- `jacobian`, 28") && !code.contains("- `rhs`"));
}

/// Asserts that two lists of expressions agree at random states, up to rounding errors.
fn agree(graph: &Graph, ours: &[Expr<'_>], theirs: &[Expr<'_>], scene: &str) {
    for seed in 0..20 {
        let mut next = numbers(13 * seed);
        let values = graph.evaluate(&[ours, theirs].concat(), |_| 3.0 * next());
        let (ours, theirs) = values.split_at(ours.len());
        let scale = theirs.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        for (n, (x, y)) in ours.iter().zip(theirs).enumerate() {
            assert!(
                (x - y).abs() <= 1e-12 * scale,
                "{x} is not {y}: number {n} of {} in {scene}",
                ours.len()
            );
        }
    }
}

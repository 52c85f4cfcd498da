//! Floating bodies, whose accelerations are solved along their own axes.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use super::{is_thorough, model, near, numbers};
use crate::dynamics::{ArticulatedTangent, Dynamics, articulated, derived, partials_by_recursion};
use crate::expr::{Expr, Graph, Symbol};
use crate::form::{Basis, Forms, jacobian, rhs};
use crate::model::Model;

const SCENES: [&str; 7] = [
    // one body off its centre of mass, on a frame that is turned
    "pub Stone {
        params { g: m/s^2, c: m, k: N/m }
        gravity: [0.3*g, g, -9.81],
        body post on ground { joint: fixed at [1, 2, 3] rpy [0.3, -0.2, 0.5] }
        body stone on post { mass: 1.3, com: [c, 0.1, 0.2*c], inertia: [0.1, 0.2, 0.25], \
            joint: free at [0, 1, 0] rpy [0, 0.4, 0.1], orientation: o, position: p }
        point a on stone at [0.1, 0.2, 0.3], point b on ground at [0, 0, 1],
        spring between a and b: (k, 0), force on a: [0.1, 0.2*dot(o).x, p.x] in stone, potential: 0.3*o.x*p.y,
    }",
    // a carrier of hinges and a loop, beside another floating body and a pendulum; one hinge is driven
    "pub Carrier {
        gravity: [0.1, 0.4, -9.81],
        body pendulum on ground { mass: 1, com: [0, 0, -0.4], inertia: [0.1, 0.1, 0.1], joint: revolute(x), \
            coordinate: r }
        body trunk on ground { mass: 2, com: [0.1, 0.2, 0.1], inertia: [0.1, 0.2, 0.25], joint: free, orientation: o, \
            position: p }
        body arm on trunk { mass: 0.4, com: [0.1, 0.05, 0.2], inertia: [0.01, 0.02, 0.025], \
            joint: revolute([1, 1, 0]) at [0.2, 0.1, 0], coordinate: lean, friction: 0.3 }
        body hand on arm { mass: 0.2, com: [0.1, 0, 0.1], inertia: [0.01, 0.02, 0.015], joint: prismatic(z), \
            motion: 0.3*sin(t) }
        body crank on trunk { mass: 0.5, com: [0.1, 0, 0], inertia: [0.002, 0.003, 0.004], joint: revolute(z), \
            coordinate: a near 0.8 }
        body coupler on crank { mass: 1.1, com: [0.2, 0.1, 0], inertia: [0.02, 0.01, 0.02], \
            joint: revolute(z) at [0.2, 0, 0], coordinate: b depends near -0.3 }
        body rocker on trunk { mass: 0.9, com: [0.2, 0.1, 0], inertia: [0.01, 0.02, 0.02], \
            joint: revolute(z) at [0.6, 0, 0], coordinate: c depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        body ball on ground { mass: 0.3, com: [0, 0, 0.1], inertia: [0.01, 0.01, 0.01], joint: free at [1, 0, 0], \
            orientation: u, position: s }
        point x on pendulum at [0, 0, -1], point y on ball at [0.1, 0, 0], point z on hand,
        spring between x and y: (3, 0.1), damper between y and z: 0.2,
    }",
    // a body floating relative to a moving one is solved along the axes of its position
    "pub Riding {
        gravity: [0.1, 0.4, -9.81],
        body carrier on ground { mass: 1, com: [0.3, 0, -0.4], inertia: [0.1, 0.1, 0.1], joint: revolute(x), \
            coordinate: r }
        body rider on carrier { mass: 2, com: [0.1, 0.2, 0.1], inertia: [0.1, 0.2, 0.25], joint: free at [0.1, 0, 0], \
            orientation: o, position: p }
        point a on rider at [0.1, 0.2, 0.3], point b on carrier at [0, 0, 1], point c on ground at [1, 1, 1],
        spring between a and b: (3, 0.1), damper between a and c: 0.2, force on a: [0.1, 0.2*dot(o).x, p.x] in rider,
    }",
    // so is a body with a follower
    "pub Followed {
        gravity: [0.1, 0.4, -9.81],
        body stone on ground { mass: 1, com: [0.1, 0.2, 0.1], inertia: [0.1, 0.2, 0.25], joint: free, orientation: o, \
            position: p }
        body arm on stone { mass: 0.5, com: [0.3, 0, 0], inertia: [0.01, 0.02, 0.02], joint: revolute(z), \
            motion: 2*p.x - p.z }
    }",
    // and a body tied to the ground by a loop
    "pub Tied {
        gravity: [0.1, 0.4, -9.81],
        body stone on ground { mass: 2, com: [0.1, 0.2, 0.1], inertia: [0.1, 0.2, 0.25], joint: free, orientation: o, \
            position: p }
        body crank on stone { mass: 0.5, com: [0.1, 0, 0], inertia: [0.002, 0.003, 0.004], joint: revolute(z), \
            coordinate: a depends near 0.42 }
        body coupler on crank { mass: 1.1, com: [0.2, 0.1, 0], inertia: [0.02, 0.01, 0.02], \
            joint: revolute(x) at [0.2, 0, 0], coordinate: b depends near 0.13 }
        body rod on coupler { mass: 1.1, com: [0.2, 0.1, 0], inertia: [0.02, 0.01, 0.02], \
            joint: prismatic(y) at [0.2, 0, 0], coordinate: c depends near 0.78 }
        close rod to ground at [0.05, 0.87, 0.1]: ball,
    }",
    // articulated bodies: ball joints in a row
    "pub Chain {
        params { g: m/s^2, c: m, k: N*m*s }
        gravity: [0.3*g, g, -9.81],
        body a on ground { mass: 1, com: [0.01, c, -0.2], inertia: [0.1, 0.2, 0.15, 0.01, 0.02, -0.01], \
            joint: ball at [0.1, 0, 0] rpy [0, 0.4, 0.1], orientation: o, friction: k }
        body b on a { mass: 0.5, com: [0.1, 0, 0], inertia: [0.02, 0.03, 0.04], joint: ball at [0.1, 0, -0.5], \
            orientation: u }
        body c on b { mass: 0.3, com: [0, 0.1, -0.2], inertia: [0.01, 0.02, 0.015], \
            joint: ball at [0, 0.1, -0.4] rpy [0.2, 0, 0.3], orientation: v }
        point x on c at [0.1, 0, -1], point y on ground at [0.1, 0, 0],
        spring between x and y: (3, 0.1), force on x: [0.1, 0.2*dot(u).x, 0.3] in c, potential: 0.3*o.x*v.y,
    }",
    // articulated bodies in flight, with a slide and a drive between them
    "pub Tail {
        gravity: [0.1, 0.4, -9.81],
        body post on ground { joint: fixed at [1, 2, 3] rpy [0.3, -0.2, 0.5] }
        body head on post { mass: 1, com: [0.01, 0.1, -0.2], inertia: [0.1, 0.2, 0.15], \
            joint: free at [0, 1, 0] rpy [0, 0.4, 0.1], orientation: o, position: p }
        body a on head { mass: 0.5, com: [0.1, 0, 0], inertia: [0.02, 0.03, 0.04], joint: ball at [0.1, 0, -0.5], \
            orientation: u }
        body b on a { mass: 0.2, com: [0.1, 0, 0.1], inertia: [0.01, 0.02, 0.015], joint: prismatic(z), \
            motion: 0.3*sin(t) }
        body c on b { mass: 0.3, com: [0, 0.1, -0.2], inertia: [0.01, 0.02, 0.015], \
            joint: ball at [0, 0.1, -0.4] rpy [0.2, 0, 0.3], orientation: v }
        body d on c { mass: 0.3, com: [0, 0.1, -0.2], inertia: [0.01, 0.02, 0.015], joint: revolute(x) at [0, 0.1, 0], \
            coordinate: r, friction: 0.3 }
        body e on d { mass: 0.1, com: [0, 0.1, -0.2], inertia: [0.01, 0.02, 0.015], \
            joint: helical(x, 0.1) at [0, 0.1, 0], coordinate: s }
        point x on e at [0.1, 0, -1], point y on ground at [0.1, 0, 0],
        spring between x and y: (3, 0.1), force on x: [0.1, 0.2*p.x, 0.3] in e,
    }",
];

/// True for each scene that is solved by articulated bodies.
const BY_LINKS: [bool; 7] = [false, false, false, false, false, true, true];

/// Random values of the symbols of a scene, near its assembled configuration, with orientations of this length.
fn values_of(model: &Model<'_>, text: &str, seed: u32, length: f64) -> BTreeMap<String, f64> {
    let mut next = numbers(seed);
    let mut value = |name: &str| near(text, name).map_or_else(&mut next, |near| near + 0.01);
    let symbols = model.state().into_iter().chain([model.time]);
    let symbols = symbols.chain(model.parameters.iter().map(|parameter| parameter.symbol));
    let mut values: BTreeMap<String, f64> = symbols.map(|x| (name(x), value(&name(x)))).collect();
    for coordinate in model.coordinates.iter().filter(|c| c.is_of_orientation()) {
        let quaternion = coordinate.changes.iter().map(|&(component, _)| name(component));
        let quaternion: Vec<String> = quaternion.collect();
        let size = quaternion.iter().map(|name| values[name].powi(2)).sum::<f64>().sqrt();
        for name in quaternion {
            values.entry(name).and_modify(|x| *x *= length / size);
        }
    }
    values
}

fn name(symbol: Expr<'_>) -> String {
    symbol.as_symbol().expect("a symbol").name.clone()
}

fn evaluated(model: &Model<'_>, roots: &[Expr<'_>], values: &BTreeMap<String, f64>) -> Vec<f64> {
    let value = |symbol: &Symbol| *values.get(&symbol.name).unwrap_or_else(|| panic!("{}", symbol.name));
    model.graph.evaluate(&model.written_out(roots), value)
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, x| x.abs().max(largest))
}

#[test]
fn what_flies_moves_as_along_its_position() {
    for (n, text) in SCENES.iter().enumerate() {
        let graph = Graph::new();
        let model = model(&graph, text);
        let floating = [1, 2, 0, 0, 0, 0, 1];
        assert_eq!(model.floating().len(), floating[n], "{text}");
        let dynamics = Dynamics::new(&model);
        let forms = Forms::new(&model, &dynamics);
        let solved = forms.accelerations();
        assert_eq!(solved.form.basis == Basis::Articulated, BY_LINKS[n], "{text}");
        let accelerations = solved.roots;
        let known = model.coordinates.iter().map(|c| c.acceleration).zip(accelerations);
        let left = graph.substitute(&dynamics.balance.rows, known.collect());
        for seed in 0..5 {
            let values = values_of(&model, text, seed, 1.0);
            let left = largest(&evaluated(&model, &left, &values));
            let size = largest(&evaluated(&model, &dynamics.balance.residual, &values));
            assert!(left <= 1e-12 * size, "{left} of {size} is left in {text}");
        }
    }
}

/// Off the unit length of quaternions, where methods evaluate their stages, the Jacobian is still the derivative of the
/// right-hand side.
#[test]
fn the_jacobian_of_what_flies_is_that_of_its_right_hand_side() {
    /// Step of the fourth-order differences, which lose some five of sixteen digits.
    const STEP: f64 = 1e-4;
    let every = if is_thorough() { 1 } else { 3 };
    for text in SCENES.iter().step_by(every) {
        let graph = Graph::new();
        let model = model(&graph, text);
        let mut forms = Forms::new(&model, &Dynamics::new(&model));
        let rates = rhs(&mut forms, &model).roots;
        let roots = jacobian(&mut forms, &model).roots;
        let values = values_of(&model, text, 3, 1.05);
        let all = evaluated(&model, &roots, &values);
        let (own, columns) = all.split_at(rates.len());
        let expected = evaluated(&model, &rates, &values);
        let off = own.iter().zip(&expected).map(|(a, b)| a - b).collect::<Vec<_>>();
        assert!(largest(&off) <= 1e-12 * largest(own), "{text}");
        for (symbol, column) in model.state().iter().zip(columns.chunks(rates.len())) {
            let name = &symbol.as_symbol().expect("a symbol").name;
            let at = |steps: f64| {
                let mut values = values.clone();
                values.entry(name.clone()).and_modify(|x| *x += steps * STEP);
                evaluated(&model, &rates, &values)
            };
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(at);
            for (n, &entry) in column.iter().enumerate() {
                let difference = (a[n] - 8.0 * b[n] + 8.0 * c[n] - d[n]) / (12.0 * STEP);
                let off = (entry - difference).abs();
                assert!(
                    off <= 1e-9 * largest(column).max(1.0),
                    "{entry} by {name} is not {difference} in {text}"
                );
            }
        }
    }
}

/// Two limbs and a tail on a floating trunk. The limbs branch again.
const CRAWLER: &str = "pub Crawler {
    params { g: m/s^2, c: m }
    gravity: [0.3*g, g, -9.81],
    body post on ground { joint: fixed at [1, 2, 3] rpy [0.3, -0.2, 0.5] }
    body trunk on post { mass: 1.3, com: [c, 0.1, 0.2*c], inertia: [0.1, 0.2, 0.25], \
        joint: free at [0, 1, 0] rpy [0, 0.4, 0.1], orientation: o, position: p }
    body hip on trunk { mass: 0.5, com: [0.1, 0, 0], inertia: [0.02, 0.03, 0.04], joint: revolute([1, 2, 0]) at \
        [0.1, 0.2, 0], coordinate: hip, friction: 0.3 }
    body thigh on hip { mass: 0.4, com: [0.1, 0, 0.1], inertia: [0.02, 0.03, 0.04, 0.001, 0, 0.002], \
        joint: helical(y, 0.2) at [0, 0, -0.3], coordinate: thigh }
    body toe on thigh { mass: 0.2, com: [0.1, 0, 0], inertia: [0.01, 0.02, 0.02], joint: revolute(x) at \
        [0, 0.1, -0.3], coordinate: toe }
    body heel on thigh { mass: 0.3, com: [0, 0.1, 0], inertia: [0.02, 0.01, 0.02], joint: prismatic([1, 0, 1]), \
        coordinate: heel, spring: (3, 0.1) }
    body spur on heel { mass: 0.1, com: [0.1, 0, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(z) at [0, 0, 0.1], \
        coordinate: spur }
    body tail on trunk { mass: 0.3, com: [0, 0, 0.2], inertia: [0.02, 0.02, 0.01], joint: revolute(x) at [-0.2, 0, 0], \
        coordinate: tail }
    body tip on tail { mass: 0.1, com: [0, 0, 0.1], inertia: [0.01, 0.01, 0.01], joint: revolute(x) at [0, 0, 0.3], \
        coordinate: tip }
    point a on toe at [0.1, 0.2, 0.3], point b on tip at [0, 0, 1],
    spring between a and b: (3, 0.1), force on a: [0.1, 0.2*dot(o).x, p.x] in trunk, potential: 0.3*o.x*p.y,
}";

/// Derivatives without differentiating the equations: of the forces, and of the accelerations of articulated bodies.
#[test]
fn what_flies_is_derived_link_by_link() {
    for text in [SCENES[0], CRAWLER] {
        let graph = Graph::new();
        let model = model(&graph, text);
        let (floating, state) = (model.floating(), model.state());
        let balance = Dynamics::balance_of_links(&model, false, &floating);
        let (accelerations, _) = articulated(&model, false, &floating);
        let symbols = model.coordinates.iter().map(|c| c.acceleration);
        let known: FxHashMap<_, _> = symbols.zip(accelerations.iter().copied()).collect();
        let tangent = ArticulatedTangent::new(&model, &floating);
        let columns = tangent
            .columns(&balance, &model.coordinates, &state)
            .expect("a tangent");
        let of_forces = partials_by_recursion(&balance, &model.coordinates, &state).expect("a tangent");
        let ours = graph.substitute(&[columns.concat(), of_forces.concat()].concat(), known.clone());
        let of_rows = graph.substitute(&derived(&balance.rows, &state).concat(), known);
        let theirs = [derived(&accelerations, &state).concat(), of_rows].concat();
        for seed in 0..5 {
            let values = values_of(&model, text, seed, 1.05);
            let [ours, theirs] = [&ours, &theirs].map(|roots| evaluated(&model, roots, &values));
            let off = ours.iter().zip(&theirs).map(|(a, b)| a - b).collect::<Vec<_>>();
            assert!(largest(&off) <= 1e-12 * largest(&theirs), "{} in {text}", largest(&off));
        }
    }
}

/// The mass matrix of one rigid body is constant along its own axes, so it is inverted once, when the model is built.
#[test]
fn a_rigid_body_in_flight_divides_nothing() {
    let text = "pub Handle {
        body handle on ground { mass: 0.4, com: [0.01, 0, 0], inertia: [1e-3, 2e-3, 3e-3], joint: free, \
            orientation: o, position: p }
    }";
    let graph = Graph::new();
    let model = model(&graph, text);
    let mut forms = Forms::new(&model, &Dynamics::new(&model));
    let [rhs, jacobian] = [rhs, jacobian].map(|routine| routine(&mut forms, &model).operations);
    let counted =
        [rhs, jacobian].map(|operations| (operations.additions + operations.multiplications, operations.divisions));
    assert!(counted[0].0 <= 80 && counted[1].0 <= 178, "{counted:?}");
    assert_eq!(counted.map(|(_, divisions)| divisions), [0, 0]);
    let series = forms.taylor(&model);
    assert!(series.slots.len() <= 35, "{} products of series", series.slots.len());
}

/// Without a mass matrix each ball adds about as many operations as the one before.
#[test]
fn balls_in_a_row_take_as_many_operations_each() {
    /// Maximum number of additions and multiplications for each ball. With a mass matrix the fifth exceeds twice this
    /// number.
    const EACH: usize = 550;
    let additions_and_multiplications = |balls: usize| {
        let body = |k: usize| {
            let on = k
                .checked_sub(1)
                .map_or("ground".to_owned(), |below| format!("b{below}"));
            format!(
                "body b{k} on {on} {{ mass: {}, com: [0.01, 0.02, -0.25], inertia: [0.1, 0.2, 0.15],
                    joint: ball at [0.1, 0, -0.5], orientation: o{k} }}\n",
                k + 1
            )
        };
        let bodies: String = (0..balls).map(body).collect();
        let graph = Graph::new();
        let model = model(&graph, &format!("pub Chain {{ gravity: [0, 0, -9.81], {bodies} }}"));
        let mut forms = Forms::new(&model, &Dynamics::new(&model));
        let operations = rhs(&mut forms, &model).operations;
        operations.additions + operations.multiplications
    };
    let counts = [3, 4, 5].map(additions_and_multiplications);
    let [three, four, five] = counts;
    assert!(
        four - three <= EACH && five - four <= EACH && five <= 4 * EACH,
        "{counts:?}"
    );
}

//! How code grows with the number of joints, and that the form which was chosen is the shortest.

use pendulum_codegen::Function;
use pendulum_codegen::pass::{Basis, Chosen, Operations};

/// Links of one shape that turn about parallel axes.
fn planar(n: usize) -> String {
    let bodies = (0..n).map(|k| {
        let (parent, at) = below(k, "[0, -1, 0]");
        format!("body b{k} on {parent}: link {{ joint: revolute(z) at {at}, coordinate: q{k}, friction: c }}")
    });
    format!(
        "pub Chain {{ params {{ g: m/s^2, m: kg, c: N m s }} gravity: [0, -g, 0], generate: [rhs],
            shape link {{ mass: m, com: [0.02, -0.5, 0], inertia: 0.1 }} {} }}",
        bodies.collect::<String>()
    )
}

/// Bodies of any shape on joints that turn about z, y and x in turns.
fn spatial(n: usize) -> String {
    let bodies = (0..n).map(|k| {
        let (parent, at) = below(k, "[0.1, 0.05, 0.3]");
        format!(
            "body b{k} on {parent} {{ mass: {}, com: [0.02, 0.01, 0.1], inertia: [0.1, 0.12, 0.05, 0.001, 0.002, 0.003],
                joint: revolute({}) at {at}, coordinate: q{k} }}",
            k + 1,
            ["z", "y", "x"][k % 3]
        )
    });
    format!(
        "pub Chain {{ gravity: [0, 0, -9.81], generate: [rhs], {} }}",
        bodies.collect::<String>()
    )
}

fn below(k: usize, at: &str) -> (String, &str) {
    match k {
        0 => ("ground".to_owned(), "[0, 0, 0]"),
        _ => (format!("b{}", k - 1), at),
    }
}

fn right_hand_side(scene: &str) -> Chosen {
    let tokens = scene.parse().expect("tokens");
    let program = pendulum_codegen::program(tokens).unwrap_or_else(|errors| panic!("{errors}"));
    program.functions[&Function::Rhs].clone()
}

fn on(chosen: &Chosen, basis: Basis) -> Operations {
    let all = chosen.others.iter().copied().chain([(chosen.form, chosen.operations)]);
    let (_, operations) = all.into_iter().find(|(form, _)| form.basis == basis).expect("known");
    operations
}

fn flops(operations: Operations) -> usize {
    operations.additions + operations.multiplications
}

#[test]
fn planar_chains_grow_with_their_length() {
    let chains: Vec<Chosen> = [6, 7, 8, 9].map(|n| right_hand_side(&planar(n))).into();
    let counts: Vec<usize> = chains.iter().map(|chosen| flops(chosen.operations)).collect();
    let steps: Vec<usize> = counts.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(steps.windows(2).all(|pair| pair[0] == pair[1]), "{counts:?}");
    assert!(chains.iter().all(|chosen| chosen.form.basis == Basis::Articulated));
}

#[test]
fn spatial_chains_grow_with_the_square_of_their_length_at_most() {
    let chains: Vec<(usize, Chosen)> = [4, 5, 6, 7, 8].map(|n| (n, right_hand_side(&spatial(n)))).into();
    let shares: Vec<f64> = chains
        .iter()
        .map(|(n, chosen)| flops(chosen.operations) as f64 / (n * n) as f64)
        .collect();
    assert!(shares.windows(2).all(|pair| pair[1] < pair[0]), "{shares:?}");
    // axes come back after three joints
    let articulated: Vec<usize> = [5, 8, 11]
        .map(|n| flops(on(&right_hand_side(&spatial(n)), Basis::Articulated)))
        .into();
    assert!(
        articulated[2] - articulated[1] <= articulated[1] - articulated[0],
        "{articulated:?}"
    );
}

#[test]
fn the_chosen_form_is_never_beaten() {
    for scene in [planar, spatial].iter().flat_map(|of| [2, 3, 5].map(of)) {
        let chosen = right_hand_side(&scene);
        // a form that loses no digits is worth an eighth more
        let least = match chosen.operations.weight() {
            weight if chosen.form.exact => weight * 8 / 9,
            weight => weight,
        };
        assert!(chosen.others.len() >= 2, "forms are compared: {:?}", chosen.others);
        assert!(
            chosen.others.iter().all(|(_, other)| other.weight() >= least),
            "{chosen:?}"
        );
    }
}

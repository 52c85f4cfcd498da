//! How code grows with the number of joints, and that the form which was chosen is the shortest.

use super::chains::{planar, spatial};
use crate::Function;
use crate::expr::Graph;
use crate::form::{Basis, Chosen, Form};
use crate::pass::Operations;

/// What is known of the right-hand side of a scene but its expressions.
struct Rhs {
    chosen: (Form, Operations),
    others: Vec<(Form, Operations)>,
}

fn right_hand_side(scene: &str) -> Rhs {
    let graph = Graph::new();
    let tokens = scene.parse().expect("tokens");
    let program = crate::program(&graph, tokens).unwrap_or_else(|errors| panic!("{errors}"));
    let Chosen {
        form,
        operations,
        others,
        ..
    } = &program.functions[&Function::Rhs];
    Rhs {
        chosen: (*form, *operations),
        others: others.clone(),
    }
}

fn on(rhs: &Rhs, basis: Basis) -> Operations {
    let mut all = rhs.others.iter().chain([&rhs.chosen]);
    all.find(|(form, _)| form.basis == basis).expect("known").1
}

fn flops(operations: Operations) -> usize {
    operations.additions + operations.multiplications
}

#[test]
fn planar_chains_grow_with_the_square_of_their_length_at_most() {
    let chains: Vec<(usize, Rhs)> = [5, 6, 7, 8].map(|n| (n, right_hand_side(&planar(n, "rhs")))).into();
    let shares: Vec<f64> = chains
        .iter()
        .map(|(n, rhs)| flops(rhs.chosen.1) as f64 / (n * n) as f64)
        .collect();
    assert!(shares.windows(2).all(|pair| pair[1] < pair[0]), "{shares:?}");
    let articulated: Vec<usize> = chains
        .iter()
        .map(|(_, rhs)| flops(on(rhs, Basis::Articulated)))
        .collect();
    let steps: Vec<usize> = articulated.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(steps.windows(2).all(|pair| pair[0] == pair[1]), "{articulated:?}");
}

#[test]
fn spatial_chains_grow_with_the_square_of_their_length_at_most() {
    let chains: Vec<(usize, Rhs)> = [4, 5, 6, 7, 8].map(|n| (n, right_hand_side(&spatial(n, "rhs")))).into();
    let shares: Vec<f64> = chains
        .iter()
        .map(|(n, rhs)| flops(rhs.chosen.1) as f64 / (n * n) as f64)
        .collect();
    assert!(shares.windows(2).all(|pair| pair[1] < pair[0]), "{shares:?}");
    // axes come back after three joints
    let articulated: Vec<usize> = [5, 8, 11]
        .map(|n| flops(on(&right_hand_side(&spatial(n, "rhs")), Basis::Articulated)))
        .into();
    assert!(
        articulated[2] - articulated[1] <= articulated[1] - articulated[0],
        "{articulated:?}"
    );
}

#[test]
fn the_chosen_form_is_never_beaten() {
    for scene in [planar, spatial].iter().flat_map(|of| [2, 3, 5].map(|n| of(n, "rhs"))) {
        let rhs = right_hand_side(&scene);
        let (form, operations) = rhs.chosen;
        // a form that loses no digits is worth an eighth more
        let least = match operations.weight() {
            weight if form.exact => weight * 8 / 9,
            weight => weight,
        };
        assert!(rhs.others.len() >= 2, "forms are compared: {:?}", rhs.others);
        assert!(rhs.others.iter().all(|(_, other)| other.weight() >= least), "{form}");
    }
}

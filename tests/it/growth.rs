//! Growth of code with the number of joints. Also checks that the chosen form is the shortest.

use pendulum_codegen::program::{Cost, Operations};
use testbed::chains::{planar, spatial};

fn right_hand_side(scene: &str) -> Cost {
    let tokens = scene.parse().expect("tokens");
    let program = pendulum_codegen::program(tokens).unwrap_or_else(|errors| panic!("{errors}"));
    program.routine("rhs").expect("a right-hand side").cost.clone()
}

fn of_articulated_bodies(cost: &Cost) -> Operations {
    let all = cost.others.iter().chain([cost]);
    all.filter(|cost| cost.form == "articulated bodies")
        .map(|cost| cost.operations)
        .next()
        .expect("known")
}

fn flops(operations: Operations) -> usize {
    operations.additions + operations.multiplications
}

#[test]
fn planar_chains_grow_with_the_square_of_their_length_at_most() {
    let chains: Vec<(usize, Cost)> = [5, 6, 7, 8].map(|n| (n, right_hand_side(&planar(n, "rhs")))).into();
    let shares: Vec<f64> = chains
        .iter()
        .map(|(n, chosen)| flops(chosen.operations) as f64 / (n * n) as f64)
        .collect();
    assert!(shares.windows(2).all(|pair| pair[1] < pair[0]), "{shares:?}");
    let articulated: Vec<usize> = chains
        .iter()
        .map(|(_, chosen)| flops(of_articulated_bodies(chosen)))
        .collect();
    let steps: Vec<usize> = articulated.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(steps.windows(2).all(|pair| pair[0] == pair[1]), "{articulated:?}");
}

#[test]
#[ignore = "takes long"]
fn spatial_chains_grow_with_the_square_of_their_length_at_most() {
    let costs = [4, 5, 6, 7, 8, 11].map(|n| (n, right_hand_side(&spatial(n, "rhs"))));
    let shares: Vec<f64> = costs[..5]
        .iter()
        .map(|(n, chosen)| flops(chosen.operations) as f64 / (n * n) as f64)
        .collect();
    assert!(shares.windows(2).all(|pair| pair[1] < pair[0]), "{shares:?}");
    // axes repeat after three joints: 5, 8 and 11
    let articulated = [1, 4, 5].map(|at| flops(of_articulated_bodies(&costs[at].1)));
    assert!(
        articulated[2] - articulated[1] <= articulated[1] - articulated[0],
        "{articulated:?}"
    );
}

#[test]
fn the_chosen_form_is_never_beaten() {
    for scene in [planar, spatial].iter().flat_map(|of| [2, 3, 5].map(|n| of(n, "rhs"))) {
        let chosen = right_hand_side(&scene);
        // a form without cancellation may be longer by an eighth
        let least = match chosen.operations.weight() {
            weight if chosen.form.contains("exact") => weight * 8 / 9,
            weight => weight,
        };
        assert!(chosen.others.len() >= 2, "forms are compared: {:?}", chosen.others);
        assert!(
            chosen.others.iter().all(|other| other.operations.weight() >= least),
            "{chosen:?}"
        );
    }
}

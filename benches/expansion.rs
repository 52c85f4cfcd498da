//! Run time of the generator: `cargo bench --bench expansion`.
//!
//! Inside the compiler the generator runs with the optimisation of build scripts and macros, which is none unless a
//! profile sets `[profile.dev.build-override] opt-level = 2`, as this workspace does.

use divan::Bencher;
use testbed::source::{MECHANISMS, ROBOTS, SCENES, declaration};

fn main() {
    divan::main();
}

fn expand(bencher: Bencher, source: &str, model: &str) {
    let text = declaration(source, model);
    bencher
        .with_inputs(|| text.parse().unwrap_or_default())
        .bench_values(pendulum_codegen::expand);
}

#[divan::bench]
fn double_pendulum(bencher: Bencher) {
    expand(bencher, SCENES, "DoublePendulum");
}

#[divan::bench(args = ["CartPole", "Furuta", "ScrewJoint", "Elbow3", "Tree", "Chain5"])]
fn mechanism(bencher: Bencher, model: &str) {
    expand(bencher, MECHANISMS, model);
}

#[divan::bench(args = ["Ur5", "Panda"], sample_count = 10)]
fn robot(bencher: Bencher, model: &str) {
    expand(bencher, ROBOTS, model);
}

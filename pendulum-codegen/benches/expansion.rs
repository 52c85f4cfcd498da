//! How long the generator takes: `cargo bench -p pendulum-codegen`.
//!
//! Inside the compiler the generator runs with the optimisation of build scripts and macros, which is none unless a profile says
//! `[profile.dev.build-override] opt-level = 2`, as this workspace does.

use divan::Bencher;
use proc_macro2::{Delimiter, TokenStream, TokenTree};

fn main() {
    divan::main();
}

/// The contents of the declaration of a model in a file.
fn declaration(source: &str, model: &str) -> String {
    let tokens: TokenStream = match source.parse() {
        Ok(tokens) => tokens,
        Err(error) => panic!("the source is Rust: {error}"),
    };
    let groups = tokens.into_iter().filter_map(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group.stream().to_string()),
        _ => None,
    });
    match groups.into_iter().find(|text| text.contains(&format!("pub {model}"))) {
        Some(text) => text,
        None => panic!("no declaration of {model}"),
    }
}

fn expand(bencher: Bencher, source: &str, model: &str) {
    let text = declaration(source, model);
    bencher
        .with_inputs(|| text.parse().unwrap_or_default())
        .bench_values(pendulum_codegen::expand);
}

#[divan::bench]
fn double_pendulum(bencher: Bencher) {
    expand(bencher, include_str!("../../tests/common/scenes.rs"), "DoublePendulum");
}

#[divan::bench(args = ["CartPole", "Furuta", "ScrewJoint", "Elbow3", "Tree", "Chain5"])]
fn mechanism(bencher: Bencher, model: &str) {
    expand(bencher, include_str!("../../tests/common/mechanisms.rs"), model);
}

#[divan::bench(args = ["Ur5", "Panda"], sample_count = 10)]
fn robot(bencher: Bencher, model: &str) {
    expand(bencher, include_str!("../../tests/common/robots.rs"), model);
}

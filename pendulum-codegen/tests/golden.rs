//! The emitted code of the first scene, to the byte, and that it is the same every time.
//!
//! `UPDATE_EXPECT=1 cargo test -p pendulum-codegen --test golden` rewrites the expected code.

use expect_test::expect_file;
use proc_macro2::{TokenStream, TokenTree};

/// The declaration in `tests/common/scenes.rs`.
fn declaration() -> TokenStream {
    let source = include_str!("../../tests/common/scenes.rs");
    let start = source.find("mechanism!").expect("a declaration") + "mechanism!".len();
    let tokens: TokenStream = source[start..].parse().expect("tokens");
    match tokens.into_iter().next() {
        Some(TokenTree::Group(group)) => group.stream(),
        other => panic!("a declaration stands in braces, not {other:?}"),
    }
}

fn emitted() -> String {
    let items = syn::parse2(pendulum_codegen::expand(declaration())).expect("items");
    prettyplease::unparse(&items)
}

#[test]
fn the_emitted_code_is_the_expected_one() {
    expect_file!["golden/double_pendulum.rs"].assert_eq(&emitted());
}

#[test]
fn the_same_declaration_gives_the_same_code_every_time() {
    let first = emitted();
    // hash tables are seeded for each thread, so an order taken from one would show here
    let others: Vec<_> = (0..4).map(|_| std::thread::spawn(emitted)).collect();
    for other in others {
        assert_eq!(other.join().expect("no panic"), first);
    }
}

/// A rate has no name that Rust or C could take.
#[test]
fn sines_of_rates_have_names() {
    let scene = "pub Wobble {
        body b on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th, torque: sin(dot(th)) + cos(dot(th)) }
    }";
    let items = pendulum_codegen::expand(scene.parse().expect("tokens"));
    syn::parse2::<syn::File>(items).expect("items");
    let program = pendulum_codegen::program(scene.parse().expect("tokens")).expect("a scene");
    let source = pendulum_codegen::c(&program).source;
    assert!(!source.contains("dot("), "{source}");
}

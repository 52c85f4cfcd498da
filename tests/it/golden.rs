//! The emitted code of the first scene, to the byte, and that it is the same every time.
//!
//! `UPDATE_EXPECT=1 cargo test --test it golden` rewrites the expected code.

use expect_test::expect_file;
use testbed::source::{SCENES, declaration};

fn emitted() -> String {
    let scene = declaration(SCENES, "DoublePendulum").parse().expect("tokens");
    let items = syn::parse2(pendulum_codegen::expand(scene)).expect("items");
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
        units: none,
        body b on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th, torque: sin(dot(th)) + cos(dot(th)) }
    }";
    let items = pendulum_codegen::expand(scene.parse().expect("tokens"));
    syn::parse2::<syn::File>(items).expect("items");
    let program = pendulum_codegen::program(scene.parse().expect("tokens")).expect("a scene");
    let source = pendulum_codegen::c(&program).source;
    assert!(!source.contains("dot("), "{source}");
}

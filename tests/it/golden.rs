//! Compares the emitted code of eight scenes with golden files, and of all examples with digests. Checks that expansion
//! is deterministic.
//!
//! `UPDATE_EXPECT=1 cargo test -p tests --features thorough --test it golden` rewrites the golden files.

use std::fmt::Write;
use std::fs;
use std::mem::take;
use std::path::{Path, PathBuf};

use expect_test::expect_file;
use syn::parse::{Parse, ParseStream};
use syn::{File, ImplItem, ImplItemMacro, Item, ItemMacro, Macro};
use testbed::digest::Digest;
use testbed::source::{ROBOTS, SCENES, declaration, declarations};

macro_rules! gallery {
    ($name:literal) => {
        include_str!(concat!("../../examples/gallery/src/", $name, ".rs"))
    };
}

/// Returns the formatted code of a declaration, with paths relative to the repository. The contents of `with_std!`
/// replace the macro, since only items are formatted.
fn code(declaration: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let items = pendulum_codegen::expand_in(&root, declaration.parse().expect("tokens"));
    let mut file: File = syn::parse2(items).expect("items");
    for item in &mut file.items {
        if let Item::Mod(module) = item
            && let Some((_, items)) = &mut module.content
        {
            *items = unwrapped(take(items), |item| match item {
                Item::Macro(ItemMacro { mac, .. }) => Some(mac),
                _ => None,
            });
            for item in items {
                if let Item::Impl(of) = item {
                    of.items = unwrapped(take(&mut of.items), |item| match item {
                        ImplItem::Macro(ImplItemMacro { mac, .. }) => Some(mac),
                        _ => None,
                    });
                }
            }
        }
    }
    let code = prettyplease::unparse(&file);
    for word in ["unsafe", "compile_error", "with_std"] {
        assert!(!code.contains(word), "{word} in {code}");
    }
    code
}

/// Replaces each macro among the items by the items in it.
fn unwrapped<I: Parse>(items: Vec<I>, as_macro: fn(&I) -> Option<&Macro>) -> Vec<I> {
    let inside = |mac: &Macro| {
        let all = |input: ParseStream<'_>| {
            let mut items = Vec::new();
            while !input.is_empty() {
                items.push(input.parse()?);
            }
            Ok(items)
        };
        mac.parse_body_with(all).expect("items")
    };
    let items = items.into_iter().map(|item| match as_macro(&item) {
        Some(mac) => inside(mac),
        None => vec![item],
    });
    items.flatten().collect()
}

/// Scenes of different kinds, each with a golden file: name of the file, source, and scene.
const KINDS: [(&str, &str, &str); 8] = [
    ("eq22", SCENES, "DoublePendulum"),
    ("ur5", ROBOTS, "Ur5"),
    ("points_and_forces", gallery!("magnets"), "Magnets"),
    ("four_bar", gallery!("four_bar"), "FourBar"),
    ("ball_chain", gallery!("ball_pendulum"), "BallPendulum"),
    ("hybrid", include_str!("../hybrid/scenes.rs"), "Block"),
    ("inputs", include_str!("../../examples/cart_pole.rs"), "CartPole"),
    ("driven_joints", gallery!("driven_pivot"), "DrivenPivot"),
];

#[test]
fn emitted_code_is_the_expected_one() {
    for (kind, source, scene) in KINDS {
        expect_file![format!("golden/{kind}.rs")].assert_eq(&code(declaration(source, scene)));
    }
}

/// Compares the code of every example by its number of lines and a digest. The code is written to `target/tmp/emitted`,
/// for a comparison of versions.
#[test]
#[ignore = "takes long"]
fn emitted_code_of_all_examples_has_the_expected_digests() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
    let written = Path::new(env!("CARGO_TARGET_TMPDIR")).join("emitted");
    let mut digests = String::new();
    for path in sources(&examples) {
        let source = fs::read_to_string(&path).expect("text");
        let code: Vec<String> = declarations(&source).map(code).collect();
        if !code.is_empty() {
            let (code, example) = (code.join("\n"), path.strip_prefix(&examples).expect("an example"));
            let place = written.join(example);
            fs::create_dir_all(place.parent().expect("a folder")).expect("a folder");
            fs::write(place, &code).expect("a file");
            let (example, lines) = (example.display(), code.lines().count());
            let mut digest = Digest::default();
            digest.add(code.bytes());
            writeln!(digests, "{example}: {lines} lines, {:016x}", digest.value()).expect("a string");
        }
    }
    assert!(digests.lines().count() > 15, "{digests}");
    expect_file!["golden/examples.txt"].assert_eq(&digests);
}

/// Returns the Rust files below a folder, in order.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("a file").path());
    let (folders, mut files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    files.retain(|path| path.extension().is_some_and(|extension| extension == "rs"));
    files.extend(folders.iter().flat_map(|folder| sources(folder)));
    files.sort();
    files
}

#[test]
fn the_same_declaration_gives_the_same_code_every_time() {
    let emitted = || code(declaration(SCENES, "DoublePendulum"));
    let first = emitted();
    // each thread seeds its hash tables, so an order that depends on one differs here
    let others: Vec<_> = (0..4).map(|_| std::thread::spawn(emitted)).collect();
    for other in others {
        assert_eq!(other.join().expect("no panic"), first);
    }
}

/// The name of a rate, such as `dot(th)`, is not a valid identifier in Rust or C.
#[test]
fn sines_of_rates_have_names() {
    let scene = "pub Wobble {
        units: none,
        body b on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th, torque: sin(dot(th)) + cos(dot(th)),
        }
    }";
    let items = pendulum_codegen::expand(scene.parse().expect("tokens"));
    syn::parse2::<syn::File>(items).expect("items");
    let program = pendulum_codegen::program(scene.parse().expect("tokens")).expect("a scene");
    let source = pendulum_codegen::c(&program).source;
    assert!(!source.contains("dot("), "{source}");
}

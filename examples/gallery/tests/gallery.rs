//! Every system of the gallery passes its checks, and the page of the book shows it.
//!
//! `UPDATE_EXPECT=1 cargo test -p gallery` rewrites the page; `cargo run --release -p gallery` draws the pictures,
//! which are copied into the book.

use std::path::Path;

use expect_test::expect_file;
use gallery::SYSTEMS;

#[test]
fn every_check_holds() {
    let mut wrong = Vec::new();
    for system in SYSTEMS {
        let run = (system.run)().unwrap_or_else(|error| panic!("{}: {error}", system.name));
        assert!(run.checks.len() > 1, "{} checks nothing but power", system.name);
        let failed = run.checks.iter().filter(|check| !check.holds());
        wrong.extend(failed.map(|check| format!("{}: {check}", system.name)));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn declarations_are_short() {
    for system in SYSTEMS {
        for declaration in system.declarations() {
            let (lines, bodies) = (declaration.lines().count() - 2, declaration.matches("body ").count());
            assert!(lines <= (4 * bodies).max(25), "{} takes {lines} lines", system.name);
        }
    }
}

#[test]
fn the_book_shows_all_of_them() {
    let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src");
    expect_file![book.join("gallery.md")].assert_eq(&gallery::page());
    for system in SYSTEMS {
        let picture = book.join("img/gallery").join(format!("{}.png", system.name));
        assert!(picture.exists(), "no {}", picture.display());
    }
}

//! Wrong declarations, one file for each mistake, and what the compiler says of them.
//!
//! `TRYBUILD=overwrite cargo test --test ui` rewrites the expected messages.

#[test]
fn wrong_declarations_are_explained() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}

//! Wrong declarations in a real compilation: the errors stand on the right tokens, and uses of the model add none.
//! What the messages say is compared in `pendulum-codegen/tests/ui.rs`, without a compiler.
//!
//! `TRYBUILD=overwrite cargo test -p tests --test ui` rewrites the expected messages.

#[test]
fn errors_stand_on_their_tokens_and_bring_no_others() {
    trybuild::TestCases::new().compile_fail("ui/*.rs");
}

//! The `mechanism!` macro. It only calls `pendulum-codegen`, which can be tested as a library.
#![forbid(unsafe_code)]

use proc_macro::TokenStream;

/// Expands the declaration of a mechanism into its flat equations of motion.
///
/// The grammar, the generated items and the theory are documented in `pendulum_core`, which re-exports it by default.
#[proc_macro]
pub fn mechanism(input: TokenStream) -> TokenStream {
    pendulum_codegen::expand(input.into()).into()
}

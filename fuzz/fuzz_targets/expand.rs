//! Bytes to text to tokens to items: the generator must not panic, and what it gives must parse.
#![no_main]

use libfuzzer_sys::{Corpus, fuzz_target};
use proc_macro2::TokenStream;

fuzz_target!(|bytes: &[u8]| -> Corpus {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return Corpus::Reject;
    };
    let Ok(tokens) = text.parse::<TokenStream>() else {
        return Corpus::Reject;
    };
    if let Err(errors) = pendulum_codegen::program(tokens.clone()) {
        assert!(errors.iter().next().is_some(), "refused without an error");
        for error in errors.iter() {
            assert!(error.to_string().contains("]\nhelp: "), "no code, or no help: {error}");
        }
    }
    let items = pendulum_codegen::expand(tokens).to_string();
    syn::parse_file(&items).expect("items");
    Corpus::Keep
});

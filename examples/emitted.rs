//! Prints the code that `mechanism!` makes of a declaration, formatted.
//!
//! `cargo run --example emitted` shows the double pendulum of the paper; `cargo run --example emitted -- src/lib.rs` shows
//! every declaration of a file, in its functions and modules as well.

use std::error::Error;

use pendulum_codegen::expand;
use proc_macro2::{TokenStream, TokenTree};

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args()
        .nth(1)
        .unwrap_or_else(|| "tests/common/scenes.rs".to_owned());
    let source = std::fs::read_to_string(&path).map_err(|error| format!("cannot read {path}: {error}"))?;
    let mut declarations = Vec::new();
    collect(source.parse()?, &mut declarations);
    if declarations.is_empty() {
        return Err(format!("{path} holds no `mechanism! {{ .. }}`").into());
    }
    for declaration in declarations {
        let items = syn::parse2(expand(declaration))?;
        println!("{}", prettyplease::unparse(&items));
    }
    Ok(())
}

/// The contents of every `mechanism! { .. }`, wherever it stands.
fn collect(tokens: TokenStream, declarations: &mut Vec<TokenStream>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (n, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else { continue };
        let called = matches!(&tokens[..n], [.., TokenTree::Ident(name), TokenTree::Punct(bang)]
            if name == "mechanism" && bang.as_char() == '!');
        if called {
            declarations.push(group.stream());
        } else {
            collect(group.stream(), declarations);
        }
    }
}

//! Prints the code that `mechanism!` makes of a declaration, formatted.
//!
//! `cargo run --example emitted` shows the double pendulum of the paper; `cargo run --example emitted -- src/lib.rs` shows
//! every declaration of a file, in its functions and modules as well.
//! `cargo run --example emitted -- --c src/lib.rs` writes C instead: a header and a source for each declaration, into `out/emitted/` or
//! the folder that is named last.

use std::error::Error;
use std::path::Path;

use pendulum_codegen::expand;
use proc_macro2::{TokenStream, TokenTree};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let c = arguments.first().is_some_and(|first| first == "--c");
    arguments.drain(..usize::from(c));
    let path = arguments.first().map_or("tests/common/scenes.rs", String::as_str);
    let folder = arguments.get(1).map_or("out/emitted", String::as_str);
    let source = std::fs::read_to_string(path).map_err(|error| format!("cannot read {path}: {error}"))?;
    let mut declarations = Vec::new();
    collect(source.parse()?, &mut declarations);
    if declarations.is_empty() {
        return Err(format!("{path} holds no `mechanism! {{ .. }}`").into());
    }
    if c {
        return write_c(declarations, Path::new(folder));
    }
    for declaration in declarations {
        let items = syn::parse2(expand(declaration))?;
        println!("{}", prettyplease::unparse(&items));
    }
    Ok(())
}

/// Writes a header and a source for each declaration.
fn write_c(declarations: Vec<TokenStream>, folder: &Path) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(folder)?;
    for declaration in declarations {
        let sources = pendulum_codegen::c(&pendulum_codegen::program(declaration)?);
        for (extension, text) in [("h", sources.header), ("c", sources.source)] {
            let path = folder.join(&sources.name).with_extension(extension);
            std::fs::write(&path, text)?;
            println!("{}", path.display());
        }
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

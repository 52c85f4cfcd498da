//! Finds declarations in source text.

use proc_macro2::{TokenStream, TokenTree};

/// Returns the contents of every `mechanism! { .. }`, at any depth.
pub(crate) fn declarations(tokens: TokenStream) -> Vec<TokenStream> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut declarations = Vec::new();
    for (n, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else { continue };
        let is_call = matches!(&tokens[..n], [.., TokenTree::Ident(name), TokenTree::Punct(bang)]
            if name == "mechanism" && bang.as_char() == '!');
        if is_call {
            declarations.push(group.stream());
        } else {
            declarations.extend(self::declarations(group.stream()));
        }
    }
    declarations
}

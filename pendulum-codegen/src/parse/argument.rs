//! Lists in brackets, and arguments of solids and joints.

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::parse::{Parse, ParseStream};
use syn::{bracketed, token};

use super::expr::recorded;
use super::token::{brackets, list};
use crate::ast::{Expr, Vector};
use crate::error::{Code, on};

/// An argument of a solid or of a joint.
pub(super) enum Argument {
    /// A number.
    Scalar(Expr),
    /// A list of numbers.
    List(Vec<Expr>, TokenStream),
    /// A list of lists.
    Points(Vec<Vec<Expr>>, TokenStream),
}

impl ToTokens for Argument {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Self::Scalar(e) => e.to_tokens(tokens),
            Self::List(_, text) | Self::Points(_, text) => text.to_tokens(tokens),
        }
    }
}

impl Parse for Argument {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        if !input.peek(token::Bracket) {
            return Ok(Self::Scalar(input.parse()?));
        }
        let ahead = input.fork();
        let inner;
        bracketed!(inner in ahead);
        if !inner.peek(token::Bracket) {
            let (entries, tokens) = entries(input)?;
            return Ok(Self::List(entries, tokens));
        }
        let (points, tokens) = recorded(input, |input| {
            let inner = brackets(input, "points", "[[x, y], [x, y]]")?;
            let points = list(&inner, "[[x, y], [x, y]]", entries)?;
            Ok(points.into_iter().map(|(entries, _)| entries).collect())
        })?;
        Ok(Self::Points(points, tokens))
    }
}

impl Argument {
    /// Returns the argument as a vector, or unchanged if it does not have three components.
    pub(super) fn vector(self) -> Result<Vector, Self> {
        match self {
            Self::List(entries, tokens) => match <[Expr; 3]>::try_from(entries) {
                Ok(components) => Ok(Vector { components, tokens }),
                Err(entries) => Err(Self::List(entries, tokens)),
            },
            other => Err(other),
        }
    }
}

impl Parse for Vector {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let (entries, tokens) = entries(input)?;
        let count = entries.len();
        match <[Expr; 3]>::try_from(entries) {
            Ok(components) => Ok(Self { components, tokens }),
            Err(_) => {
                let fact = format!("a vector has three components, not {count}");
                Err(on(Code::Arguments, tokens, fact, "write `[x, y, z]`"))
            }
        }
    }
}

/// `[e, e, ..]`
fn entries(input: ParseStream) -> syn::Result<(Vec<Expr>, TokenStream)> {
    recorded(input, |input| {
        let inner = brackets(input, "a vector", "[x, y, z]")?;
        list(&inner, "[x, y, z]", Expr::parse)
    })
}

//! A program as Rust: the items that a declaration stands for.

mod block;
mod build;
mod facts;
mod lanes;
mod routines;
mod series;
mod stub;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

pub(crate) use stub::stub;

use crate::ast::Head;
use crate::program::{Program, Quantity};
use block::Names;

/// Everything that a declaration stands for.
pub(crate) fn items(head: &Head, program: &Program) -> TokenStream {
    let items = Items { head, program };
    let parts = [
        items.parameters(),
        items.inputs().unwrap_or_default(),
        items.model(),
        items.constructor(),
        items.facts(),
        items.routines(),
        items.series().unwrap_or_default(),
        items.over_numbers().unwrap_or_default(),
    ];
    parts.into_iter().collect()
}

/// The lints that say nothing about generated code.
fn allowed() -> TokenStream {
    quote!(#[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)])
}

struct Items<'p> {
    head: &'p Head,
    program: &'p Program,
}

impl Items<'_> {
    fn names(&self) -> Names<'_> {
        Names(self.program)
    }

    /// The length of the state.
    fn length(&self) -> Literal {
        count(self.program.layout.len())
    }

    fn parameters_name(&self) -> Ident {
        format_ident!("{}Params", self.head.name)
    }

    fn inputs_name(&self) -> Ident {
        format_ident!("{}Inputs", self.head.name)
    }

    fn parameters(&self) -> TokenStream {
        let (vis, name) = (&self.head.vis, self.parameters_name());
        let parameters = &self.program.parameters;
        let doc = format!("Parameters of [`{}`].", self.head.name);
        let fields = parameters.iter().map(|p| declared(p, &quote!(f64)));
        let defaults: Option<Vec<_>> = parameters
            .iter()
            .map(|p| p.default.map(|value| (field(&p.name), value)))
            .collect();
        let default = defaults.map(|defaults| {
            let values = defaults.into_iter().map(|(field, value)| quote!(#field: #value));
            let allowed = allowed();
            quote! {
                impl ::core::default::Default for #name {
                    #allowed
                    fn default() -> Self {
                        Self { #(#values),* }
                    }
                }
            }
        });
        let serde = cfg!(feature = "serde").then(|| {
            quote! {
                #[derive(::pendulum_core::serde::Serialize, ::pendulum_core::serde::Deserialize)]
                #[serde(crate = "::pendulum_core::serde")]
            }
        });
        quote! {
            #[doc = #doc]
            #serde
            #[derive(Clone, Copy, Debug, PartialEq)]
            #vis struct #name { #(#fields),* }
            #default
        }
    }

    fn inputs(&self) -> Option<TokenStream> {
        let inputs = &self.program.inputs;
        if inputs.is_empty() {
            return None;
        }
        let (vis, name) = (&self.head.vis, self.inputs_name());
        let doc = format!("Inputs of [`{}`], given at each evaluation.", self.head.name);
        let fields = inputs.iter().map(|input| declared(input, &quote!(T)));
        Some(quote! {
            #[doc = #doc]
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            #vis struct #name<T = f64> { #(#fields),* }
        })
    }

    fn model(&self) -> TokenStream {
        let (vis, name, parameters) = (&self.head.vis, &self.head.name, self.parameters_name());
        let (docs, constants) = (&self.head.docs, &self.program.constants_text);
        let mut text = format!("# Equations of motion\n\n```text\n{}```\n", self.program.equations);
        if !constants.is_empty() {
            text.push_str("\n# Constants, computed by `new`\n\n```text\n");
            for (n, constant) in constants.iter().enumerate() {
                text.push_str(&format!("k{n} = {constant}\n"));
            }
            text.push_str("```\n");
        }
        let count = count(constants.len());
        quote! {
            #(#[doc = #docs])*
            #[doc = ""]
            #[doc = #text]
            #[derive(Clone, Copy, Debug, PartialEq)]
            #vis struct #name<T = f64> {
                params: #parameters,
                constants: [T; #count],
            }
        }
    }
}

/// The field of a parameter or an input.
fn declared(quantity: &Quantity, of: &TokenStream) -> TokenStream {
    let (field, docs) = (field(&quantity.name), &quantity.docs);
    let unit = match quantity.unit.as_str() {
        "1" => "A plain number.".to_owned(),
        unit => format!("In {unit}."),
    };
    quote!(#(#[doc = #docs])* #[doc = #unit] pub #field: #of)
}

/// The name of the field of a parameter or an input.
fn field(name: &str) -> Ident {
    format_ident!("{name}")
}

/// A count without a suffix.
fn count(n: usize) -> Literal {
    Literal::usize_unsuffixed(n)
}

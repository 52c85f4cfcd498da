//! A program as Rust: the items that replace a declaration.
//!
//! The items are in a module of their own, which keeps their fields private, and are exported from there with the
//! visibility of the declaration. Every path is absolute, so that a scene may have any name but those of primitive
//! type.

mod apart;
mod block;
mod build;
mod drawing;
mod facts;
mod hybrid;
mod inherent;
mod lanes;
mod loops;
mod routines;
mod series;
mod tangents;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote, quote_spanned};

use crate::ast::{Head, Input, Scene};
use crate::program::{Program, Quantity, Routine};
use block::{Names, local};

/// All items that replace a declaration.
pub(crate) fn items(head: &Head, program: &Program) -> TokenStream {
    let items = Items { head, program };
    items.in_own_module(items.everything())
}

/// Items that replace a declaration with errors, complete enough that uses of its model cause no further errors.
///
/// If the number of coordinates is unknown, for example because the file of a robot is missing, the model implements
/// its traits for several lengths of the state.
pub(crate) fn stand_in(scene: &Scene) -> TokenStream {
    let (head, inputs) = (&scene.head, &scene.items.inputs);
    let is_whole = scene.items.robot.as_ref().is_none_or(|robot| robot.unread.is_none());
    let is_known = is_whole && !Program::blank(scene, inputs, 0).layout.is_empty();
    let programs = |inputs: &[Input]| -> Vec<Program> {
        let guesses = 0..=if is_known { 0 } else { MOST_UNREAD };
        let guesses = guesses.map(|unread| Program::blank(scene, inputs, unread));
        guesses.filter(|program| !program.layout.is_empty()).collect()
    };
    let all = programs(inputs);
    let mut all = all.iter().map(|program| Items { head, program });
    let items = all.next().expect("a guess");
    let mut parts = vec![Some(items.everything())];
    for other in all {
        let [motion, closed, ..] = other.traits();
        parts.extend([motion, closed, other.over_parameters(), other.over_numbers()]);
    }
    let mut words = scene.items.generate.iter().flat_map(|(_, words)| words);
    let asks_in_vain = !inputs.is_empty() && words.any(|word| CLOSED.iter().any(|closed| word == closed));
    if asks_in_vain && items.program.constraints.is_empty() {
        for program in &programs(&[]) {
            let closed = Items { head, program };
            parts.extend([
                closed.system(),
                closed.canonical(),
                closed.series(),
                closed.over_parameters(),
                closed.over_numbers(),
            ]);
        }
    }
    items.in_own_module(parts.into_iter().flatten().collect())
}

/// Maximum number of unread coordinates.
const MOST_UNREAD: usize = 8;
/// Words of `generate` that only scenes without inputs support.
const CLOSED: [&str; 2] = ["canonical", "taylor"];

/// Allowances for lints that do not apply to generated code.
fn allowed() -> TokenStream {
    quote!(#[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)])
}

struct Items<'p> {
    head: &'p Head,
    program: &'p Program,
}

impl Items<'_> {
    fn everything(&self) -> TokenStream {
        let own = [
            Some(self.parameters()),
            self.inputs(),
            Some(self.model()),
            Some(self.constructor()),
            Some(self.facts()),
            Some(self.routines()),
        ];
        own.into_iter().chain(self.beside()).flatten().collect()
    }

    /// Implementations of traits whose methods are not routines.
    fn beside(&self) -> [Option<TokenStream>; 4] {
        [
            self.series(),
            self.drawing(),
            self.over_parameters(),
            self.over_numbers(),
        ]
    }

    /// Private module of items that exports the types of the declaration.
    fn in_own_module(&self, items: TokenStream) -> TokenStream {
        let head = self.head;
        let (vis, name, path) = (&head.vis, &head.name, format_ident!("__{}", head.name));
        let (parameters, inputs) = (self.parameters_name(), self.inputs_name());
        let inputs = (!self.program.inputs.is_empty()).then(|| quote!(, #inputs));
        // the span puts the error for a second mechanism of this name at the name
        let module = quote_spanned!(name.span()=> mod #path { #items });
        quote! {
            #[allow(non_snake_case)]
            #module
            #[allow(unreachable_pub, unused_imports)]
            #vis use #path::{#name, #parameters #inputs};
        }
    }

    fn names(&self) -> Names<'_> {
        Names(self.program)
    }

    /// Length of the state.
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
        let name = self.parameters_name();
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
        let (allowed, length) = (allowed(), count(parameters.len()));
        let names = parameters.iter().map(|p| &p.name);
        let (own, given) = as_array(parameters);
        quote! {
            #[doc = #doc]
            #serde
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct #name { #(#fields),* }
            #default
            #allowed
            impl #name {
                /// Names of the parameters, in the order of their declaration.
                pub const NAMES: [&'static str; #length] = [#(#names),*];

                /// Returns the values of the parameters, in the order of [`NAMES`](Self::NAMES).
                pub const fn to_array(self) -> [f64; #length] {
                    [#(self.#own),*]
                }

                /// Builds parameters from their values, in the order of [`NAMES`](Self::NAMES).
                pub const fn from_array(values: [f64; #length]) -> Self {
                    let [#(#given),*] = values;
                    Self { #(#own: #given),* }
                }
            }
        }
    }

    fn inputs(&self) -> Option<TokenStream> {
        let inputs = &self.program.inputs;
        if inputs.is_empty() {
            return None;
        }
        let name = self.inputs_name();
        let doc = format!("Inputs of [`{}`], given at each evaluation.", self.head.name);
        let fields = inputs.iter().map(|input| declared(input, &quote!(T)));
        let (allowed, length) = (allowed(), count(inputs.len()));
        let (own, given) = as_array(inputs);
        Some(quote! {
            #[doc = #doc]
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            pub struct #name<T = f64> { #(#fields),* }
            #allowed
            impl<T> ::core::convert::From<[T; #length]> for #name<T> {
                #[inline]
                fn from(values: [T; #length]) -> Self {
                    let [#(#given),*] = values;
                    Self { #(#own: #given),* }
                }
            }
            #allowed
            impl<T> ::core::convert::From<#name<T>> for [T; #length] {
                #[inline]
                fn from(inputs: #name<T>) -> Self {
                    [#(inputs.#own),*]
                }
            }
        })
    }

    fn model(&self) -> TokenStream {
        let (name, parameters) = (&self.head.name, self.parameters_name());
        let (docs, constants) = (&self.head.docs, &self.program.constants_text);
        let mut text = format!("# Equations of motion\n\n```text\n{}```\n", self.program.equations);
        if !constants.is_empty() {
            text.push_str("\n# Constants, computed by `new`\n\n```text\n");
            for (n, constant) in constants.iter().enumerate() {
                text.push_str(&format!("k{n} = {constant}\n"));
            }
            text.push_str("```\n");
        }
        let is_long = |routine: &&Routine| routine.block.lets.len() > block::LONG;
        let long: Vec<&Routine> = self.program.routines.iter().filter(is_long).collect();
        if !long.is_empty() {
            text.push_str("\n# Long functions\n\n");
            text.push_str("They take long to compile. Leave those that are not used out of `generate`:\n\n");
            for routine in long {
                let operations = routine.cost.operations.arithmetic();
                text.push_str(&format!("- `{}`, {operations} operations\n", routine.name));
            }
        }
        let count = count(constants.len());
        quote! {
            #(#[doc = #docs])*
            #[doc = ""]
            #[doc = #text]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct #name<T = f64> {
                params: #parameters,
                constants: [T; #count],
            }
        }
    }
}

/// Field of a parameter or an input.
fn declared(quantity: &Quantity, of: &TokenStream) -> TokenStream {
    let (field, docs) = (field(&quantity.name), &quantity.docs);
    let unit = match quantity.unit.as_str() {
        "1" => "A plain number.".to_owned(),
        unit => format!("In {unit}."),
    };
    quote!(#(#[doc = #docs])* #[doc = #unit] pub #field: #of)
}

/// Fields of parameters or inputs, and names for the entries of an array of them.
fn as_array(quantities: &[Quantity]) -> (Vec<Ident>, Vec<Ident>) {
    let names = quantities.iter().enumerate();
    names.map(|(n, of)| (field(&of.name), local(&format!("v{n}")))).unzip()
}

/// Name of the field of a parameter or an input.
fn field(name: &str) -> Ident {
    format_ident!("{name}")
}

/// Count as a literal without a suffix.
fn count(n: usize) -> Literal {
    Literal::usize_unsuffixed(n)
}

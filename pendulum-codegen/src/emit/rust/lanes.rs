//! The model in other number types: cast, or gathered into lanes.

use proc_macro2::TokenStream;
use quote::quote;

use super::{Items, allowed};

/// The attributes of a function that must be inlined into code for an instruction set, since it is compiled for all machines otherwise.
/// Without optimisation it would fill the stack, as no two of its temporaries share a place.
pub(super) fn inlined_into_lanes() -> TokenStream {
    quote!(#[cfg_attr(debug_assertions, inline)] #[cfg_attr(not(debug_assertions), inline(always))])
}

impl Items<'_> {
    /// `impl Cast<N>`, where the model has a right-hand side of its own, without inputs.
    pub(super) fn over_numbers(&self) -> Option<TokenStream> {
        if !self.program.inputs.is_empty() || self.program.routine("rhs").is_none() {
            return None;
        }
        let (name, length, allowed) = (&self.head.name, self.length(), allowed());
        let (real, lanes) = (
            quote!(::pendulum_core::real::Real),
            quote!(::pendulum_core::real::lanes::Lanes),
        );
        Some(quote! {
            #allowed
            impl ::pendulum_core::Cast<#length> for #name {
                type In<T: #real> = #name<T>;

                fn cast<T: #real>(&self) -> #name<T> {
                    #name::cast(self)
                }

                #[inline]
                fn gather<'m, V: #lanes>(models: impl Fn(usize) -> &'m Self) -> #name<V>
                where
                    Self: 'm,
                {
                    let scalar = <<V as #lanes>::Scalar as #real>::from_f64;
                    #name {
                        params: models(0).params,
                        constants: ::core::array::from_fn(|k| {
                            <V as #lanes>::from_fn(|lane| scalar(models(lane).constants[k]))
                        }),
                    }
                }
            }
        })
    }
}

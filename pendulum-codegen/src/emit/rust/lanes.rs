//! The model in other number types: cast, or gathered into lanes.

use proc_macro2::TokenStream;
use quote::quote;

use super::{Items, allowed, count};
use crate::program::Role;

/// Attributes of a function that must be inlined into code for an instruction set, since it would otherwise be compiled
/// for the baseline target. Inlining is not forced without optimisation, where every temporary takes its own stack
/// space.
pub(super) fn inlined_into_lanes() -> TokenStream {
    quote!(#[cfg_attr(debug_assertions, inline)] #[cfg_attr(not(debug_assertions), inline(always))])
}

impl Items<'_> {
    /// `impl Parametric<N, P>`, or `impl ParametricControlled<N, M, P>` with inputs, if the model has a right-hand
    /// side.
    pub(super) fn over_parameters(&self) -> Option<TokenStream> {
        self.program.with_role(Role::Rhs)?;
        let (name, length, allowed, params) = (&self.head.name, self.length(), allowed(), self.parameters_name());
        let [inputs, parameters] = [self.program.inputs.len(), self.program.parameters.len()].map(count);
        let of_trait = match self.program.inputs.is_empty() {
            true => quote!(Parametric<#length, #parameters>),
            false => quote!(ParametricControlled<#length, #inputs, #parameters>),
        };
        Some(quote! {
            #allowed
            impl ::pendulum_core::#of_trait for #name {
                fn parameters(&self) -> [f64; #parameters] {
                    self.params.to_array()
                }

                fn parameter_names(&self) -> [&str; #parameters] {
                    #params::NAMES
                }

                fn check_parameters(
                    &self,
                    parameters: &[f64; #parameters],
                ) -> ::core::result::Result<(), ::pendulum_core::ParameterError> {
                    Self::new(#params::from_array(*parameters)).map(|_| ())
                }

                fn with_parameters<T: ::pendulum_core::real::Real>(&self, parameters: [T; #parameters]) -> #name<T> {
                    #name { params: self.params, constants: constants(parameters) }
                }
            }
        })
    }

    /// `impl Cast<N>`, or `impl CastControlled<N, M>` with inputs, if the model has a right-hand side;
    /// `impl CastJacobian<N>` if it has a Jacobian and no inputs.
    pub(super) fn over_numbers(&self) -> Option<TokenStream> {
        self.program.with_role(Role::Rhs)?;
        let (name, length, allowed) = (&self.head.name, self.length(), allowed());
        let of_trait = match self.program.inputs.len() {
            0 => quote!(Cast<#length>),
            inputs => {
                let inputs = count(inputs);
                quote!(CastControlled<#length, #inputs>)
            }
        };
        let (real, lanes) = (
            quote!(::pendulum_core::real::Real),
            quote!(::pendulum_core::real::lanes::Lanes),
        );
        let is_hybrid = !self.program.constraints.is_empty();
        let hybrid = is_hybrid.then(|| {
            quote!(
                const HYBRID: bool = true;
            )
        });
        let has_jacobian = self.program.inputs.is_empty() && self.program.with_role(Role::Jacobian).is_some();
        let jacobian = has_jacobian.then(|| {
            quote! {
                #allowed
                impl ::pendulum_core::CastJacobian<#length> for #name {
                    #[inline]
                    fn with_jacobian<T: #real>(model: &#name<T>) -> &impl ::pendulum_core::Jacobian<T, #length> {
                        model
                    }
                }
            }
        });
        Some(quote! {
            #jacobian
            #allowed
            impl ::pendulum_core::#of_trait for #name {
                #hybrid
                type In<T: #real> = #name<T>;

                fn cast<T: #real>(&self) -> #name<T> {
                    #name::cast(self)
                }

                #[inline]
                fn gather<'m, T: #lanes>(models: impl ::core::ops::Fn(usize) -> &'m Self) -> #name<T>
                where
                    Self: 'm,
                {
                    let scalar = <<T as #lanes>::Scalar as #real>::from_f64;
                    #name {
                        params: models(0).params,
                        constants: ::core::array::from_fn(|k| {
                            <T as #lanes>::from_fn(|lane| scalar(models(lane).constants[k]))
                        }),
                    }
                }
            }
        })
    }
}

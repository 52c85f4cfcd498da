//! What stands in for a model whose declaration has errors, so that its uses are no errors of their own.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::{allowed, number};
use crate::ast::Scene;

/// Types of the right shape that are never run.
pub(crate) fn stub(scene: &Scene) -> TokenStream {
    let (vis, name, items) = (&scene.vis, &scene.name, &scene.items);
    let parameters = format_ident!("{name}Params");
    let declared = items.params.iter().map(|param| &param.name).chain(&items.unread);
    let fields: BTreeSet<&Ident> = declared.collect();
    let fields = fields.into_iter();
    let dof = items.bodies.iter().filter(|body| body.coordinate.is_some()).count();
    let (length, dof) = (number(2 * dof), number(dof));
    let real = quote!(::pendulum_core::real::Real);
    let vector = quote!(::pendulum_core::nalgebra::SVector<T, #length>);
    let allowed = allowed();
    quote! {
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        #allowed
        #vis struct #parameters { #(pub #fields: f64),* }
        #[derive(Clone, Copy, Debug, PartialEq)]
        #allowed
        #vis struct #name<T = f64>(::core::marker::PhantomData<T>);
        #allowed
        impl #name {
            pub fn new(_: #parameters) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
                Ok(Self(::core::marker::PhantomData))
            }
            pub fn cast<T: #real>(&self) -> #name<T> {
                #name(::core::marker::PhantomData)
            }
            pub const DOF: usize = #dof;
            pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::ZERO;
            pub const EQUATIONS: &'static str = "";
        }
        #allowed
        impl<T: #real> ::pendulum_core::System<T, #length> for #name<T> {
            fn rhs(&self, _: T, x: &#vector) -> #vector {
                *x
            }
        }
        #allowed
        impl<T: #real> ::pendulum_core::Jacobian<T, #length> for #name<T> {
            fn jacobian(&self, _: T, _: &#vector) -> ::pendulum_core::nalgebra::SMatrix<T, #length, #length> {
                ::pendulum_core::nalgebra::SMatrix::from([[T::from_f64(0.0); #length]; #length])
            }
        }
        #allowed
        impl<T: #real> ::pendulum_core::Energy<T, #length> for #name<T> {
            fn kinetic(&self, _: T, _: &#vector) -> T {
                T::from_f64(0.0)
            }
            fn potential(&self, _: T, _: &#vector) -> T {
                T::from_f64(0.0)
            }
        }
    }
}

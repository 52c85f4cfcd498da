//! Drawing of a model.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::{Items, allowed, count};

impl Items<'_> {
    /// `impl Shapes`, if the scene requests it.
    pub(super) fn drawing(&self) -> Option<TokenStream> {
        let drawing = self.program.drawing.as_ref()?;
        let (name, allowed, length) = (&self.head.name, allowed(), self.length());
        let core = quote!(::pendulum_core::shapes);
        let outlines = drawing.outlines.iter().map(|outline| {
            let (kind, points) = (
                format_ident!("{}", format!("{:?}", outline.kind)),
                count(outline.points),
            );
            let (name, body, radius) = (&outline.name, &outline.body, outline.radius);
            let kind = quote!(#core::ShapeKind::#kind);
            quote!(#core::Outline { name: #name, body: #body, kind: #kind, points: #points, radius: #radius })
        });
        let block = self.block(&drawing.block, |values| quote!([#(#values),*]));
        let numbers = count(drawing.block.results.len());
        // of a generic type, since `f64` has functions of the platform by the same names
        let values = self.implement(
            Some(quote!(Values<T>)),
            &quote! {
                fn values(&self, t: T, x: &::pendulum_core::nalgebra::SVector<T, #length>) -> [T; #numbers] { #block }
            },
        );
        Some(quote! {
            ::pendulum_core::with_std! {
                #allowed
                impl #core::Shapes<#length> for #name {
                    fn shapes(
                        &self,
                        t: f64,
                        x: &::pendulum_core::nalgebra::SVector<f64, #length>
                    ) -> #core::Vec<#core::Shape<'_>> {
                        trait Values<T> {
                            fn values(
                                &self,
                                t: T,
                                x: &::pendulum_core::nalgebra::SVector<T, #length>
                            ) -> [T; #numbers];
                        }
                        #values
                        #core::placed(&[#(#outlines),*], &self.values(t, x))
                    }
                }
            }
        })
    }
}

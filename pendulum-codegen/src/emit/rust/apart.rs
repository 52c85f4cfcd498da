//! Long routines: functions of their own, compiled for more than one instruction set.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::block::Piece;
use super::lanes::inlined_into_lanes;
use super::{Items, allowed, count};
use crate::program::{Role, Routine, Shape};

/// Least [weight](crate::pass::Operations::weight) of a long routine. Shorter ones gain about what a call takes,
/// 0.6 ns.
const LEAST_WEIGHT: usize = 400;

/// True if a routine is long. Canonical equations are called by methods. Energies are added, and share their sines.
pub(super) fn is_apart(routine: &Routine) -> bool {
    use Role::{Canonical, CanonicalJacobian, Kinetic, Potential};
    let is_inlined = matches!(routine.role, Canonical | CanonicalJacobian | Kinetic | Potential);
    !is_inlined && routine.cost.operations.weight() >= LEAST_WEIGHT
}

/// A long routine in Rust.
pub(super) struct Apart {
    /// Type of its code.
    pub(super) item: TokenStream,
    /// Value of this type, made of the arguments.
    pub(super) value: TokenStream,
}

impl Items<'_> {
    /// Long routine with the results of the `output`. `conversions` turn the vectors among the arguments of an inherent
    /// function into states, within the code, since a copy of a state takes long to read.
    pub(super) fn apart(
        &self,
        routine: &Routine,
        output: &TokenStream,
        conversions: Option<&TokenStream>,
        result: impl FnOnce(&[Piece]) -> TokenStream,
    ) -> Apart {
        let (model, inline, allowed) = (&self.head.name, inlined_into_lanes(), allowed());
        let (real, core) = (
            quote!(::pendulum_core::real::Real),
            quote!(::pendulum_core::real::lanes),
        );
        let code = self.code(&format_ident!("model"), routine, result);
        let vectors = routine.arguments.iter().filter_map(|&argument| self.vector(argument));
        let vectors = vectors.map(|(name, components)| (name, components.len()));
        let vectors: Vec<(&str, usize)> = [("x", self.program.layout.len())].into_iter().chain(vectors).collect();
        let generics: Vec<Ident> = match conversions {
            Some(_) => (0..vectors.len()).map(|n| format_ident!("__X{n}")).collect(),
            None => Vec::new(),
        };
        let bounds = generics.iter().zip(&vectors).map(|(generic, &(_, length))| {
            let length = count(length);
            quote!(#generic: ::pendulum_core::IntoState<T, #length> + ::core::marker::Copy)
        });
        let of_vectors = vectors.iter().enumerate().map(|(n, &(name, length))| {
            let of = generics.get(n).map(|generic| quote!(#generic));
            (
                of.unwrap_or_else(|| self.shape(Shape::Vector(length))),
                format_ident!("{name}"),
            )
        });
        let (types, names): (Vec<_>, Vec<_>) = of_vectors.chain(self.acting_on(routine)).unzip();
        let item = quote! {
            struct __Code<'a, T, #(#generics),*> { t: T, #(#names: &'a #types),* }
            #allowed
            impl<T: #real, #(#bounds),*> #core::Routine<(), #model<T>> for __Code<'_, T, #(#generics),*> {
                type Output = #output;
                #inline
                fn run(self, (): &mut (), model: &#model<T>) -> #output {
                    let Self { t, #(#names),* } = self;
                    #conversions
                    #code
                }
            }
        };
        let value = quote!(__Code { t, #(#names),* });
        Apart { item, value }
    }
}

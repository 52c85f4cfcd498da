//! Projection of a state onto its constraints: closed loops and quaternions of unit length.

use proc_macro2::TokenStream;
use quote::quote;

use super::block::number;
use super::lanes::inlined_into_lanes;
use super::{Items, count};
use crate::emit::CORRECTIONS;
use crate::program::{Role, Shape};

/// Maximum length of the last Newton correction. The next one would be of the order of its square.
const LAST_CORRECTION: f64 = 1e-6;

impl Items<'_> {
    /// Methods of `System` and `Controlled` for closed loops and quaternions.
    pub(super) fn assembly(&self) -> TokenStream {
        let (project, margins, gaps) = (self.project(), self.margins(), self.gaps());
        quote!(#project #margins #gaps)
    }

    /// Method that reports the margin of each closed loop from its singularity (toggle), if there are any loops.
    fn margins(&self) -> Option<TokenStream> {
        self.program.with_role(Role::LoopMargins)?;
        let vector = self.shape(Shape::Vector(self.program.layout.len()));
        let loops = self.program.loops.iter().map(|[a, b]| quote!([#a, #b]));
        let number = (0..self.program.loops.len()).map(count);
        let inline = inlined_into_lanes();
        let uncounted = &self.program.uncounted;
        let of_turns = (!uncounted.is_empty()).then(|| {
            let number = (0..uncounted.len()).map(count);
            let names = uncounted.iter().map(|name| name.trim_start_matches("r#"));
            quote! {
                let (margins, rates) = self.turn_margins(t, x);
                #(tell([#names, ""], [margins[#number], rates[#number]]);)*
            }
        });
        Some(quote! {
            #inline
            fn margins(&self, t: T, x: &#vector, tell: &mut dyn FnMut([&str; 2], [T; 2])) {
                let (margins, rates) = self.loop_margins(t, x);
                #(tell(#loops, [margins[#number], rates[#number]]);)*
                #of_turns
            }
        })
    }

    /// Method that reports the closure errors of loops, if some have no closed form.
    fn gaps(&self) -> Option<TokenStream> {
        self.program.with_role(Role::LoopGaps)?;
        let vector = self.shape(Shape::Vector(self.program.layout.len()));
        let open = self.program.open_loops.iter().map(|&n| &self.program.loops[n]);
        let open = open.map(|[a, b]| quote!([#a, #b]));
        let number = (0..self.program.open_loops.len()).map(count);
        Some(quote! {
            #[inline]
            fn gaps(&self, t: T, x: &#vector, tell: &mut dyn FnMut([&str; 2], [T; 3])) {
                let (distances, angles, sizes) = self.loop_gaps(t, x);
                #(tell(#open, [distances[#number], angles[#number], sizes[#number]]);)*
            }
        })
    }

    /// Method that normalises quaternions and closes loops. Returns `None` if the model has neither.
    fn project(&self) -> Option<TokenStream> {
        let vector = self.shape(Shape::Vector(self.program.layout.len()));
        let normalised = self.program.layout.quaternions().map(|places| {
            let [w, x, y, z] = [0, 1, 2, 3].map(|n| count(places.start + n));
            quote! {
                let norm = (x[#w] * x[#w] + x[#x] * x[#x] + x[#y] * x[#y] + x[#z] * x[#z]).sqrt();
                x[#w] /= norm;
                x[#x] /= norm;
                x[#y] /= norm;
                x[#z] /= norm;
            }
        });
        let closed = self.program.with_role(Role::LoopCorrections).map(|_| {
            let (zero, least) = (number(0.0), number(LAST_CORRECTION * LAST_CORRECTION));
            let before = count(CORRECTIONS - 1);
            let places = self.program.layout.dependents().zip(0..);
            let corrected: Vec<TokenStream> = places
                .map(|(place, n)| {
                    let (place, n) = (count(place), count(n));
                    quote!(x[#place] += corrections[#n];)
                })
                .collect();
            quote! {
                for _ in 0..#before {
                    let corrections = self.loop_corrections(t, &*x);
                    #(#corrected)*
                }
                let corrections = self.loop_corrections(t, &*x);
                #(#corrected)*
                for correction in corrections.iter() {
                    x[0] += #zero * (#least - *correction * *correction).sqrt();
                }
            }
        });
        let statements: Vec<TokenStream> = normalised.chain(closed).collect();
        (!statements.is_empty()).then(|| {
            quote! {
                #[inline]
                fn project(&self, t: T, x: &mut #vector) {
                    #(#statements)*
                }
            }
        })
    }

    /// Method that closes the loops of an initial condition, if dependent coordinates are in the state.
    pub(super) fn assemble(&self) -> Option<TokenStream> {
        self.program.with_role(Role::LoopCorrections)?;
        let (length, vector) = (self.length(), self.shape(Shape::Vector(self.program.layout.len())));
        let places = self.program.layout.dependents().map(count);
        let name = &self.head.name;
        let of_trait = if self.program.inputs.is_empty() {
            self.named("System")
        } else {
            let inputs = count(self.program.inputs.len());
            quote!(::pendulum_core::Controlled<T, #length, #inputs>)
        };
        Some(quote! {
            /// Closes the loops of a state in which the dependent coordinates are guesses.
            ///
            /// # Errors
            /// If Newton's method does not converge near the guess; the error names the loop with the largest gap.
            pub fn assemble(
                &self,
                t: T,
                near: impl ::pendulum_core::IntoState<T, #length>,
            ) -> ::core::result::Result<#vector, ::pendulum_core::NotAssembled>
            where
                T: ::pendulum_core::Float,
            {
                ::pendulum_core::system::assemble(
                    near.into_state(),
                    <#name>::LAYOUT,
                    [#(#places),*],
                    |x| self.loop_corrections(t, x),
                    |x, tell| <Self as #of_trait>::gaps(self, t, x, tell),
                )
            }
        })
    }
}

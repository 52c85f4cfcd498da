//! Power series of the derivatives of a motion.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::block::Piece;
use super::lanes::inlined_into_lanes;
use super::{Items, allowed, count};
use crate::program::{Block, Coefficient, Tangents, Variable};

impl Items<'_> {
    /// Tangents for which code is printed. Recurrences that are written out order by order are as fast in dual numbers.
    pub(super) fn tangents(&self) -> Option<&Tangents> {
        let series = self.program.series.as_ref().filter(|_| !self.is_written_out())?;
        series.tangents.as_ref()
    }

    /// Number of products in the series of the motion.
    fn products_of_motion(&self) -> usize {
        self.program.series.as_ref().map_or(0, |series| series.products)
    }

    /// Numbers of the state, the equations of motion, the constants, the entries by constants, the kept values and the
    /// products.
    fn sizes(&self, tangents: &Tangents) -> [Literal; 6] {
        let [_, rates] = self.program.layout.components();
        let constants = self.program.constants_text.len();
        let own = [tangents.by_constants, tangents.kept, tangents.products];
        let [by_constants, kept, products] = own.map(count);
        [
            self.length(),
            count(rates.len()),
            count(constants),
            by_constants,
            kept,
            products,
        ]
    }

    /// Statements at the start of the series of a motion, which leave them to those of its tangents.
    pub(super) fn by_tangents(&self, tangents: &Tangents) -> TokenStream {
        let (name, sizes) = (&self.head.name, self.sizes(tangents));
        quote! {
            if const { T::TAKEN_APART } {
                ::pendulum_core::taylor::series_by_tangents::<#name, T, #(#sizes),*>(
                    &self.params, &self.constants, t, x,
                );
                return;
            }
        }
    }

    /// `impl Linearized` for the model.
    pub(super) fn linearized(&self, tangents: &Tangents) -> TokenStream {
        let (head, inline, allowed, parameters) =
            (&self.head.name, inlined_into_lanes(), allowed(), self.parameters_name());
        let all = self.sizes(tangents);
        let [state, rates, constants, by_constants, kept, products] = &all;
        let (real, core) = (quote!(::pendulum_core::real::Real), quote!(::pendulum_core::taylor));
        let equations = self.program.layout.components()[1].len();
        let of_motion = 3 * equations * equations;
        let slots = count(self.products_of_motion());
        let split = |values: &[Piece]| -> TokenStream {
            let (matrices, by_constants) = values.split_at(of_motion);
            let rows = matrices.chunks(equations).map(|row| quote!([#(#row),*]));
            let rows: Vec<TokenStream> = rows.collect();
            let matrices = rows.chunks(equations).map(|matrix| quote!([#(#matrix),*]));
            quote!([#(#matrices),*], [#(#by_constants),*])
        };
        let both = of_motion + tangents.by_constants;
        let start = self.read(&tangents.start, |values| {
            let (entries, kept) = values.split_at(both);
            let entries = split(entries);
            quote!((#entries, [#(#kept),*]))
        });
        let orders = [
            (Coefficient::Order, quote!(k as f64)),
            (Coefficient::OverOrder, quote!(1.0 / k as f64)),
        ]
        .map(|(coefficient, number)| {
            let name = self.names().variable(Variable::Series(coefficient));
            quote!(let #name = T::from_f64(#number);)
        });
        let order = self.read(&tangents.order, |values| {
            let (entries, sides) = values.split_at(both);
            let (entries, (left, right)) = (split(entries), sides.split_at(tangents.products));
            quote!((#entries, [[#(#left),*], [#(#right),*]]))
        });
        let step = self.read(&tangents.step, |values| quote!([#(#values),*]));
        let vector = quote!(::pendulum_core::nalgebra::SVector<T, #state>);
        let matrices = quote!(#core::Matrices<T, #rates>);
        quote! {
            #allowed
            impl #core::Linearized<#(#all),*> for #head {
                type Parameters = #parameters;

                #[inline]
                fn with_constants<T: #real>(params: &#parameters, constants: [T; #constants]) -> #head<T> {
                    #head { params: *params, constants }
                }

                #inline
                fn start<T: #real>(
                    constants: &[T; #constants],
                    state: &#vector,
                    accelerations: &[T; #rates],
                ) -> (#matrices, [T; #by_constants], [T; #kept]) {
                    #start
                }

                #inline
                fn order<T: #real>(
                    constants: &[T; #constants],
                    kept: &[T; #kept],
                    k: usize,
                    sums: &[T; #products],
                    coefficients: &#vector,
                    accelerations: &[T; #rates],
                    motion: &#core::Products<T, #slots>,
                ) -> (#matrices, [T; #by_constants], [[T; #products]; 2]) {
                    #(#orders)*
                    #order
                }

                #inline
                fn step<T: #real>(
                    constants: &[T; #constants],
                    kept: &[T; #kept],
                    by_constants: &[T; #by_constants],
                    sums: &[T; #rates],
                    of_constants: &[T; #constants],
                ) -> [T; #rates] {
                    #step
                }
            }
        }
    }

    /// Code of a block whose variables are in arrays.
    fn read(&self, block: &Block, result: impl FnOnce(&[Piece]) -> TokenStream) -> TokenStream {
        let products = self.products_of_motion();
        let place = |array: &str, n: usize| -> (Ident, Literal) { (format_ident!("{array}"), count(n)) };
        let reads = block.reads();
        let is_side = |variable: &Variable| matches!(variable, Variable::Series(Coefficient::Side(_)));
        let sides = reads
            .iter()
            .any(is_side)
            .then(|| quote!(let [left, right] = motion.factors(k);));
        let reads = reads.into_iter().filter_map(|variable| {
            let (array, n) = match variable {
                Variable::Constant(n) => place("constants", n),
                Variable::State(n) => place("state", n),
                Variable::Acceleration(n) => place("accelerations", n),
                Variable::Weight(n) => place("of_constants", n),
                Variable::Factor(n) => place("by_constants", n),
                Variable::Series(Coefficient::Side(n)) if n < products => place("left", n),
                Variable::Series(Coefficient::Side(n)) => place("right", n - products),
                Variable::Series(Coefficient::State(n)) => place("coefficients", n),
                Variable::Series(Coefficient::Sum(n)) => place("sums", n),
                Variable::Series(Coefficient::Kept(n)) => place("kept", n),
                _ => return None,
            };
            let name = self.names().variable(variable);
            Some(quote!(let #name = #array[#n];))
        });
        let (reads, code) = (reads.collect::<TokenStream>(), self.names().code(block, result));
        quote!(#sides #reads #code)
    }
}

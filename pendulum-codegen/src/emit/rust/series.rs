//! Power series of a motion.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::block::{Piece, local};
use super::lanes::inlined_into_lanes;
use super::{Items, allowed, count};
use crate::expr::Precedence;
use crate::program::{Coefficient, Series, Variable};

/// Maximum number of products for which the code of each order is written out. Four products fill a vector register,
/// and are faster in loops.
const FEW: usize = 3;

impl Items<'_> {
    /// `impl TaylorSeries` for the model in any number type, and `impl CastTaylor` for all of them together.
    pub(super) fn series(&self) -> Option<TokenStream> {
        let series = self.program.series.as_ref()?;
        let (inline, core) = (inlined_into_lanes(), quote!(::pendulum_core::taylor));
        let (length, slots) = (self.length(), count(series.products));
        let vector = quote!(::pendulum_core::nalgebra::SVector<T, #length>);
        let (start, orders) = (self.start(series), self.orders(series));
        let given = quote!(t: T, x: &mut [#vector], work: &mut Self::Workspace);
        let tangents = self.tangents();
        let by_tangents = tangents.map(|tangents| self.by_tangents(tangents));
        let body = quote! {
            if x.len() < 2 {
                return;
            }
            #by_tangents
            #start
            #orders
        };
        let (workspace, create) = if self.is_written_out() {
            (quote!(()), TokenStream::new())
        } else {
            (quote!(#core::Products<T, #slots>), quote!(#core::Products::new()))
        };
        let hold = quote!(::pendulum_core::hybrid::Hold);
        let (series, of_modes) = if self.program.constraints.is_empty() {
            (quote!(#inline fn series(&self, #given) { #body }), None)
        } else {
            let series = quote! {
                #inline
                fn series(&self, #given) {
                    let Some(start) = x.first() else { return };
                    let forces = ::pendulum_core::hybrid::by_sign(self, t, start);
                    let hold = #hold { forces, ..::core::default::Default::default() };
                    #core::HybridSeries::eval_series(self, &hold, t, x, work);
                }
                #[inline]
                fn hybrid_series(
                    &self,
                ) -> ::core::option::Option<&dyn #core::HybridSeries<T, #length, Workspace = Self::Workspace>> {
                    Some(self)
                }
            };
            let of_modes = quote! {
                type Workspace = #workspace;
                #inline
                fn eval_series(&self, hold: &#hold<T>, #given) { #body }
            };
            (
                series,
                Some(self.implement(Some(quote!(#core::HybridSeries<T, #length>)), &of_modes)),
            )
        };
        let of_series = quote! {
            type Workspace = #workspace;
            #[inline]
            fn workspace(&self) -> Self::Workspace {
                #create
            }
            #series
        };
        let of_series = self.implement(Some(quote!(#core::TaylorSeries<T, #length>)), &of_series);
        let of_casts = self.cast_series(&workspace);
        let linearized = tangents.map(|tangents| self.linearized(tangents));
        Some(quote! {
            #linearized
            #of_series
            #of_modes
            #of_casts
        })
    }

    /// `impl CastTaylor` for all number types together.
    fn cast_series(&self, workspace: &TokenStream) -> TokenStream {
        let (name, length, allowed) = (&self.head.name, self.length(), allowed());
        let (real, core) = (quote!(::pendulum_core::real::Real), quote!(::pendulum_core::taylor));
        quote! {
            #allowed
            impl #core::CastTaylor<#length> for #name {
                type Workspace<T: #real> = #workspace;
                #[inline]
                fn with_series<T: #real>(
                    model: &#name<T>,
                ) -> &impl #core::TaylorSeries<T, #length, Workspace = #workspace> {
                    model
                }
            }
        }
    }

    /// Statements for order 0, which compute the state of order 1 and the values shared by all higher orders.
    fn start(&self, series: &Series) -> TokenStream {
        let length = self.program.layout.len();
        let rates: Vec<Ident> = (0..length).map(|n| local(&format!("a{n}"))).collect();
        let kept = self.all(series.kept, Coefficient::Kept);
        let block = self.block(&series.start, |values| quote!((#(#values,)*)));
        let is_hybrid = !self.program.constraints.is_empty();
        let held = is_hybrid.then(|| {
            quote! {
                let held = ::pendulum_core::hybrid::HeldSeries::new(self, hold, t, &x[0]);
                let forces = &held.forces;
            }
        });
        let pin = is_hybrid.then(|| quote!(held.pin(self, &mut x[1]);));
        quote! {
            #held
            let (#(#rates,)* #(#kept,)*) = {
                let x = &x[0];
                #block
            };
            x[1] = ::pendulum_core::nalgebra::SVector::from([#(#rates),*]);
            #pin
        }
    }

    /// True if the code of each order is written out, rather than a loop over the orders.
    pub(super) fn is_written_out(&self) -> bool {
        let series = self.program.series.as_ref();
        self.program.constraints.is_empty() && series.is_some_and(|series| series.products <= FEW)
    }

    /// Code for the orders from 1 on, each of which computes the state of the next.
    fn orders(&self, series: &Series) -> TokenStream {
        let length = self.program.layout.len();
        let name = |coefficient| self.names().variable(Variable::Series(coefficient));
        let [order, over_order, time] = [Coefficient::Order, Coefficient::OverOrder, Coefficient::Time].map(name);
        let (state, sums) = (
            self.all(length, Coefficient::State),
            self.all(series.products, Coefficient::Sum),
        );
        let mut reads = series.order.reads();
        reads.extend(series.before.reads());
        let is_hybrid = !self.program.constraints.is_empty();
        let pin = is_hybrid.then(|| quote!(held.pin(self, &mut x[k + 1]);));
        let reads_time = reads.contains(&Variable::Series(Coefficient::Time));
        let time = reads_time.then(|| quote!(let #time = T::from_f64(if k == 1 { 1.0 } else { 0.0 });));
        let head = self.constants(&format_ident!("self"), &reads);
        let (core, slots) = (quote!(::pendulum_core::taylor), count(series.products));
        let (memory, interior, push) = if self.is_written_out() {
            (
                quote!(let mut work = #core::FewProducts::<T, #slots>::new();),
                quote!(work.sums(k)),
                None,
            )
        } else {
            (
                quote!(let mut newest = #core::Newest::new();),
                quote!(newest.add(work.sums(k))),
                Some(quote!(newest.push(k, left, right);)),
            )
        };
        let code = self.names().code(&series.order, |values| {
            let (rates, sides) = values.split_at(length);
            let (left, right) = sides.split_at(series.products);
            let rates = rates.iter().map(|rate| rate.within(Precedence::Atom));
            quote! {
                let (left, right) = ([#(#left),*], [#(#right),*]);
                #push
                work.set(k, left, right);
                x[k + 1] = ::pendulum_core::nalgebra::SVector::from([#(#rates.scaled(over_next)),*]);
                #pin
            }
        });
        let before = self.names().code(&series.before, |values| self.next_forces(values));
        let of_order = quote! {
            let #order = T::from_f64(k as f64);
            let #over_order = over_next;
            over_next = T::from_f64(1.0 / (k + 1) as f64);
            #time
            let [#(#sums),*] = #interior;
            let [#(#state),*] = x[k].data.0[0];
            #before
            #code
        };
        let of_orders = if self.is_written_out() {
            quote! {
                let end = x.len() - 1;
                assert!(end <= #core::MAX_ORDER, "the order of a series is at most {}", #core::MAX_ORDER);
                ::pendulum_core::for_each_order!(k in 1..end { #of_order });
            }
        } else {
            quote!(for k in 1..x.len() - 1 { #of_order })
        };
        quote! {
            #head
            let mut over_next = T::from_f64(1.0);
            #memory
            #of_orders
        }
    }

    /// Statement for the coefficients of the forces along the constraints, from the second derivatives of the
    /// constraints without these forces.
    fn next_forces(&self, values: &[Piece]) -> TokenStream {
        let constraints = self.program.constraints.len();
        if constraints == 0 {
            return TokenStream::new();
        }
        let accelerations = &values[..constraints];
        let forces = self.all(constraints, Coefficient::Force);
        let number = (0..constraints).map(count);
        quote! {
            let mut accelerations = [T::from_f64(0.0); ::pendulum_core::hybrid::MAX_CONSTRAINTS];
            #(accelerations[#number] = #accelerations;)*
            let [#(#forces,)* ..] = held.next(&accelerations);
        }
    }

    /// Names of all coefficients of a kind.
    fn all(&self, count: usize, kind: fn(usize) -> Coefficient) -> Vec<Ident> {
        let names = (0..count).map(|n| self.names().variable(Variable::Series(kind(n))));
        names.collect()
    }
}

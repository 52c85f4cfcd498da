//! The power series of a motion.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::block::local;
use super::lanes::inlined_into_lanes;
use super::{Items, allowed, count};
use crate::expr::Precedence;
use crate::program::{Coefficient, Series, Variable};

impl Items<'_> {
    /// `impl TaylorSeries` for the model in any number type, and `impl CastTaylor` for all of them together.
    pub(super) fn series(&self) -> Option<TokenStream> {
        let series = self.program.series.as_ref()?;
        let (name, allowed, inline) = (&self.head.name, allowed(), inlined_into_lanes());
        let (length, slots) = (self.length(), count(series.products));
        let (real, core) = (quote!(::pendulum_core::real::Real), quote!(::pendulum_core::taylor));
        let vector = quote!(::pendulum_core::nalgebra::SVector<T, #length>);
        let (start, orders) = (self.start(series), self.orders(series));
        Some(quote! {
            #allowed
            impl<T: #real> #core::TaylorSeries<T, #length> for #name<T> {
                type Workspace = #core::Products<T, #slots>;
                #[inline]
                fn workspace(&self) -> Self::Workspace {
                    #core::Products::new()
                }
                #inline
                fn series(&self, t: T, x: &mut [#vector], work: &mut Self::Workspace) {
                    if x.len() < 2 {
                        return;
                    }
                    #start
                    #orders
                }
            }
            #allowed
            impl #core::CastTaylor<#length> for #name {
                type Workspace<T: #real> = #core::Products<T, #slots>;
                #[inline]
                fn workspace<T: #real>() -> #core::Products<T, #slots> {
                    #core::Products::new()
                }
                #inline
                fn series<T: #real>(system: &#name<T>, t: T, x: &mut [#vector], work: &mut #core::Products<T, #slots>) {
                    #core::TaylorSeries::series(system, t, x, work);
                }
            }
        })
    }

    /// Order 0, which gives the state of order 1 and what the orders beyond have in common.
    fn start(&self, series: &Series) -> TokenStream {
        let length = self.program.layout.len();
        let rates: Vec<Ident> = (0..length).map(|n| local(&format!("a{n}"))).collect();
        let kept = self.all(series.kept, Coefficient::Kept);
        let block = self.block(&series.start, |values| quote!((#(#values,)*)));
        quote! {
            let (#(#rates,)* #(#kept,)*) = {
                let x = &x[0];
                #block
            };
            x[1] = ::pendulum_core::nalgebra::SVector::from([#(#rates),*]);
        }
    }

    /// The orders from 1 on, each of which gives the state of the next.
    fn orders(&self, series: &Series) -> TokenStream {
        let length = self.program.layout.len();
        let name = |coefficient| self.names().variable(Variable::Series(coefficient));
        let [order, over_order, time] = [Coefficient::Order, Coefficient::OverOrder, Coefficient::Time].map(name);
        let (state, sums) = (
            self.all(length, Coefficient::State),
            self.all(series.products, Coefficient::Sum),
        );
        let reads = series.order.reads();
        let reads_time = reads.contains(&Variable::Series(Coefficient::Time));
        let time = reads_time.then(|| quote!(let #time = T::from_f64(if k == 1 { 1.0 } else { 0.0 });));
        let head = self.constants(&reads);
        let code = self.names().code(&series.order, |values| {
            let (rates, sides) = values.split_at(length);
            let (left, right) = sides.split_at(series.products);
            let rates = rates.iter().map(|rate| rate.within(Precedence::Product));
            quote! {
                let (left, right) = ([#(#left),*], [#(#right),*]);
                newest.push(k, left, right);
                work.set(k, left, right);
                x[k + 1] = ::pendulum_core::nalgebra::SVector::from([#(#rates * over_next),*]);
            }
        });
        quote! {
            #head
            let mut over_next = T::from_f64(1.0);
            let mut newest = ::pendulum_core::taylor::Newest::new();
            for k in 1..x.len() - 1 {
                let #order = T::from_f64(k as f64);
                let #over_order = over_next;
                over_next = T::from_f64(1.0) / T::from_f64((k + 1) as f64);
                #time
                let [#(#sums),*] = newest.add(work.sums(k));
                let [#(#state),*] = x[k].data.0[0];
                #code
            }
        }
    }

    /// The names of all coefficients of a kind.
    fn all(&self, count: usize, kind: fn(usize) -> Coefficient) -> Vec<Ident> {
        let names = (0..count).map(|n| self.names().variable(Variable::Series(kind(n))));
        names.collect()
    }
}

//! The power series of a motion.

use proc_macro2::TokenStream;
use quote::quote;

use super::body::{Body, local};
use super::lanes::inlined_into_lanes;
use super::{Items, allowed, number};
use crate::expr::Expr;
use crate::form::Taylor;

impl Items<'_> {
    /// `impl TaylorSeries` for the model in any number type, and `impl TaylorModel` for all of them together.
    pub(super) fn taylor(&self) -> Option<TokenStream> {
        let taylor = self.program.taylor.as_ref()?;
        let (name, allowed, inline) = (self.name(), allowed(), inlined_into_lanes());
        let (length, slots) = (number(2 * self.dof()), number(taylor.slots));
        let (real, core) = (quote!(::pendulum_core::real::Real), quote!(::pendulum_core::taylor));
        let vector = quote!(::pendulum_core::nalgebra::SVector<T, #length>);
        let (start, orders) = (self.start(taylor), self.orders(taylor));
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
            impl #core::TaylorModel<#length> for #name {
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
    fn start(&self, taylor: &Taylor<'_>) -> TokenStream {
        let (dof, accelerations) = (self.dof(), self.accelerations());
        let names = self.kept(taylor);
        let block = self.block(&taylor.start, |values| quote!((#(#values,)*)));
        let rates = (dof..2 * dof).map(number);
        quote! {
            let (#(#accelerations,)* #(#names,)*) = {
                let x = &x[0];
                #block
            };
            x[1] = ::pendulum_core::nalgebra::SVector::from([#(x[0][#rates],)* #(#accelerations),*]);
        }
    }

    /// The orders from 1 on, each of which gives the state of the next.
    fn orders(&self, taylor: &Taylor<'_>) -> TokenStream {
        let (graph, dof, symbols) = (self.program.model.graph, self.dof(), &taylor.symbols);
        let state: Vec<_> = (0..2 * dof).map(|n| local(format!("x{n}"))).collect();
        let sums: Vec<_> = (0..taylor.slots).map(|n| local(format!("s{n}"))).collect();
        let (mut known, mut head) = self.constants_read(&taylor.order);
        let lists = [
            (&symbols.state, state.clone()),
            (&symbols.sums, sums.clone()),
            (&symbols.kept, self.kept(taylor)),
        ];
        for (ids, names) in lists {
            known.extend(ids.iter().map(|x| x.id()).zip(names));
        }
        let single = [
            (symbols.order, "order"),
            (symbols.over_order, "over_order"),
            (symbols.time, "time"),
        ];
        let [order, over_order, time] = single.map(|(x, name)| {
            let name = local(name.to_owned());
            known.insert(x.id(), name.clone());
            name
        });
        let reads = |x: Expr<'_>| graph.reachable(&taylor.order).binary_search(&x.id()).is_ok();
        let time = reads(symbols.time).then(|| quote!(let #time = T::from_f64(if k == 1 { 1.0 } else { 0.0 });));
        head.extend(quote!(let mut over_next = T::from_f64(1.0);));
        let code = Body::code(graph, &taylor.order, &known, |values| {
            let (accelerations, sides) = values.split_at(dof);
            let (left, right) = sides.split_at(taylor.slots);
            let rates = &state[dof..];
            quote! {
                let (left, right) = ([#(#left),*], [#(#right),*]);
                newest.push(k, left, right);
                work.set(k, left, right);
                x[k + 1] = ::pendulum_core::nalgebra::SVector::from([
                    #(#rates * over_next,)* #((#accelerations) * over_next),*
                ]);
            }
        });
        quote! {
            #head
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

    fn accelerations(&self) -> Vec<proc_macro2::Ident> {
        (0..self.dof()).map(|n| local(format!("a{n}"))).collect()
    }

    fn kept(&self, taylor: &Taylor<'_>) -> Vec<proc_macro2::Ident> {
        (0..taylor.symbols.kept.len()).map(|n| local(format!("h{n}"))).collect()
    }
}

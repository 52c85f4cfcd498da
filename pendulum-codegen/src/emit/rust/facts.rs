//! Constants of the generated type that need no evaluation.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::{Items, count};
use crate::pass::Operations;
use crate::program::Cost;

impl Items<'_> {
    /// Names, costs and equations.
    pub(super) fn facts(&self) -> TokenStream {
        let (name, program) = (&self.head.name, self.program);
        let (dof, equations) = (count(program.layout.dof()), &program.equations);
        let coordinates = program.layout.slots.iter().map(|slot| &slot.name);
        let costs = program.routines.iter().map(|routine| cost(routine.name, &routine.cost));
        let of_series = program.series.as_ref().map(|series| {
            let (cost, products) = (cost("taylor", &series.cost), count(series.products));
            quote!(#cost, taylor_products: #products)
        });
        let costs = costs.chain(of_series);
        quote! {
            impl #name {
                /// The number of degrees of freedom; the state has twice as many components.
                pub const DOF: usize = #dof;
                /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
                pub const COORDINATES: [&'static str; #dof] = [#(#coordinates),*];
                /// Counted operations of each generated function, in the form that it has and in others.
                pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost { #(#costs,)* ..::pendulum_core::Cost::ZERO };
                /// The equations of motion as text.
                pub const EQUATIONS: &'static str = #equations;
            }
        }
    }
}

/// The cost of a routine: its operations in its form and in others.
fn cost(name: &str, cost: &Cost) -> TokenStream {
    let (name, own, form) = (format_ident!("{name}"), operations(&cost.operations), &cost.form);
    let others = cost.others.iter().map(|(form, count)| {
        let count = operations(count);
        quote!((#form, #count))
    });
    quote! {
        #name: ::pendulum_core::FunctionCost { operations: #own, form: #form, others: &[#(#others),*] }
    }
}

/// Counted operations, as a value of the core's type.
fn operations(operations: &Operations) -> TokenStream {
    let Operations {
        additions,
        multiplications,
        divisions,
        sincos,
        functions,
        chain,
    } = operations;
    let counts = [additions, multiplications, divisions, sincos, functions, chain].map(|&n| count(n));
    quote!(::pendulum_core::Operations::new(#(#counts),*))
}

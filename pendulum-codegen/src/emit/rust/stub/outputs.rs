//! Outputs and events of a model that has errors: what they seem to be.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::count;
use crate::ast::{ExprKind, Items, Output, OutputValue};
use crate::program::{functions_of_event, functions_of_output, is_function};

/// The functions of outputs and events, in a scene with these inputs.
pub(super) fn functions(items: &Items, inputs: &Ident) -> TokenStream {
    // a name that is declared twice is a function once
    let mut known: BTreeSet<String> = BTreeSet::new();
    let mut fresh = |name: &String| !is_function(name, items.is_hybrid()) && known.insert(name.clone());
    let inputs = (!items.inputs.is_empty()).then(|| quote!(, _: &#inputs<T>));
    let given = |output: &Output| inputs.clone().filter(|_| has_rates(items, output)).unwrap_or_default();
    let (matrix, zero) = (quote!(::pendulum_core::nalgebra::SMatrix), quote!(T::from_f64(0.0)));
    let state = quote!(&self, _: T, _: &::pendulum_core::nalgebra::SVector<T, N>);
    let (mut functions, mut all) = (TokenStream::new(), 0);
    for output in &items.outputs {
        let shape = shape(items, output);
        let length = shape.map_or(1, |(rows, columns)| rows * columns);
        all += length;
        let (value, null) = match shape {
            None => (quote!(T), zero.clone()),
            Some((rows, columns)) => {
                let (rows, columns) = (count(rows), count(columns));
                (
                    quote!(#matrix<T, #rows, #columns>),
                    quote!(#matrix::from_element(#zero)),
                )
            }
        };
        let names = functions_of_output(&output.name);
        if !names.iter().all(&mut fresh) {
            continue;
        }
        let ([own, rate, both], length, given) =
            (names.map(|name| format_ident!("{name}")), count(length), given(output));
        functions.extend(quote! {
            pub fn #own<const N: usize>(#state) -> #value { #null }
            pub fn #rate<const N: usize>(#state #given) -> #value { #null }
            pub fn #both<const N: usize>(#state) -> (#value, #matrix<T, #length, N>) {
                (#null, #matrix::from_element(#zero))
            }
        });
    }
    for event in &items.events {
        let names = functions_of_event(&event.name);
        if !names.iter().all(&mut fresh) {
            continue;
        }
        let [value, event] = names.map(|name| format_ident!("{name}"));
        functions.extend(quote! {
            pub fn #value<const N: usize>(#state) -> T { #zero }
            ::pendulum_core::with_std! {
                pub fn #event<const N: usize>(&self) -> ::pendulum_core::Event<'_, T, N> {
                    ::pendulum_core::Event::new(|_, _| #zero)
                }
            }
        });
    }
    let given = items.outputs.iter().map(given).find(|given| !given.is_empty());
    let (all, events) = (count(all), count(items.events.len()));
    functions.extend(quote! {
        pub fn outputs<const N: usize>(#state) -> #matrix<T, #all, 1> { #matrix::from_element(#zero) }
        pub fn output_rates<const N: usize>(#state #given) -> #matrix<T, #all, 1> { #matrix::from_element(#zero) }
        pub fn outputs_and_jacobian<const N: usize>(#state) -> (#matrix<T, #all, 1>, #matrix<T, #all, N>) {
            (#matrix::from_element(#zero), #matrix::from_element(#zero))
        }
        ::pendulum_core::with_std! {
            pub fn events<const N: usize>(&self) -> [::pendulum_core::Event<'_, T, N>; #events] {
                ::core::array::from_fn(|_| ::pendulum_core::Event::new(|_, _| #zero))
            }
        }
    });
    functions
}

/// The rows and columns of an output; none for a number.
fn shape(items: &Items, output: &Output) -> Option<(usize, usize)> {
    match output.value.as_ref().ok()? {
        OutputValue::List(list) => Some((list.len(), 1)),
        OutputValue::Scalar(e) => match &e.kind {
            ExprKind::Name(name) if items.points.iter().any(|point| point.name == *name) => Some((3, 1)),
            ExprKind::Call(function, _) if function == "rotation" => Some((3, 3)),
            _ => None,
        },
    }
}

/// How many joints seem to be driven.
pub(super) fn drives(items: &Items) -> usize {
    items.bodies.iter().filter(|body| items.is_driven(body)).count()
}

/// Whether an output seems to depend on rates.
fn has_rates(items: &Items, output: &Output) -> bool {
    let is_rate = |kind: &ExprKind| matches!(kind, ExprKind::Call(function, _) if function == "dot");
    match &output.value {
        Ok(OutputValue::Scalar(e)) => items.uses(e, &is_rate),
        Ok(OutputValue::List(list)) => list.iter().any(|e| items.uses(e, &is_rate)),
        Err(_) => false,
    }
}

//! Constants of the generated type that need no evaluation.

use std::ops::Range;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::{Items, count};
use crate::program::{Cost, Operations, Slot, SlotKind, StateLayout, StateVariable};

impl Items<'_> {
    /// Names, costs and equations.
    pub(super) fn facts(&self) -> TokenStream {
        let (name, program) = (&self.head.name, self.program);
        let (dof, equations) = (count(program.layout.dof()), program.equations.to_string());
        let [_, coordinates] = program.layout.components();
        let routines = program
            .routines
            .iter()
            .map(|routine| (routine.name.as_str(), &routine.cost));
        let series = program.series.iter().map(|series| ("taylor", &series.cost));
        let costs = routines.chain(series).map(|(name, of_routine)| {
            let of_routine = cost(of_routine);
            quote!((#name, #of_routine))
        });
        let layout = layout(&program.layout);
        let places = program.layout.slots.iter().map(places);
        let places = places.chain(program.layout.states.iter().map(place));
        let (about_freedom, about_names) = docs_of_freedom(&program.layout);
        let outputs = names_of("OUTPUTS", "Names of the components of all outputs.", &program.outputs);
        let events: Vec<String> = program.events.iter().map(|event| event.name.clone()).collect();
        let events = names_of("EVENTS", "Names of the events.", &events);
        let drives = names_of("DRIVES", "Bodies whose joints are driven.", &program.drives);
        let limits = self.limits();
        let repaired = names_of("REPAIRED", "Repairs made to the file of the robot.", &program.repaired);
        quote! {
            impl #name {
                #(#places)*
                #[doc = #about_freedom]
                pub const DOF: usize = #dof;
                #[doc = #about_names]
                pub const COORDINATES: [&'static str; #dof] = [#(#coordinates),*];
                /// Operation counts of each generated function, in its own form and in others.
                pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(&[#(#costs),*]);
                /// Layout of the state.
                pub const LAYOUT: ::pendulum_core::StateLayout<'static> = #layout;
                /// Equations of motion as text.
                pub const EQUATIONS: &'static str = #equations;
                #outputs
                #events
                #drives
                #repaired
                #limits
            }
        }
    }

    /// Maximum force and rate of each coordinate, if the file of a robot gives any.
    fn limits(&self) -> Option<TokenStream> {
        let most = &self.program.most;
        let dof = count(most.len());
        let [effort, velocity] = [0, 1].map(|n| {
            let numbers = most.iter().map(|own| match own[n] {
                most if most.is_finite() => quote!(#most),
                _ => quote!(f64::INFINITY),
            });
            quote!([#(#numbers),*])
        });
        let limits = quote! {
            /// The largest force along each joint, from the file of the robot, in the order of `COORDINATES`: in N m
            /// where a joint turns, in N where it slides; infinite where the file gives none.
            #[allow(clippy::approx_constant)]
            pub const EFFORT_LIMITS: [f64; #dof] = #effort;
            /// The largest rate of each joint, from the file of the robot, in the order of `COORDINATES`: in rad/s
            /// where a joint turns, in m/s where it slides; infinite where the file gives none.
            #[allow(clippy::approx_constant)]
            pub const VELOCITY_LIMITS: [f64; #dof] = #velocity;
        };
        (!most.is_empty()).then_some(limits)
    }
}

/// Constant that lists names, if there are any.
fn names_of(constant: &str, doc: &str, names: &[String]) -> Option<TokenStream> {
    let (constant, length) = (format_ident!("{constant}"), count(names.len()));
    let plain = names.iter().map(|name| name.trim_start_matches("r#"));
    let item = quote! {
        #[doc = #doc]
        pub const #constant: [&'static str; #length] = [#(#plain),*];
    };
    (!names.is_empty()).then_some(item)
}

/// Constants for the indices of a coordinate and its rate in the state.
fn places(slot: &Slot) -> TokenStream {
    let Slot {
        name,
        kind,
        positions,
        rates,
        constants: [position, rate],
        ..
    } = slot;
    let [own, dot] =
        [(name.clone(), kind.unit()), (format!("dot({name})"), kind.rate_unit())].map(|(name, unit)| match kind {
            SlotKind::Quaternion => {
                format!("First index of `{name}` in the state. Its components are in {unit}.")
            }
            _ => format!("Index of `{name}` in the state, in {unit}."),
        });
    let (position, rate) = (format_ident!("{position}"), format_ident!("{rate}"));
    let (first, first_rate) = (count(positions.start), count(rates.start));
    let of_rate = (!rates.is_empty()).then(|| {
        quote! {
            #[doc = #dot]
            pub const #rate: usize = #first_rate;
        }
    });
    quote! {
        #[doc = #own]
        pub const #position: usize = #first;
        #of_rate
    }
}

/// Constant for the index of a first-order state.
fn place(state: &StateVariable) -> TokenStream {
    let StateVariable {
        name,
        docs,
        unit,
        index,
        ..
    } = state;
    let (constant, index) = (format_ident!("{}", state.constant), count(*index));
    let own = format!("Index of the state `{name}`, in {unit}.");
    quote! {
        #[doc = #own]
        #(#[doc = #docs])*
        pub const #constant: usize = #index;
    }
}

/// Cost as a value of the core's type.
fn cost(of: &Cost) -> TokenStream {
    let (form, operations) = (&of.form, operations(&of.operations));
    let products = of.products.map(|products| {
        let products = count(products);
        quote!(.with_products(#products))
    });
    let others = of.others.iter().map(cost);
    let others = (!of.others.is_empty()).then(|| quote!(.with_others(&[#(#others),*])));
    quote!(::pendulum_core::FunctionCost::new(#form, #operations) #products #others)
}

/// Operation counts as a value of the core's type.
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

/// Layout as a value of the core's type.
fn layout(of: &StateLayout) -> TokenStream {
    let slots = of.slots.iter().map(|slot| {
        let kind = match slot.kind {
            SlotKind::Angle => quote!(Angle),
            SlotKind::Length => quote!(Length),
            SlotKind::Quaternion => quote!(Quaternion),
        };
        let range = |range: &Range<usize>| {
            let (start, end) = (count(range.start), count(range.end));
            quote!(#start..#end)
        };
        let (name, positions, rates) = (&slot.name, range(&slot.positions), range(&slot.rates));
        let periodic = slot.periodic.then(|| quote!(.periodic()));
        let cyclic = slot.cyclic.then(|| quote!(.cyclic()));
        quote! {
            ::pendulum_core::Slot::new(#name, ::pendulum_core::SlotKind::#kind, #positions, #rates) #periodic #cyclic
        }
    });
    let states = of.states.iter().map(|state| {
        let (name, unit, index) = (&state.name, &state.unit, count(state.index));
        quote!(::pendulum_core::StateVariable::new(#name, #unit, #index))
    });
    let states = (!of.states.is_empty()).then(|| quote!(.with_states(&[#(#states),*])));
    let autonomous = of.autonomous.then(|| quote!(.autonomous()));
    quote!(::pendulum_core::StateLayout::new(&[#(#slots),*]) #states #autonomous)
}

/// Documentation of `DOF` and `COORDINATES`.
fn docs_of_freedom(layout: &StateLayout) -> (&'static str, &'static str) {
    const NAMES: &str =
        " Names of the coordinates. The state holds their positions and then their rates in this order.";
    if layout.dependents().next().is_some() {
        (
            " Number of degrees of freedom, and of rates. The state also holds dependent coordinates.",
            " Names of the independent coordinates, in the order of their rates in the state.",
        )
    } else if layout.quaternions().next().is_some() {
        (
            " Number of degrees of freedom, and of rates. A quaternion has one more component than its rates.",
            " Names of the coordinates, in the order of their rates in the state. An orientation is listed as \
             the axes of its angular velocity.",
        )
    } else if layout.states.is_empty() {
        (
            " Number of degrees of freedom. The state has twice as many components.",
            NAMES,
        )
    } else {
        (
            " Number of degrees of freedom. The state has two components for each, and then the first-order states.",
            NAMES,
        )
    }
}

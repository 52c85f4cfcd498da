//! What stands in for a model whose declaration has errors, so that its uses are no errors of their own.

mod outputs;

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::routines::is_inherent;
use super::{allowed, count, in_own_module};
use crate::ast::Scene;
use crate::model::{FACTS, places};
use crate::program::{Argument, Length, ROUTINES, Shape, WRENCH};

/// Types that have everything a declaration could ask for, for states of any length, and that are never run.
pub(crate) fn stub(scene: &Scene) -> TokenStream {
    let (name, items) = (&scene.head.name, &scene.items);
    let [parameters, inputs] = ["Params", "Inputs"].map(|suffix| format_ident!("{name}{suffix}"));
    // a name that is declared twice is a field once
    let fields: BTreeSet<&Ident> = items.params.iter().map(|param| &param.name).collect();
    let controls: BTreeSet<&Ident> = items.inputs.iter().map(|input| &input.name).collect();
    let marker = controls
        .is_empty()
        .then(|| quote!(stub: ::core::marker::PhantomData<T>));
    let (fields, controls) = (fields.into_iter(), controls.into_iter());
    let slots = || items.bodies.iter().flat_map(|body| body.fields.slots());
    let orientations = items.bodies.iter().filter(|body| body.fields.orientation.is_some());
    // an orientation has three rates, and four components
    let orientations = orientations.count();
    let dependents = items.bodies.iter().filter(|body| body.fields.depends.is_some()).count();
    let freedom = slots().count() + 2 * orientations - dependents;
    let dof = count(freedom);
    let of_coordinates = slots().flat_map(|(_, slot)| places(&slot));
    // by mistake a place may have the name of another, or of a fact
    let mut places: BTreeSet<String> = of_coordinates.collect();
    places.retain(|place| !FACTS.contains(&place.as_str()));
    let places = places.iter().map(|place| format_ident!("{place}"));
    let given = count(items.params.len());
    // the length of the state tells a law of inputs its types; without any coordinate it was not read, and what depends
    // in closed loops may be part of it, as may be what was not read of a robot
    let is_whole = items.robot.as_ref().is_none_or(|robot| robot.unread.is_none());
    let (length, any_length) = if freedom > 0 && items.closures.is_empty() && is_whole {
        (count(2 * freedom + orientations).into_token_stream(), None)
    } else {
        (quote!(N), Some(quote!(, const N: usize)))
    };
    let real = quote!(::pendulum_core::real::Real);
    let vector = quote!(::pendulum_core::nalgebra::SVector<T, N>);
    let matrix = quote!(::pendulum_core::nalgebra::SMatrix);
    let zeros = quote!(::pendulum_core::nalgebra::SMatrix::from_element(T::from_f64(0.0)));
    let allowed = allowed();
    let allowed = quote!(#allowed #[allow(dead_code, missing_docs)]);
    let (system, inherent) = (quote!(&self, _: T, x: &#vector), quote!(&self, _: T, _: &#vector));
    let own = ROUTINES.iter().filter(|row| is_inherent(row.name)).map(|row| {
        let name = format_ident!("{}", row.name);
        let arguments = row.arguments.iter().filter_map(|argument| match argument {
            Argument::Inputs => (!items.inputs.is_empty()).then(|| quote!(, _: &#inputs<T>)),
            Argument::Forces => None,
            Argument::Accelerations => Some(quote!(, _: &#matrix<T, D, 1>)),
        });
        let arguments: TokenStream = arguments.collect();
        // a vector as long as one that is given
        let given = row.arguments.contains(&Argument::Accelerations);
        let generics = given.then(|| quote!(, const D: usize));
        let length = |length: Length| match length {
            Length::State => quote!(N),
            Length::Freedom if given => quote!(D),
            Length::Freedom => quote!(#dof),
            Length::Inputs => count(items.inputs.len()).into_token_stream(),
            Length::Parameters => count(items.params.len()).into_token_stream(),
            Length::Constraints => count(0).into_token_stream(),
            Length::Loops | Length::Gaps | Length::Uncounted => count(items.closures.len()).into_token_stream(),
            Length::Dependents => count(dependents).into_token_stream(),
            Length::Wrench => count(WRENCH).into_token_stream(),
            Length::Drives => count(outputs::drives(items)).into_token_stream(),
        };
        let results = row.shapes.iter().map(|shape| match shape.map(length) {
            Shape::Scalar => (quote!(T), quote!(T::from_f64(0.0))),
            Shape::Vector(n) => (quote!(#matrix<T, #n, 1>), zeros.clone()),
            Shape::Matrix(n, m) => (quote!(#matrix<T, #n, #m>), zeros.clone()),
            Shape::Symmetric(n) => (quote!(#matrix<T, #n, #n>), zeros.clone()),
        });
        let (types, values): (Vec<TokenStream>, Vec<TokenStream>) = results.unzip();
        let (output, result) = match (&types[..], &values[..]) {
            ([one], [value]) => (one.clone(), value.clone()),
            _ => (quote!((#(#types),*)), quote!((#(#values),*))),
        };
        quote! {
            pub fn #name<const N: usize #generics>(#inherent #arguments) -> #output {
                #result
            }
        }
    });
    let assemble = (dependents > 0).then(|| {
        quote! {
            pub fn assemble<const N: usize>(
                &self,
                _: T,
                near: impl ::pendulum_core::IntoState<T, N>,
            ) -> ::core::result::Result<#vector, ::pendulum_core::NotAssembled> {
                Ok(near.into_state())
            }
        }
    });
    let own = own.chain(assemble).chain([outputs::functions(items, &inputs)]);
    // either trait has the constraints, and a name must not be found in both; the model itself has the others
    let is_hybrid = items.is_hybrid() && items.inputs.is_empty();
    let controlled = (!is_hybrid).then(|| {
        quote! {
            #allowed
            impl<T: #real, const N: usize> ::pendulum_core::Plant<T, N> for #name<T> {
                type Given = #inputs<T>;
                fn eval(#system, _: &#inputs<T>) -> #vector {
                    *x
                }
            }
            #allowed
            impl<T: #real, const N: usize> ::pendulum_core::PlantJacobian<T, N> for #name<T> {
                fn eval_with_jacobian(#system, _: &#inputs<T>) -> (#vector, #matrix<T, N, N>) {
                    (*x, #zeros)
                }
            }
            #allowed
            impl<T: #real, const N: usize, const M: usize> ::pendulum_core::Controlled<T, N, M> for #name<T> {
                type Inputs = #inputs<T>;
                fn input_jacobian(#inherent, _: &Self::Inputs) -> #matrix<T, N, M> {
                    #zeros
                }
            }
            #allowed
            impl<const N: usize, const M: usize> ::pendulum_core::CastControlled<N, M> for #name {
                type In<T: #real> = #name<T>;
                fn cast<T: #real>(&self) -> #name<T> {
                    #name::cast(self)
                }
                fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(models: impl ::core::ops::Fn(usize) -> &'m Self) -> #name<T>
                where
                    Self: 'm,
                {
                    models(0).cast()
                }
            }
        }
    });
    let hybrid = is_hybrid.then(|| {
        let core = quote!(::pendulum_core::hybrid);
        let vector = quote!(#matrix<T, #length, 1>);
        quote! {
            #allowed
            impl<T: #real #any_length> ::pendulum_core::Plant<T, #length> for #name<T> {
                type Given = [T; #core::MAX_CONSTRAINTS];
                fn eval(&self, _: T, x: &#vector, _: &[T; #core::MAX_CONSTRAINTS]) -> #vector {
                    *x
                }
                fn constraints(&self) -> &[#core::Constraint<'_>] {
                    &[]
                }
                fn laws(&self) -> [#core::Law<T>; #core::MAX_CONSTRAINTS] {
                    ::core::default::Default::default()
                }
                fn measures(&self, _: T, _: &#vector) -> [[T; 2]; #core::MAX_CONSTRAINTS] {
                    ::core::default::Default::default()
                }
                fn response(&self, _: T, x: &#vector, _: &[T; #core::MAX_CONSTRAINTS]) -> #core::Response<T, #length> {
                    #core::Response::new(*x)
                }
            }
        }
    });
    let items = quote! {
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        #allowed
        pub struct #parameters { #(pub #fields: f64),* }
        #allowed
        impl #parameters {
            pub const NAMES: [&'static str; #given] = [""; #given];
            pub const fn to_array(self) -> [f64; #given] {
                [0.0; #given]
            }
            pub fn from_array(_: [f64; #given]) -> Self {
                ::core::default::Default::default()
            }
        }
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        #allowed
        pub struct #inputs<T = f64> { #(pub #controls: T,)* #marker }
        #allowed
        impl<T: #real, const M: usize> ::core::convert::From<[T; M]> for #inputs<T> {
            fn from(_: [T; M]) -> Self {
                ::core::default::Default::default()
            }
        }
        #allowed
        impl<T: #real, const M: usize> ::core::convert::From<#inputs<T>> for [T; M] {
            fn from(_: #inputs<T>) -> Self {
                [T::from_f64(0.0); M]
            }
        }
        #[derive(Clone, Copy, Debug, PartialEq)]
        #allowed
        pub struct #name<T = f64>(::core::marker::PhantomData<T>, #parameters);
        #allowed
        impl #name {
            #(pub const #places: usize = 0;)*
            pub const DOF: usize = #dof;
            pub const COORDINATES: [&'static str; #dof] = [""; #dof];
            pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost::new(&[]);
            pub const LAYOUT: ::pendulum_core::StateLayout<'static> = ::pendulum_core::StateLayout::new(&[]);
            pub const EQUATIONS: &'static str = "";
            pub const OUTPUTS: [&'static str; 0] = [];
            pub const EVENTS: [&'static str; 0] = [];
            pub const DRIVES: [&'static str; 0] = [];
            pub fn new(params: #parameters) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
                Ok(Self(::core::marker::PhantomData, params))
            }
            pub fn cast<T: #real>(&self) -> #name<T> {
                #name(::core::marker::PhantomData, self.1)
            }
        }
        #allowed
        impl<T: #real> #name<T> {
            pub fn params(&self) -> &#parameters {
                &self.1
            }
            pub fn with_params(
                &self,
                params: #parameters,
            ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
                Ok(Self(::core::marker::PhantomData, params))
            }
            pub fn layout(&self) -> ::core::option::Option<::pendulum_core::StateLayout<'_>> {
                None
            }
            pub fn project<const N: usize>(&self, _: T, _: &mut #vector) {}
            pub fn margins<const N: usize>(&self, _: T, _: &#vector, _: &mut dyn FnMut([&str; 2], [T; 2])) {}
            pub fn gaps<const N: usize>(&self, _: T, _: &#vector, _: &mut dyn FnMut([&str; 2], [T; 3])) {}
            pub fn with_derivative<K #any_length, const M: usize>(self, _: K) -> Self
            where
                K: ::core::ops::Fn(T, &::pendulum_core::nalgebra::SVector<T, #length>) -> #matrix<T, M, #length>,
            {
                self
            }
            pub fn by_differences(self) -> Self {
                self
            }
            pub fn with_law<L>(&self, _: L) -> Self {
                *self
            }
            pub fn with_inputs<F #any_length>(&self, _: F) -> Self
            where
                F: ::core::ops::Fn(T, &::pendulum_core::nalgebra::SVector<T, #length>) -> #inputs<T>,
            {
                *self
            }
            #(#own)*
        }
        #allowed
        impl<T: #real, const N: usize> ::pendulum_core::System<T, N> for #name<T> {
            fn rhs(#system) -> #vector {
                *x
            }
        }
        #allowed
        impl<const N: usize> ::pendulum_core::Cast<N> for #name {
            type In<T: #real> = #name<T>;
            fn cast<T: #real>(&self) -> #name<T> {
                #name::cast(self)
            }
            fn gather<'m, T: ::pendulum_core::real::lanes::Lanes>(models: impl ::core::ops::Fn(usize) -> &'m Self) -> #name<T>
            where
                Self: 'm,
            {
                models(0).cast()
            }
        }
        ::pendulum_core::with_std! {
            #allowed
            impl<const N: usize> ::pendulum_core::shapes::Shapes<N> for #name {
                fn shapes(
                    &self,
                    _: f64,
                    _: &::pendulum_core::nalgebra::SVector<f64, N>,
                ) -> ::pendulum_core::shapes::Vec<::pendulum_core::shapes::Shape<'_>> {
                    ::core::default::Default::default()
                }
            }
        }
        #allowed
        impl<T: #real, const N: usize> ::pendulum_core::TaylorSeries<T, N> for #name<T> {
            type Workspace = ();
            fn workspace(&self) {}
            fn series(&self, _: T, _: &mut [#vector], _: &mut ()) {}
        }
        #allowed
        impl<const N: usize> ::pendulum_core::CastTaylor<N> for #name {
            type Workspace<T: #real> = ();
            fn with_series<T: #real>(
                model: &#name<T>,
            ) -> &impl ::pendulum_core::TaylorSeries<T, N, Workspace = ()> {
                model
            }
        }
        #allowed
        impl<T: #real, const N: usize> ::pendulum_core::Jacobian<T, N> for #name<T> {
            fn jacobian(#inherent) -> #matrix<T, N, N> {
                #zeros
            }
        }
        #allowed
        impl<const N: usize> ::pendulum_core::CastJacobian<N> for #name {
            fn with_jacobian<T: #real>(model: &#name<T>) -> &impl ::pendulum_core::Jacobian<T, N> {
                model
            }
        }
        #allowed
        impl<T: #real, const N: usize> ::pendulum_core::Canonical<T, N> for #name<T> {
            fn canonical(#system) -> (#vector, #vector) {
                (*x, *x)
            }
            fn canonical_jacobian(#inherent) -> (#matrix<T, N, N>, #matrix<T, N, N>) {
                (#zeros, #zeros)
            }
        }
        #controlled
        #allowed
        impl<T: #real, const N: usize> ::pendulum_core::Energy<T, N> for #name<T> {
            fn kinetic(#inherent) -> T {
                T::from_f64(0.0)
            }
            fn potential(#inherent) -> T {
                T::from_f64(0.0)
            }
        }
        #hybrid
    };
    in_own_module(&scene.head, &[name.clone(), parameters, inputs], &items)
}

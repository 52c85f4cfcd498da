//! Routines of a generated model.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::apart::{Apart, is_apart};
use super::block::{Piece, local, number};
use super::lanes::inlined_into_lanes;
use super::{Items, allowed, count};
use crate::program::{Argument, Block, Role, Routine, Shape, Variable};

impl Items<'_> {
    /// Trait implementations and inherent methods.
    pub(super) fn routines(&self) -> TokenStream {
        let parts = self.traits().into_iter().chain([self.inherent()]);
        parts.flatten().collect()
    }

    /// Implementations of the traits whose methods are routines.
    pub(super) fn traits(&self) -> [Option<TokenStream>; 5] {
        let [is_plain, is_controlled] = [self.acting().is_none(), !self.program.inputs.is_empty()];
        let motion = if is_plain { self.system() } else { self.plant() };
        let closed = if is_controlled {
            self.controlled()
        } else {
            (!is_plain).then(|| self.hybrid()).flatten()
        };
        let canonical = if is_plain {
            self.canonical()
        } else {
            self.hybrid_canonical()
        };
        let energy = self.of_trait("Energy", &[Role::Kinetic, Role::Potential]);
        [motion, closed, canonical, energy, self.adjoint()]
    }

    /// `impl Trait<T, N> for Model<T>`, or the inherent `impl Model<T>`.
    pub(super) fn implement(&self, of_trait: Option<TokenStream>, items: &TokenStream) -> TokenStream {
        let (name, allowed) = (&self.head.name, allowed());
        let of_trait = of_trait.map(|of_trait| quote!(#of_trait for));
        quote! {
            #allowed
            impl<T: ::pendulum_core::real::Real> #of_trait #name<T> { #items }
        }
    }

    /// Path of a trait over the length of the state.
    pub(super) fn named(&self, name: &str) -> TokenStream {
        let (name, length) = (format_ident!("{name}"), self.length());
        quote!(::pendulum_core::#name<T, #length>)
    }

    /// Implementation of a trait whose methods are all routines of the same names, if the scene has them.
    fn of_trait(&self, name: &str, methods: &[Role]) -> Option<TokenStream> {
        let routines: Option<Vec<&Routine>> = methods.iter().map(|&role| self.program.with_role(role)).collect();
        let inline = inlined_into_lanes();
        let methods = routines?.into_iter().map(|routine| {
            let function = self.function(&format_ident!("{}", routine.name), routine);
            quote!(#inline #function)
        });
        Some(self.implement(Some(self.named(name)), &methods.collect()))
    }

    /// Implementation of `Adjoint`, or of `ControlledAdjoint` for a model with inputs, where the engine can use it: if
    /// the motion has one mode, and no state is corrected to close loops.
    fn adjoint(&self) -> Option<TokenStream> {
        let has = |role| self.program.with_role(role).is_some();
        let is_smooth = self.program.constraints.is_empty() && !has(Role::LoopCorrections);
        if !(has(Role::Adjoint) && has(Role::Rhs) && is_smooth) {
            return None;
        }
        let vector = |length| self.shape(Shape::Vector(length));
        let [states, parameters, inputs] = [
            self.program.layout.len(),
            self.program.parameters.len(),
            self.program.inputs.len(),
        ];
        let (name, state, output) = (&self.head.name, vector(states), |list: &[usize]| {
            let vectors = list.iter().map(|&length| vector(length));
            quote!((#(#vectors),*))
        });
        // the routine leaves out what has no entries
        let of_parameters = (parameters > 0).then(|| quote!(by_parameters,));
        let none = (parameters == 0).then(|| {
            let none = vector(0);
            quote!(let by_parameters = <#none>::default();)
        });
        let [length, parameters_count, inputs_count] = [states, parameters, inputs].map(count);
        let (of_trait, function) = if inputs > 0 {
            let (inputs_name, output) = (self.inputs_name(), output(&[states, parameters, inputs]));
            (
                quote!(ControlledAdjoint<T, #length, #inputs_count, #parameters_count>),
                quote! {
                    fn controlled_adjoint(
                        &self, t: T, x: &#state, inputs: &#inputs_name<T>, weights: &#state,
                    ) -> #output {
                        let (by_state, #of_parameters by_inputs) = #name::adjoint(self, t, x, inputs, weights);
                        #none
                        (by_state, by_parameters, by_inputs)
                    }
                },
            )
        } else {
            let output = output(&[states, parameters]);
            let parts = match parameters {
                0 => quote!(by_state),
                _ => quote!((by_state, by_parameters)),
            };
            (
                quote!(Adjoint<T, #length, #parameters_count>),
                quote! {
                    fn adjoint(&self, t: T, x: &#state, weights: &#state) -> #output {
                        let #parts = #name::adjoint(self, t, x, weights);
                        #none
                        (by_state, by_parameters)
                    }
                },
            )
        };
        Some(self.implement(Some(quote!(::pendulum_core::#of_trait)), &quote!(#[inline] #function)))
    }

    pub(super) fn canonical(&self) -> Option<TokenStream> {
        self.of_trait("Canonical", &[Role::Canonical, Role::CanonicalJacobian])
    }

    pub(super) fn system(&self) -> Option<TokenStream> {
        let (inline, rhs) = (inlined_into_lanes(), self.program.with_role(Role::Rhs)?);
        let is_apart = is_apart(rhs).then(|| {
            quote! {
                #[inline(always)]
                fn is_apart(&self) -> bool {
                    true
                }
            }
        });
        let rhs = self.function(&format_ident!("rhs"), rhs);
        let labels = self.labels();
        let assembly = self.assembly();
        let system = self.implement(
            Some(self.named("System")),
            &quote!(#inline #rhs #is_apart #labels #assembly),
        );
        let jacobian = self
            .program
            .with_role(Role::Jacobian)
            .map(|routine| self.jacobian(routine));
        Some(quote!(#system #jacobian))
    }

    /// Implementation of `Jacobian`. A long Jacobian alone is another function, since a copy of it takes long, too.
    fn jacobian(&self, routine: &Routine) -> TokenStream {
        let (inline, arguments) = (inlined_into_lanes(), self.arguments(routine));
        let (matrix, output) = (self.shape(routine.shapes[1]), self.output(routine));
        let time_derivative = self.time_derivative("time_derivative", &arguments);
        let results = |values: &[Piece]| result(&routine.shapes, values);
        let (item, both, alone) = if is_apart(routine) {
            let Apart { item, value } = self.apart(routine, &output, None, results);
            let second = quote!(::pendulum_core::real::lanes::Second(#value));
            let [both, alone] = [value, second].map(|value| quote!(T::apart(#value, &mut (), self)));
            (Some(item), both, alone)
        } else {
            let both = self.code(&format_ident!("self"), routine, results);
            (None, both, quote!(self.rhs_and_jacobian(t, x).1))
        };
        let functions = quote! {
            #[inline]
            fn jacobian(#arguments) -> #matrix {
                #alone
            }
            #inline
            fn rhs_and_jacobian(#arguments) -> #output {
                #both
            }
            #inline
            #time_derivative
        };
        let jacobian = self.implement(Some(self.named("Jacobian")), &functions);
        quote!(#item #jacobian)
    }

    /// Methods of `System` and `Controlled` that name the components of the state, and of the outputs if there are any.
    pub(super) fn labels(&self) -> TokenStream {
        let name = &self.head.name;
        let vector = self.shape(Shape::Vector(self.program.layout.len()));
        let outputs = (!self.program.outputs.is_empty()).then(|| {
            quote! {
                #[inline]
                fn each_output(&self, t: T, x: &#vector, tell: &mut dyn FnMut(&str, T)) {
                    for (name, output) in <#name>::OUTPUTS.iter().zip(&self.outputs(t, x)) {
                        tell(name, *output);
                    }
                }
            }
        });
        quote! {
            #outputs
            #[inline]
            fn layout(&self) -> ::core::option::Option<::pendulum_core::StateLayout<'_>> {
                Some(<#name>::LAYOUT)
            }
        }
    }

    /// Time derivative of the right-hand side: zeros if it does not depend on time.
    pub(super) fn time_derivative(&self, name: &str, arguments: &TokenStream) -> TokenStream {
        let name = format_ident!("{name}");
        let state = Shape::Vector(self.program.layout.len());
        let vector = self.shape(state);
        let block = match self.program.with_role(Role::TimeDerivative) {
            Some(routine) => self.body(routine, &vector, |values| value(state, values)),
            None => {
                let zeros = value(state, &vec![number(0.0); state.len()]);
                quote!({ #zeros })
            }
        };
        quote! {
            fn #name(#arguments) -> #vector #block
        }
    }

    /// Implementation of `Controlled`, for a model with inputs.
    fn controlled(&self) -> Option<TokenStream> {
        let by_inputs = self.program.with_role(Role::InputJacobian)?;
        let (inline, length, inputs) = (inlined_into_lanes(), self.length(), count(self.program.inputs.len()));
        let name = self.inputs_name();
        let by_inputs = self.function(&format_ident!("input_jacobian"), by_inputs);
        let (labels, assembly) = (self.labels(), self.assembly());
        let functions = quote! {
            type Inputs = #name<T>;
            #inline
            #by_inputs
            #labels
            #assembly
        };
        Some(self.implement(
            Some(quote!(::pendulum_core::Controlled<T, #length, #inputs>)),
            &functions,
        ))
    }

    /// Routine as a function of a trait.
    pub(super) fn function(&self, name: &Ident, routine: &Routine) -> TokenStream {
        let arguments = self.arguments(routine);
        let output = self.output(routine);
        let block = self.body(routine, &output, |values| result(&routine.shapes, values));
        quote!(fn #name(#arguments) -> #output #block)
    }

    /// Return type of a routine.
    pub(super) fn output(&self, routine: &Routine) -> TokenStream {
        let shapes: Vec<TokenStream> = routine.shapes.iter().map(|&shape| self.shape(shape)).collect();
        match shapes.as_slice() {
            [one] => one.clone(),
            several => quote!((#(#several),*)),
        }
    }

    /// Body of a function with the [arguments](Self::arguments) of a routine.
    pub(super) fn body(
        &self,
        routine: &Routine,
        output: &TokenStream,
        result: impl FnOnce(&[Piece]) -> TokenStream,
    ) -> TokenStream {
        let statements = self.statements(routine, output, None, result);
        quote!({ #statements })
    }

    /// Statements of the body of a routine, after `conversions` of its arguments.
    pub(super) fn statements(
        &self,
        routine: &Routine,
        output: &TokenStream,
        conversions: Option<&TokenStream>,
        result: impl FnOnce(&[Piece]) -> TokenStream,
    ) -> TokenStream {
        if is_apart(routine) {
            let Apart { item, value } = self.apart(routine, output, conversions, result);
            quote!(#item T::apart(#value, &mut (), self))
        } else {
            let code = self.code(&format_ident!("self"), routine, result);
            quote!(#conversions #code)
        }
    }

    /// Statements that compute the results of a routine of `model`.
    pub(super) fn code(
        &self,
        model: &Ident,
        routine: &Routine,
        result: impl FnOnce(&[Piece]) -> TokenStream,
    ) -> TokenStream {
        let takes = |argument: Argument| routine.arguments.contains(&argument);
        let both = takes(Argument::Inputs) && takes(Argument::Forces);
        let given = both.then(|| quote!(let (u, forces) = (&given.inputs, &given.forces);));
        let statements = self.computed(model, &routine.block, result);
        quote!(#given #statements)
    }

    /// Type and name of the argument for inputs and constraint forces, if the model has any.
    pub(super) fn acting(&self) -> Option<(TokenStream, Ident)> {
        let inputs = self.inputs_name();
        let inputs = quote!(#inputs<T>);
        let (given, name) = match (self.program.inputs.is_empty(), self.program.constraints.is_empty()) {
            (true, true) => return None,
            (false, true) => (inputs, "u"),
            (true, false) => (quote!([T; ::pendulum_core::hybrid::MAX_CONSTRAINTS]), "forces"),
            (false, false) => (quote!(::pendulum_core::Acting<#inputs, T>), "given"),
        };
        Some((given, format_ident!("{name}")))
    }

    pub(super) fn arguments(&self, routine: &Routine) -> TokenStream {
        let (state, acting) = (
            self.shape(Shape::Vector(self.program.layout.len())),
            self.acting_on(routine).map(|(given, name)| quote!(, #name: &#given)),
        );
        quote!(&self, t: T, x: &#state #acting)
    }

    /// Name and components of an argument that is a vector.
    pub(super) fn vector(&self, argument: Argument) -> Option<(&'static str, Vec<Variable>)> {
        let (layout, inputs) = (&self.program.layout, self.program.inputs.len());
        let (name, length, variable): (_, _, fn(usize) -> Variable) = match argument {
            Argument::Inputs | Argument::Forces => return None,
            Argument::Accelerations => ("qdd", layout.dof(), Variable::Acceleration),
            Argument::Weights => ("weights", layout.len(), Variable::Weight),
            Argument::Direction => ("direction", layout.len() + inputs, Variable::Direction),
        };
        Some((name, (0..length).map(variable).collect()))
    }

    /// Type and name of the argument for inputs and constraint forces, if the routine takes any.
    pub(super) fn acting_on(&self, routine: &Routine) -> Option<(TokenStream, Ident)> {
        let takes = |argument: &Argument| routine.arguments.contains(argument);
        if takes(&Argument::Forces) {
            self.acting()
        } else if takes(&Argument::Inputs) {
            let inputs = self.inputs_name();
            Some((quote!(#inputs<T>), format_ident!("u")))
        } else {
            None
        }
    }

    /// Block that computes from the state `x`, the time `t`, the inputs `u`, the accelerations `qdd`, the `forces`
    /// along constraints and the constants of the model.
    pub(super) fn block(&self, block: &Block, result: impl FnOnce(&[Piece]) -> TokenStream) -> TokenStream {
        let statements = self.computed(&format_ident!("self"), block, result);
        quote!({ #statements })
    }

    fn computed(&self, model: &Ident, block: &Block, result: impl FnOnce(&[Piece]) -> TokenStream) -> TokenStream {
        let (reads, names) = (block.reads(), self.names());
        let pattern = |variables: &mut dyn Iterator<Item = Variable>| {
            let names = variables.map(|variable| match names.variable(variable) {
                name if reads.contains(&variable) => quote!(#name),
                _ => quote!(_),
            });
            let names: Vec<TokenStream> = names.collect();
            quote!([#(#names),*])
        };
        let state = pattern(&mut (0..self.program.layout.len()).map(Variable::State));
        let mut head = quote!(let #state = x.data.0[0];);
        for argument in [Argument::Accelerations, Argument::Weights, Argument::Direction] {
            let (name, variables) = self.vector(argument).expect("a vector");
            if variables.iter().any(|variable| reads.contains(variable)) {
                let (name, components) = (format_ident!("{name}"), pattern(&mut variables.into_iter()));
                head.extend(quote!(let #components = #name.data.0[0];));
            }
        }
        for n in 0..self.program.constraints.len() {
            if reads.contains(&Variable::Force(n)) {
                let (name, place) = (names.variable(Variable::Force(n)), count(n));
                head.extend(quote!(let #name = forces[#place];));
            }
        }
        for (n, input) in self.program.inputs.iter().enumerate() {
            if reads.contains(&Variable::Input(n)) {
                let (name, field) = (names.variable(Variable::Input(n)), super::field(&input.name));
                head.extend(quote!(let #name = u.#field;));
            }
        }
        head.extend(self.constants(model, &reads));
        let code = names.code(block, result);
        quote!(#head #code)
    }

    /// Statements that copy the constants of `model` read by a block.
    pub(super) fn constants(&self, model: &Ident, reads: &BTreeSet<Variable>) -> TokenStream {
        let read = reads.iter().filter_map(|variable| match variable {
            Variable::Constant(n) => Some((self.names().variable(*variable), count(*n))),
            _ => None,
        });
        read.map(|(name, index)| quote!(let #name = #model.constants[#index];))
            .collect()
    }

    /// Type of a result.
    pub(super) fn shape(&self, shape: Shape<usize>) -> TokenStream {
        match shape {
            Shape::Scalar => quote!(T),
            Shape::Vector(n) => {
                let n = count(n);
                quote!(::pendulum_core::nalgebra::SVector<T, #n>)
            }
            Shape::Matrix(n, m) => {
                let (n, m) = (count(n), count(m));
                quote!(::pendulum_core::nalgebra::SMatrix<T, #n, #m>)
            }
            Shape::Symmetric(n) => self.shape(Shape::Matrix(n, n)),
        }
    }
}

/// Results of a routine: a single one as it is, several as a tuple.
pub(super) fn result(shapes: &[Shape<usize>], mut values: &[Piece]) -> TokenStream {
    let results = shapes.iter().map(|&shape| {
        let (own, rest) = values.split_at(shape.len());
        values = rest;
        value(shape, own)
    });
    let results: Vec<TokenStream> = results.collect();
    match results.as_slice() {
        [one] => one.clone(),
        several => quote!((#(#several),*)),
    }
}

/// Value of a shape from its entries.
pub(super) fn value(shape: Shape<usize>, values: &[impl ToTokens]) -> TokenStream {
    match shape {
        Shape::Scalar => quote!(#(#values)*),
        Shape::Vector(_) => quote!(::pendulum_core::nalgebra::SVector::from([#(#values),*])),
        Shape::Matrix(rows, _) => {
            let columns = values.chunks(rows).map(|column| quote!([#(#column),*]));
            quote!(::pendulum_core::nalgebra::SMatrix::from([#(#columns),*]))
        }
        Shape::Symmetric(n) => {
            let names: Vec<Ident> = (0..values.len()).map(|n| local(&format!("a{n}"))).collect();
            let at = |i: usize, j: usize| {
                let (i, j) = (i.min(j), i.max(j));
                &names[i * n - i * (i + 1) / 2 + j]
            };
            let columns = (0..n).map(|j| {
                let column = (0..n).map(|i| at(i, j));
                quote!([#(#column),*])
            });
            let columns: Vec<TokenStream> = columns.collect();
            quote!(#(let #names = #values;)* ::pendulum_core::nalgebra::SMatrix::from([#(#columns),*]))
        }
    }
}

//! The functions of a generated model.

use std::collections::HashMap;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::body::{Body, local, spelled, unpack};
use super::lanes::inlined_into_lanes;
use super::{Items, allowed, number};
use crate::expr::{Expr, ExprId};
use crate::pipeline::Function;

/// What the functions have in common.
struct Signature {
    arguments: TokenStream,
    vector: TokenStream,
    matrix: TokenStream,
}

impl<'p> Items<'p> {
    /// The implementations of the traits, and the methods beside them.
    pub(super) fn functions(&self) -> TokenStream {
        let motion = if self.program.model.inputs.is_empty() {
            self.system()
        } else {
            self.controlled()
        };
        [motion, self.canonical(), self.energy(), self.inherent()]
            .into_iter()
            .flatten()
            .collect()
    }

    /// The arguments of every function, and the types of a vector and a matrix of the size of the state.
    fn signature(&self) -> Signature {
        let length = number(2 * self.dof());
        let vector = quote!(::pendulum_core::nalgebra::SVector<T, #length>);
        let matrix = quote!(::pendulum_core::nalgebra::SMatrix<T, #length, #length>);
        Signature {
            arguments: quote!(&self, t: T, x: &#vector),
            vector,
            matrix,
        }
    }

    /// `impl Trait<T, N> for Model<T>`, or the inherent `impl Model<T>`.
    fn implement(&self, of_trait: Option<TokenStream>, items: TokenStream) -> TokenStream {
        let (name, allowed, of_trait) = (
            &self.head.name,
            allowed(),
            of_trait.map(|of_trait| quote!(#of_trait for)),
        );
        quote! {
            #allowed
            impl<T: ::pendulum_core::real::Real> #of_trait #name<T> { #items }
        }
    }

    fn rhs_block(&self) -> Option<TokenStream> {
        let roots = &self.program.functions.get(&Function::Rhs)?.roots;
        Some(self.block(&self.with_rates(roots), vector))
    }

    /// Right-hand side and Jacobian together.
    fn jacobian_block(&self) -> Option<TokenStream> {
        let roots = &self.program.functions.get(&Function::Jacobian)?.roots;
        let dof = self.dof();
        let pair = |values: &[TokenStream]| {
            let (rhs, columns) = values.split_at(2 * dof);
            let (rhs, jacobian) = (vector(rhs), state_columns(dof, dof, columns));
            quote!((#rhs, #jacobian))
        };
        Some(self.block(&self.with_rates(roots), pair))
    }

    /// The derivative of the right-hand side by the time; zeros where that does not occur.
    fn time_derivative_block(&self) -> TokenStream {
        let zeros = vec![spelled(0.0); self.dof()];
        match self.program.functions.get(&Function::TimeDerivative) {
            Some(chosen) => self.block(&chosen.roots, |values| vector(&[&zeros, values].concat())),
            None => {
                let zeros = vector(&[&zeros[..], &zeros].concat());
                quote!({ #zeros })
            }
        }
    }

    /// The rates, which come first in every right-hand side, and behind them other roots.
    fn with_rates(&self, roots: &[Expr<'p>]) -> Vec<Expr<'p>> {
        let rates = self.program.model.coordinates.iter().map(|c| c.rate);
        rates.chain(roots.iter().copied()).collect()
    }

    fn system(&self) -> Option<TokenStream> {
        let (length, rhs) = (number(2 * self.dof()), self.rhs_block()?);
        let Signature {
            arguments,
            vector,
            matrix,
        } = self.signature();
        let of_trait = Some(quote!(::pendulum_core::System<T, #length>));
        let inline = inlined_into_lanes();
        let system = self.implement(of_trait, quote!(#inline fn rhs(#arguments) -> #vector #rhs));
        let jacobian = self.jacobian_block().map(|jacobian| {
            let time_derivative = self.time_derivative_block();
            let of_trait = Some(quote!(::pendulum_core::Jacobian<T, #length>));
            let functions = quote! {
                #[inline]
                fn jacobian(#arguments) -> #matrix {
                    self.rhs_and_jacobian(t, x).1
                }
                #[inline]
                fn rhs_and_jacobian(#arguments) -> (#vector, #matrix) #jacobian
                #[inline]
                fn time_derivative(#arguments) -> #vector
                where
                    T: ::pendulum_core::Float,
                #time_derivative
            };
            self.implement(of_trait, functions)
        });
        Some(quote!(#system #jacobian))
    }

    fn controlled(&self) -> Option<TokenStream> {
        let dof = self.dof();
        let (length, count) = (number(2 * dof), number(self.program.model.inputs.len()));
        let (rhs, jacobian) = (self.rhs_block()?, self.jacobian_block()?);
        let by_inputs = self.block(&self.program.functions.get(&Function::InputJacobian)?.roots, |values| {
            let zeros = vec![spelled(0.0); dof];
            let columns = values.chunks(dof).map(|column| quote!([#(#zeros,)* #(#column),*]));
            quote!(::pendulum_core::nalgebra::SMatrix::from([#(#columns),*]))
        });
        let Signature {
            arguments,
            vector,
            matrix,
        } = self.signature();
        let inputs = self.inputs_name();
        let arguments = quote!(#arguments, u: &#inputs<T>);
        let functions = quote! {
            type Inputs = #inputs<T>;
            #[inline]
            fn rhs_with(#arguments) -> #vector #rhs
            #[inline]
            fn jacobian_with(#arguments) -> #matrix {
                self.rhs_and_jacobian_with(t, x, u).1
            }
            #[inline]
            fn rhs_and_jacobian_with(#arguments) -> (#vector, #matrix) #jacobian
            #[inline]
            fn input_jacobian(#arguments) -> ::pendulum_core::nalgebra::SMatrix<T, #length, #count> #by_inputs
        };
        let controlled = self.implement(Some(quote!(::pendulum_core::Controlled<T, #length, #count>)), functions);
        let with_inputs = quote! {
            /// The model with a law for its inputs: a `System`.
            pub fn with_inputs<F>(&self, inputs: F) -> ::pendulum_core::WithInputs<'_, Self, F, #count>
            where
                F: Fn(T, &#vector) -> #inputs<T>,
            {
                ::pendulum_core::WithInputs::new(self, inputs)
            }
        };
        let inherent = self.implement(None, with_inputs);
        Some(quote!(#controlled #inherent))
    }

    fn canonical(&self) -> Option<TokenStream> {
        let (model, functions) = (&self.program.model, &self.program.functions);
        let dof = self.dof();
        let positions = model.coordinates.iter().map(|c| c.position);
        // coordinates and momenta, then the rates of both
        let roots = &functions.get(&Function::Canonical)?.roots;
        let (momenta, rates) = roots.split_at(dof);
        let roots: Vec<Expr<'_>> = positions
            .chain(momenta.iter().copied())
            .chain(self.with_rates(rates))
            .collect();
        let variables = self.block(&roots, |values| {
            let (variables, rates) = values.split_at(2 * dof);
            let (variables, rates) = (self::vector(variables), self::vector(rates));
            quote!((#variables, #rates))
        });
        let derivatives = self.block(&functions.get(&Function::CanonicalJacobian)?.roots, |values| {
            let (momenta, rates) = values.split_at(2 * dof * dof);
            let (momenta, rates) = (state_columns(dof, 0, momenta), state_columns(dof, dof, rates));
            quote!((#momenta, #rates))
        });
        let length = number(2 * dof);
        let Signature {
            arguments,
            vector,
            matrix,
        } = self.signature();
        let functions = quote! {
            #[inline]
            fn canonical(#arguments) -> (#vector, #vector) #variables
            #[inline]
            fn canonical_jacobian(#arguments) -> (#matrix, #matrix) #derivatives
        };
        Some(self.implement(Some(quote!(::pendulum_core::Canonical<T, #length>)), functions))
    }

    fn energy(&self) -> Option<TokenStream> {
        let all = &self.program.functions;
        let scalar = |function| Some(self.block(&all.get(&function)?.roots, |values| quote!(#(#values)*)));
        let (kinetic, potential) = (scalar(Function::Kinetic)?, scalar(Function::Potential)?);
        let (length, Signature { arguments, .. }) = (number(2 * self.dof()), self.signature());
        let functions = quote! {
            #[inline]
            fn kinetic(#arguments) -> T #kinetic
            #[inline]
            fn potential(#arguments) -> T #potential
        };
        Some(self.implement(Some(quote!(::pendulum_core::Energy<T, #length>)), functions))
    }

    /// The methods that belong to no trait.
    fn inherent(&self) -> Option<TokenStream> {
        let (dof, parameters) = (number(self.dof()), number(self.program.model.parameters.len()));
        let vector = quote!(::pendulum_core::nalgebra::SVector<T, #dof>);
        let matrix = |columns| quote!(::pendulum_core::nalgebra::SMatrix<T, #dof, #columns>);
        let accelerations = quote!(, qdd: &#vector);
        let inputs = self.inputs_name();
        let inputs = (!self.program.model.inputs.is_empty()).then(|| quote!(, u: &#inputs<T>));
        let columns = |values: &[TokenStream]| columns(self.dof(), values);
        let methods: [Method; 5] = [
            Method {
                function: Function::MassMatrix,
                doc: "The mass matrix.",
                more: None,
                output: matrix(dof.clone()),
                result: &|values| symmetric(self.dof(), values),
            },
            Method {
                function: Function::Bias,
                doc: "The bias: velocity terms and gravity, as generalised forces.",
                more: None,
                output: vector.clone(),
                result: &self::vector,
            },
            Method {
                function: Function::Momentum,
                doc: "The momenta of the coordinates: the mass matrix times their rates.",
                more: None,
                output: vector.clone(),
                result: &self::vector,
            },
            Method {
                function: Function::InverseDynamics,
                doc: "The generalised forces `A qdd + b - Q` that must act beside gravity and the forces of the joints for the accelerations `qdd`: \
                      zero along a free motion. Inputs count as zero: where each coordinate has one, these are their values.",
                more: Some(accelerations),
                output: vector.clone(),
                result: &self::vector,
            },
            Method {
                function: Function::ParameterJacobian,
                doc: "The derivatives of the accelerations by the parameters: one column for each, in the order of their declaration.",
                more: inputs,
                output: matrix(parameters),
                result: &columns,
            },
        ];
        let Signature { arguments, .. } = self.signature();
        let methods = methods.into_iter().filter_map(|method| {
            let chosen = self.program.functions.get(&method.function)?;
            let block = self.block(&chosen.roots, method.result);
            let Method { doc, more, output, .. } = method;
            let name = format_ident!("{}", method.function.name());
            Some(quote! {
                #[doc = #doc]
                #[inline]
                pub fn #name(#arguments #more) -> #output #block
            })
        });
        let methods: TokenStream = methods.collect();
        (!methods.is_empty()).then(|| self.implement(None, methods))
    }

    /// A block that computes roots from the state `x`, the time `t`, the inputs `u` and the constants of the model.
    pub(super) fn block(&self, roots: &[Expr<'_>], result: impl FnOnce(&[TokenStream]) -> TokenStream) -> TokenStream {
        let (mut known, mut head) = unpack(&self.program.model, roots);
        let (constants, read) = self.constants_read(roots);
        known.extend(constants);
        head.extend(read);
        let code = Body::code(self.program.model.graph, roots, &known, result);
        quote!({ #head #code })
    }

    /// The names of the constants of the model, and statements for those that some roots read.
    pub(super) fn constants_read(&self, roots: &[Expr<'_>]) -> (HashMap<ExprId, Ident>, TokenStream) {
        let (mut known, mut head) = (HashMap::new(), TokenStream::new());
        let used = self.program.model.graph.reachable(roots);
        for (n, constant) in self.program.constants.iter().enumerate() {
            let (name, index) = (local(format!("k{n}")), number(n));
            let read = used.binary_search(&constant.id()).is_ok();
            known.insert(constant.id(), name.clone());
            if read {
                head.extend(quote!(let #name = self.constants[#index];));
            }
        }
        (known, head)
    }
}

/// A method that belongs to no trait.
struct Method<'a> {
    function: Function,
    doc: &'static str,
    /// What it takes beside the time and the state.
    more: Option<TokenStream>,
    output: TokenStream,
    result: &'a dyn Fn(&[TokenStream]) -> TokenStream,
}

fn vector(values: &[TokenStream]) -> TokenStream {
    quote!(::pendulum_core::nalgebra::SVector::from([#(#values),*]))
}

/// A matrix from its columns of length `dof`.
fn columns(dof: usize, values: &[TokenStream]) -> TokenStream {
    let columns = values.chunks(dof).map(|column| quote!([#(#column),*]));
    quote!(::pendulum_core::nalgebra::SMatrix::from([#(#columns),*]))
}

/// The derivatives of a vector of the length of the state, column by column. Its upper half is that of the state from the component
/// `first` on: the coordinates, or their rates.
fn state_columns(dof: usize, first: usize, values: &[TokenStream]) -> TokenStream {
    let columns = values.chunks(dof).enumerate().map(|(k, column)| {
        let upper = (0..dof).map(|i| spelled(if k == i + first { 1.0 } else { 0.0 }));
        quote!([#(#upper,)* #(#column),*])
    });
    quote!(::pendulum_core::nalgebra::SMatrix::from([#(#columns),*]))
}

/// A symmetric matrix from its upper triangle, row by row.
fn symmetric(dof: usize, values: &[TokenStream]) -> TokenStream {
    let names: Vec<_> = (0..values.len()).map(|n| local(format!("a{n}"))).collect();
    let at = |i: usize, j: usize| {
        let (i, j) = (i.min(j), i.max(j));
        &names[i * dof - i * (i + 1) / 2 + j]
    };
    let columns = (0..dof).map(|j| {
        let column = (0..dof).map(|i| at(i, j));
        quote!([#(#column),*])
    });
    let columns: Vec<_> = columns.collect();
    quote!(#(let #names = #values;)* ::pendulum_core::nalgebra::SMatrix::from([#(#columns),*]))
}

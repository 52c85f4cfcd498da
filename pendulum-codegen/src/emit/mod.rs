//! The items of a generated model.

mod body;
mod equations;
mod stub;

use std::collections::HashMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

pub(crate) use equations::equations;
pub(crate) use stub::stub;

use crate::ast::Scene;
use crate::expr::{ExprId, Printer};
use crate::model::{ROUNDING, Requirement};
use crate::pass::Operations;
use crate::pipeline::{Function, Program};
use body::{Body, local, spelled, unpack};

/// Everything that a declaration stands for.
pub(crate) fn items(scene: &Scene, program: &Program) -> TokenStream {
    let items = Items { scene, program };
    let parts = [
        items.parameters(),
        items.inputs().unwrap_or_default(),
        items.model(),
        items.constructor(),
        items.facts(),
        items.functions(),
    ];
    parts.into_iter().collect()
}

/// The lints that say nothing about generated code.
pub(crate) fn allowed() -> TokenStream {
    quote!(#[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)])
}

struct Items<'p> {
    scene: &'p Scene,
    program: &'p Program,
}

impl Items<'_> {
    fn name(&self) -> &Ident {
        &self.scene.name
    }

    fn parameters_name(&self) -> Ident {
        format_ident!("{}Params", self.scene.name)
    }

    fn inputs_name(&self) -> Ident {
        format_ident!("{}Inputs", self.scene.name)
    }

    fn dof(&self) -> usize {
        self.program.model.dof()
    }

    fn parameters(&self) -> TokenStream {
        let (vis, name) = (&self.scene.vis, self.parameters_name());
        let parameters = &self.program.model.parameters;
        let doc = format!("Parameters of [`{}`].", self.name());
        let fields = parameters.iter().map(|p| {
            let (field, docs, unit) = (field(&p.name), &p.docs, unit_line(&p.unit.text));
            quote!(#(#[doc = #docs])* #[doc = #unit] pub #field: f64)
        });
        let defaults: Option<Vec<_>> = parameters
            .iter()
            .map(|p| p.default.map(|value| (field(&p.name), value)))
            .collect();
        let default = defaults.map(|defaults| {
            let values = defaults.into_iter().map(|(field, value)| quote!(#field: #value));
            let allowed = allowed();
            quote! {
                impl ::core::default::Default for #name {
                    #allowed
                    fn default() -> Self {
                        Self { #(#values),* }
                    }
                }
            }
        });
        let serde = cfg!(feature = "serde").then(|| {
            quote! {
                #[derive(::pendulum_core::serde::Serialize, ::pendulum_core::serde::Deserialize)]
                #[serde(crate = "::pendulum_core::serde")]
            }
        });
        quote! {
            #[doc = #doc]
            #serde
            #[derive(Clone, Copy, Debug, PartialEq)]
            #vis struct #name { #(#fields),* }
            #default
        }
    }

    fn inputs(&self) -> Option<TokenStream> {
        let inputs = &self.program.model.inputs;
        if inputs.is_empty() {
            return None;
        }
        let (vis, name) = (&self.scene.vis, self.inputs_name());
        let doc = format!("Inputs of [`{}`], given at each evaluation.", self.name());
        let fields = inputs.iter().map(|input| {
            let (field, docs, unit) = (field(&input.name), &input.docs, unit_line(&input.unit.text));
            quote!(#(#[doc = #docs])* #[doc = #unit] pub #field: T)
        });
        Some(quote! {
            #[doc = #doc]
            #[derive(Clone, Copy, Debug, Default, PartialEq)]
            #vis struct #name<T = f64> { #(#fields),* }
        })
    }

    fn model(&self) -> TokenStream {
        let (vis, name, parameters) = (&self.scene.vis, self.name(), self.parameters_name());
        let (docs, count) = (&self.scene.docs, number(self.program.constants.len()));
        let has_constants = !self.program.constants.is_empty();
        let equations = &self.program.equations;
        let mut text = format!("# Equations of motion\n\n```text\n{equations}```\n");
        if has_constants {
            text.push_str("\n# Constants, computed by `new`\n\n```text\n");
            for (n, constant) in self.constants_text().iter().enumerate() {
                text.push_str(&format!("k{n} = {constant}\n"));
            }
            text.push_str("```\n");
        }
        quote! {
            #(#[doc = #docs])*
            #[doc = ""]
            #[doc = #text]
            #[derive(Clone, Copy, Debug, PartialEq)]
            #vis struct #name<T = f64> {
                params: #parameters,
                constants: [T; #count],
            }
        }
    }

    fn constants_text(&self) -> Vec<String> {
        let printer = Printer::new(&self.program.model.graph);
        self.program.constants.iter().map(|&id| printer.print(id)).collect()
    }

    fn constructor(&self) -> TokenStream {
        let (name, parameters, model) = (self.name(), self.parameters_name(), &self.program.model);
        let fields: Vec<_> = model.parameters.iter().map(|p| field(&p.name)).collect();
        let texts: Vec<_> = model.parameters.iter().map(|p| &p.name).collect();
        let (count, constants) = (number(fields.len()), number(self.program.constants.len()));
        let mut checked = Vec::new();
        let mut tests = TokenStream::new();
        for rule in &model.rules {
            let (value, text, sentence) = (local(format!("r{}", checked.len())), &rule.name, &rule.text);
            checked.push(rule.value);
            let holds = match rule.requirement {
                Requirement::Positive => quote!(#value > 0.0),
                Requirement::NonNegative => quote!(#value >= 0.0),
                Requirement::NonNegativeWithin(scale) => {
                    let size = local(format!("r{}", checked.len()));
                    checked.push(scale);
                    quote!(#value >= -#ROUNDING * #size.abs())
                }
            };
            tests.extend(quote! {
                if !(#holds) {
                    return Err(::pendulum_core::ParameterError { name: #text, value: #value, rule: #sentence });
                }
            });
        }
        let values: Vec<_> = (0..checked.len()).map(|n| local(format!("r{n}"))).collect();
        let (rules, compute) = (
            self.of_parameters(&checked),
            self.of_parameters(&self.program.constants),
        );
        let (rule_count, constant_texts, allowed) = (number(checked.len()), self.constants_text(), allowed());
        quote! {
            #allowed
            impl #name {
                /// Builds the model: checks the parameters, and computes once whatever depends on them alone.
                ///
                /// # Errors
                ///
                /// The first parameter, or combination of parameters, that is not finite or that no rigid body can have.
                pub fn new(params: #parameters) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
                    #[inline]
                    fn rules<T: ::pendulum_core::real::Real>(given: [T; #count]) -> [T; #rule_count] #rules
                    #[inline]
                    fn constants<T: ::pendulum_core::real::Real>(given: [T; #count]) -> [T; #constants] #compute
                    let given: [f64; #count] = [#(params.#fields),*];
                    let names: [&'static str; #count] = [#(#texts),*];
                    for (name, value) in names.into_iter().zip(given) {
                        if !value.is_finite() {
                            return Err(::pendulum_core::ParameterError { name, value, rule: "a parameter must be finite" });
                        }
                    }
                    let [#(#values),*] = rules(given);
                    #tests
                    let constants = constants(given);
                    let names: [&'static str; #constants] = [#(#constant_texts),*];
                    for (name, value) in names.into_iter().zip(constants) {
                        if !value.is_finite() {
                            let rule = "this combination of parameters must be finite: perhaps a coordinate has no inertia";
                            return Err(::pendulum_core::ParameterError { name, value, rule });
                        }
                    }
                    Ok(Self { params, constants })
                }

                /// The same model in another number type, such as `f32`. Its constants are computed in double precision and
                /// then rounded.
                pub fn cast<T: ::pendulum_core::real::Real>(&self) -> #name<T> {
                    #name { params: self.params, constants: self.constants.map(T::from_f64) }
                }
            }

            #allowed
            impl<T: ::pendulum_core::real::Real> #name<T> {
                /// The parameters that the model was built from.
                pub fn params(&self) -> &#parameters {
                    &self.params
                }
            }
        }
    }

    /// A block that computes expressions of the parameters `given`.
    fn of_parameters(&self, roots: &[ExprId]) -> TokenStream {
        let model = &self.program.model;
        let names = model
            .parameters
            .iter()
            .map(|p| (p.symbol, local(format!("p_{}", p.name))));
        let known: HashMap<ExprId, Ident> = names.collect();
        let pattern = model.parameters.iter().map(|p| &known[&p.symbol]);
        let pattern = quote!(let [#(#pattern),*] = given;);
        let mut body = Body::new(&model.graph, roots, &known);
        let values: Vec<_> = roots.iter().map(|&root| body.value(root)).collect();
        let code = body.finish(&quote!([#(#values),*]));
        quote!({ #pattern #code })
    }

    /// Constants of the type that need no evaluation.
    fn facts(&self) -> TokenStream {
        let (name, dof, coordinates) = (self.name(), number(self.dof()), self.program.model.coordinate_names());
        let equations = &self.program.equations;
        let costs = self.program.functions.iter().map(|(function, chosen)| {
            let field = match function {
                Function::Rhs => quote!(rhs),
                Function::Jacobian => quote!(jacobian),
                Function::InputJacobian => quote!(input_jacobian),
                Function::Kinetic => quote!(kinetic),
                Function::Potential => quote!(potential),
                Function::MassMatrix => quote!(mass_matrix),
                Function::Bias => quote!(bias),
            };
            let Operations {
                additions,
                multiplications,
                divisions,
                sincos,
                functions,
            } = chosen.operations;
            let [additions, multiplications, divisions, sincos, functions] =
                [additions, multiplications, divisions, sincos, functions].map(number);
            quote! {
                #field: ::pendulum_core::Operations {
                    additions: #additions,
                    multiplications: #multiplications,
                    divisions: #divisions,
                    sincos: #sincos,
                    functions: #functions,
                }
            }
        });
        quote! {
            impl #name {
                /// The number of degrees of freedom; the state has twice as many components.
                pub const DOF: usize = #dof;
                /// The names of the coordinates, in the order in which they, and then their rates, stand in the state.
                pub const COORDINATES: [&'static str; #dof] = [#(#coordinates),*];
                /// Counted operations of each generated function.
                pub const COST: ::pendulum_core::Cost = ::pendulum_core::Cost { #(#costs,)* ..::pendulum_core::Cost::ZERO };
                /// The equations of motion as text.
                pub const EQUATIONS: &'static str = #equations;
            }
        }
    }

    fn functions(&self) -> TokenStream {
        let all = &self.program.functions;
        let (name, dof) = (self.name(), self.dof());
        let (length, size, allowed) = (number(2 * dof), number(dof), allowed());
        let real = quote!(::pendulum_core::real::Real);
        let vector = quote!(::pendulum_core::nalgebra::SVector<T, #length>);
        let matrix = quote!(::pendulum_core::nalgebra::SMatrix<T, #length, #length>);
        let mut items = TokenStream::new();
        let arguments = quote!(&self, t: T, x: &#vector);
        let rhs = all.get(&Function::Rhs).map(|chosen| {
            let rates = self.program.model.coordinates.iter().map(|c| c.rate);
            let roots: Vec<ExprId> = rates.chain(chosen.roots.iter().copied()).collect();
            self.block(
                &roots,
                |values| quote!(::pendulum_core::nalgebra::SVector::from([#(#values),*])),
            )
        });
        let jacobian = all
            .get(&Function::Jacobian)
            .map(|chosen| self.block(&chosen.roots, |values| state_columns(dof, values)));
        let inputs = number(self.program.model.inputs.len());
        if !self.program.model.inputs.is_empty() {
            if let (Some(rhs), Some(jacobian), Some(chosen)) = (&rhs, &jacobian, all.get(&Function::InputJacobian)) {
                let by_inputs = self.block(&chosen.roots, |values| {
                    let zeros = vec![spelled(0.0); dof];
                    let columns = values.chunks(dof).map(|column| quote!([#(#zeros,)* #(#column),*]));
                    quote!(::pendulum_core::nalgebra::SMatrix::from([#(#columns),*]))
                });
                let inputs_name = self.inputs_name();
                let with_inputs = quote!(#arguments, u: &#inputs_name<T>);
                items.extend(quote! {
                    #allowed
                    impl<T: #real> ::pendulum_core::Controlled<T, #length, #inputs> for #name<T> {
                        type Inputs = #inputs_name<T>;
                        #[inline]
                        fn rhs_with(#with_inputs) -> #vector #rhs
                        #[inline]
                        fn jacobian_with(#with_inputs) -> #matrix #jacobian
                        #[inline]
                        fn input_jacobian(#with_inputs) -> ::pendulum_core::nalgebra::SMatrix<T, #length, #inputs> #by_inputs
                    }
                    impl<T: #real> #name<T> {
                        /// The model with a law for its inputs: a `System`.
                        pub fn with_inputs<F>(&self, inputs: F) -> ::pendulum_core::WithInputs<'_, Self, F, #inputs>
                        where
                            F: Fn(T, &#vector) -> #inputs_name<T>,
                        {
                            ::pendulum_core::WithInputs::new(self, inputs)
                        }
                    }
                });
            }
        } else {
            if let Some(rhs) = rhs {
                items.extend(quote! {
                    #allowed
                    impl<T: #real> ::pendulum_core::System<T, #length> for #name<T> {
                        #[inline]
                        fn rhs(#arguments) -> #vector #rhs
                    }
                });
            }
            if let Some(jacobian) = jacobian {
                items.extend(quote! {
                    #allowed
                    impl<T: #real> ::pendulum_core::Jacobian<T, #length> for #name<T> {
                        #[inline]
                        fn jacobian(#arguments) -> #matrix #jacobian
                    }
                });
            }
        }
        if let (Some(kinetic), Some(potential)) = (all.get(&Function::Kinetic), all.get(&Function::Potential)) {
            let [kinetic, potential] =
                [kinetic, potential].map(|chosen| self.block(&chosen.roots, |values| quote!(#(#values)*)));
            items.extend(quote! {
                #allowed
                impl<T: #real> ::pendulum_core::Energy<T, #length> for #name<T> {
                    #[inline]
                    fn kinetic(#arguments) -> T #kinetic
                    #[inline]
                    fn potential(#arguments) -> T #potential
                }
            });
        }
        if let Some(chosen) = all.get(&Function::MassMatrix) {
            let block = self.block(&chosen.roots, |values| symmetric(dof, values));
            items.extend(quote! {
                #allowed
                impl<T: #real> #name<T> {
                    /// The mass matrix.
                    #[inline]
                    pub fn mass_matrix(#arguments) -> ::pendulum_core::nalgebra::SMatrix<T, #size, #size> #block
                }
            });
        }
        if let Some(chosen) = all.get(&Function::Bias) {
            let block = self.block(
                &chosen.roots,
                |values| quote!(::pendulum_core::nalgebra::SVector::from([#(#values),*])),
            );
            items.extend(quote! {
                #allowed
                impl<T: #real> #name<T> {
                    /// The bias: velocity terms and gravity, as generalised forces.
                    #[inline]
                    pub fn bias(#arguments) -> ::pendulum_core::nalgebra::SVector<T, #size> #block
                }
            });
        }
        items
    }

    /// A block that computes roots from the state `x`, the time `t`, the inputs `u` and the constants of the model.
    fn block(&self, roots: &[ExprId], result: impl FnOnce(&[TokenStream]) -> TokenStream) -> TokenStream {
        let graph = &self.program.model.graph;
        let (mut known, mut head) = unpack(&self.program.model, roots);
        let used = graph.reachable(roots);
        for (n, constant) in self.program.constants.iter().enumerate() {
            let (name, index) = (local(format!("k{n}")), number(n));
            let read = used.binary_search(constant).is_ok();
            known.insert(*constant, name.clone());
            if read {
                head.extend(quote!(let #name = self.constants[#index];));
            }
        }
        let mut body = Body::new(graph, roots, &known);
        let values: Vec<_> = roots.iter().map(|&root| body.value(root)).collect();
        let result = result(&values);
        let code = body.finish(&result);
        quote!({ #head #code })
    }
}

/// A parameter's or an input's field.
fn field(name: &str) -> Ident {
    format_ident!("{name}")
}

/// A count without a suffix.
pub(crate) fn number(count: usize) -> Literal {
    Literal::usize_unsuffixed(count)
}

fn unit_line(unit: &str) -> String {
    if unit == "1" {
        "A plain number.".to_owned()
    } else {
        format!("In {unit}.")
    }
}

/// The state Jacobian, column by column: its upper half is known.
fn state_columns(dof: usize, values: &[TokenStream]) -> TokenStream {
    let columns = values.chunks(dof).enumerate().map(|(k, column)| {
        let upper = (0..dof).map(|i| spelled(if k == i + dof { 1.0 } else { 0.0 }));
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

//! Constructor of a generated model: checks its parameters and computes its constants.

use proc_macro2::TokenStream;
use quote::quote;

use super::block::local;
use super::{Items, allowed, count, field};
use crate::program::{Block, Condition, FINITE_CONSTANT, FINITE_PARAMETER, ROUNDING, Variable};

impl Items<'_> {
    /// `new`, `cast`, `params` and `with_params`.
    pub(super) fn constructor(&self) -> TokenStream {
        let (name, parameters, program) = (&self.head.name, self.parameters_name(), self.program);
        let (given, constants) = (count(program.parameters.len()), count(program.constants_text.len()));
        let tests = self.tests();
        let values = (0..program.checked.results.len()).map(|n| local(&format!("r{n}")));
        let (rules, compute) = (
            self.of_parameters(&program.checked),
            self.of_parameters(&program.constants),
        );
        let (checked, constants_text, allowed) =
            (count(program.checked.results.len()), &program.constants_text, allowed());
        let of_any_type = self.with_parameters();
        quote! {
            /// Constants of the model, from its parameters.
            #allowed
            #[inline]
            fn constants<T: ::pendulum_core::real::Real>(given: [T; #given]) -> [T; #constants] #compute

            #allowed
            impl #name {
                /// Builds the model: checks the parameters, and computes all constants that depend on them alone.
                ///
                /// # Errors
                ///
                /// Returns the first parameter, or combination of parameters, that is not finite or is impossible for a
                /// rigid body.
                pub fn new(params: #parameters) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
                    #[inline]
                    fn rules<T: ::pendulum_core::real::Real>(given: [T; #given]) -> [T; #checked] #rules
                    let given = params.to_array();
                    for (name, value) in #parameters::NAMES.into_iter().zip(given) {
                        if !value.is_finite() {
                            return Err(::pendulum_core::ParameterError::new(name, value, #FINITE_PARAMETER, &[]));
                        }
                    }
                    let [#(#values),*] = rules(given);
                    #tests
                    let constants = constants(given);
                    let names: [&'static str; #constants] = [#(#constants_text),*];
                    for (name, value) in names.into_iter().zip(constants) {
                        if !value.is_finite() {
                            let given: [_; #given] = ::core::array::from_fn(|n| (#parameters::NAMES[n], given[n]));
                            return Err(::pendulum_core::ParameterError::new(name, value, #FINITE_CONSTANT, &given));
                        }
                    }
                    Ok(Self { params, constants })
                }

                /// Converts the model to another number type, such as `f32`. Its constants are computed in double
                /// precision and then rounded.
                pub fn cast<T: ::pendulum_core::real::Real>(&self) -> #name<T> {
                    #name { params: self.params, constants: self.constants.map(T::from_f64) }
                }
            }

            #of_any_type
        }
    }

    /// `params` and `with_params` of a model in any number type.
    fn with_parameters(&self) -> TokenStream {
        let (name, parameters) = (&self.head.name, self.parameters_name());
        let methods = quote! {
            /// Returns the parameters from which the model was built.
            pub fn params(&self) -> &#parameters {
                &self.params
            }

            /// Returns a model with other parameters, in the same number type, and recomputes its constants.
            ///
            /// # Errors
            ///
            /// Returns the errors of `new`.
            pub fn with_params(
                &self,
                params: #parameters,
            ) -> ::core::result::Result<Self, ::pendulum_core::ParameterError> {
                Ok(<#name>::new(params)?.cast())
            }
        };
        self.implement(None, &methods)
    }

    /// Statements with which `new` rejects parameters, from the checked values `r0`, `r1`, ..
    fn tests(&self) -> TokenStream {
        let tests = self.program.rules.iter().map(|rule| {
            let (value, text, sentence) = (local(&format!("r{}", rule.value)), &rule.name, &rule.text);
            let holds = match rule.condition {
                Condition::Positive => quote!(#value > 0.0),
                Condition::NonNegative => quote!(#value >= 0.0),
                Condition::NonNegativeWithin(scale) => {
                    let size = local(&format!("r{scale}"));
                    quote!(#value >= -#ROUNDING * #size.abs())
                }
            };
            let given = rule.parameters.iter().map(|&n| {
                let name = &self.program.parameters[n].name;
                let field = field(name);
                quote!((#name, params.#field))
            });
            quote! {
                if !(#holds) {
                    return Err(::pendulum_core::ParameterError::new(#text, #value, #sentence, &[#(#given),*]));
                }
            }
        });
        tests.collect()
    }

    /// Block that computes from the parameters `given`.
    fn of_parameters(&self, block: &Block) -> TokenStream {
        let names = self.names();
        let pattern = (0..self.program.parameters.len()).map(|n| names.variable(Variable::Parameter(n)));
        let pattern = quote!(let [#(#pattern),*] = given;);
        let code = names.code(block, |values| quote!([#(#values),*]));
        quote!({ #pattern #code })
    }
}

//! The items of a generated model.

mod body;
mod equations;
mod functions;
mod lanes;
mod schedule;
mod stub;
mod taylor;

use std::collections::HashMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

pub(crate) use equations::equations;
pub(crate) use stub::stub;

use crate::ast::Head;
use crate::expr::{Expr, ExprId, Printer};
use crate::form::Form;
use crate::model::{ROUNDING, Requirement};
use crate::pass::Operations;
use crate::pipeline::Program;
use body::{Body, local};

/// Everything that a declaration stands for.
pub(crate) fn items(head: &Head, program: &Program<'_>) -> TokenStream {
    let items = Items { head, program };
    let parts = [
        items.parameters(),
        items.inputs().unwrap_or_default(),
        items.model(),
        items.constructor(),
        items.facts(),
        items.functions(),
        items.taylor().unwrap_or_default(),
        items.over_numbers().unwrap_or_default(),
    ];
    parts.into_iter().collect()
}

/// The lints that say nothing about generated code.
pub(crate) fn allowed() -> TokenStream {
    quote!(#[allow(clippy::all, clippy::pedantic, non_snake_case, unused_variables)])
}

struct Items<'p> {
    head: &'p Head,
    program: &'p Program<'p>,
}

impl Items<'_> {
    fn name(&self) -> &Ident {
        &self.head.name
    }

    fn parameters_name(&self) -> Ident {
        format_ident!("{}Params", self.head.name)
    }

    fn inputs_name(&self) -> Ident {
        format_ident!("{}Inputs", self.head.name)
    }

    fn dof(&self) -> usize {
        self.program.model.dof()
    }

    fn parameters(&self) -> TokenStream {
        let (vis, name) = (&self.head.vis, self.parameters_name());
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
        let (vis, name) = (&self.head.vis, self.inputs_name());
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
        let (vis, name, parameters) = (&self.head.vis, self.name(), self.parameters_name());
        let (docs, count) = (&self.head.docs, number(self.program.constants.len()));
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
        let printer = Printer::new(self.program.model.graph);
        self.program.constants.iter().map(|x| printer.print(x.id())).collect()
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
                            let rule = "this combination of parameters must be finite: it overflows, a divisor is zero, or a coordinate has no inertia";
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
    fn of_parameters(&self, roots: &[Expr<'_>]) -> TokenStream {
        let model = &self.program.model;
        let names = model
            .parameters
            .iter()
            .map(|p| (p.symbol.id(), local(format!("p_{}", p.name))));
        let known: HashMap<ExprId, Ident> = names.collect();
        let pattern = model.parameters.iter().map(|p| &known[&p.symbol.id()]);
        let pattern = quote!(let [#(#pattern),*] = given;);
        let code = Body::code(model.graph, roots, &known, |values| quote!([#(#values),*]));
        quote!({ #pattern #code })
    }

    /// Constants of the type that need no evaluation.
    fn facts(&self) -> TokenStream {
        let (name, dof, coordinates) = (self.name(), number(self.dof()), self.program.model.coordinate_names());
        let equations = &self.program.equations;
        let costs = self.program.functions.iter().map(|(function, chosen)| {
            let others = chosen.others.iter().map(|(form, count)| (form.to_string(), *count));
            cost(function.name(), &chosen.form.to_string(), &chosen.operations, others)
        });
        let of_series = self.program.taylor.as_ref().map(|taylor| {
            let text = |form: &Form, slots: &usize| format!("{form}, {slots} products of series");
            let others = taylor
                .others
                .iter()
                .map(|(form, slots, count)| (text(form, slots), *count));
            let cost = cost("taylor", &text(&taylor.form, &taylor.slots), &taylor.operations, others);
            let slots = number(taylor.slots);
            quote!(#cost, taylor_products: #slots)
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

/// A field of the costs: the operations of a function in its form and in others.
fn cost(field: &str, form: &str, own: &Operations, others: impl Iterator<Item = (String, Operations)>) -> TokenStream {
    let (field, own) = (format_ident!("{field}"), operations(own));
    let others = others.map(|(form, count)| {
        let count = operations(&count);
        quote!((#form, #count))
    });
    quote! {
        #field: ::pendulum_core::FunctionCost { operations: #own, form: #form, others: &[#(#others),*] }
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
    let counts = [additions, multiplications, divisions, sincos, functions, chain].map(|&count| number(count));
    quote!(::pendulum_core::Operations::new(#(#counts),*))
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

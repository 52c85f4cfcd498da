//! Inherent functions of a model.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::lanes::inlined_into_lanes;
use super::routines::result;
use super::{Items, count};
use crate::program::{Role, Routine};

impl Items<'_> {
    /// Methods that belong to no trait.
    pub(super) fn inherent(&self) -> Option<TokenStream> {
        let routines = self
            .program
            .routines
            .iter()
            .filter(|routine| routine.role.is_function());
        let methods = routines.map(|routine| {
            let (doc, function) = (&routine.doc, self.inherent_function(routine));
            let inline = match routine.role {
                Role::Function | Role::LoopMargins | Role::TurnMargins => inlined_into_lanes(),
                _ => quote!(#[inline]),
            };
            quote!(#[doc = #doc] #inline pub #function)
        });
        let methods: TokenStream = methods.chain(self.assemble()).chain(self.events()).collect();
        (!methods.is_empty()).then(|| self.implement(None, &methods))
    }

    /// A method for each event, and one for all of them.
    fn events(&self) -> Option<TokenStream> {
        let (events, length, count) = (&self.program.events, self.length(), count(self.program.events.len()));
        if events.is_empty() {
            return None;
        }
        let plain = || events.iter().map(|event| event.name.trim_start_matches("r#"));
        let names: Vec<Ident> = plain().map(|event| format_ident!("{event}_event")).collect();
        let events = events.iter().map(|event| {
            let value = format_ident!("{}", event.name);
            let restart = event.is_kink.then(|| quote!(.restart()));
            quote!(::pendulum_core::Event::new(|t, x| self.#value(t, x)) #restart)
        });
        let docs = plain().map(|event| {
            format!("Event `{event}`: each zero of the function [`{event}`](Self::{event}), in both directions.")
        });
        Some(quote! {
            ::pendulum_core::with_std! {
                #(
                    #[doc = #docs]
                    pub fn #names(&self) -> ::pendulum_core::Event<'_, T, #length> {
                        #events
                    }
                )*

                /// Returns all events, in the order of `EVENTS`.
                pub fn events(&self) -> [::pendulum_core::Event<'_, T, #length>; #count] {
                    [#(self.#names()),*]
                }
            }
        })
    }

    /// Routine as an inherent function, whose state may be any type accepted as an initial condition.
    fn inherent_function(&self, routine: &Routine) -> TokenStream {
        let (name, output, more) = (
            format_ident!("{}", routine.name),
            self.output(routine),
            self.acting_on(routine).map(|(given, name)| quote!(, #name: &#given)),
        );
        let vector = |length| quote!(&(impl ::pendulum_core::IntoState<T, #length> + Copy));
        let converted = |name: &str| {
            let name = format_ident!("{name}");
            quote!(let #name = ::pendulum_core::IntoState::into_state(*#name);)
        };
        let (x, state) = (vector(self.length()), converted("x"));
        let vectors = routine.arguments.iter().filter_map(|&argument| self.vector(argument));
        let (arguments, conversions): (TokenStream, TokenStream) = vectors
            .map(|(name, variables)| {
                let (ident, vector) = (format_ident!("{name}"), vector(count(variables.len())));
                (quote!(, #ident: #vector), converted(name))
            })
            .unzip();
        let conversions = quote!(#state #conversions);
        let statements = self.statements(routine, &output, Some(&conversions), |values| {
            result(&routine.shapes, values)
        });
        quote! {
            fn #name(&self, t: T, x: #x #more #arguments) -> #output {
                #statements
            }
        }
    }
}

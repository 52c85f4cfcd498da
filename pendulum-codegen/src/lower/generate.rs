//! The words of `generate`.

use std::collections::BTreeSet;

use syn::Ident;

use super::Lower;
use crate::error::suggestion;
use crate::model::Output;

impl Lower<'_> {
    /// What to generate.
    pub(super) fn outputs(
        &mut self,
        generate: Option<&[Ident]>,
        has_parameters: bool,
        has_inputs: bool,
    ) -> BTreeSet<Output> {
        let Some(list) = generate else {
            return [Output::Rhs, Output::Jacobian, Output::Energy].into();
        };
        let mut outputs = BTreeSet::new();
        for ident in list {
            let name = ident.to_string();
            match Output::ALL.iter().find(|(known, _)| *known == name) {
                Some((_, output)) if !outputs.insert(*output) => {
                    self.errors.at(
                        ident.span(),
                        format_args!("`{name}` is listed twice"),
                        "keep one of the two",
                    );
                }
                Some((_, Output::ParameterJacobian)) if !has_parameters => {
                    self.errors.at(
                        ident.span(),
                        "there are no parameters to derive by",
                        "declare the quantities of interest in `params { .. }`; numbers are constants",
                    );
                }
                Some((_, Output::Canonical)) if has_inputs => {
                    self.errors.at(
                        ident.span(),
                        "the canonical equations of a motion under inputs are not known: their law is given after the code is written",
                        "leave out `canonical`, or write the law into a `torque` in place of the input",
                    );
                }
                Some((_, Output::Taylor)) if has_inputs => {
                    self.errors.at(
                        ident.span(),
                        "the Taylor series of a motion under inputs is not known: their law is given after the code is written",
                        "leave out `taylor`, or write the law into a `torque` in place of the input",
                    );
                }
                Some(_) => {}
                None => {
                    let help = suggestion(&name, Output::ALL.map(|(known, _)| known));
                    self.errors
                        .at(ident.span(), format_args!("`{name}` cannot be generated"), help);
                }
            }
        }
        outputs
    }
}

//! Constants for the indices of the coordinates in the state.

use super::Lower;
use crate::ast;
use crate::error::Code;
use crate::model::{FACTS, places};

impl Lower<'_> {
    /// Rejects coordinates whose constants have the name of another constant of the model.
    pub(super) fn check_places(&mut self, bodies: &[ast::Body]) {
        let mut taken: Vec<(String, String)> = FACTS
            .map(|fact| (fact.to_owned(), "another fact of the model".to_owned()))
            .into();
        for (ident, slot) in bodies.iter().flat_map(|body| body.fields.slots()) {
            let own = places(&slot);
            let clash = taken.iter().find(|(constant, _)| own.contains(constant));
            if let Some((constant, owner)) = clash.filter(|(_, owner)| *owner != format!("`{slot}`")) {
                let fact = format!(
                    "coordinate `{slot}` needs the constant `{constant}` for its place in the state, \
                     but {owner} has that name"
                );
                self.errors
                    .at(Code::NameTaken, ident.span(), fact, "rename the coordinate");
            }
            taken.extend(own.map(|constant| (constant, format!("`{slot}`"))));
        }
    }
}

//! Constants for the indices of the coordinates and first-order states in the state.

use super::Lower;
use crate::ast;
use crate::error::Code;
use crate::model::{FACTS, constant, places};

impl Lower<'_> {
    /// Rejects coordinates and states whose constants have the name of another constant of the model.
    pub(super) fn check_places(&mut self, items: &ast::Items) {
        let mut taken: Vec<(String, String)> = FACTS
            .map(|fact| (fact.to_owned(), "another constant of the model".to_owned()))
            .into();
        let coordinates = items.bodies.iter().flat_map(|body| body.fields.slots());
        let coordinates = coordinates.map(|(ident, slot)| ("coordinate", ident, places(&slot).to_vec(), slot));
        let states = items.states.iter().map(|state| (&state.name, state.name.to_string()));
        let states = states.map(|(ident, name)| ("state", ident, vec![constant(&name)], name));
        for (kind, ident, own, slot) in coordinates.chain(states) {
            let clash = taken.iter().find(|(constant, _)| own.contains(constant));
            if let Some((constant, owner)) = clash.filter(|(_, owner)| *owner != format!("`{slot}`")) {
                let fact = format!(
                    "{kind} `{slot}` needs the constant `{constant}` for its index in the state, but {owner} has that \
                     name"
                );
                self.errors
                    .at(Code::NameTaken, ident.span(), fact, format_args!("rename the {kind}"));
            }
            taken.extend(own.into_iter().map(|constant| (constant, format!("`{slot}`"))));
        }
    }
}

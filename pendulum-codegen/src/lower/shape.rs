//! Shapes, and mass properties of bodies, from a shape or their own.

use std::collections::{BTreeMap, BTreeSet};

use syn::Ident;

use super::Lower;
use super::mass::Mass;
use crate::ast;
use crate::error::{Code, Reported};

impl<'g> Lower<'g> {
    pub(super) fn shapes(&mut self, declared: &[ast::Shape]) -> BTreeMap<String, Result<Mass<'g>, Reported>> {
        let mut shapes = BTreeMap::new();
        for shape in declared {
            let mass = self.mass(&shape.name, &shape.properties, shape.unread);
            if shapes.insert(shape.name.to_string(), mass).is_some() {
                self.errors.at(
                    Code::NameTaken,
                    shape.name.span(),
                    format_args!("shape `{}` is declared twice", shape.name),
                    "rename one of the two",
                );
            }
        }
        shapes
    }

    /// Mass properties of a body, if it has any.
    pub(super) fn mass_of_body(
        &mut self,
        body: &ast::Body,
        shapes: &BTreeMap<String, Result<Mass<'g>, Reported>>,
    ) -> Result<Option<Mass<'g>>, Reported> {
        let own = &body.fields.properties;
        let has_own = own.mass.is_some() || own.com.is_some() || own.inertia.is_some() || own.solids.is_some();
        let Some(shape) = &body.shape else {
            return if has_own {
                self.mass(&body.name, own, body.unread).map(Some)
            } else {
                Ok(None)
            };
        };
        if has_own {
            return Err(self.errors.at(
                Code::MassProperties,
                shape.span(),
                format_args!("`{}` has a shape and mass properties of its own", body.name),
                "give either the shape, or mass, com and inertia, or solids",
            ));
        }
        match shapes.get(&shape.to_string()) {
            Some(mass) => mass.clone().map(Some),
            None => {
                let fact = format_args!("no shape named `{shape}`");
                Err(self
                    .errors
                    .unknown(Code::UnknownName, shape, fact, shapes.keys().map(String::as_str), &[]))
            }
        }
    }

    pub(super) fn report_unused_shapes(&mut self, items: &ast::Items) {
        let used: BTreeSet<String> = items
            .bodies
            .iter()
            .filter_map(|b| b.shape.as_ref())
            .map(Ident::to_string)
            .collect();
        for shape in items
            .shapes
            .iter()
            .filter(|shape| !used.contains(&shape.name.to_string()))
        {
            self.errors.at(
                Code::Unused,
                shape.name.span(),
                format_args!("shape `{}` is never used", shape.name),
                "remove it, or give it to a body: `body b on ground: shape { .. }`",
            );
        }
    }
}

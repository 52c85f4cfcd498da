//! Names and what they stand for.

use std::collections::BTreeMap;

use proc_macro2::Span;
use syn::Ident;

use crate::error::{Errors, suggestion};
use crate::expr::Expr;

/// The names of a scene. Everything that can stand in an expression shares one space of names.
#[derive(Debug, Default)]
pub(super) struct Names<'g>(BTreeMap<String, Name<'g>>);

#[derive(Debug)]
struct Name<'g> {
    kind: Kind,
    span: Span,
    value: Option<Expr<'g>>,
    rate: Option<Expr<'g>>,
    used: bool,
    order: usize,
}

/// What a name is the name of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Parameter,
    Input,
    Let,
    Coordinate,
}

impl Kind {
    /// With its article: `an input`.
    fn one(self) -> String {
        let article = if self == Self::Input { "an" } else { "a" };
        format!("{article} {self}")
    }
}

impl std::fmt::Display for Kind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Parameter => "parameter",
            Self::Input => "input",
            Self::Let => "`let`",
            Self::Coordinate => "coordinate",
        })
    }
}

/// Words of the language that no declared name may take.
const RESERVED: [&str; 6] = ["t", "pi", "q", "qd", "dot", "ground"];

impl<'g> Names<'g> {
    /// Declares a name. A second declaration is an error.
    pub(super) fn declare(&mut self, errors: &mut Errors, kind: Kind, ident: &Ident, value: Option<Expr<'g>>) {
        let (text, order) = (ident.to_string(), self.0.len());
        if RESERVED.contains(&text.as_str()) {
            errors.at(
                ident.span(),
                format_args!("`{text}` is a word of the language"),
                "choose another name; `q` and `qd` are a joint's own coordinate and rate, `t` is time",
            );
        } else if let Some(first) = self.0.get(&text) {
            errors.at(
                ident.span(),
                format_args!("the name `{text}` is declared twice, first as {}", first.kind.one()),
                "rename one of the two",
            );
        } else {
            self.0.insert(
                text,
                Name {
                    kind,
                    span: ident.span(),
                    value,
                    rate: None,
                    used: false,
                    order,
                },
            );
        }
    }

    /// Says what the rate of a declared name is.
    pub(super) fn set_rate(&mut self, name: &str, rate: Expr<'g>) {
        if let Some(known) = self.0.get_mut(name) {
            known.rate = Some(rate);
        }
    }

    /// Says what a declared name stands for.
    pub(super) fn set_value(&mut self, name: &str, value: Expr<'g>) {
        if let Some(known) = self.0.get_mut(name) {
            known.value = Some(value);
        }
    }

    /// What a name stands for.
    pub(super) fn value(&mut self, name: &str) -> Option<Expr<'g>> {
        let known = self.0.get_mut(name)?;
        known.used = true;
        known.value
    }

    /// Whether the name is declared, whatever it stands for.
    pub(super) fn is_declared(&self, name: &str) -> bool {
        self.0.contains_key(name)
    }

    /// The rate of a name.
    pub(super) fn rate(&mut self, name: &str) -> Option<Expr<'g>> {
        let known = self.0.get_mut(name)?;
        known.used = true;
        known.rate
    }

    /// The declared names whose values fit, in order, and some of the language.
    pub(super) fn known<'a>(&'a self, fits: impl Fn(Expr<'g>) -> bool, more: &[&'a str]) -> Vec<&'a str> {
        let fitting = self.0.iter().filter(|(_, name)| name.value.is_some_and(&fits));
        let mut names: Vec<_> = fitting.map(|(text, name)| (name.order, text.as_str())).collect();
        names.sort_unstable();
        names
            .into_iter()
            .map(|(_, text)| text)
            .chain(more.iter().copied())
            .collect()
    }

    /// A help line for a rate that is not there.
    pub(super) fn suggest_rate(&self, name: &str) -> String {
        suggestion(
            name,
            self.0
                .iter()
                .filter(|(_, name)| name.rate.is_some())
                .map(|(text, _)| text.as_str()),
        )
    }

    /// Reports every name that nothing uses.
    pub(super) fn report_unused(&self, errors: &mut Errors) {
        let mut unused: Vec<_> = self
            .0
            .iter()
            .filter(|(_, name)| !name.used && name.kind != Kind::Coordinate)
            .collect();
        unused.sort_by_key(|(_, name)| name.order);
        for (text, name) in unused {
            let help = "remove it, or use it: every declared number must matter to the motion";
            errors.at(name.span, format_args!("{} `{text}` is never used", name.kind), help);
        }
    }
}

//! Declared names and their values.

use std::collections::BTreeMap;

use proc_macro2::Span;
use syn::Ident;

use super::measure::{Measure, Quantity};
use crate::error::{Code, Errors};
use crate::expr::Expr;

/// Names of a scene. All names that can stand in an expression share one namespace.
#[derive(Debug, Default)]
pub(super) struct Names<'g>(BTreeMap<String, Name<'g>>);

#[derive(Debug)]
struct Name<'g> {
    kind: Kind,
    span: Span,
    measure: Measure,
    value: Option<Expr<'g>>,
    rate: Option<Expr<'g>>,
    used: bool,
    order: usize,
}

/// Kind of a declared name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Parameter,
    Input,
    State,
    Let,
    Coordinate,
    Orientation,
    Position,
    Point,
}

impl Kind {
    /// True for names of components of the state, which are part of the motion even if no expression uses them.
    fn is_of_state(self) -> bool {
        matches!(
            self,
            Self::State | Self::Coordinate | Self::Orientation | Self::Position
        )
    }

    /// Kind with its article: `an input`.
    pub(super) fn one(self) -> String {
        let article = if matches!(self, Self::Input | Self::Orientation) {
            "an"
        } else {
            "a"
        };
        format!("{article} {self}")
    }
}

impl std::fmt::Display for Kind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Parameter => "parameter",
            Self::Input => "input",
            Self::State => "state",
            Self::Let => "`let`",
            Self::Coordinate => "coordinate",
            Self::Orientation => "orientation",
            Self::Position => "position",
            Self::Point => "point",
        })
    }
}

/// Reserved words of the language, and their meanings.
const RESERVED: [(&str, &str); 7] = [
    ("t", "the time"),
    ("pi", "the number"),
    ("q", "a joint's own coordinate"),
    ("qd", "a joint's own rate"),
    ("dot", "the rate of a coordinate"),
    ("on", "it precedes the body of a point, or the point of a force"),
    ("ground", "the body that does not move"),
];

/// Meaning of a reserved word.
pub(crate) fn reserved(name: &str) -> Option<&'static str> {
    RESERVED
        .iter()
        .find(|(word, _)| *word == name)
        .map(|(_, meaning)| *meaning)
}

impl<'g> Names<'g> {
    /// Declares a name, or reports that it is declared twice or reserved.
    pub(super) fn declare(
        &mut self,
        errors: &mut Errors,
        kind: Kind,
        ident: &Ident,
        (measure, value): (Measure, Option<Expr<'g>>),
    ) {
        let (text, span, order) = (ident.to_string(), ident.span(), self.0.len());
        if let Some(meaning) = reserved(&text) {
            let fact = format_args!("`{text}` is a reserved word: {meaning}");
            errors.at(Code::NameTaken, span, fact, "choose another name");
        } else if let Some(first) = self.0.get(&text) {
            let fact = format_args!("the name `{text}` is declared twice, first as {}", first.kind.one());
            errors.at(Code::NameTaken, span, fact, "rename one of the two");
        } else {
            let name = Name {
                kind,
                span,
                measure,
                value,
                rate: None,
                used: false,
                order,
            };
            self.0.insert(text, name);
        }
    }

    /// Sets the rate of a declared name.
    pub(super) fn set_rate(&mut self, name: &str, rate: Expr<'g>) {
        if let Some(known) = self.0.get_mut(name) {
            known.rate = Some(rate);
        }
    }

    /// Sets the value of a declared name.
    pub(super) fn set_value(&mut self, name: &str, value: Expr<'g>) {
        if let Some(known) = self.0.get_mut(name) {
            known.value = Some(value);
        }
    }

    /// Sets the measure of a declared name.
    pub(super) fn set_measure(&mut self, name: &str, measure: Measure) {
        if let Some(known) = self.0.get_mut(name) {
            known.measure = measure;
        }
    }

    /// Value of a name, which is marked as used.
    pub(super) fn value(&mut self, name: &str) -> Option<Quantity<'g>> {
        let known = self.0.get_mut(name)?;
        known.used = true;
        let measure = known.measure;
        known.value.map(|value| Quantity { value, measure })
    }

    /// Marks a name as used.
    pub(super) fn mark_used(&mut self, name: &str) {
        if let Some(known) = self.0.get_mut(name) {
            known.used = true;
        }
    }

    /// Measure of a declared name.
    pub(super) fn measure(&self, name: &str) -> Option<Measure> {
        self.0.get(name).map(|known| known.measure)
    }

    /// Kind of a declared name.
    pub(super) fn kind(&self, name: &str) -> Option<Kind> {
        self.0.get(name).map(|known| known.kind)
    }

    /// Rate of a name, which is marked as used.
    pub(super) fn rate(&mut self, name: &str) -> Option<Quantity<'g>> {
        let known = self.0.get_mut(name)?;
        known.used = true;
        let measure = known.measure.rate();
        known.rate.map(|value| Quantity { value, measure })
    }

    /// Declared names whose values satisfy a predicate, in order of declaration, followed by `more`.
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

    /// Names that have rates, in order of declaration.
    pub(super) fn with_rates(&self) -> Vec<&str> {
        let with_rates = self.0.iter().filter(|(_, name)| name.rate.is_some());
        let mut names: Vec<_> = with_rates.map(|(text, name)| (name.order, text.as_str())).collect();
        names.sort_unstable();
        names.into_iter().map(|(_, text)| text).collect()
    }

    /// Coordinate whose rate a name such as `theta_dot` probably means.
    pub(super) fn rate_meant(&self, text: &str) -> Option<&str> {
        let forms = |name: &str| {
            [
                format!("{name}_dot"),
                format!("{name}dot"),
                format!("d{name}"),
                format!("{name}_d"),
            ]
        };
        let mut names = self.with_rates().into_iter();
        names.find(|name| forms(name).iter().any(|form| form == text))
    }

    /// Reports every unused name.
    pub(super) fn report_unused(&self, errors: &mut Errors) {
        let mut unused: Vec<_> = self
            .0
            .iter()
            .filter(|(_, name)| !name.used && !name.kind.is_of_state())
            .collect();
        unused.sort_by_key(|(_, name)| name.order);
        for (text, name) in unused {
            let help = match name.kind {
                Kind::Point => "remove it, or use it in a force, an expression or an output",
                _ => "remove it, or use it: every declared number must affect the motion",
            };
            let what = match name.kind {
                Kind::Let => format!("`let {text}`"),
                kind => format!("{kind} `{text}`"),
            };
            errors.at(Code::Unused, name.span, format_args!("{what} is never used"), help);
        }
    }
}

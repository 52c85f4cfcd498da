//! Attributes of a URDF file.

use roxmltree::Node;

use super::number::{ZERO, is_in_range, is_number, number};
use super::read::{EXPAND, ONE, Reader};
use crate::error::Code;

impl Reader {
    pub(super) fn text(&mut self, node: Node<'_, '_>, attribute: &str, owner: &str) -> Option<String> {
        let text = node.attribute(attribute).map(str::trim).filter(|text| !text.is_empty());
        if text.is_none() {
            self.go_to(node);
            self.wrong(Code::FileNumber, format!("{owner} has no `{attribute}`"), "add it");
        }
        text.map(str::to_owned)
    }

    /// Returns the number of an attribute, or the default if it is missing.
    pub(super) fn number(&mut self, node: Node<'_, '_>, attribute: &str, owner: &str, default: Option<&str>) -> String {
        self.go_to(node);
        match node.attribute(attribute).or(default) {
            Some(text) => self.parsed(text, attribute, owner, number),
            None => {
                let element = node.tag_name().name();
                self.wrong(
                    Code::FileNumber,
                    format!("`{element}` of {owner} has no `{attribute}`"),
                    "add it",
                );
                ONE.to_owned()
            }
        }
    }

    /// Returns a limit, which may be infinite.
    pub(super) fn largest(&mut self, node: Node<'_, '_>, attribute: &str, owner: &str) -> f64 {
        self.go_to(node);
        let text = node.attribute(attribute).unwrap_or_default().trim();
        if let Some(number) = text.parse().ok().filter(|number: &f64| *number >= 0.0) {
            return number;
        }
        self.wrong(
            Code::FileNumber,
            format!("`{attribute}` of {owner} is `{text}`"),
            "write a number that is not negative, or leave it out",
        );
        f64::INFINITY
    }

    pub(super) fn parsed(
        &mut self,
        text: &str,
        attribute: &str,
        owner: &str,
        read: fn(&str) -> Option<String>,
    ) -> String {
        let (what, help) = match read(text.trim()) {
            Some(read) if read == ZERO || is_in_range(text) => return read,
            _ if is_number(text) => ("out of range", "write a number between 1e-300 and 1e300, or 0"),
            _ if is_unexpanded(text) => ("an expression of xacro", EXPAND),
            _ => ("not a number", "write a decimal number such as 0.25 or 1e-3"),
        };
        self.wrong(
            Code::FileNumber,
            format!("`{attribute}` of {owner} is `{text}`, which is {what}"),
            help,
        );
        // not zero, which might cause further errors
        ONE.to_owned()
    }

    pub(super) fn triple(
        &mut self,
        node: Node<'_, '_>,
        attribute: &str,
        owner: &str,
        read: fn(&str) -> Option<String>,
    ) -> Option<[String; 3]> {
        self.go_to(node);
        let text = node.attribute(attribute).unwrap_or_default();
        let parts: Vec<&str> = text.split_whitespace().collect();
        let Ok(parts) = <[&str; 3]>::try_from(parts) else {
            let element = node.tag_name().name();
            let fact = format!("`{attribute}` in `{element}` of {owner} is `{text}`, not three numbers");
            let help = match is_unexpanded(text) {
                true => EXPAND,
                false => "write three numbers separated by spaces",
            };
            self.wrong(Code::FileNumber, fact, help);
            return None;
        };
        Some(parts.map(|part| self.parsed(part, attribute, owner, read)))
    }
}

/// True if a text contains an expression of xacro.
fn is_unexpanded(text: &str) -> bool {
    text.contains("${")
}

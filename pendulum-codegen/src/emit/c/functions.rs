//! Functions that generated code calls: sines without the platform, and others of it.

use super::block::Calls;

/// Heads and code of the called functions.
pub(super) fn functions(calls: &Calls) -> impl Iterator<Item = (&'static str, &'static str)> {
    sections().filter(|(head, _)| calls.contains(name_of(head)))
}

/// True if generated code may call a function of this name.
pub(super) fn is_function(name: &str) -> bool {
    sections().any(|(head, _)| name_of(head) == name)
}

fn sections() -> impl Iterator<Item = (&'static str, &'static str)> {
    let sections = include_str!("templates/functions.c").split("//! ");
    sections.filter_map(|section| section.split_once('\n'))
}

/// Name of a function: its head, without the default of the platform.
fn name_of(head: &str) -> &str {
    head.split(':').next().unwrap_or(head)
}

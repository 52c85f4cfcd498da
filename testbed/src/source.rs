//! Source text of the declarations, for tests of the generator as a library.

pub const SCENES: &str = include_str!("scenes.rs");
pub const MECHANISMS: &str = include_str!("mechanisms.rs");
pub const ROBOTS: &str = include_str!("robots.rs");

/// Returns the declaration of the model `name`: the contents of its `mechanism! { .. }`.
///
/// # Panics
/// If no such model is declared without indentation in the source.
pub fn declaration<'s>(source: &'s str, name: &str) -> &'s str {
    let head = format!(" {name} {{");
    declarations(source)
        .find(|text| text.contains(&head))
        .unwrap_or_else(|| panic!("no declaration of {name}"))
}

/// Returns the contents of each unindented `mechanism! { .. }` of a source.
pub fn declarations(source: &str) -> impl Iterator<Item = &str> {
    source
        .split("mechanism! {\n")
        .skip(1)
        .filter_map(|text| text.split("\n}\n").next())
}

//! The declarations as text, for the generator as a library.

pub const SCENES: &str = include_str!("scenes.rs");
pub const MECHANISMS: &str = include_str!("mechanisms.rs");
pub const ROBOTS: &str = include_str!("robots.rs");

/// What `mechanism! { .. }` holds for the model of that name.
///
/// # Panics
/// If no such model is declared at the margin of the source.
pub fn declaration<'s>(source: &'s str, name: &str) -> &'s str {
    let head = format!(" {name} {{");
    let inside = source
        .split("mechanism! {\n")
        .filter_map(|text| text.split("\n}\n").next());
    let mut found = inside.filter(|text| text.contains(&head));
    found.next().unwrap_or_else(|| panic!("no declaration of {name}"))
}

//! Models at run time against compiled ones, and what they refuse.

/// Declares a mechanism twice: as a type, and as text.
macro_rules! twice {
    ($($declaration:tt)*) => {
        mechanism! { $($declaration)* }

        pub(super) const TEXT: &str = stringify!($($declaration)*);
    };
}

#[path = "it/analyses.rs"]
mod analyses;
#[path = "it/compiled.rs"]
mod compiled;
#[path = "it/corpus.rs"]
mod corpus;
#[path = "it/declared.rs"]
mod declared;
#[path = "it/inputs.rs"]
mod inputs;
#[path = "it/refused.rs"]
mod refused;
#[path = "it/robots.rs"]
mod robots;
#[path = "it/simplest.rs"]
mod simplest;

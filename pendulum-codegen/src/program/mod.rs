//! What a printer needs to know of a generated model, in no language.

mod equations;

pub(crate) use equations::equations;
pub use equations::{Equations, Listing, Quantity, Row};

//! What a printer needs to know of a model, in no language.

mod layout;

pub use layout::{Slot, SlotKind, StateLayout};

//! Printers of a [`Program`](crate::program::Program), one for each language.

pub(crate) mod c;
pub(crate) mod fmi;
pub(crate) mod rust;
pub(crate) mod tape;

/// Number of Newton corrections of the dependent coordinates of closed loops after a step.
const CORRECTIONS: usize = 3;

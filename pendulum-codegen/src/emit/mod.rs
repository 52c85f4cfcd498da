//! Printers of a [`Program`](crate::program::Program), one for each language.

pub(crate) mod c;
pub(crate) mod rust;

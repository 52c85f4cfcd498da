//! Printers of a [`Program`](crate::program::Program), one for each language.

pub(crate) mod rust;

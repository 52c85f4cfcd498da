//! Printers of a [`Program`](crate::program::Program), one for each language.

pub(crate) mod c;
mod equations;
pub(crate) mod rust;

pub(crate) use equations::equations;

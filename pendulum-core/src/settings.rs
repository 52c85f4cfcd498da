//! Settings of plain values, such as methods.

/// Implements methods that set the field of their name: to the argument, or to a value made of it.
macro_rules! settings {
    ($($(#[$doc:meta])* $name:ident: $type:ty $(=> $value:expr)?;)*) => { $(
        $(#[$doc])*
        #[must_use]
        pub const fn $name(mut self, $name: $type) -> Self {
            self.$name = $crate::settings::settings!(@ $name $($value)?);
            self
        }
    )* };
    (@ $argument:ident) => { $argument };
    (@ $argument:ident $value:expr) => { $value };
}
pub(crate) use settings;

//! Messages of errors as tables.

/// Implements `Display` by a table. A row has a pattern of `self` and its message, which may contain the names that the
/// pattern binds, and further names with their values.
macro_rules! messages {
    ([$($generics:tt)*] $error:ty; $(
        $pattern:pat $(if $condition:expr)? => $message:literal $(, $name:ident = $value:expr)*;
    )*) => {
        impl<$($generics)*> core::fmt::Display for $error {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                match self {
                    $($pattern $(if $condition)? => write!(f, $message $(, $name = $value)*),)*
                }
            }
        }
    };
}

/// Implements `Debug` as `Display`.
macro_rules! debug_as_display {
    ($([$($generics:tt)*] $error:ty;)*) => { $(
        impl<$($generics)*> core::fmt::Debug for $error {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                core::fmt::Display::fmt(self, f)
            }
        }
    )* };
}

pub(crate) use {debug_as_display, messages};

//! Positions in lists, each of a type of its own.

/// Declares types of positions in lists: with one of them a list of anything is indexed.
macro_rules! index_types {
    ($($(#[$doc:meta])* $vis:vis $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        $vis struct $name(usize);

        impl $name {
            /// The position `index`.
            $vis fn new(index: usize) -> Self {
                Self(index)
            }

            /// The positions in a list of some length.
            $vis fn all(length: usize) -> impl DoubleEndedIterator<Item = Self> + ExactSizeIterator {
                (0..length).map(Self)
            }
        }

        impl From<$name> for usize {
            fn from(at: $name) -> usize {
                at.0
            }
        }

        impl<T> std::ops::Index<$name> for [T] {
            type Output = T;
            fn index(&self, at: $name) -> &T {
                &self[at.0]
            }
        }

        impl<T> std::ops::IndexMut<$name> for [T] {
            fn index_mut(&mut self, at: $name) -> &mut T {
                &mut self[at.0]
            }
        }

        impl<T> std::ops::Index<$name> for Vec<T> {
            type Output = T;
            fn index(&self, at: $name) -> &T {
                &self[at.0]
            }
        }

        impl<T> std::ops::IndexMut<$name> for Vec<T> {
            fn index_mut(&mut self, at: $name) -> &mut T {
                &mut self[at.0]
            }
        }
    )*};
}

pub(crate) use index_types;

index_types! {
    /// A body of a model.
    pub BodyId;
    /// A coordinate of a model.
    pub CoordinateId;
}

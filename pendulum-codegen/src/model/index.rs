//! Typed indices into lists.

/// Declares index types, each of which indexes lists of any element type.
macro_rules! index_types {
    ($($(#[$doc:meta])* $vis:vis $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        $vis struct $name(usize);

        impl $name {
            /// Creates the index of position `index`.
            $vis fn new(index: usize) -> Self {
                Self(index)
            }

            /// Iterates over the indices of a list.
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
    /// Index of a body in a model.
    pub BodyId;
    /// Index of a coordinate in a model.
    pub CoordinateId;
}

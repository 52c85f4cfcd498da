//! Names in errors.

use core::fmt;
use core::ops::Deref;

/// Maximum number of bytes of a stored name.
const MOST: usize = 39;
/// End of a truncated name.
const ELLIPSIS: &str = "…";

/// The name of a part of a model, in an error that outlives the model: at most 39 bytes. Longer names are truncated,
/// and end in `…`.
///
/// ```
/// use pendulum_core::Name;
///
/// let name = Name::from("floor");
/// assert!(name == "floor" && name.len() == 5 && name.to_string() == "floor");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Name {
    bytes: [u8; MOST],
    length: u8,
}

impl From<&str> for Name {
    fn from(name: &str) -> Self {
        let (kept, end) = if name.len() <= MOST {
            (name, "")
        } else {
            (&name[..name.floor_char_boundary(MOST - ELLIPSIS.len())], ELLIPSIS)
        };
        let (mut bytes, length) = ([0; MOST], kept.len() + end.len());
        bytes[..kept.len()].copy_from_slice(kept.as_bytes());
        bytes[kept.len()..length].copy_from_slice(end.as_bytes());
        Self {
            bytes,
            length: length as u8,
        }
    }
}

impl Deref for Name {
    type Target = str;

    fn deref(&self) -> &str {
        core::str::from_utf8(&self.bytes[..usize::from(self.length)]).unwrap_or_default()
    }
}

impl PartialEq<&str> for Name {
    fn eq(&self, other: &&str) -> bool {
        **self == **other
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&**self, f)
    }
}

impl fmt::Debug for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&**self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::{MOST, Name};

    #[test]
    fn names_are_kept_as_far_as_they_fit() {
        let whole = "x".repeat(MOST);
        assert_eq!(Name::from(whole.as_str()), whole.as_str());
        let cut = Name::from("x".repeat(MOST + 1).as_str());
        assert_eq!(cut, format!("{}…", "x".repeat(MOST - 3)).as_str());
        // not within a character
        let cut = Name::from("ä".repeat(MOST).as_str());
        assert_eq!(cut, format!("{}…", "ä".repeat(18)).as_str());
        assert_eq!(Name::from(""), "");
    }
}

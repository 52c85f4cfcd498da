//! Charts that several studies draw.

pub mod panels;

//! Binding strength of operations in written formulas.

/// The outermost operation of a piece of text, from the loosest to the tightest. A piece is put into brackets where its
/// place requires a tighter one.
///
/// In the language of declarations a minus binds as loosely as a sum, so `-a*b` is [`Precedence::Sum`]; in Rust and C
/// it is [`Precedence::Unary`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Precedence {
    /// `a + b`, `a - b`
    Sum,
    /// `a*b`, `a/b`
    Product,
    /// `-a` in Rust and C
    Unary,
    /// `a^b`
    Power,
    /// A name, a number, a call, or anything in brackets.
    Atom,
}

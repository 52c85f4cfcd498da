//! How tightly a printed expression holds together.

/// From the loosest to the tightest. Text that is looser than its place asks for stands in brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Precedence {
    /// A sum, or a number with a sign.
    Sum,
    /// A product or a quotient.
    Product,
    /// An opposite, in languages where that binds tighter than a product.
    Unary,
    /// A power.
    Power,
    /// A name, a number, a call.
    Atom,
}

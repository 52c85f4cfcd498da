//! Indices of joints.

use crate::expr::Expr;
use crate::model::index_types;

index_types! {
    /// Index of a joint: of a body, or of a link.
    pub(super) JointId;
}

/// An entry of a matrix over the joints: row, column and value.
pub(super) type Entry<'g> = (JointId, JointId, Expr<'g>);

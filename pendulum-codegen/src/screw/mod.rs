//! Screws over symbolic expressions: vectors and rotations, twists and wrenches, spatial inertia, transforms.
//!
//! Right-handed frames. A twist is `(angular; linear)` with the linear part the velocity of the point at the origin of the
//! frame it is written in; a wrench is `(moment; force)` about that origin. Structural zeros vanish in the constructors
//! of the graph, so a planar scene written in these terms comes out planar.

mod inertia;
mod moments;
mod transform;
mod twist;
mod vector;

pub use inertia::SpatialInertia;
pub use moments::{MassMoments, Turn};
pub use transform::Transform;
pub(crate) use transform::{identity, rotation};
pub use twist::{Twist, Wrench, bracket};
pub use vector::{Mat3, Symmetric3, Vec3, add, cross, dot, mat_mul, mat_vec, scale, sub, sum, transpose};

//! Screws over symbolic expressions: vectors and rotations, twists and wrenches, spatial inertia, transforms.
//!
//! Right-handed frames. A twist is `(angular; linear)` with the linear part the velocity of the point at the origin of the
//! frame it is written in; a wrench is `(moment; force)` about that origin. Structural zeros vanish in the constructors
//! of the graph, so a planar scene written in these terms comes out planar.

mod inertia;
mod matrix;
mod moments;
mod symmetric;
mod transform;
mod turn;
mod twist;
mod vector;
mod wrench;

pub use inertia::SpatialInertia;
pub use matrix::Mat3;
pub use moments::MassMoments;
pub use symmetric::Symmetric3;
pub use transform::Transform;
pub use turn::Turn;
pub use twist::Twist;
pub use vector::Vec3;
pub use wrench::Wrench;

//! Screws over symbolic expressions: vectors and rotations, twists and wrenches, spatial inertia, transforms.
//!
//! Frames are right-handed. A twist is `(angular; linear)`, where the linear part is the velocity of the point at the
//! origin of the frame it is written in; a wrench is `(moment; force)` about that origin. The graph drops structural
//! zeros when it builds expressions, so a planar scene yields planar equations.

mod inertia;
mod matrix;
mod moments;
mod plane;
mod symmetric;
mod transform;
mod turn;
mod twist;
mod vector;
mod wrench;

pub(crate) use inertia::SpatialInertia;
pub(crate) use matrix::Mat3;
pub(crate) use moments::MassMoments;
pub(crate) use plane::{Scalar, Vec2};
pub(crate) use symmetric::Symmetric3;
pub(crate) use transform::Transform;
pub(crate) use turn::Turn;
pub(crate) use twist::Twist;
pub(crate) use vector::Vec3;
pub(crate) use wrench::Wrench;

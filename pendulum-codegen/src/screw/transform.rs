//! Rigid displacements.

use std::ops::Mul;

use super::{Mat3, SpatialInertia, Symmetric3, Twist, Vec3};
use crate::expr::Graph;

/// Pose `a_from_b` of a frame `b` in a frame `a`: `point_in_a = rotation * point_in_b + translation`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Transform<'g> {
    /// Axes of `b` in `a`, as columns.
    pub rotation: Mat3<'g>,
    /// Origin of `b` in `a`.
    pub translation: Vec3<'g>,
}

impl<'g> Transform<'g> {
    /// Identity.
    pub(crate) fn identity(g: &'g Graph) -> Self {
        Self {
            rotation: Mat3::identity(g),
            translation: Vec3::zero(g),
        }
    }

    /// `b_from_a`
    #[must_use]
    pub(crate) fn inverse(&self) -> Self {
        let rotation = self.rotation.transpose();
        Self {
            rotation,
            translation: -(rotation * self.translation),
        }
    }

    /// Maps a point from `b` to `a`.
    pub(crate) fn point(&self, point: Vec3<'g>) -> Vec3<'g> {
        self.rotation * point + self.translation
    }

    /// Maps a twist from `b` to `a` (the adjoint).
    pub(crate) fn twist(&self, twist: &Twist<'g>) -> Twist<'g> {
        let angular = self.rotation * twist.angular;
        Twist {
            angular,
            linear: self.rotation * twist.linear + self.translation.cross(angular),
        }
    }

    /// Maps a twist from `a` to `b` (the inverse adjoint).
    pub(crate) fn twist_back(&self, twist: &Twist<'g>) -> Twist<'g> {
        let back = self.rotation.transpose();
        let linear = twist.linear - self.translation.cross(twist.angular);
        Twist {
            angular: back * twist.angular,
            linear: back * linear,
        }
    }

    /// Maps a spatial inertia from `b` to `a`.
    pub(crate) fn inertia(&self, inertia: &SpatialInertia<'g>) -> SpatialInertia<'g> {
        let p = self.translation;
        let turned = inertia.about_origin.rotated(self.rotation);
        let h = self.rotation * inertia.moment;
        let offset = inertia.mass * p;
        // parallel axes: m [p][p]^T + [p][h]^T + [h][p]^T
        let own = Symmetric3::of_point(inertia.mass, p);
        let twice = 2 * p.dot(h);
        let mixed = Symmetric3::from_fn(|i, j| {
            let outer = p[i] * h[j] + p[j] * h[i];
            if i == j { twice - outer } else { -outer }
        });
        SpatialInertia {
            about_origin: turned + own + mixed,
            moment: h + offset,
            mass: inertia.mass,
        }
    }
}

/// `a_from_c = a_from_b * b_from_c`
impl Mul for Transform<'_> {
    type Output = Self;
    fn mul(self, b_from_c: Self) -> Self {
        Self {
            rotation: self.rotation * b_from_c.rotation,
            translation: self.point(b_from_c.translation),
        }
    }
}

//! Rigid displacements.

use crate::expr::{ExprId, Graph, Unary};

use super::{Mat3, SpatialInertia, Symmetric3, Twist, Vec3, add, cross, dot, mat_mul, mat_vec, scale, sub, transpose};

/// Where a frame `b` sits in a frame `a`, so that `point_in_a = rotation * point_in_b + translation`: `a_from_b`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transform {
    /// The axes of `b` in `a`, as columns.
    pub rotation: Mat3,
    /// The origin of `b` in `a`.
    pub translation: Vec3,
}

impl Transform {
    /// No displacement.
    pub fn identity(g: &Graph) -> Self {
        Self {
            rotation: identity(g),
            translation: [g.zero(); 3],
        }
    }

    /// `a_from_c = a_from_b * b_from_c`.
    pub fn then(&self, g: &Graph, b_from_c: &Self) -> Self {
        Self {
            rotation: mat_mul(g, self.rotation, b_from_c.rotation),
            translation: self.point(g, b_from_c.translation),
        }
    }

    /// A point of `b`, in `a`.
    pub fn point(&self, g: &Graph, point: Vec3) -> Vec3 {
        let turned = mat_vec(g, self.rotation, point);
        add(g, turned, self.translation)
    }

    /// A twist written in `b`, in `a` (the adjoint).
    pub fn twist(&self, g: &Graph, twist: &Twist) -> Twist {
        let angular = mat_vec(g, self.rotation, twist.angular);
        let linear = mat_vec(g, self.rotation, twist.linear);
        let moment = cross(g, self.translation, angular);
        Twist {
            angular,
            linear: add(g, linear, moment),
        }
    }

    /// A twist written in `a`, in `b` (the inverse adjoint).
    pub fn twist_back(&self, g: &Graph, twist: &Twist) -> Twist {
        let back = transpose(self.rotation);
        let moment = cross(g, self.translation, twist.angular);
        let linear = sub(g, twist.linear, moment);
        Twist {
            angular: mat_vec(g, back, twist.angular),
            linear: mat_vec(g, back, linear),
        }
    }

    /// A vector without a place, such as gravity, written in `a`, in `b`.
    pub fn vector_back(&self, g: &Graph, vector: Vec3) -> Vec3 {
        mat_vec(g, transpose(self.rotation), vector)
    }

    /// A spatial inertia written in `b`, in `a`.
    pub fn inertia(&self, g: &Graph, inertia: &SpatialInertia) -> SpatialInertia {
        let p = self.translation;
        let turned = inertia.about_origin.rotated(g, self.rotation);
        let moment = mat_vec(g, self.rotation, inertia.moment);
        let offset = scale(g, inertia.mass, p);
        // parallel axes: m [p][p]^T + [p][h]^T + [h][p]^T
        let own = Symmetric3::of_point(g, inertia.mass, p);
        let both = dot(g, p, moment);
        let both = g.add(both, both);
        let mixed = Symmetric3::PLACES.map(|(i, j)| {
            let (u, v) = (g.mul(p[i], moment[j]), g.mul(p[j], moment[i]));
            let cross = g.add(u, v);
            if i == j { g.sub(both, cross) } else { g.neg(cross) }
        });
        let about_origin = turned.plus(g, own).plus(g, Symmetric3(mixed));
        SpatialInertia {
            mass: inertia.mass,
            moment: add(g, moment, offset),
            about_origin,
        }
    }
}

/// The unit matrix.
pub(crate) fn identity(g: &Graph) -> Mat3 {
    let (zero, one) = (g.zero(), g.one());
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
}

/// The rotation by `angle` about a unit vector (Rodrigues).
pub(crate) fn rotation(g: &Graph, axis: Vec3, angle: ExprId) -> Mat3 {
    let (sine, cosine) = (g.unary(Unary::Sin, angle), g.unary(Unary::Cos, angle));
    let one = g.one();
    let versine = g.sub(one, cosine);
    let identity = identity(g);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let outer = g.mul(axis[i], axis[j]);
            // on the diagonal of a coordinate axis this is 1 without further ado
            let symmetric = if outer == one {
                one
            } else {
                let (a, b) = (g.mul(outer, versine), g.mul(identity[i][j], cosine));
                g.add(a, b)
            };
            let k = (6 - i - j) % 3;
            if i == j {
                return symmetric;
            }
            let turned = g.mul(sine, axis[k]);
            if (i + 1) % 3 == j {
                g.sub(symmetric, turned)
            } else {
                g.add(symmetric, turned)
            }
        })
    })
}

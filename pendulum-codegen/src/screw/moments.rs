//! Inertia as moments of mass.

use crate::expr::{ExprId, Graph, ratio};

use super::{Mat3, SpatialInertia, Symmetric3, Vec3, add, mat_vec, scale};

/// Mass, first moment `integral r dm` and second moments `integral r r^T dm` about the origin of a frame.
///
/// The second moments hold what the rotational inertia `J = tr(S) 1 - S` holds, in a form that a displacement and the inertial
/// moment of a motion treat more simply.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MassMoments {
    /// Mass.
    pub mass: ExprId,
    /// First moment.
    pub first: Vec3,
    /// Second moments.
    pub second: Symmetric3,
}

impl MassMoments {
    /// The moments of a spatial inertia: `S = tr(J)/2 - J`.
    pub fn new(g: &Graph, inertia: &SpatialInertia) -> Self {
        let [xx, yy, zz, xy, xz, yz] = inertia.about_origin.0;
        let half = g.number(ratio(1, 2));
        let diagonal = |g: &Graph, p: ExprId, q: ExprId, own: ExprId| {
            let others = g.add(p, q);
            let twice = g.sub(others, own);
            g.mul(half, twice)
        };
        let diagonals = [
            diagonal(g, yy, zz, xx),
            diagonal(g, xx, zz, yy),
            diagonal(g, xx, yy, zz),
        ];
        let [xx, yy, zz] = diagonals;
        let second = Symmetric3([xx, yy, zz, g.neg(xy), g.neg(xz), g.neg(yz)]);
        Self {
            mass: inertia.mass,
            first: inertia.moment,
            second,
        }
    }

    /// The rotational inertia about the origin: `J = tr(S) 1 - S`.
    pub fn rotational(&self, g: &Graph) -> Symmetric3 {
        let Symmetric3([xx, yy, zz, xy, xz, yz]) = self.second;
        let diagonal = [g.add(yy, zz), g.add(xx, zz), g.add(xx, yy)];
        let [xy, xz, yz] = [xy, xz, yz].map(|x| g.neg(x));
        Symmetric3([diagonal[0], diagonal[1], diagonal[2], xy, xz, yz])
    }

    /// The sum of two.
    pub fn plus(&self, g: &Graph, other: &Self) -> Self {
        Self {
            mass: g.add(self.mass, other.mass),
            first: add(g, self.first, other.first),
            second: self.second.plus(g, other.second),
        }
    }

    /// The same mass, seen from a frame in which its own frame is turned by `rotation`.
    pub fn rotated(&self, g: &Graph, rotation: Mat3) -> Self {
        Self {
            mass: self.mass,
            first: mat_vec(g, rotation, self.first),
            second: self.second.rotated(g, rotation),
        }
    }

    /// The same mass, seen from a frame in which its own frame sits at `p`: `S + p h^T + h p^T + m p p^T`.
    pub fn moved(&self, g: &Graph, p: Vec3) -> Self {
        let h = self.first;
        let carried = scale(g, self.mass, p);
        let first = add(g, h, carried);
        // (h + m p) p^T + p h^T
        let shift = Symmetric3::PLACES.map(|(i, j)| {
            let (left, right) = (g.mul(first[i], p[j]), g.mul(p[i], h[j]));
            g.add(left, right)
        });
        Self {
            mass: self.mass,
            first,
            second: self.second.plus(g, Symmetric3(shift)),
        }
    }
}

/// A rotation about z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Turn {
    /// Sine of the angle.
    pub sine: ExprId,
    /// Cosine of the angle.
    pub cosine: ExprId,
}

impl Turn {
    /// A vector of the turned frame, in the frame that it is turned in.
    pub fn forward(self, g: &Graph, [x, y, z]: Vec3) -> Vec3 {
        let (cx, sy, sx, cy) = (
            g.mul(self.cosine, x),
            g.mul(self.sine, y),
            g.mul(self.sine, x),
            g.mul(self.cosine, y),
        );
        [g.sub(cx, sy), g.add(sx, cy), z]
    }

    /// A symmetric tensor of the turned frame, in the frame that it is turned in.
    pub fn forward_tensor(self, g: &Graph, tensor: Symmetric3) -> Symmetric3 {
        let Symmetric3([xx, yy, zz, xy, xz, yz]) = tensor;
        let [xz, yz, _] = self.forward(g, [xz, yz, zz]);
        // with d = xx - yy: xx' = yy + c (c d - 2 s xy), yy' = xx - c (..), xy' = xy + s (..)
        let difference = g.sub(xx, yy);
        let twice = g.add(xy, xy);
        let (p, q) = (g.mul(self.cosine, difference), g.mul(self.sine, twice));
        let m = g.sub(p, q);
        let (cm, sm) = (g.mul(self.cosine, m), g.mul(self.sine, m));
        Symmetric3([g.add(yy, cm), g.sub(xx, cm), zz, g.add(xy, sm), xz, yz])
    }

    /// The inverse of [`Turn::forward`].
    pub fn back(self, g: &Graph, v: Vec3) -> Vec3 {
        Self {
            sine: g.neg(self.sine),
            cosine: self.cosine,
        }
        .forward(g, v)
    }
}

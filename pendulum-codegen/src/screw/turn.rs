//! Rotations about z.

use std::ops::Mul;

use super::{Symmetric3, Vec3};
use crate::expr::Expr;

/// A rotation about z, which maps vectors of the rotated frame to the frame it is rotated in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Turn<'g> {
    /// Sine of the angle.
    pub sine: Expr<'g>,
    /// Cosine of the angle.
    pub cosine: Expr<'g>,
}

impl<'g> Turn<'g> {
    /// Rotation by an angle.
    pub(crate) fn by(angle: Expr<'g>) -> Self {
        Self {
            sine: angle.sin(),
            cosine: angle.cos(),
        }
    }

    /// Inverse rotation.
    #[must_use]
    pub(crate) fn inverse(self) -> Self {
        Self {
            sine: -self.sine,
            cosine: self.cosine,
        }
    }

    /// Maps a symmetric tensor of the rotated frame to the frame it is rotated in.
    pub(crate) fn tensor(self, Symmetric3([xx, yy, zz, xy, xz, yz]): Symmetric3<'g>) -> Symmetric3<'g> {
        let Self { sine: s, cosine: c } = self;
        let Vec3([xz, yz, _]) = self * Vec3([xz, yz, zz]);
        // xx' = yy + c m, yy' = xx - c m, xy' = xy + s m
        let m = c * (xx - yy) - s * (2 * xy);
        let (cm, sm) = (c * m, s * m);
        Symmetric3([yy + cm, xx - cm, zz, xy + sm, xz, yz])
    }
}

impl<'g> Mul<Vec3<'g>> for Turn<'g> {
    type Output = Vec3<'g>;
    fn mul(self, Vec3([x, y, z]): Vec3<'g>) -> Vec3<'g> {
        let Self { sine: s, cosine: c } = self;
        Vec3([c * x - s * y, s * x + c * y, z])
    }
}

//! Positions of a state, and the rates that move them.

use core::ops::Range;

use nalgebra::SVector;

use super::MAX_CONSTRAINTS;
use crate::real::Real;
use crate::system::Plant;

/// Places of the positions and of the rates in a state.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Kinematics<'a> {
    /// Number of position components; the rates follow them.
    positions: usize,
    /// Number of rates.
    dof: usize,
    /// See [`Plant::orientations`].
    orientations: &'a [[usize; 2]],
}

impl<'a> Kinematics<'a> {
    #[inline(always)]
    pub(crate) fn of<T, S, const N: usize>(system: &'a S) -> Self
    where
        T: Real,
        S: Plant<T, N, Given = [T; MAX_CONSTRAINTS]> + ?Sized,
    {
        let (dof, orientations) = (system.dof(), system.orientations());
        Self {
            positions: dof + orientations.len(),
            dof,
            orientations,
        }
    }

    /// Components of the rates.
    #[inline(always)]
    pub(crate) fn rates(self) -> Range<usize> {
        self.positions..self.positions + self.dof
    }

    /// Components of the positions.
    #[inline(always)]
    pub(super) fn positions(self) -> Range<usize> {
        0..self.positions
    }

    /// Component of the coordinate whose rate is the component `rate`. It is not part of an angular velocity.
    #[inline(always)]
    pub(super) fn position(self, rate: usize) -> usize {
        let mut position = rate - self.positions;
        for &[_, first] in self.orientations {
            // a quaternion has one component more than its angular velocity
            position += usize::from(first < rate);
        }
        position
    }

    /// True for the position of a coordinate, which is not part of a quaternion.
    #[cfg(feature = "std")]
    pub(crate) fn is_coordinate(self, component: usize) -> bool {
        component < self.positions && !self.orientations().flatten().any(|places| places.contains(&component))
    }

    /// Components of the quaternion and of the angular velocity of each orientation.
    pub(super) fn orientations(self) -> impl Iterator<Item = [Range<usize>; 2]> + use<'a> {
        let orientations = self.orientations.iter();
        orientations.map(|&[quaternion, turn]| [quaternion..quaternion + 4, turn..turn + 3])
    }

    /// Moves the positions by a small displacement, a change `by(k)` along each rate `k`.
    #[inline(always)]
    pub(super) fn displace<T: Real, const N: usize>(self, x: &mut SVector<T, N>, by: impl Fn(usize) -> T) {
        let Range { start: mut from, end } = self.rates();
        let mut back = self.positions;
        for &[quaternion, first] in self.orientations {
            for k in from..first {
                x[k - back] += by(k);
            }
            turn(x, quaternion, [0, 1, 2].map(|n| by(first + n)));
            (from, back) = (first + 3, back - 1);
        }
        for k in from..end {
            x[k - back] += by(k);
        }
    }
}

/// Turns a quaternion about the axes of its body, to `q (1, v / 2) / |(1, v / 2)|` for a small rotation vector `v`. It
/// remains exactly as it is without a turn.
fn turn<T: Real, const N: usize>(x: &mut SVector<T, N>, at: usize, by: [T; 3]) {
    let [a, b, c] = by.map(|angle| T::from_f64(0.5) * angle);
    let [w, i, j, k] = [0, 1, 2, 3].map(|n| x[at + n]);
    let norm = (T::from_f64(1.0) + (a * a + b * b + c * c)).sqrt();
    x[at] = (w - (i * a + j * b + k * c)) / norm;
    x[at + 1] = (i + w * a + (j * c - k * b)) / norm;
    x[at + 2] = (j + w * b + (k * a - i * c)) / norm;
    x[at + 3] = (k + w * c + (i * b - j * a)) / norm;
}

#[cfg(test)]
mod tests {
    use nalgebra::{Quaternion, SVector, UnitQuaternion, Vector3};

    use super::Kinematics;

    const SCENE: Kinematics<'_> = Kinematics {
        positions: 10,
        dof: 8,
        orientations: &[[1, 11], [6, 15]],
    };

    #[test]
    fn coordinates_between_orientations_have_their_places() {
        assert_eq!([10, 14].map(|rate| SCENE.position(rate)), [0, 5]);
        assert_eq!((SCENE.rates(), SCENE.positions()), (10..18, 0..10));
        assert!((0..18).filter(|&component| SCENE.is_coordinate(component)).eq([0, 5]));
    }

    #[test]
    fn displacements_turn_quaternions_about_the_axes_of_their_body() {
        let before = UnitQuaternion::from_euler_angles(0.3, -0.7, 1.1);
        let mut x = SVector::<f64, 18>::zeros();
        for at in [1, 6] {
            let q: &Quaternion<f64> = &before;
            [q.w, q.i, q.j, q.k]
                .into_iter()
                .enumerate()
                .for_each(|(n, component)| x[at + n] = component);
        }
        let turn = Vector3::new(2e-4, -3e-4, 1e-4);
        let mut moved = x;
        SCENE.displace(&mut moved, |rate| match rate {
            10 => 0.25,
            11..14 => turn[rate - 11],
            14 => -0.5,
            _ => 0.0,
        });
        assert_eq!((moved[0], moved[5]), (0.25, -0.5));
        // the second orientation stays, bit by bit
        assert_eq!(moved.rows(6, 12), x.rows(6, 12));
        let after = before * UnitQuaternion::from_scaled_axis(turn);
        let expected = [after.w, after.i, after.j, after.k];
        for (n, component) in expected.into_iter().enumerate() {
            assert!((moved[1 + n] - component).abs() < 1e-11, "{n}");
        }
        assert!((moved.rows(1, 4).norm() - 1.0).abs() < 1e-15);
    }
}

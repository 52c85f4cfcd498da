//! The compound double pendulum with friction, coded by hand: Williams (2023), Eq. 22, corrected, and for any `c` and
//! `d`.

use nalgebra::{SMatrix, SVector};
use pendulum_core::Real;
use pendulum_core::prelude::*;

/// Plate: mass, inertia about the centre of mass, distance from the joint to the centre of mass, friction of that
/// joint.
#[derive(Clone, Copy, Debug)]
pub struct Plate {
    pub mass: f64,
    pub inertia: f64,
    pub c: f64,
    pub friction: f64,
}

/// Double pendulum in absolute angles, `x = (theta1, theta2, omega1, omega2)`, with regrouped parameters.
#[derive(Clone, Copy, Debug)]
pub struct Eq22<T = f64> {
    /// Diagonal of the mass matrix, `I1 + m1 c1^2 + m2 d^2` and `I2 + m2 c2^2`, and the product of the two.
    m11: T,
    m22: T,
    m11_m22: T,
    /// `m2 d c2`, the factor of the cosine in the mass matrix.
    mu: T,
    /// `(m1 c1 + m2 d) g` and `m2 c2 g`.
    weight1: T,
    weight2: T,
    gamma1: T,
    gamma2: T,
}

impl<T: Real> Eq22<T> {
    /// Double pendulum of two plates; `d` is the distance between the two joints of the upper plate.
    pub fn new(upper: Plate, lower: Plate, d: f64, g: f64) -> Self {
        let m11 = upper.inertia + upper.mass * upper.c * upper.c + lower.mass * d * d;
        let m22 = lower.inertia + lower.mass * lower.c * lower.c;
        Self {
            m11: T::from_f64(m11),
            m22: T::from_f64(m22),
            m11_m22: T::from_f64(m11 * m22),
            mu: T::from_f64(lower.mass * d * lower.c),
            weight1: T::from_f64((upper.mass * upper.c + lower.mass * d) * g),
            weight2: T::from_f64(lower.mass * lower.c * g),
            gamma1: T::from_f64(upper.friction),
            gamma2: T::from_f64(lower.friction),
        }
    }

    /// Pendulum of the paper: two plates with `m = I = c = d = 1`, `g = 9.8` and the friction `gamma` in both joints.
    pub fn paper(gamma: f64) -> Self {
        let plate = Plate {
            mass: 1.0,
            inertia: 1.0,
            c: 1.0,
            friction: gamma,
        };
        Self::new(plate, plate, 1.0, 9.8)
    }
}

impl<T: Real> System<T, 4> for Eq22<T> {
    /// Takes 33 additions and multiplications, 1 division and 2 sine-cosine pairs.
    #[inline]
    fn rhs(&self, _t: T, x: &SVector<T, 4>) -> SVector<T, 4> {
        let (w1, w2) = (x[2], x[3]);
        let (s1, c1) = x[0].sin_cos();
        let (s2, c2) = x[1].sin_cos();
        let m12 = self.mu * (c1 * c2 + s1 * s2);
        let turn = self.mu * (s1 * c2 - c1 * s2);
        let rub = self.gamma2 * (w1 - w2);
        let f1 = -(self.gamma1 * w1 + rub + turn * w2 * w2 + self.weight1 * s1);
        let f2 = rub + turn * w1 * w1 - self.weight2 * s2;
        let inverse = T::from_f64(1.0) / (self.m11_m22 - m12 * m12);
        let a1 = (self.m22 * f1 - m12 * f2) * inverse;
        let a2 = (self.m11 * f2 - m12 * f1) * inverse;
        SVector::from([w1, w2, a1, a2])
    }
}

impl<T: Real> Jacobian<T, 4> for Eq22<T> {
    /// Computed column by column from `M da = df - dM a`.
    fn jacobian(&self, t: T, x: &SVector<T, 4>) -> SMatrix<T, 4, 4> {
        let (zero, one, two) = (T::default(), T::from_f64(1.0), T::from_f64(2.0));
        let (w1, w2) = (x[2], x[3]);
        let (s1, c1) = x[0].sin_cos();
        let (s2, c2) = x[1].sin_cos();
        let m12 = self.mu * (c1 * c2 + s1 * s2);
        let turn = self.mu * (s1 * c2 - c1 * s2);
        let inverse = one / (self.m11_m22 - m12 * m12);
        let rhs = self.rhs(t, x);
        let (a1, a2) = (rhs[2], rhs[3]);
        // d(m12)/d(theta1) = -turn, d(m12)/d(theta2) = turn; d(turn)/d(theta1) = m12, d(turn)/d(theta2) = -m12.
        let forces = [
            (
                -(m12 * w2 * w2 + self.weight1 * c1) + turn * a2,
                m12 * w1 * w1 + turn * a1,
            ),
            (
                m12 * w2 * w2 - turn * a2,
                -(m12 * w1 * w1) - self.weight2 * c2 - turn * a1,
            ),
            (-(self.gamma1 + self.gamma2), self.gamma2 + two * turn * w1),
            (self.gamma2 - two * turn * w2, -self.gamma2),
        ];
        let mut jacobian = SMatrix::from_element(zero);
        jacobian[(0, 2)] = one;
        jacobian[(1, 3)] = one;
        for (column, (f1, f2)) in forces.into_iter().enumerate() {
            jacobian[(2, column)] = (self.m22 * f1 - m12 * f2) * inverse;
            jacobian[(3, column)] = (self.m11 * f2 - m12 * f1) * inverse;
        }
        jacobian
    }
}

impl<T: Real> Energy<T, 4> for Eq22<T> {
    fn kinetic(&self, _t: T, x: &SVector<T, 4>) -> T {
        let (s1, c1) = x[0].sin_cos();
        let (s2, c2) = x[1].sin_cos();
        let m12 = self.mu * (c1 * c2 + s1 * s2);
        T::from_f64(0.5) * (self.m11 * x[2] * x[2] + self.m22 * x[3] * x[3]) + m12 * x[2] * x[3]
    }

    fn potential(&self, _t: T, x: &SVector<T, 4>) -> T {
        let (_, c1) = x[0].sin_cos();
        let (_, c2) = x[1].sin_cos();
        -(self.weight1 * c1) - self.weight2 * c2
    }
}

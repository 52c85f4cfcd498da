//! Twists and their bracket.

use std::ops::{Add, Mul};

use super::Vec3;
use crate::expr::{Expr, Graph};

/// A twist, in rad/s and m/s, or a screw axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Twist<'g> {
    /// Angular velocity.
    pub angular: Vec3<'g>,
    /// Velocity of the point at the origin.
    pub linear: Vec3<'g>,
}

impl<'g> Twist<'g> {
    /// Zero twist.
    pub fn zero(g: &'g Graph) -> Self {
        Self {
            angular: Vec3::zero(g),
            linear: Vec3::zero(g),
        }
    }

    /// True if the angular part is not zero, so that the motion is not a pure translation.
    pub fn turns(&self) -> bool {
        !self.angular.is_zero()
    }

    /// True if all components are the number 0.
    pub fn is_zero(&self) -> bool {
        self.angular.is_zero() && self.linear.is_zero()
    }

    /// `[a, b] = (a_w x b_w ; a_v x b_w + a_w x b_v)`
    #[must_use]
    pub fn bracket(&self, other: &Self) -> Self {
        Self {
            angular: self.angular.cross(other.angular),
            linear: self.linear.cross(other.angular) + self.angular.cross(other.linear),
        }
    }
}

impl Add for Twist<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            angular: self.angular + other.angular,
            linear: self.linear + other.linear,
        }
    }
}

impl<'g> Mul<Twist<'g>> for Expr<'g> {
    type Output = Twist<'g>;
    fn mul(self, twist: Twist<'g>) -> Twist<'g> {
        Twist {
            angular: self * twist.angular,
            linear: self * twist.linear,
        }
    }
}

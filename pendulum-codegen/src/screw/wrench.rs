//! Wrenches.

use std::ops::{Add, Mul, Sub};

use super::{Twist, Vec3};
use crate::expr::Expr;

/// A wrench, in N m and N, or a momentum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wrench<'g> {
    /// Moment about the origin.
    pub moment: Vec3<'g>,
    /// Force.
    pub force: Vec3<'g>,
}

impl<'g> Wrench<'g> {
    /// Power of the wrench along a twist.
    pub fn power(&self, twist: &Twist<'g>) -> Expr<'g> {
        self.moment.dot(twist.angular) + self.force.dot(twist.linear)
    }
}

impl Add for Wrench<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            moment: self.moment + other.moment,
            force: self.force + other.force,
        }
    }
}

impl Sub for Wrench<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self {
            moment: self.moment - other.moment,
            force: self.force - other.force,
        }
    }
}

impl<'g> Mul<Wrench<'g>> for Expr<'g> {
    type Output = Wrench<'g>;
    fn mul(self, wrench: Wrench<'g>) -> Wrench<'g> {
        Wrench {
            moment: self * wrench.moment,
            force: self * wrench.force,
        }
    }
}

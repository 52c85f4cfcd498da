//! Two robots against reference data: scenes for which the closed form is long, or too long to be made.

mod common;
#[path = "common/robots.rs"]
mod robots;

use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use robots::*;

/// Largest error over largest entry: rounding of some thousand operations.
const TOLERANCE: f64 = 1e-11;

agrees! {
    ur5: Ur5, 6;
    panda: Panda, 7;
}

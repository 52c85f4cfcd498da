//! Ten mechanisms, declared with the macro, against reference data made without screws: energies, mass matrix, bias,
//! acceleration and state Jacobian at four states each.

use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use testbed::mechanisms::*;

/// Largest error over largest entry. The reference has 20 digits; the remainder is rounding errors of some hundred
/// operations.
const TOLERANCE: f64 = 1e-12;

testbed::agrees! {
    eq22: Eq22, 2;
    eq22_joint: Eq22Joint, 2;
    irregular_plates: IrregularPlates, 2;
    chain5: Chain5, 5;
    cart_pole: CartPole, 2;
    furuta: Furuta, 2;
    screw_joint: ScrewJoint, 2;
    elbow3: Elbow3, 3;
    tree: Tree, 4;
    spring_pendulum_rig: SpringPendulumRig, 2;
}

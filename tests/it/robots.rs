//! Two robots against reference data: scenes for which the closed form is long, or too long to be made.

use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use testbed::robots::*;

/// Largest error over largest entry: rounding of some thousand operations.
const TOLERANCE: f64 = 1e-11;

testbed::agrees! {
    ur5: Ur5, 6;
    panda: Panda, 7;
}

/// Additions and multiplications, of the right-hand side and of the Jacobian with all that it needs. CasADi's C code of the same
/// models, after its own elimination of common subexpressions, has 890 and 5649 for UR5, 1910 and 9806 for Panda.
#[test]
fn the_code_is_short() {
    let [ur5, panda] = [Ur5::COST, Panda::COST];
    let counts = [ur5["rhs"], ur5["jacobian"], panda["rhs"], panda["jacobian"]].map(|cost| cost.flops());
    let most = [380, 1600, 1150, 4800];
    assert!(
        counts.iter().zip(most).all(|(&count, most)| count <= most),
        "{counts:?}"
    );
}

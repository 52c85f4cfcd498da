//! Code so long that it is compiled in parts.

use pendulum_core::dual::Dual;
use pendulum_core::prelude::*;

macro_rules! chain {
    ($($body:ident on $parent:ident as $angle:ident,)*) => {
        mechanism! {
            /// Links in a row, each with friction.
            Chain {
                gravity: [0, -9.81, 0],
                generate: [rhs, jacobian],
                body b0 on ground {
                    mass: 1.1, com: [0.02, -0.25, 0], inertia: 0.03,
                    joint: revolute(z), coordinate: q0, friction: 0.01,
                }
                $(
                    body $body on $parent {
                        mass: 1.1, com: [0.02, -0.25, 0], inertia: 0.03,
                        joint: revolute(z) at [0, -0.5, 0], coordinate: $angle, friction: 0.01,
                    }
                )*
            }
        }
    };
}

chain! {
    b1 on b0 as q1, b2 on b1 as q2, b3 on b2 as q3, b4 on b3 as q4, b5 on b4 as q5, b6 on b5 as q6,
    b7 on b6 as q7, b8 on b7 as q8, b9 on b8 as q9, b10 on b9 as q10, b11 on b10 as q11, b12 on b11 as q12,
    b13 on b12 as q13, b14 on b13 as q14, b15 on b14 as q15, b16 on b15 as q16, b17 on b16 as q17, b18 on b17 as q18,
    b19 on b18 as q19, b20 on b19 as q20, b21 on b20 as q21, b22 on b21 as q22, b23 on b22 as q23, b24 on b23 as q24,
    b25 on b24 as q25, b26 on b25 as q26,
}

/// Length of the state.
const N: usize = 2 * Chain::DOF;

#[test]
fn the_jacobian_of_a_long_chain_is_that_of_its_right_hand_side() {
    let chain = Chain::new(ChainParams::default()).expect("physical");
    let x: SVector<f64, N> = SVector::from_fn(|i, _| (1.0 + i as f64).sin());
    let (rates, jacobian) = chain.rhs_and_jacobian(0.0, &x);
    assert_eq!(rates, chain.rhs(0.0, &x));
    let of_duals = chain.cast::<Dual<f64, 1>>();
    for (k, column) in jacobian.column_iter().enumerate() {
        let mut moved = x.map(Dual::constant);
        moved[k] = Dual::variable(x[k], 0);
        let expected = of_duals.rhs(Dual::constant(0.0), &moved).map(|rate| rate.slopes[0]);
        let off = (column - expected).amax();
        assert!(off <= 1e-10 * expected.amax().max(1.0), "{off} in column {k}");
    }
}

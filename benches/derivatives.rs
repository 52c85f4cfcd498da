//! Times of derivatives of trajectories over those of the trajectories: `cargo bench -p benches --bench derivatives`.

use std::hint::black_box;

use pendulum_core::Real;
use pendulum_core::prelude::*;
use pendulum_core::sensitivity::{self, Cost, Variable};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

use Variable::{Parameter, Start};
use ratio::ratio;

mod ratio;

mechanism! {
    /// Ten links in space with 99 parameters.
    pub Chain {
        params {
            m0: kg = 1, l0: m = 0.5, c0: m = 0.2, d0: m = 0.03, e0: m = -0.04, ia0: kg m^2 = 0.02,
            ib0: kg m^2 = 0.03, ic0: kg m^2 = 0.025, g0: N m s = 0.1, s0: N m/rad = 0.2,
            m1: kg = 1, l1: m = 0.5, c1: m = 0.2, d1: m = 0.03, e1: m = -0.04, ia1: kg m^2 = 0.02,
            ib1: kg m^2 = 0.03, ic1: kg m^2 = 0.025, g1: N m s = 0.1, s1: N m/rad = 0.2,
            m2: kg = 1, l2: m = 0.5, c2: m = 0.2, d2: m = 0.03, e2: m = -0.04, ia2: kg m^2 = 0.02,
            ib2: kg m^2 = 0.03, ic2: kg m^2 = 0.025, g2: N m s = 0.1, s2: N m/rad = 0.2,
            m3: kg = 1, l3: m = 0.5, c3: m = 0.2, d3: m = 0.03, e3: m = -0.04, ia3: kg m^2 = 0.02,
            ib3: kg m^2 = 0.03, ic3: kg m^2 = 0.025, g3: N m s = 0.1, s3: N m/rad = 0.2,
            m4: kg = 1, l4: m = 0.5, c4: m = 0.2, d4: m = 0.03, e4: m = -0.04, ia4: kg m^2 = 0.02,
            ib4: kg m^2 = 0.03, ic4: kg m^2 = 0.025, g4: N m s = 0.1, s4: N m/rad = 0.2,
            m5: kg = 1, l5: m = 0.5, c5: m = 0.2, d5: m = 0.03, e5: m = -0.04, ia5: kg m^2 = 0.02,
            ib5: kg m^2 = 0.03, ic5: kg m^2 = 0.025, g5: N m s = 0.1, s5: N m/rad = 0.2,
            m6: kg = 1, l6: m = 0.5, c6: m = 0.2, d6: m = 0.03, e6: m = -0.04, ia6: kg m^2 = 0.02,
            ib6: kg m^2 = 0.03, ic6: kg m^2 = 0.025, g6: N m s = 0.1, s6: N m/rad = 0.2,
            m7: kg = 1, l7: m = 0.5, c7: m = 0.2, d7: m = 0.03, e7: m = -0.04, ia7: kg m^2 = 0.02,
            ib7: kg m^2 = 0.03, ic7: kg m^2 = 0.025, g7: N m s = 0.1, s7: N m/rad = 0.2,
            m8: kg = 1, l8: m = 0.5, c8: m = 0.2, d8: m = 0.03, e8: m = -0.04, ia8: kg m^2 = 0.02,
            ib8: kg m^2 = 0.03, ic8: kg m^2 = 0.025, g8: N m s = 0.1, s8: N m/rad = 0.2,
            m9: kg = 1, c9: m = 0.2, d9: m = 0.03, e9: m = -0.04, ia9: kg m^2 = 0.02, ib9: kg m^2 =
            0.03, ic9: kg m^2 = 0.025, g9: N m s = 0.1, s9: N m/rad = 0.2,
        }
        gravity: [0, -9.81, 0],
        generate: [rhs, adjoint],
        body b0 on ground {
            mass: m0, com: [c0, d0, e0], inertia: [ia0, ib0, ic0],
            joint: revolute(z) at [0, 0, 0], coordinate: q0, friction: g0, spring: (s0, 0),
        }
        body b1 on b0 {
            mass: m1, com: [c1, d1, e1], inertia: [ia1, ib1, ic1],
            joint: revolute(y) at [l0, 0, 0], coordinate: q1, friction: g1, spring: (s1, 0),
        }
        body b2 on b1 {
            mass: m2, com: [c2, d2, e2], inertia: [ia2, ib2, ic2],
            joint: revolute(x) at [l1, 0, 0], coordinate: q2, friction: g2, spring: (s2, 0),
        }
        body b3 on b2 {
            mass: m3, com: [c3, d3, e3], inertia: [ia3, ib3, ic3],
            joint: revolute(z) at [l2, 0, 0], coordinate: q3, friction: g3, spring: (s3, 0),
        }
        body b4 on b3 {
            mass: m4, com: [c4, d4, e4], inertia: [ia4, ib4, ic4],
            joint: revolute(y) at [l3, 0, 0], coordinate: q4, friction: g4, spring: (s4, 0),
        }
        body b5 on b4 {
            mass: m5, com: [c5, d5, e5], inertia: [ia5, ib5, ic5],
            joint: revolute(x) at [l4, 0, 0], coordinate: q5, friction: g5, spring: (s5, 0),
        }
        body b6 on b5 {
            mass: m6, com: [c6, d6, e6], inertia: [ia6, ib6, ic6],
            joint: revolute(z) at [l5, 0, 0], coordinate: q6, friction: g6, spring: (s6, 0),
        }
        body b7 on b6 {
            mass: m7, com: [c7, d7, e7], inertia: [ia7, ib7, ic7],
            joint: revolute(y) at [l6, 0, 0], coordinate: q7, friction: g7, spring: (s7, 0),
        }
        body b8 on b7 {
            mass: m8, com: [c8, d8, e8], inertia: [ia8, ib8, ic8],
            joint: revolute(x) at [l7, 0, 0], coordinate: q8, friction: g8, spring: (s8, 0),
        }
        body b9 on b8 {
            mass: m9, com: [c9, d9, e9], inertia: [ia9, ib9, ic9],
            joint: revolute(z) at [l8, 0, 0], coordinate: q9, friction: g9, spring: (s9, 0),
        }
    }
}

/// Squared angle of the last link.
struct Tip;

impl Cost<20> for Tip {
    fn end<T: Real>(&self, _t: T, x: &SVector<T, 20>) -> T {
        x[9] * x[9]
    }
}

/// Number of pairs of measurements; the ratio is their median.
const PAIRS: usize = 201;

fn main() {
    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    let x0 = black_box([2.0, 2.5, 0.0, 0.0]);
    let four = [Start(0), Start(1), Start(2), Start(3)];
    let parameters = [0, 1, 2, 3, 5, 6].map(Parameter);
    let ten: [Variable; 10] = std::array::from_fn(|k| if k < 4 { four[k] } else { parameters[k - 4] });
    println!("double pendulum with friction, 10 s at 1e-8, end only:");
    let method = Vern9::new().rtol(1e-8).atol(1e-8);
    let plain = || {
        method
            .stepper(&model, 0.0, 10.0, x0)
            .expect("valid")
            .run()
            .expect("regular")
    };
    let by = |name: &str, ratio: f64| println!("{name:<40} {ratio:.2}");
    by(
        "Vern9, by 4 initial conditions",
        ratio(
            PAIRS,
            1,
            || sensitivity::end(&method, &model, 0.0, 10.0, x0, four),
            plain,
        ),
    );
    by(
        "Vern9, by 4 and 6 parameters",
        ratio(
            PAIRS,
            1,
            || sensitivity::end(&method, &model, 0.0, 10.0, x0, ten),
            plain,
        ),
    );
    let (models, starts) = ([model], vec![SVector::from(x0); 64]);
    let plain = || method.ensemble(&models, 0.0, 10.0, &starts);
    by(
        "Vern9 in lanes, by 4 initial conditions",
        ratio(
            PAIRS,
            1,
            || sensitivity::ensemble(&method, &models, 0.0, 10.0, &starts, four),
            plain,
        ),
    );
    by(
        "Vern9 in lanes, by 4 and 6 parameters",
        ratio(
            PAIRS,
            1,
            || sensitivity::ensemble(&method, &models, 0.0, 10.0, &starts, ten),
            plain,
        ),
    );
    println!("ten links, 2 s at 1e-8, gradient by 20 initial conditions and 99 parameters:");
    let chain = Chain::new(ChainParams::default()).expect("physical");
    let x0: [f64; 20] = std::array::from_fn(|k| 0.1 * (k as f64).sin());
    macro_rules! gradient {
        ($method:ident) => {{
            let method = $method::new().rtol(1e-8).atol(1e-8);
            let plain = || {
                method
                    .stepper(&chain, 0.0, 2.0, x0)
                    .expect("valid")
                    .run()
                    .expect("regular")
            };
            let gradient = || sensitivity::gradient(&method, &chain, 0.0, 2.0, x0, &Tip);
            by(stringify!($method), ratio(PAIRS, 1, gradient, plain));
        }};
    }
    gradient!(Vern9);
    gradient!(Vern7);
    gradient!(Rk45);
}

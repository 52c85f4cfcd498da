//! Time of a pass of iterative LQR over 30 steps of 20 ms, for robots from files, within the limits of their torques:
//! `cargo bench -p benches --bench ilqr`.
//!
//! A pass follows the last motion from a state that has moved, goes backward, and searches forward.

use std::hint::black_box;
use std::time::Instant;

use pendulum_core::control::{Ilqr, Quadratic};
use pendulum_core::inputs::Controlled;
use pendulum_core::prelude::*;

mechanism! {
    pub Ur5 {
        robot: urdf("../testbed/data/urdf/ur5.urdf"),
        gravity: [0, 0, -9.81],
        input u1: N m, input u2: N m, input u3: N m, input u4: N m, input u5: N m, input u6: N m,
        body shoulder_link on base_link { torque: u1 }
        body upper_arm_link on shoulder_link { torque: u2 }
        body forearm_link on upper_arm_link { torque: u3 }
        body wrist_1_link on forearm_link { torque: u4 }
        body wrist_2_link on wrist_1_link { torque: u5 }
        body wrist_3_link on wrist_2_link { torque: u6 }
        generate: [rhs, jacobian, inverse_dynamics],
    }
}

mechanism! {
    pub Panda {
        robot: urdf("../testbed/data/urdf/panda_with_hand.urdf"),
        gravity: [0, 0, -9.81],
        input u1: N m, input u2: N m, input u3: N m, input u4: N m, input u5: N m, input u6: N m, input u7: N m,
        body panda_link1 on panda_link0 { torque: u1 }
        body panda_link2 on panda_link1 { torque: u2 }
        body panda_link3 on panda_link2 { torque: u3 }
        body panda_link4 on panda_link3 { torque: u4 }
        body panda_link5 on panda_link4 { torque: u5 }
        body panda_link6 on panda_link5 { torque: u6 }
        body panda_link7 on panda_link6 { torque: u7 }
        body panda_leftfinger on panda_hand { joint: fixed }
        body panda_rightfinger on panda_hand { joint: fixed }
        generate: [rhs, jacobian, inverse_dynamics],
    }
}

/// Number of passes; the fastest one counts.
const PASSES: usize = 2000;

fn time<S, const N: usize, const M: usize>(name: &str, model: &S, at: [f64; N], hold: [f64; M], limits: [f64; M])
where
    S: Controlled<f64, N, M>,
{
    let goal = SVector::from(at).map(|q| 0.8 * q);
    let weights = std::array::from_fn(|n| if n < M { 100.0 } else { 0.1 });
    let cost = Quadratic::diagonal(weights, [1e-4; M])
        .end(SMatrix::from_diagonal(&SVector::from(weights)))
        .goal(goal, hold);
    let mut ilqr = Ilqr::<_, _, N, M, 30>::new(0.02, cost)
        .limits(limits.map(|limit| -limit), limits)
        .start(hold);
    let solved = ilqr.solve(model, 0.0, at).expect("a motion");
    let moved = SVector::from(at).map(|q| q + 1e-3);
    let mut times: Vec<f64> = (0..PASSES)
        .map(|_| {
            let mut ilqr = black_box(ilqr);
            let start = Instant::now();
            let pass = ilqr.pass(model, 0.0, moved).expect("a motion");
            let time = start.elapsed().as_secs_f64();
            assert!(pass.share == 1.0, "{pass:?}");
            time
        })
        .collect();
    times.sort_by(f64::total_cmp);
    let [least, median] = [times[0], times[PASSES / 2]].map(|time| 1e3 * time);
    println!(
        "{name}: {least:.3} ms at least, median {median:.3} ms; the search took {} passes",
        solved.iterations
    );
}

/// The state of an arm at rest.
fn state<const M: usize, const N: usize>(joints: [f64; M]) -> [f64; N] {
    std::array::from_fn(|n| joints.get(n).copied().unwrap_or_default())
}

fn main() {
    let ur5 = Ur5::new(Ur5Params {}).expect("physical");
    let at = state([0.5, -1.0, 1.2, -0.4, 0.7, 0.3]);
    let hold = ur5.inverse_dynamics(0.0, &SVector::from(at), &SVector::zeros());
    time("UR5", &ur5, at, hold.into(), Ur5::EFFORT_LIMITS);

    let panda = Panda::new(PandaParams {}).expect("physical");
    let at = state([0.3, -0.8, 0.2, -2.0, 0.1, 1.6, 0.8]);
    let hold = panda.inverse_dynamics(0.0, &SVector::from(at), &SVector::zeros());
    time("Panda", &panda, at, hold.into(), Panda::EFFORT_LIMITS);
}

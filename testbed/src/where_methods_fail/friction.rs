//! Friction that makes the double pendulum stiff.

use pendulum_core::method::{Fixed, RadauIIA};
use pendulum_core::prelude::*;
use pendulum_core::stability::{StabilityFunction, equilibrium, max_stable_step};
use pendulum_core::{Reason, Statistics};

use super::row::{Claim, Row, Size, kind};
use crate::scenes::DoublePendulum;
use crate::scenes::double_pendulum;

const START: [f64; 4] = [1.0, -1.0, 0.0, 0.0];

/// Step size of the method with fixed steps, in s.
const H: f64 = 0.1;
/// End time, in s; the pendulum comes to rest within seconds.
const REST: f64 = 400.0;

/// Bisects for the friction at which `breaks` becomes true, between a value at which it is false and one at which it is
/// true.
fn threshold(breaks: impl Fn(f64) -> bool, (mut sound, mut broken): (f64, f64)) -> f64 {
    for _ in 0..20 {
        let middle = sound.midpoint(broken);
        if breaks(middle) {
            broken = middle;
        } else {
            sound = middle;
        }
    }
    sound.midpoint(broken)
}

/// Final state of a method.
fn end_of(method: &impl Method<DoublePendulum, f64, 4>, gamma: f64) -> Result<SVector<f64, 4>, Reason> {
    method.stepper(&double_pendulum(gamma), 0.0, REST, START)?.run()
}

/// Critical friction of a step size.
pub fn critical(_: Size) -> Row {
    let around = (1.0, 30.0);
    let end = |gamma| end_of(&Rk4::new(H), gamma);
    let predicted = threshold(
        |gamma| {
            let hanging = equilibrium(&double_pendulum(gamma), [0.0; 4]).expect("it hangs");
            H > max_stable_step(&Rk4::new(H), &hanging.jacobian).expect("finite")
        },
        around,
    );
    // The pendulum should rest: a finite state may be wrong all the same.
    let observed = threshold(|gamma| !end(gamma).is_ok_and(|x| x.amax() < 1e-6), around);
    let beyond = end(1.1 * predicted).map_or(f64::NAN, |x| x.amax());
    let far_beyond = end(2.0 * predicted).expect_err("far too long");
    let gauss = end_of(&Gauss6::new(H), 2.0 * predicted).expect("stable").amax();
    let radau = end_of(&Fixed::<RadauIIA>::new(H), 2.0 * predicted)
        .expect("stable")
        .amax();
    Row {
        in_book: true,
        case: "Friction with steps of 0.1 s",
        claims: vec![
            Claim::close("Rk4 unstable above γ (N m s)", predicted, observed, 0.01),
            Claim::at_least("at 1.1 of that, largest rate after 400 s, truly 0 (rad/s)", 1.0, beyond),
            Claim::at_most("which stays bounded (rad/s)", 10.0, beyond),
            Claim::same("at twice of that, it ends in", "NonFinite", kind(far_beyond)),
            Claim::at_most("and Gauss6 at rest (rad, rad/s)", 1e-6, gauss),
            Claim::at_most("and Radau5 with such steps at rest (rad, rad/s)", 1e-6, radau),
        ],
        survives: "Rodas, Radau, Gauss",
    }
}

const TOLERANCE: f64 = 1e-6;
const TIME: f64 = 10.0;

/// Work of an adaptive method at a given friction.
pub fn work<M: Method<DoublePendulum, f64, 4>>(method: &M, gamma: f64) -> Statistics {
    let solution = method.solve(&double_pendulum(gamma), 0.0, TIME, START);
    solution.expect("regular").statistics()
}

/// Minimum number of steps for which a method is stable along the motion.
pub fn stable_steps(method: &impl StabilityFunction, gamma: f64) -> f64 {
    let model = double_pendulum(gamma);
    let motion = Radau5::new()
        .rtol(TOLERANCE)
        .atol(TOLERANCE)
        .solve(&model, 0.0, TIME, START)
        .expect("regular");
    let mut steps = 0.0;
    for pair in motion.t().windows(2) {
        let middle = motion.at(pair[0].midpoint(pair[1])).expect("within");
        let longest = max_stable_step(method, &model.jacobian(0.0, &middle)).expect("finite");
        steps += (pair[1] - pair[0]) / longest;
    }
    steps
}

/// Explicit methods take as many steps as stability requires, which increase with the friction; implicit methods take
/// fewer, as the motion has less to resolve.
pub fn steps(_: Size) -> Row {
    const FRICTIONS: [f64; 3] = [1e4, 1e3, 1e2];
    /// Number of extra steps at the start, before stability alone limits the step size.
    const START_STEPS: f64 = 20.0;
    fn explicit<M: Method<DoublePendulum, f64, 4> + StabilityFunction>(name: &str, method: &M) -> [Claim; 3] {
        FRICTIONS.map(|gamma| {
            let what = format!("{name}: steps at γ = {gamma:.0e} N m s");
            let (least, taken) = (stable_steps(method, gamma), work(method, gamma).accepted as f64);
            Claim::close(what, least, taken, START_STEPS / least)
        })
    }
    fn implicit<M: Method<DoublePendulum, f64, 4>>(name: &str, method: &M) -> [Claim; 2] {
        let steps = FRICTIONS.map(|gamma| work(method, gamma).accepted as f64);
        [0, 1].map(|n| {
            let what = format!("{name}: steps at γ = {:.0e} N m s, fewer than with less", FRICTIONS[n]);
            Claim::at_most(what, steps[n + 1] - 1.0, steps[n])
        })
    }
    let mut claims = Vec::new();
    claims.extend(explicit("Rk45", &Rk45::new().rtol(TOLERANCE).atol(TOLERANCE)));
    claims.extend(explicit("Vern9", &Vern9::new().rtol(TOLERANCE).atol(TOLERANCE)));
    claims.extend(explicit("Taylor", &Taylor::new().rtol(TOLERANCE).atol(TOLERANCE)));
    claims.extend(implicit("Rodas4", &Rodas4::new().rtol(TOLERANCE).atol(TOLERANCE)));
    claims.extend(implicit("Rodas5P", &Rodas5P::new().rtol(TOLERANCE).atol(TOLERANCE)));
    claims.extend(implicit("Radau5", &Radau5::new().rtol(TOLERANCE).atol(TOLERANCE)));
    Row {
        in_book: true,
        case: "Friction with a tolerance of 1e-6, for 10 s",
        claims,
        survives: "Rodas, Radau, Auto",
    }
}

/// [`Auto`] switches if stability limits the step size, and only then.
pub fn detection(_: Size) -> Row {
    let auto = Auto::new().rtol(TOLERANCE).atol(TOLERANCE);
    // Maximum number of explicit steps: eight at the limit of stability, and as many before.
    const BEFORE: f64 = 20.0;
    let stiff = [1e2, 1e3, 1e4].map(|gamma| {
        let work = work(&auto, gamma);
        [
            Claim::same(format!("changes at γ = {gamma:.0e} N m s"), 1, work.switches),
            Claim::at_most("explicit steps before", BEFORE, (work.accepted - work.stiff) as f64),
        ]
    });
    let chaotic = auto
        .solve(&double_pendulum(0.0), 0.0, 100.0, [2.0, 2.5, 0.0, 0.0])
        .expect("regular");
    let silent = Claim::same("changes without friction, in chaos", 0, chaotic.statistics().switches);
    Row {
        in_book: false,
        case: "Stiffness that is noticed",
        claims: stiff.into_iter().flatten().chain([silent]).collect(),
        survives: "Auto",
    }
}

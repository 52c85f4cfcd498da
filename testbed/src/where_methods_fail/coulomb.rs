//! Dry friction.

use std::f64::consts::PI;

use pendulum_core::prelude::*;
use pendulum_core::stability::max_stable_step;

use super::row::{Claim, Row, Size, kind};
use super::scenes::{DryPendulum, DryPendulumParams, SmoothedPendulum, SmoothedPendulumParams};

/// Maximum friction force per mass, in m/s^2.
const GRIP: f64 = 2.0;
/// Pulling force per mass, in m/s^2.
const PULL: f64 = 1.0;
/// Initial speed, in m/s.
const SPEED: f64 = 1.0;
/// Duration of sliding, in s, after which friction holds the block.
const STOP: f64 = SPEED / (GRIP - PULL);

/// Block on a level floor with friction by the sign function: `v' = PULL - GRIP sign(v)`.
struct Sign;

impl System<f64, 2> for Sign {
    fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        SVector::from([x[1], PULL - GRIP * x[1].signum()])
    }
}

impl Jacobian<f64, 2> for Sign {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        SMatrix::from([[0.0, 0.0], [1.0, 0.0]])
    }
}

mechanism! {
    /// Like `Sign`, but with friction smoothed over a speed of `eps`.
    Smooth {
        params { grip: N, pull: N, eps: m/s }
        body block on ground { mass: 1, joint: prismatic(x), coordinate: x, torque: pull - grip * tanh(qd / eps) }
    }
}

mechanism! {
    /// Block with stiction, pulled to and fro.
    Dry {
        params { grip: N, pull: N, omega: rad/s }
        generate: [rhs],
        body block on ground {
            mass: 1, joint: prismatic(x), coordinate: x, torque: pull * sin(omega * t), dry_friction: grip,
        }
    }
}

/// Mean size of `STEPS` steps of a method during which the block should stand still.
fn crawl<M: Method<Sign, f64, 2>>(method: &M) -> f64 {
    let mut stepper = method.stepper(&Sign, 0.0, 10.0 * STOP, [0.0, SPEED]).expect("valid");
    while stepper.t() < STOP {
        stepper.step().expect("regular");
    }
    let start = stepper.t();
    for _ in 0..STEPS {
        stepper.step().expect("the jump is small");
    }
    (stepper.t() - start) / f64::from(STEPS)
}

/// Number of steps in the mean. The first ones still belong to the stop: at the larger tolerance they would raise a
/// mean of 1000 steps of Vern9 by 9 %.
const STEPS: u32 = 4000;
const TOLERANCES: [f64; 2] = [1e-6, 1e-8];

/// If each step contains a jump of the force, the error of a method is of first order, so its step size is proportional
/// to the tolerance.
pub fn sign(_: Size) -> Row {
    let lengths = [
        (
            "Rk45",
            TOLERANCES.map(|tolerance| crawl(&Rk45::new().rtol(tolerance).atol(tolerance))),
        ),
        (
            "Vern9",
            TOLERANCES.map(|tolerance| crawl(&Vern9::new().rtol(tolerance).atol(tolerance))),
        ),
        (
            "Rodas5P",
            TOLERANCES.map(|tolerance| crawl(&Rodas5P::new().rtol(tolerance).atol(tolerance))),
        ),
    ];
    let falls = lengths.map(|(name, [wide, narrow])| {
        Claim::close(
            format!(
                "{name}: mean steps at the tolerance {:.0e} over those at {:.0e}",
                TOLERANCES[0], TOLERANCES[1]
            ),
            TOLERANCES[0] / TOLERANCES[1],
            wide / narrow,
            0.05,
        )
    });
    let longest = lengths.iter().map(|(_, [_, narrow])| *narrow).fold(0.0, f64::max);
    let radau = crawl(&Radau5::new().rtol(TOLERANCES[1]).atol(TOLERANCES[1]));
    let error = Rk45::new()
        .rtol(TOLERANCES[1])
        .atol(TOLERANCES[1])
        .max_steps(1000)
        .solve(&Sign, 0.0, 10.0 * STOP, [0.0, SPEED])
        .expect_err("it crawls");
    let rest = [
        Claim::at_most(
            "the longest of them at the narrow one (s)",
            50.0 * TOLERANCES[1],
            longest,
        ),
        Claim::at_most("Radau5: mean steps at the narrow one (s)", 2.0 * TOLERANCES[1], radau),
        Claim::same("Rk45: how it ends", "Jump", kind(error.reason)),
    ];
    Row {
        in_book: false,
        case: "Coulomb friction as a sign",
        claims: falls.into_iter().chain(rest).collect(),
        survives: "none: smooth the sign, or stop at an event",
    }
}

/// Width of the smoothed sign, in m/s.
const EPS: f64 = 1e-4;

/// With a smooth law the block creeps wherever a force acts: `tanh(v / eps) = PULL / GRIP`.
pub fn smooth(_: Size) -> Row {
    let params = SmoothParams {
        grip: GRIP,
        pull: PULL,
        eps: EPS,
    };
    let model = Smooth::new(params).expect("physical");
    let creep = EPS * (PULL / GRIP).atanh();
    let time = 10.0 * STOP;
    let solution = Rodas5P::new().solve(&model, 0.0, time, [0.0, SPEED]).expect("smooth");
    let creeping = model.jacobian(0.0, &SVector::from([0.0, creep]));
    let longest = max_stable_step(&Rk45::new(), &creeping).expect("finite");
    let explicit = Rk45::new().solve(&model, 0.0, time, [0.0, SPEED]).expect("smooth");
    Row {
        in_book: true,
        case: "Coulomb friction as a smoothed sign",
        claims: vec![
            Claim::close(
                "speed of a block that should stick (m/s)",
                creep,
                solution.end()[1],
                1e-9,
            ),
            Claim::close(
                "Rk45: steps",
                (time - STOP) / longest,
                explicit.statistics().accepted as f64,
                0.02,
            ),
            Claim::at_most("Rodas5P: steps", 100.0, solution.statistics().accepted as f64),
        ],
        survives: "Rodas, Radau, Auto, but the block creeps",
    }
}

const TO_AND_FRO: f64 = 3.0;
const OMEGA: f64 = 2.0;

/// First two mode switches in closed form: the pull exceeds the grip, and the momentum is used up.
fn first_slip() -> [(f64, f64); 2] {
    let (amplitude, w) = (TO_AND_FRO, OMEGA);
    let start = (GRIP / amplitude).asin() / w;
    let speed = |t: f64| amplitude / w * ((w * start).cos() - (w * t).cos()) - GRIP * (t - start);
    // bracket from maximum speed, where the pull is down to the grip again, to the opposite extreme of the pull
    let (mut before, mut after) = ((PI - w * start) / w, 1.5 * PI / w);
    for _ in 0..60 {
        let middle = before.midpoint(after);
        if speed(middle) > 0.0 {
            before = middle;
        } else {
            after = middle;
        }
    }
    let time = before - start;
    let way = amplitude / w * (w * start).cos() * time
        - amplitude / (w * w) * ((w * before).sin() - (w * start).sin())
        - 0.5 * GRIP * time * time;
    [(start, 0.0), (before, way)]
}

/// Stiction: the block alternately slips and sticks.
pub fn events(_: Size) -> Row {
    let params = DryParams {
        grip: GRIP,
        pull: TO_AND_FRO,
        omega: OMEGA,
    };
    let model = Dry::new(params).expect("physical");
    let method = Vern9::new().rtol(1e-12).atol(1e-12);
    let solution = method
        .solve(&model, 0.0, 12.0 * PI / OMEGA, [0.0, 0.0])
        .expect("regular");
    let at = |t: f64| solution.at(t).expect("within");
    let changes: Vec<f64> = solution.modes()[1..].iter().map(|(t, _)| *t).collect();
    let [breaks, stops] = first_slip();
    Row {
        in_book: true,
        case: "Coulomb friction with sticking",
        claims: vec![
            Claim::close("start of slip (s)", breaks.0, changes[0], 1e-12),
            Claim::close("it sticks at (s)", stops.0, changes[1], 1e-12),
            Claim::close("on its way of (m)", stops.1, at(changes[1])[0], 1e-12),
            Claim::at_most("from the start after a period (m)", 1e-12, at(changes[3])[0].abs()),
            Claim::same(
                "its rate where it sticks (m/s)",
                0,
                at(changes[1].midpoint(changes[2]))[1],
            ),
            Claim::same("changes in six periods", 23, changes.len()),
        ],
        survives: "every method, by `dry_friction`",
    }
}

/// Breakaway moments of the joints of the double pendulum, in N m.
const MOMENTS: [f64; 2] = [1.5, 0.6];
/// Initial condition.
const LIFTED: [f64; 4] = [1.2, 0.4, 0.0, 0.0];
/// Time at which it has been at rest for a while, in s.
const LATE: f64 = 60.0;
/// Maximum error of the angles at the time [`LATE`], in rad.
const ALLOWED: f64 = 1e-6;

/// Number of evaluations and Jacobians of a method, if it meets the maximum error.
fn spent<S, M>(method: &M, system: &S, truth: &SVector<f64, 4>) -> Option<usize>
where
    S: System<f64, 4>,
    M: Method<S, f64, 4>,
{
    let mut stepper = method.stepper(system, 0.0, LATE, LIFTED).ok()?;
    let end = stepper.run().ok()?;
    let error = (end - truth).fixed_rows::<2>(0).amax();
    let work = stepper.statistics();
    (error <= ALLOWED).then_some(work.evaluations + work.jacobians)
}

/// Least work of several methods, each at its best tolerance in steps of half a decade.
macro_rules! least {
    ($system:expr, $truth:expr, $half_decades:expr, [$($method:ident),*]) => { {
        let tolerances = $half_decades.map(half_decade);
        let each = tolerances.flat_map(|tolerance| {
            [$( spent(&$method::new().rtol(tolerance).atol(tolerance).max_steps(200_000), $system, $truth) ),*]
        });
        each.flatten().min()
    } };
}

fn half_decade(n: i32) -> f64 {
    10.0_f64.powf(-0.5 * f64::from(n))
}

/// For the same error of the rest position, stiction takes a fraction of the work of a smoothed sign.
pub fn smoothed_against_stuck(size: Size) -> Row {
    let [mu1, mu2] = MOMENTS;
    let dry = DryPendulum::new(DryPendulumParams { mu1, mu2 }).expect("physical");
    let truth = Vern9::new().rtol(1e-13).atol(1e-13).solve(&dry, 0.0, LATE, LIFTED);
    let truth = truth.expect("regular");
    let ((rests, _), end) = (*truth.modes().last().expect("a mode"), truth.end());
    let smoothed = |eps: f64| {
        let params = SmoothedPendulumParams { mu1, mu2, eps };
        SmoothedPendulum::new(params).expect("physical")
    };
    let (sticking, creeping) = match size {
        // the best combinations of the full search
        Size::Small => (
            least!(&dry, &end, 10..=12, [Tsit5]),
            least!(&smoothed(half_decade(17)), &end, 18..=20, [Rodas5P]),
        ),
        Size::Full => {
            let widths = (12..=20).map(half_decade);
            let each = widths.filter_map(|eps| least!(&smoothed(eps), &end, 8..=24, [Rodas5P, Radau5, Auto]));
            (least!(&dry, &end, 8..=24, [Tsit5, Vern7, Vern9]), each.min())
        }
    };
    let [sticking, creeping] = [sticking, creeping].map(|work| work.map_or(f64::NAN, |work| work as f64));
    // gravity load of the lower joint, and the creep rate at which the smoothed sign balances it
    let load = 0.5 * 9.81 * (end[0] + end[1]).sin();
    let eps = 1e-4;
    let late = Rodas5P::new()
        .rtol(1e-9)
        .atol(1e-12)
        .solve(&smoothed(eps), 0.0, LATE, LIFTED);
    let late = late.expect("regular").end();
    let creep = -eps * (0.5 * 9.81 * (late[0] + late[1]).sin() / mu2).atanh();
    Row {
        in_book: true,
        case: "Double pendulum with dry friction, to 1e-6 rad after a minute",
        claims: vec![
            Claim::at_most(
                "evaluations, at most a tenth of those with the best smoothed sign",
                0.1 * creeping,
                sticking,
            ),
            Claim::close(
                "creep of the lower rod, smoothed over 1e-4 rad/s (rad/s)",
                creep,
                late[3],
                1e-3,
            ),
            Claim::same("its rate with friction that sticks (rad/s)", 0, end[3]),
            Claim::at_most("which carries of what it can (N m)", mu2, load.abs()),
            Claim::at_most("from (s)", 10.0, rests),
        ],
        survives: "every method, by `dry_friction`",
    }
}

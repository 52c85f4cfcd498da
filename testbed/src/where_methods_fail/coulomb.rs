//! Dry friction.

use std::f64::consts::PI;

use pendulum_core::prelude::*;
use pendulum_core::stability::max_stable_step;

use super::row::{Claim, Row, Size, kind};

/// The force that friction can bear, per mass, in m/s^2.
const GRIP: f64 = 2.0;
/// What pulls, per mass.
const PULL: f64 = 1.0;
/// The speed at the start, in m/s: it slides for 1 s, and then friction holds it.
const SPEED: f64 = 1.0;
const STOP: f64 = SPEED / (GRIP - PULL);

/// A block on a level floor whose friction is a sign: `v' = PULL - GRIP sign(v)`.
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
    /// The same with a friction that rises over a speed of `eps`.
    Smooth {
        params { grip: N, pull: N, eps: m/s }
        body block on ground { mass: 1, joint: prismatic(x), coordinate: x, torque: pull - grip * tanh(qd / eps) }
    }
}

mechanism! {
    /// The block as it slips to the side `side`, pulled to and fro.
    Slip {
        params { grip: N, pull: N, omega: rad/s, side: 1 }
        generate: [rhs],
        body block on ground { mass: 1, joint: prismatic(x), coordinate: x, torque: pull * sin(omega * t) - grip * side }
    }
}

/// The mean length of `STEPS` steps of a method where the block should stand still.
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

/// The first of them are those of the stop: with the wide tolerance they are 9 % of the mean of 1000 of Vern9's.
const STEPS: u32 = 4000;
const TOLERANCES: [f64; 2] = [1e-6, 1e-8];

/// A method that meets a jump of the force in each step has errors of first order, so its steps are as long as the tolerance is wide.
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
        Claim::same("Rk45: how it ends", "TooManySteps", kind(error.reason)),
    ];
    Row {
        case: "Coulomb friction as a sign",
        claims: falls.into_iter().chain(rest).collect(),
        survives: "none: smooth the sign, or stop at an event",
    }
}

/// The width of the smoothed sign, in m/s.
const EPS: f64 = 1e-4;

/// What is smooth can stand still nowhere but where nothing pulls: `tanh(v / eps) = PULL / GRIP`.
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
        case: "Coulomb friction as a smoothed sign",
        claims: vec![
            Claim::close(
                "speed of the block that should stand (m/s)",
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
        survives: "Rodas, Radau, Auto; but the block creeps",
    }
}

const TO_AND_FRO: f64 = 3.0;
const OMEGA: f64 = 2.0;

/// The times at which the block slips and sticks by turns until `t1`, with its place there.
fn stick_slip(t1: f64) -> Vec<(f64, f64)> {
    let method = Vern9::new().rtol(1e-12).atol(1e-12).h_max(0.1);
    let pull = |t: f64| TO_AND_FRO * (OMEGA * t).sin();
    let (mut t, mut x) = (0.0, 0.0);
    let mut changes = Vec::new();
    while t < t1 {
        let at_rest = FnSystem(|_t: f64, _x: &SVector<f64, 1>| SVector::zeros());
        let breaks = Event::new(|t, _x: &SVector<f64, 1>| pull(t).abs() - GRIP)
            .rising()
            .terminal();
        let stuck = method.solve_with(&at_rest, t, t1, [x], &[breaks]).expect("regular");
        t = stuck.last().0;
        changes.push((t, x));
        let side = pull(t).signum();
        let params = SlipParams {
            grip: GRIP,
            pull: TO_AND_FRO,
            omega: OMEGA,
            side,
        };
        let slip = Slip::new(params).expect("physical");
        let stops = Event::new(|_t, x: &SVector<f64, 2>| side * x[1]).falling().terminal();
        let slipped = method.solve_with(&slip, t, t1, [x, 0.0], &[stops]).expect("regular");
        (t, x) = (slipped.last().0, slipped.end()[0]);
        changes.push((t, x));
    }
    changes
}

/// The first two changes in closed form: the pull exceeds the grip, and the momentum is used up.
fn first_slip() -> [(f64, f64); 2] {
    let (amplitude, w) = (TO_AND_FRO, OMEGA);
    let start = (GRIP / amplitude).asin() / w;
    let speed = |t: f64| amplitude / w * ((w * start).cos() - (w * t).cos()) - GRIP * (t - start);
    // from the top of the speed, where the pull is down to the grip again, to where the pull is at its other extreme
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

/// Dry friction as two systems, the block that slips and the block that sticks, with events between them.
pub fn events(_: Size) -> Row {
    let changes = stick_slip(12.0 * PI / OMEGA);
    let [breaks, stops] = first_slip();
    let back = changes[3].1;
    Row {
        case: "Coulomb friction with events",
        claims: vec![
            Claim::close("it slips at (s)", breaks.0, changes[0].0, 1e-12),
            Claim::close("it sticks at (s)", stops.0, changes[1].0, 1e-11),
            Claim::close("on its way of (m)", stops.1, changes[1].1, 1e-10),
            Claim::at_most("from the start after a period (m)", 1e-11, back.abs()),
            Claim::same("changes in six periods", 24, changes.len()),
        ],
        survives: "every method with events",
    }
}

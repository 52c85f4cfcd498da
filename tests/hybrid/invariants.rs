//! Invariants of modes throughout their steps, from random states: slipping joints keep their direction, held ones
//! stand still, and no gap is negative.

use nalgebra::SVector;
use pendulum_core::hybrid::{Constraint, Hybrid, MAX_CONSTRAINTS, Status};
use pendulum_core::prelude::*;
use pendulum_core::{Method, Plant, Reason};
use testbed::random::{Random, share};

mechanism! {
    /// Two rods with dry axles; the lower one has stops before it folds.
    pub Rods {
        params { mu1: N m, mu2: N m, l: m, at_rest: 1, e: 1 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, taylor],
        body upper on ground {
            solids: [rod(1, [0, 0, 0], [0, -l, 0])],
            joint: revolute(z), coordinate: a, dry_friction: mu1, static_friction: at_rest*mu1,
        }
        body lower on upper {
            solids: [rod(1, [0, 0, 0], [0, -1, 0])],
            joint: revolute(z) at [0, -l, 0], coordinate: b, dry_friction: mu2, stop: [-1.5, 1] restitution(e),
        }
    }
}

const LIMITS: [f64; 2] = [-1.5, 1.0];

fn random_states(count: usize) -> impl Iterator<Item = (Rods, SVector<f64, 4>)> {
    let mut random = Random::new(38);
    (0..count).map(move |_| random_state(&mut random))
}

fn random_state(random: &mut Random) -> (Rods, SVector<f64, 4>) {
    let mut number = |low, high| random.between(low, high);
    let params = RodsParams {
        mu1: number(0.1, 1.0),
        mu2: number(0.05, 0.6),
        l: number(0.5, 1.5),
        at_rest: number(1.0, 1.5),
        e: number(0.0, 0.9),
    };
    let start = [
        number(-3.0, 3.0),
        number(-1.5, 1.0),
        number(-4.0, 4.0),
        number(-4.0, 4.0),
    ];
    (Rods::new(params).expect("physical"), SVector::from(start))
}

/// First invariant violated on the way to `t1`, if any: by rates above `noise`, or gaps below `-within`.
fn broken<M>(
    model: &Rods,
    method: &M,
    t1: f64,
    start: SVector<f64, 4>,
    (noise, within): (f64, f64),
) -> Result<Option<String>, Reason>
where
    M: Method<Rods, f64, 4>,
{
    let mut stepper = method.stepper(model, 0.0, t1, start)?;
    while let Some(step) = stepper.step()? {
        let (_, mode) = stepper.mode().expect("hybrid");
        let dense = stepper.dense();
        for theta in [0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0] {
            let h = step.t1 - step.t0;
            let t = step.t0 + theta * h;
            let x = if theta == 0.0 { step.x0 } else { dense.at(t) };
            for n in 0..2 {
                let (value, rate) = (x[n], x[n + 2]);
                let goes = match mode.0[n] {
                    Status::Forward => rate >= -noise,
                    Status::Backward => rate <= noise,
                    Status::Free => true,
                    _ => rate == 0.0,
                };
                let is_within = n == 0 || LIMITS[0] - within <= value && value <= LIMITS[1] + within;
                if !goes || !is_within {
                    let status = mode.0[n];
                    return Ok(Some(format!("{status:?} at {t}, {theta} of {h:e}: {value}, {rate:e}")));
                }
            }
        }
    }
    Ok(None)
}

fn check<M: Method<Rods, f64, 4>>(what: &str, method: &M, allowed: (f64, f64)) {
    for (nth, (model, start)) in random_states(share(400)).enumerate() {
        let found = broken(&model, method, 6.0, start, allowed);
        assert_eq!(found, Ok(None), "{what}, start {nth}");
    }
}

#[test]
fn modes_keep_their_promises() {
    macro_rules! check {
        ($($method:ident $tolerance:literal within $noise:expr),*) => { $(
            let method = $method::new().rtol($tolerance).atol($tolerance);
            // right after an impact a gap is only as accurate as the polynomial
            check(concat!(stringify!($method), " ", $tolerance), &method, ($noise, 0.1 * $tolerance));
        )* };
    }
    check!(
        Tsit5 1e-3 within 1e-12, Tsit5 1e-4 within 1e-12, Vern9 1e-10 within 1e-12, Taylor 1e-6 within 1e-12,
        // their polynomials do not start with the slope of the motion
        Rodas5P 1e-3 within 1e-3, Rodas5P 1e-7 within 1e-7, Radau5 1e-3 within 1e-3, Auto 1e-3 within 1e-3
    );
}

mechanism! {
    /// A block pressed against a stop by its spring.
    pub Pressed {
        params { k: N/m, pull: N, e: 1, high: m }
        generate: [rhs, jacobian],
        body block on ground {
            mass: 1, joint: prismatic(x), coordinate: x, spring: (k, 0), friction: 0.5, torque: pull*cos(0.7 rad/s*t),
            stop: [-2, high] restitution(e),
        }
    }
}

/// Rebounds that become lower than the tolerance still end, although a long step does not resolve them.
#[test]
fn rebounds_lower_than_the_tolerance_come_to_rest() {
    fn steps<M: Method<Pressed, f64, 2>>(method: &M) -> usize {
        let mut random = Random::new(12);
        let mut number = |low, high| random.between(low, high);
        let steps = (0..100).map(|_| {
            let params = PressedParams {
                k: number(15.0, 20.0),
                pull: number(0.5, 1.5),
                e: number(0.1, 0.5),
                high: number(-0.2, -0.15),
            };
            let start = [params.high - number(0.01, 1.0), number(-1.0, 1.0)];
            let model = Pressed::new(params).expect("physical");
            let mut stepper = method
                .stepper(&model, 0.0, 12.0, SVector::from(start))
                .expect("regular");
            stepper.run().expect("regular");
            let (_, mode) = stepper.mode().expect("hybrid");
            assert_eq!(mode.0[0], Status::High);
            stepper.statistics().accepted
        });
        steps.max().expect("some")
    }
    for tolerance in [1e-3, 1e-5] {
        let radau = steps(&Radau5::new().rtol(tolerance).atol(tolerance));
        let rosenbrock = steps(&Rodas5P::new().rtol(tolerance).atol(tolerance));
        let explicit = steps(&Tsit5::new().rtol(tolerance).atol(tolerance));
        assert!(
            radau.max(rosenbrock).max(explicit) < 150,
            "{radau} {rosenbrock} {explicit}"
        );
    }
}

/// Rodas5P at 1e-3 took a million steps from some of these states: each step ended short of the time at which its
/// polynomial touched a limit.
#[test]
fn steps_do_not_creep_towards_the_end_of_a_mode() {
    fn steps<M: Method<Rods, f64, 4>>(method: &M) -> usize {
        let steps = random_states(300).map(|(model, start)| {
            let mut stepper = method.stepper(&model, 0.0, 6.0, start).expect("regular");
            stepper.run().expect("regular");
            stepper.statistics().accepted
        });
        steps.max().expect("some")
    }
    let tolerance = 1e-3;
    let stiff = steps(&Rodas5P::new().rtol(tolerance).atol(tolerance));
    let other = steps(&Tsit5::new().rtol(tolerance).atol(tolerance));
    assert!(stiff < 2 * other, "{stiff} {other}");
}

mechanism! {
    /// A block pushed to a stop by a force that is NaN for 2 ms.
    pub Numberless {
        params { c: N/s = 1, middle: s = 0.31, half: s = 1e-3 }
        generate: [rhs, jacobian],
        body block on ground {
            mass: 1, joint: prismatic(x), coordinate: x,
            torque: -c*sqrt((t - middle)^2 - half^2), dry_friction: 0.1, stop: [0, 1] restitution(0.5),
        }
    }
}

#[test]
fn a_force_that_is_no_number_ends_a_search() {
    let mut random = Random::new(7);
    for _ in 0..share(400) {
        let params = NumberlessParams {
            middle: random.between(0.1, 1.0),
            half: random.between(1e-7, 1e-2),
            ..NumberlessParams::default()
        };
        let model = Numberless::new(params).expect("physical");
        let start = [random.between(0.0, 1.0), random.between(-2.0, 2.0)];
        macro_rules! each {
            ($($method:ident),*) => { $(
                // steps may pass over the 2 ms
                match $method::new().rtol(1e-4).atol(1e-4).stepper(&model, 0.0, 2.0, start).map(|mut way| way.run()) {
                    Ok(Ok(end)) => assert!(end.iter().all(|x| x.is_finite())),
                    Ok(Err(reason)) | Err(reason) => assert!(reason.to_string().contains("finite"), "{reason}"),
                }
            )* };
        }
        each!(Tsit5, Vern9, Rodas5P, Auto);
    }
}

/// A hand-written ball without the response to forces at its floor.
struct Unanswered;

impl System<f64, 2> for Unanswered {
    fn rhs(&self, t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        self.eval(t, x, &[0.0; MAX_CONSTRAINTS])
    }

    fn hybrid(&self) -> Option<&dyn Hybrid<f64, 2>> {
        Some(self)
    }
}

impl Plant<f64, 2> for Unanswered {
    type Given = [f64; MAX_CONSTRAINTS];

    fn eval(&self, _t: f64, x: &SVector<f64, 2>, forces: &[f64; MAX_CONSTRAINTS]) -> SVector<f64, 2> {
        SVector::from([x[1], forces[0] - 9.81])
    }

    fn constraints(&self) -> &[Constraint<'_>] {
        const {
            &[Constraint {
                name: "floor",
                rate: &[(1, 1)],
            }]
        }
    }

    fn measures(&self, _t: f64, x: &SVector<f64, 2>) -> [[f64; 2]; MAX_CONSTRAINTS] {
        let mut measures = [[0.0; 2]; MAX_CONSTRAINTS];
        measures[0] = [x[0], x[1]];
        measures
    }
}

#[test]
#[should_panic(expected = "a model with constraints implements `Plant::response`")]
fn a_model_with_constraints_says_what_forces_along_them_do() {
    let _ = Tsit5::new().solve(&Unanswered, 0.0, 1.0, [1.0, 0.0]);
}

mechanism! {
    /// A ball in a box with shaking walls.
    pub Shaker {
        params { a1: m, a2: m, w1: rad/s, w2: rad/s, e: 1, f: N s/m }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian],
        point centre on ball at [0, 0, 0],
        wall left { gap: centre.x + 1 + a1*sin(w1*t), restitution: e }
        wall right { gap: 1 - centre.x + a2*sin(w2*t) + centre.y/10, restitution: e }
        wall floor { gap: centre.y + 1 - a2*sin(w1*t) + centre.x^2/20 m, restitution: e }
        wall top { gap: 1 - centre.y + a1*sin(w2*t), restitution: e }
        body across on ground { joint: prismatic(x), coordinate: x }
        body ball on across { mass: 1, joint: prismatic(y), coordinate: y, friction: f }
    }
}

/// Implicit methods, whose polynomials touch the floor at the start of a step, missed it later in the step.
#[test]
fn a_wall_is_met_after_a_zero_that_was_disproved() {
    let params = ShakerParams {
        a1: 0.16652099885189273,
        a2: 0.1773622175643687,
        w1: 22.10200705869909,
        w2: 11.656806107711441,
        e: 0.43121764558168835,
        f: 0.2423172464180806,
    };
    let model = Shaker::new(params).expect("physical");
    let start = [
        -0.17317462758397206,
        -0.04431813540504825,
        -2.6567194224065496,
        -0.46845387127316407,
    ];
    let truth = Vern9::new()
        .rtol(1e-11)
        .atol(1e-11)
        .solve(&model, 0.0, 3.0, start)
        .expect("regular")
        .end();
    macro_rules! near {
        ($($method:ident),*) => { $(
            let method = $method::new().rtol(1e-3).atol(1e-3);
            let found = method.solve(&model, 0.0, 3.0, start).expect("regular").end();
            assert!((found - truth).amax() < 1e-3, "{}: {found} {truth}", stringify!($method));
        )* };
    }
    near!(Rodas4, Rodas5P, Radau5, Tsit5);
}

mechanism! {
    /// A block on a spring and a dry carriage, in a box whose walls move slowly.
    pub Crate {
        params { mu: N, e: 1, d: m, g: m/s^2, o: rad/s, k: N/m }
        gravity: [0, -g, 0],
        generate: [rhs, jacobian],
        body carriage on ground { mass: 0.5, joint: prismatic(x), coordinate: x, dry_friction: mu }
        body block on carriage { mass: 1, joint: prismatic(y), coordinate: y, spring: (k, 0.8 m) }
        point p on block at [0, 0, 0],
        wall roof { gap: 1 m - p.y + 0.2*p.x + d*sin(4*o*t), restitution: e }
        wall left { gap: p.x + 1 m + d*sin(3*o*t), restitution: e }
        wall right { gap: 1 m - p.x + 0.3*p.y + d*cos(2*o*t), restitution: e }
        wall floor { gap: p.y + 1 m - 0.4*p.x + d*sin(5*o*t), restitution: e }
    }
}

/// A gap may close at the start of a long step and open in a short one: Radau5 took 46,923 and 20,627 such steps from
/// these states, and Rodas5P more than 50,000 from the second.
#[test]
fn steps_grow_again_behind_a_gap_that_opens_slowly() {
    let cases = [
        (
            [1.4640460809451248, 0.5915586028009855, 0.06470245314939857],
            [-2.5206068574941907, 1.0899722769377322, 44.94852658532555],
            [
                0.09668452386518589,
                -0.24821594143193643,
                0.5148767121653641,
                1.2458457743356082,
            ],
        ),
        (
            [0.8970039363211955, 0.14952254183082184, 0.1873135942225064],
            [-1.9202556730151636, 1.3447191006036423, 27.36194337040503],
            [
                -0.004775636622215362,
                0.2042362399048105,
                -1.3156458954432209,
                0.3994606205634055,
            ],
        ),
    ];
    for ([mu, e, d], [g, o, k], start) in cases {
        let model = Crate::new(CrateParams { mu, e, d, g, o, k }).expect("physical");
        macro_rules! steps {
            ($($method:ident),*) => { $(
                let method = $method::new().rtol(1e-3).atol(1e-3);
                let solution = method.solve(&model, 0.0, 5.0, start).expect("regular");
                let steps = solution.statistics().accepted;
                assert!(steps < 200, "{}: {steps} steps", stringify!($method));
            )* };
        }
        steps!(Radau5, Rodas5P, Vern9);
    }
}

//! Each trajectory of an ensemble equals the trajectory solved alone, bit for bit: on each instruction set, in full and
//! partial rounds of lanes, and whatever happens in neighbouring lanes.

use std::collections::BTreeSet;
use std::process::Command;

use nalgebra::SVector;
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::{Isa, Kernel, Lanes};
use pendulum_core::{Cast, EnsembleError, Reason};
use testbed::linkages::{Parallelogram, ParallelogramParams};

mechanism! {
    /// A pendulum that a torque may drive to infinity in finite time.
    Driven {
        params { k: N m = 0 }
        generate: [rhs, jacobian, energy, taylor, canonical],
        gravity: [0, -9.81, 0],
        body bob on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, torque: k*angle^3,
        }
    }
}

mechanism! {
    /// A pendulum held by friction, between two stops.
    Braked {
        generate: [rhs, jacobian, energy, taylor, canonical],
        gravity: [0, -9.81, 0],
        body bob on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle,
            dry_friction: 1.5, stop: [-0.8, 1] restitution(0.5),
        }
    }
}

/// Kernel that returns the number of lanes in a register.
struct CountLanes;

impl Kernel<f64> for CountLanes {
    type Output = usize;

    fn run<V: Lanes<Scalar = f64>>(self) -> usize {
        V::LANES
    }
}

/// Numbers of trajectories that fill rounds of `lanes`, leave one lane empty, or exceed them by one.
fn counts(lanes: usize) -> BTreeSet<usize> {
    let w = lanes.max(1);
    let all = [1, w - 1, w, w + 1, 2 * w - 1, 3 * w + 1];
    all.into_iter().filter(|&count| count > 0).collect()
}

/// Last state of a trajectory, with the time and reason if it stopped early.
type End = ([u64; 2], Option<(f64, Reason)>);

fn bits(x: &SVector<f64, 2>) -> [u64; 2] {
    (*x).map(f64::to_bits).into()
}

/// Ends of an ensemble.
fn ends(ended: Result<Vec<SVector<f64, 2>>, EnsembleError<f64, 2>>) -> Vec<End> {
    let (x, stopped) = match ended {
        Ok(x) => (x, Vec::new()),
        Err(EnsembleError::Stopped { x, stopped }) => (x, stopped),
        Err(error) => panic!("{error}"),
    };
    let why = |n: usize| stopped.iter().find(|stopped| stopped.index == n);
    let end = |(n, x)| (bits(x), why(n).map(|stopped| (stopped.t, stopped.reason)));
    x.iter().enumerate().map(end).collect()
}

/// Compares ensembles of a scene with its trajectories solved alone, and returns how many stop early.
///
/// The method advances `registers` registers side by side, or single trajectories if this is 0. Trajectory `n` of the
/// model `models[n % models.len()]` starts from `start(n)`.
fn assert_alone<A, M>(
    method: A,
    registers: usize,
    models: &[M],
    t1: f64,
    start: impl Fn(usize) -> [f64; 2],
) -> [usize; 2]
where
    A: Ensemble<M, f64, 2> + Method<M::In<f64>, f64, 2>,
    M: Cast<2> + Clone,
{
    let most = *counts(registers * Isa::widest().run(CountLanes)).last().expect("some");
    let model = |n: usize| models[n % models.len()].clone();
    let alone = |n: usize| -> End {
        let (model, start) = (model(n).cast::<f64>(), start(n));
        match method.solve(&model, 0.0, t1, start) {
            Ok(solution) => (bits(&solution.end()), None),
            Err(error) => (bits(&error.x()), Some((error.t(), error.reason))),
        }
    };
    let alone: Vec<End> = (0..most).map(alone).collect();
    for isa in Isa::available() {
        for count in counts(registers * isa.run(CountLanes)) {
            let mut own: Vec<M> = (0..count).map(model).collect();
            own.truncate(if models.len() == 1 { 1 } else { count });
            let starts: Vec<_> = (0..count).map(|n| start(n).into()).collect();
            let differ = ends(method.ensemble_on(isa, &own, 0.0, t1, &starts));
            assert!(
                differ == alone[..count],
                "{count} on {isa:?}: {differ:?}, not {alone:?}"
            );
            let starts = vec![starts[0]; count];
            let equal = ends(method.ensemble_on(isa, &own[..1], 0.0, t1, &starts));
            assert!(
                equal.iter().all(|end| *end == alone[0]),
                "{count} equal on {isa:?}: {equal:?}, not {:?}",
                alone[0]
            );
        }
    }
    [alone.iter().filter(|(_, stopped)| stopped.is_some()).count(), most]
}

/// Calls a macro for each method, with the number of registers that it advances side by side without observers.
macro_rules! each_method {
    ($scene:ident) => {
        $scene!(Rk4::new(0.02), 4);
        $scene!(Rk45::new().rtol(1e-3).atol(1e-3).max_steps(60), 2);
        $scene!(Tsit5::new().rtol(1e-3).atol(1e-3).max_steps(60), 2);
        $scene!(Vern7::new().rtol(1e-3).atol(1e-3).max_steps(60), 2);
        $scene!(Vern9::new().rtol(1e-3).atol(1e-3).max_steps(60), 2);
        $scene!(Taylor::new().rtol(1e-3).atol(1e-3).max_steps(60), 1);
        $scene!(Rodas4::new().rtol(1e-3).atol(1e-3).max_steps(60), 1);
        $scene!(Rodas5P::new().rtol(1e-3).atol(1e-3).max_steps(60), 1);
        $scene!(Auto::new().rtol(1e-3).atol(1e-3).max_steps(60), 1);
        $scene!(Radau5::new().rtol(1e-3).atol(1e-3).max_steps(60), 0);
        $scene!(Gauss4::new(0.02), 0);
        $scene!(Gauss6::new(0.02), 0);
    };
}

fn driven(k: f64) -> Driven {
    Driven::new(DrivenParams { k }).expect("physical")
}

#[test]
fn smooth_motions() {
    macro_rules! smooth {
        ($method:expr, $registers:expr) => {
            let start = |n: usize| [0.05 * n as f64 - 0.5, 0.3];
            let [stopped, _] = assert_alone($method, $registers, &[driven(0.0)], 0.4, start);
            assert_eq!(stopped, 0);
        };
    }
    each_method!(smooth);
}

#[test]
fn motions_of_which_some_fail() {
    macro_rules! failing {
        ($method:expr, $registers:expr) => {
            let start = |n: usize| [2.0 + 0.01 * n as f64, 1.0];
            let models = [30.0, 0.0, 0.0, 20.0, 0.1].map(driven);
            let [stopped, of] = assert_alone($method, $registers, &models, 0.6, start);
            assert!(stopped >= of.div_ceil(5) && stopped < of, "{stopped} of {of}");
        };
    }
    each_method!(failing);
}

#[test]
fn loops_that_come_to_a_toggle() {
    let model = Parallelogram::new(ParallelogramParams::default()).expect("physical");
    macro_rules! looped {
        ($method:expr, $registers:expr) => {
            let start = |n: usize| [0.1 + 0.02 * n as f64, 15.0 - 0.7 * (n % 20) as f64];
            let [stopped, _] = assert_alone($method, $registers, std::slice::from_ref(&model), 0.3, start);
            assert!(stopped > 0);
        };
    }
    each_method!(looped);
}

#[test]
fn modes_that_change() {
    let model = Braked::new(BrakedParams::default()).expect("physical");
    macro_rules! hybrid {
        ($method:expr, $registers:expr) => {
            let start = |n: usize| [0.02 * n as f64 - 0.5, 3.0 - 0.2 * n as f64];
            let registers = usize::from($registers > 0);
            let [stopped, _] = assert_alone($method, registers, std::slice::from_ref(&model), 1.0, start);
            assert_eq!(stopped, 0);
        };
    }
    each_method!(hybrid);
}

#[test]
fn events_that_end_motions_or_reset_them() {
    let passes = |at: f64| Event::new(move |_, x: &SVector<f64, 2>| x[0] - at);
    let events = [
        vec![],
        vec![passes(0.2), passes(0.4).terminal()],
        vec![passes(0.3).reset(|_, x| SVector::from([x[0], -x[1]]))],
        vec![passes(0.25), Event::new(|t, _| if t < 0.2 { 1.0 } else { f64::NAN })],
    ];
    let of = |n: usize| events[n % 4].as_slice();
    let model = driven(0.0);
    let start = |n: usize| SVector::from([0.01 * n as f64, 1.5]);
    macro_rules! observed {
        ($method:expr, $registers:expr) => {
            let method = $method;
            let most = *counts($registers * Isa::widest().run(CountLanes))
                .last()
                .expect("some");
            let alone: Vec<_> = (0..most)
                .map(|n| method.solve_with(&model, 0.0, 0.4, start(n), of(n)))
                .collect();
            for isa in Isa::available() {
                for count in counts($registers * isa.run(CountLanes)) {
                    let starts: Vec<_> = (0..count).map(start).collect();
                    let mut seen: Vec<_> = starts.iter().map(|&x| Solution::start(0.0, x)).collect();
                    let ends = ends(method.observe_on(
                        isa,
                        std::slice::from_ref(&model),
                        (0.0, 0.4),
                        &starts,
                        of,
                        &mut seen,
                    ));
                    for (n, (seen, end)) in seen.iter().zip(ends).enumerate() {
                        let (solution, stopped) = match &alone[n] {
                            Ok(solution) => (solution, None),
                            Err(error) => (&*error.solution, Some(error.reason)),
                        };
                        assert!(
                            seen == solution,
                            "{n} of {count} on {isa:?}: {seen:?}, not {solution:?}"
                        );
                        assert_eq!(
                            end.1.map(|(_, reason)| reason),
                            stopped,
                            "{n} of {count} on {isa:?}"
                        );
                        assert_eq!(end.0, bits(&solution.end()), "{n} of {count} on {isa:?}");
                    }
                }
            }
        };
    }
    each_method!(observed);
}

#[test]
fn what_solutions_report_alone_they_report_in_lanes() {
    let fast = [Event::new(|t, _x: &SVector<f64, 2>| (1e5 * t).sin())];
    let model = driven(0.0);
    let starts: Vec<_> = (0..9).map(|n| SVector::from([1e-9 * f64::from(n), 0.0])).collect();
    for isa in Isa::available() {
        let mut seen: Vec<_> = starts.iter().map(|&x| Solution::start(0.0, x)).collect();
        let method = Tsit5::new();
        method
            .observe_on(
                isa,
                std::slice::from_ref(&model),
                (0.0, 0.1),
                &starts,
                |_| &fast,
                &mut seen,
            )
            .expect("regular");
        for (n, seen) in seen.iter().enumerate() {
            let alone = method.solve_with(&model, 0.0, 0.1, starts[n], &fast).expect("regular");
            assert!(*seen == alone, "{n} on {isa:?}");
            assert_eq!(seen.missed(), alone.missed());
            assert!(!seen.missed().is_empty(), "{n} on {isa:?}");
            assert_eq!(seen.below_tolerance(), alone.below_tolerance());
            assert_eq!(
                seen.below_tolerance().len(),
                if n == 0 { 0 } else { 2 },
                "{n} on {isa:?}"
            );
        }
    }
}

#[test]
fn the_environment_keeps_lanes_to_narrower_registers() {
    let names: Vec<String> = Isa::available().map(|isa| format!("{isa:?}")).collect();
    if let Ok(asked) = std::env::var("PENDULUM_ISA") {
        assert!(names[0] == asked || !names.contains(&asked), "{asked}: {names:?}");
        return;
    }
    for name in names {
        let mut again = Command::new(std::env::current_exe().expect("this program"));
        again.args(["--exact", "alone::the_environment_keeps_lanes_to_narrower_registers"]);
        let output = again.env("PENDULUM_ISA", &name).output().expect("it runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
    }
}

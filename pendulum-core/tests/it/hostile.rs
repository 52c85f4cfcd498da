//! Invalid and extreme settings, spans, initial conditions, right-hand sides and events. Every method must end after
//! bounded work, with finite states or with an error that says what to do.

use std::cell::Cell;

use pendulum_core::method::{Adaptive, Estimates, Fixed, OneStep};
use pendulum_core::prelude::*;
use pendulum_core::{Reason, SolveError};

use crate::methods::{Driven, each_adaptive, each_fixed};

const NAN: f64 = f64::NAN;
const INFINITY: f64 = f64::INFINITY;

/// `x'' = -x` with a disturbance added to the derivatives.
type Hostile<'a> = Driven<&'a dyn Fn(f64, &SVector<f64, 2>) -> SVector<f64, 2>, 2>;

/// Maximum number of steps of a single integration.
const MOST_STEPS: usize = 200;
/// Maximum number of evaluations of the right-hand side and of event functions in a single integration.
const MOST_WORK: usize = 1_000_000;

/// Problem for a method, apart from its settings.
#[derive(Clone, Copy)]
struct Task {
    span: (f64, f64),
    start: [f64; 2],
    disturbance: fn(f64, f64) -> f64,
    event: Option<fn(f64, f64) -> f64>,
    resets: bool,
}

const TASK: Task = Task {
    span: (0.0, 1.0),
    start: [1.0, 0.0],
    disturbance: |_t, _x| 0.0,
    event: None,
    resets: false,
};

thread_local! {
    /// Number of integrations.
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

impl Task {
    /// Runs the integration and checks that it ends with finite states or with a reason.
    fn run<M>(&self, name: &str, method: &M) -> Result<(), Reason>
    where
        M: for<'b> Method<Hostile<'b>, f64, 2>,
    {
        let work = Cell::new(0);
        let count = || {
            work.set(work.get() + 1);
            assert!(work.get() < MOST_WORK, "{name}: it does not end");
        };
        let slopes = |t: f64, x: &SVector<f64, 2>| {
            count();
            SVector::from([x[1], -x[0] + (self.disturbance)(t, x[0])])
        };
        let system: Hostile<'_> = Driven::new(SMatrix::from([[0.0, -1.0], [1.0, 0.0]]), &slopes);
        let event = self.event.map(|function| {
            let event = Event::new(move |t, x: &SVector<f64, 2>| {
                count();
                function(t, x[0])
            });
            if self.resets { event.reset(|_t, x| *x) } else { event }
        });
        let ended = method.solve_with(&system, self.span.0, self.span.1, self.start, event.as_slice());
        COUNT.set(COUNT.get() + 1);
        let is_finite = |solution: &Solution<f64, 2>| {
            solution
                .points()
                .all(|(t, x)| t.is_finite() && x.iter().all(|x| x.is_finite()))
        };
        match ended {
            Ok(solution) => {
                assert!(is_finite(&solution), "{name}: {solution:?}");
                assert_eq!(solution.last().0, self.span.1, "{name}");
                Ok(())
            }
            Err(SolveError { reason, solution, .. }) => {
                // For invalid input the state is the initial condition as passed.
                let is_invalid = matches!(reason, Reason::InvalidInput { .. });
                assert!(is_invalid || is_finite(&solution), "{name}: {reason}");
                // The message states a fact and an action.
                let message = reason.to_string();
                assert!(message.contains(':') || message.contains(';'), "{name}: {message}");
                Err(reason)
            }
        }
    }
}

/// Invalid or extreme values of settings.
const NUMBERS: [f64; 12] = [
    0.0, -0.0, -1.0, NAN, INFINITY, -INFINITY, 1e300, 1e-300, 5e-324, 1e-17, 1.0, 1e9,
];

const SPANS: [(f64, f64); 16] = [
    (0.0, 0.0),
    (1.0, 0.0),
    (NAN, 1.0),
    (0.0, NAN),
    (-INFINITY, 1.0),
    (0.0, INFINITY),
    (INFINITY, INFINITY),
    (0.0, 5e-324),
    (-1e-310, 1e-310),
    (0.0, 1e-300),
    (1.0, 1.0 + f64::EPSILON),
    (1.0, 1.0 - 64.0 * f64::EPSILON),
    (0.0, 1e300),
    (-1e308, 1e308),
    (1e300, 1.1e300),
    (1e16, 1e16 + 8.0),
];

const STARTS: [[f64; 2]; 10] = [
    [0.0, 0.0],
    [-0.0, 5e-324],
    [NAN, 0.0],
    [0.0, NAN],
    [INFINITY, 0.0],
    [0.0, -INFINITY],
    [1e300, -1e300],
    [f64::MAX, f64::MAX],
    [1e-300, 1e300],
    [1e-310, 0.0],
];

const DISTURBANCES: [fn(f64, f64) -> f64; 18] = [
    |_, _| NAN,
    |_, _| INFINITY,
    |t, _| if t > 0.5 { NAN } else { 0.0 },
    |t, _| if t > 0.5 { -INFINITY } else { 0.0 },
    |t, _| if t == 0.0 { NAN } else { 0.0 },
    |t, _| if t > 0.0 { NAN } else { 0.0 },
    |t, _| if (0.3..0.4).contains(&t) { NAN } else { 0.0 },
    |_, x| if x < 0.9 { NAN } else { 0.0 },
    |_, _| 1e300,
    |t, _| if t > 0.5 { f64::MAX } else { f64::MIN },
    |_, x| 1e3 * x * x,
    |_, x| 1.0 / (x - 0.9),
    |_, x| (x - 0.9).sqrt(),
    |_, x| -1e300 * x,
    |t, _| 1.0 / (t - 0.5),
    |t, _| (1e6 * t).sin().signum(),
    |t, _| 1e9 * (1e9 * t).sin(),
    |_, _| 5e-324,
];

const EVENTS: [fn(f64, f64) -> f64; 18] = [
    |_, _| NAN,
    |_, _| INFINITY,
    |_, _| 0.0,
    |_, _| -0.0,
    |_, _| 5e-324,
    |_, _| f64::MIN,
    |t, _| if t > 0.5 { NAN } else { 1.0 },
    |t, _| if t > 0.5 { NAN } else { 0.0 },
    |t, _| if t == 0.0 { 0.0 } else { 1.0 },
    |t, _| if t > 0.5 { -1.0 } else { 1.0 },
    |t, _| if t > 0.5 { 0.0 } else { 1.0 },
    |t, _| if t > 0.5 { -f64::MAX } else { f64::MAX },
    |t, _| (1e4 * t).sin(),
    |t, _| (1e3 * t).sin().signum(),
    |t, _| (10.0 * t).tan(),
    |t, _| (t - 0.5) * (t - 0.5),
    |t, _| 1e-300 * (t - 0.5),
    |_, x| x - 1.0,
];

/// Runs all tasks with the usual settings.
fn each_task<M>(name: &str, method: &M)
where
    M: for<'a> Method<Hostile<'a>, f64, 2>,
{
    let run = |what: &str, index: usize, task: Task| {
        let ended = task.run(&format!("{name}, {what} {index}"), method);
        (what == "usual").then(|| ended.expect("nothing is wrong"));
    };
    run("usual", 0, TASK);
    for (index, &span) in SPANS.iter().enumerate() {
        run("span", index, Task { span, ..TASK });
    }
    for (index, &start) in STARTS.iter().enumerate() {
        run("start", index, Task { start, ..TASK });
    }
    for (index, &disturbance) in DISTURBANCES.iter().enumerate() {
        run("disturbance", index, Task { disturbance, ..TASK });
    }
    for (index, &event) in EVENTS.iter().enumerate() {
        let event = Some(event);
        for resets in [false, true] {
            run("event", index, Task { event, resets, ..TASK });
        }
    }
}

#[test]
fn hostile_settings_end_well_or_say_why_not() {
    fn adaptive<F>(name: &str)
    where
        F: for<'a> OneStep<Hostile<'a>, f64, 2> + Estimates + Default,
    {
        let method = || Adaptive::<F>::new().max_steps(MOST_STEPS);
        each_task(name, &method());
        for (index, &number) in NUMBERS.iter().enumerate() {
            let settings: [(&str, Adaptive<F>); 5] = [
                ("rtol", method().rtol(number)),
                ("atol", method().atol(number)),
                ("h0", method().h0(number)),
                ("h_min", method().h_min(number)),
                ("h_max", method().h_max(number)),
            ];
            for (what, method) in settings {
                let ended = TASK.run(&format!("{name}, {what} {index}"), &method);
                // Invalid settings are rejected by name, the others accepted.
                let refused = matches!(ended, Err(Reason::InvalidInput { what: named, .. }) if named == what);
                let is_sensible = match what {
                    "rtol" => (10.0 * f64::EPSILON..1.0).contains(&number),
                    "h_min" => (0.0..INFINITY).contains(&number),
                    "h_max" => number > f64::EPSILON,
                    _ => number > 0.0 && number < INFINITY,
                };
                assert_eq!(!refused, is_sensible, "{name}, {what} = {number:e}: {ended:?}");
            }
        }
        for most in [0, 1] {
            let ended = TASK.run(name, &method().max_steps(most));
            assert_eq!(ended, Err(Reason::TooManySteps { max_steps: most }), "{name}");
        }
    }
    fn fixed<F>(name: &str)
    where
        F: for<'a> OneStep<Hostile<'a>, f64, 2> + Default,
    {
        each_task(name, &Fixed::<F>::new(0.05));
        for number in NUMBERS {
            let ended = TASK.run(name, &Fixed::<F>::new(number));
            let refused = matches!(ended, Err(Reason::InvalidInput { what: "h", .. }));
            // the smallest step is 16 ulps of the time
            assert_eq!(
                !refused,
                number > 1e-15 && number < INFINITY,
                "{name}: {number:e}, {ended:?}"
            );
        }
    }
    each_adaptive!(adaptive());
    each_fixed!(fixed());
    assert!(COUNT.get() > 1000, "{}", COUNT.get());
}

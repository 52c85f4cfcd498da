//! Derivatives of trajectories by initial conditions and parameters.

use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use pendulum_core::sensitivity::{self, Sensitivity, Variable};
use pendulum_core::{Parametric, System, stability};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

use crate::states::{
    Linkage, LinkageParams, Lorenz, LorenzParams, Mixed, MixedParams, Robertson, RobertsonParams, Servo, ServoParams,
};

use Variable::{Parameter, Start};

/// Derivatives by differences of order six of solutions with other initial conditions and parameters.
fn by_differences<M, X, const N: usize, const P: usize, const K: usize>(
    method: &X,
    model: &M,
    (t0, t1): (f64, f64),
    x0: [f64; N],
    variables: [Variable; K],
) -> SMatrix<f64, N, K>
where
    M: Parametric<P>,
    M::Of<f64>: System<f64, N>,
    X: Method<M::Of<f64>, f64, N>,
{
    const STENCIL: [(f64, f64); 6] = [
        (-3.0, -1.0),
        (-2.0, 9.0),
        (-1.0, -45.0),
        (1.0, 45.0),
        (2.0, -9.0),
        (3.0, 1.0),
    ];
    let columns = variables.map(|variable| {
        let (mut start, mut parameters) = (x0, model.parameters());
        let mut sum = SVector::<f64, N>::zeros();
        let size = match variable {
            Start(n) => x0[n].abs().max(1.0),
            Parameter(n) => parameters[n].abs(),
        };
        let h = 2e-4 * size;
        for (steps, weight) in STENCIL {
            let own = match variable {
                Start(n) => &mut start[n],
                Parameter(n) => &mut parameters[n],
            };
            let kept = *own;
            *own += steps * h;
            let end = method
                .solve(&model.with_parameters(parameters), t0, t1, start)
                .expect("regular")
                .end();
            match variable {
                Start(n) => start[n] = kept,
                Parameter(n) => parameters[n] = kept,
            }
            sum += end * weight;
        }
        sum / (60.0 * h)
    });
    SMatrix::from_columns(&columns)
}

#[track_caller]
fn close<const N: usize, const K: usize>(
    what: &str,
    ours: &SMatrix<f64, N, K>,
    theirs: &SMatrix<f64, N, K>,
    within: f64,
) {
    let error = (ours - theirs).amax() / (1.0 + theirs.amax());
    println!("{what}: {error:.1e}");
    assert!(error < within, "{what}: {error:e}\n{ours}{theirs}");
}

#[test]
fn a_regular_double_pendulum() {
    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    let x0 = [1.0, 0.5, 0.0, 0.0];
    let variables = [
        Start(0),
        Start(1),
        Start(2),
        Start(3),
        Parameter(0),
        Parameter(2),
        Parameter(5),
        Parameter(6),
    ];
    let tight = Vern9::new().rtol(1e-13).atol(1e-13);
    let expected = by_differences(&tight, &model, (0.0, 3.0), x0, variables);
    let check = |what: &str, motion: Sensitivity<4, 8>, within: f64| close(what, &motion.end().1, &expected, within);
    check(
        "Vern9",
        sensitivity::solve(&tight, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Vern7::new().rtol(1e-12).atol(1e-12);
    check(
        "Vern7",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Tsit5::new().rtol(1e-12).atol(1e-12);
    check(
        "Tsit5",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Rk45::new().rtol(1e-12).atol(1e-12);
    check(
        "Rk45",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Rk4::new(1e-3);
    check(
        "Rk4",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Taylor::new().rtol(1e-14).atol(1e-14);
    check(
        "Taylor",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Rodas5P::new().rtol(1e-11).atol(1e-11);
    check(
        "Rodas5P",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Rodas4::new().rtol(1e-10).atol(1e-10);
    check(
        "Rodas4",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-8,
    );
    let method = Radau5::new().rtol(1e-12).atol(1e-12);
    check(
        "Radau5",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Auto::new().rtol(1e-12).atol(1e-12);
    check(
        "Auto",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Gauss6::new(2e-3);
    check(
        "Gauss6",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-9,
    );
    let method = Gauss4::new(1e-3);
    check(
        "Gauss4",
        sensitivity::solve(&method, &model, 0.0, 3.0, x0, variables).expect("regular"),
        1e-8,
    );
    // the first four are the transition matrix
    let transition = stability::transition(&model, 0.0, 3.0, x0, 1e-13).expect("regular");
    let motion =
        sensitivity::solve(&tight, &model, 0.0, 3.0, x0, [Start(0), Start(1), Start(2), Start(3)]).expect("regular");
    close("transition", &motion.end().1, &transition.1, 1e-10);
}

/// Runs a function on a deep stack: without optimisation, a Taylor series of dual numbers takes more than that of a test.
fn with_deep_stack<R: Send>(run: impl FnOnce() -> R + Send) -> R {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(1 << 26);
        let handle = thread.spawn_scoped(scope, run).expect("a thread");
        handle.join().expect("it ends")
    })
}

/// Checks a model with some methods against differences.
macro_rules! check {
    ($model:expr, $span:expr, $x0:expr, $variables:expr, $reference:expr, [$($method:expr => $within:expr),* $(,)?]) => {{
        let (model, span, x0, variables) = ($model, $span, $x0, $variables);
        let expected = by_differences(&$reference, &model, span, x0, variables);
        println!("{expected}");
        $(
            let solved = || sensitivity::solve(&$method, &model, span.0, span.1, x0, variables).expect("regular");
            let motion = with_deep_stack(solved);
            close(stringify!($method), &motion.end().1, &expected, $within);
        )*
    }};
}

#[test]
fn through_breakaway_and_stops() {
    let servo = Servo::new(ServoParams::default()).expect("physical");
    let tight = Vern9::new().rtol(1e-13).atol(1e-13);
    // the initial rate is held by friction: its effect is quadratic
    let all = [
        Start(0),
        Start(2),
        Parameter(0),
        Parameter(1),
        Parameter(2),
        Parameter(3),
        Parameter(4),
        Parameter(5),
        Parameter(6),
    ];
    // slipping after the breakaway
    check!(servo, (0.0, 0.3), [0.0; 4], all, tight, [
        Vern9::new().rtol(1e-13).atol(1e-13) => 1e-9,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-9,
        Rodas5P::new().rtol(1e-11).atol(1e-11) => 1e-9,
        Rk4::new(1e-3) => 1e-8,
    ]);
    // after the first rebound
    check!(servo, (0.0, 1.0), [0.0; 4], all, tight, [
        Vern9::new().rtol(1e-13).atol(1e-13) => 1e-9,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-9,
        Rk4::new(1e-3) => 1e-8,
    ]);
    // at rest at the stop
    check!(servo, (0.0, 6.0), [0.0; 4], all, tight, [
        Vern9::new().rtol(1e-13).atol(1e-13) => 1e-9,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-9,
    ]);
}

#[test]
fn of_loops_balls_and_states() {
    let tight = Vern9::new().rtol(1e-13).atol(1e-13);
    let linkage = Linkage::new(LinkageParams::default()).expect("physical");
    check!(linkage, (0.0, 1.0), [0.7, 0.0, 0.0], [Start(0), Start(1), Start(2), Parameter(0), Parameter(1), Parameter(2), Parameter(3)], tight, [
        Vern9::new().rtol(1e-12).atol(1e-12) => 1e-9,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-9,
    ]);
    let mixed = Mixed::new(MixedParams::default()).expect("physical");
    check!(mixed, (0.0, 2.0), [1.0, 0.0, 0.0, 0.0, 0.5, -0.7, 1.1, 0.3], [Start(4), Start(5), Start(7), Parameter(0), Parameter(1), Parameter(2), Parameter(3)], tight, [
        Vern9::new().rtol(1e-12).atol(1e-12) => 1e-9,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-9,
    ]);
    let lorenz = Lorenz::new(LorenzParams::default()).expect("valid");
    check!(lorenz, (0.0, 3.0), [1.0, 1.0, 20.0], [Start(0), Start(1), Start(2), Parameter(0), Parameter(1), Parameter(2)], tight, [
        Vern9::new().rtol(1e-13).atol(1e-13) => 1e-8,
        Taylor::new().rtol(1e-14).atol(1e-14) => 1e-8,
    ]);
    let robertson = Robertson::new(RobertsonParams::default()).expect("valid");
    check!(robertson, (0.0, 40.0), [1.0, 0.0, 0.0], [Start(0), Parameter(0), Parameter(1), Parameter(2)], Radau5::new().rtol(1e-12).atol(1e-16), [
        Radau5::new().rtol(1e-11).atol(1e-15) => 1e-8,
        Rodas5P::new().rtol(1e-10).atol(1e-14) => 1e-8,
    ]);
}

//! Times of tapes over those of compiled code: `cargo bench -p benches --bench tapes`. One evaluation, and ensembles of
//! 256 trajectories in lanes on one core, of which those of tapes are observed and padded as in `pendulum-runtime`.
//!
//! Each number is the median over some pairs of measurements.

mod ratio;

use std::hint::black_box;
use std::sync::Arc;

use nalgebra::SVector;
use pendulum_core::dense::Dense;
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::Isa;
use pendulum_core::tape::{Model, Tape};
use pendulum_core::{Cast, Need, Observer};
use testbed::robots::{Panda, PandaParams, Ur5, Ur5Params};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};
use testbed::source::{ROBOTS, SCENES, declaration};

use ratio::ratio;

/// Number of trajectories.
const COUNT: usize = 256;
/// Number of pairs of measurements.
const PAIRS: usize = 15;
/// End of the motions, in s.
const T1: f64 = 0.3;

fn main() {
    let params = DoublePendulumParams::default();
    let pendulum = DoublePendulum::new(params).expect("physical");
    compare::<_, 4, 4>(
        "double pendulum",
        &pendulum,
        &tape(SCENES, "DoublePendulum", &params.to_array()),
    );
    let ur5 = Ur5::new(Ur5Params::default()).expect("physical");
    compare::<_, 12, 16>("UR5", &ur5, &tape(ROBOTS, "Ur5", &[]));
    let panda = Panda::new(PandaParams::default()).expect("physical");
    compare::<_, 14, 16>("Panda", &panda, &tape(ROBOTS, "Panda", &[]));
}

/// Model of a declaration in a source, on a tape.
fn tape<const N: usize>(source: &str, name: &str, params: &[f64]) -> Model<f64, N> {
    let program = pendulum_codegen::program(declaration(source, name).parse().expect("tokens")).expect("a declaration");
    let tape: Arc<Tape> = Arc::new(pendulum_codegen::tape(&program).parse().expect("a tape"));
    tape.padded(params).expect("physical")
}

/// Observer that needs nothing of any step.
struct Idle;

impl<const N: usize> Observer<f64, N> for Idle {
    fn needs(&self, _t0: f64, _t1: f64) -> Need {
        Need::Nothing
    }

    fn step(&mut self, _dense: &Dense<'_, f64, N>) {}
}

/// States of `N` components, padded to `L`.
fn states<const N: usize, const L: usize>() -> Vec<SVector<f64, L>> {
    let component = |k: usize, n: usize| (0.37 * (k + 1) as f64 + n as f64).sin();
    let state = |k| SVector::from_fn(|n, _| if n < N { component(k, n) } else { 0.0 });
    (0..COUNT).map(state).collect()
}

/// Compares a model of `N` components with its tape, padded to `L`.
fn compare<M, const N: usize, const L: usize>(name: &str, compiled: &M, tape: &Model<f64, L>)
where
    M: Cast<N> + System<f64, N>,
{
    let (starts, padded) = (states::<N, N>(), states::<N, L>());
    let alone = over(
        || starts.iter().map(|x| compiled.rhs(0.0, black_box(x))[N - 1]).sum(),
        || padded.iter().map(|x| tape.rhs(0.0, black_box(x))[N - 1]).sum(),
    );
    println!("{name}, one evaluation: {alone:.2}");
    let (models, tapes) = (std::slice::from_ref(compiled), std::slice::from_ref(tape));
    macro_rules! ensembles {
        ($isa:ident $($name:ident $method:expr;)*) => {$(
            let of_compiled = || {
                let ends = $method.ensemble_on($isa, models, 0.0, T1, &starts);
                ends.expect("regular").iter().map(|x| x[0]).sum()
            };
            let of_tape = || {
                let mut observers: Vec<Idle> = (0..COUNT).map(|_| Idle).collect();
                let ends = $method.observe_on($isa, tapes, (0.0, T1), &padded, |_| &[], &mut observers);
                ends.expect("regular").iter().map(|x| x[0]).sum()
            };
            println!("{name}, {}, {:?}: {:.2}", stringify!($name), $isa, over(of_compiled, of_tape));
        )*};
    }
    for isa in Isa::available() {
        ensembles!(isa Rk4 Rk4::new(0.01); Tsit5 Tsit5::new(); Vern9 Vern9::new(););
    }
}

/// Ratio of the times of the second and of the first of two functions with the same result.
fn over(first: impl Fn() -> f64, second: impl Fn() -> f64) -> f64 {
    assert_eq!(first().to_bits(), second().to_bits(), "other bits");
    ratio(PAIRS, 1, second, first)
}

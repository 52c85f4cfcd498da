//! Ensembles compared with the same trajectories one by one: `cargo bench --bench ensembles`.
//!
//! Runs on one core. Each number is the median of ratios of times measured in turn.

use std::error::Error;
use std::fmt::Debug;
use std::time::Instant;

use nalgebra::SVector;
use pendulum_core::dense::Dense;
use pendulum_core::prelude::*;
use pendulum_core::{Need, Observer, Occurrence, Reason};

mechanism! {
    /// Two rods of 1 kg and 1 m, joined by a spring with a damper.
    Rods {
        params { k: N m/rad, c: N m s/rad }
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        generate: [rhs, jacobian],
        body upper on ground: arm { joint: revolute(z), coordinate: theta1, friction: 0.02 }
        body lower on upper: arm {
            joint: revolute(z) at [0, -1, 0], coordinate: theta2, spring: (k, 0), friction: c,
        }
    }
}

/// Number of rounds.
const ROUNDS: usize = 9;
/// Number of trajectories in each round.
const COUNT: usize = 128;
const T1: f64 = 10.0;
/// Number of stored states.
const SAMPLES: usize = 100;

fn main() -> Result<(), Box<dyn Error>> {
    let loose = ensemble(0.0, 0.0)?;
    compare("Tsit5", &Tsit5::new(), &loose)?;
    compare("Vern9", &Vern9::new().rtol(1e-10).atol(1e-10), &loose)?;
    compare("Rk4", &Rk4::new(0.01), &loose)?;
    // nearly rigid connection
    compare("Rodas5P", &Rodas5P::new(), &ensemble(1e5, 1e3)?)
}

/// Models and initial states.
type Members = (Vec<Rods>, Vec<SVector<f64, 4>>);

fn ensemble(k: f64, c: f64) -> Result<Members, Box<dyn Error>> {
    let share = |n: usize| n as f64 / COUNT as f64;
    let rods = |n| {
        Rods::new(RodsParams {
            k: k * (1.0 + share(n)),
            c,
        })
    };
    let models = (0..COUNT).map(rods).collect::<Result<_, _>>()?;
    let start = |n| SVector::from([3.0 * share(n), 0.1, 0.0, 0.0]);
    Ok((models, (0..COUNT).map(start).collect()))
}

/// Observer that samples the states at given times.
#[derive(PartialEq)]
struct Samples(Vec<SVector<f64, 4>>);

impl Samples {
    fn next(&self) -> f64 {
        T1 * self.0.len() as f64 / SAMPLES as f64
    }
}

impl Observer<f64, 4> for Samples {
    fn needs(&self, _t0: f64, t1: f64) -> Need {
        match self.next() < t1 {
            true => Need::Inside,
            false => Need::Nothing,
        }
    }

    fn step(&mut self, dense: &Dense<'_, f64, 4>) {
        while self.next() < dense.step().t1 {
            self.0.push(dense.at(self.next()));
        }
    }
}

/// Ratio of the times of single trajectories to the ensemble, for each kind of output.
fn compare<A>(name: &str, method: &A, members: &Members) -> Result<(), Box<dyn Error>>
where
    A: Method<Rods, f64, 4> + ObservedEnsemble<Rods, f64, 4>,
{
    let (models, starts) = members;
    let steps = method.solve(&models[1], 0.0, T1, starts[1])?.statistics().accepted;
    let end = |(model, &x)| method.stepper(model, 0.0, T1, x)?.run();
    let ends = ratio(
        || models.iter().zip(starts).map(end).collect::<Result<Vec<_>, _>>(),
        || method.ensemble(models, 0.0, T1, starts),
    );
    let passes = [Event::new(|_, x: &SVector<f64, 4>| x[0] + x[1])];
    let samples = followed(method, members, &[], |_| Samples(Vec::new()));
    let events = followed(method, members, &passes, |_| Vec::<Occurrence<f64, 4>>::new());
    let solutions = followed(method, members, &[], |x| Solution::start(0.0, x));
    println!(
        "{name}, {steps} steps: ends {ends:.2}, {SAMPLES} samples {samples:.2}, events {events:.2}, solutions \
         {solutions:.2}"
    );
    Ok(())
}

/// Like [`compare`], but with observers.
fn followed<A, O>(
    method: &A,
    (models, starts): &Members,
    events: &[Event<'_, f64, 4>],
    observer: impl Fn(SVector<f64, 4>) -> O,
) -> f64
where
    A: Method<Rods, f64, 4> + ObservedEnsemble<Rods, f64, 4>,
    O: Observer<f64, 4> + PartialEq,
{
    let follow = |(model, &x)| {
        let mut observer = observer(x);
        method.follow(model, 0.0, T1, x, events, &mut observer)?;
        Ok::<_, Reason>(observer)
    };
    ratio(
        || models.iter().zip(starts).map(follow).collect::<Result<Vec<_>, _>>(),
        || {
            let mut observers: Vec<_> = starts.iter().map(|&x| observer(x)).collect();
            let ended = method.observe(models, (0.0, T1), starts, |_| events, &mut observers);
            ended.map(|_| observers)
        },
    )
}

/// Median ratio of the times of two functions that return the same result, measured in turn.
fn ratio<R: PartialEq, E: Debug, F: Debug>(
    alone: impl Fn() -> Result<R, E>,
    in_lanes: impl Fn() -> Result<R, F>,
) -> f64 {
    let mut ratios: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let (start, first) = (Instant::now(), alone());
            let (between, second) = (Instant::now(), in_lanes());
            let end = Instant::now();
            match (first, second) {
                (Ok(first), Ok(second)) => assert!(first == second, "other bits"),
                (first, second) => panic!("{:?} {:?}", first.err(), second.err()),
            }
            (between - start).as_secs_f64() / (end - between).as_secs_f64()
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    ratios[ROUNDS / 2]
}

//! Ends of rough scenes by one method against those by another, from random starts.
//!
//! `PENDULUM_ROUGH=4000 cargo test --release -p tests --test it agreement -- --nocapture` tries more of them, and shows
//! how many agree. `PENDULUM_SEED` is the first seed.

use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

use nalgebra::SVector;
use pendulum_core::hybrid::{Hybrid, MOST};
use pendulum_core::prelude::*;
use pendulum_core::stability::transition;
use pendulum_core::{Canonical, Solution, SolveError, TaylorSeries};
use testbed::contacts::{Boxed, BoxedParams, Row, RowParams};
use testbed::random::Random;

use super::rough::{folding_start, gap, number, pushed_start, restitution, walled_start, within};

/// How many of each scene are tried where no other number is given.
const DEFAULT: u64 = 200;
const DURATION: f64 = 2.0;
const TOLERANCE: f64 = 1e-9;
const REFERENCE: f64 = 1e-12;
/// By how much the second of two impacts is too far away to be one with the first, in m or rad.
const LATER: f64 = 1e-9;
/// Of what rebounds elastically, again and again.
const MOST_STEPS: usize = 200_000;

pub(crate) fn row_start(seed: u64) -> (Row, SVector<f64, 6>) {
    let mut random = Random::new(seed);
    // what nothing brakes comes back to where it was, where it grazes
    let f1 = random.between(0.01, 2.0);
    let mut friction = || [0.0, random.between(0.0, 2.0), random.between(0.0, 20.0)][random.below(3)];
    let (f2, f3) = (friction(), friction());
    let model = Row::new(RowParams {
        m1: random.between(0.1, 3.0),
        m2: random.between(0.1, 3.0),
        m3: random.between(0.1, 3.0),
        f1,
        f2,
        f3,
        e0: restitution(&mut random),
        e1: restitution(&mut random),
        e2: restitution(&mut random),
        e3: restitution(&mut random),
        k: random.between(0.0, 40.0),
        rest: random.between(0.0, 0.8),
        d: 0.1,
        l: 1.0,
    })
    .expect("physical");
    let start = within(
        &mut random,
        &model,
        [
            (0.0, 1.0),
            (0.0, 1.0),
            (0.0, 1.0),
            (-2.0, 2.0),
            (-2.0, 2.0),
            (-2.0, 2.0),
        ],
    );
    (model, start)
}

pub(crate) fn boxed_start(seed: u64) -> (Boxed, SVector<f64, 4>) {
    let mut random = Random::new(seed);
    let l2 = random.between(0.3, 1.5);
    let model = Boxed::new(BoxedParams {
        m: 1.0,
        l1: 1.0,
        l2,
        g: 9.81,
        mu: [0.0, random.between(0.0, 1.0)][random.below(2)],
        room: random.between(0.1, 1.0),
        deep: 1.0 + l2 * random.between(0.5, 1.0),
        e: restitution(&mut random),
        ef: restitution(&mut random),
        es: restitution(&mut random),
    })
    .expect("physical");
    let start = within(
        &mut random,
        &model,
        [(-2.0, 2.0), (-2.0, 2.0), (-3.0, 3.0), (-3.0, 3.0)],
    );
    (model, start)
}

/// A motion by one of seven methods.
fn solve<S, const N: usize>(
    which: u64,
    model: &S,
    (t0, start): (f64, SVector<f64, N>),
    tolerance: f64,
) -> Result<Solution<f64, N>, SolveError<f64, N>>
where
    S: Jacobian<f64, N> + Hybrid<f64, N> + TaylorSeries<f64, N>,
{
    macro_rules! by {
        ($method:ident) => {
            $method::new()
                .rtol(tolerance)
                .atol(tolerance)
                .max_steps(MOST_STEPS)
                .solve(model, t0, DURATION, start)
        };
    }
    match which {
        0 => by!(Tsit5),
        1 => by!(Vern7),
        2 => by!(Rodas5P),
        3 => by!(Radau5),
        4 => by!(Auto),
        5 => by!(Taylor),
        _ => by!(Vern9),
    }
}

#[derive(Debug)]
struct Tally {
    /// Starts with impacts whose order decides and is not known.
    ambiguous: usize,
    /// How far the ends of both orders are apart, at least.
    least_between_orders: f64,
    /// The largest difference of two ends, in tolerances times the sensitivity, and the seed.
    worst: (f64, u64),
    deepest: f64,
    impacts: usize,
}

impl Tally {
    fn none() -> Self {
        Self {
            ambiguous: 0,
            least_between_orders: f64::INFINITY,
            worst: (0.0, 0),
            deepest: 0.0,
            impacts: 0,
        }
    }
}

/// Follows both orders of two impacts at once, each time from where one of the gaps is not closed yet: how far the ends
/// are apart.
fn between_orders<S, const N: usize>(model: &S, solution: &Solution<f64, N>) -> Option<f64>
where
    S: Jacobian<f64, N> + Hybrid<f64, N> + TaylorSeries<f64, N>,
{
    let ambiguity = solution.ambiguities().first()?;
    let impact = solution.impacts().iter().find(|impact| impact.t == ambiguity.t)?;
    let [one, other] = ambiguity.constraints().collect::<Vec<_>>().try_into().ok()?;
    let response = model.response(impact.t, &impact.before, &[0.0; MOST]);
    let entry = |n: usize, m: usize| response.matrix[n][m];
    let determinant = entry(one, one) * entry(other, other) - entry(one, other) * entry(one, other);
    let [first, second] = [(one, other), (other, one)].map(|(closed, open)| {
        let away = if model.laws()[open].low.is_some() {
            LATER
        } else {
            -LATER
        };
        let moves = [(closed, -entry(closed, open)), (open, entry(closed, closed))];
        let mut x = impact.before;
        for (n, share) in moves {
            for k in 0..N / 2 {
                x[k] += response.columns[n][k + N / 2] * share * away / determinant;
            }
        }
        solve(6, model, (impact.t, x), REFERENCE).expect("a motion").end()
    });
    Some((first - second).norm())
}

/// Compares the end by one method with that by Vern9 within a thousandth of the tolerance.
fn compare<S, const N: usize>(seed: u64, (model, start): (S, SVector<f64, N>)) -> Tally
where
    S: Jacobian<f64, N> + Hybrid<f64, N> + Canonical<f64, N> + TaylorSeries<f64, N>,
{
    let [found, expected] = [(seed % 7, TOLERANCE), (6, REFERENCE)].map(|(which, tolerance)| {
        solve(which, &model, (0.0, start), tolerance).unwrap_or_else(|error| panic!("seed {seed}: {error}"))
    });
    let mut tally = Tally::none();
    for solution in [&found, &expected] {
        let modes = solution.modes();
        assert!(modes.is_sorted_by_key(|&(t, _)| t), "seed {seed}: {modes:?}");
        assert!(modes[0].0 == 0.0 && modes[modes.len() - 1].0 <= DURATION, "seed {seed}");
        for (t, x) in solution.points() {
            let size = x.rows(0, N / 2).amax().max(1.0);
            tally.deepest = tally.deepest.max(-gap(&model, t, x) / size);
        }
        assert_eq!(solution.ambiguities().len(), solution.statistics().ambiguities);
    }
    tally.impacts = found.impacts().len();
    if !found.ambiguities().is_empty() || !expected.ambiguities().is_empty() {
        tally.ambiguous = 1;
        for solution in [&found, &expected] {
            if let Some(apart) = between_orders(&model, solution) {
                tally.least_between_orders = tally.least_between_orders.min(apart);
            }
        }
        return tally;
    }
    let (_, matrix) = transition(&model, 0.0, DURATION, start, TOLERANCE).expect("tangents");
    let apart = (found.end() - expected.end()).norm() / (1.0 + expected.end().norm());
    tally.worst = (apart / (TOLERANCE * (1.0 + matrix.norm())), seed);
    tally
}

fn all_agree(name: &str, compared: impl Fn(u64) -> Tally + Sync) {
    let (first, count) = (number("PENDULUM_SEED", 0), number("PENDULUM_ROUGH", DEFAULT));
    let (next, total) = (AtomicU64::new(first), Mutex::new(Tally::none()));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    if seed >= first + count {
                        break;
                    }
                    let tally = compared(seed);
                    let mut total = total.lock().expect("no other has failed");
                    total.ambiguous += tally.ambiguous;
                    total.impacts += tally.impacts;
                    total.least_between_orders = total.least_between_orders.min(tally.least_between_orders);
                    total.deepest = total.deepest.max(tally.deepest);
                    if tally.worst.0 > total.worst.0 {
                        total.worst = tally.worst;
                    }
                }
            });
        }
    });
    let total = total.into_inner().expect("none has failed");
    println!("{name}: {count} starts, {total:?}");
    assert!(total.worst.0 <= 10.0, "{name}: {total:?}");
    assert!(total.deepest <= 1e-12, "{name}: {total:?}");
    assert!(total.ambiguous as u64 * 100 <= count, "{name}: {total:?}");
    assert!(total.least_between_orders > 10.0 * TOLERANCE, "{name}: {total:?}");
    assert!(total.impacts as u64 > count, "{name}: {total:?}");
}

#[test]
fn ends_of_folding_pendulums_agree() {
    all_agree("folding", |seed| compare(seed, folding_start(seed)));
}

#[test]
fn ends_of_rods_between_walls_agree() {
    all_agree("walled", |seed| compare(seed, walled_start(seed)));
}

#[test]
fn ends_of_pushed_rods_agree() {
    all_agree("pushed", |seed| compare(seed, pushed_start(seed)));
}

#[test]
fn ends_of_rows_of_blocks_agree() {
    all_agree("row", |seed| compare(seed, row_start(seed)));
}

#[test]
fn ends_of_rods_in_a_box_agree() {
    all_agree("boxed", |seed| compare(seed, boxed_start(seed)));
}

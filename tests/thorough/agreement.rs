//! Final states of rough scenes by one method against those by another, from random initial conditions.
//!
//! `PENDULUM_ROUGH=4000 cargo test --release -p tests --features thorough agreement -- --nocapture` tries more scenes
//! and prints the number that agree. `PENDULUM_SEED` is the first seed.

use nalgebra::{DMatrix, DVector, SVector};
use pendulum_core::hybrid::{Hybrid, MAX_CONSTRAINTS};
use pendulum_core::prelude::*;
use pendulum_core::stability::transition;
use pendulum_core::{Canonical, Solution, SolveError, TaylorSeries};
use testbed::contacts::{Boxed, BoxedParams, Row, RowParams};
use testbed::random::{Random, each_seed, number};

use super::rough::{folding_start, gap, pushed_start, restitution, walled_start, within};

/// Default number of random cases for each scene.
const DEFAULT: u64 = 200;
const DURATION: f64 = 2.0;
const TOLERANCE: f64 = 1e-9;
const REFERENCE: f64 = 1e-12;
/// Distance of the second of two impacts beyond which they are separate, in m or rad.
const LATER: f64 = 1e-13;
/// Maximum number of steps for a motion with repeated elastic rebounds.
const MOST_STEPS: usize = 1_000_000;

pub(crate) fn row_start(seed: u64) -> (Row, SVector<f64, 6>) {
    let mut random = Random::new(seed);
    // an undamped motion returns to where it was, and grazes there
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

/// Motion by one of seven methods.
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
    /// Number of cases with impacts whose order is ambiguous.
    ambiguous: usize,
    /// Number of these whose final states differ by more than ten tolerances between the two orders.
    decided: usize,
    /// Largest difference of two final states, in tolerances times the sensitivity, and its seed.
    worst: (f64, u64),
    deepest: f64,
    impacts: usize,
}

impl Tally {
    fn none() -> Self {
        Self {
            ambiguous: 0,
            decided: 0,
            worst: (0.0, 0),
            deepest: 0.0,
            impacts: 0,
        }
    }
}

/// Distance of the final states for the two orders of a simultaneous pair of impacts. Each order starts from a state in
/// which one of the gaps is not closed yet.
fn between_orders<S, const N: usize>(model: &S, solution: &Solution<f64, N>) -> Option<f64>
where
    S: Jacobian<f64, N> + Hybrid<f64, N> + TaylorSeries<f64, N>,
{
    let ambiguity = solution.ambiguities().first()?;
    let impact = solution.impacts().iter().find(|impact| impact.t == ambiguity.t)?;
    let orders: [usize; 2] = ambiguity.constraints().collect::<Vec<_>>().try_into().ok()?;
    let (laws, measures) = (model.laws(), model.measures(impact.t, &impact.before));
    // other contacts stay closed
    let apart = |n: usize| {
        let [low, high] = [laws[n].low, laws[n].high].map(|limit| limit.map(|limit| (measures[n][0] - limit).abs()));
        low.into_iter().chain(high).fold(f64::INFINITY, f64::min)
    };
    let closed: Vec<usize> = (0..MAX_CONSTRAINTS)
        .filter(|&n| orders.contains(&n) || apart(n) < 1e-12)
        .collect();
    let response = model.response(impact.t, &impact.before, &[0.0; MAX_CONSTRAINTS]);
    let matrix = DMatrix::from_fn(closed.len(), closed.len(), |i, j| response.matrix[closed[i]][closed[j]]);
    let ends = orders.map(|open| {
        let away = if laws[open].low.is_some() { LATER } else { -LATER };
        let target = DVector::from_fn(closed.len(), |i, _| if closed[i] == open { away } else { 0.0 });
        let moves = matrix.clone().lu().solve(&target)?;
        let mut x = impact.before;
        for (&n, share) in closed.iter().zip(moves.iter()) {
            for k in 0..N / 2 {
                x[k] += response.columns[n][k + N / 2] * share;
            }
        }
        Some(solve(6, model, (impact.t, x), REFERENCE).expect("a motion").end())
    });
    let [first, second] = [ends[0]?, ends[1]?];
    Some((first - second).norm())
}

/// Compares the final state by one method with that by Vern9 at a thousandth of the tolerance.
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
        // friction and further impacts may cancel the effect of the order
        if let Some(apart) = between_orders(&model, &expected) {
            println!("seed {seed}: {:?}, ends {apart:e} apart", expected.ambiguities());
            tally.decided = usize::from(apart > 10.0 * TOLERANCE);
        }
        return tally;
    }
    let from =
        |t: f64, x: SVector<f64, N>| transition(&model, t, DURATION, x, TOLERANCE).map(|(_, matrix)| matrix.norm());
    let apart = (found.end() - expected.end()).norm() / (1.0 + expected.end().norm());
    let mut sensitivity = from(0.0, start).expect("tangents");
    // the final state may be more sensitive to errors made on the way
    if apart > TOLERANCE * (1.0 + sensitivity) {
        let points = expected.t().len();
        for point in [points / 4, points / 2, 3 * points / 4] {
            let later = from(expected.t()[point], expected.x()[point]);
            sensitivity = later.map_or(sensitivity, |later| later.max(sensitivity));
        }
    }
    tally.worst = (apart / (TOLERANCE * (1.0 + sensitivity)), seed);
    tally
}

fn all_agree(name: &str, compared: impl Fn(u64) -> Tally + Sync) {
    let (first, count) = (number("PENDULUM_SEED", 0), number("PENDULUM_ROUGH", DEFAULT));
    let mut total = Tally::none();
    each_seed(first..first + count, compared, |_, tally| {
        total.ambiguous += tally.ambiguous;
        total.impacts += tally.impacts;
        total.decided += tally.decided;
        total.deepest = total.deepest.max(tally.deepest);
        if tally.worst.0 > total.worst.0 {
            total.worst = tally.worst;
        }
    });
    println!("{name}: {count} starts, {total:?}");
    assert!(total.worst.0 <= 10.0, "{name}: {total:?}");
    assert!(total.deepest <= 1e-12, "{name}: {total:?}");
    assert!(total.ambiguous as u64 * 100 <= count, "{name}: {total:?}");
    assert!(total.decided > 0 || total.ambiguous == 0, "{name}: {total:?}");
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

//! Timing: all forms of the peers first, then the best ones of each peer together with the generated code.

use std::error::Error;
use std::hint::black_box;
use std::time::Duration;

use ours::Solo;
use pendulum_core::real::Real;

use super::candidate::{Candidate, Function, OURS, Order};
use super::entrants;
use super::results::Row;
use crate::library::Program;
use crate::timing::{Times, in_turns};
use testbed::random::Random;

/// Number of states evaluated one after another in each pass. It is small enough that the processor learns the branches
/// of the platform's sines and cosines, as it does for the states of a motion.
const STATES: usize = 256;
/// Time budget for all forms of all peers, for each function of a model and each order.
const HEATS: Duration = Duration::from_secs(4);
/// Time budget for the best form of each peer, for each function of a model and each order.
const FINAL: Duration = Duration::from_secs(10);
/// Forms of a peer within this factor of its best time are measured again, since they may only have been disturbed.
const CLOSE: f64 = 1.3;

/// Random states, and the length of one state: coordinates within a turn, rates within 3 rad/s, orientations of unit
/// length.
pub(crate) fn states(model: &str, count: usize) -> Result<(usize, Vec<f64>), String> {
    let (length, _) = entrants::sizes(model, Function::Rhs)?;
    let mut random = Random::new(22);
    let mut states: Vec<f64> = (0..length * count).map(|_| random.between(-3.0, 3.0)).collect();
    if model == "solo" {
        for state in states.chunks_exact_mut(length) {
            let orientation = &mut state[Solo::O..Solo::O + 4];
            let size = orientation.iter().map(|x| x * x).sum::<f64>().sqrt();
            orientation.iter_mut().for_each(|x| *x /= size);
        }
    }
    Ok((length, states))
}

/// Rows of one function of one model: the best form of each peer, in the order of their times, then the slower forms.
pub(crate) fn hold(
    candidates: &[Candidate],
    model: &str,
    function: Function,
    order: Order,
) -> Result<Vec<Row>, Box<dyn Error>> {
    let (length, states) = states(model, STATES)?;
    let entered: Vec<&Candidate> = candidates
        .iter()
        .filter(|candidate| candidate.model == model && candidate.function == function && candidate.order == order)
        .collect();
    let heats = time(
        &entered.iter().map(|candidate| &candidate.program).collect::<Vec<_>>(),
        &states,
        HEATS,
    );
    let least: Vec<f64> = heats.iter().map(Times::least).collect();
    let advances = |n: usize| {
        let same = |k: &usize| entered[*k].peer == entered[n].peer;
        (0..entered.len()).filter(same).all(|k| least[n] <= CLOSE * least[k])
    };
    let all = entered.iter().zip(heats).enumerate();
    let (best, lost): (Vec<_>, Vec<_>) = all.partition(|(n, _)| advances(*n));
    let best: Vec<&Candidate> = best.into_iter().map(|(_, (candidate, _))| *candidate).collect();
    let mut rows = finals(&best, length, &states)?;
    // Keep one form of each peer.
    for n in 0..rows.len() {
        let rival = |row: &Row| row.peer == rows[n].peer;
        rows[n].heat = rows
            .iter()
            .any(|row| rival(row) && row.times.least() < rows[n].times.least());
    }
    rows.extend(lost.into_iter().map(|(_, (candidate, times))| Row {
        heat: true,
        ..Row::new(candidate, times)
    }));
    rows.sort_by(|a, b| (a.heat.cmp(&b.heat)).then(a.times.least().total_cmp(&b.times.least())));
    Ok(rows)
}

fn finals(best: &[&Candidate], length: usize, states: &[f64]) -> Result<Vec<Row>, Box<dyn Error>> {
    let made: Vec<Option<Program>> = best
        .iter()
        .map(|candidate| entrants::cheapened(candidate))
        .collect::<Result<_, _>>()?;
    let cheap: Vec<Option<&Program>> = best
        .iter()
        .zip(&made)
        .map(|(candidate, made)| candidate.cheap.as_ref().or(made.as_ref()))
        .collect();
    let pairs = best
        .iter()
        .find(|candidate| candidate.peer == OURS)
        .and_then(|ours| ours.operations);
    let sines = sines(length, pairs.map_or(0, |operations| operations.sincos));
    // The functions, then their variants without sine and cosine, then the sines and cosines alone.
    let programs: Vec<&Program> = best.iter().map(|candidate| &candidate.program).collect();
    let others: Vec<&Program> = cheap.iter().flatten().copied().chain([&sines]).collect();
    let mut times = time(&[programs, others].concat(), states, FINAL).into_iter();
    let mut rows: Vec<Row> = best
        .iter()
        .zip(times.by_ref())
        .map(|(candidate, times)| Row::new(candidate, times))
        .collect();
    for (row, cheap) in rows.iter_mut().zip(cheap) {
        row.without = cheap.and_then(|_| times.next());
    }
    if let Some(ours) = rows.iter_mut().find(|row| row.peer == OURS) {
        ours.sines = times.next();
    }
    Ok(rows)
}

fn time(programs: &[&Program], states: &[f64], budget: Duration) -> Vec<Times> {
    let runs: Vec<Box<dyn Fn() + '_>> = programs
        .iter()
        .map(|program| Box::new(|| (program.run)(black_box(states))) as Box<dyn Fn()>)
        .collect();
    let runs: Vec<&dyn Fn()> = runs.iter().map(AsRef::as_ref).collect();
    in_turns(&runs, STATES, budget)
}

/// Sines and cosines of the first coordinates, and nothing else.
fn sines(length: usize, pairs: usize) -> Program {
    let run = move |states: &[f64]| {
        for x in states.chunks_exact(length) {
            for &angle in &x[..pairs] {
                black_box(Real::sin_cos(angle));
            }
        }
    };
    Program {
        run: Box::new(run),
        value: Box::new(|_| Vec::new()),
    }
}

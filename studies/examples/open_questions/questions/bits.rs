//! Equal bits, however many trajectories are integrated at once.

use std::collections::BTreeSet;
use std::error::Error;

use pendulum_core::prelude::*;
use pendulum_core::real::lanes::Isa;
use testbed::digest::Digest;

use super::Answer;

mechanism! {
    /// A chaotic double pendulum.
    pub Chaotic {
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: arm { joint: revolute(z), coordinate: theta1 }
        body lower on upper: arm { joint: revolute(z) at [0, -1, 0], coordinate: theta2 }
    }
}

/// Number of trajectories.
const STARTS: u32 = 256;
/// Trajectories integrated at once.
const BATCHES: [usize; 4] = [1, 7, 64, 256];

fn digest(ends: &[SVector<f64, 4>]) -> u64 {
    let mut digest = Digest::default();
    digest.add(ends.iter().flatten().flat_map(|number| number.to_le_bytes()));
    digest.value()
}

/// Digests of all final states: of trajectories alone, and for each instruction set and batch.
pub(crate) fn digests() -> Result<Vec<u64>, Box<dyn Error>> {
    let (model, method) = (Chaotic::new(ChaoticParams {})?, Vern7::new());
    let starts: Vec<_> = (0..STARTS)
        .map(|n| SVector::from([2.0 + 1e-2 * f64::from(n), 2.0, 0.0, 0.0]))
        .collect();
    let alone = starts
        .iter()
        .map(|&start| Ok(method.solve(&model, 0.0, 2.0, start)?.end()));
    let mut digests = vec![digest(&alone.collect::<Result<Vec<_>, Box<dyn Error>>>()?)];
    for isa in Isa::available() {
        for batch in BATCHES {
            let mut ends = Vec::new();
            for starts in starts.chunks(batch) {
                ends.extend(method.ensemble_on(isa, &[model], 0.0, 2.0, starts)?);
            }
            digests.push(digest(&ends));
        }
    }
    Ok(digests)
}

pub(crate) fn answer() -> Result<Answer, Box<dyn Error>> {
    let digests = digests()?;
    let distinct: BTreeSet<u64> = digests.iter().copied().collect();
    let text = format!(
        "{STARTS} trajectories, alone and in batches of {BATCHES:?} on every instruction set: {} digest, {:016x}",
        distinct.len(),
        digests[0]
    );
    Ok(Answer::new(distinct.len() as f64, text))
}

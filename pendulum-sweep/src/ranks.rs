//! The processes of `mpirun`, which share the shards of a job.

use std::sync::Mutex;
use std::thread::{scope, sleep};
use std::time::Duration;

use indicatif::ProgressBar;
use mpi::Threading;
use mpi::collective::SystemOperation;
use mpi::environment::Universe;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::error::SweepError;

/// How long the first rank waits between two looks for messages.
const PAUSE: Duration = Duration::from_millis(2);
/// In place of the number of a shard: there is none left.
const NONE_LEFT: i64 = -1;

/// All processes, as long as this lives.
pub(crate) struct Ranks {
    world: SimpleCommunicator,
    _universe: Universe,
}

/// Ends all ranks where one panics: it would wait for the others at its end, and these for its work.
impl Drop for Ranks {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.world.abort(101);
        }
    }
}

impl Ranks {
    /// None where the program was started alone.
    pub(crate) fn of_program() -> Option<Self> {
        let (universe, _) = mpi::initialize_with_threading(Threading::Funneled)?;
        let world = universe.world();
        (world.size() > 1).then_some(Self {
            world,
            _universe: universe,
        })
    }

    pub(crate) fn is_first(&self) -> bool {
        self.world.rank() == 0
    }

    /// Waits for all others.
    pub(crate) fn meet(&self) {
        self.world.barrier();
    }

    /// The number of the first rank, on all of them.
    pub(crate) fn of_first(&self, mut number: u32) -> u32 {
        self.world.process_at_rank(0).broadcast_into(&mut number);
        number
    }

    /// The sum over all ranks, at the first one.
    pub(crate) fn sum(&self, number: usize) -> usize {
        let (own, mut sum) = (number as i64, 0_i64);
        let first = self.world.process_at_rank(0);
        if self.is_first() {
            first.reduce_into_root(&own, &mut sum, SystemOperation::sum());
        } else {
            first.reduce_into(&own, SystemOperation::sum());
        }
        usize::try_from(sum).unwrap_or(0)
    }

    /// Ends all processes.
    pub(crate) fn abort(&self, error: &SweepError) -> ! {
        eprintln!("rank {}: {error}", self.world.rank());
        self.world.abort(1)
    }

    /// Does the work of all shards, each on one rank, which asks for the next one as it ends; `work` returns its rows,
    /// which the first rank shows.
    pub(crate) fn share(
        &self,
        shards: Vec<usize>,
        progress: &ProgressBar,
        mut work: impl FnMut(usize) -> Result<usize, SweepError> + Send,
    ) -> Result<(), SweepError> {
        if !self.is_first() {
            let (first, mut rows) = (self.world.process_at_rank(0), 0);
            loop {
                first.send(&(rows as i64));
                let (shard, _) = first.receive::<i64>();
                let Ok(shard) = usize::try_from(shard) else {
                    return Ok(());
                };
                rows = work(shard)?;
            }
        }
        let waiting = Mutex::new(shards.into_iter());
        let next = || waiting.lock().map_or(None, |mut waiting| waiting.next());
        scope(|scope| {
            let own = scope.spawn(|| {
                while let Some(shard) = next() {
                    progress.inc(work(shard)? as u64);
                }
                Ok(())
            });
            let mut others = self.world.size() - 1;
            while others > 0 {
                let Some((message, status)) = self.world.any_process().immediate_matched_probe() else {
                    if own.is_finished() && waiting.lock().is_ok_and(|waiting| waiting.len() > 0) {
                        break; // with an error, which ends all
                    }
                    sleep(PAUSE);
                    continue;
                };
                let (rows, _) = message.matched_receive::<i64>();
                progress.inc(u64::try_from(rows).unwrap_or(0));
                let shard = next().map_or(NONE_LEFT, |shard| shard as i64);
                others -= i32::from(shard == NONE_LEFT);
                self.world.process_at_rank(status.source_rank()).send(&shard);
            }
            let panicked = |_| SweepError::Invalid("a thread panicked".to_owned());
            own.join().map_err(panicked)?
        })
    }
}

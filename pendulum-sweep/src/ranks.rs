//! Processes of `mpirun`, which share the shards of a job.

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

/// Interval at which the first rank polls for messages.
const PAUSE: Duration = Duration::from_millis(2);
/// Message in place of the index of a shard: none is left.
const NONE_LEFT: i64 = -1;

/// MPI environment with all processes; dropping it finalizes MPI.
pub(crate) struct Ranks {
    world: SimpleCommunicator,
    _universe: Universe,
}

/// Aborts all ranks if one panics. Otherwise it would wait for the others in the finalization, and they for its work.
impl Drop for Ranks {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.world.abort(101);
        }
    }
}

impl Ranks {
    /// Initializes MPI; returns `None` if the program was started alone.
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

    /// Waits for all other ranks.
    pub(crate) fn meet(&self) {
        self.world.barrier();
    }

    /// Broadcasts the number of the first rank.
    pub(crate) fn of_first(&self, mut number: u32) -> u32 {
        self.world.process_at_rank(0).broadcast_into(&mut number);
        number
    }

    /// Returns the sum over all ranks, at the first one.
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

    /// Prints an error and ends all processes.
    pub(crate) fn abort(&self, error: &SweepError) -> ! {
        eprintln!("rank {}: {error}", self.world.rank());
        self.world.abort(1)
    }

    /// Distributes the shards over the ranks; each rank requests the next shard when it has finished one. `work`
    /// returns the number of rows of a shard, which the first rank adds to the progress bar.
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
                        break; // the rank's own thread failed, which ends all ranks
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

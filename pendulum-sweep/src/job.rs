//! Jobs: a sweep and the task at its points.

use std::collections::{BTreeMap, HashSet};
use std::error::Error;
use std::fmt;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use indicatif::{HumanCount, ProgressBar, ProgressState, ProgressStyle};
use rayon::prelude::*;
use serde_json::{Value, json};

use crate::design::Sweep;
use crate::error::SweepError;
use crate::file::MOST_ROWS;
use crate::shards::{Role, Shards};
use crate::table::{Column, Table};

/// Reason for a failure at a point; `?` converts any error into it, and `.into()` a text.
pub type Failure = Box<dyn Error + Send + Sync>;

/// Computation at the points of a sweep.
pub trait Task<const K: usize>: Sync {
    /// Returns the columns of the results, and a description of everything that they depend on besides the points, as
    /// far as it can be written down. A sweep resumes only if this description is unchanged.
    fn describe(&self, sweep: &Sweep<K>) -> (Vec<Column>, Value);

    /// Computes the results at some points.
    ///
    /// # Errors
    /// [`SweepError::Invalid`] if settings are invalid at all points; a failure at one point is part of the results.
    fn run(&self, points: &[[f64; K]]) -> Result<Chunk, SweepError>;

    /// Preferred number of points for each call of [`run`](Self::run).
    fn chunk(&self) -> usize {
        USUAL_CHUNK
    }
}

/// Results at some points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chunk {
    /// Row by row.
    numbers: Vec<f64>,
    width: usize,
    rows: usize,
    failures: BTreeMap<usize, String>,
}

impl Chunk {
    /// An empty chunk with memory for `rows` rows.
    pub(crate) fn with_capacity(rows: usize, width: usize) -> Self {
        let numbers = Vec::with_capacity(rows * width);
        Self {
            numbers,
            ..Self::default()
        }
    }

    /// Adds a row: one number for each column.
    ///
    /// # Panics
    /// If the length of the row differs from the earlier ones.
    pub fn push(&mut self, numbers: impl IntoIterator<Item = f64>) {
        self.push_row(|row| {
            row.extend(numbers);
            None::<String>
        });
    }

    /// Adds a row whose numbers a function appends; the function returns the reason if the row failed.
    pub(crate) fn push_row<R: fmt::Display>(&mut self, row: impl FnOnce(&mut Vec<f64>) -> Option<R>) {
        let before = self.numbers.len();
        if let Some(reason) = row(&mut self.numbers) {
            self.failures.insert(self.rows, reason.to_string());
        }
        let width = self.numbers.len() - before;
        assert!(
            self.rows == 0 || width == self.width,
            "rows of one chunk have one length"
        );
        self.width = width;
        self.rows += 1;
    }

    /// Adds the row of a point that failed, with the numbers that are available.
    ///
    /// # Panics
    /// Like [`push`](Self::push).
    pub fn fail(&mut self, numbers: impl IntoIterator<Item = f64>, reason: impl fmt::Display) {
        self.push_row(|row| {
            row.extend(numbers);
            Some(reason)
        });
    }

    /// All columns, beginning with those of the points.
    fn columns<'a, const K: usize>(
        &'a self,
        points: &'a [[f64; K]],
    ) -> impl Iterator<Item = impl Iterator<Item = f64> + 'a> {
        assert_eq!(self.rows, points.len(), "a chunk has a row for each point");
        let parts = [(points.as_flattened(), K), (self.numbers.as_slice(), self.width)];
        let columns = move |(numbers, width): (&'a [f64], usize)| {
            (0..width).map(move |n| (0..self.rows).map(move |row| numbers[width * row + n]))
        };
        parts.into_iter().flat_map(columns)
    }
}

/// A sweep and the task at its points; see the [crate](crate).
#[must_use = "nothing is computed before `run`, `run_to` or `main`"]
pub struct Job<T, const K: usize> {
    sweep: Sweep<K>,
    pub(crate) task: T,
    shard: Option<usize>,
    share: (usize, usize),
    threads: usize,
    quiet: bool,
    version: String,
}

/// Summary of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Summary {
    /// Number of rows of the sweep.
    pub rows: usize,
    /// Number of rows computed in this run; the others existed already, or belong to other shares.
    pub computed: usize,
    /// Number of rows that failed in this run.
    pub failed: usize,
    /// Elapsed time.
    pub time: Duration,
    /// True if the file is complete.
    pub complete: bool,
}

/// Upper bound for the number of points: smaller row numbers are exact in `f64`, for all readers.
const MOST_POINTS: usize = 1 << 53;
/// Maximum number of threads, above the number of cores of any machine.
const MOST_THREADS: usize = 4096;
/// Default number of points per chunk.
const USUAL_CHUNK: usize = 256;
/// Minimum number of chunks in a shard, unless the number of its rows is given.
const SHARD: usize = 16;
/// Default maximum number of shards.
const USUAL_SHARDS: usize = 4096;
/// Number of columns above which there are fewer shards, down to [`LEAST_SHARDS`].
const USUAL_COLUMNS: usize = 16;
/// Minimum of the default maximum number of shards.
const LEAST_SHARDS: usize = 64;
/// Maximum number of row groups in a Parquet file.
const MOST_SHARDS: usize = i16::MAX as usize;

impl<const K: usize> Sweep<K> {
    /// Columns computed by a function at each point. The function may do anything: choose a method and its settings by
    /// the point, for example.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    /// use pendulum_sweep::{Axis, Sweep};
    ///
    /// mechanism! {
    ///     pub Swing {
    ///         gravity: [0, -9.81, 0],
    ///         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
    ///     }
    /// }
    ///
    /// let swing = Swing::new(SwingParams {})?;
    /// let table = Sweep::grid("drift", [Axis::logarithmic("step", "s", 1e-3, 1e-1, 5)])
    ///     .each([("drift", "J")], |[step]| {
    ///         let end = Rk4::new(step).solve(&swing, 0.0, 10.0, [2.0, 0.0])?.end();
    ///         Ok([swing.energy(10.0, &end) - swing.energy(0.0, &[2.0, 0.0])])
    ///     })
    ///     .quiet()
    ///     .run()?;
    /// assert!(table["drift"][0].abs() < 1e-11 && table["drift"][4].abs() > 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn each<F, const Q: usize>(self, columns: [(&str, &str); Q], find: F) -> Job<Each<F, Q>, K>
    where
        F: Fn([f64; K]) -> Result<[f64; Q], Failure> + Sync,
    {
        let columns = columns.map(|(name, unit)| Column::new(name, unit));
        self.job(Each { columns, find })
    }

    /// A job with any task.
    pub fn job<T: Task<K>>(self, task: T) -> Job<T, K> {
        Job {
            sweep: self,
            task,
            shard: None,
            share: (0, 1),
            threads: 0,
            quiet: false,
            version: String::new(),
        }
    }
}

impl<T: Task<K>, const K: usize> Job<T, K> {
    /// Number of rows per shard, at most 2^20. A killed job loses at most one shard per core. The default is 4096. It
    /// is larger for methods that integrate more trajectories at a time, and where there would be more than 4096
    /// shards, or fewer if there are more than 16 columns: while the file is assembled, the entries that each shard
    /// adds are kept in memory.
    pub fn rows_per_shard(mut self, rows: usize) -> Self {
        self.shard = Some(rows.clamp(1, MOST_ROWS));
        self
    }

    fn rows_of_shard(&self, columns: usize) -> usize {
        let chunk = self.task.chunk();
        let shards = USUAL_SHARDS
            .min(USUAL_COLUMNS * USUAL_SHARDS / columns.max(1))
            .max(LEAST_SHARDS);
        let usual = || self.sweep.points().div_ceil(shards).next_multiple_of(chunk);
        self.shard.unwrap_or_else(|| usual().max(SHARD * chunk).min(MOST_ROWS))
    }

    /// Computes only every `of`-th shard, beginning with `index`, which must be below `of`. Other processes, on this
    /// machine or another one, compute the others, and [`merge`](Self::merge) assembles the file.
    pub fn share(mut self, index: usize, of: usize) -> Self {
        self.share = (index, of);
        self
    }

    /// Sets the number of threads. The default, 0, means one per core.
    pub fn threads(mut self, threads: usize) -> Self {
        self.threads = threads;
        self
    }

    /// Hides the progress bar.
    pub fn quiet(mut self) -> Self {
        self.quiet = true;
        self
    }

    /// Names the version of your own code. A sweep cannot detect changes in its functions: set another version when you
    /// change them.
    pub fn version(mut self, version: &str) -> Self {
        version.clone_into(&mut self.version);
        self
    }

    /// Computes all rows.
    ///
    /// # Errors
    /// [`SweepError::Invalid`], also for a [share](Self::share), which needs a file, and if there is not enough memory
    /// for the table.
    pub fn run(&self) -> Result<Table, SweepError> {
        let mut empty = self.empty()?;
        if self.share.1 > 1 {
            return Err(SweepError::Invalid(
                "a share is computed into a file: use `run_to`".to_owned(),
            ));
        }
        let rows = self.sweep.points();
        let progress = self.progress(rows);
        empty.rows = rows;
        for numbers in &mut empty.numbers {
            let reserved = numbers.try_reserve_exact(rows);
            let rule = |_| SweepError::Invalid(format!("there is not enough memory for {rows} rows: use `run_to`"));
            reserved.map_err(rule)?;
            numbers.resize(rows, 0.0);
        }
        let table = Mutex::new(empty);
        self.in_threads(|| {
            self.rows(0..rows, &progress, |first, points, chunk| {
                let table = &mut locked(&table);
                for (column, numbers) in table.numbers.iter_mut().zip(chunk.columns(points)) {
                    column[first..]
                        .iter_mut()
                        .zip(numbers)
                        .for_each(|(place, number)| *place = number);
                }
                let failures = chunk.failures.into_iter();
                table
                    .failures
                    .extend(failures.map(|(row, reason)| (first + row, reason)));
            })
        })?;
        Ok(table.into_inner().unwrap_or_else(PoisonError::into_inner))
    }

    /// Computes all rows into a Parquet file. Intermediate results are shards in the folder `PATH.shards` beside the
    /// file; a killed job continues with the missing shards. If the file exists, nothing is computed.
    ///
    /// The columns of the file are `row`, the columns of the points, the results, and `failure`, a text or null. The
    /// metadata hold the units and the declaration.
    ///
    /// # Errors
    /// Any [`SweepError`]. A [share](Self::share) that ends before the others is not an error.
    pub fn run_to(&self, path: impl AsRef<Path>) -> Result<Summary, SweepError> {
        let (index, of) = self.share;
        self.timed(path.as_ref(), |shards| {
            let role = if of == 1 { Role::Alone } else { Role::Share };
            let Some(_lock) = shards.enter(role)? else {
                return Ok((0, 0, true));
            };
            let own = shards.missing((index..shards.count).step_by(of))?;
            let rows = own.iter().map(|&n| shards.rows(n).len()).sum();
            let progress = self.progress(rows);
            let failures = shards.flushed(|| {
                self.in_threads(|| {
                    let shard = |&n: &usize| self.write(shards, n, &progress);
                    own.par_iter().map(shard).try_reduce(|| 0, |a, b| Ok(a + b))
                })
            })?;
            if of == 1 {
                shards.merge()?;
            }
            Ok((rows, failures, of == 1))
        })
    }

    /// Times a computation and returns its summary; `compute` returns the number of rows, the number of failed rows,
    /// and whether the file is complete.
    fn timed(
        &self,
        path: &Path,
        compute: impl FnOnce(&Shards<'_>) -> Result<(usize, usize, bool), SweepError>,
    ) -> Result<Summary, SweepError> {
        let since = Instant::now();
        let (computed, failed, complete) = compute(&self.shards(path)?)?;
        Ok(Summary {
            rows: self.sweep.points(),
            computed,
            failed,
            time: since.elapsed(),
            complete,
        })
    }

    /// Computes all rows into a file, together with the other processes of `mpirun`.
    #[cfg(feature = "mpi")]
    pub(crate) fn run_on(&self, ranks: &crate::ranks::Ranks, path: &Path) -> Result<Summary, SweepError> {
        if self.share.1 > 1 {
            let reason = "processes of `mpirun` share the work by themselves: leave out `--shard`";
            return Err(SweepError::Invalid(reason.to_owned()));
        }
        self.timed(path, |shards| {
            let declaration = crc32fast::hash(shards.empty.declaration.as_bytes());
            if declaration != ranks.of_first(declaration) {
                let reason = "this process has another sweep than the first one of `mpirun`";
                return Err(SweepError::Invalid(reason.to_owned()));
            }
            let lock = if ranks.is_first() {
                shards.enter(Role::Alone)?
            } else {
                None
            };
            if ranks.of_first(u32::from(lock.is_none())) == 1 {
                return Ok((0, 0, true));
            }
            let (mut missing, mut progress) = (Vec::new(), ProgressBar::hidden());
            if ranks.is_first() {
                missing = shards.missing(0..shards.count)?;
                progress = self.progress(missing.iter().map(|&n| shards.rows(n).len()).sum());
            }
            let (mut computed, mut failures) = (0, 0);
            shards.flushed(|| {
                ranks.share(missing, &progress, |n| {
                    let rows = shards.rows(n).len();
                    let failed = self.in_threads(|| self.write(shards, n, &ProgressBar::hidden()))?;
                    (computed, failures) = (computed + rows, failures + failed);
                    Ok(rows)
                })
            })?;
            (computed, failures) = (ranks.sum(computed), ranks.sum(failures));
            if ranks.is_first() {
                shards.merge()?;
            }
            ranks.meet();
            Ok((computed, failures, true))
        })
    }

    /// Assembles the file from the shards of all shares.
    ///
    /// # Errors
    /// [`SweepError::Incomplete`] if shards are missing, and the errors of [`run_to`](Self::run_to).
    pub fn merge(&self, path: impl AsRef<Path>) -> Result<(), SweepError> {
        let shards = self.shards(path.as_ref())?;
        if !shards.are_begun() && !shards.is_merged()? {
            let of = shards.count;
            return Err(SweepError::Incomplete {
                present: 0,
                of,
                missing: 0,
            });
        }
        let Some(_lock) = shards.enter(Role::Alone)? else {
            return Ok(());
        };
        shards.missing(0..shards.count)?;
        shards.merge()
    }

    fn shards<'p>(&self, path: &'p Path) -> Result<Shards<'p>, SweepError> {
        let empty = self.empty()?;
        let rows = self.rows_of_shard(empty.columns.len());
        let shards = Shards::new(path, self.sweep.points(), rows, empty)?;
        if shards.count > MOST_SHARDS {
            let least = self.sweep.points().div_ceil(MOST_SHARDS);
            let reason = if least > MOST_ROWS {
                format!("a file takes {} rows at most", MOST_SHARDS * MOST_ROWS)
            } else {
                format!("a file takes {MOST_SHARDS} shards at most: of so many points, each has {least} rows or more")
            };
            return Err(SweepError::Invalid(reason));
        }
        Ok(shards)
    }

    fn check(&self) -> Result<(), SweepError> {
        let (index, of) = self.share;
        if index >= of {
            let reason = format!(
                "share {index} of {of}: shares are counted from 0, so the last one is {}",
                of.max(1) - 1
            );
            return Err(SweepError::Invalid(reason));
        }
        let wrong = match self.sweep.points() {
            0 => "the sweep has no points",
            MOST_POINTS.. => {
                "the sweep has 2^53 points or more, which no machine computes: take fewer values, or random points"
            }
            _ if self.threads > MOST_THREADS => "there are at most 4096 threads",
            _ => return self.sweep.check(),
        };
        Err(SweepError::Invalid(wrong.to_owned()))
    }

    /// Checks the job and returns its table without rows.
    fn empty(&self) -> Result<Table, SweepError> {
        self.check()?;
        let of_points = self.sweep.columns();
        let (kept, task) = self.task.describe(&self.sweep);
        let mut names = HashSet::from(["row", "failure"]);
        let mut all = of_points.iter().chain(&kept);
        if let Some(Column { name, .. }) = all.find(|column| !names.insert(&column.name)) {
            let is_in = |columns: &[Column]| columns.iter().any(|column| column.name == *name);
            let reason = if ["row", "failure"].contains(&name.as_str()) {
                format!("a column has the name `{name}`, which every table has already")
            } else if is_in(&of_points) && is_in(&kept) {
                format!(
                    "two columns have the name `{name}`: a number of the points, and one that is kept of trajectories, \
                     perhaps a coordinate; give the number of the points another name"
                )
            } else {
                format!("two columns have the name `{name}`")
            };
            return Err(SweepError::Invalid(reason));
        }
        let columns = [of_points, kept].concat();
        let declaration = json!({
            "name": self.sweep.name,
            "design": self.sweep.declaration(),
            "task": task,
            "columns": columns.iter().map(|column| json!([column.name, column.unit])).collect::<Vec<_>>(),
            "size of shards": self.rows_of_shard(columns.len()),
            "version": self.version,
            "pendulum-sweep": env!("CARGO_PKG_VERSION"),
        });
        Ok(Table {
            rows: 0,
            numbers: vec![Vec::new(); columns.len()],
            columns,
            failures: BTreeMap::new(),
            declaration: declaration.to_string(),
        })
    }

    /// Computes and writes a shard, and returns the number of its rows that failed.
    fn write(&self, shards: &Shards<'_>, n: usize, progress: &ProgressBar) -> Result<usize, SweepError> {
        let shard = Mutex::new(shards.begin(n));
        self.rows(shards.rows(n), progress, |first, points, chunk| {
            let shard = &mut locked(&shard);
            shard.keep(first, chunk.columns(points));
            for (row, reason) in chunk.failures {
                shard.fail(first + row, reason);
            }
        })?;
        let shard = shard.into_inner().unwrap_or_else(PoisonError::into_inner);
        let failed = shard.failed();
        shards.write(n, shard)?;
        Ok(failed)
    }

    /// Computes rows in chunks on all threads, and passes each chunk to `keep` with the index of its first row within
    /// `rows`.
    fn rows(
        &self,
        rows: Range<usize>,
        progress: &ProgressBar,
        keep: impl Fn(usize, &[[f64; K]], Chunk) + Sync,
    ) -> Result<(), SweepError> {
        // smaller chunks if there are few rows, so that all threads have work
        let size = self.task.chunk().min(rows.len().div_ceil(rayon::current_num_threads()));
        let compute = |first: usize| {
            let of_chunk = first..rows.end.min(first + size);
            let points = self.sweep.points_of(of_chunk.clone());
            let results = catch_unwind(AssertUnwindSafe(|| self.task.run(&points))).unwrap_or_else(|panic| {
                eprintln!("this was in one of the rows {} to {}", of_chunk.start, of_chunk.end - 1);
                resume_unwind(panic)
            });
            keep(first - rows.start, &points, results?);
            progress.inc(points.len() as u64);
            Ok(())
        };
        let firsts: Vec<usize> = rows.clone().step_by(size).collect();
        firsts.into_par_iter().try_for_each(compute)
    }

    fn in_threads<R: Send>(&self, work: impl FnOnce() -> Result<R, SweepError> + Send) -> Result<R, SweepError> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(self.threads).build();
        pool.map_err(|error| SweepError::Invalid(error.to_string()))?
            .install(work)
    }

    /// Progress bar on the terminal.
    fn progress(&self, rows: usize) -> ProgressBar {
        if self.quiet {
            return ProgressBar::hidden();
        }
        let template = "{bar:40} {human_pos} of {human_len}, {rate} a second, {eta} left";
        let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        let rate = |state: &ProgressState, text: &mut dyn fmt::Write| {
            // ignore errors of the text, which is then not shown
            let _ = write!(text, "{}", HumanCount(state.per_sec() as u64));
        };
        ProgressBar::new(rows as u64).with_style(style.with_key("rate", rate))
    }
}

/// Locks a mutex, even after a panic in another thread: then the whole job panics anyway.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Task of [`Sweep::each`].
pub struct Each<F, const Q: usize> {
    columns: [Column; Q],
    find: F,
}

impl<F, const K: usize, const Q: usize> Task<K> for Each<F, Q>
where
    F: Fn([f64; K]) -> Result<[f64; Q], Failure> + Sync,
{
    fn describe(&self, _sweep: &Sweep<K>) -> (Vec<Column>, Value) {
        (self.columns.to_vec(), json!("each"))
    }

    fn run(&self, points: &[[f64; K]]) -> Result<Chunk, SweepError> {
        let mut chunk = Chunk::default();
        for &point in points {
            match (self.find)(point) {
                Ok(numbers) => chunk.push(numbers),
                Err(reason) => chunk.fail([f64::NAN; Q], reason),
            }
        }
        Ok(chunk)
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            rows,
            computed,
            failed,
            time,
            complete,
        } = self;
        let seconds = time.as_secs_f64();
        write!(f, "{computed} of {rows} rows in {seconds:.1} s")?;
        if *computed > 0 {
            write!(f, ", {:.0} per second", *computed as f64 / seconds)?;
        }
        if *failed > 0 {
            write!(f, ", of which {failed} failed")?;
        }
        f.write_str(if *complete {
            ""
        } else {
            "; merge the shares when all are done"
        })
    }
}

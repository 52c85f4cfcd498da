//! Jobs as command-line programs.

use std::path::{Path, PathBuf};

use crate::error::SweepError;
use crate::job::{Job, Task};

/// Command-line arguments of a sweep.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Arguments {
    /// `--out FILE`: output file, in place of the default.
    pub out: Option<PathBuf>,
    /// `--shard I/N`: computes share `I`, from 0, of `N`.
    pub share: Option<(usize, usize)>,
    /// `--merge`: assembles the file from the shards of all shares.
    pub merge: bool,
    /// `--threads N`.
    pub threads: Option<usize>,
    /// `--quiet`: shows no progress.
    pub quiet: bool,
    /// `--help`: only prints the usage.
    pub help: bool,
}

const USAGE: &str = "usage: [--out FILE] [--shard I/N | --merge] [--threads N] [--quiet] [--help]
  --out FILE   the Parquet file
  --shard I/N  computes share I of N, counted from 0; --merge puts them together when all are done
  --threads N  threads in place of one for each core
  --quiet      shows no progress
  --help       shows this";

impl Arguments {
    /// Parses the arguments of a program, without the program's name.
    ///
    /// # Errors
    /// [`SweepError::Invalid`] with a usage text.
    pub fn parse(arguments: impl IntoIterator<Item = String>) -> Result<Self, SweepError> {
        let mut parsed = Self::default();
        let mut arguments = arguments.into_iter();
        let wrong = |what: String| SweepError::Invalid(format!("{what}\n{USAGE}"));
        while let Some(argument) = arguments.next() {
            let mut value = || {
                arguments
                    .next()
                    .ok_or_else(|| wrong(format!("{argument} takes a value")))
            };
            match argument.as_str() {
                "--out" => parsed.out = Some(value()?.into()),
                "--shard" => {
                    let text = value()?;
                    let share = text
                        .split_once('/')
                        .and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
                    let share = share.filter(|(index, of)| index < of);
                    let rule = || wrong(format!("--shard {text}: it is I/N with I from 0 to N - 1, as 0/4"));
                    parsed.share = Some(share.ok_or_else(rule)?);
                }
                "--merge" => parsed.merge = true,
                "--threads" => {
                    let text = value()?;
                    let rule = |_| wrong(format!("--threads {text}: it is a number"));
                    parsed.threads = Some(text.parse().map_err(rule)?);
                }
                "--quiet" => parsed.quiet = true,
                "--help" | "-h" => parsed.help = true,
                _ => return Err(wrong(format!("unknown argument {argument}"))),
            }
        }
        if parsed.merge && parsed.share.is_some() {
            return Err(wrong("--merge is for all shares: leave out --shard".to_owned()));
        }
        Ok(parsed)
    }
}

impl<T: Task<K>, const K: usize> Job<T, K> {
    /// Runs the job according to the command line of the program and prints a summary; see [`Arguments`]. The output
    /// goes to `path` unless `--out` names another file.
    ///
    /// With the feature `mpi`, processes started by `mpirun` share the shards; each takes the next shard when it has
    /// finished one. If one process fails, all of them end.
    ///
    /// # Errors
    /// [`SweepError::Invalid`] if the arguments are wrong, and the errors of [`obey`](Self::obey).
    pub fn main(self, path: impl AsRef<Path>) -> Result<(), SweepError> {
        self.obey(Arguments::parse(std::env::args().skip(1))?, path)
    }

    /// Like [`main`](Self::main), but with arguments that the program supplies.
    ///
    /// # Errors
    /// The errors of [`run_to`](Self::run_to) and [`merge`](Self::merge).
    pub fn obey(mut self, arguments: Arguments, path: impl AsRef<Path>) -> Result<(), SweepError> {
        if arguments.help {
            println!("{USAGE}");
            return Ok(());
        }
        let path = arguments.out.unwrap_or_else(|| path.as_ref().to_owned());
        #[cfg(feature = "mpi")]
        let ranks = crate::ranks::Ranks::of_program();
        if arguments.merge {
            #[cfg(feature = "mpi")]
            if ranks.as_ref().is_some_and(|ranks| !ranks.is_first()) {
                return Ok(());
            }
            self.merge(&path)?;
            println!("{}", path.display());
            return Ok(());
        }
        if let Some((index, of)) = arguments.share {
            self = self.share(index, of);
        }
        if let Some(threads) = arguments.threads {
            self = self.threads(threads);
        }
        if arguments.quiet {
            self = self.quiet();
        }
        #[cfg(feature = "mpi")]
        if let Some(ranks) = ranks {
            let summary = self.run_on(&ranks, &path).unwrap_or_else(|error| ranks.abort(&error));
            if ranks.is_first() {
                println!("{}: {summary}", path.display());
            }
            return Ok(());
        }
        println!("{}: {}", path.display(), self.run_to(&path)?);
        Ok(())
    }
}

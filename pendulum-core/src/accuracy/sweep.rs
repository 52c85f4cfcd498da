//! Interleaved measurement of methods and settings.

use std::fmt;
use std::hint::black_box;
use std::rc::Rc;

use nalgebra::SVector;

use crate::accuracy::timing::{Timer, in_turns};
use crate::accuracy::{Errors, Failure, Measured, MethodRuns, Problem, Report, Run};
use crate::ensemble::{Ensemble, EnsembleError};
use crate::method::Method;
use crate::statistics::Statistics;
use crate::system::System;

/// Work-precision measurement: methods with lists of settings, on one [`Problem`].
pub struct Sweep<'a, S, const N: usize> {
    problem: Problem<'a, S, N>,
    methods: Vec<(String, Vec<Trial<'a, S, N>>)>,
    rounds: usize,
}

/// One method with one setting.
struct Trial<'a, S, const N: usize> {
    setting: f64,
    /// Integrates with a record and computes the errors.
    judge: Box<Judge<'a, S, N>>,
    /// Integrates without a record, for timing.
    run: Box<Rerun<'a, S, N>>,
    /// Number of trajectories of a run.
    count: usize,
}

type Rerun<'a, S, const N: usize> = dyn Fn(&Problem<'a, S, N>) + 'a;
type Judge<'a, S, const N: usize> = dyn Fn(&Problem<'a, S, N>) -> Result<(Errors, Option<Statistics>), Failure> + 'a;

impl<'a, S: System<f64, N> + 'a, const N: usize> Sweep<'a, S, N> {
    /// A sweep of 15 rounds, without methods.
    #[must_use]
    pub fn new(problem: Problem<'a, S, N>) -> Self {
        Self {
            problem,
            methods: Vec::new(),
            rounds: 15,
        }
    }

    /// Sets the number of timings per setting, at least one; see [`run`](Self::run).
    #[must_use]
    pub fn rounds(mut self, rounds: usize) -> Self {
        self.rounds = rounds.max(1);
        self
    }

    /// Adds the method `make(setting)` for each of the settings, which are tolerances or step sizes.
    #[must_use]
    pub fn method<M>(
        self,
        name: impl Into<String>,
        settings: impl IntoIterator<Item = f64>,
        make: impl Fn(f64) -> M,
    ) -> Self
    where
        M: Method<S, f64, N> + 'a,
    {
        self.add(name, settings, |setting| {
            let method = Rc::new(make(setting));
            let same = Rc::clone(&method);
            Trial {
                setting,
                judge: Box::new(move |problem| judge(&*method, problem)),
                run: Box::new(move |problem| {
                    // `judge` has checked that the integration succeeds.
                    let stepper = same.stepper(problem.system, problem.t0, problem.t1, black_box(problem.x0));
                    let _ = black_box(stepper.and_then(|mut stepper| stepper.run()));
                }),
                count: 1,
            }
        })
    }

    /// Adds the ensemble method `make(setting)` for each of the settings. It integrates from the initial condition of
    /// the problem together with all of `more`.
    ///
    /// Only the trajectory of the problem is compared with the reference; times are per trajectory.
    #[must_use]
    pub fn ensemble<M>(
        self,
        name: impl Into<String>,
        settings: impl IntoIterator<Item = f64>,
        more: &[SVector<f64, N>],
        make: impl Fn(f64) -> M,
    ) -> Self
    where
        M: Ensemble<S, f64, N> + 'a,
    {
        let starts: Rc<[_]> = [self.problem.x0].iter().chain(more).copied().collect();
        let count = starts.len();
        self.ends(name, settings, count, |setting| {
            let (method, starts) = (make(setting), Rc::clone(&starts));
            move |problem| {
                let models = std::slice::from_ref(problem.system);
                let ends = method.ensemble(models, problem.t0, problem.t1, black_box(&starts));
                Ok(ends.map_err(|error| first_failure(&error, problem.t0))?[0])
            }
        })
    }

    /// Adds any other solver for each of the settings: `solve(setting)` returns the state at the end of the problem.
    #[must_use]
    pub fn other(
        self,
        name: impl Into<String>,
        settings: impl IntoIterator<Item = f64>,
        solve: impl Fn(f64) -> Result<SVector<f64, N>, Failure> + 'a,
    ) -> Self {
        let solve = Rc::new(solve);
        self.ends(name, settings, 1, |setting| {
            let solve = Rc::clone(&solve);
            move |_| solve(black_box(setting))
        })
    }

    /// Runs the measurement: first all errors, then the times in rounds. Each round runs every setting once, in turn.
    ///
    /// A time covers an integration without a record, including the construction of the stepper. Short runs are
    /// repeated within a measurement, after one that is not measured. Settings that fail are not timed.
    ///
    /// # Panics
    /// If a method reports success before the end of the span.
    #[must_use]
    pub fn run(self) -> Report {
        let problem = &self.problem;
        let mut methods = Vec::new();
        for (name, trials) in &self.methods {
            let runs = trials.iter().map(|trial| {
                let outcome = (trial.judge)(problem);
                (trial, outcome.map(|found| (found, Timer::new(|| (trial.run)(problem)))))
            });
            methods.push((name, runs.collect::<Vec<_>>()));
        }
        let runs = methods.iter_mut().flat_map(|(_, runs)| runs);
        in_turns(
            runs.filter_map(|(_, outcome)| Some(&mut outcome.as_mut().ok()?.1)),
            self.rounds,
        );
        let methods = methods.into_iter().map(|(name, runs)| MethodRuns {
            name: name.clone(),
            runs: runs
                .into_iter()
                .map(|(trial, outcome)| finish(trial, outcome))
                .collect(),
        });
        Report {
            methods: methods.collect(),
            uncertainty: problem.reference.uncertainty(problem.t1),
        }
    }

    /// Adds a solver that returns only final states, of `count` trajectories.
    fn ends<F>(
        self,
        name: impl Into<String>,
        settings: impl IntoIterator<Item = f64>,
        count: usize,
        make: impl Fn(f64) -> F,
    ) -> Self
    where
        F: Fn(&Problem<'a, S, N>) -> Result<SVector<f64, N>, Failure> + 'a,
    {
        self.add(name, settings, |setting| {
            let solve = Rc::new(make(setting));
            let same = Rc::clone(&solve);
            Trial {
                setting,
                judge: Box::new(move |problem| {
                    let errors = Errors::at_end(problem.t1, &solve(problem)?, problem.reference);
                    Ok((errors.expect("the reference knows the end"), None))
                }),
                run: Box::new(move |problem| {
                    let _ = black_box(same(problem));
                }),
                count,
            }
        })
    }

    fn add(
        mut self,
        name: impl Into<String>,
        settings: impl IntoIterator<Item = f64>,
        trial: impl Fn(f64) -> Trial<'a, S, N>,
    ) -> Self {
        let trials = settings.into_iter().map(trial).collect();
        self.methods.push((name.into(), trials));
        self
    }
}

/// Result of [`Trial::judge`], and the work to time.
type Timed<'w> = ((Errors, Option<Statistics>), Timer<'w>);

fn finish<S, const N: usize>(trial: &Trial<'_, S, N>, outcome: Result<Timed<'_>, Failure>) -> Run {
    let measured = outcome.map(|((errors, work), mut timed)| {
        let (minimum, median) = timed.minimum_and_median();
        let count = trial.count as f64;
        Measured {
            errors,
            minimum: minimum / count,
            median: median / count,
            work,
        }
    });
    Run {
        setting: trial.setting,
        outcome: measured,
    }
}

/// Integrates twice: with a record for the errors, without one for the statistics.
fn judge<S, M, const N: usize>(method: &M, problem: &Problem<'_, S, N>) -> Result<(Errors, Option<Statistics>), Failure>
where
    S: System<f64, N>,
    M: Method<S, f64, N>,
{
    let Problem { system, t0, t1, x0, .. } = *problem;
    let solution = method.solve(system, t0, t1, x0).map_err(|error| Failure {
        t: error.t(),
        reason: error.reason,
    })?;
    let at_start = |reason| Failure { t: t0, reason };
    let mut stepper = method.stepper(system, t0, t1, x0).map_err(at_start)?;
    let end = stepper.run().map_err(at_start)?;
    assert_eq!((stepper.t(), solution.last()), (t1, (t1, end)), "not at the end");
    Ok((problem.errors(&solution), Some(stepper.statistics())))
}

/// Failure of the first trajectory that stopped.
fn first_failure<const N: usize>(error: &EnsembleError<f64, N>, t0: f64) -> Failure {
    match error {
        EnsembleError::InvalidInput(reason) => Failure { t: t0, reason: *reason },
        EnsembleError::Stopped { stopped, .. } => Failure {
            t: stopped[0].t,
            reason: stopped[0].reason,
        },
    }
}

impl<S, const N: usize> fmt::Debug for Sweep<'_, S, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = self.methods.iter().map(|(name, trials)| (name, trials.len()));
        f.debug_struct("Sweep")
            .field("problem", &self.problem)
            .field("settings", &names.collect::<Vec<_>>())
            .field("rounds", &self.rounds)
            .finish()
    }
}

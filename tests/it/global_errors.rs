//! Errors of whole trajectories: their estimates, and methods chosen by them.

use approx::assert_relative_eq;
use pendulum_core::accuracy::{Alternative, Setting, SolutionWithError, TuneError, Tuning, tune};
use pendulum_core::prelude::*;
use pendulum_core::{Canonical, Reason, TaylorSeries};
use testbed::random::{Random, share};
use testbed::scenes::{DoublePendulum, double_pendulum};

mechanism! {
    /// A driven pole on a sprung cart.
    pub Driven {
        params { k: N/m = 100, c: N s/m = 1 }
        gravity: [0, -9.8, 0],
        generate: [rhs, jacobian, energy, taylor, canonical],
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, spring: (k, 0), friction: c }
        body pole on cart {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle,
            torque: 0.5 N m * sin(3 rad/s * t),
        }
    }
}

mechanism! {
    /// A ball on a spring that bounces, on a slide that comes to rest against dry friction.
    pub Ball {
        params { mu: N = 0.5 }
        gravity: [0, -9.8, 0],
        generate: [rhs, jacobian, energy, taylor],
        wall floor { gap: y, restitution: 0.7 }
        body slide on ground { mass: 0.1, joint: prismatic(x), coordinate: x, dry_friction: mu }
        body ball on slide { mass: 1, joint: prismatic(y), coordinate: y, spring: (20, 0) }
    }
}

/// A motion over a span, with the exact state at its end.
struct Case<S, const N: usize> {
    model: S,
    t1: f64,
    x0: SVector<f64, N>,
    end: SVector<f64, N>,
}

impl<S: Jacobian<f64, N>, const N: usize> Case<S, N> {
    fn new(model: S, t1: f64, x0: SVector<f64, N>) -> Self {
        let method = Radau13::new().rtol(1e-14).atol(1e-14);
        let end = method
            .stepper(&model, 0.0, t1, x0)
            .and_then(|mut stepper| stepper.run());
        let end = end.expect("regular");
        Self { model, t1, x0, end }
    }

    /// Ratio of the true error to the estimated one, each of the largest component at the end.
    fn ratio(&self, solved: &SolutionWithError<f64, N>) -> f64 {
        (solved.solution.end() - self.end).amax() / solved.error().amax()
    }
}

/// A number whose logarithm is uniformly distributed.
fn spread(random: &mut Random, low: f64, high: f64) -> f64 {
    random.between(low.ln(), high.ln()).exp()
}

/// Ratios of true to estimated errors for random tolerances and steps, one per method and motion.
#[derive(Default)]
struct Ratios(Vec<(String, f64)>);

impl Ratios {
    fn of<S, const N: usize>(&mut self, case: &Case<S, N>, random: &mut Random)
    where
        S: Jacobian<f64, N> + TaylorSeries<f64, N> + Canonical<f64, N>,
    {
        let tolerance = spread(random, 1e-12, 1e-3);
        macro_rules! adaptive {
            ($($method:ident)*) => { $(
                let method = $method::new().rtol(tolerance).atol(tolerance).with_error();
                let solved = method.solve(&case.model, 0.0, case.t1, case.x0).expect("regular");
                self.0.push((format!("{} with {tolerance:.1e}", stringify!($method)), case.ratio(&solved)));
            )* };
        }
        adaptive!(Rk45 Tsit5 Vern7 Vern9 Taylor Rodas4 Rodas5P Radau5 Radau9 Radau13 Auto);
        let h = spread(random, 5e-3, 3e-2);
        macro_rules! fixed {
            ($($method:ident)*) => { $(
                let method = $method::new(h).with_error();
                let solved = method.solve(&case.model, 0.0, case.t1, case.x0).expect("regular");
                self.0.push((format!("{} with {h:.1e}", stringify!($method)), case.ratio(&solved)));
            )* };
        }
        fixed!(Rk4 Gauss4 Gauss6);
    }
}

#[test]
fn estimates_are_those_of_the_true_errors() {
    let mut ratios = Ratios::default();
    let cases = share(24);
    for seed in 0..cases as u64 {
        let random = &mut Random::new(seed);
        let (t1, reach) = (random.between(1.0, 8.0), random.between(0.2, 1.5));
        let mut start = || SVector::from_fn(|n, _| random.between(-reach, reach) * if n < 2 { 1.0 } else { 0.3 });
        let x0 = start();
        if seed % 2 == 0 {
            let model = double_pendulum(random.between(0.0, 0.5));
            ratios.of(&Case::new(model, t1, x0), random);
        } else {
            let (k, c) = (spread(random, 10.0, 1e3), spread(random, 0.5, 100.0));
            let model = Driven::new(DrivenParams { k, c }).expect("physical");
            ratios.of(&Case::new(model, t1, x0), random);
        }
    }
    let off: Vec<_> = ratios
        .0
        .iter()
        .filter(|(_, ratio)| !(0.3..3.0).contains(ratio))
        .collect();
    assert!(20 * off.len() <= ratios.0.len(), "{off:?}");
}

#[test]
fn estimates_cost_less_than_two_more_solutions() {
    let model = double_pendulum(0.1);
    let method = Vern9::new().rtol(1e-9).atol(1e-9);
    let solved = method
        .with_error()
        .solve(&model, 0.0, 10.0, [1.0, 0.5, 0.0, 0.0])
        .expect("regular");
    let alone = method.solve(&model, 0.0, 10.0, [1.0, 0.5, 0.0, 0.0]).expect("regular");
    assert_eq!(solved.solution, alone);
    assert_eq!(solved.errors.len(), alone.t().len());
    assert_eq!(solved.errors[0].amax(), 0.0);
    let (first, second) = (alone.statistics().evaluations, solved.statistics.evaluations);
    assert!(second < 2 * first, "{second} after {first}");
    let largest = solved.largest();
    assert!((0..4).all(|n| largest[n] >= solved.error()[n].abs() && largest[n] > 0.0));
}

#[test]
fn estimates_work_backward_in_time_and_in_single_precision() {
    let spring = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0]]));
    let method = Tsit5::new().rtol(1e-6).atol(1e-6).with_error();
    let solved = method.solve(&spring, 3.0, -7.0, [1.0, 0.0]).expect("regular");
    let error = solved.solution.end() - SVector::from([10_f64.cos(), 10_f64.sin()]);
    assert_relative_eq!(solved.error(), error, max_relative = 0.05);

    let spring = FnSystem(|_t: f32, x: &SVector<f32, 2>| SVector::from([x[1], -x[0]]));
    let method = Tsit5::new().rtol(1e-4).atol(1e-4).with_error();
    let solved = method.solve(&spring, 0.0, 10.0, [1.0, 0.0]).expect("regular");
    let error = solved.solution.end() - SVector::from([10_f32.cos(), -10_f32.sin()]);
    assert_relative_eq!(solved.error(), error, max_relative = 0.1);
}

#[test]
fn estimates_include_impacts_and_sticking() {
    let ball = Ball::new(BallParams::default()).expect("physical");
    let start = SVector::from([0.0, 1.0, 1.0, 0.0]);
    let method = Tsit5::new().rtol(1e-5).atol(1e-5).with_error();
    let solved = method.solve(&ball, 0.0, 1.0, start).expect("regular");
    let solution = &solved.solution;
    assert!(!solution.impacts().is_empty());
    // jumps of the rate are no errors
    assert!(solved.largest().amax() < 1e-3, "{}", solved.largest());

    let coarse = Rk4::new(0.1)
        .with_error()
        .solve(&ball, 0.0, 1.0, start)
        .expect("regular");
    let known = Vern9::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve(&ball, 0.0, 1.0, start)
        .expect("regular");
    let times = coarse.solution.t();
    for (n, error) in coarse.errors.iter().enumerate() {
        let is_jump = n > 0 && times[n] == times[n - 1] || times.get(n + 1) == Some(&times[n]);
        if !is_jump {
            let exact = coarse.solution.x()[n] - known.at(times[n]).expect("within");
            assert!((error - exact).amax() <= 0.3 * exact.amax() + 1e-10, "{error} {exact}");
        }
    }
}

#[test]
fn failures_of_either_integration_are_errors() {
    let explodes = FnSystem(|_t: f64, x: &SVector<f64, 1>| x.component_mul(x));
    let error = Vern7::new()
        .with_error()
        .solve(&explodes, 0.0, 2.0, [1.0])
        .expect_err("infinite at 1");
    assert!((error.t() - 1.0).abs() < 1e-3 && error.solution.t().len() > 5);
    let error = Vern7::new().rtol(1e-20).with_error().solve(&explodes, 0.0, 0.5, [1.0]);
    let reason = error.expect_err("below the least").reason;
    assert!(matches!(reason, Reason::InvalidInput { what: "rtol", .. }), "{reason}");

    // the second one takes shorter steps than permitted
    let method = Rk45::new().rtol(1e-4).atol(1e-4).h_min(0.3).with_error();
    let spring = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0]]));
    let error = method.solve(&spring, 0.0, 5.0, [1.0, 0.0]).expect_err("too short");
    assert!(matches!(error.reason, Reason::StepUnderflow { .. }), "{error}");
    assert_eq!(error.solution.t().len(), 1);
}

fn relative<const N: usize>(x: &SVector<f64, N>, known: &SVector<f64, N>) -> f64 {
    x.zip_map(known, |x, known| (x - known).abs() / known.abs().max(1.0))
        .amax()
}

/// Largest error of a method with a tolerance, and its mean number of evaluations.
fn measured<S, const N: usize>(cases: &[Case<S, N>], method: &impl Method<S, f64, N>) -> Option<(f64, f64)>
where
    S: System<f64, N>,
{
    let (mut error, mut evaluations) = (0.0_f64, 0.0);
    for case in cases {
        let mut stepper = method.stepper(&case.model, 0.0, case.t1, case.x0).expect("valid");
        error = error.max(relative(&stepper.run().ok()?, &case.end));
        evaluations += stepper.statistics().evaluations as f64 / cases.len() as f64;
    }
    Some((error, evaluations))
}

/// Evaluations of the first tolerance, from large to small ones, that keeps within an error.
fn first_within<M, S, const N: usize>(cases: &[Case<S, N>], error: f64, method: impl Fn(f64) -> M) -> f64
where
    M: Method<S, f64, N>,
    S: System<f64, N>,
{
    let tolerances = (2..=28).map(|n| 10_f64.powf(-0.5 * f64::from(n)));
    let within = |tolerance| measured(cases, &method(tolerance)).filter(|&(reached, _)| reached <= error);
    tolerances
        .into_iter()
        .find_map(within)
        .map_or(f64::INFINITY, |(_, evaluations)| evaluations)
}

/// Tunes for some starts, and returns the stated and the true error of the choice, and its evaluations over those of
/// the best tolerance of a sweep.
fn tuned<S>(model: &S, random: &mut Random) -> Option<(f64, f64, f64)>
where
    S: Jacobian<f64, 4> + TaylorSeries<f64, 4> + Copy,
{
    let (t1, reach) = (random.between(1.0, 6.0), random.between(0.2, 1.5));
    let error = spread(random, 1e-10, 1e-2);
    let count = 1 + random.below(6);
    let starts: Vec<_> = (0..count)
        .map(|_| SVector::from_fn(|_, _| random.between(-reach, reach)))
        .collect();
    let tuned = match tune(model, (0.0, t1), &starts, error) {
        Ok(tuned) => tuned,
        Err(TuneError::BelowUncertainty { .. }) => return None,
        Err(error) => panic!("{error}"),
    };
    let cases: Vec<_> = starts.iter().map(|&x0| Case::new(*model, t1, x0)).collect();
    let errors = cases
        .iter()
        .map(|case| relative(&tuned.run(case.x0).expect("regular"), &case.end));
    macro_rules! best {
        ($($method:ident)*) => {
            match tuned.chosen().name {
                $(stringify!($method) => first_within(&cases, error, |tol| $method::new().rtol(tol).atol(tol)),)*
                _ => f64::INFINITY,
            }
        };
    }
    let best = best!(Rk45 Tsit5 Vern7 Vern9 Taylor Rodas4 Rodas5P Radau5 Radau9 Radau13 Auto);
    Some((error, errors.fold(0.0, f64::max), tuned.chosen().evaluations / best))
}

#[test]
fn chosen_methods_keep_within_the_error_at_the_cost_of_the_best_setting() {
    let mut outcomes = Vec::new();
    let cases = share(24) as u64;
    for seed in 0..cases {
        let random = &mut Random::new(seed);
        outcomes.extend(match seed % 3 {
            0 => tuned(&double_pendulum(random.between(0.0, 0.5)), random),
            1 => tuned(&double_pendulum(spread(random, 10.0, 1e4)), random),
            _ => {
                let (k, c) = (spread(random, 10.0, 1e3), spread(random, 1.0, 1e3));
                tuned(&Driven::new(DrivenParams { k, c }).expect("physical"), random)
            }
        });
    }
    assert!(
        4 * outcomes.len() as u64 >= 3 * cases,
        "too many of {cases} are chaotic"
    );
    let beyond = outcomes.iter().filter(|(error, reached, _)| reached > error).count();
    let dear = outcomes.iter().filter(|(_, _, ratio)| *ratio > 1.5).count();
    assert!(
        20 * beyond <= outcomes.len() && dear <= outcomes.len().div_ceil(10),
        "{outcomes:?}"
    );
}

#[test]
fn steps_are_tuned_as_tolerances_are() {
    let model = double_pendulum(0.0);
    let starts = [[0.5, 0.2, 0.0, 0.0]].map(SVector::from);
    let case = Case::new(model, 2.0, starts[0]);
    let tuned = |tuning: Tuning<'_, DoublePendulum, 4>| {
        // the only others are much slower
        let slower = tuning
            .adaptive("Rk45", Rk45::new().h_max(1e-3))
            .adaptive("Tsit5", Tsit5::new().h_max(1e-3));
        *slower.run().expect("regular").chosen()
    };
    let tuning = || Tuning::new(&model, (0.0, 2.0), &starts, 1e-6);
    fn check(of: Alternative, name: &str, error: impl Fn(f64) -> Option<(f64, f64)>) {
        let Setting::Step(h) = of.setting else {
            panic!("{of:?} is no step")
        };
        let [at, beyond] = [h, 1.5 * h].map(|h| error(h).expect("regular").0);
        // which knows the end to a tenth of the error
        assert_relative_eq!(at, of.error, max_relative = 0.1);
        assert!(
            of.name == name && at <= 1e-6 && beyond > 5e-7,
            "{of:?}: {at:e} {beyond:e}"
        );
    }
    let cases = std::slice::from_ref(&case);
    check(tuned(tuning().fixed("Rk4", Rk4::new(1.0))), "Rk4", |h| {
        measured(cases, &Rk4::new(h))
    });
    check(tuned(tuning().fixed("Gauss4", Gauss4::new(1.0))), "Gauss4", |h| {
        measured(cases, &Gauss4::new(h))
    });
    check(tuned(tuning().fixed("Gauss6", Gauss6::new(1.0))), "Gauss6", |h| {
        measured(cases, &Gauss6::new(h))
    });
}

#[test]
fn a_motion_at_rest_is_tuned() {
    let model = double_pendulum(0.1);
    let tuned = tune(&model, (0.0, 5.0), &[SVector::zeros()], 1e-8).expect("at rest");
    assert_eq!(tuned.chosen().error, 0.0);
}

#[test]
fn what_cannot_be_tuned_is_refused() {
    let model = double_pendulum(0.0);
    let starts = [[2.0, 2.5, 0.0, 0.0]].map(SVector::from);
    let error_of = |outcome: Result<_, TuneError>| match outcome {
        Ok::<pendulum_core::accuracy::Tuned<'_, _, 4>, _>(tuned) => panic!("{tuned}"),
        Err(error) => error.to_string(),
    };
    let refused = |span, starts: &[_], error| error_of(tune(&model, span, starts, error));
    assert_eq!(
        refused((0.0, 1.0), &starts, 1e-16),
        "`error` is 1e-16: the error must be at least 8 ulps (1.8e-15), since states are rounded, and below 1"
    );
    assert!(refused((0.0, 0.0), &starts, 1e-6).contains("the span must not be empty"));
    assert!(refused((0.0, f64::NAN), &starts, 1e-6).contains("a time must be finite"));
    assert!(refused((0.0, 1.0), &[], 1e-6).contains("at least one start"));
    assert!(refused((0.0, 40.0), &starts, 1e-9).contains("shorten the span if the motion is chaotic"));
    // not confirmed by `Auto`, which is `Vern9` with tight tolerances
    let alone = Tuning::new(&model, (0.0, 100.0), &starts, 1e-3)
        .adaptive("Vern9", Vern9::new())
        .adaptive("Auto", Auto::new());
    assert!(error_of(alone.run()).contains("shorten the span if the motion is chaotic"));
    let fixed = Tuning::new(&model, (0.0, 1.0), &starts, 1e-6).canonical();
    assert!(error_of(fixed.run()).contains("at least two methods must be adaptive"));
    let scaled = Tuning::new(&model, (0.0, 1.0), &starts, 1e-6).explicit().scale(0.0);
    assert!(error_of(scaled.run()).contains("the scale must be positive"));

    assert!(refused((0.0, 1.0), &[SVector::repeat(f64::NAN)], 1e-6).contains("must be finite"));
    let cancelled = Tuning::new(&model, (0.0, 1.0), &starts, 1e-6)
        .explicit()
        .cancel(&|| true);
    assert_eq!(error_of(cancelled.run()), "the search for a method was cancelled");

    let explodes = FnSystem(|_t: f64, x: &SVector<f64, 4>| x.component_mul(x));
    let starts = [SVector::repeat(1.0)];
    let error = Tuning::new(&explodes, (0.0, 2.0), &starts, 1e-6)
        .explicit()
        .run()
        .expect_err("infinite at 1");
    let TuneError::TooFewSucceeded { failures } = &error else {
        panic!("{error}")
    };
    let names: Vec<_> = failures.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["Vern9", "Vern7", "Tsit5", "Rk45"]);
    assert!(
        failures.iter().all(|(_, failure)| (failure.t - 1.0).abs() < 0.01),
        "{error}"
    );
}

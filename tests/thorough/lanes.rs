//! Lanes against scalars, bit for bit, on every instruction set of the machine.

use std::fmt::Debug;

use nalgebra::SVector;
use pendulum_core::dense::Dense;
use pendulum_core::method::{Fixed, PowerSeries, Rosenbrock};
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::{F32x8, F32x16, F64x4, F64x8, Isa, Kernel, LaneElement, Lanes};
use pendulum_core::tableau::HairerWanner4;
use pendulum_core::{Cast, CastJacobian, EnsembleError, Float, Need, Observer, Real, Reason, SolveError};
use testbed::random::Random;
use testbed::robots::{Ur5, Ur5Params};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

/// True for identical numbers, and for two NaNs.
fn same<T: Float>(ours: T, theirs: T) -> bool {
    let (ours, theirs) = (ours.to_f64(), theirs.to_f64());
    ours.to_bits() == theirs.to_bits() || ours.is_nan() && theirs.is_nan()
}

/// Every operation in lanes `V`, on pairs of numbers with one lane for each.
struct Operations<'a, T>(&'a [(T, T)]);

impl<T: Float + Debug> Kernel<T> for Operations<'_, T> {
    type Output = ();

    fn run<V: Lanes<Scalar = T>>(self) {
        macro_rules! check {
            ($($operation:expr;)*) => { $( {
                /// Operation on scalars or on lanes.
                fn operation<R: Real>(a: R, b: R) -> R {
                    let operation: fn(R, R) -> R = $operation;
                    operation(a, b)
                }
                for numbers in self.0.chunks_exact(V::LANES) {
                    let result = operation(V::from_fn(|i| numbers[i].0), V::from_fn(|i| numbers[i].1));
                    for (i, &(a, b)) in numbers.iter().enumerate() {
                        let (ours, theirs) = (result.lane(i), operation(a, b));
                        assert!(same(ours, theirs), "{} of {a:?}, {b:?}: {ours:?}, not {theirs:?}",
                            stringify!($operation));
                    }
                }
            } )* };
        }
        for numbers in self.0.chunks_exact(V::LANES) {
            let (a, b) = (V::from_fn(|i| numbers[i].0), V::from_fn(|i| numbers[i].1));
            let (either, finite) = (a.select(a, b), a.all_finite());
            for (i, &(a, b)) in numbers.iter().enumerate() {
                assert!(same(either.lane(i), Lanes::select(a, a, b)), "{a:?}, {b:?}");
                assert!(a.is_finite() || !finite, "{a:?} is among those that are finite");
            }
        }
        assert!(V::from_fn(|i| V::Scalar::from_f64(i as f64)).all_finite());
        check! {
            |a, b| a + b;
            |a, b| a - b;
            |a, b| a * b;
            |a, b| a / b;
            |a, _| -a;
            |a, _| a.sqrt();
            |a, _| a.abs();
            |a, _| a.sin_cos().0;
            |a, _| a.sin_cos().1;
            |a, _| a.tan();
            |a, _| a.exp();
            |a, _| a.ln();
            |a, _| a.tanh();
            |a, _| a.signum();
            |a, b| a.atan2(b);
            |a, b| a.powf(b);
            |_, _| R::from_f64(0.1);
            |mut a, b| { a += b; a *= b; a -= b; a /= b; a };
        }
    }
}

/// Numbers of all kinds, mixed so that neighbours differ in kind.
fn numbers<T: Float>() -> Vec<(T, T)> {
    let special = [
        0.0,
        -0.0,
        1.0,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        6400.0,
        6401.0,
        1e5,
        1.1e5,
        -3e8,
        1e-40,
        5e-324,
    ];
    let mut random = Random::new(1);
    let mut number = || {
        let at = random.between(0.0, 4.0 * special.len() as f64) as usize;
        T::from_f64(special.get(at).copied().unwrap_or_else(|| random.between(-20.0, 20.0)))
    };
    (0..2048).map(|_| (number(), number())).collect()
}

#[test]
fn every_operation_gives_what_it_gives_for_a_scalar() {
    let (double, single) = (numbers::<f64>(), numbers::<f32>());
    Operations(&double).run::<F64x4>();
    Operations(&double).run::<F64x8>();
    Operations(&single).run::<F32x8>();
    Operations(&single).run::<F32x16>();
    for isa in Isa::available() {
        isa.run(Operations(&double));
        isa.run(Operations(&single));
        isa.run(Twice(Operations(&double)));
    }
}

/// Kernel on pairs of registers.
struct Twice<K>(K);

impl<T: Float, K: Kernel<T>> Kernel<T> for Twice<K> {
    type Output = K::Output;

    fn run<V: Lanes<Scalar = T>>(self) -> K::Output {
        self.0.run::<V::Double>()
    }
}

/// Pendulums that differ in every parameter, and initial conditions.
fn pendulums(count: usize) -> (Vec<DoublePendulum>, Vec<SVector<f64, 4>>) {
    let mut random = Random::new(2);
    let model = |random: &mut Random| {
        DoublePendulum::new(DoublePendulumParams {
            m: random.between(0.5, 2.0),
            inertia: random.between(0.5, 2.0),
            c: random.between(0.5, 2.0),
            d: random.between(0.5, 2.0),
            g: random.between(5.0, 15.0),
            gamma1: random.between(0.0, 0.1),
            gamma2: random.between(0.0, 0.1),
        })
        .expect("physical")
    };
    let models = (0..count).map(|_| model(&mut random)).collect();
    let starts = (0..count).map(|_| SVector::from_fn(|_, _| random.between(-3.0, 3.0)));
    (models, starts.collect())
}

/// Compares an ensemble on all instruction sets with trajectories solved one by one.
fn assert_ensemble<A, M, T, const N: usize>(method: A, models: &[M], (t0, t1): (T, T), starts: &[SVector<T, N>])
where
    A: Ensemble<M, T, N> + Method<M::In<T>, T, N>,
    M: Cast<N>,
    T: LaneElement + Debug,
{
    for isa in Isa::available() {
        let ends = method.ensemble_on(isa, models, t0, t1, starts).expect("regular");
        for (i, (end, start)) in ends.iter().zip(starts).enumerate() {
            let model = models.get(i).unwrap_or(&models[0]).cast::<T>();
            let alone = method.solve(&model, t0, t1, *start).expect("regular").end();
            assert!(
                end.iter().zip(&alone).all(|(&a, &b)| same(a, b)),
                "{isa:?}, {i}: {end:?} {alone:?}"
            );
        }
    }
}

#[test]
fn pendulums_that_differ() {
    // more than one group, the last of them partial
    let (models, starts) = pendulums(45);
    let single: Vec<_> = starts.iter().map(|x| x.map(|x| x as f32)).collect();
    macro_rules! assert_ensembles {
        ($($method:expr;)*) => { $(
            assert_ensemble($method, &models, (0.0, 2.0), &starts);
            assert_ensemble($method, &models, (1.0, -0.503), &starts);
            assert_ensemble($method, &models, (1.0, 1.0), &starts);
            assert_ensemble($method, &models, (0.0, 2.0), &single);
        )* };
    }
    assert_ensembles! {
        Rk4::new(0.01);
        Rk45::new();
        Rk45::new().h0(0.01).h_max(0.02);
        Vern9::new().rtol(1e-5);
        Taylor::new();
        Taylor::new().order(7);
        Fixed::<PowerSeries>::new(0.05);
        Rodas4::new();
        Rodas5P::new().rtol(1e-4);
        Fixed::<Rosenbrock<HairerWanner4, 6>>::new(0.05);
        Radau5::new();
        Auto::new();
        Gauss4::new(0.05);
    }
}

mechanism! {
    /// A pendulum whose friction varies in time.
    Braked {
        params { brake: N m s }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian],
        body bob on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle,
            torque: -brake*sin(3 rad/s*t)^8*dot(angle),
        }
    }
}

#[test]
fn the_stiff_beside_the_free() {
    let brakes = (0..45).map(|n| 10.0_f64.powf(0.1 * f64::from(n)));
    let models: Vec<_> = brakes
        .map(|brake| Braked::new(BrakedParams { brake }).expect("physical"))
        .collect();
    let starts: Vec<_> = (0..45).map(|n| SVector::from([0.05 * f64::from(n), 0.0])).collect();
    // from 1e-9 on, trajectories that turn stiff leave their lanes
    for tolerance in [1e-3, 1e-4, 1e-6, 2e-9, 1e-9] {
        let method = Auto::new().rtol(tolerance).atol(tolerance);
        assert_ensemble(method, &models, (0.0, 4.0), &starts);
        // the brake is on at the start, where a first step is unstable
        assert_ensemble(method, &models, (0.5, 1.0), &starts);
        let swings = || Event::new(|_, x: &SVector<f64, 2>| x[1]);
        let hangs = Event::new(|t, x: &SVector<f64, 2>| if t > 1.0 { x[0].abs() - 0.1 } else { 1.0 });
        // trajectories with the terminal event leave their lanes early
        let events = [[swings(), swings().rising()], [swings(), hangs.terminal()]];
        assert_observed(method, &models, (0.0, 2.0), &starts, &events);
        let switches = |n: usize| {
            let alone = method.solve(&models[n], 0.0, 4.0, starts[n]).expect("regular");
            alone.statistics().switches
        };
        // switches forth and back with each pulse of the brake that is strong enough
        assert_eq!(switches(0), 0);
        assert!(switches(44) >= 6, "{}", switches(44));
    }
}

/// `x'' = -sign(x) - x' / 10 + push sign(sin(7 t))`: forces that jump, at different times in each lane.
#[derive(Clone, Copy, Debug)]
struct Jolted<T = f64>(T);

impl<T: Real> System<T, 2> for Jolted<T> {
    #[inline(always)]
    fn rhs(&self, t: T, x: &SVector<T, 2>) -> SVector<T, 2> {
        let push = self.0 * (t * T::from_f64(7.0)).sin_cos().0.signum();
        SVector::from([x[1], push - x[0].signum() - x[1] * T::from_f64(0.1)])
    }
}

impl Cast<2> for Jolted {
    type In<T: Real> = Jolted<T>;

    fn cast<T: Real>(&self) -> Jolted<T> {
        Jolted(T::from_f64(self.0))
    }

    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Jolted<V> {
        Jolted(V::from_fn(|i| V::Scalar::from_f64(models(i).0)))
    }
}

impl<T: Real> Jacobian<T, 2> for Jolted<T> {
    #[inline(always)]
    fn jacobian(&self, _t: T, _x: &SVector<T, 2>) -> SMatrix<T, 2, 2> {
        SMatrix::<f64, 2, 2>::from([[0.0, 0.0], [1.0, -0.1]]).map(T::from_f64)
    }
}

impl CastJacobian<2> for Jolted {
    fn with_jacobian<T: Real>(model: &Jolted<T>) -> &impl Jacobian<T, 2> {
        model
    }
}

#[test]
fn forces_that_jump() {
    let mut random = Random::new(4);
    let models: Vec<_> = (0..45).map(|_| Jolted(random.between(0.1, 0.9))).collect();
    let starts: Vec<_> = (0..45)
        .map(|_| SVector::from_fn(|_, _| random.between(-1.0, 1.0)))
        .collect();
    for span in [(0.0, 3.0), (1.0, -2.0)] {
        assert_ensemble(Rk45::new(), &models, span, &starts);
        assert_ensemble(Tsit5::new().rtol(1e-9).atol(1e-9), &models, span, &starts);
        assert_ensemble(Vern7::new(), &models, span, &starts);
        assert_ensemble(Vern9::new(), &models, span, &starts);
        // the time derivative is a central difference, about a different time in each lane
        assert_ensemble(Rodas5P::new(), &models, span, &starts);
    }
    // steps across a jump are rejected
    let alone = Rk45::new().solve(&models[0], 0.0, 3.0, starts[0]).expect("regular");
    assert!(alone.statistics().rejected > 10);
}

#[test]
fn one_model_for_all() {
    let (models, starts) = pendulums(20);
    assert_ensemble(Rk4::new(0.01), &models[..1], (0.0, 1.0), &starts);
    assert_ensemble(Tsit5::new(), &models[..1], (0.0, 1.0), &starts);
    assert_ensemble(Taylor::new(), &models[..1], (0.0, 1.0), &starts);
}

#[test]
fn a_robot() {
    let mut random = Random::new(3);
    let starts: Vec<_> = (0..11)
        .map(|_| SVector::from_fn(|_, _| random.between(-1.0, 1.0)))
        .collect();
    let robot = [Ur5::new(Ur5Params {}).expect("physical")];
    assert_ensemble(Rk4::new(0.01), &robot, (0.0, 0.2), &starts);
    assert_ensemble(Vern7::new(), &robot, (0.0, 0.2), &starts);
}

#[test]
fn lanes_by_name() {
    let (models, starts) = pendulums(F64x8::LANES);
    let x = SVector::from_fn(|k, _| F64x8::from_fn(|lane| starts[lane][k]));
    let system = DoublePendulum::gather::<F64x8>(|lane| &models[lane]);
    let slope = system.rhs(F64x8::default(), &x);
    for (i, model) in models.iter().enumerate() {
        assert_eq!(slope.map(|slope| slope.lane(i)), model.rhs(0.0, &starts[i]));
    }
}

#[test]
#[should_panic(expected = "a lane below 4, not 4")]
fn no_such_lane() {
    let _ = F64x4::default().lane(4);
}

/// `x' = rate x^2`, which is infinite at `t = 1 / (rate x0)`.
#[derive(Clone, Copy, Debug)]
struct Burst<T = f64>(T);

impl<T: Real> System<T, 1> for Burst<T> {
    #[inline(always)]
    fn rhs(&self, _t: T, x: &SVector<T, 1>) -> SVector<T, 1> {
        SVector::from([self.0 * x[0] * x[0]])
    }
}

impl Cast<1> for Burst {
    type In<T: Real> = Burst<T>;

    fn cast<T: Real>(&self) -> Burst<T> {
        Burst(T::from_f64(self.0))
    }

    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Burst<V> {
        Burst(V::from_fn(|i| V::Scalar::from_f64(models(i).0)))
    }
}

#[test]
fn a_trajectory_that_bursts_is_named_and_spoils_no_other() {
    assert_burst(Rk4::new(0.01));
    assert_burst(Rk45::new());
    assert_burst(Vern7::new().max_steps(40));
    assert_burst(Rodas5P::new());
    assert_burst(Radau5::new());
    assert_burst(Auto::new());
}

impl<T: Real> Jacobian<T, 1> for Burst<T> {
    #[inline(always)]
    fn jacobian(&self, _t: T, x: &SVector<T, 1>) -> SMatrix<T, 1, 1> {
        SMatrix::from([[self.0 * (x[0] + x[0])]])
    }
}

impl CastJacobian<1> for Burst {
    fn with_jacobian<T: Real>(model: &Burst<T>) -> &impl Jacobian<T, 1> {
        model
    }
}

fn assert_burst<A: Ensemble<Burst, f64, 1> + Method<Burst, f64, 1>>(method: A) {
    let models = [0.1, 1.0, 0.2, 0.3].map(Burst);
    let starts = [1.0, 1.0, f64::NAN, 1.0].map(|x| SVector::from([x]));
    let error = method
        .ensemble(&models, 0.0, 2.0, &starts)
        .expect_err("a pole, and no number");
    assert!(
        error
            .to_string()
            .starts_with("2 of 4 trajectories stopped; trajectory 1 at t = "),
        "{error}"
    );
    let EnsembleError::Stopped { stopped, x } = error else {
        panic!("{error}");
    };
    let pole = method.solve(&models[1], 0.0, 2.0, starts[1]).expect_err("a pole");
    assert_eq!(
        (stopped[0].index, stopped[0].t, stopped[0].reason),
        (1, pole.t(), pole.reason)
    );
    assert_eq!(x[1], pole.x());
    assert_eq!((stopped[1].index, stopped[1].t), (2, 0.0));
    assert!(matches!(stopped[1].reason, Reason::InvalidInput { what: "x0", .. }));
    assert_eq!(stopped.len(), 2);
    for i in [0, 3] {
        assert_eq!(
            x[i],
            method.solve(&models[i], 0.0, 2.0, starts[i]).expect("regular").end()
        );
    }
}

#[test]
fn trajectories_that_stop_at_once_make_way_for_the_others() {
    let models: Vec<Burst> = (0..90)
        .map(|n| Burst(if n < 80 { f64::NAN } else { 0.01 * f64::from(n) }))
        .collect();
    let starts = vec![SVector::from([0.3]); models.len()];
    let method = Rk45::new();
    for isa in Isa::available() {
        let error = method.ensemble_on(isa, &models, 0.0, 2.0, &starts);
        let EnsembleError::Stopped { stopped, x } = error.expect_err("no number") else {
            panic!("valid input");
        };
        let mut indices: Vec<usize> = stopped.iter().map(|stopped| stopped.index).collect();
        indices.sort_unstable();
        assert_eq!(indices, (0..80).collect::<Vec<_>>(), "{isa:?}");
        for index in 80..90 {
            let end = method
                .solve(&models[index], 0.0, 2.0, starts[index])
                .expect("regular")
                .end();
            assert_eq!(x[index], end, "{isa:?}: {index}");
        }
    }
}

#[test]
fn steps_are_counted_for_each_trajectory() {
    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    let starts: Vec<_> = (0..40)
        .map(|n| SVector::from([0.05 * f64::from(n), 0.0, 0.0, 0.0]))
        .collect();
    let method = Rk45::new().max_steps(30);
    for isa in Isa::available() {
        let error = method.ensemble_on(isa, std::slice::from_ref(&model), 0.0, 5.0, &starts);
        let EnsembleError::Stopped { stopped, x } = error.expect_err("large swings take more steps") else {
            panic!("valid input");
        };
        for (index, start) in starts.iter().enumerate() {
            let stopped = stopped.iter().find(|stopped| stopped.index == index);
            match method.solve(&model, 0.0, 5.0, *start) {
                Ok(solution) => assert!(stopped.is_none() && x[index] == solution.end(), "{isa:?}: {index}"),
                Err(error) => {
                    assert_eq!(error.reason, Reason::TooManySteps { max_steps: 30 });
                    let stopped = stopped.expect("too many steps in lanes as well");
                    assert_eq!(
                        (stopped.t, stopped.reason),
                        (error.t(), error.reason),
                        "{isa:?}: {index}"
                    );
                    assert_eq!(x[index], error.x());
                }
            }
        }
        assert!((1..40).contains(&stopped.len()), "{}", stopped.len());
    }
}

#[test]
fn bad_input() {
    let what = |models: usize, starts: usize, h: f64, t1: f64| {
        let (models, starts) = (vec![Burst(0.1); models], vec![SVector::from([1.0]); starts]);
        match Rk4::new(h).ensemble(&models, 0.0, t1, &starts) {
            Err(EnsembleError::InvalidInput(Reason::InvalidInput { what, .. })) => Some(what),
            Ok(ends) => {
                assert_eq!(ends.len(), starts.len());
                None
            }
            Err(error) => panic!("{error}"),
        }
    };
    assert_eq!(what(2, 3, 0.1, 1.0), Some("models"));
    assert_eq!(what(0, 3, 0.1, 1.0), Some("models"));
    assert_eq!(what(1, 3, -0.1, 1.0), Some("h"));
    assert_eq!(what(1, 3, f64::NAN, 1.0), Some("h"));
    assert_eq!(what(1, 3, 1e-18, 1.0), Some("h"));
    // also if nothing is integrated, and before models are counted
    assert_eq!(what(0, 0, -0.1, 1.0), Some("h"));
    assert_eq!(what(2, 3, -0.1, 1.0), Some("h"));
    assert_eq!(what(1, 3, 0.1, f64::INFINITY), Some("t1"));
    for (models, starts) in [(1, 3), (3, 3), (1, 0), (0, 0)] {
        assert_eq!(what(models, starts, 0.1, 1.0), None);
    }
    // settings are checked before anything is integrated, also without lanes
    let wrong = Radau5::new()
        .rtol(-1.0)
        .ensemble(&[Burst(0.1)], 0.0, 1.0, &[SVector::from([1.0])]);
    assert!(matches!(
        wrong,
        Err(EnsembleError::InvalidInput(Reason::InvalidInput { what: "rtol", .. }))
    ));
    let observers = &mut [(); 2].map(|()| Vec::new());
    let wrong = Tsit5::new().observe(&[Burst(0.1)], (0.0, 1.0), &[SVector::from([1.0])], |_| &[], observers);
    assert!(matches!(
        wrong,
        Err(EnsembleError::InvalidInput(Reason::InvalidInput {
            what: "observers",
            ..
        }))
    ));
}

/// `x' = rate(t) x`, with a rate of -1 before `t = self` and of 32 after it.
#[derive(Clone, Copy, Debug)]
struct Turns<T = f64>(T);

impl<T: Real> Turns<T> {
    fn rate(&self, t: T) -> T {
        let [rest, half] = [15.5, 16.5].map(T::from_f64);
        rest + half * (t - self.0).signum()
    }
}

impl<T: Real> System<T, 1> for Turns<T> {
    #[inline(always)]
    fn rhs(&self, t: T, x: &SVector<T, 1>) -> SVector<T, 1> {
        SVector::from([self.rate(t) * x[0]])
    }
}

impl<T: Real> Jacobian<T, 1> for Turns<T> {
    #[inline(always)]
    fn jacobian(&self, t: T, _x: &SVector<T, 1>) -> SMatrix<T, 1, 1> {
        SMatrix::from([[self.rate(t)]])
    }

    #[inline(always)]
    fn time_derivative(&self, _t: T, _x: &SVector<T, 1>) -> SVector<T, 1> {
        SVector::from([T::default()])
    }
}

impl Cast<1> for Turns {
    type In<T: Real> = Turns<T>;

    fn cast<T: Real>(&self) -> Turns<T> {
        Turns(T::from_f64(self.0))
    }

    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Turns<V> {
        Turns(V::from_fn(|i| V::Scalar::from_f64(models(i).0)))
    }
}

impl CastJacobian<1> for Turns {
    fn with_jacobian<T: Real>(model: &Turns<T>) -> &impl Jacobian<T, 1> {
        model
    }
}

#[test]
fn a_singular_matrix_stops_its_trajectory_alone() {
    fn check<A: Ensemble<Turns, f64, 1> + Method<Turns, f64, 1>>(method: A) {
        let models: Vec<_> = (0..40).map(|n| Turns(if n % 3 == 1 { 0.4 } else { 9.0 })).collect();
        let starts: Vec<_> = (0..40).map(|n| SVector::from([0.01 * f64::from(n + 1)])).collect();
        for isa in Isa::available() {
            let error = method
                .ensemble_on(isa, &models, 0.0, 1.0, &starts)
                .expect_err("singular");
            let EnsembleError::Stopped { stopped, x } = error else {
                panic!("{error}");
            };
            assert_eq!(stopped.len(), 13);
            for (n, (model, start)) in models.iter().zip(&starts).enumerate() {
                match method.solve(model, 0.0, 1.0, *start) {
                    Ok(solution) => assert_eq!(x[n], solution.end()),
                    Err(error) => {
                        let stopped = stopped.iter().find(|stopped| stopped.index == n).expect("it stopped");
                        assert_eq!((stopped.t, stopped.reason, x[n]), (error.t(), error.reason, error.x()));
                        // 1 - h gamma J is zero for J = 32
                        assert_eq!((error.t(), error.reason), (0.5, Reason::NoConvergence { h: 0.125 }));
                    }
                }
            }
        }
    }
    check(Rodas4::new().h0(0.125).h_min(0.125).h_max(0.125).atol(10.0));
    check(Fixed::<Rosenbrock<HairerWanner4, 6>>::new(0.125));
}

/// Compares the records of observers of an ensemble with trajectories solved one by one.
fn assert_observed<A, M, T, const N: usize>(
    method: A,
    models: &[M],
    (t0, t1): (T, T),
    starts: &[SVector<T, N>],
    events: &[[Event<'_, T, N>; 2]],
) where
    A: ObservedEnsemble<M, T, N> + Method<M::In<T>, T, N>,
    M: Cast<N>,
    T: LaneElement + Debug,
{
    let of = |n: usize| events[n % events.len()].as_slice();
    for isa in Isa::available() {
        let mut solutions: Vec<_> = starts.iter().map(|&x| Solution::start(t0, x)).collect();
        let ended = method.observe_on(isa, models, (t0, t1), starts, of, &mut solutions);
        let (ends, stopped) = match ended {
            Ok(ends) => (ends, Vec::new()),
            Err(EnsembleError::Stopped { x, stopped }) => (x, stopped),
            Err(error) => panic!("{error}"),
        };
        let mut stopped = stopped.iter().peekable();
        for (n, (solution, start)) in solutions.iter().zip(starts).enumerate() {
            let model = models.get(n).unwrap_or(&models[0]).cast::<T>();
            let stopped = stopped.next_if(|stopped| stopped.index == n);
            match method.solve_with(&model, t0, t1, *start, of(n)) {
                Ok(alone) => {
                    assert!(*solution == alone, "{isa:?}, {n}: {solution:?} {alone:?}");
                    assert!(stopped.is_none() && ends[n] == alone.end(), "{isa:?}, {n}");
                }
                Err(SolveError {
                    reason,
                    solution: alone,
                    ..
                }) => {
                    assert!(*solution == *alone, "{isa:?}, {n}: {solution:?} {alone:?}");
                    let stopped = stopped.expect("it stopped alone");
                    assert_eq!(stopped.reason, reason, "{isa:?}, {n}");
                }
            }
        }
        assert_eq!(stopped.next(), None);
    }
}

#[test]
fn observers_see_what_solutions_keep() {
    let (models, starts) = pendulums(37);
    let single: Vec<_> = starts.iter().map(|x| x.map(|x| x as f32)).collect();
    fn events<T: Float>() -> [[Event<'static, T, 4>; 2]; 4] {
        let turns = || Event::new(|_, x: &SVector<T, 4>| x[2]);
        let passes = || Event::new(|t, x: &SVector<T, 4>| x[0] + t - T::from_f64(0.5));
        [
            [turns(), passes().rising()],
            [turns(), passes().terminal()],
            [turns().falling().terminal(), passes()],
            // solved without lanes
            [turns().reset(|_, x| -x), passes()],
        ]
    }
    macro_rules! assert_all_observed {
        ($($method:expr;)*) => { $(
            assert_observed($method, &models, (0.0, 1.5), &starts, &events());
            assert_observed($method, &models, (1.0, 0.503), &starts, &events());
            assert_observed($method, &models, (1.0, 1.0), &starts, &events());
            assert_observed($method, &models[..1], (0.0, 0.6), &single, &events());
        )* };
    }
    assert_all_observed! {
        Tsit5::new();
        Vern9::new().rtol(1e-5);
        Taylor::new().order(7);
        Rodas5P::new().rtol(1e-4);
        Auto::new();
        Rk4::new(0.01);
    }
    assert_observed(Rk45::new().max_steps(30), &models, (0.0, 2.0), &starts, &events());
    // rejected steps
    let jolted: Vec<_> = (0..20).map(|n| Jolted(0.1 + 0.04 * f64::from(n))).collect();
    let starts: Vec<_> = (0..20)
        .map(|n| SVector::from([0.1 * f64::from(n) - 1.0, 0.5]))
        .collect();
    let never = || Event::new(|_, _: &SVector<f64, 2>| 1.0);
    assert_observed(Tsit5::new(), &jolted, (0.0, 3.0), &starts, &[[never(), never()]]);
    assert_observed(Rodas5P::new(), &jolted, (0.0, 3.0), &starts, &[[never(), never()]]);
    assert_observed(Auto::new(), &jolted, (0.0, 3.0), &starts, &[[never(), never()]]);
    // an event that is NaN from the start, or from a later time on
    let nowhere = |from: f64| Event::new(move |t: f64, _: &SVector<f64, 2>| if t < from { 1.0 } else { f64::NAN });
    let events = [[never(), never()], [never(), nowhere(0.0)], [never(), nowhere(1.5)]];
    assert_observed(Tsit5::new(), &jolted, (0.0, 3.0), &starts, &events);
    // trajectories that diverge
    let models: Vec<_> = (0..9).map(|n| Burst(0.2 * f64::from(n))).collect();
    let starts = [SVector::from([1.0]); 9];
    let never = || Event::new(|_, _: &SVector<f64, 1>| 1.0);
    assert_observed(Tsit5::new(), &models, (0.0, 2.0), &starts, &[[never(), never()]]);
    assert_observed(Rodas5P::new(), &models, (0.0, 2.0), &starts, &[[never(), never()]]);
    assert_observed(Auto::new(), &models, (0.0, 2.0), &starts, &[[never(), never()]]);
}

/// Observer that requests the dense output of every third step.
struct Third(usize, Vec<SVector<f64, 4>>);

impl Observer<f64, 4> for Third {
    fn needs(&self, _t0: f64, _t1: f64) -> Need {
        match self.0 % 3 {
            2 => Need::Inside,
            _ => Need::Ends,
        }
    }

    fn step(&mut self, dense: &Dense<'_, f64, 4>) {
        if self.0 % 3 == 2 {
            self.1.push(dense.at(dense.step().t0 + 0.3 * dense.step().h));
        }
        self.1.push(dense.step().x1);
        self.0 += 1;
    }
}

/// Observer of the ends of steps after the first second, which may cancel at once.
struct Late {
    ends: Vec<f64>,
    cancels: bool,
}

impl Observer<f64, 4> for Late {
    fn needs(&self, _t0: f64, t1: f64) -> Need {
        match t1 < 1.0 {
            true => Need::Nothing,
            false => Need::Ends,
        }
    }

    fn is_cancelled(&self) -> bool {
        self.cancels
    }

    fn step(&mut self, dense: &Dense<'_, f64, 4>) {
        self.ends.push(dense.step().t1);
    }
}

#[test]
fn steps_that_no_observer_needs_are_left_out() {
    let (models, starts) = pendulums(20);
    let late = |cancels| Late {
        ends: Vec::new(),
        cancels,
    };
    for isa in Isa::available() {
        let mut seen: Vec<_> = (0..20).map(|n| late(n % 3 == 2)).collect();
        let ended = Tsit5::new().observe_on(isa, &models, (0.0, 2.0), &starts, |_| &[], &mut seen);
        let Err(EnsembleError::Stopped { stopped, .. }) = ended else {
            panic!("{isa:?}: none was cancelled");
        };
        let mut cancelled: Vec<_> = stopped.iter().map(|own| own.index).collect();
        cancelled.sort_unstable();
        assert_eq!(cancelled, [2, 5, 8, 11, 14, 17], "{isa:?}");
        assert!(
            stopped
                .iter()
                .all(|own| own.reason == Reason::Cancelled && own.t > 0.0 && own.t < 1.0)
        );
        for (n, seen) in seen.iter().enumerate().filter(|(_, seen)| !seen.cancels) {
            let mut alone = late(false);
            let ended = Tsit5::new().follow(&models[n], 0.0, 2.0, starts[n], &[], &mut alone);
            ended.expect("regular");
            assert!(alone.ends == seen.ends && seen.ends[0] >= 1.0, "{isa:?}, {n}");
        }
    }
}

#[test]
fn no_more_steps_are_kept_than_fit() {
    let (models, starts) = pendulums(2);
    let mut solutions = starts
        .clone()
        .into_iter()
        .map(|start| Solution::start(0.0, start))
        .collect::<Vec<_>>();
    let error = Rk4::new(1e-8).observe(&models, (0.0, 1.0), &starts, |_| &[], &mut solutions);
    let Err(EnsembleError::InvalidInput(reason)) = error else {
        panic!("1e8 points");
    };
    assert!(reason.to_string().contains("ten million points"), "{reason}");
    assert_eq!(solutions[1].t().len(), 1);
}

#[test]
fn observers_look_into_the_steps_that_they_ask_for() {
    fn check<A: ObservedEnsemble<DoublePendulum, f64, 4> + Method<DoublePendulum, f64, 4>>(method: A) {
        let (models, starts) = pendulums(20);
        for isa in Isa::available() {
            let mut seen: Vec<_> = (0..20).map(|n| Third(n, Vec::new())).collect();
            method
                .observe_on(isa, &models, (0.0, 2.0), &starts, |_| &[], &mut seen)
                .expect("regular");
            for (n, seen) in seen.iter().enumerate() {
                let mut alone = Third(n, Vec::new());
                let end = method
                    .follow(&models[n], 0.0, 2.0, starts[n], &[], &mut alone)
                    .expect("regular");
                assert!(alone.1 == seen.1 && alone.1.last() == Some(&end), "{isa:?}, {n}");
                let solution = method.solve(&models[n], 0.0, 2.0, starts[n]).expect("regular");
                let (t, h) = (solution.t(), |k: usize| solution.t()[k + 1] - solution.t()[k]);
                let first = (2 + 3 * n - n) % 3;
                let within = solution.at(t[first] + 0.3 * h(first)).expect("within");
                assert!(seen.1.contains(&within), "{isa:?}, {n}");
            }
        }
    }
    check(Tsit5::new());
    check(Vern7::new());
    check(Rodas4::new());
    check(Radau5::new());
}

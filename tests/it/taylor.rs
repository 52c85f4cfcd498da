//! Generated recurrences of power series.

use nalgebra::SVector;
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::{F64x4, Isa, Kernel, Lanes};
use pendulum_core::taylor::MAX_ORDER;
use pendulum_core::{Cast, CastTaylor, TaylorSeries};
use testbed::power_series::{LENGTH, Series, difference, motion};
use testbed::problems::{HenonHeiles, HenonHeilesParams};
use testbed::random::Random;
use testbed::robots::{Panda, Ur5};
use testbed::series::*;
use testbed::trajectories::scene;

fn assert_series<M, const N: usize>(name: &str, model: &M)
where
    M: TaylorSeries<f64, N> + Cast<N>,
    M::In<f64>: TaylorSeries<f64, N>,
{
    let mut random = Random::new(7);
    let mut work = model.workspace();
    for _ in 0..5 {
        let mut x = [SVector::zeros(); LENGTH];
        x[0] = SVector::from_fn(|_, _| random.between(-1.5, 1.5));
        let t = random.between(-1.0, 1.0);
        model.series(t, &mut x, &mut work);
        let theirs = motion(&model.cast::<Series>(), t, x[0]);
        let difference = difference(&x, &theirs);
        assert!(difference < 1e-12, "{name}: {difference:e}");
    }
}

macro_rules! as_by_the_right_hand_side {
    ($($test:ident: $($model:ident),*;)*) => { $(
        /// The recurrences give the same series as the right-hand side evaluated on series.
        #[test]
        fn $test() {
            $( assert_series(stringify!($model), &$model::new(Default::default()).expect("physical")); )*
        }
    )* };
}

as_by_the_right_hand_side! {
    mechanisms: Pendulums, Elbow, Slides, Spring;
    robots: Ur5, Panda;
    functions: Tangent, Exponential, Logarithm, Root, Powers, Quotient, Saturated, Clamped, Angle, Drag, Driven;
}

fn pendulums(gamma: f64) -> Pendulums {
    let params = PendulumsParams {
        gamma1: gamma,
        gamma2: gamma,
        ..Default::default()
    };
    Pendulums::new(params).expect("physical")
}

/// Steps of a fixed length by series of a fixed order, against trajectories computed in 45 digits.
#[test]
fn reference_trajectories() {
    // at order 20 the series reaches far beyond the steps; the remaining errors are rounding, amplified by the chaotic
    // swing
    for (name, gamma, last, tolerance) in [("paper_gamma_0.1", 0.1, 20.0, 1e-14), ("large_swing", 0.0, 2.0, 1e-13)] {
        let (scene, model, h) = (scene(name), pendulums(gamma), 1.0 / 64.0);
        let mut work = model.workspace();
        let mut x = [SVector::zeros(); 21];
        x[0] = SVector::from(scene.start());
        let (mut t, mut compared) = (0.0, 0);
        for (time, state) in scene.points::<4>().into_iter().filter(|(time, _)| *time <= last) {
            while t < time {
                model.series(t, &mut x, &mut work);
                x[0] = x
                    .iter()
                    .rev()
                    .fold(SVector::zeros(), |sum: SVector<f64, 4>, x| sum * h + x);
                t += h;
            }
            assert_eq!(t, time, "{name}");
            let error = (x[0] - SVector::from(state)).amax();
            assert!(error < tolerance, "{name} at {t} s: {error:e}");
            compared += 1;
        }
        assert!(compared > 0, "{name}");
    }
}

/// Three angles with their sines and cosines, two squares of rates, two products with `sin(theta1 - theta2)`, and the
/// two products of `cos(theta1 - theta2)` with accelerations.
#[test]
fn eq_22_takes_twelve_products() {
    assert_eq!(Pendulums::COST["taylor"].products, Some(12));
    let most = [
        (Spring::COST, 0),
        (Elbow::COST, 66),
        (Ur5::COST, 142),
        (Panda::COST, 339),
    ];
    let counts = most.map(|(cost, _)| cost["taylor"].products.expect("a series"));
    assert!(
        counts.iter().zip(&most).all(|(count, (_, most))| count <= most),
        "{counts:?}"
    );
}

#[test]
fn every_order_by_itself() {
    let model = pendulums(0.1);
    let mut work = model.workspace();
    let mut longest = [SVector::from([2.0, 2.5, 0.3, -0.4]); MAX_ORDER + 1];
    model.series(0.0, &mut longest, &mut work);
    assert!(longest.iter().all(|x| x.iter().all(|x| x.is_finite())));
    let slope = model.rhs(0.0, &longest[0]);
    assert!((longest[1] - slope).amax() < 1e-14, "{} {slope}", longest[1]);
    // the previous use of a workspace does not matter
    model.series(0.0, &mut [SVector::from([0.1, -3.0, 5.0, 2.0]); 9], &mut work);
    for order in 0..=MAX_ORDER {
        let mut x = vec![longest[0]; order + 1];
        model.series(0.0, &mut x, &mut work);
        assert_eq!(x, longest[..=order]);
    }
    model.series(0.0, &mut [], &mut work);
}

#[test]
#[should_panic(expected = "the order of a series is at most 24")]
fn beyond_the_highest_order() {
    let model = pendulums(0.1);
    model.series(0.0, &mut [SVector::zeros(); MAX_ORDER + 2], &mut model.workspace());
}

#[test]
#[should_panic(expected = "the order of a series is at most 24")]
fn beyond_the_highest_order_of_a_few_products() {
    let model = HenonHeiles::new(HenonHeilesParams {}).expect("physical");
    model.series(0.0, &mut [SVector::zeros(); MAX_ORDER + 2], &mut model.workspace());
}

/// Kernel for series in lanes, each with its own initial condition and parameters.
struct Side<'a, M, const N: usize>(&'a [M], &'a [SVector<f64, N>]);

impl<M: CastTaylor<N>, const N: usize> Kernel<f64> for Side<'_, M, N>
where
    M::In<f64>: TaylorSeries<f64, N>,
{
    type Output = ();

    fn run<V: Lanes<Scalar = f64>>(self) {
        let system = M::gather::<V>(|lane| &self.0[lane]);
        let system = M::with_series::<V>(&system);
        let mut work = system.workspace();
        let mut x = [SVector::from_fn(|n, _| V::from_fn(|lane| self.1[lane][n])); LENGTH];
        system.series(V::from_f64(0.7), &mut x, &mut work);
        for lane in 0..V::LANES {
            let alone = self.0[lane].cast::<f64>();
            let mut scalar = [self.1[lane]; LENGTH];
            alone.series(0.7, &mut scalar, &mut alone.workspace());
            assert_eq!(x.map(|x| x.map(|x| x.lane(lane))), scalar);
        }
    }
}

fn assert_lanes<M: CastTaylor<N>, const N: usize>(models: &[M])
where
    M::In<f64>: TaylorSeries<f64, N>,
{
    let mut random = Random::new(11);
    let starts: Vec<_> = models
        .iter()
        .map(|_| SVector::from_fn(|_, _| random.between(-1.5, 1.5)))
        .collect();
    for isa in Isa::available() {
        isa.run(Side(models, &starts));
    }
    Side(models, &starts).run::<F64x4>();
}

/// Lanes equal scalars bit for bit, like everything in lanes.
#[test]
fn lanes() {
    let pendulums: Vec<_> = (0..8).map(|n| pendulums(0.1 * n as f64)).collect();
    assert_lanes(&pendulums);
    let models = |_| Powers::new(Default::default()).expect("physical");
    assert_lanes(&(0..8).map(models).collect::<Vec<_>>());
}

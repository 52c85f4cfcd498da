//! Generated recurrences of power series.

mod common;
#[path = "common/power_series.rs"]
mod power_series;
#[path = "common/series.rs"]
mod series;

use common::random::Random;
use nalgebra::SVector;
use pendulum_core::prelude::*;
use power_series::{LENGTH, Series};
use series::*;

/// The largest difference of two lists of coefficients, each component measured by its largest term at the end of a step as long as
/// the series of both reaches: where the last terms are as large as the first.
fn difference<const N: usize>(ours: &[SVector<f64, N>], theirs: &[SVector<f64, N>]) -> f64 {
    let size = |k: usize| theirs[k].amax();
    let last = theirs.len() - 1;
    let reach = (1..=last)
        .map(|k| (size(0) / size(k)).powf(1.0 / k as f64))
        .fold(f64::INFINITY, f64::min);
    let term = |k: usize| reach.powi(k as i32);
    let scale = (0..=last).map(|k| size(k) * term(k)).fold(0.0, f64::max);
    (0..=last)
        .map(|k| (ours[k] - theirs[k]).amax() * term(k) / scale)
        .fold(0.0, f64::max)
}

fn assert_series<M, const N: usize>(name: &str, model: &M)
where
    M: TaylorSeries<f64, N> + Model<N>,
    M::In<f64>: TaylorSeries<f64, N>,
{
    let mut random = Random::new(7);
    let mut work = model.workspace();
    for _ in 0..5 {
        let mut x = [SVector::zeros(); LENGTH];
        x[0] = SVector::from_fn(|_, _| random.between(-1.5, 1.5));
        let t = random.between(-1.0, 1.0);
        model.series(t, &mut x, &mut work);
        let theirs = power_series::motion(&model.cast::<Series>(), t, x[0]);
        let difference = difference(&x, &theirs);
        println!("{name}: {difference:e}");
        assert!(difference < 1e-12, "{name}: {difference:e}");
    }
}

macro_rules! as_by_the_right_hand_side {
    ($($test:ident: $($model:ident),*;)*) => { $(
        /// The recurrences give the series that the right-hand side gives when it computes with series.
        #[test]
        fn $test() {
            $( assert_series(stringify!($model), &$model::new(Default::default()).expect("physical")); )*
        }
    )* };
}

as_by_the_right_hand_side! {
    mechanisms: Pendulums, Elbow, Slides, Spring;
    functions: Tangent, Exponential, Logarithm, Root, Powers, Quotient, Saturated, Angle, Drag, Driven;
}

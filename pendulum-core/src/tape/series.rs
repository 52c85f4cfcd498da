//! Power series of the motions of a tape's model.

use nalgebra::SVector;

use super::model::Model;
use super::source::{Lists, Source};
use super::{Series, Tape};
use crate::constraint::{Hold, MAX_CONSTRAINTS};
use crate::hybrid::HeldSeries;
use crate::real::Real;
use crate::system::Cast;
use crate::taylor::{CastTaylor, HybridSeries, Newest, Products, TaylorSeries};

/// Number of products that are summed side by side.
const SIDE_BY_SIDE: usize = 4;

/// Memory for the series of a [`Model`].
#[derive(Clone, Debug)]
pub struct Workspace<T> {
    products: Vec<(Products<T, SIDE_BY_SIDE>, Newest<T, SIDE_BY_SIDE>)>,
    sums: Vec<T>,
    /// Factors of the products, filled up with zeros.
    factors: [Vec<T>; 2],
    kept: Vec<T>,
    /// Values of an order that are known before the forces along the constraints.
    carried: Vec<T>,
}

impl<T: Real> Workspace<T> {
    fn new(series: &Series) -> Self {
        let groups = series.products.div_ceil(SIDE_BY_SIDE);
        Self {
            products: vec![(Products::new(), Newest::new()); groups],
            sums: vec![T::default(); SIDE_BY_SIDE * groups],
            factors: [(); 2].map(|()| vec![T::default(); SIDE_BY_SIDE * groups]),
            kept: vec![T::default(); series.kept],
            carried: vec![T::default(); series.before.results.len()],
        }
    }
}

impl Tape {
    /// Series of the motion.
    fn needed_series(&self) -> &Series {
        #[cold]
        fn missing(name: &str) -> ! {
            panic!("the tape of `{name}` has no series: add `taylor` to its `generate`")
        }
        self.series.as_ref().unwrap_or_else(|| missing(&self.name))
    }
}

impl<T: Real, const N: usize, const HYBRID: bool> TaylorSeries<T, N> for Model<T, N, HYBRID> {
    type Workspace = Workspace<T>;

    fn workspace(&self) -> Workspace<T> {
        Workspace::new(self.tape.needed_series())
    }

    #[inline(always)]
    fn series(&self, t: T, x: &mut [SVector<T, N>], work: &mut Workspace<T>) {
        let Some(start) = x.first() else { return };
        let forces = self.sliding(t, start);
        let hold = Hold {
            forces,
            ..Hold::default()
        };
        self.eval_series(&hold, t, x, work);
    }

    #[inline]
    fn hybrid_series(&self) -> Option<&dyn HybridSeries<T, N, Workspace = Workspace<T>>> {
        self.is_hybrid().then_some(self)
    }
}

impl<T: Real, const N: usize, const HYBRID: bool> HybridSeries<T, N> for Model<T, N, HYBRID> {
    type Workspace = Workspace<T>;

    #[inline(always)]
    fn eval_series(&self, hold: &Hold<T>, t: T, x: &mut [SVector<T, N>], work: &mut Workspace<T>) {
        if x.len() < 2 {
            return;
        }
        let (series, constraints) = (self.tape.needed_series(), self.tape.constraints.len());
        let held = HeldSeries::new(self, hold, t, &x[0]);
        let start = x[0];
        let of_start = Lists::new()
            .with(Source::Time, core::slice::from_ref(&t))
            .with(Source::State, start.as_slice())
            .with(Source::Force, &held.forces);
        let mut rates = SVector::from([T::default(); N]);
        let places = rates.iter_mut().take(self.active).chain(&mut work.kept);
        self.write(&series.start, &of_start, places);
        x[1] = rates;
        held.pin(self, &mut x[1]);
        work.products.iter_mut().for_each(|(_, newest)| *newest = Newest::new());
        let mut over_next = T::from_f64(1.0);
        for k in 1..x.len() - 1 {
            let (order, over_order) = (T::from_f64(k as f64), over_next);
            over_next = T::from_f64(1.0) / T::from_f64((k + 1) as f64);
            let time = T::from_f64(if k == 1 { 1.0 } else { 0.0 });
            let (sums, _) = work.sums.as_chunks_mut::<SIDE_BY_SIDE>();
            for (sums, (products, newest)) in sums.iter_mut().zip(&work.products) {
                *sums = newest.add(products.sums(k));
            }
            let state = x[k];
            let others = |coefficients, carried| {
                [
                    (Source::StateCoefficient, state.as_slice()),
                    (Source::Sum, &work.sums),
                    (Source::Kept, &work.kept),
                    (Source::Carried, carried),
                    (Source::Order, core::slice::from_ref(&order)),
                    (Source::OverOrder, core::slice::from_ref(&over_order)),
                    (Source::TimeCoefficient, core::slice::from_ref(&time)),
                    (Source::ForceCoefficient, coefficients),
                ]
            };
            let mut accelerations = [T::default(); MAX_CONSTRAINTS];
            let places = accelerations[..constraints].iter_mut().chain(&mut work.carried);
            self.write(&series.before, &of_start.and(&others(&[], &[])), places);
            let forces = held.next(&accelerations);
            let [left, right] = &mut work.factors;
            let places = rates
                .iter_mut()
                .take(self.active)
                .chain(&mut left[..series.products])
                .chain(&mut right[..series.products]);
            self.write(&series.order, &of_start.and(&others(&forces, &work.carried)), places);
            let sides = left.as_chunks().0.iter().zip(right.as_chunks().0);
            for ((products, newest), (left, right)) in work.products.iter_mut().zip(sides) {
                newest.push(k, *left, *right);
                products.set(k, *left, *right);
            }
            x[k + 1] = rates.map(|rate| rate * over_next);
            held.pin(self, &mut x[k + 1]);
        }
    }
}

impl<const N: usize, const HYBRID: bool> CastTaylor<N> for Model<f64, N, HYBRID> {
    type Workspace<T: Real> = Workspace<T>;

    fn with_series<T: Real>(model: &<Self as Cast<N>>::In<T>) -> &impl TaylorSeries<T, N, Workspace = Workspace<T>> {
        model
    }
}

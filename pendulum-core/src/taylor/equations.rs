//! Power series of equations by hand: their operations are recorded at each start, and repeated for each order.
//!
//! A. Griewank, A. Walther, "Evaluating Derivatives", 2nd ed. (2008), chapter 13, has the recurrences. Every operation
//! of an order takes a sum over the lower orders of its operands, so that a series takes as many operations as a
//! generated one. Recording anew at each start lets the equations branch on values.

use nalgebra::SVector;

use super::recorded::Recorded;
use super::recording::{Recording, Rows, recorded_in};
use super::{CastTaylor, TaylorSeries};
use crate::real::Real;
use crate::system::{Equations, EquationsSystem};

impl<T: Real, E: Equations<N>, const N: usize> TaylorSeries<T, N> for EquationsSystem<E> {
    type Workspace = Recording<T>;

    fn workspace(&self) -> Recording<T> {
        Recording(None)
    }

    #[inline(always)]
    fn series(&self, t: T, x: &mut [SVector<T, N>], work: &mut Recording<T>) {
        if x.len() < 2 {
            return;
        }
        let (mut rows, rates) = record_rates(self, t, &x[0], work);
        let time = &mut rows.results[N];
        time[1..].fill(T::default());
        time[1] = T::from_f64(1.0);
        x[1] = rates.map(|rate| rate.value);
        for k in 1..x.len() {
            if k > 1 {
                let over = T::from_f64(1.0) / T::from_f64(k as f64);
                x[k] = rates.map(|rate| rate.place.map_or(T::default(), |place| over * rows.of(place)[k - 1]));
            }
            for (result, x) in rows.results.iter_mut().zip(&x[k]) {
                result[k] = *x;
            }
            if k + 1 < x.len() {
                rows.advance(k);
            }
        }
        work.0 = Some(rows);
    }
}

/// Records the right-hand side in the memory of `work`, and returns it with the rates.
#[inline(always)]
fn record_rates<T: Real, E: Equations<N>, const N: usize>(
    system: &EquationsSystem<E>,
    t: T,
    x: &SVector<T, N>,
    work: &mut Recording<T>,
) -> (Box<Rows<T>>, SVector<Recorded<T>, N>) {
    let rows = work.0.take().unwrap_or_default();
    recorded_in(rows, || {
        // rows of the state come first, then the one of time
        let x = x.map(Recorded::given);
        system.0.rhs(Recorded::given(t), &x)
    })
}

impl<E: Equations<N>, const N: usize> CastTaylor<N> for EquationsSystem<E> {
    type Workspace<T: Real> = Recording<T>;

    fn with_series<T: Real>(model: &Self) -> &impl TaylorSeries<T, N, Workspace = Recording<T>> {
        model
    }
}

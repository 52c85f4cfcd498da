//! Many trajectories with steps of the same length.

use std::marker::PhantomData;

use nalgebra::SVector;

use super::{Ensemble, EnsembleError, check_models, conclude, leave_alone, model_of};
use crate::method::{Explicit, Fixed, Grid, SHORT, attempt, check_span};
use crate::real::Float;
use crate::real::lanes::{Isa, Kernel, LaneElement, Lanes};
use crate::system::{Cast, System};
use crate::tableau::Tableau;

impl<M, B, T, const STAGES: usize, const N: usize> Ensemble<M, T, N> for Fixed<Explicit<B, STAGES>>
where
    M: Cast<N>,
    B: Tableau<STAGES>,
    T: LaneElement,
{
    fn ensemble_on(
        &self,
        isa: Isa,
        models: &[M],
        t0: T,
        t1: T,
        starts: &[SVector<T, N>],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<T, N>> {
        check_span(t0, t1)?;
        let grid = Grid::new(self.h, t0, t1)?;
        check_models(models, starts)?;
        let mut x = starts.to_vec();
        isa.run(March {
            method: PhantomData::<B>,
            models,
            grid,
            x: &mut x,
        });
        conclude(self, models, (t0, t1), starts, x)
    }
}

/// Trajectories on their way from the states `x`, which are replaced.
struct March<'a, B, M, T, const STAGES: usize, const N: usize> {
    method: PhantomData<B>,
    models: &'a [M],
    grid: Grid<T>,
    x: &'a mut [SVector<T, N>],
}

impl<B, M, T, const STAGES: usize, const N: usize> Kernel<T> for March<'_, B, M, T, STAGES, N>
where
    B: Tableau<STAGES>,
    M: Cast<N>,
    T: Float,
{
    type Output = ();

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) {
        // Further lanes fill the gaps where operations wait for one another. A longer system has enough that are independent, and
        // needs the registers for itself.
        if const { N <= SHORT } {
            self.in_groups::<<V::Double as Lanes>::Double>();
        } else if const { V::LANES > 1 } {
            self.in_groups::<V>();
        } else {
            leave_alone(self.x);
        }
    }
}

impl<B, M, T, const STAGES: usize, const N: usize> March<'_, B, M, T, STAGES, N>
where
    B: Tableau<STAGES>,
    M: Cast<N>,
    T: Float,
{
    /// As many trajectories at a time as there are lanes; where they run out, the last fills the group.
    #[inline(always)]
    fn in_groups<V: Lanes<Scalar = T>>(self) {
        for (group, states) in self.x.chunks_mut(V::LANES).enumerate() {
            let member = |lane: usize| lane.min(states.len() - 1);
            let system = M::gather::<V>(|lane| model_of(self.models, group * V::LANES + member(lane)));
            let x = SVector::from_fn(|k, _| V::from_fn(|lane| states[member(lane)][k]));
            let (x, slope) = march::<B, _, V, STAGES, N>(&system, self.grid, x);
            for (lane, state) in states.iter_mut().enumerate() {
                *state = x.map(|x| x.lane(lane));
                // The stepper requires a finite derivative at the end, too.
                if slope.iter().any(|slope| !slope.lane(lane).is_finite()) {
                    state.fill(T::from_f64(f64::NAN));
                }
            }
        }
    }
}

/// Goes to the end of the grid: the state and its derivative there.
#[inline(always)]
fn march<B, S, V, const STAGES: usize, const N: usize>(
    system: &S,
    mut grid: Grid<V::Scalar>,
    mut x: SVector<V, N>,
) -> (SVector<V, N>, SVector<V, N>)
where
    B: Tableau<STAGES>,
    S: System<V, N>,
    V: Lanes,
{
    let mut stages = [SVector::from_element(V::default()); STAGES];
    let mut t = grid.t0();
    if t != grid.t1() {
        stages[0] = system.rhs(V::splat(t), &x);
    }
    while t != grid.t1() {
        let t_new = grid.next();
        x = attempt::<B, _, _, _, _>(system, (V::splat(t), &x), V::splat(t_new), &mut stages);
        stages[0] = system.rhs(V::splat(t_new), &x);
        t = t_new;
    }
    (x, stages[0])
}

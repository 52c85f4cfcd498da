//! Integration in lanes with a fixed step size, of which only the final states are returned.

use nalgebra::SVector;

use super::check::{first_not_finite, in_lane, sum};
use super::in_lanes::Never;
use super::march::March;
use super::watch::Watch;
use super::{Expanded, InLanes, model_of};
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::{Hold, InMode};
use crate::method::{Accepted, Fixed, Grid, Scheme, Stalled, place};
use crate::real::lanes::{Kernel, LaneElement, Lanes};
use crate::statistics::Statistics;
use crate::system::Cast;

/// Four registers.
type Four<V> = <<V as Lanes>::Double as Lanes>::Double;
/// Eight registers.
type Eight<V> = <Four<V> as Lanes>::Double;

/// Time of a step on eight registers of 256 bits over that on four, for models that are [wide](Cast::WIDE).
const EIGHT_OVER_FOUR: f64 = 1.75;

/// True if a number of a model may take eight registers: those of 256 bits, of which the choice of an operation takes
/// as long as the operation on four or more.
const fn takes_eight<M, F, V, const N: usize>() -> bool
where
    M: Cast<N>,
    F: InLanes<M, V::Scalar, N>,
    V: Lanes,
    V::Scalar: LaneElement,
{
    M::WIDE && F::WIDE && V::LANES > 1 && size_of::<V>() == 32
}

impl<F, M, T, W, const N: usize> Kernel<T> for March<'_, Fixed<F>, M, T, W, N>
where
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    type Output = Result<(), Reason>;

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) -> Result<(), Reason> {
        if const { M::HYBRID } {
            self.one_by_one();
            return Ok(());
        }
        if const { takes_eight::<M, F, V, N>() } && self.fills_eight::<V>() {
            return if const { W::WATCHES } {
                self.in_lanes::<Eight<V>, Never<Eight<V>>>()
            } else {
                self.in_groups::<Eight<V>>()
            };
        }
        // Further lanes hide the latency of dependent operations. Larger systems have enough independent operations,
        // and need the registers for themselves.
        if const { M::WIDE && V::LANES > 1 && W::WATCHES } {
            self.in_lanes::<Four<V>, Never<Four<V>>>()
        } else if const { V::LANES > 1 && W::WATCHES } {
            self.in_lanes::<V, Never<V>>()
        } else if const { (M::WIDE || !F::NARROW) && !W::WATCHES } {
            self.in_groups::<Four<V>>()
        } else if const { V::LANES > 1 && !W::WATCHES } {
            self.in_groups::<V>()
        } else {
            self.one_by_one();
            Ok(())
        }
    }
}

impl<F, M, T, W, const N: usize> March<'_, Fixed<F>, M, T, W, N>
where
    F: InLanes<M, T, N>,
    M: Cast<N>,
    T: LaneElement,
    W: Watch<T, N>,
{
    /// True if the trajectories take less time on eight registers than on four, where fewer lanes are empty.
    fn fills_eight<V: Lanes>(&self) -> bool {
        let groups = |lanes: usize| self.x.len().div_ceil(lanes) as f64;
        EIGHT_OVER_FOUR * groups(8 * V::LANES) <= groups(4 * V::LANES)
    }

    /// Integrates as many trajectories at once as there are lanes; the last trajectory fills up an incomplete group.
    ///
    /// Non-finite numbers persist to the end, so only the final states are checked. Trajectories with a non-finite end
    /// are repeated alone to find time and reason; a check in every step would cost a tenth of the run time.
    #[inline(always)]
    fn in_groups<V: Lanes<Scalar = T>>(mut self) -> Result<(), Reason> {
        let grid = Grid::new(self.method.h, self.span.0, self.span.1)?;
        let mut failed = Vec::new();
        for (number, states) in self.x.chunks_mut(V::LANES).enumerate() {
            let first = number * V::LANES;
            let before = failed.len();
            let unplaced = if self.goes_on { 0 } else { states.len() };
            for (lane, state) in states.iter_mut().enumerate().take(unplaced) {
                let model = model_of(self.models, first + lane).cast::<T>();
                match place(&model, grid.t0(), state) {
                    Ok(placed) => *state = placed,
                    // The scalar run reports the reason.
                    Err(_) => failed.push(first + lane),
                }
            }
            let refused = before..failed.len();
            let member = |lane: usize| lane.min(states.len() - 1);
            let system = Expanded::<M, V, N>::gather(|lane| model_of(self.models, first + member(lane)));
            let scheme = self.method.family.stages::<V>(&system, None, false)?;
            let x = SVector::from_fn(|k, _| V::from_fn(|lane| states[member(lane)][k]));
            let ends = march(&system, scheme, x, grid);
            let all_are_finite = ends
                .as_ref()
                .is_ok_and(|(x, slope)| sum(x, slope.as_ref()).all_finite());
            for (lane, state) in states.iter_mut().enumerate() {
                if failed[refused.clone()].contains(&(first + lane)) {
                    continue;
                }
                match &ends {
                    Ok((x, slope)) if all_are_finite || first_not_finite(x, slope.as_ref(), lane).is_none() => {
                        *state = in_lane(x, lane);
                    }
                    _ => failed.push(first + lane),
                }
            }
        }
        self.alone(failed);
        Ok(())
    }
}

/// Integrates from the states `x` to the end of the grid. Returns the states there, and their derivatives for methods
/// that compute them.
#[inline(always)]
#[allow(clippy::type_complexity, reason = "a state and a derivative")]
fn march<C, S, V, const N: usize>(
    system: &S,
    mut scheme: C,
    x: SVector<V, N>,
    mut grid: Grid<V::Scalar>,
) -> Result<(SVector<V, N>, Option<SVector<V, N>>), Stalled>
where
    C: Scheme<S, V, N>,
    V: Lanes,
{
    let hold = Hold::default();
    let system = &InMode::new(system, &hold);
    let work = &mut Statistics::default();
    let mut t = grid.t0();
    let (mut states, mut others) = (x, x);
    // Swapping references avoids copies of the states.
    let (mut x, mut x_new) = (&mut states, &mut others);
    let mut slope = None;
    if t != grid.t1() {
        scheme.begin(system, V::splat(t), x, work);
    }
    while t != grid.t1() {
        let t_new = grid.next();
        let (start, end) = (V::splat(t), V::splat(t_new));
        scheme.attempt(system, (start, x), (end, x_new), work)?;
        let arrived = scheme.arrive(system, (end, x_new), work);
        if t_new == grid.t1() {
            slope = arrived.copied();
        }
        scheme.accept(system, &Step::new((start, *x), (end, *x_new)), Accepted::All, work);
        std::mem::swap(&mut x, &mut x_new);
        t = t_new;
    }
    Ok((*x, slope))
}

//! Many trajectories of one method, in the lanes of the machine's vector registers.

use std::error::Error;
use std::fmt;
use std::marker::PhantomData;

use nalgebra::SVector;

use crate::error::Reason;
use crate::method::{Explicit, Fixed, Grid, Method, SHORT, Scheme, Stepper, attempt, check_span, require};
use crate::real::Float;
use crate::real::lanes::{Isa, Kernel, Lane, Lanes};
use crate::system::{Model, System};
use crate::tableau::Tableau;

impl<B: Tableau<STAGES>, const STAGES: usize> Fixed<Explicit<B, STAGES>> {
    /// Integrates a model from each of many states at `t0` to `t1`, and returns the states there.
    ///
    /// There is one model for each start, or a single one for all. Each trajectory is bit for bit what [`solve`](Method::solve) gives
    /// for it alone; there is no record of the way. Beside the result no heap is used. Without optimisation, and with debug assertions,
    /// the code is not inlined as wide registers need it, and lanes are slower than scalars.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    ///
    /// mechanism! {
    ///     pub Swing {
    ///         params { l: m = 1.0 }
    ///         gravity: [0, -9.81, 0],
    ///         body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: angle }
    ///     }
    /// }
    ///
    /// let lengths = (1..=100).map(|i| Swing::new(SwingParams { l: 0.1 * f64::from(i) }));
    /// let swings = lengths.collect::<Result<Vec<_>, _>>()?;
    /// let starts = vec![SVector::from([0.5, 0.0]); swings.len()];
    /// let ends = Rk4::new(0.001).ensemble(&swings, 0.0, 10.0, &starts)?;
    /// assert_eq!(ends[41], Rk4::new(0.001).solve(&swings[41], 0.0, 10.0, starts[41])?.last().1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`EnsembleError::InvalidInput`] if there are neither one nor as many models as starts, or if times or step are not what
    /// [`solve`](Method::solve) takes. [`EnsembleError::Stopped`] names the trajectories that did not come to their end, a bad start
    /// included, and has the final states of the others.
    pub fn ensemble<M, T, const N: usize>(
        &self,
        models: &[M],
        t0: T,
        t1: T,
        starts: &[SVector<T, N>],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<N, T>>
    where
        M: Model<N>,
        T: Lane,
    {
        self.ensemble_on(Isa::widest(), models, t0, t1, starts)
    }

    /// [`ensemble`](Self::ensemble) with a given instruction set, for comparisons: the results are the same bits.
    ///
    /// # Errors
    /// As for [`ensemble`](Self::ensemble).
    pub fn ensemble_on<M, T, const N: usize>(
        &self,
        isa: Isa,
        models: &[M],
        t0: T,
        t1: T,
        starts: &[SVector<T, N>],
    ) -> Result<Vec<SVector<T, N>>, EnsembleError<N, T>>
    where
        M: Model<N>,
        T: Lane,
    {
        check_span(t0, t1)?;
        let grid = Grid::new(self.h, t0, t1)?;
        require(
            models.len() == 1 || models.len() == starts.len(),
            "models",
            models.len() as f64,
            "an ensemble takes one model for all starts, or one for each",
        )?;
        let mut x = starts.to_vec();
        isa.run(March {
            method: PhantomData::<B>,
            models,
            grid,
            x: &mut x,
        });
        let mut stopped = Vec::new();
        for (index, x) in x.iter_mut().enumerate() {
            if x.iter().any(|component| !component.is_finite()) {
                // The same trajectory alone tells where it ended, and why.
                let model = model_of(models, index).cast::<T>();
                let (t, reason);
                (t, *x, reason) = match self.stepper(&model, t0, t1, starts[index]) {
                    Ok(stepper) => to_the_end(stepper),
                    Err(reason) => (t0, starts[index], Some(reason)),
                };
                stopped.extend(reason.map(|reason| Stopped { index, t, reason }));
            }
        }
        if stopped.is_empty() {
            Ok(x)
        } else {
            Err(EnsembleError::Stopped { stopped, x })
        }
    }
}

/// The last good point, and if it is not the end, why.
fn to_the_end<C, S, T, const N: usize>(mut stepper: Stepper<'_, C, S, N, T>) -> (T, SVector<T, N>, Option<Reason>)
where
    C: Scheme<S, T, N>,
    S: System<T, N>,
    T: Float,
{
    let reason = stepper.run().err();
    (stepper.t(), stepper.x(), reason)
}

/// The model of trajectory `i`.
fn model_of<M>(models: &[M], i: usize) -> &M {
    if let [model] = models { model } else { &models[i] }
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
    M: Model<N>,
    T: Float,
{
    type Output = ();

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) {
        // Further lanes fill the gaps where operations wait for one another, but that of `f32` is two already where it computes
        // sines. A longer system has enough that are independent, and wants the registers for itself.
        if const { N > SHORT } {
            self.in_groups::<V>();
        } else if const { size_of::<T>() < size_of::<f64>() } {
            self.in_groups::<V::Double>();
        } else {
            self.in_groups::<<V::Double as Lanes>::Double>();
        }
    }
}

impl<B, M, T, const STAGES: usize, const N: usize> March<'_, B, M, T, STAGES, N>
where
    B: Tableau<STAGES>,
    M: Model<N>,
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
                // The stepper wants a finite derivative at the end, too.
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

/// A trajectory that ended before its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stopped<T = f64> {
    /// Its place among the starts.
    pub index: usize,
    /// The last good time.
    pub t: T,
    /// Why it ended.
    pub reason: Reason,
}

/// Why an ensemble did not come to its end as a whole.
#[derive(Clone, Debug, PartialEq)]
pub enum EnsembleError<const N: usize, T = f64> {
    /// A setting or an argument makes no sense; nothing was integrated.
    InvalidInput(Reason),
    /// Some trajectories ended before their time.
    Stopped {
        /// Which, in ascending order; at least one.
        stopped: Vec<Stopped<T>>,
        /// The final states of all others, and the last good states of these.
        x: Vec<SVector<T, N>>,
    },
}

impl<const N: usize, T> From<Reason> for EnsembleError<N, T> {
    fn from(reason: Reason) -> Self {
        Self::InvalidInput(reason)
    }
}

impl<const N: usize, T: Float> fmt::Display for EnsembleError<N, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::InvalidInput(reason) => reason.fmt(f),
            Self::Stopped { stopped, x } => {
                write!(f, "{} of {} trajectories stopped", stopped.len(), x.len())?;
                if let Some(Stopped { index, t, reason }) = stopped.first() {
                    write!(f, ", the first, {index}, at t = {}: {reason}", t.to_f64())?;
                }
                Ok(())
            }
        }
    }
}

impl<const N: usize, T: Float> Error for EnsembleError<N, T> {}

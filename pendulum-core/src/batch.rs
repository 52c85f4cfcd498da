//! Functions of many states at once, in the lanes of vector registers.
//!
//! Several states, as many as a register has lanes, are evaluated in the time of one. Each result has the bits of an
//! evaluation alone. Integrations of many trajectories are an [`ensemble`](crate::ensemble).
//!
//! ```
//! use pendulum_core::batch;
//! use pendulum_core::prelude::*;
//!
//! mechanism! {
//!     pub Swing {
//!         params { l: m = 1.0 }
//!         gravity: [0, -9.81, 0],
//!         body bob on ground { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: angle }
//!     }
//! }
//!
//! let swing = Swing::new(SwingParams::default())?;
//! let states: Vec<_> = (0..1000).map(|n| SVector::from([0.001 * f64::from(n), 0.0])).collect();
//! let mut rates = vec![SVector::zeros(); states.len()];
//! batch::rhs(&[swing], 0.0, &states, &mut rates)?;
//! assert_eq!(rates[700], swing.rhs(0.0, &states[700]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Pass one model for all states, or one for each, to let parameters differ. Large batches are shared between cores by
//! their parts, such as `par_chunks` of `rayon`.

use nalgebra::{SMatrix, SVector};

use crate::constraint::MAX_CONSTRAINTS;
use crate::ensemble::{check_lanes, check_number};
use crate::error::Reason;
use crate::inputs::{CastControlled, Controlled};
use crate::method::require;
use crate::real::Real;
use crate::real::lanes::{Isa, Kernel, LaneElement, Lanes};
use crate::system::{ActsWith, Cast, CastJacobian, Jacobian, System};

/// Rule for the number of models.
const ONE_OR_EACH: &str = "a batch takes one model for all states, or one for each";

/// Computes the right-hand sides at the time `t`, `rates[i]` from `states[i]`.
///
/// # Errors
/// [`Reason::InvalidInput`] if there is neither one model nor one for each state, or not one rate for each; and if the
/// models cannot share lanes, since they differ in laws of inputs or in equations by hand.
pub fn rhs<M, T, const N: usize>(
    models: &[M],
    t: T,
    states: &[SVector<T, N>],
    rates: &mut [SVector<T, N>],
) -> Result<(), Reason>
where
    M: Cast<N>,
    T: LaneElement,
{
    evaluate(&Rhs, models, t, states, rates)
}

/// Computes the Jacobians of the right-hand side at the time `t`, `jacobians[i]` from `states[i]`.
///
/// # Errors
/// See [`rhs`].
pub fn jacobian<M, T, const N: usize>(
    models: &[M],
    t: T,
    states: &[SVector<T, N>],
    jacobians: &mut [SMatrix<T, N, N>],
) -> Result<(), Reason>
where
    M: CastJacobian<N>,
    T: LaneElement,
{
    evaluate(&JacobianOfRhs, models, t, states, jacobians)
}

/// Computes the right-hand sides of models with inputs at the time `t`: `rates[i]` is that of `states[i]` under
/// `inputs[i]`, in the order of declaration. Models with constraints are evaluated without constraint forces.
///
/// # Errors
/// See [`rhs`]; there must be one vector of inputs for each state, too.
pub fn rhs_with_inputs<M, T, const N: usize, const K: usize>(
    models: &[M],
    t: T,
    states: &[SVector<T, N>],
    inputs: &[SVector<T, K>],
    rates: &mut [SVector<T, N>],
) -> Result<(), Reason>
where
    M: CastControlled<N, K>,
    T: LaneElement,
{
    check_number("models", models, states, ONE_OR_EACH)?;
    check_one_for_each("inputs", inputs, states)?;
    check_one_for_each("results", rates, states)?;
    if !states.is_empty() {
        Isa::widest().run(Held {
            models,
            t,
            states,
            inputs,
            rates,
        });
    }
    Ok(())
}

/// A function of the model, the time and the state, written once for all number types: an energy, an output, a cost.
///
/// The result is a matrix of `R` rows and `C` columns.
///
/// ```
/// use pendulum_core::Real;
/// use pendulum_core::batch::{self, StateFunction};
/// use pendulum_core::prelude::*;
///
/// mechanism! {
///     pub Swing {
///         gravity: [0, -9.81, 0],
///         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
///     }
/// }
///
/// struct TotalEnergy;
///
/// impl StateFunction<Swing, 2, 1> for TotalEnergy {
///     #[inline(always)]
///     fn value<T: Real>(&self, swing: &Swing<T>, t: T, x: &SVector<T, 2>) -> SVector<T, 1> {
///         SVector::from([swing.energy(t, x)])
///     }
/// }
///
/// let swing = Swing::new(SwingParams {})?;
/// let states = [SVector::from([0.5, 0.0]), SVector::from([1.0, 2.0])];
/// let mut energies = [SVector::zeros(); 2];
/// batch::evaluate(&TotalEnergy, &[swing], 0.0, &states, &mut energies)?;
/// assert_eq!(energies[1][0], swing.energy(0.0, &states[1]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait StateFunction<M: Cast<N>, const N: usize, const R: usize, const C: usize = 1> {
    /// Computes the value. It should be `#[inline(always)]`, as generated functions are: one that is not inlined is
    /// compiled for the baseline of the target, where lanes are slow.
    fn value<T: Real>(&self, model: &M::In<T>, t: T, x: &SVector<T, N>) -> SMatrix<T, R, C>;
}

/// Computes a function at the time `t`: `values[i]` is its value at `states[i]`.
///
/// # Errors
/// See [`rhs`].
pub fn evaluate<F, M, T, const N: usize, const R: usize, const C: usize>(
    function: &F,
    models: &[M],
    t: T,
    states: &[SVector<T, N>],
    values: &mut [SMatrix<T, R, C>],
) -> Result<(), Reason>
where
    F: StateFunction<M, N, R, C>,
    M: Cast<N>,
    T: LaneElement,
{
    check_number("models", models, states, ONE_OR_EACH)?;
    check_lanes(models)?;
    check_one_for_each("results", values, states)?;
    if !states.is_empty() {
        Isa::widest().run(Free {
            function,
            models,
            t,
            states,
            values,
        });
    }
    Ok(())
}

/// The right-hand side.
struct Rhs;

impl<M: Cast<N>, const N: usize> StateFunction<M, N, N> for Rhs {
    #[inline(always)]
    fn value<T: Real>(&self, model: &M::In<T>, t: T, x: &SVector<T, N>) -> SVector<T, N> {
        model.rhs(t, x)
    }
}

/// The Jacobian.
struct JacobianOfRhs;

impl<M: CastJacobian<N>, const N: usize> StateFunction<M, N, N, N> for JacobianOfRhs {
    #[inline(always)]
    fn value<T: Real>(&self, model: &M::In<T>, t: T, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        M::with_jacobian(model).rhs_and_jacobian(t, x).1
    }
}

/// Evaluation of a function of the state.
struct Free<'a, F, M, T, const N: usize, const R: usize, const C: usize> {
    function: &'a F,
    models: &'a [M],
    t: T,
    states: &'a [SVector<T, N>],
    values: &'a mut [SMatrix<T, R, C>],
}

impl<F, M, T, const N: usize, const R: usize, const C: usize> Kernel<T> for Free<'_, F, M, T, N, R, C>
where
    F: StateFunction<M, N, R, C>,
    M: Cast<N>,
    T: LaneElement,
{
    type Output = ();

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) {
        let (one, t) = (M::gather::<V>(|_| &self.models[0]), V::from_fn(|_| self.t));
        for places in Places::groups(self.states.len(), V::LANES) {
            let x = places.gather::<V, N>(self.states);
            let value = match self.models.len() {
                1 => self.function.value(&one, t, &x),
                _ => self
                    .function
                    .value(&M::gather::<V>(|lane| &self.models[places.of(lane)]), t, &x),
            };
            places.scatter(&value, self.values);
        }
    }
}

/// Evaluation of right-hand sides under inputs.
struct Held<'a, M, T, const N: usize, const K: usize> {
    models: &'a [M],
    t: T,
    states: &'a [SVector<T, N>],
    inputs: &'a [SVector<T, K>],
    rates: &'a mut [SVector<T, N>],
}

impl<M, T, const N: usize, const K: usize> Kernel<T> for Held<'_, M, T, N, K>
where
    M: CastControlled<N, K>,
    T: LaneElement,
{
    type Output = ();

    #[inline(always)]
    fn run<V: Lanes<Scalar = T>>(self) {
        let (one, t) = (M::gather::<V>(|_| &self.models[0]), V::from_fn(|_| self.t));
        for places in Places::groups(self.states.len(), V::LANES) {
            let (x, u) = (places.gather::<V, N>(self.states), places.gather::<V, K>(self.inputs));
            let rate = match self.models.len() {
                1 => under(&one, t, &x, u),
                _ => under(&M::gather::<V>(|lane| &self.models[places.of(lane)]), t, &x, u),
            };
            places.scatter(&rate, self.rates);
        }
    }
}

/// Right-hand side under inputs, without constraint forces.
#[inline(always)]
fn under<S, V, const N: usize, const K: usize>(model: &S, t: V, x: &SVector<V, N>, u: SVector<V, K>) -> SVector<V, N>
where
    S: Controlled<V, N, K>,
    V: Real,
{
    let inputs = S::Inputs::from(u.data.0[0]);
    model.eval(t, x, &S::Given::with(inputs, &[V::default(); MAX_CONSTRAINTS]))
}

/// Places of the states in the lanes: consecutive ones, of which the last fills the lanes that are left over.
#[derive(Clone, Copy)]
struct Places {
    first: usize,
    last: usize,
}

impl Places {
    /// Groups of `lanes` out of `count` places.
    #[inline(always)]
    fn groups(count: usize, lanes: usize) -> impl Iterator<Item = Self> {
        (0..count)
            .step_by(lanes)
            .map(move |first| Self { first, last: count - 1 })
    }

    #[inline(always)]
    fn of(self, lane: usize) -> usize {
        (self.first + lane).min(self.last)
    }

    /// Vectors at these places, side by side.
    #[inline(always)]
    fn gather<V: Lanes, const N: usize>(self, vectors: &[SVector<V::Scalar, N>]) -> SVector<V, N> {
        // a full group needs no checks of places
        match vectors.get(self.first..self.first + V::LANES) {
            Some(vectors) => side_by_side(vectors, |lane| lane),
            None => side_by_side(vectors, |lane| self.of(lane)),
        }
    }

    /// Writes the results to these places.
    #[inline(always)]
    fn scatter<V: Lanes, const R: usize, const C: usize>(
        self,
        results: &SMatrix<V, R, C>,
        into: &mut [SMatrix<V::Scalar, R, C>],
    ) {
        match into.get_mut(self.first..self.first + V::LANES) {
            Some(into) => Self::write(results, into, V::LANES),
            None => Self::write(results, &mut into[self.first..], self.last + 1 - self.first),
        }
    }

    /// Writes the results in the first `count` lanes.
    #[inline(always)]
    fn write<V: Lanes, const R: usize, const C: usize>(
        results: &SMatrix<V, R, C>,
        into: &mut [SMatrix<V::Scalar, R, C>],
        count: usize,
    ) {
        for lane in 0..count {
            for (into, column) in into[lane].data.0.iter_mut().zip(&results.data.0) {
                for (into, result) in into.iter_mut().zip(column) {
                    *into = result.lane(lane);
                }
            }
        }
    }
}

/// Vectors at `place(lane)`, side by side.
#[inline(always)]
fn side_by_side<V: Lanes, const N: usize>(
    vectors: &[SVector<V::Scalar, N>],
    place: impl Fn(usize) -> usize,
) -> SVector<V, N> {
    let mut x = [V::default(); N];
    for (i, x) in x.iter_mut().enumerate() {
        *x = V::from_fn(|lane| vectors[place(lane)][i]);
    }
    SVector::from(x)
}

/// Checks that there is one argument for each state.
fn check_one_for_each<X, Y>(name: &'static str, arguments: &[Y], states: &[X]) -> Result<(), Reason> {
    let rule = "a batch takes one for each state";
    require(arguments.len() == states.len(), name, arguments.len() as f64, rule)
}

//! Steps by a method of integration, through mode switches.

use nalgebra::{SMatrix, SVector};

use super::step::check_loops;
use super::{IlqrError, StepDerivatives, StepMap};
use crate::control::Held;
use crate::dual::{Dual, variables};
use crate::error::Reason;
use crate::inputs::{CastControlled, Controlled, WithInputs};
use crate::method::Method;
use crate::real::Float;

/// A model whose steps a method integrates, through mode switches: for [`Ilqr`](super::Ilqr) on scenes with dry
/// friction, stops and walls.
///
/// ```
/// use pendulum_core::control::{Ilqr, Integrated, Quadratic};
/// use pendulum_core::prelude::*;
///
/// mechanism! {
///     /// A block on a floor: 2 N break it away, and brake it.
///     pub Block {
///         input push: N,
///         body block on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push, dry_friction: 2 }
///     }
/// }
///
/// let block = Integrated::new(Block::new(BlockParams {})?, Tsit5::new());
/// let weights = SMatrix::from_diagonal(&[100.0, 10.0].into());
/// let cost = Quadratic::diagonal([0.0; 2], [0.01]).end(weights).goal([1.0, 0.0], [0.0]);
/// // 40 steps of 50 ms; 5 N break the block away
/// let mut ilqr = Ilqr::<_, _, 2, 1, 40>::new(0.05, cost).limits([-6.0], [6.0]).start([5.0]);
/// ilqr.solve(&block, 0.0, [0.0, 0.0])?;
/// assert!((ilqr.end()[Block::S] - 1.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// The method integrates each step on its own, and its derivatives as those of [dual numbers](crate::dual), once by the
/// state and once by the inputs. They are the exact ones of the step that was taken, with their jumps at mode switches
/// (saltation), and cost no heap. Any explicit method will do, with steps that it chooses or of fixed length; models
/// are in double precision.
///
/// - Where friction holds, small forces change nothing, and their derivatives are zero: start from inputs that break
///   the joint away.
/// - The cost has a kink where a mode begins or ends at a node, and the best motion is often there. Where no step
///   decreases the cost, [`solve`](super::Ilqr::solve) also tries the inputs without the gains, which respond to the
///   jump of the state at an impact, and then goes along the kink. Along several of them it is slow: it ends after ten
///   decreases in a row below the tolerance.
/// - The cost has a jump where an impact at a node changes a rate that the running cost weighs. There `solve` may end
///   at a motion that is not a minimum, or with [`NoDecrease`](super::IlqrError::NoDecrease), and keeps the best
///   motion.
/// - A step that has no derivatives, such as one that only touches a stop, is
///   [`StepFailed`](super::IlqrError::StepFailed).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integrated<S, X> {
    model: S,
    method: X,
}

impl<S, X> Integrated<S, X> {
    /// Steps of `model` by `method`.
    #[must_use]
    pub const fn new(model: S, method: X) -> Self {
        Self { model, method }
    }
}

/// A model with held inputs in dual numbers of `D` derivatives.
type Differentiated<S, const N: usize, const M: usize, const D: usize> =
    WithInputs<<S as CastControlled<N, M>>::In<Dual<f64, D>>, Held<Dual<f64, D>, M>, M>;

impl<S, X, const N: usize, const M: usize> StepMap<f64, N, M> for Integrated<S, X>
where
    S: CastControlled<N, M> + Controlled<f64, N, M> + Clone,
    X: Method<WithInputs<S, Held<f64, M>, M>, f64, N>
        + Method<Differentiated<S, N, M, N>, Dual<f64, N>, N>
        + Method<Differentiated<S, N, M, M>, Dual<f64, M>, N>,
{
    const HAS_KINKS: bool = S::HYBRID;

    type Error = Reason;

    fn step(&self, t: f64, h: f64, x: &SVector<f64, N>, u: &[f64; M]) -> Result<SVector<f64, N>, Reason> {
        end(&self.method, self.model.clone(), [t, t + h], *x, *u)
    }

    fn step_derivatives(
        &self,
        t: f64,
        h: f64,
        x: &SVector<f64, N>,
        u: &[f64; M],
    ) -> Result<StepDerivatives<f64, N, M>, Reason> {
        let by_state = end(
            &self.method,
            self.model.cast::<Dual<f64, N>>(),
            [t, t + h].map(Dual::constant),
            variables(x),
            u.map(Dual::constant),
        )?;
        let by_inputs = end(
            &self.method,
            self.model.cast::<Dual<f64, M>>(),
            [t, t + h].map(Dual::constant),
            x.map(Dual::constant),
            variables(&(*u).into()).into(),
        )?;
        Ok(StepDerivatives {
            a: SMatrix::from_fn(|i, j| by_state[i].slopes[j]),
            b: SMatrix::from_fn(|i, j| by_inputs[i].slopes[j]),
        })
    }

    fn check(&self, t: f64, x: &SVector<f64, N>) -> Result<(), IlqrError> {
        check_loops(&self.model, t, x)
    }
}

/// State at the end of a step with held inputs.
fn end<X, S, T, const N: usize, const M: usize>(
    method: &X,
    model: S,
    [t0, t1]: [T; 2],
    x: SVector<T, N>,
    u: [T; M],
) -> Result<SVector<T, N>, Reason>
where
    X: Method<WithInputs<S, Held<T, M>, M>, T, N>,
    S: Controlled<T, N, M>,
    T: Float,
{
    let system = WithInputs::of(model, Held(u));
    method.stepper(&system, t0, t1, x)?.run()
}

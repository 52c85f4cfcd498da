//! Stability of motions.

use nalgebra::Complex;
use pendulum_core::Jacobian;
use pendulum_core::stability::{self, Stability, StabilityError};

use crate::error::Error;
use crate::padded::{Padded, active, padded};
use crate::worker::Cancel;

/// A state at which the right-hand side vanishes.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Equilibrium {
    /// State.
    pub x: Vec<f64>,
    /// Stability according to the linearisation.
    pub stability: Stability,
    /// Eigenvalues of the linearisation in 1/s, the fastest growing first.
    pub eigenvalues: Vec<Complex<f64>>,
}

/// A state that dry friction and contacts hold at rest.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Resting {
    /// State; its rates are zero.
    pub x: Vec<f64>,
    /// Constraints that stick or touch.
    pub mode: String,
    /// Smallest relative reserve of any friction force: 1 without load, 0 at the limit of sticking.
    pub margin: f64,
}

/// Settings of the computation of Lyapunov exponents.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lyapunov {
    /// Number of exponents, the largest first: 1 to 4.
    pub count: usize,
    /// Time over which growth is counted, in s.
    pub duration: f64,
    /// Time before, in s.
    pub transient: f64,
    /// Relative and absolute tolerance of the trajectory and its tangents.
    pub tolerance: f64,
}

/// Lyapunov exponents of a trajectory.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Exponents {
    /// Exponents in 1/s, the largest first.
    pub values: Vec<f64>,
    /// Standard error of each.
    pub uncertainty: Vec<f64>,
}

impl Default for Lyapunov {
    /// Settings for the largest exponent over 1000 s.
    fn default() -> Self {
        Self {
            count: 1,
            duration: 1000.0,
            transient: 0.0,
            tolerance: 1e-8,
        }
    }
}

pub(crate) fn equilibria<const N: usize>(
    model: &Padded<f64, N>,
    seeds: &[Vec<f64>],
) -> Result<(Vec<Equilibrium>, Vec<String>), Error> {
    let length = model.tape().length();
    let found = stability::equilibria(model, seeds.iter().map(|seed| padded(seed)))?;
    let unsearched = found.unsearched().to_vec();
    let found = found.into_iter().map(|own| Equilibrium {
        stability: own.stability(),
        eigenvalues: own.spectrum.eigenvalues().collect(),
        x: active(own.x, length),
    });
    Ok((found.collect(), unsearched))
}

pub(crate) fn resting<const N: usize>(model: &Padded<f64, N>, seed: &[f64]) -> Result<Resting, Error> {
    if model.tape().constraints().is_empty() {
        let rule = "only a mechanism with dry friction, stops or walls can be held at rest by them; use `equilibria`";
        return Err(Error::setting("resting", rule));
    }
    let found = stability::resting::<_, N>(model, padded::<N>(seed))?;
    Ok(Resting {
        x: active(found.x, seed.len()),
        mode: found.mode.describe(model.tape().constraints()).to_string(),
        margin: found.margin,
    })
}

pub(crate) fn lyapunov<const N: usize>(
    model: &Padded<f64, N>,
    x0: &[f64],
    settings: &Lyapunov,
    cancel: &Cancel<'_>,
) -> Result<Exponents, Error> {
    let method = stability::Lyapunov::new()
        .duration(settings.duration)
        .transient(settings.transient)
        .tolerance(settings.tolerance);
    fn of<const K: usize, const N: usize>(
        method: &stability::Lyapunov,
        model: &impl Jacobian<f64, N>,
        x0: &[f64],
        cancel: &dyn Fn() -> bool,
    ) -> Result<[Vec<f64>; 2], StabilityError> {
        let found = method.exponents_unless::<K, N>(model, padded::<N>(x0), cancel)?;
        Ok([found.values.to_vec(), found.uncertainty.to_vec()])
    }
    let [values, uncertainty] = match settings.count {
        1 => of::<1, N>(&method, model, x0, cancel)?,
        2 => of::<2, N>(&method, model, x0, cancel)?,
        3 => of::<3, N>(&method, model, x0, cancel)?,
        4 => of::<4, N>(&method, model, x0, cancel)?,
        count => {
            let rule = format!("1 to 4 exponents can be computed, not {count}");
            return Err(Error::setting("count", rule));
        }
    };
    Ok(Exponents { values, uncertainty })
}

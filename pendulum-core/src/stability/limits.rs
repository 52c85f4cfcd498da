//! Step size limits of stability.

use nalgebra::{Complex, SMatrix};

use super::{Spectrum, StabilityError, StabilityFunction};

/// Stability interval on the negative real axis: the distance from 0 at which `|R|` first exceeds 1. Infinite for
/// A-stable methods.
///
/// Overdamped modes, for example with strong friction, require `h |lambda|` below this limit. For the tolerance on
/// `|R|` see [`imaginary_limit`].
#[must_use]
pub fn real_limit<M: StabilityFunction + ?Sized>(method: &M) -> f64 {
    limit_along(method, Complex::new(-1.0, 0.0))
}

/// Stability interval on the imaginary axis: the distance from 0 at which `|R|` first exceeds 1. Infinite for A-stable
/// methods.
///
/// Undamped oscillations require `h |lambda|` below this limit.
///
/// Values of `|R|` up to `1 + 1e-9` count as 1. Only Gauss methods have exactly 1 near 0. The others have `1 + C y^n`,
/// where `n` is the even one of `p + 1` and `p + 2`, and `p` is the order of `R`. With a positive `C` the exact
/// interval is empty, as for [`Vern7`](crate::Vern7) and for [`Taylor`](crate::Taylor) methods of orders such as 17 and
/// 18. This growth is of the size of the method error and decreases with the step size. The bound separates loss of
/// stability from this effect and from rounding errors; it admits growth by a factor of e over a billion steps. It
/// changes the nonempty limits of `Rk4`, `Rk45`, `Tsit5` and `Vern9` by at most 0.1 %. The limits of `Taylor`, whose
/// `C` is tiny, are mostly the points where `|R|` crosses the bound.
#[must_use]
pub fn imaginary_limit<M: StabilityFunction + ?Sized>(method: &M) -> f64 {
    limit_along(method, Complex::new(0.0, 1.0))
}

/// Largest step size, in s, at which a method amplifies no decaying or neutral mode of `jacobian`. All smaller steps
/// are stable as well. Infinite if the method is stable for all steps, or if there is no such mode.
///
/// The limit is the minimum of `r / |lambda|` over the eigenvalues `lambda` of the Jacobian. Here `r` is the distance
/// up to which `|R|` stays at most 1 on the ray from 0 in the direction of `lambda`; for the tolerance on `|R|` see
/// [`imaginary_limit`]. Eigenvalues with positive real parts are skipped: such modes grow in the exact solution as
/// well. A real part below its [uncertainty](super::Eigenmode::uncertainty) counts as zero. If both parts are that
/// small, the eigenvalue counts as 0 and sets no limit.
///
/// The limit is exact for small motions about an equilibrium. Elsewhere it is a good estimate over times in which the
/// Jacobian hardly changes.
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::stability::max_stable_step;
///
/// mechanism! {
///     pub Swing {
///         params { gamma: N m s = 100.0 }
///         gravity: [0, -9.81, 0],
///         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: gamma }
///     }
/// }
///
/// let swing = Swing::new(SwingParams::default())?;
/// let hanging = SVector::from([0.0, 0.0]);
/// let longest = max_stable_step(&Rk4::new(0.01), &swing.jacobian(0.0, &hanging))?;
/// let end = |h: f64| Rk4::new(h).stepper(&swing, 0.0, 1000.0 * h, [0.1, 0.0])?.run();
/// assert!(end(0.99 * longest)?[1].abs() < 0.1);
/// assert!(end(1.01 * longest)?[1].abs() > 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// See [`Spectrum::of`].
pub fn max_stable_step<M, const N: usize>(method: &M, jacobian: &SMatrix<f64, N, N>) -> Result<f64, StabilityError>
where
    M: StabilityFunction + ?Sized,
{
    let mut longest = f64::INFINITY;
    for mode in Spectrum::of(jacobian)?.modes() {
        let (growth, frequency) = (mode.growth_rate(), mode.angular_frequency());
        let is_neutral = growth.abs() <= mode.uncertainty;
        if (is_neutral && frequency <= mode.uncertainty) || (growth > 0.0 && !is_neutral) {
            continue;
        }
        // of a pair, only the one above the real axis, since R commutes with conjugation
        let lambda = Complex::new(if is_neutral { 0.0 } else { growth }, frequency);
        longest = longest.min(limit_along(method, lambda / lambda.norm()) / lambda.norm());
    }
    Ok(longest)
}

/// Amount by which `|R|` may exceed 1.
const NEUTRAL: f64 = 1e-9;
/// Search increment along a ray: absolute up to a distance of 1, relative beyond.
const PARTS: f64 = 1.0 / 128.0;
/// Distance from 0 beyond which `R` equals its limit at infinity.
const FAR: f64 = 1e6;

/// Distance from 0 in a direction of length 1 at which `|R|` first exceeds 1.
fn limit_along<M: StabilityFunction + ?Sized>(method: &M, direction: Complex<f64>) -> f64 {
    // NaN counts as unstable
    let is_stable = |far: f64| method.stability_function(direction * far).norm() <= 1.0 + NEUTRAL;
    let mut within = 0.0;
    while within < FAR {
        let mut beyond = within + PARTS * within.max(1.0);
        if is_stable(beyond) {
            within = beyond;
            continue;
        }
        loop {
            let middle = 0.5 * (within + beyond);
            if middle <= within || middle >= beyond {
                return within;
            }
            if is_stable(middle) {
                within = middle;
            } else {
                beyond = middle;
            }
        }
    }
    f64::INFINITY
}

//! How long a step of a method may be before modes grow that do not.

use nalgebra::{Complex, SMatrix};

use super::{Spectrum, StabilityError, StabilityFunction};

/// The interval of stability on the negative real axis: how far from 0 `|R|` first exceeds 1. Infinite for A-stable methods.
///
/// Modes that creep back, as those of strong friction do, want `h |lambda|` below this. For what counts as 1 see [`imaginary_limit`].
#[must_use]
pub fn real_limit<M: StabilityFunction + ?Sized>(method: &M) -> f64 {
    limit_along(method, Complex::new(-1.0, 0.0))
}

/// The interval of stability on the imaginary axis: how far from 0 `|R|` first exceeds 1. Infinite for A-stable methods.
///
/// Modes that swing without friction want `h |lambda|` below this.
///
/// Up to `1 + 1e-9` counts as 1. Only methods of Gauss have exactly 1 close to 0: others have `1 + C y^n`, with the even one of `p + 1` and `p + 2` for
/// `n`, where `p` is the order of `R`. A positive `C` leaves nothing of the exact interval, as for [`Vern7`](crate::Vern7) and for [`Taylor`](crate::Taylor)
/// methods of orders such as 17 and 18; yet that is no more than the error of the method, which falls with the step. The bound tells a loss of
/// stability from it and from rounding errors, and admits growth that takes a billion steps to a factor of e. It moves the limits of `Rk4`, `Rk45`,
/// `Tsit5` and `Vern9`, which are not empty, by 0.1 % at most. Those of `Taylor`, whose `C` is tiny, are mostly where `|R|` passes the bound.
#[must_use]
pub fn imaginary_limit<M: StabilityFunction + ?Sized>(method: &M) -> f64 {
    limit_along(method, Complex::new(0.0, 1.0))
}

/// The longest step with which a method lets no mode of `jacobian` grow that does not grow by itself, in s: all shorter ones are
/// stable as well. Infinite where the method is stable for all steps, or where there is no such mode.
///
/// It is the least `r / |lambda|` over the eigenvalues `lambda` of the Jacobian, where `r` is how far `|R|` stays at 1 or below, on the
/// ray from 0 in the direction of `lambda`; for what counts as 1 see [`imaginary_limit`]. Eigenvalues with positive real parts are passed over: there the
/// motion itself grows, and the method is right to follow. Those whose real part is no larger than its [uncertainty](super::Eigenmode::uncertainty) count as
/// imaginary, and those of which both parts are so small as 0, which limits nothing.
///
/// The limit holds for small motions where the Jacobian is that of an equilibrium; elsewhere it is a good guess over times in which the
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
/// Those of [`Spectrum::of`].
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
        // of a pair, the one above: R takes conjugates to conjugates
        let lambda = Complex::new(if is_neutral { 0.0 } else { growth }, frequency);
        longest = longest.min(limit_along(method, lambda / lambda.norm()) / lambda.norm());
    }
    Ok(longest)
}

/// By how much `|R|` may exceed 1.
const NEUTRAL: f64 = 1e-9;
/// Rays are searched in parts of 1 until there, and from there in parts of what lies behind.
const PARTS: f64 = 1.0 / 128.0;
/// Beyond this, `R` is what it is at infinity.
const FAR: f64 = 1e6;

/// How far from 0 in a direction of length 1 `|R|` first exceeds 1.
fn limit_along<M: StabilityFunction + ?Sized>(method: &M, direction: Complex<f64>) -> f64 {
    // not a number is not stable
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

//! Events: where a function of time and state passes zero, and what happens there.

use core::fmt;

use nalgebra::SVector;

use crate::real::Float;

/// Something that happens where a function `g(t, x)` passes zero along a trajectory; for
/// [`Method::solve_with`](crate::Method::solve_with).
///
/// An event occurs where `g` reaches zero or changes its sign: once, whether that is within a step, at the end of one,
/// or at the start of the integration. It is located on the dense output of the method, to its accuracy and to the last
/// bits of the time. Two zeros in one step are found even if the sign is the same at both ends: `g` is evaluated at ten
/// places of each step, and where it comes near zero between them its extremum is searched. Where these values go up
/// and down about zero, `g` is evaluated at up to a thousand places more, enough for some 150 zeros in a step. Where
/// even these do not show all of them, the solution reports it: [`Solution::missed`](crate::Solution::missed).
///
/// A [terminal](Self::terminal) event is not one at the start: a motion from rest goes on to the next turning point,
/// though its rate is zero from the beginning. [`at_start`](Self::at_start) asks for that too.
///
/// A reset that does not lead away from zero, such as a rebound without speed, lets the function pass zero: make such
/// an event terminal. One that leads away so little that the event repeats without end is
/// [`EventsAccumulate`](crate::Reason::EventsAccumulate).
///
/// ```
/// use pendulum_core::prelude::*;
/// use pendulum_core::SolveError;
///
/// // a ball that is dropped and rebounds with four fifths of its speed
/// let ball = FnSystem(|_t: f64, _x: &SVector<f64, 2>| SVector::from([_x[1], -9.81]));
/// let bounce = Event::new(|_t, x: &SVector<f64, 2>| x[0])
///     .falling()
///     .reset(|_t, x| SVector::from([0.0, -0.8 * x[1]]));
/// let top = Event::new(|_t, x: &SVector<f64, 2>| x[1]).falling();
/// let solution = Rk45::new().solve_with(&ball, 0.0, 1.5, [1.0, 0.0], &[bounce, top])?;
/// let bounces: Vec<f64> = solution.events().iter().filter(|event| event.index == 0).map(|event| event.t).collect();
/// let fall = (2.0_f64 / 9.81).sqrt();
/// assert!((bounces[0] - fall).abs() < 1e-12 && (bounces[1] - 2.6 * fall).abs() < 1e-12);
/// # Ok::<(), SolveError<f64, 2>>(())
/// ```
pub struct Event<'e, T, const N: usize> {
    pub(crate) function: Function<'e, T, N>,
    pub(crate) direction: Direction,
    pub(crate) terminal: bool,
    at_start: bool,
    pub(crate) reset: Option<Reset<'e, T, N>>,
    restarts: bool,
}

/// The function that passes zero.
type Function<'e, T, const N: usize> = Box<dyn Fn(T, &SVector<T, N>) -> T + 'e>;

/// The state after an event, from the state before it.
type Reset<'e, T, const N: usize> = Box<dyn Fn(T, &SVector<T, N>) -> SVector<T, N> + 'e>;

/// Which zero crossings count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Both ways.
    #[default]
    Either,
    /// From below zero, as time goes on in the direction of the integration.
    Rising,
    /// From above zero.
    Falling,
}

impl Direction {
    /// Whether a zero counts at which the function rises, or falls.
    pub(crate) fn includes(self, rises: bool) -> bool {
        match self {
            Self::Either => true,
            Self::Rising => rises,
            Self::Falling => !rises,
        }
    }
}

impl<'e, T, const N: usize> Event<'e, T, N> {
    /// Records each zero crossing of `function`, in either direction.
    #[must_use]
    pub fn new(function: impl Fn(T, &SVector<T, N>) -> T + 'e) -> Self {
        Self {
            function: Box::new(function),
            direction: Direction::Either,
            terminal: false,
            at_start: false,
            reset: None,
            restarts: false,
        }
    }

    /// Only where the function rises through zero, as time goes on in the direction of the integration.
    #[must_use]
    pub fn rising(mut self) -> Self {
        self.direction = Direction::Rising;
        self
    }

    /// Only where the function falls through zero, as time goes on in the direction of the integration.
    #[must_use]
    pub fn falling(mut self) -> Self {
        self.direction = Direction::Falling;
        self
    }

    /// Ends the integration, after the reset if there is one.
    ///
    /// Where the function is zero at the start, it neither ends it there nor occurs, but for [`at_start`](Self::at_start).
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    ///
    /// // a spring that is released at rest, up to where it turns
    /// let spring = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0]]));
    /// let turns = || Event::new(|_t, x: &SVector<f64, 2>| x[1]).terminal();
    /// let solution = Vern9::new().solve_with(&spring, 0.0, 10.0, [1.0, 0.0], &[turns()])?;
    /// assert!((solution.last().0 - std::f64::consts::PI).abs() < 1e-6);
    /// let solution = Vern9::new().solve_with(&spring, 0.0, 10.0, [1.0, 0.0], &[turns().at_start()])?;
    /// assert_eq!(solution.last().0, 0.0);
    /// # Ok::<(), pendulum_core::SolveError<f64, 2>>(())
    /// ```
    #[must_use]
    pub fn terminal(mut self) -> Self {
        self.terminal = true;
        self
    }

    /// Makes a terminal event end the integration at the start too, where its function is zero there and leaves zero in
    /// the direction of the event. Other events occur there anyway.
    #[must_use]
    pub fn at_start(mut self) -> Self {
        self.at_start = true;
        self
    }

    /// Continues from the state `reset(t, x)`, where `x` is the state before.
    ///
    /// The new state must be finite, and on the constraints of the system: with quaternions of unit length and closed
    /// loops, as `assemble` of a generated model closes them. Off by up to 1e-3 it is put back there, and otherwise the
    /// integration ends in [`BadReset`](crate::Reason::BadReset).
    ///
    /// Zeros that functions cross in the reset itself are not events.
    #[must_use]
    pub fn reset(mut self, reset: impl Fn(T, &SVector<T, N>) -> SVector<T, N> + 'e) -> Self {
        self.reset = Some(Box::new(reset));
        self
    }

    /// Ends the step there, and begins the next one anew: for a kink of the right-hand side, such as a controller that
    /// saturates. A step across a kink loses the order of the method.
    ///
    /// Where it occurs again so soon that rounding errors may be the cause, it is recorded and the step goes on.
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    ///
    /// // a cart that is pulled back by 1 N at most: at constant force from 1.1 m to 0.1 m, then as by a spring
    /// let cart = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], (-10.0 * x[0]).clamp(-1.0, 1.0)]));
    /// let (t, fall, rate) = (1.5, 2.0_f64.sqrt(), 10.0_f64.sqrt());
    /// let (sin, cos) = f64::sin_cos(rate * (t - fall));
    /// let error = |events: &[Event<f64, 2>]| -> Result<f64, SolveError<f64, 2>> {
    ///     let solution = Rk4::new(0.0125).solve_with(&cart, 0.0, t, [1.1, 0.0], events)?;
    ///     Ok((solution.last().1[0] - (0.1 * cos - fall / rate * sin)).abs())
    /// };
    /// let saturates = Event::new(|_t, x: &SVector<f64, 2>| 1.0 - (10.0 * x[0]).abs()).restart();
    /// assert!(error(&[])? > 1e-6 && error(&[saturates])? < 1e-8);
    /// # use pendulum_core::SolveError;
    /// # Ok::<(), SolveError<f64, 2>>(())
    /// ```
    #[must_use]
    pub fn restart(mut self) -> Self {
        self.restarts = true;
        self
    }

    /// Whether it occurs at the start of the integration, where its function is zero there.
    pub(crate) fn occurs_at_start(&self) -> bool {
        self.at_start || !self.terminal
    }

    /// Whether the step ends there.
    pub(crate) fn acts(&self) -> bool {
        self.restarts || self.changes()
    }

    /// Whether it is a kink of the right-hand side, and nothing more.
    pub(crate) fn is_kink(&self) -> bool {
        self.restarts && !self.changes()
    }

    /// Whether the integration begins anew there.
    pub(crate) fn begins_anew(&self) -> bool {
        self.restarts || self.reset.is_some()
    }

    /// Whether it ends the integration or resets the state.
    pub(crate) fn changes(&self) -> bool {
        self.terminal || self.reset.is_some()
    }
}

impl<T, const N: usize> fmt::Debug for Event<'_, T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Event")
            .field("direction", &self.direction)
            .field("terminal", &self.terminal)
            .field("resets", &self.reset.is_some())
            .field("restarts", &self.restarts)
            .finish_non_exhaustive()
    }
}

/// An event that occurred.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>"
    ))
)]
pub struct Occurrence<T, const N: usize> {
    /// The index of the event among those given.
    pub index: usize,
    /// The time.
    pub t: T,
    /// The state, before a reset.
    pub x: SVector<T, N>,
}

/// A part of a trajectory in which an event may have occurred more often than was found: its function changes faster
/// than the steps show. Bound them by `h_max`, to a few times the time between two zeros.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Missed<T = f64> {
    /// The index of the event among those given.
    pub index: usize,
    /// The time from which.
    pub from: T,
    /// The time up to which.
    pub to: T,
}

impl<T: Float> fmt::Display for Missed<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { index, from, to } = *self;
        let (from, to) = (from.to_f64(), to.to_f64());
        write!(
            f,
            "event {index} may have occurred more often than was found from t = {from:?} to {to:?}: its function passes \
             zero hundreds of times within a step; set `h_max` to a few times the time between two zeros"
        )
    }
}

//! Events: zero crossings of functions of time and state, and the actions there.

use core::fmt;

use nalgebra::SVector;

use crate::real::Float;

/// An event where a function `g(t, x)` passes zero along a trajectory; see
/// [`Method::solve_with`](crate::Method::solve_with).
///
/// An event occurs where `g` reaches zero or changes its sign: once, whether within a step, at the end of one, or at
/// the start of the integration. It is located on the dense output of the method, with the accuracy of that output, to
/// the last bits of the time. At an event that [resets](Self::reset) the state or [restarts](Self::restart) the method,
/// the step is retaken up to the event, once or twice, so that `g` is zero at the accuracy of the ends of steps. (With
/// [`Taylor`](crate::Taylor) dense output has that accuracy.) Two zeros in one step are found even if the sign is the
/// same at both ends: `g` is sampled at ten positions of each step, and its extremum is searched where the samples come
/// close to zero. If the samples oscillate about zero, `g` is evaluated at up to a thousand more positions, enough for
/// some 150 zeros in a step. If even these do not resolve all zeros, the solution reports it:
/// [`Solution::missed`](crate::Solution::missed).
///
/// A [terminal](Self::terminal) event does not occur at the start: a motion from rest continues to the next turning
/// point, though its rate is zero at the beginning. [`at_start`](Self::at_start) enables the event at the start, too.
///
/// If a reset does not lead away from zero, such as a rebound without speed, the function passes zero: make such an
/// event terminal. If it leads away so little that the event repeats forever, the integration stops with
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

/// Event function, whose zeros are events.
type Function<'e, T, const N: usize> = Box<dyn Fn(T, &SVector<T, N>) -> T + 'e>;

/// State after an event, as a function of the state before it.
type Reset<'e, T, const N: usize> = Box<dyn Fn(T, &SVector<T, N>) -> SVector<T, N> + 'e>;

/// Zero crossings that count as events.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Direction {
    /// In both directions.
    #[default]
    Either,
    /// From negative to positive, in the direction of the integration.
    Rising,
    /// From positive to negative.
    Falling,
}

impl Direction {
    /// True if a zero counts at which the function rises (`rises`) or falls.
    pub(crate) fn includes(self, rises: bool) -> bool {
        match self {
            Self::Either => true,
            Self::Rising => rises,
            Self::Falling => !rises,
        }
    }
}

impl<'e, T, const N: usize> Event<'e, T, N> {
    /// Creates an event that records each zero crossing of `function`, in either direction.
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

    /// Restricts the event to rising zero crossings, in the direction of the integration.
    #[must_use]
    pub fn rising(mut self) -> Self {
        self.direction = Direction::Rising;
        self
    }

    /// Restricts the event to falling zero crossings, in the direction of the integration.
    #[must_use]
    pub fn falling(mut self) -> Self {
        self.direction = Direction::Falling;
        self
    }

    /// Ends the integration at the event, after the reset if there is one. The state at the end is that of the dense
    /// output. With a reset, or with [`restart`](Self::restart) as well, it is that of a step that ends there, and
    /// ensembles integrate the trajectory outside of lanes.
    ///
    /// If the function is zero at the start, the event neither occurs there nor ends the integration, unless
    /// [`at_start`](Self::at_start) is set.
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

    /// Lets a terminal event end the integration at the start, if its function is zero there and leaves zero in the
    /// direction of the event. Other events occur at the start anyway.
    #[must_use]
    pub fn at_start(mut self) -> Self {
        self.at_start = true;
        self
    }

    /// Continues from the state `reset(t, x)`, where `x` is the state before.
    ///
    /// The new state must be finite, and on the constraints of the system: quaternions of unit length and closed loops,
    /// as `assemble` of a generated model returns them. Deviations up to 1e-3 are projected onto the constraints;
    /// beyond that, the integration stops with [`BadReset`](crate::Reason::BadReset), and with
    /// [`BeyondLimit`](crate::Reason::BeyondLimit) beyond a stop or a wall.
    ///
    /// Zero crossings due to the reset itself are not events.
    #[must_use]
    pub fn reset(mut self, reset: impl Fn(T, &SVector<T, N>) -> SVector<T, N> + 'e) -> Self {
        self.reset = Some(Box::new(reset));
        self
    }

    /// Ends the step at the event, and restarts the method: for a kink of the right-hand side, such as a controller
    /// that saturates. A step across a kink loses the order of the method.
    ///
    /// Occurrences within a thousand ulps of the time are one. If a kink recurs so soon that rounding errors may be the
    /// cause, it is recorded, but the step continues. Steps no longer end at kinks after a hundred in a row that each
    /// left less than 1 % of a step: the step is unstable, and crosses the limit again and again.
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
    /// let saturates = Event::new(|_t, x: &SVector<f64, 2>| 1.0 - (10.0 * x[0]).powi(2)).restart();
    /// assert!(error(&[])? > 1e-6 && error(&[saturates])? < 1e-8);
    /// # use pendulum_core::SolveError;
    /// # Ok::<(), SolveError<f64, 2>>(())
    /// ```
    #[must_use]
    pub fn restart(mut self) -> Self {
        self.restarts = true;
        self
    }

    /// The event in another number type, with its function and its reset there.
    pub(crate) fn with<'f, U>(
        &self,
        function: impl Fn(U, &SVector<U, N>) -> U + 'f,
        reset: Option<impl Fn(U, &SVector<U, N>) -> SVector<U, N> + 'f>,
    ) -> Event<'f, U, N> {
        Event {
            function: Box::new(function),
            direction: self.direction,
            terminal: self.terminal,
            at_start: self.at_start,
            reset: reset.map(|reset| Box::new(reset) as Reset<'f, U, N>),
            restarts: self.restarts,
        }
    }

    /// True if it occurs at the start of the integration, where its function is zero there.
    pub(crate) fn occurs_at_start(&self) -> bool {
        self.at_start || !self.terminal
    }

    /// True if it marks a kink of the right-hand side, and does nothing else.
    pub(crate) fn is_kink(&self) -> bool {
        self.restarts && !self.changes()
    }

    /// True if the right-hand side has a kink at the event.
    pub(crate) fn restarts(&self) -> bool {
        self.restarts
    }

    /// True if the method restarts at the event.
    pub(crate) fn begins_anew(&self) -> bool {
        self.restarts || self.reset.is_some()
    }

    /// True if it ends the integration or resets the state.
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
    /// Index of the event among those given.
    pub index: usize,
    /// Time.
    pub t: T,
    /// State, before a reset.
    pub x: SVector<T, N>,
}

/// A part of a trajectory in which an event may have occurred more often than was found, since its function varies
/// faster than the steps resolve. Bound the steps by `h_max`, to a few times the time between two zeros.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Missed<T = f64> {
    /// Index of the event among those given.
    pub index: usize,
    /// Start of the part.
    pub from: T,
    /// End of the part.
    pub to: T,
}

impl<T: Float> fmt::Display for Missed<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { index, from, to } = *self;
        let (from, to) = (from.to_f64(), to.to_f64());
        write!(
            f,
            "event {index} may have occurred more often than was found from t = {from:?} to {to:?}: its function \
             passes zero hundreds of times within a step; set `h_max` to a few times the time between two zeros"
        )
    }
}

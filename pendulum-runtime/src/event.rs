//! Events of trajectories.

use std::fmt;

use nalgebra::SVector;
use pendulum_core::tape::Given;
use pendulum_core::{Direction, Event as CoreEvent, Real, System};

use crate::error::Error;
use crate::padded::Padded;

/// An event: a function of time and state that passes zero.
pub struct Event<'e> {
    kind: Kind<'e>,
    name: String,
    direction: Direction,
    pub(crate) terminal: bool,
}

/// Function of the time and the state.
type Function<'e> = Box<dyn Fn(f64, &[f64]) -> f64 + Send + Sync + 'e>;

enum Kind<'e> {
    Function(Function<'e>),
    Declared,
    Value(f64),
}

impl<'e> Event<'e> {
    /// An event where a function of the time and the state is zero.
    pub fn new(function: impl Fn(f64, &[f64]) -> f64 + Send + Sync + 'e) -> Self {
        Self::of(Kind::Function(Box::new(function)), "")
    }

    /// An event of the declaration.
    #[must_use]
    pub fn declared(name: &str) -> Self {
        Self::of(Kind::Declared, name)
    }

    /// An event where an output or a component of the state has a value.
    #[must_use]
    pub fn value(name: &str, value: f64) -> Self {
        Self::of(Kind::Value(value), name)
    }

    fn of(kind: Kind<'e>, name: &str) -> Self {
        Self {
            kind,
            name: name.to_owned(),
            direction: Direction::Either,
            terminal: false,
        }
    }

    /// Restricts the event to zeros at which the function rises, in the direction of the integration.
    #[must_use]
    pub fn rising(mut self) -> Self {
        self.direction = Direction::Rising;
        self
    }

    /// Restricts the event to zeros at which the function falls.
    #[must_use]
    pub fn falling(mut self) -> Self {
        self.direction = Direction::Falling;
        self
    }

    /// Ends the integration at the event.
    #[must_use]
    pub fn terminal(mut self) -> Self {
        self.terminal = true;
        self
    }

    /// The event as one of a model.
    pub(crate) fn at<'m, const N: usize>(
        &'m self,
        model: &'m Padded<f64, N>,
        length: usize,
    ) -> Result<CoreEvent<'m, f64, N>, Error> {
        let tape = model.tape();
        let mut is_kink = false;
        let event = match &self.kind {
            Kind::Function(function) => {
                CoreEvent::new(move |t, x: &SVector<f64, N>| function(t, &x.as_slice()[..length]))
            }
            Kind::Declared => {
                let events = tape.events().iter().map(|(name, _)| *name);
                is_kink = tape.events()[Error::index_of("event", &self.name, events)?].1;
                declared(model, &self.name)?
            }
            &Kind::Value(value) => {
                let components = tape.layout().components();
                if let Some(n) = components.iter().position(|name| *name == self.name) {
                    CoreEvent::new(move |_, x: &SVector<f64, N>| x[n] - value)
                } else {
                    let names = tape.outputs().iter().copied();
                    let known = names.clone().chain(components.iter().map(String::as_str));
                    let unknown = || Error::unknown("output or component", &self.name, known);
                    let n = names.clone().position(|name| name == self.name).ok_or_else(unknown)?;
                    CoreEvent::new(move |t, x: &SVector<f64, N>| {
                        let (mut next, mut found) = (0, f64::NAN);
                        model.each_output(t, x, &mut |_, output| {
                            if next == n {
                                found = output;
                            }
                            next += 1;
                        });
                        found - value
                    })
                }
            }
        };
        let event = match self.direction {
            Direction::Rising => event.rising(),
            Direction::Falling => event.falling(),
            _ => event,
        };
        let event = if self.terminal { event.terminal() } else { event };
        Ok(if is_kink { event.restart() } else { event })
    }
}

/// The event of this name among those that the model declares.
fn declared<'m, T: Real, const N: usize>(model: &'m Padded<T, N>, name: &str) -> Result<CoreEvent<'m, T, N>, Error> {
    let routines = model.tape().routines().iter().map(|routine| routine.name());
    let routine = Error::index_of("event", name, routines)?;
    Ok(CoreEvent::new(move |t, x: &SVector<T, N>| {
        let mut value = [T::default()];
        model.evaluate(routine, t, x, &Given::default(), &mut value);
        value[0]
    }))
}

/// The events of a model at which its motion has a kink: derivatives of trajectories need steps that end there.
#[cfg(feature = "full")]
pub(crate) fn kinks<T: Real, const N: usize>(model: &Padded<T, N>) -> Result<Vec<CoreEvent<'_, T, N>>, Error> {
    let kinks = model.tape().events().iter().filter(|(_, is_kink)| *is_kink);
    kinks.map(|(name, _)| Ok(declared(model, name)?.restart())).collect()
}

impl fmt::Debug for Event<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Event")
            .field("name", &self.name)
            .field("direction", &self.direction)
            .field("terminal", &self.terminal)
            .finish_non_exhaustive()
    }
}

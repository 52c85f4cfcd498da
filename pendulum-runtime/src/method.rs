//! Methods by name.

use pendulum_core::method::Adaptive;
use pendulum_core::{Auto, Gauss6, ObservedEnsemble, Rk4, Rodas5P, Taylor, Vern9};
#[cfg(feature = "full")]
use pendulum_core::{Gauss4, Gauss16, Radau5, Radau9, Radau13, Rk45, Rodas4, Tsit5, Vern7};

use crate::error::Error;
use crate::padded::{Padded, Smooth};

/// A method of integration with its settings. Those that are not set have the defaults of
/// [`Adaptive`](pendulum_core::method::Adaptive).
#[derive(Clone, Debug, PartialEq)]
pub struct Method {
    pub(crate) kind: Kind,
    pub(crate) h: Option<f64>,
    rtol: Option<f64>,
    atol: Option<f64>,
    h0: Option<f64>,
    h_min: Option<f64>,
    h_max: Option<f64>,
    max_steps: Option<usize>,
}

/// Defines the methods, and their choice at run time: those with a fixed step, then those that keep a tolerance.
macro_rules! methods {
    ($($(#[$if_fixed:meta])? $fixed:ident)*; $($(#[$if:meta])? $adaptive:ident)*) => {
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum Kind {
            $($(#[$if_fixed])? $fixed,)*
            $($(#[$if])? $adaptive,)*
        }

        impl Method {
            /// Names of all methods.
            pub const NAMES: &'static [&'static str] = &[
                $($(#[$if_fixed])? stringify!($fixed),)*
                $($(#[$if])? stringify!($adaptive),)*
            ];

            const KINDS: &'static [Kind] = &[
                $($(#[$if_fixed])? Kind::$fixed,)*
                $($(#[$if])? Kind::$adaptive,)*
            ];

            /// Number of methods with a fixed step; they come first.
            const FIXED: usize = [$($(#[$if_fixed])? Kind::$fixed),*].len();

            /// Integrates by the method.
            pub(crate) fn run<K: Task<N>, const N: usize>(&self, task: K) -> K::Output {
                match self.kind {
                    $($(#[$if_fixed])? Kind::$fixed => task.by($fixed::new(self.h.unwrap_or(f64::NAN))),)*
                    $($(#[$if])? Kind::$adaptive => task.by(self.set($adaptive::new())),)*
                }
            }
        }
    };
}

methods! {
    Rk4
    #[cfg(feature = "full")] Gauss4
    Gauss6
    #[cfg(feature = "full")] Gauss16;
    #[cfg(feature = "full")] Rk45
    #[cfg(feature = "full")] Tsit5
    #[cfg(feature = "full")] Vern7
    Vern9
    Taylor
    #[cfg(feature = "full")] Rodas4
    Rodas5P
    #[cfg(feature = "full")] Radau5
    #[cfg(feature = "full")] Radau9
    #[cfg(feature = "full")] Radau13
    Auto
}

/// Integration in states of this length.
pub(crate) trait Task<const N: usize> {
    type Output;

    fn by(self, method: impl pendulum_core::Method<Padded<f64, N>, f64, N>) -> Self::Output;
}

/// Integration of many trajectories in lanes.
pub(crate) trait TaskInLanes<const N: usize> {
    type Output;

    fn by(self, method: impl ObservedEnsemble<Smooth<N>, f64, N> + Sync) -> Self::Output;
}

impl Method {
    /// The method of this name, in upper or lower case: `Rk4`, `Gauss4`, `Gauss6` and `Gauss16` with a fixed step, or
    /// `Rk45`, `Tsit5`, `Vern7`, `Vern9`, `Taylor`, `Rodas4`, `Rodas5P`, `Radau5`, `Radau9`, `Radau13` and `Auto` with
    /// a tolerance.
    ///
    /// # Errors
    /// If there is no such method; the error names the most similar one.
    pub fn new(name: &str) -> Result<Self, Error> {
        let unknown = || Error::unknown("method", name, Self::NAMES.iter().copied());
        let place = Self::NAMES.iter().position(|own| own.eq_ignore_ascii_case(name));
        Ok(Self {
            kind: Self::KINDS[place.ok_or_else(unknown)?],
            h: None,
            rtol: None,
            atol: None,
            h0: None,
            h_min: None,
            h_max: None,
            max_steps: None,
        })
    }

    /// Name of the method.
    #[must_use]
    pub fn name(&self) -> &'static str {
        Self::NAMES[self.kind as usize]
    }

    /// Relative and absolute tolerance and the length of fixed steps, as far as they are set.
    #[must_use]
    pub fn settings(&self) -> [Option<f64>; 3] {
        [self.rtol, self.atol, self.h]
    }

    /// True if the method takes steps of a fixed length.
    #[must_use]
    pub fn is_fixed(&self) -> bool {
        (self.kind as usize) < Self::FIXED
    }

    /// Sets the length of the fixed steps, in s.
    #[must_use]
    pub fn h(mut self, h: f64) -> Self {
        self.h = Some(h);
        self
    }

    /// Sets the relative tolerance.
    #[must_use]
    pub fn rtol(mut self, rtol: f64) -> Self {
        self.rtol = Some(rtol);
        self
    }

    /// Sets the absolute tolerance.
    #[must_use]
    pub fn atol(mut self, atol: f64) -> Self {
        self.atol = Some(atol);
        self
    }

    /// Sets the length of the first step, in s.
    #[must_use]
    pub fn h0(mut self, h0: f64) -> Self {
        self.h0 = Some(h0);
        self
    }

    /// Sets the minimum length of a step, in s.
    #[must_use]
    pub fn h_min(mut self, h_min: f64) -> Self {
        self.h_min = Some(h_min);
        self
    }

    /// Sets the maximum length of a step, in s.
    #[must_use]
    pub fn h_max(mut self, h_max: f64) -> Self {
        self.h_max = Some(h_max);
        self
    }

    /// Sets the maximum number of steps.
    #[must_use]
    pub fn max_steps(mut self, max_steps: usize) -> Self {
        self.max_steps = Some(max_steps);
        self
    }

    /// Integrates many trajectories in lanes of vector registers, if the method can.
    pub(crate) fn run_in_lanes<K: TaskInLanes<N>, const N: usize>(&self, task: K) -> Result<K::Output, K> {
        Ok(match self.kind {
            Kind::Rk4 => task.by(Rk4::new(self.h.unwrap_or(f64::NAN))),
            #[cfg(feature = "full")]
            Kind::Tsit5 => task.by(self.set(Tsit5::new())),
            #[cfg(feature = "full")]
            Kind::Vern7 => task.by(self.set(Vern7::new())),
            #[cfg(feature = "full")]
            Kind::Vern9 => task.by(self.set(Vern9::new())),
            _ => return Err(task),
        })
    }

    /// Checks that the settings are those of the method.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let name = self.name();
        let error = |what: &str, rule: String| Err(Error::setting(what, rule));
        if self.is_fixed() && self.h.is_none() {
            return error("h", format!("`{name}` takes fixed steps: give their length in s"));
        }
        if !self.is_fixed() && self.h.is_some() {
            return error(
                "h",
                format!("`{name}` chooses its steps by a tolerance: set `rtol` and `atol`, or `h_max`"),
            );
        }
        let of_tolerance = [
            ("rtol", self.rtol.is_some()),
            ("atol", self.atol.is_some()),
            ("h0", self.h0.is_some()),
            ("h_min", self.h_min.is_some()),
            ("h_max", self.h_max.is_some()),
            ("max_steps", self.max_steps.is_some()),
        ];
        match of_tolerance.into_iter().find(|(_, set)| *set) {
            Some((what, _)) if self.is_fixed() => error(
                what,
                format!("`{name}` takes fixed steps, and has the only setting `h`"),
            ),
            _ => Ok(()),
        }
    }

    /// Word of `generate` that the method needs beside `rhs`.
    #[must_use]
    pub fn word(&self) -> Option<&'static str> {
        match self.name() {
            "Gauss4" | "Gauss6" | "Gauss16" => Some("canonical"),
            "Taylor" => Some("taylor"),
            "Rodas4" | "Rodas5P" | "Radau5" | "Radau9" | "Radau13" | "Auto" => Some("jacobian"),
            _ => None,
        }
    }

    pub(crate) fn set<F>(&self, mut method: Adaptive<F>) -> Adaptive<F> {
        if let Some(rtol) = self.rtol {
            method = method.rtol(rtol);
        }
        if let Some(atol) = self.atol {
            method = method.atol(atol);
        }
        if let Some(h0) = self.h0 {
            method = method.h0(h0);
        }
        if let Some(h_min) = self.h_min {
            method = method.h_min(h_min);
        }
        if let Some(h_max) = self.h_max {
            method = method.h_max(h_max);
        }
        if let Some(max_steps) = self.max_steps {
            method = method.max_steps(max_steps);
        }
        method
    }
}

//! Methods by name.

use pendulum_core::dual::Dual;
use pendulum_core::method::Adaptive;
use pendulum_core::{
    Auto, Gauss4, Gauss6, ObservedEnsemble, Radau5, Rk4, Rk45, Rodas4, Rodas5P, Taylor, Tsit5, Vern7, Vern9,
};

use crate::error::Error;
use crate::padded::{Padded, Smooth};
use crate::sensitivity::PART;

/// A method of integration with its settings. Those that are not set have the defaults of
/// [`Adaptive`](pendulum_core::method::Adaptive).
#[derive(Clone, Debug, PartialEq)]
pub struct Method {
    kind: Kind,
    h: Option<f64>,
    rtol: Option<f64>,
    atol: Option<f64>,
    h0: Option<f64>,
    h_min: Option<f64>,
    h_max: Option<f64>,
    max_steps: Option<usize>,
}

/// Defines the methods, and their choice at run time: those with a fixed step, then those that keep a tolerance.
macro_rules! methods {
    ($($fixed:ident)*; $($adaptive:ident)*) => {
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        enum Kind {
            $($fixed,)*
            $($adaptive,)*
        }

        impl Method {
            /// Names of all methods.
            pub const NAMES: &'static [&'static str] = &[$(stringify!($fixed),)* $(stringify!($adaptive)),*];

            fn kind(name: &str) -> Option<Kind> {
                $(if name.eq_ignore_ascii_case(stringify!($fixed)) { return Some(Kind::$fixed); })*
                $(if name.eq_ignore_ascii_case(stringify!($adaptive)) { return Some(Kind::$adaptive); })*
                None
            }

            /// Name of the method.
            #[must_use]
            pub fn name(&self) -> &'static str {
                match self.kind {
                    $(Kind::$fixed => stringify!($fixed),)*
                    $(Kind::$adaptive => stringify!($adaptive),)*
                }
            }

            /// True if the method takes steps of a fixed length.
            #[must_use]
            pub fn is_fixed(&self) -> bool {
                match self.kind {
                    $(Kind::$fixed => true,)*
                    $(Kind::$adaptive => false,)*
                }
            }

            /// Integrates by the method.
            pub(crate) fn run<K: Task<N>, const N: usize>(&self, task: K) -> K::Output {
                match self.kind {
                    $(Kind::$fixed => task.by($fixed::new(self.h.unwrap_or(f64::NAN))),)*
                    $(Kind::$adaptive => task.by(self.set($adaptive::new())),)*
                }
            }
        }
    };
}

methods! {
    Rk4 Gauss4 Gauss6;
    Rk45 Tsit5 Vern7 Vern9 Taylor Rodas4 Rodas5P Radau5 Auto
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

/// Integration with derivatives.
pub(crate) trait TaskWithDerivatives<const N: usize> {
    type Output;

    fn by(
        self,
        method: impl pendulum_core::Method<Padded<Dual<f64, PART>, N>, Dual<f64, PART>, N> + Sync,
    ) -> Self::Output;
}

impl Method {
    /// The method of this name, in upper or lower case: `Rk4`, `Gauss4` and `Gauss6` with a fixed step, or `Rk45`,
    /// `Tsit5`, `Vern7`, `Vern9`, `Taylor`, `Rodas4`, `Rodas5P`, `Radau5` and `Auto` with a tolerance.
    ///
    /// # Errors
    /// If there is no such method; the error names the most similar one.
    pub fn new(name: &str) -> Result<Self, Error> {
        let unknown = || Error::unknown("method", name, Self::NAMES.iter().copied());
        Ok(Self {
            kind: Self::kind(name).ok_or_else(unknown)?,
            h: None,
            rtol: None,
            atol: None,
            h0: None,
            h_min: None,
            h_max: None,
            max_steps: None,
        })
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

    /// Integrates many trajectories in lanes of vector registers, if the method is one of those that do.
    pub(crate) fn run_in_lanes<K: TaskInLanes<N>, const N: usize>(&self, task: K) -> Result<K::Output, K> {
        Ok(match self.kind {
            Kind::Rk4 => task.by(Rk4::new(self.h.unwrap_or(f64::NAN))),
            Kind::Tsit5 => task.by(self.set(Tsit5::new())),
            Kind::Vern7 => task.by(self.set(Vern7::new())),
            Kind::Vern9 => task.by(self.set(Vern9::new())),
            _ => return Err(task),
        })
    }

    /// Integrates with derivatives.
    ///
    /// # Errors
    /// If the method is not one of those that do.
    pub(crate) fn run_with_derivatives<K, const N: usize>(&self, task: K) -> Result<K::Output, Error>
    where
        K: TaskWithDerivatives<N>,
    {
        match self.kind {
            Kind::Vern9 => Ok(task.by(self.set(Vern9::new()))),
            Kind::Rodas5P => Ok(task.by(self.set(Rodas5P::new()))),
            _ => Err(Error::Setting {
                what: "method".to_owned(),
                rule: format!(
                    "derivatives of trajectories are computed by `Vern9` or, for stiff systems, by `Rodas5P`, not by \
                     `{}`",
                    self.name()
                ),
            }),
        }
    }

    /// Checks that the settings are those of the method.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let name = self.name();
        let error = |what: &str, rule: String| {
            let what = what.to_owned();
            Err(Error::Setting { what, rule })
        };
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
    pub(crate) fn word(&self) -> Option<&'static str> {
        match self.kind {
            Kind::Gauss4 | Kind::Gauss6 => Some("canonical"),
            Kind::Taylor => Some("taylor"),
            Kind::Rodas4 | Kind::Rodas5P | Kind::Radau5 | Kind::Auto => Some("jacobian"),
            Kind::Rk4 | Kind::Rk45 | Kind::Tsit5 | Kind::Vern7 | Kind::Vern9 => None,
        }
    }

    fn set<F>(&self, mut method: Adaptive<F>) -> Adaptive<F> {
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

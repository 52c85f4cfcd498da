//! Ensembles on GPUs and other OpenCL devices.
//!
//! A scene declared by [`declared!`](crate::declared) keeps its declaration at run time. From it the generator writes
//! OpenCL C, and [`Device::method`] turns a method into an [`Ensemble`] that integrates each trajectory in a work-item
//! of the device, for [`Sweep::ends`](crate::Sweep::ends) or alone. The explicit Runge-Kutta methods from
//! [`Rk4`](pendulum_core::Rk4) to [`Vern9`](pendulum_core::Vern9) are supported, for scenes without inputs, dry
//! friction, stops and walls.
//!
//! In double precision the results have the bits of [`solve`](Method::solve), if the scene calls no functions but
//! sines, cosines and roots, angles stay below 1e5 rad, and the device rounds according to IEEE 754.
//!
//! ```no_run
//! use pendulum_core::prelude::*;
//! use pendulum_sweep::opencl::Device;
//! use pendulum_sweep::{Axis, Sweep, declared};
//!
//! declared! {
//!     pub Swing {
//!         params { gamma: N m s }
//!         gravity: [0, -9.81, 0],
//!         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: gamma }
//!     }
//! }
//!
//! let device = Device::first()?;
//! let sweep = Sweep::grid("swing", [
//!     Axis::linear("start", "rad", -3.0, 3.0, 1000),
//!     Axis::logarithmic("gamma", "N m s", 1e-3, 1.0, 1000),
//! ]);
//! let table = sweep
//!     .ends(device.method(Rk45::new())?, (0.0, 10.0), |[start, gamma]| {
//!         Ok((Swing::new(SwingParams { gamma })?, [start, 0.0]))
//!     })
//!     .run()?;
//! assert_eq!(table.rows(), 1_000_000);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod device;
mod source;

use std::fmt;
use std::marker::PhantomData;

use opencl3::error_codes::ClError;
use pendulum_core::ensemble::{Stopped, check_models, conclude};
use pendulum_core::nalgebra::SVector;
use pendulum_core::real::Float;
use pendulum_core::real::lanes::Isa;
use pendulum_core::{Cast, Ensemble, EnsembleError, Method, Reason};

pub use device::Device;
pub use source::{KernelMethod, Settings};

use crate::ends::is_of_start;
use crate::error::SweepError;
use device::Kernel;

/// Model whose declaration is available at run time: of a scene in [`declared!`](crate::declared).
pub trait Declared {
    /// Source text of the declaration.
    const DECLARATION: &'static str;

    /// Values of the parameters, in the order of their declaration.
    fn parameters(&self) -> Vec<f64>;
}

/// Like [`mechanism!`](pendulum_core::mechanism), but keeps the declaration of the scene at run time, so that
/// [kernels](crate::opencl) can be generated from it.
#[macro_export]
macro_rules! declared {
    ($(#[$attribute:meta])* $visibility:vis $name:ident { $($scene:tt)* }) => {
        ::pendulum_core::mechanism! { $(#[$attribute])* $visibility $name { $($scene)* } }

        impl $crate::opencl::Declared for $name {
            const DECLARATION: &'static str = ::core::stringify!($visibility $name { $($scene)* });

            fn parameters(&self) -> ::std::vec::Vec<f64> {
                self.params().to_array().to_vec()
            }
        }
    };
}

/// Method that integrates on a device; see [`Device::method`].
pub struct OnDevice<X, M> {
    method: X,
    kernel: Kernel,
    single: bool,
    model: PhantomData<fn() -> M>,
}

/// Number of trajectories per batch: enough to fill a GPU.
const BATCH: usize = 1 << 16;
/// Number of distinct outcomes in the code of a trajectory.
const ENDS: i32 = 5;

impl Device {
    /// Returns `method` for models of one scene, on this device, in double precision.
    ///
    /// # Errors
    /// [`SweepError::Invalid`] with advice, if the scene has dry friction, stops, walls or inputs, if the device has no
    /// double precision, or if its compiler rejects the kernel.
    pub fn method<M: Declared, X: KernelMethod>(&self, method: X) -> Result<OnDevice<X, M>, SweepError> {
        self.compile(method, false)
    }

    /// Like [`method`](Self::method), but in single precision, in which most GPUs are many times faster. Settings that
    /// are not given take the defaults of `f32`; results are close to those of `f32` in Rust, but not bit for bit
    /// equal.
    ///
    /// # Errors
    /// Like [`method`](Self::method).
    pub fn method_in_single<M: Declared, X: KernelMethod>(&self, method: X) -> Result<OnDevice<X, M>, SweepError> {
        self.compile(method, true)
    }

    fn compile<M: Declared, X: KernelMethod>(&self, method: X, single: bool) -> Result<OnDevice<X, M>, SweepError> {
        let invalid = |reason: String| SweepError::Invalid(reason);
        let tokens = M::DECLARATION
            .parse()
            .map_err(|_| invalid("not a declaration".to_owned()))?;
        let program = pendulum_codegen::program(tokens).map_err(|errors| invalid(errors.to_string()))?;
        if !program.constraints.is_empty() || !program.inputs.is_empty() {
            let name = &program.name;
            return Err(invalid(format!(
                "`{name}` has inputs, dry friction, stops or walls, which kernels do not take: integrate it on the CPU"
            )));
        }
        let text = source::program(&pendulum_codegen::opencl(&program), &method);
        let kernel = Kernel::new(self, &text, single)?;
        Ok(OnDevice {
            method,
            kernel,
            single,
            model: PhantomData,
        })
    }
}

impl<X: fmt::Debug, M> fmt::Debug for OnDevice<X, M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OnDevice")
            .field("method", &self.method)
            .field("device", &self.kernel.device_name())
            .field("single", &self.single)
            .finish()
    }
}

impl<X, M, const N: usize> Ensemble<M, f64, N> for OnDevice<X, M>
where
    X: KernelMethod + Method<M::In<f64>, f64, N> + Method<M::In<f32>, f32, N>,
    M: Declared + Cast<N>,
{
    fn ensemble_on(
        &self,
        _isa: Isa,
        models: &[M],
        t0: f64,
        t1: f64,
        starts: &[SVector<f64, N>],
    ) -> Result<Vec<SVector<f64, N>>, EnsembleError<f64, N>> {
        if self.single {
            self.integrate::<f32, N>(models, (t0, t1), starts)
        } else {
            self.integrate::<f64, N>(models, (t0, t1), starts)
        }
    }

    fn batch(&self) -> usize {
        BATCH
    }
}

impl<X, M> OnDevice<X, M> {
    fn integrate<T: Float, const N: usize>(
        &self,
        models: &[M],
        (t0, t1): (f64, f64),
        starts: &[SVector<f64, N>],
    ) -> Result<Vec<SVector<f64, N>>, EnsembleError<f64, N>>
    where
        X: KernelMethod + Method<M::In<T>, T, N>,
        M: Declared + Cast<N>,
    {
        check_models(models, starts)?;
        let span = (T::from_f64(t0), T::from_f64(t1));
        let settings = self.method.settings(span)?;
        let (mut ends, mut stopped) = (starts.to_vec(), Vec::new());
        // trajectories with a valid start: their parameters, initial states and first step sizes
        let (mut started, mut parameters, mut points) = (Vec::new(), Vec::new(), Vec::new());
        for (index, start) in starts.iter().enumerate() {
            let model = if let [model] = models { model } else { &models[index] };
            let start = start.map(T::from_f64);
            match self.method.stepper(&model.cast::<T>(), span.0, span.1, start) {
                Ok(stepper) => {
                    started.push(index);
                    parameters.extend(model.parameters().into_iter().map(T::from_f64));
                    points.extend(start.iter().copied().chain([stepper.h()]));
                }
                Err(reason) if is_of_start(&reason) => stopped.push(Stopped::new(index, t0, reason)),
                Err(reason) => return Err(EnsembleError::InvalidInput(reason)),
            }
        }
        if started.is_empty() {
            return conclude(ends, stopped);
        }
        let reached = self
            .kernel
            .integrate((started.len(), N), span, &settings, &parameters, &points)
            .map_err(|ClError(code)| {
                EnsembleError::InvalidInput(Reason::InvalidInput {
                    what: "device",
                    value: f64::from(code),
                    rule: "OpenCL failed with this code; a smaller ensemble takes less memory",
                })
            })?;
        for ((&index, numbers), &code) in started.iter().zip(reached.numbers.chunks(N + 3)).zip(&reached.codes) {
            ends[index] = SVector::from_fn(|component, _| numbers[component].to_f64());
            let t = numbers[N].to_f64();
            let details = (numbers[N + 1].to_f64(), numbers[N + 2].to_f64());
            let reason = reason(code, details, settings.max_steps);
            stopped.extend(reason.map(|reason| Stopped::new(index, t, reason)));
        }
        conclude(ends, stopped)
    }
}

/// Decodes the outcome of a trajectory.
fn reason(code: i32, (h, least): (f64, f64), max_steps: u64) -> Option<Reason> {
    let component = (code / ENDS) as usize;
    Some(match code % ENDS {
        1 => Reason::NonFinite { component, h: Some(h) },
        2 => Reason::NonFinite { component, h: None },
        3 => Reason::StepUnderflow { h, least },
        4 => Reason::TooManySteps {
            max_steps: max_steps as usize,
        },
        _ => return None,
    })
}

//! The methods of integration: plain values with settings, each with `solve` and `stepper`.

mod adaptive;
mod explicit;
mod fixed;
mod grid;
mod input;
mod rk4;
mod rk45;
mod stepper;

pub(crate) use explicit::{SHORT, attempt};
pub(crate) use grid::Grid;
pub(crate) use input::{check_span, require};

pub use adaptive::Adaptive;
pub use fixed::Fixed;
pub use rk4::Rk4;
pub use rk45::Rk45;
pub use stepper::Stepper;

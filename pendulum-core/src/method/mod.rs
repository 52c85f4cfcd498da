//! The methods of integration: plain values with settings, each with `solve` and `stepper`.

mod adaptive;
mod explicit;
mod fixed;
mod input;
mod rk4;
mod rk45;
mod stepper;

pub use adaptive::Adaptive;
pub use fixed::Fixed;
pub use rk4::Rk4;
pub use rk45::Rk45;
pub use stepper::Stepper;

//! Methods and stability on systems written by hand.

mod auto;
mod continuation;
mod events;
mod failures;
mod hostile;
mod implicit;
mod inputs;
mod jumps;
mod methods;
mod orbits;
mod rosenbrock;
#[cfg(feature = "serde")]
mod serialization;
mod stability;
mod stability_functions;
mod tableaus;

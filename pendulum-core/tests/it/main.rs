//! Methods and stability on systems written by hand.
#![forbid(unsafe_code)]
#![allow(clippy::disallowed_methods, reason = "references may be those of the platform")]

mod auto;
mod bifurcations;
mod continuation;
mod control;
mod equations;
mod events;
mod failures;
mod hostile;
mod hybrid;
mod implicit;
mod inputs;
mod jumps;
mod methods;
mod orbits;
mod rosenbrock;
mod small;
mod stability;
mod stability_functions;
mod tableaus;
mod unresolved;

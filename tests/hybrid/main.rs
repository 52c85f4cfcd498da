//! Sticking dry friction, stops, walls, and inputs: generated models in every mode against closed forms and other
//! derivations.
#![forbid(unsafe_code)]

mod controlled;
mod corner;
mod floating;
mod hybrid_stability;
mod impacts;
mod invariants;
mod lift_off;
mod modes;
mod scenes;

//! Closed loops: assembled, moved by every method, and stopped where they cannot close.
#![forbid(unsafe_code)]

mod assembled;
mod closures;
mod coupled_loops;
mod linkages;
mod turns;

//! Tests that take long to build or to run: every method in lanes, the promised operations of steps for all sizes, and
//! many random scenes; tapes, which build slowly as well.
//!
//! `cargo test -p tests --features thorough --test thorough`
#![forbid(unsafe_code)]

mod agreement;
mod alone;
mod exponents;
mod floating;
mod lanes;
mod long;
mod rough;
mod step_limits;
mod tapes;

//! The slips of the printed paper, row by row as in `docs/paper-audit.md`: H. Williams, "A compound double pendulum with friction",
//! Forces in Mechanics (2023).
//!
//! Each test makes one check of two forms, and asserts that the right one passes it and that the printed one fails, and
//! by how much. The printed forms are code of their own, as a reader would type them. `cargo test -p studies --features thorough
//! paper_audit -- --nocapture` prints the sizes.

mod chain;
mod equations;
mod hanging;
mod linear;
mod newton;
mod plates;
mod quartic;
mod screws;
mod swing;
mod units;

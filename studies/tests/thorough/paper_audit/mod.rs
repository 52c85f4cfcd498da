//! Misprints of the paper, row by row like in `docs/paper-audit.md`: H. Williams, "A compound double pendulum with
//! friction", Forces in Mechanics (2023).
//!
//! Each test applies one check to two forms, and asserts that the correct one passes and that the printed one fails,
//! and by how much. The printed forms are separate code, as a reader would type them. `cargo test -p studies --features
//! thorough paper_audit -- --nocapture` prints the sizes of the errors.

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

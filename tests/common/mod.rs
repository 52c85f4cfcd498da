//! What several integration tests share.
#![allow(
    dead_code,
    unreachable_pub,
    reason = "each test is a crate of its own and uses a part of this"
)]

pub mod chains;
pub mod dual;
pub mod eq22;
pub mod lopsided;
pub mod mechanisms;
pub mod random;
pub mod ratios;
pub mod reference;
pub mod scenes;
pub mod trajectories;

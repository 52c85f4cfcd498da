//! Tests of the studies: accuracy, failures, stability, and the misprints of the paper.
#![forbid(unsafe_code)]

mod accuracy;
mod bifurcations;
mod every_failure;
mod open_questions;
mod paper_audit;
mod solve_accuracy;
mod stability;
mod twelve_problems;
mod where_methods_fail;

//! Shared parts of tests and studies: scenes, reference data, number types and known failures.
#![forbid(unsafe_code)]
#![allow(missing_docs, reason = "fields and functions whose names say what they are")]

pub mod by_hand;
pub mod chains;
pub mod contacts;
pub mod counted;
pub mod digest;
pub mod dual;
pub mod eq22;
pub mod fit;
pub mod linkages;
pub mod lopsided;
pub mod mechanisms;
pub mod methods;
pub mod motions;
pub mod plates;
pub mod power_series;
pub mod printed;
pub mod problems;
pub mod random;
pub mod ratios;
pub mod reference;
pub mod robots;
pub mod scenes;
pub mod series;
pub mod source;
pub mod trajectories;
pub mod trees;
pub mod where_methods_fail;
pub mod work;

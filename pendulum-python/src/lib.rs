//! The part of the package `pendulum` that is written in Rust. Its functions take arrays of the right type; the Python
//! files convert to them.

mod ensemble;
mod error;
mod fit;
mod model;
mod motion;
mod wait;

use pyo3::prelude::*;

#[pymodule]
mod _native {
    #[pymodule_export]
    use super::error::DeclarationError;
    #[pymodule_export]
    use super::model::Model;
    #[pymodule_export]
    use super::motion::Motion;
}

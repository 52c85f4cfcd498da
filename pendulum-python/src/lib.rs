//! The part of the package `pendulum_dynamics` that is written in Rust. Its functions take arrays of the right type;
//! the Python files convert to them.

mod ensemble;
mod error;
mod fit;
mod inputs;
mod model;
mod motion;
mod wait;

use pyo3::pymodule;

#[pymodule]
mod _native {
    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("METHODS", pendulum_runtime::Method::NAMES)
    }

    #[pymodule_export]
    use super::error::DeclarationError;
    #[pymodule_export]
    use super::model::Model;
    #[pymodule_export]
    use super::motion::Motion;
}

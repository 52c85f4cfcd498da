//! Right-hand side and Jacobian behind pointers.

use nalgebra::SVector;
use pendulum_core::Jacobian;

type Function = Box<dyn Fn(&[f64], &mut [f64])>;
type Product = dyn Fn(&[f64], &[f64], &mut [f64]);

/// Right-hand side and Jacobian, for libraries whose states have no length at compile time. No problem depends on time.
pub struct Model {
    /// Number of components of the state.
    pub length: usize,
    /// Writes the derivative of a state.
    pub rhs: Function,
    /// Writes the Jacobian at a state, column by column.
    pub jacobian: Function,
    /// Writes the product of the Jacobian at a state and a vector.
    pub product: Box<Product>,
}

impl Model {
    pub(crate) fn of<S: Jacobian<f64, N>, const N: usize>(model: &'static S) -> Self {
        let state = |x: &[f64]| SVector::<f64, N>::from_column_slice(x);
        Self {
            length: N,
            rhs: Box::new(move |x, slope| slope.copy_from_slice(model.rhs(0.0, &state(x)).as_slice())),
            jacobian: Box::new(move |x, columns| columns.copy_from_slice(model.jacobian(0.0, &state(x)).as_slice())),
            product: Box::new(move |x, v, product| {
                product.copy_from_slice((model.jacobian(0.0, &state(x)) * state(v)).as_slice());
            }),
        }
    }
}

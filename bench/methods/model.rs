//! The generated model for libraries in other languages, as declared in `double_pendulum.h`.
//!
//! The declaration of the model is prepended to this file.

use pendulum_core::prelude::*;

/// Creates a model with the given friction of both joints.
#[unsafe(export_name = "double_pendulum")]
pub extern "C" fn make(gamma: f64) -> *mut DoublePendulum {
    Box::into_raw(Box::new(double_pendulum(gamma).expect("good parameters")))
}

/// # Safety
/// `model` was returned by `double_pendulum`, and is not used afterwards.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn double_pendulum_free(model: *mut DoublePendulum) {
    // SAFETY: guaranteed by the caller.
    drop(unsafe { Box::from_raw(model) });
}

/// # Safety
/// `model` was returned by `double_pendulum`; state and slope have four numbers each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn double_pendulum_rhs(model: *const DoublePendulum, x: *const [f64; 4], slope: *mut [f64; 4]) {
    // SAFETY: guaranteed by the caller.
    unsafe { *slope = (*model).rhs(0.0, &SVector::from(*x)).data.0[0] };
}

/// # Safety
/// `model` was returned by `double_pendulum`; the state has four numbers, the Jacobian sixteen.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn double_pendulum_jacobian(
    model: *const DoublePendulum,
    x: *const [f64; 4],
    columns: *mut [[f64; 4]; 4],
) {
    // SAFETY: guaranteed by the caller.
    unsafe { *columns = (*model).jacobian(0.0, &SVector::from(*x)).data.0 };
}

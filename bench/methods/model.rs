//! The generated model for libraries of other languages: what `double_pendulum.h` declares.
//!
//! The declaration of the model is put before this.

use pendulum_core::prelude::*;

/// A model with its parameters, of which the friction of both axles is given.
#[unsafe(export_name = "double_pendulum")]
pub extern "C" fn make(gamma: f64) -> *mut DoublePendulum {
    Box::into_raw(Box::new(double_pendulum(gamma).expect("good parameters")))
}

/// # Safety
/// The model comes from `double_pendulum`, and is not used any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn double_pendulum_free(model: *mut DoublePendulum) {
    // SAFETY: as the caller promises.
    drop(unsafe { Box::from_raw(model) });
}

/// # Safety
/// The model comes from `double_pendulum`; state and slope have four numbers each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn double_pendulum_rhs(model: *const DoublePendulum, x: *const [f64; 4], slope: *mut [f64; 4]) {
    // SAFETY: as the caller promises.
    unsafe { *slope = (*model).rhs(0.0, &SVector::from(*x)).data.0[0] };
}

/// # Safety
/// The model comes from `double_pendulum`; the state has four numbers, the Jacobian sixteen.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn double_pendulum_jacobian(
    model: *const DoublePendulum,
    x: *const [f64; 4],
    columns: *mut [[f64; 4]; 4],
) {
    // SAFETY: as the caller promises.
    unsafe { *columns = (*model).jacobian(0.0, &SVector::from(*x)).data.0 };
}

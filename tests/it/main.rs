//! The generator and the numbers together: generated models against reference data, other derivations, and each other.
#![forbid(unsafe_code)]

mod c_code;
mod canonical;
mod closed_loops;
mod compile_errors;
mod controlled;
mod double_pendulum;
mod drives;
mod emitted_c;
mod every_method;
mod followers;
mod forces;
mod gauss;
mod golden;
mod growth;
mod hybrid;
mod hybrid_stability;
mod lanes;
mod lift_off;
mod mechanisms;
mod methods;
mod modes;
mod parameters;
mod points;
mod random_mechanisms;
mod robots;
mod rough;
mod sincos;
mod step_limits;
mod stiff;
mod taylor;
mod taylor_traps;
mod trajectories;
mod urdf;

//! Integration tests of generator and core: generated models against reference data, other derivations, and each other.
#![forbid(unsafe_code)]

mod adjoints;
mod balls;
mod c_code;
mod canonical;
mod clamp;
mod closed_loops;
mod compile_errors;
mod control;
mod double_pendulum;
mod drives;
mod emitted_c;
mod every_method;
mod fits;
mod followers;
mod forces;
mod fused;
mod gauss;
mod global_errors;
mod golden;
mod growth;
mod mechanisms;
mod methods;
mod parameters;
mod points;
mod quaternions;
mod random_mechanisms;
mod robots;
mod sensitivities;
mod sincos;
mod states;
mod stiff;
mod taylor;
mod taylor_traps;
mod trajectories;
mod urdf;

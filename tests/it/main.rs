//! The generator and the numbers together: generated models against reference data, other derivations, and each other.

mod accuracy;
mod bifurcations;
mod canonical;
mod compile_errors;
mod double_pendulum;
mod emitted_c;
mod every_failure;
mod every_method;
mod forces;
mod gauss;
mod golden;
mod growth;
mod lanes;
mod mechanisms;
mod methods;
mod paper_audit;
mod parameters;
mod robots;
mod sincos;
mod solve_accuracy;
mod stability;
mod stiff;
mod taylor;
mod taylor_traps;
mod trajectories;
mod where_methods_fail;

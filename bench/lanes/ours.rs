//! RK4 on double pendulums: one after another, and in the lanes of each instruction set.
//!
//! All functions have the same signature as those of the peers: they read `count` initial states of four numbers and
//! write the final states.

use std::ffi::c_long;

use pendulum_core::prelude::*;
use pendulum_core::Float;
use pendulum_core::real::lanes::{Isa, LaneElement};

mechanism! {
    pub DoublePendulum {
        params { m: kg, inertia: kg m^2, c: m, d: m, g: m/s^2, gamma: N m s }
        gravity: [0, -g, 0],
        shape plate { mass: m, com: [0, -c, 0], inertia: inertia }
        body upper on ground: plate { joint: revolute(z), coordinate: theta1, friction: gamma }
        body lower on upper: plate { joint: revolute(z) at [0, -d, 0], coordinate: theta2 absolute, friction: gamma }
    }
}

const METHOD: fn() -> Rk4 = || Rk4::new(0.01);
const END: f64 = 10.0;

/// Hides the parameters from the optimiser, so that they are known only at run time.
fn model() -> DoublePendulum {
    let params = std::hint::black_box(DoublePendulumParams {
        m: 1.0,
        inertia: 1.0,
        c: 1.0,
        d: 1.0,
        g: 9.8,
        gamma: 0.0,
    });
    DoublePendulum::new(params).expect("good parameters")
}

fn alone<T: Float>(starts: &[[f64; 4]], ends: &mut [[f64; 4]])
where
    DoublePendulum<T>: System<T, 4>,
{
    let model = model().cast::<T>();
    for (start, end) in starts.iter().zip(ends) {
        let start = SVector::from(start.map(T::from_f64));
        let mut stepper = METHOD().stepper(&model, T::from_f64(0.0), T::from_f64(END), start).expect("a good start");
        while stepper.step().expect("a good step").is_some() {}
        *end = stepper.x().data.0[0].map(Float::to_f64);
    }
}

fn lanes<T: LaneElement>(name: &str, starts: &[[f64; 4]], ends: &mut [[f64; 4]]) {
    let isa = Isa::available().find(|isa| format!("{isa:?}") == name).expect("an instruction set of this machine");
    let starts: Vec<SVector<T, 4>> = starts.iter().map(|start| SVector::from(start.map(T::from_f64))).collect();
    let found = METHOD().ensemble_on(isa, &[model()], T::from_f64(0.0), T::from_f64(END), &starts).expect("good steps");
    for (found, end) in found.iter().zip(ends) {
        *end = found.data.0[0].map(Float::to_f64);
    }
}

macro_rules! functions {
    ($($name:ident: $body:expr;)*) => { $(
        /// # Safety
        /// `starts` points to `count` states, and `ends` to room for as many.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(starts: *const [f64; 4], ends: *mut [f64; 4], count: c_long) {
            // SAFETY: guaranteed by the caller.
            let (starts, ends) = unsafe {
                (
                    std::slice::from_raw_parts(starts, count as usize),
                    std::slice::from_raw_parts_mut(ends, count as usize),
                )
            };
            let body: fn(&[[f64; 4]], &mut [[f64; 4]]) = $body;
            body(starts, ends);
        }
    )* };
}

functions! {
    alone_f64: |starts, ends| alone::<f64>(starts, ends);
    alone_f32: |starts, ends| alone::<f32>(starts, ends);
    portable_f64: |starts, ends| lanes::<f64>("Portable", starts, ends);
    portable_f32: |starts, ends| lanes::<f32>("Portable", starts, ends);
    avx2_f64: |starts, ends| lanes::<f64>("Avx2", starts, ends);
    avx2_f32: |starts, ends| lanes::<f32>("Avx2", starts, ends);
    avx512_f64: |starts, ends| lanes::<f64>("Avx512", starts, ends);
    avx512_f32: |starts, ends| lanes::<f32>("Avx512", starts, ends);
}

//! Evaluations of a right-hand side, either independent or each depending on the previous one, with an inserted
//! operation or without.
//!
//! `MODEL` and its number of state variables `N` are prepended to this file, and the module `cheap`.

use cheap::Cheap;
use std::ffi::c_long;
use std::hint::black_box;

type Plain = Cheap<true, true>;

unsafe fn given<'a>(states: *const [f64; N], count: c_long) -> &'a [[f64; N]] {
    // SAFETY: the caller passes `count` states.
    unsafe { std::slice::from_raw_parts(states, count as usize) }
}

macro_rules! functions {
    ($($beside:ident $after:ident $jacobian:ident $sines:literal $divisions:literal;)*) => { $(
        /// Independent evaluations.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $beside(states: *const [f64; N], _: *mut f64, count: c_long) {
            type T = Cheap<$sines, $divisions>;
            let model = MODEL.cast::<T>();
            for x in unsafe { given(states, count) } {
                black_box(model.rhs(Cheap(0.0), &SVector::from(x.map(Cheap))));
            }
        }

        /// Each state depends on the derivative at the previous one, component by component, as in an integration.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $after(states: *const [f64; N], _: *mut f64, count: c_long) {
            type T = Cheap<$sines, $divisions>;
            let model = MODEL.cast::<T>();
            let zero = black_box(Cheap(0.0));
            let mut f = SVector::from([Cheap(0.0); N]);
            for x in unsafe { given(states, count) } {
                f = model.rhs(Cheap(0.0), &SVector::from_fn(|i, _| Cheap(x[i]) + zero * f[i]));
            }
            black_box(f);
        }

        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $jacobian(states: *const [f64; N], _: *mut f64, count: c_long) {
            type T = Cheap<$sines, $divisions>;
            let model = MODEL.cast::<T>();
            for x in unsafe { given(states, count) } {
                black_box(model.jacobian(Cheap(0.0), &SVector::from(x.map(Cheap))));
            }
        }
    )* };
}

functions! {
    beside_both after_both jacobian_both true true;
    beside_divisions after_divisions jacobian_divisions false true;
    beside_sines after_sines jacobian_sines true false;
    beside_neither after_neither jacobian_neither false false;
}

macro_rules! insertions {
    ($($on:ident $off:ident $beside:ident: $operation:expr;)*) => { $(
        /// Inserts the operation between the accelerations and the rates computed from them: on the critical path.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $on(states: *const [f64; N], _: *mut f64, count: c_long) {
            let model = MODEL.cast::<Plain>();
            let (zero, c) = black_box((Cheap(0.0), Cheap(1.25)));
            let operation: fn(Plain, Plain) -> (Plain, Plain) = $operation;
            let mut f = SVector::from([Cheap(0.0); N]);
            for x in unsafe { given(states, count) } {
                let e = operation(c + zero * (f[N / 2] + f[N - 1]), c);
                let last = zero * (e.0 + e.1);
                f = model.rhs(
                    Cheap(0.0),
                    &SVector::from_fn(|i, _| Cheap(x[i]) + if i < N / 2 { zero * f[i] } else { last }),
                );
            }
            black_box(f);
        }

        /// Applies the operation to a number given with the state, and stores the result: no later operation depends on
        /// it.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $off(states: *const [f64; N], _: *mut f64, count: c_long) {
            let model = MODEL.cast::<Plain>();
            let (zero, c) = black_box((Cheap(0.0), Cheap(1.25)));
            let operation: fn(Plain, Plain) -> (Plain, Plain) = $operation;
            let mut f = SVector::from([Cheap(0.0); N]);
            for x in unsafe { given(states, count) } {
                black_box(operation(c + Cheap(x[0]), c));
                f = model.rhs(Cheap(0.0), &SVector::from_fn(|i, _| Cheap(x[i]) + zero * f[i]));
            }
            black_box(f);
        }

        /// Applies the operation with independent evaluations.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $beside(states: *const [f64; N], _: *mut f64, count: c_long) {
            let model = MODEL.cast::<Plain>();
            let c = black_box(Cheap(1.25));
            let operation: fn(Plain, Plain) -> (Plain, Plain) = $operation;
            for x in unsafe { given(states, count) } {
                black_box(operation(c + Cheap(x[0]), c));
                black_box(model.rhs(Cheap(0.0), &SVector::from(x.map(Cheap))));
            }
        }
    )* };
}

insertions! {
    on_nothing off_nothing beside_nothing: |x, c| (x, c);
    on_addition off_addition beside_addition: |x, c| (x + c, c);
    on_multiplication off_multiplication beside_multiplication: |x, c| (x * c, c);
    on_division off_division beside_division: |x, c| (c / x, c);
    on_sincos off_sincos beside_sincos: |x, _| x.sin_cos();
    on_sqrt off_sqrt beside_sqrt: |x, c| (x.sqrt(), c);
    on_exp off_exp beside_exp: |x, c| (x.exp(), c);
}

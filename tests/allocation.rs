//! No heap in a step, nor in a right-hand side: counted by the allocator itself.
#![allow(
    unsafe_code,
    reason = "a global allocator is unsafe by its nature; this one counts and forwards"
)]

mod common;

use std::alloc::{GlobalAlloc, Layout, System as Heap};
use std::cell::Cell;

use common::mechanisms::Tree;
use common::scenes::{DoublePendulum, DoublePendulumParams};
use pendulum_core::prelude::*;

struct Counting;

thread_local! {
    /// Allocations of this thread: those of the test harness are its own business.
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call goes to the system's allocator with the arguments as they came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.set(COUNT.get() + 1);
        // SAFETY: the caller keeps the contract of `alloc`.
        unsafe { Heap.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller keeps the contract of `dealloc`.
        unsafe { Heap.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// How often `work` allocates.
fn allocations(work: impl FnOnce()) -> usize {
    let before = COUNT.get();
    work();
    COUNT.get() - before
}

fn pendulum(gamma: f64) -> DoublePendulum {
    let params = DoublePendulumParams {
        gamma1: gamma,
        gamma2: gamma,
        ..Default::default()
    };
    DoublePendulum::new(params).expect("physical")
}

const START: [f64; 4] = [2.0, 2.5, 0.0, 0.0];

#[test]
fn the_count_counts() {
    let boxed = || drop(std::hint::black_box(Box::new(1.0)));
    assert_eq!(allocations(boxed), 1);
}

#[test]
fn the_functions_of_a_model_do_not_allocate() {
    let model = pendulum(0.1);
    let x = SVector::from(START);
    let evaluate = || {
        std::hint::black_box((model.rhs(0.0, &x), model.jacobian(0.0, &x)));
        std::hint::black_box(model.energy(0.0, &x));
    };
    assert_eq!(allocations(evaluate), 0);
    let model = Tree::new(Default::default()).expect("physical");
    let x = SVector::from([0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8]);
    let evaluate = || {
        std::hint::black_box((model.rhs(0.0, &x), model.jacobian(0.0, &x)));
        std::hint::black_box((model.mass_matrix(0.0, &x), model.bias(0.0, &x)));
    };
    assert_eq!(allocations(evaluate), 0);
}

#[test]
fn adaptive_steps_do_not_allocate() {
    let model = pendulum(0.0);
    let mut steps = 0;
    let integrate = || {
        let mut stepper = Rk45::new().stepper(&model, 0.0, 100.0, START).expect("valid");
        while let Some(step) = stepper.step().expect("regular") {
            std::hint::black_box(stepper.dense().at(step.t0 + 0.5 * step.h));
            steps += 1;
        }
        assert!(stepper.statistics().rejected > 0);
    };
    assert_eq!(allocations(integrate), 0);
    assert!(steps > 1000, "{steps}");
}

#[test]
fn fixed_steps_do_not_allocate() {
    let model = pendulum(0.0);
    let mut steps = 0;
    let integrate = || {
        let mut stepper = Rk4::new(0.01).stepper(&model, 0.0, 50.0, START).expect("valid");
        while let Some(step) = stepper.step().expect("regular") {
            std::hint::black_box(stepper.dense().at(step.t0 + 0.5 * step.h));
            steps += 1;
        }
    };
    assert_eq!(allocations(integrate), 0);
    assert_eq!(steps, 5000);
}

#[test]
fn implicit_steps_do_not_allocate() {
    let model = pendulum(10.0);
    let mut steps = 0;
    macro_rules! integrate {
        ($method:expr) => {
            let mut stepper = $method.stepper(&model, 0.0, 20.0, START).expect("valid");
            while let Some(step) = stepper.step().expect("regular") {
                std::hint::black_box(stepper.dense().at(step.t0 + 0.5 * step.h));
                steps += 1;
            }
        };
    }
    let integrate = || {
        integrate!(Rodas5P::new());
        integrate!(Radau5::new());
    };
    assert_eq!(allocations(integrate), 0);
    assert!(steps > 100, "{steps}");
}

#[test]
fn steps_in_canonical_variables_do_not_allocate() {
    fn steps<M: Method<Tree, f64, 8>>(method: &M) -> usize {
        let model = Tree::new(Default::default()).expect("physical");
        let mut steps = 0;
        let integrate = || {
            let start = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8];
            let mut stepper = method.stepper(&model, 0.0, 5.0, start).expect("valid");
            while let Some(step) = stepper.step().expect("regular") {
                std::hint::black_box(stepper.dense().at(step.t0 + 0.5 * step.h));
                steps += 1;
            }
        };
        assert_eq!(allocations(integrate), 0);
        steps
    }
    assert_eq!(steps(&Gauss4::new(0.01)), 500);
    assert_eq!(steps(&Gauss6::new(0.02)), 250);
}

#[test]
fn errors_of_a_stepper_do_not_allocate() {
    let model = pendulum(0.0);
    let fail = || {
        let mut stepper = Rk45::new()
            .max_steps(10)
            .stepper(&model, 0.0, 50.0, START)
            .expect("valid");
        let reason = loop {
            if let Err(reason) = stepper.step() {
                break reason;
            }
        };
        assert_eq!(reason, Reason::TooManySteps { max_steps: 10 });
    };
    assert_eq!(allocations(fail), 0);
}

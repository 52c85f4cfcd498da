//! No heap allocation in a step or a right-hand side, as counted by the allocator itself.
#![allow(
    unsafe_code,
    reason = "a global allocator is unsafe by its nature; this one counts and forwards"
)]

use std::alloc::{GlobalAlloc, Layout, System as Heap};
use std::cell::Cell;

use pendulum_core::control::{Ilqr, Integrated, Pid, Quadratic, Sampled};
use pendulum_core::method::{Adaptive, Estimates, Fixed, OneStep};
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::Isa;
use pendulum_core::{Reason, TaylorSeries};
use testbed::mechanisms::Tree;
use testbed::methods::Promise;
use testbed::scenes::{DoublePendulum, double_pendulum};

struct Counting;

thread_local! {
    /// Number of allocations of this thread. Those of the test harness do not count.
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call is forwarded to the system's allocator with unchanged arguments.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.set(COUNT.get() + 1);
        // SAFETY: the caller upholds the contract of `alloc`.
        unsafe { Heap.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller upholds the contract of `dealloc`.
        unsafe { Heap.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Number of allocations in `work`. The instruction set is looked up in the environment once, before the count.
fn allocations(work: impl FnOnce()) -> usize {
    std::hint::black_box(Isa::widest());
    let before = COUNT.get();
    work();
    COUNT.get() - before
}

const START: [f64; 4] = [2.0, 2.5, 0.0, 0.0];

#[test]
fn the_count_counts() {
    let boxed = || drop(std::hint::black_box(Box::new(1.0)));
    assert_eq!(allocations(boxed), 1);
}

#[test]
fn the_functions_of_a_model_do_not_allocate() {
    let model = double_pendulum(0.1);
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

/// Takes steps with dense output and restarts to the end, and returns their number.
fn walk<M, S, const N: usize>(method: &M, model: &S, t1: f64, x0: [f64; N]) -> usize
where
    M: Method<S, f64, N>,
    S: System<f64, N>,
{
    let mut steps = 0;
    let integrate = || {
        let mut stepper = method.stepper(model, 0.0, t1, x0).expect("valid");
        while let Some(step) = stepper.step().expect("regular") {
            let (t, dense) = (step.t0 + 0.5 * step.h, stepper.dense());
            let x = std::hint::black_box(dense.at(t));
            if steps % 10 == 9 && step.t1 < t1 {
                stepper.restart(t, x).expect("regular");
            }
            steps += 1;
        }
    };
    assert_eq!(allocations(integrate), 0);
    steps
}

#[test]
fn steps_do_not_allocate() {
    fn fixed<F: OneStep<DoublePendulum, f64, 4> + Default>(promise: &Promise) {
        let steps = walk(&Fixed::<F>::new(0.01), &double_pendulum(0.0), 2.0, START);
        assert!(steps >= 200, "{promise:?}: {steps}");
    }
    // more states than the shortcuts are for
    fn longer<F: OneStep<Tree, f64, 8> + Default>(promise: &Promise) {
        let tree = Tree::new(Default::default()).expect("physical");
        let start = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8];
        let steps = walk(&Fixed::<F>::new(0.01), &tree, 1.0, start);
        assert!(steps >= 100, "{promise:?}: {steps}");
    }
    fn adaptive<F: OneStep<DoublePendulum, f64, 4> + Estimates + Default>(promise: &Promise) {
        for gamma in [0.0, 100.0] {
            let steps = walk(&Adaptive::<F>::new(), &double_pendulum(gamma), 10.0, START);
            assert!(steps > 10, "{promise:?}: {steps}");
        }
    }
    testbed::each_adaptive!(fixed);
    testbed::each_without_estimate!(fixed);
    testbed::each_without_estimate!(longer);
    testbed::each_adaptive!(adaptive);
}

/// The first series of equations by hand makes room for all.
#[test]
fn series_by_hand_do_not_allocate_again() {
    let (_, arenstorf, _) = testbed::by_hand::three();
    let mut series = [SVector::from([0.5, 0.3, 0.1, -1.2]); 16];
    let mut work = arenstorf.workspace();
    assert_ne!(allocations(|| arenstorf.series(0.0, &mut series, &mut work)), 0);
    assert_eq!(allocations(|| arenstorf.series(0.0, &mut series, &mut work)), 0);
}

mechanism! {
    /// A pendulum with a motor.
    pub Driven {
        input motor: N m,
        gravity: [0, -9.81, 0],
        body bob on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, torque: motor, dry_friction: 0.5,
        }
    }
}

#[test]
fn sampled_controllers_do_not_allocate() {
    let model = Driven::new(DrivenParams {}).expect("physical");
    let pid = Pid::new(40.0, 60.0, 6.0).set_point(1.0);
    let sampled = Sampled::of_components(pid, 0.01, [Driven::ANGLE]);
    let sampled = sampled
        .delay(0.025)
        .noise([1e-3])
        .resolution([1e-3])
        .limits([-9.0], [9.0]);
    let integrate = || {
        let end = sampled.end(&Vern7::new(), &model, 0.0, 5.0, [0.0, 0.0]);
        assert!((end.expect("a motion")[0] - 1.0).abs() < 0.1);
    };
    assert_eq!(allocations(integrate), 0);
}

mechanism! {
    /// A pendulum with a motor, and without friction.
    pub Frictionless {
        input motor: N m,
        gravity: [0, -9.81, 0],
        body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, torque: motor }
    }
}

#[test]
fn iterative_lqr_does_not_allocate() {
    let model = Frictionless::new(FrictionlessParams {}).expect("physical");
    let cost = Quadratic::diagonal([1.0, 0.1], [0.1]).end(SMatrix::identity());
    let work = || {
        let mut ilqr = Ilqr::<_, _, 2, 1, 40>::new(0.02, cost).limits([-9.0], [9.0]);
        ilqr.solve(&model, 0.0, [1.0, 0.0]).expect("a motion");
        ilqr.shift();
        ilqr.pass(&model, 0.02, [0.9, -0.1]).expect("a motion");
        let error = ilqr.limits([9.0], [-9.0]).pass(&model, 0.0, [1.0, 0.0]);
        error.expect_err("reversed");
        let sampled = Sampled::new(ilqr.controller(model).expect("in range"), 0.02);
        let end = sampled.end(&Vern7::new(), &model, 0.0, 1.0, [1.0, 0.0]);
        assert!(end.expect("a motion").norm() < 1.0);
    };
    assert_eq!(allocations(work), 0);
}

mechanism! {
    /// A block on a floor with dry friction, that may bounce back from a stop.
    pub Block {
        input push: N,
        body block on ground {
            mass: 1, joint: prismatic(x), coordinate: s,
            torque: push, dry_friction: 2, stop: [-1, 0.6] restitution(0.3),
        }
    }
}

#[test]
fn iterative_lqr_through_mode_switches_does_not_allocate() {
    let model = Integrated::new(Block::new(BlockParams {}).expect("physical"), Tsit5::new());
    let cost = Quadratic::diagonal([1.0, 0.0], [0.01]).goal([0.5, 0.0], [0.0]);
    let work = || {
        let mut ilqr = Ilqr::<_, _, 2, 1, 40>::new(0.05, cost)
            .limits([-9.0], [9.0])
            .start([3.0]);
        for _ in 0..10 {
            ilqr.pass(&model, 0.0, [0.0, 0.0]).expect("a motion");
        }
        assert!((ilqr.end()[0] - 0.5).abs() < 0.1);
        ilqr.pass(&model, 0.0, [1.0, 0.0]).expect_err("beyond its limit");
    };
    assert_eq!(allocations(work), 0);
}

#[test]
fn errors_of_a_stepper_do_not_allocate() {
    fn check<F: OneStep<DoublePendulum, f64, 4> + Estimates + Default>(promise: &Promise) {
        let (model, method) = (double_pendulum(0.0), Adaptive::<F>::new().max_steps(10));
        let fail = || {
            let mut stepper = method.stepper(&model, 0.0, 50.0, START).expect("valid");
            let reason = stepper.run().expect_err("a long time");
            assert_eq!(reason, Reason::TooManySteps { max_steps: 10 }, "{promise:?}");
        };
        assert_eq!(allocations(fail), 0);
    }
    testbed::each_adaptive!(check);
}

//! Closed loops without a closed form: dependent positions in the state, integrated from their rates.

use nalgebra::SVector;
use pendulum_core::prelude::*;
use pendulum_core::stability::{Lyapunov, equilibrium};
use pendulum_core::{Reason, SlotKind};

mechanism! {
    /// Three rods hold a plate, one of them on a crank.
    pub Plate {
        gravity: [0, -9.81, 0],
        body crank on ground { solids: [rod(0.5, [0, 0, 0], [0.15, 0, 0])], joint: revolute(z),
            coordinate: theta near 0.8 }
        body rod on crank {
            solids: [rod(0.3, [0, 0, 0], [0.4, 0, 0])], joint: revolute(z) at [0.15, 0, 0],
                coordinate: alpha depends near 0.2,
        }
        body left on ground {
            solids: [rod(0.4, [0, 0, 0], [0.5, 0, 0])], joint: revolute(z) at [-0.45, 0, 0],
                coordinate: beta depends near 1.8,
        }
        body plate on left {
            solids: [rod(1, [0, 0, 0], [1.45, -0.04, 0])], joint: revolute(z) at [0.5, 0, 0],
                coordinate: gamma depends near -1.7,
        }
        body right on ground {
            solids: [rod(0.9, [0, 0, 0], [0.5, 0, 0])], joint: revolute(z) at [0.7, 0.1, 0],
                coordinate: delta depends near 1.4,
        }
        close plate at [0.95, -0.15, 0] to rod at [0.4, 0, 0]: revolute(z),
        close plate at [1.45, -0.04, 0] to right at [0.5, 0, 0]: revolute(z),
        point p on plate at [0.95, -0.15, 0], point o on rod at [0.4, 0, 0],
        point r on plate at [1.45, -0.04, 0], point s on right at [0.5, 0, 0],
        output gaps: [p.x - o.x, p.y - o.y, r.x - s.x, r.y - s.y],
        output margin: margin(plate, rod),
        output rates: [dot(alpha), dot(delta)],
        generate: [rhs, jacobian, energy, taylor],
    }
}

mechanism! {
    /// Two cranks about axes at an angle, and a rod between ball joints, one of which is a yoke.
    pub Spatial {
        params { length: m = 0.815 }
        gravity: [0, 1, -9.81],
        body crank on ground { solids: [disk(40, 0.15, [0, 0, 0]), rod(0.5, [0, 0, 0], [0.06, 0, 0.02])],
            joint: revolute(z), coordinate: theta near 0.8 }
        body yoke on crank { mass: 0.1, inertia: [0.001, 0.002, 0.002], joint: revolute(z) at [0.06, 0, 0.02],
            coordinate: alpha depends near -0.5 }
        body rod on yoke { mass: 0.4, com: [0.4, 0, 0], inertia: [0.001, 0.01, 0.01], joint: revolute(y),
            coordinate: beta depends near -0.6 }
        body rocker on ground {
            mass: 0.9, com: [0, 0.3, 0.1], inertia: [0.02, 0.01, 0.01],
            joint: revolute([1, 0, 0.02]) at [0.4, 0, 0.1], coordinate: gamma depends near 0.7, spring: (2, 0.4),
        }
        close rod at [length, 0, 0] to rocker at [0, 0.7, 0.1]: ball,
        point p on rod at [length, 0, 0], point r on rocker at [0, 0.7, 0.1],
        output gaps: [p.x - r.x, p.y - r.y, p.z - r.z],
        output margin: margin(rod, rocker),
        event flat: margin(rod, rocker) - 0.01,
        generate: [rhs, jacobian, energy, taylor],
    }
}

mechanism! {
    /// Bennett's linkage: four hinges in space that can move, since two of their five closing equations are redundant.
    pub Bennett {
        params { l: m = 1, skew: rad = 0.4, other: rad = 0.8928089789005025 }
        gravity: [0, 1, -9.81],
        body first on ground {
            solids: [rod(0.5, [0, 0, 0], [0.4, 0, 0])], joint: revolute(z) at [0.8, 0, 0] rpy [other, 0, 0],
                coordinate: theta near 2,
        }
        body second on first {
            solids: [rod(0.7, [0, 0, 0], [0.8, 0, 0])], joint: revolute(z) at [0.4, 0, 0] rpy [skew, 0, 0],
                coordinate: phi depends near 2,
        }
        body third on second {
            solids: [rod(0.5, [0, 0, 0], [0.4, 0, 0])], joint: revolute(z) at [0.8, 0, 0] rpy [other, 0, 0],
                coordinate: psi depends near -2,
        }
        close third at [0.4, 0, 0] rpy [skew, 0, 0] to ground: revolute(z),
        point p on third at [0.4, 0, 0], point r on third at [0.4, -l*sin(skew), l*cos(skew)],
        output gaps: [p.x, p.y, p.z, r.x, r.y],
        output along: r.z,
        output margin: margin(third, ground),
        generate: [rhs, jacobian, energy, loop_wrenches, taylor],
    }
}

mechanism! {
    /// The bodies of `Bennett` without the last hinge: a force at its place, and a moment as couples in the frame of
    /// the body.
    pub Cut {
        params { skew: rad = 0.4, other: rad = 0.8928089789005025 }
        input fx: N, input fy: N, input fz: N, input mx: N m, input my: N m, input mz: N m,
        gravity: [0, 1, -9.81],
        body first on ground {
            solids: [rod(0.5, [0, 0, 0], [0.4, 0, 0])], joint: revolute(z) at [0.8, 0, 0] rpy [other, 0, 0],
                coordinate: theta,
        }
        body second on first {
            solids: [rod(0.7, [0, 0, 0], [0.8, 0, 0])], joint: revolute(z) at [0.4, 0, 0] rpy [skew, 0, 0],
                coordinate: phi,
        }
        body third on second {
            solids: [rod(0.5, [0, 0, 0], [0.4, 0, 0])], joint: revolute(z) at [0.8, 0, 0] rpy [other, 0, 0],
                coordinate: psi,
        }
        point p on third at [0.4, 0, 0],
        point xp on third at [0.9, 0, 0], point xm on third at [-0.1, 0, 0],
        point yp on third at [0.4, 0.5, 0], point ym on third at [0.4, -0.5, 0],
        point zp on third at [0.4, 0, 0.5], point zm on third at [0.4, 0, -0.5],
        force on p: [fx, fy, fz],
        force on xp: [0, mz/1 m, 0] in third, force on xm: [0, -mz/1 m, 0] in third,
        force on yp: [0, 0, mx/1 m] in third, force on ym: [0, 0, -mx/1 m] in third,
        force on zp: [my/1 m, 0, 0] in third, force on zm: [-my/1 m, 0, 0] in third,
        output turned: rotation(third),
    }
}

fn plate() -> Plate {
    Plate::new(PlateParams {}).expect("the parameters are physical")
}

/// Checks energy and closure along motions by methods of every kind.
macro_rules! moves {
    ($($test:ident: $model:ident of $n:literal, from $start:expr, for $time:expr, within $margin:expr;)*) => {$(
        #[test]
        fn $test() {
            let model = $model::new(Default::default()).expect("the parameters are physical");
            let start = model.assemble(0.0, $start).expect("it closes");
            assert!(model.gaps(0.0, &start).amax() < 4e-16, "{}", model.gaps(0.0, &start));
            let energy = model.energy(0.0, &start);
            let end = Vern9::new().rtol(1e-13).atol(1e-13).solve(&model, 0.0, $time, start).expect("it moves").end();
            let mut least: f64 = 1.0;
            let mut check = |solution: &pendulum_core::Solution<f64, $n>, tolerance: f64| {
                for (t, x) in solution.points() {
                    assert!(model.gaps(t, x).amax() < 5e-15, "{t}: {}", model.gaps(t, x));
                    let drift = (model.energy(t, x) - energy).abs();
                    assert!(drift < tolerance * energy.abs().max(1.0), "{t}: {drift:e}");
                    least = least.min(model.margin(t, x));
                }
                assert!((solution.end() - end).amax() < 1e3 * tolerance, "{}", solution.end() - end);
            };
            check(&Vern9::new().rtol(1e-11).atol(1e-11).solve(&model, 0.0, $time, start).expect("it moves"), 1e-10);
            check(&Tsit5::new().rtol(1e-10).atol(1e-10).solve(&model, 0.0, $time, start).expect("it moves"), 1e-8);
            check(&Rodas5P::new().rtol(1e-9).atol(1e-9).solve(&model, 0.0, $time, start).expect("it moves"), 1e-6);
            check(&Radau5::new().rtol(1e-9).atol(1e-9).solve(&model, 0.0, $time, start).expect("it moves"), 1e-6);
            check(&Taylor::new().rtol(1e-13).atol(1e-13).solve(&model, 0.0, $time, start).expect("it moves"), 1e-11);
            check(&Rk4::new(5e-4).solve(&model, 0.0, $time, start).expect("it moves"), 1e-6);
            assert!($margin.contains(&least), "{least}");
        }
    )*};
}

moves! {
    the_plate_moves: Plate of 6, from [0.8, 0.2, 1.8, -1.7, 1.4, 0.5], for 1.0, within 0.05..0.15;
    the_rod_in_space_moves: Spatial of 5, from [0.8, 0.1, -0.7, 0.6, 6.0], for 2.0, within 0.05..0.12;
    bennett_moves: Bennett of 4, from [2.0, 2.0, -2.0, 1.0], for 2.0, within 0.01..0.99;
}

/// The Jacobian of the equations against differences. Off the constraint as well, where no equation is redundant.
#[test]
fn jacobians() {
    fn check<M: Jacobian<f64, N> + System<f64, N>, const N: usize>(model: &M, x: SVector<f64, N>) {
        let ours = model.jacobian(0.0, &x);
        let differences = pendulum_core::system::Differences(model).jacobian(0.0, &x);
        let size = ours.amax();
        assert!((ours - differences).amax() < 1e-7 * size, "{ours}{differences}");
    }
    check(&plate(), SVector::from([0.8, 0.2, 1.8, -1.7, 1.4, 0.5]));
    let spatial = Spatial::new(SpatialParams::default()).expect("the parameters are physical");
    check(&spatial, SVector::from([0.8, 0.1, -0.7, 0.6, 3.0]));
    let bennett = Bennett::new(BennettParams::default()).expect("the parameters are physical");
    check(
        &bennett,
        bennett.assemble(0.0, [2.0, 2.0, -2.0, 1.0]).expect("it closes"),
    );
}

#[test]
fn the_state_holds_what_follows_behind() {
    let names = "theta alpha beta gamma delta dot(theta)";
    assert_eq!(Plate::LAYOUT.components().join(" "), names);
    assert_eq!((Plate::DOF, Plate::DELTA, Plate::DOT_THETA), (1, 4, 5));
    assert!(
        Plate::LAYOUT
            .slots
            .iter()
            .all(|slot| slot.kind == SlotKind::Angle && slot.periodic)
    );
    let model = plate();
    let x = model.assemble(0.0, [0.8, 0.2, 1.8, -1.7, 1.4, 0.5]).expect("it closes");
    let rates = model.rhs(0.0, &x);
    assert_eq!(model.rates(0.0, &x).as_slice(), [rates[1], rates[4]]);
}

/// A guess that closes nothing, lengths out of reach, and a state with an open loop.
#[test]
fn what_does_not_close_is_refused() {
    let short = Spatial::new(SpatialParams { length: 0.1 }).expect("the parameters are physical");
    let error = short
        .assemble(0.0, [0.8, 0.1, -0.7, 0.6, 3.0])
        .expect_err("it is too short");
    assert!(
        error.to_string().starts_with("the loops do not close near this state"),
        "{error}"
    );
    let open = Vern9::new()
        .solve(&plate(), 0.0, 1.0, [0.8, 0.2, 1.8, -1.7, 1.4, 0.5])
        .expect_err("it is open");
    assert!(open.to_string().contains("as `assemble` returns"), "{open}");
}

/// The motion ends at a singularity (toggle), and jumps to no other assembly.
#[test]
fn a_motion_ends_at_a_toggle() {
    let model = Spatial::new(SpatialParams { length: 0.88 }).expect("the parameters are physical");
    let start = model.assemble(0.0, [3.0, -2.07, 0.29, -0.6, 6.0]).expect("it closes");
    let flat = model.flat_event().terminal();
    let ended = Vern9::new()
        .solve_with(&model, 0.0, 5.0, start, &[flat])
        .expect("the event ends it");
    let (t, x) = ended.last();
    assert!(
        (model.margin(t, &x) - 0.01).abs() < 1e-12,
        "{t} {}",
        model.margin(t, &x)
    );
    for method in [Vern9::new().rtol(1e-6).atol(1e-6), Vern9::new().rtol(1e-10).atol(1e-10)] {
        let error = method
            .max_steps(10_000)
            .solve(&model, 0.0, 5.0, start)
            .expect_err("it comes to its toggle");
        let told = matches!(
            error.reason,
            Reason::Toggle { bodies, .. } if bodies == ["rod", "rocker"]
        );
        assert!(told, "{error}");
        let (t, x) = error.solution.last();
        let left = model.margin(t, &x);
        assert!(
            (1e-3..0.01).contains(&left) && model.gaps(t, &x).amax() < 1e-14,
            "stopped {left:e} before the toggle: {error}"
        );
    }
    for h in [0.1, 0.01] {
        let error = Rk4::new(h)
            .solve(&model, 0.0, 5.0, start)
            .expect_err("a step passes it");
        assert!(matches!(error.reason, Reason::Toggle { .. }), "{error}");
    }
}

/// States of rest and their modes, against the energies along the free coordinate.
#[test]
fn coupled_loops_come_to_rest() {
    const STEP: f64 = 1e-3;
    let model = plate();
    let start = model.assemble(0.0, [0.8, 0.2, 1.8, -1.7, 1.4, 0.0]).expect("it closes");
    let found = equilibrium(&model, start).expect("it hangs somewhere");
    let at_rest = found.x;
    assert!(model.rhs(0.0, &at_rest).amax() < 1e-12 && model.gaps(0.0, &at_rest).amax() < 1e-15);
    let moved = |by: f64| {
        let mut x = at_rest;
        x[Plate::THETA] += by;
        model.assemble(0.0, x).expect("it is near")
    };
    let potential = |by: f64| model.potential(0.0, &moved(by));
    let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|n| potential(n * STEP));
    let stiffness = (16.0 * (b + d) - a - e - 30.0 * c) / (12.0 * STEP * STEP);
    let mut unit = at_rest;
    unit[Plate::DOT_THETA] = 1.0;
    let inertia = 2.0 * model.kinetic(0.0, &unit);
    let [first, second] = found.spectrum.modes() else {
        panic!("two modes of one degree of freedom")
    };
    let squares = [first, second].map(|mode| mode.eigenvalue * mode.eigenvalue);
    for square in squares {
        assert!(
            (square.re * inertia / -stiffness - 1.0).abs() < 1e-7,
            "{square} {stiffness} {inertia}"
        );
    }
    // the shape includes dependent coordinates
    let by = moved(STEP) - moved(-STEP);
    let along = first.shape / first.shape[Plate::THETA];
    for n in 1..5 {
        let expected = by[n] / (2.0 * STEP);
        assert!((along[n].re - expected).abs() < 1e-5, "{n}: {} {expected}", along[n]);
    }
}

/// Exponents along the loop only: their sum is the loss rate of a friction on the crank.
#[test]
fn exponents_keep_to_the_loop() {
    let model = plate();
    let start = model.assemble(0.0, [0.8, 0.2, 1.8, -1.7, 1.4, 3.0]).expect("it closes");
    let lyapunov = Lyapunov::new().duration(20.0);
    let exponents = lyapunov.exponents::<2, 6>(&model, start).expect("it moves");
    let sum: f64 = exponents.values.iter().sum();
    // the flow preserves volumes of coordinates and momenta, and momenta are rates times a bounded factor
    assert!(sum.abs() < 0.2, "{:?}", exponents.values);
    assert!(lyapunov.exponents::<3, 6>(&model, start).is_err());
}

/// Lanes take the same steps as single trajectories, bit for bit.
#[test]
fn lanes_close_the_same_loops() {
    let model = plate();
    let starts: Vec<SVector<f64, 6>> = (0..5)
        .map(|n| {
            let rate = 0.3 * f64::from(n);
            model
                .assemble(0.0, [0.8, 0.2, 1.8, -1.7, 1.4, rate])
                .expect("it closes")
        })
        .collect();
    let method = Tsit5::new().rtol(1e-8).atol(1e-8);
    let ends = method.ensemble(&[model], 0.0, 1.0, &starts).expect("they move");
    for (start, end) in starts.iter().zip(ends) {
        let alone = method.solve(&model, 0.0, 1.0, *start).expect("it moves").end();
        assert_eq!(alone, end);
        assert!(model.gaps(1.0, &end).amax() < 5e-15);
    }
}

/// The wrench of the last hinge, applied in its place, moves the open chain like the closed one.
#[test]
fn wrenches_hold_the_loop() {
    let closed = Bennett::new(BennettParams::default()).expect("the parameters are physical");
    let cut = Cut::new(CutParams::default()).expect("the parameters are physical");
    let x = closed.assemble(0.3, [2.0, 2.0, -2.0, 1.5]).expect("it closes");
    let (rates, jacobian) = closed.rhs_and_jacobian(0.3, &x);
    let seconds = jacobian * rates;
    let wrench = -closed.loop_wrenches(0.3, &x).column(0);
    let state = SVector::from([x[0], x[1], x[2], rates[0], rates[1], rates[2]]);
    let force = wrench.fixed_rows::<3>(3);
    assert!(force.norm() > 1.0 && wrench.fixed_rows::<3>(0).norm() > 0.1, "{wrench}");
    let moment = cut.turned(0.3, &state).transpose() * wrench.fixed_rows::<3>(0);
    let inputs = CutInputs {
        fx: force[0],
        fy: force[1],
        fz: force[2],
        mx: moment[0],
        my: moment[1],
        mz: moment[2],
    };
    let moved = cut.eval(0.3, &state, &inputs);
    for (k, expected) in [rates[3], seconds[1], seconds[2]].into_iter().enumerate() {
        assert!(
            (moved[3 + k] - expected).abs() < 1e-12 * seconds.amax(),
            "{moved} beside {seconds}"
        );
    }
}

mechanism! {
    /// The wheels of a locomotive, as two rods that turn with the first: one holds the beam, the other is redundant.
    pub Coupled {
        gravity: [0, -9.81, 0],
        body left on ground { solids: [rod(1, [0, 0, 0], [0, 1, 0])], joint: revolute(z), coordinate: alpha near 0.3 }
        body beam on left {
            solids: [rod(1, [0, 0, 0], [2, 0, 0])], joint: revolute(z) at [0, 1, 0], coordinate: beta depends near -0.3,
        }
        body right on ground {
            solids: [rod(1, [0, 0, 0], [0, 1, 0])], joint: revolute(z) at [2, 0, 0], coordinate: p depends near 0.3,
        }
        body middle on ground {
            solids: [rod(0.7, [0, 0, 0], [0, 1, 0])], joint: revolute(z) at [0.8, 0, 0], coordinate: m depends near 0.3,
        }
        close beam at [2, 0, 0] to right at [0, 1, 0]: revolute(z),
        close beam at [0.8, 0, 0] to middle at [0, 1, 0]: revolute(z),
    }
}

mechanism! {
    /// `Coupled` with a middle rod that follows directly, without a loop.
    pub Following {
        gravity: [0, -9.81, 0],
        body left on ground { solids: [rod(1, [0, 0, 0], [0, 1, 0])], joint: revolute(z), coordinate: alpha near 0.3 }
        body beam on left {
            solids: [rod(1, [0, 0, 0], [2, 0, 0])], joint: revolute(z) at [0, 1, 0], coordinate: beta depends near -0.3,
        }
        body right on ground {
            solids: [rod(1, [0, 0, 0], [0, 1, 0])], joint: revolute(z) at [2, 0, 0], coordinate: p depends near 0.3,
        }
        body middle on ground {
            solids: [rod(0.7, [0, 0, 0], [0, 1, 0])], joint: revolute(z) at [0.8, 0, 0], motion: alpha,
        }
        close beam at [2, 0, 0] to right at [0, 1, 0]: revolute(z),
    }
}

/// A loop that repeats the constraint of another one is no error.
#[test]
fn a_loop_may_add_nothing() {
    let coupled = Coupled::new(CoupledParams::default()).expect("the parameters are physical");
    let following = Following::new(FollowingParams::default()).expect("the parameters are physical");
    for (alpha, rate) in [(0.3, 1.0), (-0.7, -4.0), (1.2, 0.0)] {
        let mut x = SVector::from([0.0; Coupled::LAYOUT.slots.len() + 1]);
        (x[Coupled::ALPHA], x[Coupled::M], x[Coupled::DOT_ALPHA]) = (alpha, alpha, rate);
        let ours = coupled.rhs(0.0, &x);
        let theirs = following.rhs(0.0, &[alpha, rate].into());
        assert!((ours[Coupled::DOT_ALPHA] - theirs[1]).abs() < 1e-12, "{ours} {theirs}");
        assert!((ours[Coupled::M] - rate).abs() < 1e-13, "{ours}");
    }
}

//! Initial conditions: closed loops must be closed, with the declared orientations.

use pendulum_core::prelude::*;
use pendulum_core::stability::{StabilityError, equilibrium};
use pendulum_core::{EnsembleError, LoopGap, Name, Reason};

use crate::coupled_loops::{Bennett, BennettParams};

mechanism! {
    /// A parallelogram with a third, redundant crank: four equations for three coordinates.
    pub Par {
        params { l: m = 0.5, d: m = 0.8, e: m = 0.4, f: m = 0.5 }
        gravity: [0, -9.81, 0],
        body a on ground { solids: [rod(1, [0, 0, 0], [l, 0, 0])], joint: revolute(z), coordinate: th near 0.5 }
        body b on a {
            solids: [rod(1, [0, 0, 0], [d, 0, 0])], joint: revolute(z) at [l, 0, 0], coordinate: ph depends near -0.5,
        }
        body c on ground {
            solids: [rod(1, [0, 0, 0], [l, 0, 0])], joint: revolute(z) at [d, 0, 0], coordinate: ps depends near 0.5,
        }
        body k on ground {
            solids: [rod(1, [0, 0, 0], [f, 0, 0])], joint: revolute(z) at [e, 0, 0], coordinate: ka depends near 0.5,
        }
        close b at [d, 0, 0] to c at [l, 0, 0]: revolute(z),
        close b at [e, 0, 0] to k at [f, 0, 0]: revolute(z),
        point o on b at [e, 0, 0], point p on k at [f, 0, 0],
        output apart: [o.x - p.x, o.y - p.y],
    }
}

mechanism! {
    /// Two bodies that turn about one point, welded.
    pub Weld3 {
        gravity: [0, 0, -9.81],
        body a on ground { mass: 1, com: [0, 0.1, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(x), coordinate: th }
        body u on ground { joint: revolute(z), coordinate: cz depends near 0.1 }
        body v on u { joint: revolute(y), coordinate: cy depends near 0.1 }
        body w on v {
            mass: 1, com: [0, 0.1, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(x), coordinate: cx depends near 0.1,
        }
        close a at [0, 0, 0] to w at [0, 0, 0]: fixed,
        output of_a: rotation(a),
        output of_w: rotation(w),
    }
}

/// Gap of the loop that rejects an initial condition.
fn gap(reason: Reason) -> LoopGap {
    match reason {
        Reason::Open(gap) => gap,
        other => panic!("{other}"),
    }
}

fn bennett(other: f64) -> Bennett {
    let params = BennettParams {
        other,
        ..BennettParams::default()
    };
    Bennett::new(params).expect("the parameters are physical")
}

/// Newton's method converges to the least sum of squares of contradictory equations.
#[test]
fn a_loop_whose_equations_contradict_each_other_is_open() {
    let model = bennett(1.2);
    let error = model.assemble(0.0, [2.0, 2.0, -2.0, 1.0]).expect_err("it is open");
    let open = error.open.expect("a gap");
    assert_eq!(open.bodies, ["third", "ground"]);
    assert!(open.unit == "m" && (0.05..0.12).contains(&open.by), "{error}");
    let text = error.to_string();
    let start = "the loops do not close near this state: the loop between `third` and `ground` is open by ";
    assert!(text.starts_with(start), "{text}");
    // open by less than a tenth of a millimetre
    let error = bennett(0.893)
        .assemble(0.0, [2.0, 2.0, -2.0, 1.0])
        .expect_err("it is open");
    let open = error.open.expect("a gap");
    assert!((1e-5..1e-3).contains(&open.by), "{error}");
    // closed once its lengths agree
    let model = bennett(BennettParams::default().other);
    model.assemble(0.0, [2.0, 2.0, -2.0, 1.0]).expect("it closes");
}

/// A parallelogram whose third crank does not fit, in a state where the corrections vanish.
fn open() -> (Par, SVector<f64, 3>) {
    let params = ParParams {
        f: 0.6,
        ..ParParams::default()
    };
    let model = Par::new(params).expect("the parameters are physical");
    let mut x = SVector::from([0.5, 0.5, 1.0]);
    for _ in 0..200 {
        x[1] += 0.3 * model.loop_corrections(0.0, &x)[0];
    }
    assert!(model.loop_corrections(0.0, &x).amax() < 1e-6);
    (model, x)
}

/// Every motion begins on closed loops: a single one, those of an ensemble, and after a reset.
#[test]
fn every_motion_starts_closed() {
    let (model, x) = open();
    let reason = Vern9::new().solve(&model, 0.0, 1.0, x).expect_err("it is open").reason;
    assert_eq!(gap(reason).bodies, ["b", "k"]);
    assert!(reason.to_string().contains("close it by `assemble`"), "{reason}");
}

#[test]
fn every_trajectory_of_an_ensemble_starts_closed() {
    let (model, x) = open();
    let adaptive = Rk45::new().ensemble(&[model], 0.0, 1.0, &[x]).map(|_| ());
    let fixed = Rk4::new(0.01).ensemble(&[model], 0.0, 1.0, &[x]).map(|_| ());
    for error in [adaptive, fixed].map(|result| result.expect_err("it is open")) {
        match error {
            EnsembleError::Stopped { stopped, .. } => assert_eq!(gap(stopped[0].reason).bodies, ["b", "k"]),
            other => panic!("{other}"),
        }
    }
}

#[test]
fn a_search_for_rest_starts_closed() {
    let (model, x) = open();
    match equilibrium(&model, x).map(|_| ()).expect_err("it is open") {
        StabilityError::Integration(reason) => assert_eq!(gap(reason).bodies, ["b", "k"]),
        other => panic!("{other}"),
    }
}

/// A reset to the other assembly of the first loop, in which the second is open.
#[test]
fn a_reset_goes_on_closed() {
    let par = Par::new(ParParams::default()).expect("the parameters are physical");
    let start = par.assemble(0.0, [0.5, 0.5, 1.0]).expect("it closes");
    // a state where the corrections vanish
    let mut x = SVector::from([-0.3, -0.3, 1.0]);
    for _ in 0..200 {
        x[1] += 0.3 * par.loop_corrections(0.0, &x)[0];
    }
    let crossed = Event::new(|t: f64, _: &SVector<f64, 3>| t - 0.01).reset(move |_, _| x);
    let error = Rk45::new()
        .solve_with(&par, 0.0, 1.0, start, &[crossed])
        .expect_err("the reset opens it");
    assert_eq!(gap(error.reason).bodies, ["b", "k"]);
}

/// A crank that is too long for its place, and a parallelogram that has turned over.
#[test]
fn a_redundant_crank_must_fit() {
    let long = Par::new(ParParams {
        f: 0.6,
        ..ParParams::default()
    })
    .expect("the parameters are physical");
    let error = long.assemble(0.0, [0.5, 0.5, 1.0]).expect_err("it is open");
    let open = error.open.expect("a gap");
    assert_eq!(open.bodies, ["b", "k"]);
    assert!((open.by - 0.1).abs() < 0.01, "{error}");

    let model = Par::new(ParParams::default()).expect("the parameters are physical");
    let error = model
        .assemble(0.0, [-0.3, -0.3, 1.0])
        .expect_err("the first loop is crossed");
    assert!((error.open.expect("a gap").by - 0.127).abs() < 0.01, "{error}");
    for n in 1..30 {
        let th = 0.1 * f64::from(n);
        let x = model.assemble(0.0, [th, th + 0.2, 1.0]).expect("the loops agree");
        assert!(model.apart(0.0, &x).amax() < 1e-15, "{}", model.apart(0.0, &x).amax());
        Vern9::new().solve(&model, 0.0, 0.01, x).expect("it starts");
    }
}

/// The equations of a weld also vanish half a turn off, and a third of a turn about the diagonal.
#[test]
fn a_weld_keeps_the_declared_orientation() {
    let model = Weld3::new(Weld3Params {}).expect("the parameters are physical");
    let error = model
        .assemble(0.0, [0.0, 0.8, 0.3, 0.8, 1.0])
        .expect_err("it is a third of a turn off");
    let open = error.open.expect("a gap");
    assert_eq!((open.bodies, open.unit), (["a", "w"].map(Name::from), "rad"));
    assert!((open.by - std::f64::consts::TAU / 3.0).abs() < 1e-6, "{error}");
    let reason = Vern9::new()
        .solve(
            &model,
            0.0,
            1.0,
            [0.0, std::f64::consts::FRAC_PI_2, 0.0, std::f64::consts::FRAC_PI_2, 1.0],
        )
        .expect_err("so is the start")
        .reason;
    assert_eq!(gap(reason).unit, "rad", "{reason}");
    let off = [
        [0.0, std::f64::consts::PI, 0.0, 0.0],
        [0.3, 0.0, std::f64::consts::PI, 0.3],
        [0.3, 0.0, 0.0, 0.3 + std::f64::consts::PI],
        [0.0, std::f64::consts::FRAC_PI_2, 0.0, std::f64::consts::FRAC_PI_2],
    ];
    for [th, cz, cy, cx] in off {
        let x = [th, cz, cy, cx, 1.0];
        model.assemble(0.0, x).expect_err("it is turned");
        Vern9::new().solve(&model, 0.0, 1.0, x).expect_err("it is turned");
    }
    for n in 0..40 {
        let th = 0.3 * f64::from(n);
        let x = model.assemble(0.0, [th, 0.3, -0.2, th + 0.3, 1.0]).expect("it closes");
        let apart = model.of_a(0.0, &x) - model.of_w(0.0, &x);
        assert!(apart.amax() < 1e-12, "{apart}");
        Vern9::new().solve(&model, 0.0, 0.1, x).expect("it moves");
    }
}

/// An initial condition closed to three digits is closed to all digits, also in single precision and after many turns.
#[test]
fn a_start_may_be_off_by_rounding() {
    let model = bennett(BennettParams::default().other);
    let closed = model.assemble(0.0, [2.0, 2.0, -2.0, 1.0]).expect("it closes");
    for by in [1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 9e-4] {
        for off in [[by, by], [by, -by], [-by, 0.0]] {
            let x = SVector::from([closed[0], closed[1] + off[0], closed[2] + off[1], closed[3]]);
            let solution = Vern9::new().solve(&model, 0.0, 0.1, x).expect("it starts");
            let start = solution.points().next().expect("the start").1;
            assert!(model.gaps(0.0, start).amax() < 1e-14, "{by}");
        }
    }
    let turns = 1e4 * std::f64::consts::TAU;
    let far = model
        .assemble(0.0, [2.0 + turns, 2.0 - turns, turns - 2.0, 1.0])
        .expect("it closes");
    Vern9::new().solve(&model, 0.0, 0.1, far).expect("it starts");
    let single = model.cast::<f32>();
    let x = single.assemble(0.0, [2.0, 2.0, -2.0, 1.0]).expect("it closes");
    Vern9::new()
        .rtol(1e-5)
        .atol(1e-5)
        .solve(&single, 0.0, 0.1, x)
        .expect("it starts");
    bennett(1.2)
        .cast::<f32>()
        .assemble(0.0, [2.0, 2.0, -2.0, 1.0])
        .expect_err("it is open");
}

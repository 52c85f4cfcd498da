//! Dependent angles of closed loops count their turns: springs, potentials and torques on them conserve energy.

use std::f64::consts::TAU;

use pendulum_core::Reason;
use pendulum_core::prelude::*;

mechanism! {
    /// A crank that turns all the way, with a spring at the coupler.
    pub Motor {
        params { k: N m = 1 }
        gravity: [0, -9.81, 0],
        body crank on ground { mass: 1, inertia: 0.01, joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank {
            solids: [rod(1, [0, 0, 0], [0.5, 0, 0])], joint: revolute(z) at [0.2, 0, 0],
            coordinate: phi depends near -0.3, spring: (k, 0),
        }
        body rocker on ground {
            solids: [rod(1, [0, 0, 0], [0.4, 0, 0])], joint: revolute(z) at [0.6, 0, 0],
                coordinate: psi depends near 1.6,
        }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        output phi: phi,
        generate: [rhs, jacobian, energy, taylor],
    }
}

mechanism! {
    /// Two intersecting circles, of any lengths.
    pub Bars {
        params { a: m = 0.2, b: m = 0.5, c: m = 0.4, d: m = 0.6, k: N m = 1, rest: rad = 0 }
        gravity: [0, -9.81, 0],
        body crank on ground { mass: 1, inertia: 0.01, joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank {
            solids: [rod(1, [0, 0, 0], [b, 0, 0])], joint: revolute(z) at [a, 0, 0], coordinate: phi depends near -0.3,
        }
        body rocker on ground {
            solids: [rod(1, [0, 0, 0], [c, 0, 0])], joint: revolute(z) at [d, 0, 0], coordinate: psi depends near 1.6,
            torque: -k*(q - rest),
        }
        close coupler at [b, 0, 0] to rocker at [c, 0, 0]: revolute(z),
        point o on coupler at [b, 0, 0], point p on rocker at [c, 0, 0],
        output apart: [o.x - p.x, o.y - p.y],
        let bend = phi + 2*psi,
        output bend: bend,
        output angles: [phi, psi],
        output rates: [dot(phi), dot(psi)],
        output stored: k*(psi - rest)^2/2,
        potential: k*bend^2/8,
        generate: [rhs, jacobian, energy],
    }
}

mechanism! {
    /// The loop of `Motor`, closed by a weld to a pin: not a triangle.
    pub Welded {
        params { a: m = 0.2, k: N m = 1 }
        gravity: [0, -9.81, 0],
        body crank on ground { mass: 1, inertia: 0.01, joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank {
            solids: [rod(1, [0, 0, 0], [0.5, 0, 0])], joint: revolute(z) at [a, 0, 0],
            coordinate: phi depends near -0.3, spring: (k, 0),
        }
        body rocker on ground {
            solids: [rod(1, [0, 0, 0], [0.4, 0, 0])], joint: revolute(z) at [0.6, 0, 0],
                coordinate: psi depends near 1.6,
        }
        body pin on rocker { joint: revolute(z) at [0.4, 0, 0], coordinate: chi depends near -1.1 }
        close coupler at [0.5, 0, 0] to pin at [0, 0, 0]: fixed,
    }
}

mechanism! {
    /// A rod that slides through a rotating block, and a crank that slides in a slot.
    pub Slots {
        params { a: m = 0.2, d: m = 0.5, k: N m = 1 }
        gravity: [0, -9.81, 0],
        body crank on ground { mass: 1, inertia: 0.01, joint: revolute(z), coordinate: theta near 0.8 }
        body lever on ground { solids: [rod(1, [0, 0, 0], [0.4, 0, 0])], joint: revolute(z) at [-d, 0, 0],
            coordinate: psi depends near 0.3, spring: (k, 0) }
        body block on lever { mass: 0.1, joint: prismatic(x), coordinate: s depends near 0.6 }
        close block at [0, 0.05, 0] to crank at [a, 0, 0]: revolute(z),
        point o on block at [0, 0.05, 0], point p on crank at [a, 0, 0],
        output apart: [o.x - p.x, o.y - p.y],
        output lever: psi,
        output rate: dot(psi),
    }
}

mechanism! {
    /// A slider at the end of a rod, above the line of the crank.
    pub Slider {
        gravity: [0, -9.81, 0],
        body crank on ground { mass: 1, inertia: 0.01, joint: revolute(z), coordinate: theta near 0.8 }
        body rod on crank { solids: [rod(1, [0, 0, 0], [0.5, 0, 0])], joint: revolute(z) at [0.2, 0, 0],
            coordinate: phi depends near -0.8, spring: (0.3, 0) }
        body piston on ground { mass: 1, joint: prismatic(x) at [0, 0.1, 0], coordinate: s depends near 0.6 }
        close rod at [0.5, 0, 0] to piston at [0, 0, 0]: revolute(z),
        output rod: phi,
    }
}

mechanism! {
    /// A dyad on the coupler of a four-bar: either the third vector of its triangle leads, or none does.
    pub SixBar {
        params { far: m = 1.5, high: m = 0, long: m = 0.9, k: N m = 0.5 }
        gravity: [0, -9.81, 0],
        body crank on ground { mass: 1, inertia: 0.01, joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank { solids: [rod(1, [0, 0, 0], [0.5, 0, 0])], joint: revolute(z) at [0.2, 0, 0],
            coordinate: phi depends near -0.3 }
        body rocker on ground { solids: [rod(1, [0, 0, 0], [0.4, 0, 0])], joint: revolute(z) at [0.6, 0, 0],
            coordinate: psi depends near 1.6 }
        body arm on coupler { solids: [rod(0.4, [0, 0, 0], [1, 0, 0])], joint: revolute(z) at [0.25, 0.1, 0],
            coordinate: chi depends near -0.6, spring: (k, 0) }
        body swing on ground { solids: [rod(0.4, [0, 0, 0], [long, 0, 0])], joint: revolute(z) at [far, high, 0],
            coordinate: omega depends near 1.9, spring: (k, 0) }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        close arm at [1, 0, 0] to swing at [long, 0, 0]: revolute(z),
        point o on coupler at [0.5, 0, 0], point p on rocker at [0.4, 0, 0],
        point e on arm at [1, 0, 0], point f on swing at [long, 0, 0],
        output apart: [o.x - p.x, o.y - p.y, e.x - f.x, e.y - f.y],
        output angles: [chi, omega],
        output rates: [dot(chi), dot(omega)],
    }
}

/// Checks the energy along a motion through `turns` turns of the first coordinate. A jump by one turn would change it.
macro_rules! conserves {
    ($model:expr, $start:expr, $turns:expr, $stored:expr) => {{
        let (model, start, stored) = ($model, SVector::from($start), $stored);
        let energy = |t: f64, x: &_| model.energy(t, x) + stored(&model, x);
        let before = energy(0.0, &start);
        let method = Tsit5::new().rtol(1e-9).atol(1e-9).max_steps(10_000_000);
        let mut stepper = method.stepper(&model, 0.0, 1e4, start).expect("it starts");
        while stepper.x()[0].abs() < $turns * TAU {
            let more = stepper.step().expect("it moves").is_some();
            let (t, x) = (stepper.t(), stepper.x());
            let drift = (energy(t, &x) - before).abs();
            assert!(drift < 1e-5 * before.abs().max(1.0), "{} turns: {drift:e}", x[0] / TAU);
            assert!(more, "{} turns", x[0] / TAU);
        }
        (stepper.t(), stepper.x())
    }};
}

fn nothing<M, X>(_: &M, _: &X) -> f64 {
    0.0
}

/// The motion of the bug report: 6.68 J became 3752 J in a minute.
#[test]
fn a_spring_winds_up_with_the_coupler() {
    let model = Motor::new(MotorParams::default()).expect("the parameters are physical");
    let energy = model.energy(0.0, &SVector::from([0.8, 12.0]));
    let solution = Vern9::new()
        .rtol(1e-10)
        .atol(1e-10)
        .solve(&model, 0.0, 60.0, [0.8, 12.0])
        .expect("it moves");
    for (t, x) in solution.points() {
        assert!(
            (model.energy(t, x) - energy).abs() < 1e-7 * energy,
            "{t}: {}",
            model.energy(t, x)
        );
    }
}

/// Springs, potentials, torques and `let` expressions, through a thousand turns.
#[test]
fn energy_is_conserved_through_a_thousand_turns() {
    let motor = Motor::new(MotorParams { k: 1e-8 }).expect("the parameters are physical");
    let (t, x) = conserves!(motor, [0.8, 12.0], 1000.0, nothing);
    assert!(
        motor.phi(t, &x) < -6000.0,
        "the coupler turns against the crank: {}",
        motor.phi(t, &x)
    );
}

#[test]
fn potentials_and_torques_wind_up() {
    // the ground is the longest bar in the first, and the shortest in the others, whose cranks turn all the way
    for (a, b, c, d) in [(0.2, 0.5, 0.4, 0.6), (0.5, 0.45, 0.4, 0.15), (0.4, 0.45, 0.5, 0.2)] {
        let params = BarsParams {
            a,
            b,
            c,
            d,
            k: 1e-5,
            rest: 0.0,
        };
        let bars = Bars::new(params).expect("the parameters are physical");
        conserves!(bars, [0.8, 14.0], 100.0, |bars: &Bars, x: &SVector<f64, 2>| bars
            .stored(0.0, x));
    }
}

#[test]
#[ignore = "takes long"]
fn loops_without_a_closed_form_wind_up() {
    let welded = Welded::new(WeldedParams { a: 0.2, k: 1e-8 }).expect("the parameters are physical");
    let start = welded.assemble(0.0, [0.8, -0.3, 1.6, -1.1, 12.0]).expect("it closes");
    let (_, x) = conserves!(welded, start, 1000.0, nothing);
    assert!(x[1] < -6000.0, "{x}");
    // the closed form counts the same turns
    let motor = Motor::new(MotorParams { k: 1e-8 }).expect("the parameters are physical");
    assert!((motor.phi(0.0, &SVector::from([x[0], x[4]])) - x[1]).abs() < 1e-9);
}

#[test]
fn slides_wind_up() {
    for (a, d) in [(0.2, 0.5), (0.5, 0.2)] {
        let slots = Slots::new(SlotsParams { a, d, k: 1e-8 }).expect("the parameters are physical");
        let (t, x) = conserves!(slots, [0.8, 14.0], 300.0, nothing);
        let turns = slots.lever(t, &x) / TAU;
        assert!((turns.abs() - if a > d { 300.0 } else { 0.0 }).abs() < 0.6, "{turns}");
    }
    let slider = Slider::new(SliderParams {}).expect("the parameters are physical");
    let (t, x) = conserves!(slider, [0.8, 1.0], 0.05, nothing);
    assert!(slider.rod(t, &x).abs() < TAU);
}

/// Along many turns of the crank an output changes by the integral of its rate, by Simpson's rule over each small step.
#[test]
fn outputs_are_continuous() {
    let follow = |outputs: &dyn Fn(f64) -> [[f64; 2]; 2], name: &str| {
        let step = 1e-2;
        let mut before = outputs(0.8);
        for n in 1..4000 {
            let theta = 0.8 + step * f64::from(n);
            let (middle, now) = (outputs(theta - step / 2.0), outputs(theta));
            for k in 0..2 {
                let way = step / 6.0 * (before[1][k] + 4.0 * middle[1][k] + now[1][k]);
                let moved = now[0][k] - before[0][k];
                assert!(
                    (moved - way).abs() < 1e-5,
                    "{name} {k} at {theta}: {moved} instead of {way}"
                );
            }
            before = now;
        }
        before[0]
    };
    // first the crank is shortest, then the ground; lengths are parameters and decide which vector leads
    for ([a, b, c, d], turns) in [
        ([0.2, 0.5, 0.4, 0.6], [-1.0, 0.0]),
        ([0.5, 0.45, 0.4, 0.15], [0.0, 1.0]),
    ] {
        let bars = Bars::new(BarsParams {
            a,
            b,
            c,
            d,
            ..BarsParams::default()
        })
        .expect("the parameters are physical");
        let outputs = |theta| {
            let x = SVector::from([theta, 1.0]);
            [bars.angles(0.0, &x), bars.rates(0.0, &x)].map(Into::into)
        };
        let ([end, start], turned) = ([follow(&outputs, "bars"), outputs(0.8)[0]], 39.99 / TAU);
        for k in 0..2 {
            let made = (end[k] - start[k]) / TAU;
            assert!((made - turns[k] * turned).abs() < 0.7, "{k}: {made}");
        }
    }
    // the ground leads the three vectors of the dyad
    let six = SixBar::new(SixBarParams::default()).expect("the parameters are physical");
    let outputs = |theta| {
        let x = SVector::from([theta, 1.0]);
        [six.angles(0.0, &x), six.rates(0.0, &x)].map(Into::into)
    };
    follow(&outputs, "six bars");
    let [start, _] = outputs(0.8);
    assert!(
        (start[0] + 0.6).abs() < 1.0 && (start[1] - 1.9).abs() < 1.0,
        "near the guesses: {start:?}"
    );
}

/// Lanes count turns like scalars, also in single precision.
#[test]
fn lanes_count_alike() {
    let models = [0.0, 0.5, 1.0].map(|k| Motor::new(MotorParams { k: k * 1e-3 }).expect("the parameters are physical"));
    let starts: Vec<SVector<f64, 2>> = (0..11)
        .map(|n| SVector::from([0.8 + 0.1 * f64::from(n), 12.0]))
        .collect();
    let all: Vec<Motor> = (0..11).map(|n| models[n % 3]).collect();
    let method = Rk45::new().rtol(1e-9).atol(1e-9);
    let ends = method.ensemble(&all, 0.0, 5.0, &starts).expect("they move");
    for ((model, start), end) in all.iter().zip(&starts).zip(&ends) {
        let alone = method.solve(model, 0.0, 5.0, *start).expect("it moves").end();
        assert_eq!(alone, *end);
        assert!(model.phi(0.0, end).abs() > TAU, "it turned");
    }
    let single = models[2].cast::<f32>();
    for n in 0..2000 {
        let theta = 0.8 + 0.05 * f64::from(n);
        let (ours, theirs) = (
            models[2].phi(0.0, &SVector::from([theta, 1.0])),
            single.phi(0.0, &SVector::from([theta as f32, 1.0])),
        );
        assert!((ours - f64::from(theirs)).abs() < 1e-4, "{theta}: {ours} {theirs}");
    }
}

/// The pivot of the dyad is within the coupler curve, so that the dyad turns with the crank although no vector leads.
/// The motion ends before its springs would jump.
#[test]
fn turns_that_do_not_follow_from_the_state_end_a_motion() {
    let params = SixBarParams {
        far: 0.15,
        high: 0.22,
        long: 1.0,
        k: 1e-3,
    };
    let model = SixBar::new(params).expect("the parameters are physical");
    let energy = model.energy(0.0, &SVector::from([0.8, 6.0]));
    let method = Vern9::new().rtol(1e-11).atol(1e-11);
    let error = method.solve(&model, 0.0, 60.0, [0.8, 6.0]).expect_err("it turns");
    assert!(
        matches!(
            error.reason,
            Reason::HalfTurn { coordinate } if ["chi", "omega"].contains(&&*coordinate)
        ),
        "{error}"
    );
    assert!(error.t() > 0.05 && error.t() < 2.0, "{error}");
    for (t, x) in error.solution.points() {
        assert!(
            (model.energy(t, x) - energy).abs() < 1e-8 * energy,
            "{t}: {}",
            model.energy(t, x)
        );
    }
    // turns are counted where the ground leads
    let model = SixBar::new(SixBarParams::default()).expect("the parameters are physical");
    assert_eq!(
        model.turn_margins(0.0, &SVector::from([0.8, 6.0])).0.as_slice(),
        [1.0, 1.0]
    );
    Vern9::new().solve(&model, 0.0, 5.0, [0.8, 12.0]).expect("it moves on");
    // a torsion spring counts turns, so a full turn of the crank changes the state
    assert!(!Motor::LAYOUT.slots[0].periodic);
}

//! Dry friction, stops and walls in scenes with ball and free joints.

use nalgebra::{Quaternion, SVector, UnitQuaternion, Vector3};
use pendulum_core::hybrid::Impact;
use pendulum_core::prelude::*;
use pendulum_core::sensitivity::{self, Variable};
use pendulum_core::stability::{resting, transition};
use pendulum_core::{Cast, Parametric, Plant};
use testbed::dual::Dual;
use testbed::power_series::Series;
use testbed::random::Random;

use super::scenes::{check_derivatives, check_response, check_series};

mechanism! {
    /// A pendulum on a cart with dry friction, beside a wall.
    pub Planar {
        gravity: [0, -9.81, 0],
        point tip on bob at [0, -1, 0],
        wall side { gap: 0.4 - tip.x, restitution: 0.6 }
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, dry_friction: 3 }
        body bob on cart {
            mass: 1, com: [0, -0.6, 0], inertia: [0.1, 0.05, 0.08], joint: revolute(z), coordinate: a,
        }
    }
}

mechanism! {
    /// That pendulum on a ball joint.
    pub Spatial {
        params { push: N = 0 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, taylor],
        point tip on bob at [0, -1, 0],
        wall side { gap: 0.4 - tip.x, restitution: 0.6 }
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, dry_friction: 3, torque: push }
        body bob on cart { mass: 1, com: [0, -0.6, 0], inertia: [0.1, 0.05, 0.08], joint: ball, orientation: o }
    }
}

mechanism! {
    /// The push as an input.
    pub Pushed {
        gravity: [0, -9.81, 0],
        input push: N,
        point tip on bob at [0, -1, 0],
        wall side { gap: 0.4 - tip.x, restitution: 0.6 }
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, dry_friction: 3, torque: push }
        body bob on cart { mass: 1, com: [0, -0.6, 0], inertia: [0.1, 0.05, 0.08], joint: ball, orientation: o }
    }
}

mechanism! {
    /// A die above the plane through the origin whose normal is `n`.
    pub Die {
        params { e: 1 = 0.5, n1: 1 = 0, n2: 1 = 0, n3: 1 = 1 }
        gravity: [-9.81*n1, -9.81*n2, -9.81*n3],
        generate: [rhs, jacobian, energy, momentum],
        point c1 on die at [0.1, 0.1, 0.1],
        point c2 on die at [-0.1, 0.1, 0.1],
        point c3 on die at [0.1, -0.1, 0.1],
        point c4 on die at [-0.1, -0.1, 0.1],
        point c5 on die at [0.1, 0.1, -0.1],
        point c6 on die at [-0.1, 0.1, -0.1],
        point c7 on die at [0.1, -0.1, -0.1],
        point c8 on die at [-0.1, -0.1, -0.1],
        wall w1 { gap: n1*c1.x + n2*c1.y + n3*c1.z, restitution: e }
        wall w2 { gap: n1*c2.x + n2*c2.y + n3*c2.z, restitution: e }
        wall w3 { gap: n1*c3.x + n2*c3.y + n3*c3.z, restitution: e }
        wall w4 { gap: n1*c4.x + n2*c4.y + n3*c4.z, restitution: e }
        wall w5 { gap: n1*c5.x + n2*c5.y + n3*c5.z, restitution: e }
        wall w6 { gap: n1*c6.x + n2*c6.y + n3*c6.z, restitution: e }
        wall w7 { gap: n1*c7.x + n2*c7.y + n3*c7.z, restitution: e }
        wall w8 { gap: n1*c8.x + n2*c8.y + n3*c8.z, restitution: e }
        body die on ground {
            mass: 0.5, inertia: [0.0033, 0.0034, 0.0032], joint: free, orientation: o, position: p,
        }
    }
}

mechanism! {
    /// A satellite with an arm whose hinge is dry and has stops.
    pub Satellite {
        params { mu: N m = 0.5 }
        generate: [rhs, jacobian, energy, momentum, taylor],
        body hull on ground {
            mass: 5, com: [0.1, 0, 0], inertia: [0.5, 0.7, 0.6], joint: free, orientation: o, position: p,
        }
        body arm on hull {
            mass: 1, com: [0, 0.5, 0], inertia: [0.09, 0.01, 0.09],
            joint: revolute(x) at [0.2, 0.3, 0], coordinate: a, dry_friction: mu, static_friction: 1.2*mu,
            stop: [-1, 1] restitution(0.5),
        }
    }
}

mechanism! {
    /// A stone that is pushed by a wall beside its centre of mass.
    pub Stone {
        gravity: [1, 0, -9.81],
        generate: [rhs, jacobian, energy, taylor],
        point corner on stone at [0.2, -0.1, -0.3],
        wall floor { gap: 0.8*corner.z + 0.6*corner.x, restitution: 0.4 }
        body stone on ground {
            mass: 0.5, com: [0.1, 0.2, 0.3], inertia: [0.03, 0.04, 0.05], joint: free, orientation: o, position: p,
        }
    }
}

/// Method of the tests, close to rounding errors.
fn method() -> Vern9 {
    Vern9::new().rtol(1e-12).atol(1e-12)
}

fn spatial() -> Spatial {
    Spatial::new(SpatialParams::default()).expect("physical")
}

fn die(e: f64, [n1, n2, n3]: [f64; 3]) -> Die {
    Die::new(DieParams { e, n1, n2, n3 }).expect("physical")
}

fn satellite(mu: f64) -> Satellite {
    Satellite::new(SatelliteParams { mu }).expect("physical")
}

fn orientation<const N: usize>(x: &SVector<f64, N>, at: usize) -> UnitQuaternion<f64> {
    UnitQuaternion::new_unchecked(Quaternion::new(x[at], x[at + 1], x[at + 2], x[at + 3]))
}

fn vector<const N: usize>(x: &SVector<f64, N>, at: usize) -> Vector3<f64> {
    x.fixed_rows::<3>(at).into()
}

/// Largest error of the length of a quaternion along a motion.
fn off_unit_length<const N: usize>(solution: &Solution<f64, N>, at: usize) -> f64 {
    let lengths = solution.points().map(|(_, x)| x.fixed_rows::<4>(at).norm());
    lengths.map(|length| (length - 1.0).abs()).fold(0.0, f64::max)
}

#[test]
fn responses_and_their_derivatives_hold_in_every_mode() {
    check_response(&spatial(), &spatial().cast::<Dual>(), 2);
    check_derivatives::<_, _, 9>(&spatial(), &spatial().cast::<Dual>(), 2);
    check_response(&satellite(0.5), &satellite(0.5).cast::<Dual>(), 1);
    check_derivatives::<_, _, 15>(&satellite(0.5), &satellite(0.5).cast::<Dual>(), 1);
    let stone = Stone::new(StoneParams {}).expect("physical");
    check_response(&stone, &stone.cast::<Dual>(), 1);
    check_derivatives::<_, _, 13>(&stone, &stone.cast::<Dual>(), 1);
    // more than three of its corners depend on one another
    let die = die(0.5, [0.36, 0.48, 0.8]);
    check_response(&die, &die.cast::<Dual>(), 8);
    check_derivatives::<_, _, 13>(&die, &die.cast::<Dual>(), 3);
}

#[test]
fn power_series_hold_in_every_mode() {
    let stone = Stone::new(StoneParams {}).expect("physical");
    check_series::<_, _, 13>(&stone, &stone.cast::<Series>(), 1);
    check_series::<_, _, 9>(&spatial(), &spatial().cast::<Series>(), 2);
    check_series::<_, _, 15>(&satellite(0.5), &satellite(0.5).cast::<Series>(), 1);
}

/// In a plane, a ball joint is a hinge: the same impacts, and the same end of the slip.
#[test]
fn a_ball_joint_in_a_plane_is_a_hinge() {
    let planar = Planar::new(PlanarParams {}).expect("physical");
    let [s, a, speed, rate] = [0.0, -0.9, 1.5, 0.5_f64];
    let (sin, cos) = (0.5 * a).sin_cos();
    let flat = method().solve(&planar, 0.0, 4.0, [s, a, speed, rate]).expect("regular");
    let start = [s, cos, 0.0, 0.0, sin, speed, 0.0, 0.0, rate];
    let solution = method().solve(&spatial(), 0.0, 4.0, start).expect("regular");
    assert_eq!(solution.modes().len(), flat.modes().len());
    assert!(flat.impacts().len() > 2 && flat.modes().iter().any(|(_, mode)| mode.is_held(0)));
    for ((t, mode), (known, other)) in solution.modes().iter().zip(flat.modes()) {
        assert!(mode == other && (t - known).abs() < 1e-9, "{t} {known}");
    }
    let (x, known) = (solution.end(), flat.end());
    let angle = 2.0 * x[Spatial::O + 3].atan2(x[Spatial::O]);
    let ours = [x[0], angle, x[Spatial::DOT_S], x[Spatial::DOT_O + 2]];
    assert!((SVector::from(ours) - known).amax() < 1e-9, "{ours:?} {known}");
    assert!(off_unit_length(&solution, Spatial::O) < 1e-15);
}

/// A start of the pendulum out of any plane.
fn swinging() -> [f64; 9] {
    let (sin, cos) = (-0.45_f64).sin_cos();
    [0.0, cos * 0.96, cos * 0.28, 0.0, sin, 1.5, 0.1, 0.2, 0.5]
}

#[test]
fn methods_and_laws_give_the_same_motion() {
    fn near<S: System<f64, 9>>(system: &S, method: &impl Method<S, f64, 9>, known: &SVector<f64, 9>, what: &str) {
        let end = method.solve(system, 0.0, 2.0, swinging()).expect(what).end();
        let error = (end - known).amax();
        assert!(error < 1e-7, "{what}: {error:e}");
    }
    let model = spatial();
    let solution = method().solve(&model, 0.0, 2.0, swinging()).expect("regular");
    assert!(!solution.impacts().is_empty() && solution.modes().iter().any(|(_, mode)| mode.is_held(0)));
    let known = solution.end();
    near(&model, &Tsit5::new().rtol(1e-11).atol(1e-11), &known, "Tsit5");
    near(&model, &Rodas5P::new().rtol(1e-11).atol(1e-11), &known, "Rodas5P");
    near(&model, &Radau5::new().rtol(1e-11).atol(1e-11), &known, "Radau5");
    near(&model, &Taylor::new().rtol(1e-11).atol(1e-11), &known, "Taylor");
    // pressed against the wall
    let pressed = Spatial::new(SpatialParams { push: 8.0 }).expect("physical");
    let solution = method().solve(&pressed, 0.0, 2.0, swinging()).expect("regular");
    assert!(solution.modes().iter().any(|(_, mode)| mode.is_held(1)));
    let pushed = Pushed::new(PushedParams {}).expect("physical");
    let closed = pushed.with_inputs(|_t, _x| PushedInputs { push: 8.0 });
    near(&closed, &method(), &solution.end(), "a law");
    assert_eq!(Plant::<f64, 9>::orientations(&closed), [[Spatial::O, Spatial::DOT_O]]);
}

/// Die whose lowest face is `above` the table, with this orientation, velocity and rates.
fn thrown(above: f64, turned: UnitQuaternion<f64>, velocity: [f64; 3], rates: [f64; 3]) -> SVector<f64, 13> {
    let q = turned.quaternion();
    let [a, b, c, d] = [q.w, q.i, q.j, q.k];
    let ([u, v, w], [i, j, k]) = (velocity, rates);
    SVector::from([0.0, 0.0, above + 0.1, a, b, c, d, u, v, w, i, j, k])
}

/// A die that falls flat bounces and comes to rest like a ball: its corners collide together.
#[test]
fn a_die_that_falls_flat_bounces_like_a_ball() {
    let (e, model) = (0.5, die(0.5, [0.0, 0.0, 1.0]));
    let start = thrown(0.3, UnitQuaternion::identity(), [0.7, -0.2, 0.0], [0.0; 3]);
    let solution = method().solve(&model, 0.0, 1.0, start).expect("regular");
    let first = solution.impacts()[0];
    let rate = Die::DOT_P_X + 2;
    let fall = (0.6_f64 / 9.81).sqrt();
    assert!((first.t - fall).abs() < 1e-12, "{}", first.t);
    assert!(
        (first.after[rate] + e * first.before[rate]).abs() < 1e-12,
        "{}",
        first.after
    );
    let (rests, mode) = *solution.modes().last().expect("a mode");
    assert!((rests - fall * (1.0 + 2.0 * e / (1.0 - e))).abs() < 1e-11, "{rests}");
    assert_eq!((0..8).filter(|&n| mode.is_held(n)).count(), 4);
    let mut end = thrown(0.0, UnitQuaternion::identity(), [0.7, -0.2, 0.0], [0.0; 3]);
    (end[0], end[1]) = (0.7, -0.2);
    assert!((solution.end() - end).amax() < 1e-12, "{}", solution.end());
}

/// Energy of a die, and its momenta that a smooth table does not change: along the table, and about its normal.
fn conserved(model: &Die, x: &SVector<f64, 13>) -> (f64, Vector3<f64>) {
    let momentum = model.momentum(0.0, x);
    let spin = orientation(x, Die::O) * Vector3::new(momentum[3], momentum[4], momentum[5]);
    (model.energy(0.0, x), Vector3::new(momentum[0], momentum[1], spin.z))
}

#[test]
fn a_die_without_losses_keeps_its_energy_and_momenta() {
    let model = die(1.0, [0.0, 0.0, 1.0]);
    let start = thrown(
        0.5,
        UnitQuaternion::from_euler_angles(0.4, 0.3, -0.8),
        [1.0, 0.4, 0.0],
        [3.0, -5.0, 2.0],
    );
    let solution = method().solve(&model, 0.0, 2.0, start).expect("regular");
    assert!(solution.impacts().len() > 5, "{}", solution.impacts().len());
    let (energy, momenta) = conserved(&model, &start);
    for (t, x) in solution.points() {
        let (now, along) = conserved(&model, x);
        assert!((now / energy - 1.0).abs() < 1e-10, "{now} at {t}");
        assert!((along - momenta).norm() < 1e-10 * momenta.norm(), "{along} at {t}");
    }
    assert!(off_unit_length(&solution, Die::O) < 1e-15);
}

#[test]
fn a_die_comes_to_rest_on_a_face() {
    let model = die(0.4, [0.0, 0.0, 1.0]);
    let start = thrown(
        0.3,
        UnitQuaternion::from_euler_angles(0.7, 0.2, 0.5),
        [0.5, -0.3, 0.2],
        [6.0, -2.0, 1.0],
    );
    let solution = method()
        .max_steps(20_000)
        .solve(&model, 0.0, 4.0, start)
        .expect("regular");
    let (before, momenta) = conserved(&model, &start);
    let mut energy = before;
    for (t, x) in solution.points() {
        let (now, along) = conserved(&model, x);
        assert!(now < energy + 1e-10 * before, "{now} at {t}");
        assert!((along - momenta).norm() < 1e-9 * momenta.norm(), "{along} at {t}");
        energy = now;
        let lowest = model.measures(t, x).map(|[gap, _]| gap).into_iter().fold(0.0, f64::min);
        assert!(lowest > -1e-12, "{lowest:e} at {t}");
    }
    let (end, (_, mode)) = (solution.end(), *solution.modes().last().expect("a mode"));
    // three hold it, and the fourth is as near as rounding errors let it be
    assert!((0..8).filter(|&n| mode.is_held(n)).count() >= 3, "{mode:?}");
    let gaps = model.measures(4.0, &end).map(|[gap, _]| gap);
    assert_eq!(gaps.iter().filter(|gap| gap.abs() < 1e-12).count(), 4, "{gaps:?}");
    assert!(
        (end[2] - 0.1).abs() < 1e-12 && end[Die::DOT_P_X + 2].abs() < 1e-12,
        "{end}"
    );
    assert!(off_unit_length(&solution, Die::O) < 1e-15);
}

/// In a turned frame the motion is turned.
#[test]
fn a_turned_scene_has_the_turned_motion() {
    let turn = UnitQuaternion::rotation_between(&Vector3::z(), &Vector3::new(0.36, 0.48, 0.8)).expect("not opposite");
    let start = thrown(
        0.3,
        UnitQuaternion::from_euler_angles(0.7, 0.2, 0.5),
        [0.5, -0.3, 0.2],
        [6.0, -2.0, 1.0],
    );
    let turned = |x: &SVector<f64, 13>| {
        let mut all = *x;
        for at in [Die::P_X, Die::DOT_P_X] {
            all.fixed_rows_mut::<3>(at).copy_from(&(turn * vector(x, at)));
        }
        let q = turn * orientation(x, Die::O);
        let q = q.quaternion();
        all.fixed_rows_mut::<4>(Die::O).copy_from_slice(&[q.w, q.i, q.j, q.k]);
        all
    };
    let level = method()
        .solve(&die(0.6, [0.0, 0.0, 1.0]), 0.0, 0.6, start)
        .expect("regular");
    let inclined = method().solve(&die(0.6, [0.36, 0.48, 0.8]), 0.0, 0.6, turned(&start));
    let inclined = inclined.expect("regular");
    assert!(level.impacts().len() > 2 && inclined.impacts().len() == level.impacts().len());
    let error = (inclined.end() - turned(&level.end())).amax();
    assert!(error < 1e-8, "{error:e}");
}

/// State of a satellite with these rates of turning.
fn spinning(rates: [f64; 3], arm: f64) -> SVector<f64, 15> {
    let mut x = SVector::<f64, 15>::zeros();
    (x[Satellite::O], x[Satellite::A]) = (0.8, 0.4);
    x[Satellite::O + 2] = 0.6;
    x.fixed_rows_mut::<3>(Satellite::DOT_P_X)
        .copy_from_slice(&[0.3, -0.1, 0.2]);
    x.fixed_rows_mut::<3>(Satellite::DOT_O).copy_from_slice(&rates);
    x[Satellite::DOT_A] = arm;
    x
}

/// A dry hinge exchanges momentum within a satellite until it sticks, and the whole keeps its own.
#[test]
fn a_satellite_with_a_dry_hinge_keeps_its_momentum() {
    let model = satellite(0.5);
    let momentum = |x: &SVector<f64, 15>| {
        let along = model.momentum(0.0, x);
        let (linear, turning) = (vector(&along, 0), vector(&along, 3));
        let angular = orientation(x, Satellite::O) * turning + vector(x, Satellite::P_X).cross(&linear);
        (linear, angular)
    };
    let start = spinning([0.4, 0.3, -0.2], 4.0);
    let solution = method().solve(&model, 0.0, 5.0, start).expect("regular");
    let at_stop = |impact: &Impact<f64, 15>| impact.after[Satellite::A] == 1.0;
    assert!(!solution.impacts().is_empty() && solution.impacts().iter().all(at_stop));
    let (linear, angular) = momentum(&start);
    for (t, x) in solution.points() {
        let (now, about) = momentum(x);
        assert!(
            (now - linear).norm() < 1e-11 && (about - angular).norm() < 1e-11,
            "at {t}"
        );
    }
    let sticks: Vec<_> = solution.modes().iter().filter(|(_, mode)| mode.is_held(0)).collect();
    let [(since, _)] = sticks[..] else { panic!("{sticks:?}") };
    let held = solution.points().filter(|(t, _)| t > since);
    let angles: Vec<f64> = held.map(|(_, x)| x[Satellite::A]).collect();
    assert!(angles.len() > 2 && angles.iter().all(|angle| *angle == angles[0]));
    assert_eq!(solution.end()[Satellite::DOT_A], 0.0);
    // while it sticks, no energy is lost
    let energy = |t: f64| model.energy(t, &solution.at(t).expect("within"));
    assert!((energy(5.0) / energy(*since + 0.1) - 1.0).abs() < 1e-9);
    assert!(off_unit_length(&solution, Satellite::O) < 1e-15);
    // a fast spin throws the arm off its place
    let fast = method()
        .solve(&model, 0.0, 1.0, spinning([0.4, 0.3, 4.0], 0.0))
        .expect("regular");
    let modes = fast.modes();
    assert!(modes.iter().any(|(_, mode)| !mode.is_held(0)), "{modes:?}");
}

#[test]
fn lanes_have_the_bits_of_trajectories_alone() {
    fn same(method: &(impl Ensemble<Satellite, f64, 15> + Method<Satellite, f64, 15>)) {
        let mut random = Random::new(3);
        let (models, starts): (Vec<_>, Vec<_>) = (0..12)
            .map(|_| {
                let mut number = |size: f64| random.between(-size, size);
                let rates = [(); 3].map(|()| number(1.0));
                (satellite(0.5 + number(0.3)), spinning(rates, number(4.0)))
            })
            .unzip();
        let ends = method.ensemble(&models, 0.0, 3.0, &starts).expect("regular");
        for ((model, start), end) in models.iter().zip(&starts).zip(&ends) {
            let alone = method.solve(model, 0.0, 3.0, *start).expect("regular");
            assert_eq!(alone.end().map(f64::to_bits), end.map(f64::to_bits), "from {start}");
        }
    }
    same(&Tsit5::new());
    same(&Rk4::new(0.01));
}

/// Tangents and sensitivities through impacts and the ends of slips, against neighbouring motions.
#[test]
fn derivatives_are_those_of_neighbours() {
    let solution = check_neighbours(&spatial(), swinging(), Spatial::O, 1.6);
    assert!(!solution.impacts().is_empty());
    let start = thrown(
        0.3,
        UnitQuaternion::from_euler_angles(0.4, 0.3, -0.8),
        [1.0, 0.4, 0.0],
        [3.0, -5.0, 2.0],
    );
    let solution = check_neighbours(&die(0.5, [0.0, 0.0, 1.0]), start.into(), Die::O, 0.35);
    assert!(!solution.impacts().is_empty());
    // without a rebound, the die turns on about its corner
    let solution = check_neighbours(&die(0.0, [0.0, 0.0, 1.0]), start.into(), Die::O, 0.27);
    let (_, last) = *solution.modes().last().expect("a mode");
    assert!(!solution.impacts().is_empty() && (0..8).any(|n| last.is_held(n)));
}

/// Checks the derivatives by all initial values, in directions in which the quaternion keeps its length. Returns the
/// motion.
fn check_neighbours<S, const N: usize, const P: usize>(model: &S, start: [f64; N], o: usize, t: f64) -> Solution<f64, N>
where
    S: Jacobian<f64, N> + Parametric<N, P> + Cast<N>,
{
    let start = SVector::from(start);
    let end = |x: SVector<f64, N>| method().solve(model, 0.0, t, x).expect("regular").end();
    let (_, matrix) = transition(model, 0.0, t, start, 1e-12).expect("regular");
    let by: [Variable; N] = std::array::from_fn(Variable::Start);
    let sensitive = sensitivity::solve(&method(), model, 0.0, t, start, by).expect("regular");
    let (_, derivatives) = sensitive.end();
    let (reach, q) = (1e-5, start.fixed_rows::<4>(o).into_owned());
    for component in 0..N {
        let mut direction = SVector::<f64, N>::zeros();
        direction[component] = 1.0;
        let along = q.dot(&direction.fixed_rows::<4>(o));
        direction
            .fixed_rows_mut::<4>(o)
            .iter_mut()
            .zip(q.iter())
            .for_each(|(d, q)| *d -= along * q);
        let theirs = (end(start + reach * direction) - end(start - reach * direction)) / (2.0 * reach);
        for (what, ours) in [
            ("tangent", matrix * direction),
            ("sensitivity", derivatives * direction),
        ] {
            let error = (ours - theirs).amax() / (1.0 + theirs.amax());
            assert!(error < 1e-6, "{what}: {error:e} in {component}");
        }
    }
    method().solve(model, 0.0, t, start).expect("regular")
}

/// Friction of the cart holds it where the pendulum hangs.
#[test]
fn a_pendulum_on_a_ball_joint_hangs_at_rest() {
    let seed = [0.2, 0.97, 0.15, 0.0, -0.19, 0.0, 0.0, 0.0, 0.0];
    let mut seed = SVector::from(seed);
    let length = seed.fixed_rows::<4>(Spatial::O).norm();
    seed.fixed_rows_mut::<4>(Spatial::O).unscale_mut(length);
    let rests = resting(&spatial(), seed).expect("it rests");
    let down = orientation(&rests.x, Spatial::O) * -Vector3::y();
    assert!((down + Vector3::y()).norm() < 1e-9, "{down}");
    assert!((rests.x.fixed_rows::<4>(Spatial::O).norm() - 1.0).abs() < 1e-12);
}

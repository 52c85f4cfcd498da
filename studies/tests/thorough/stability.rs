//! Equilibria of generated mechanisms, and motions about them, compared with closed forms.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use pendulum_core::nalgebra::{DMatrix, SymmetricEigen};
use pendulum_core::prelude::*;
use pendulum_core::stability::{
    Equilibrium, Lyapunov, Shooting, Stability, StabilityError, equilibria, equilibrium, section,
};
use testbed::random::{Random, share};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

mechanism! {
    /// Four links whose centres of mass lie beside the lines of their joints.
    pub Crooked {
        params { m: kg = 1.0, a: m = 0.1, b: m = -0.2, g: m/s^2 = 9.81, gamma: N m s = 0.3 }
        gravity: [0, -g, 0],
        body first on ground {
            mass: m, com: [a, -0.5, 0], inertia: 0.1, joint: revolute(z), coordinate: q1, friction: gamma,
        }
        body second on first {
            mass: m, com: [b, -0.4, 0], inertia: 0.1,
            joint: revolute(z) at [0.1, -1, 0], coordinate: q2, friction: gamma,
        }
        body third on second {
            mass: m, com: [a, 0.3, 0], inertia: 0.1,
            joint: revolute(z) at [0, -0.9, 0], coordinate: q3, friction: gamma,
        }
        body fourth on third {
            mass: m, com: [b, 0, 0], inertia: 0.1,
            joint: revolute(z) at [-0.2, -0.7, 0], coordinate: q4, friction: gamma,
        }
    }
}

mechanism! {
    /// Like `Crooked`, but with absolute angles.
    pub CrookedAbsolute {
        params { m: kg = 1.0, a: m = 0.1, b: m = -0.2, g: m/s^2 = 9.81, gamma: N m s = 0.3 }
        gravity: [0, -g, 0],
        body first on ground {
            mass: m, com: [a, -0.5, 0], inertia: 0.1, joint: revolute(z), coordinate: q1 absolute, friction: gamma,
        }
        body second on first {
            mass: m, com: [b, -0.4, 0], inertia: 0.1,
            joint: revolute(z) at [0.1, -1, 0], coordinate: q2 absolute, friction: gamma,
        }
        body third on second {
            mass: m, com: [a, 0.3, 0], inertia: 0.1,
            joint: revolute(z) at [0, -0.9, 0], coordinate: q3 absolute, friction: gamma,
        }
        body fourth on third {
            mass: m, com: [b, 0, 0], inertia: 0.1,
            joint: revolute(z) at [-0.2, -0.7, 0], coordinate: q4 absolute, friction: gamma,
        }
    }
}

mechanism! {
    /// A pendulum driven by a constant motor torque.
    pub Motor {
        params { torque: N m = 3.0 }
        gravity: [0, -9.81, 0],
        body bob on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, torque: torque, friction: 0.1,
        }
    }
}

mechanism! {
    /// A pendulum on a cart on a level track.
    pub Cart {
        gravity: [0, -9.81, 0],
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: x, friction: 0.5 }
        body bob on cart { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle, friction: 0.1 }
    }
}

mechanism! {
    /// A pendulum at the rim of a table that rotates freely.
    pub Turntable {
        gravity: [0, 0, -9.81],
        body table on ground { mass: 2, inertia: [1, 1, 1], joint: revolute(z), coordinate: turn, friction: 0.1 }
        body bob on table {
            mass: 1, com: [0, 0, -1], inertia: [0.1, 0.1, 0.1],
            joint: revolute(x) at [1, 0, 0], coordinate: angle, friction: 0.1,
        }
    }
}

mechanism! {
    /// A pendulum driven by an oscillating motor torque.
    pub Shaken {
        gravity: [0, -9.81, 0],
        body bob on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle,
            torque: 1 N m*cos(1 rad/s*t), friction: 0.1,
        }
    }
}

fn pendulum(gamma1: f64, gamma2: f64) -> DoublePendulum {
    let params = DoublePendulumParams {
        gamma1,
        gamma2,
        ..Default::default()
    };
    DoublePendulum::new(params).expect("physical")
}

fn unstable<const N: usize>(equilibrium: &Equilibrium<N>) -> usize {
    let modes = equilibrium.spectrum.modes().iter();
    modes.filter(|mode| mode.growth_rate() > mode.uncertainty).count()
}

/// Each link hangs or stands, and each standing one causes one growing motion: the stiffness matrix is diagonal in
/// absolute angles, and the signs of its entries are those of the squares of the growth rates, whatever the masses
/// (Sylvester's law of inertia).
#[test]
fn the_equilibria_of_a_chain_are_all_found() {
    fn check(model: &impl Jacobian<f64, 8>, seed: SVector<f64, 8>) {
        let found = equilibria(model, [seed]).expect("autonomous");
        assert_eq!(found.len(), 16);
        let mut counts = [0; 5];
        for equilibrium in &found {
            assert!(model.rhs(0.0, &equilibrium.x).amax() < 1e-11);
            assert_eq!(equilibrium.jacobian, model.jacobian(0.0, &equilibrium.x));
            counts[unstable(equilibrium)] += 1;
            let expected = match unstable(equilibrium) {
                0 => Stability::AsymptoticallyStable,
                _ => Stability::Unstable,
            };
            assert_eq!(equilibrium.stability(), expected);
        }
        assert_eq!(counts, [1, 4, 6, 4, 1]);
    }
    let mut random = Random::new(5);
    for _ in 0..3 {
        let (m, a) = (random.between(0.1, 10.0), random.between(-1.0, 1.0));
        let seed = SVector::from_fn(|i, _| if i < 4 { random.between(-PI, PI) } else { 0.0 });
        let params = CrookedParams {
            m,
            a,
            ..Default::default()
        };
        check(&Crooked::new(params).expect("physical"), seed);
        let params = CrookedAbsoluteParams {
            m,
            a,
            ..Default::default()
        };
        check(&CrookedAbsolute::new(params).expect("physical"), seed);
    }
}

#[test]
fn a_constant_torque_turns_the_equilibria_and_then_ends_them() {
    for torque in [3.0, -9.0, 9.8] {
        let motor = Motor::new(MotorParams { torque }).expect("physical");
        let found = equilibria(&motor, [SVector::from([0.3, 0.0])]).expect("autonomous");
        let [low, high] = &found[..] else {
            panic!("there are two: {found:?}")
        };
        let lean = (torque / 9.81).asin();
        assert!((low.x[0] - lean).abs() < 1e-9 && low.stability() == Stability::AsymptoticallyStable);
        let other = if torque > 0.0 { PI - lean } else { -PI - lean };
        assert!((high.x[0] - other).abs() < 1e-9 && high.stability() == Stability::Unstable);
    }
    let motor = Motor::new(MotorParams { torque: 10.0 }).expect("physical");
    assert!(equilibrium(&motor, [0.3, 0.0]).is_err());
    assert!(
        equilibria(&motor, [SVector::from([0.3, 0.0])])
            .expect("autonomous")
            .is_empty()
    );
}

mechanism! {
    /// A pendulum with a torsion spring: `k theta + 9.81 sin theta = 0`.
    pub Wound {
        params { k: N m / rad }
        gravity: [0, -9.81, 0],
        body bob on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta, spring: (k, 0), friction: 0.1,
        }
    }
}

mechanism! {
    /// Two pendulums with torsion springs, one on the other.
    pub WoundChain {
        params { k: N m / rad }
        gravity: [0, -9.81, 0],
        body upper on ground {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta, spring: (k, 0), friction: 0.1,
        }
        body lower on upper {
            mass: 1, com: [0, -1, 0], joint: revolute(z) at [0, -1, 0], coordinate: phi, spring: (k, 0), friction: 0.1,
        }
    }
}

mechanism! {
    /// A slider on a level rail, with a spring of length 1 m to a point 0.6 m above the rail.
    pub Snap {
        point pin on ground at [0, 0.6, 0],
        point middle on slider,
        spring between pin and middle: (10, 1),
        body slider on ground { mass: 1, joint: prismatic(x), coordinate: x, friction: 0.1 }
    }
}

/// Compares with the sign changes of the equilibrium equations on a fine grid.
#[test]
fn equilibria_under_springs_are_all_found() {
    for k in [0.3, 1.0, 2.0, 5.0, 20.0] {
        let torque = |angle: f64| k * angle + 9.81 * angle.sin();
        let reach = 9.81 / k + 1.0;
        let at = |n: i32| reach * (f64::from(n) + 0.5) / 20_000.0;
        let known = (-20_000..20_000)
            .filter(|&n| torque(at(n - 1)) * torque(at(n)) < 0.0)
            .count();
        let wound = Wound::new(WoundParams { k }).expect("physical");
        let found = equilibria(&wound, [SVector::from([0.1, 0.0])]).expect("autonomous");
        assert_eq!(found.len(), known, "{k}");
        assert!(found.unsearched().is_empty());
        let stable = found
            .iter()
            .filter(|found| found.stability() == Stability::AsymptoticallyStable);
        assert_eq!(2 * stable.count() - 1, known);
    }
    // a spring so soft that equilibria extend over some 15 turns
    let wound = Wound::new(WoundParams { k: 0.1 }).expect("physical");
    let found = equilibria(&wound, [SVector::from([0.1, 0.0])]).expect("autonomous");
    assert_eq!(found.unsearched(), ["theta"]);
    // for two angles, all roots that Newton's method finds from a fine grid
    for &k in &[4.0, 2.0][..share(2)] {
        let chain = WoundChain::new(WoundChainParams { k }).expect("physical");
        let found = equilibria(&chain, [SVector::zeros()]).expect("autonomous");
        let mut known: Vec<SVector<f64, 4>> = Vec::new();
        for n in 0..25 * 25 {
            let angle = |n: i32| 0.7 * f64::from(n - 12);
            let seed = SVector::from([angle(n % 25), angle(n / 25), 0.0, 0.0]);
            let Ok(other) = equilibrium(&chain, seed) else { continue };
            if known.iter().all(|x| (x - other.x).norm() > 1e-6) {
                known.push(other.x);
            }
        }
        let missing = known
            .iter()
            .filter(|x| found.iter().all(|found| (found.x - *x).norm() > 1e-6));
        assert_eq!(missing.count(), 0, "{k}: {} of {}", found.len(), known.len());
        assert!(known.len() > 1 && found.unsearched().is_empty());
    }
    let snap = Snap::new(SnapParams {}).expect("physical");
    let found = equilibria(&snap, [SVector::from([0.3, 0.0])]).expect("autonomous");
    let mut places: Vec<f64> = found.iter().map(|found| found.x[0]).collect();
    places.sort_by(f64::total_cmp);
    assert!(places.len() == 3 && found.unsearched() == ["x"], "{places:?}");
    for (found, known) in places.iter().zip([-0.8, 0.0, 0.8]) {
        assert!((found - known).abs() < 1e-9, "{places:?}");
    }
}

/// The equilibrium is independent of the position of the cart: one motion neither grows nor decays.
#[test]
fn equilibria_that_are_not_isolated_are_found_nearby() {
    let cart = Cart::new(CartParams {}).expect("physical");
    let found = equilibria(&cart, [SVector::from([0.7, 0.5, 0.0, 0.0])]).expect("autonomous");
    assert_eq!(found.len(), 2);
    assert_eq!(found[0].stability(), Stability::Undecided);
    assert_eq!(found[1].stability(), Stability::Unstable);
    let still = found[0].spectrum.modes()[0];
    assert!(still.eigenvalue.norm() <= still.uncertainty);
    // the cart moves, and nothing else
    assert!((still.shape[0].norm() - 1.0).abs() < 1e-9 && still.shape.rows(1, 3).map(|part| part.norm()).max() < 1e-9);
}

/// The equilibrium is independent of the angle of the table, so half a turn of it yields no different equilibrium.
#[test]
fn angles_that_do_not_matter_are_not_turned() {
    let table = Turntable::new(TurntableParams {}).expect("physical");
    let slots = Turntable::LAYOUT.slots.iter();
    assert!(
        slots
            .map(|slot| (slot.periodic, slot.cyclic))
            .eq([(true, true), (true, false)])
    );
    let found = equilibria(&table, [SVector::from([0.4, 0.1, 0.0, 0.0])]).expect("autonomous");
    assert_eq!(found.len(), 2, "{found:?}");
}

#[test]
fn a_system_that_time_drives_has_no_equilibria() {
    let shaken = Shaken::new(ShakenParams {}).expect("physical");
    let seed = SVector::from([0.1, 0.0]);
    assert_eq!(equilibria(&shaken, [seed]), Err(StabilityError::TimeDependent));
    assert_eq!(equilibrium(&shaken, seed), Err(StabilityError::TimeDependent));
    let free = Shooting::new().autonomous(&shaken, seed, TAU);
    assert_eq!(free, Err(StabilityError::TimeDependent));
    let forced = Shooting::new().forced(&shaken, seed, TAU);
    assert!(forced.is_ok(), "{forced:?}");
}

/// With `A = [[3, 1], [1, 2]]` and stiffness `diag(2 g, g)`, with the opposite sign for a standing plate, the squares
/// `s` of the rates solve `5 s^2 + 7 g s + 2 g^2 = 0`, `5 s^2 - 7 g s + 2 g^2 = 0`, `5 s^2 + g s - 2 g^2 = 0` and
/// `5 s^2 - g s - 2 g^2 = 0`.
#[test]
fn frictionless_modes_are_those_of_the_closed_form() {
    let g = 9.8_f64;
    let found = equilibria(&pendulum(0.0, 0.0), [SVector::from([0.1, 0.0, 0.0, 0.0])]).expect("autonomous");
    assert_eq!(found.len(), 4);
    let root = 41.0_f64.sqrt();
    for equilibrium in found {
        let stands = [0, 1].map(|i| equilibrium.x[i].abs() > FRAC_PI_2);
        let squares = match stands {
            [false, false] => [-0.4 * g, -g],
            [true, true] => [g, 0.4 * g],
            [false, true] => [(root - 1.0) * g / 10.0, -(root + 1.0) * g / 10.0],
            [true, false] => [(root + 1.0) * g / 10.0, -(root - 1.0) * g / 10.0],
        };
        let mut expected = Vec::new();
        for square in squares {
            let root = f64::abs(square).sqrt();
            expected.extend(if square > 0.0 {
                [(root, 0.0), (-root, 0.0)]
            } else {
                [(0.0, root), (0.0, -root)]
            });
        }
        for mode in equilibrium.spectrum.modes() {
            let apart = |&(re, im): &(f64, f64)| (mode.eigenvalue.re - re).hypot(mode.eigenvalue.im - im);
            let nearest = expected.iter().map(apart).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-13 * g, "{mode:?}");
            assert!(nearest <= mode.uncertainty, "{mode:?}");
        }
        let expected = if stands == [false, false] {
            Stability::Undecided
        } else {
            Stability::Unstable
        };
        assert_eq!(equilibrium.stability(), expected);
    }
}

/// Friction makes a stable equilibrium asymptotically stable, and cannot stabilise an unstable one (Kelvin, Tait and
/// Chetaev), however it is distributed.
#[test]
fn friction_settles_what_hangs_and_nothing_else() {
    let sizes = [0.0, 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4];
    for gamma1 in sizes {
        for gamma2 in sizes {
            if (gamma1, gamma2) == (0.0, 0.0) {
                continue;
            }
            let model = pendulum(gamma1, gamma2);
            for equilibrium in equilibria(&model, [SVector::zeros()]).expect("autonomous") {
                let standing = (0..2).filter(|&i| equilibrium.x[i].abs() > FRAC_PI_2).count();
                assert_eq!(unstable(&equilibrium), standing, "{gamma1} {gamma2} {equilibrium:?}");
                let stable = equilibrium.stability() == Stability::AsymptoticallyStable;
                assert_eq!(stable, standing == 0, "{gamma1} {gamma2} {equilibrium:?}");
            }
        }
    }
}

/// Beside an unstable equilibrium, the full model follows the linear theory for a while.
#[test]
fn a_start_beside_an_unstable_rest_leaves_at_the_growth_rate() {
    let model = pendulum(0.3, 0.2);
    for equilibrium in equilibria(&model, [SVector::zeros()]).expect("autonomous") {
        let fastest = equilibrium.spectrum.modes()[0];
        if fastest.growth_rate() < 0.0 {
            continue;
        }
        let shape = fastest.shape.map(|part| part.re);
        let start = equilibrium.x + shape * 1e-9;
        let t = 1e4_f64.ln() / fastest.growth_rate();
        let end = Vern9::new()
            .rtol(1e-13)
            .atol(1e-15)
            .solve(&model, 0.0, t, start)
            .expect("regular")
            .end();
        let grown = (end - equilibrium.x).dot(&shape) / shape.norm_squared();
        assert!((grown / 1e-5 - 1.0).abs() < 1e-4, "{grown:e} {equilibrium:?}");
    }
}

/// In `[q; qd]` the exponents of a motion without friction come in pairs of opposite sign; with friction, their sum is
/// the mean of the trace.
#[test]
fn exponents_pair_without_friction_and_sum_to_the_mean_trace_with_it() {
    let start = [2.0, 2.5, 0.0, 0.0];
    let measure = Lyapunov::new().tolerance(1e-7).duration(150.0);
    let [first, second, third, fourth] = measure
        .exponents::<4, 4>(&pendulum(0.0, 0.0), start)
        .expect("regular")
        .values;
    assert!(first > 0.5, "{first}");
    // up to end effects of directions that are not orthogonal, which decrease as one over the time
    assert!(
        (first + fourth).abs() < 0.03 && (second + third).abs() < 0.03,
        "{first} {second} {third} {fourth}"
    );

    let model = pendulum(0.1, 0.02);
    let found = measure.exponents::<4, 4>(&model, start).expect("regular");
    let solution = Vern9::new()
        .rtol(1e-8)
        .atol(1e-8)
        .solve(&model, 0.0, 150.0, start)
        .expect("regular");
    let traces = |t: f64| model.jacobian(t, &solution.at(t).expect("within")).trace();
    let n = 30_000;
    let simpson: f64 = (0..=n)
        .map(|i| {
            let weight = if i == 0 || i == n {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            };
            weight * traces(150.0 * f64::from(i) / f64::from(n))
        })
        .sum::<f64>()
        / f64::from(3 * n);
    let sum: f64 = found.values.iter().sum();
    // some ten steps per second, each with a relative error of up to 1e-7
    assert!((sum - simpson).abs() < 1e-6, "{sum} {simpson}");
}

/// Compares linear modes of a chain of three with a symmetric eigenproblem of its own mass matrix and weights.
#[test]
fn hanging_chains_swing_at_the_frequencies_of_the_symmetric_problem() {
    let chain = testbed::plates::TripleChain::new(testbed::plates::TripleChainParams {}).expect("physical");
    let hanging = equilibrium(&chain, [0.1, -0.1, 0.2, 0.0, 0.0, 0.0]).expect("there is one");
    assert!(hanging.x.amax() < 1e-12);
    // Absolute angles: weights below each joint times their levers; masses 1, 0.7, 0.5, lengths 1, 0.8, centres at 0.5,
    // 0.4, 0.3.
    let (g, levers) = (9.81, [0.5 + 0.7 + 0.5, 0.7 * 0.4 + 0.5 * 0.8, 0.5 * 0.3]);
    let mass = DMatrix::from_row_slice(
        3,
        3,
        &[
            0.08 + 0.25 + 1.2,
            levers[1],
            levers[2], //
            levers[1],
            0.05 + 0.7 * 0.16 + 0.5 * 0.64,
            0.5 * 0.8 * 0.3, //
            levers[2],
            0.5 * 0.8 * 0.3,
            0.02 + 0.5 * 0.09,
        ],
    );
    let roots = DMatrix::from_diagonal(&levers.map(|lever| 1.0 / (g * lever).sqrt()).to_vec().into());
    let inverse_squares = SymmetricEigen::<f64, _>::new(&roots * mass * &roots).eigenvalues;
    let mut expected: Vec<f64> = inverse_squares.iter().map(|square: &f64| 1.0 / square.sqrt()).collect();
    expected.sort_by(f64::total_cmp);
    let mut sizes: Vec<f64> = hanging
        .spectrum
        .eigenvalues()
        .map(|eigenvalue| eigenvalue.norm())
        .collect();
    sizes.sort_by(f64::total_cmp);
    // the friction of 0.01 N m s changes them to second order
    for (size, expected) in sizes.chunks(2).zip(expected) {
        assert!((size[0] / expected - 1.0).abs() < 3e-3, "{sizes:?} {expected}");
    }
}

/// A small motion in one mode passes the middle once per period.
#[test]
fn a_section_of_a_mode_is_one_point_for_each_period() {
    let model = pendulum(0.0, 0.0);
    let hanging = equilibrium(&model, [0.0; 4]).expect("there is one");
    let surface = Event::new(|_t, x: &SVector<f64, 4>| x[0]).rising();
    let method = Taylor::new().rtol(1e-12).atol(1e-14);
    for mode in hanging.spectrum.modes().iter().step_by(2) {
        let start = mode.shape.map(|part| 1e-4 * part.re);
        let points = section(&method, &model, 0.0, 200.0, start, &surface).expect("regular");
        let energy = model.energy(0.0, &start);
        for (k, point) in points.iter().enumerate() {
            assert!(point.x[0].abs() < 1e-15 && point.x[2] > 0.0);
            assert!((model.energy(point.t, &point.x) - energy).abs() < 1e-12);
            let period = 2.0 * PI / mode.angular_frequency();
            // frequencies decrease with the square of the amplitude
            let passed = (point.t - points[0].t) / period;
            assert!((passed - k as f64).abs() < 1e-8 * (1.0 + passed), "{passed} {k}");
        }
        assert!(points.len() > 60);
    }
}

//! Hybrid systems written by hand, against analytic solutions.

use std::cell::Cell;

use nalgebra::{SMatrix, SVector};
use pendulum_core::hybrid::{
    Constraint, Hybrid, HybridJacobian, Law, MAX_CONSTRAINTS, MeasureDerivatives, Response, ResponseDerivative, Status,
};
use pendulum_core::prelude::*;
use pendulum_core::stability::{Lyapunov, transition};
use pendulum_core::{Plant, PlantJacobian, Reason};

/// A ball of 1 kg above a floor.
struct Ball {
    restitution: f64,
    slow: f64,
}

const GRAVITY: f64 = 9.81;

impl System<f64, 2> for Ball {
    fn rhs(&self, t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        self.eval(t, x, &[0.0; MAX_CONSTRAINTS])
    }

    fn hybrid(&self) -> Option<&dyn Hybrid<f64, 2>> {
        Some(self)
    }
}

impl Plant<f64, 2> for Ball {
    type Given = [f64; MAX_CONSTRAINTS];

    fn eval(&self, _t: f64, x: &SVector<f64, 2>, forces: &[f64; MAX_CONSTRAINTS]) -> SVector<f64, 2> {
        SVector::from([x[1], forces[0] - GRAVITY])
    }

    fn constraints(&self) -> &[Constraint<'_>] {
        const {
            &[Constraint {
                name: "floor",
                rate: &[(1, 1)],
            }]
        }
    }

    fn laws(&self) -> [Law<f64>; MAX_CONSTRAINTS] {
        let mut laws = [Law::default(); MAX_CONSTRAINTS];
        laws[0] = Law {
            low: Some(0.0),
            restitution: self.restitution,
            slow: self.slow,
            ..Law::default()
        };
        laws
    }

    fn measures(&self, _t: f64, x: &SVector<f64, 2>) -> [[f64; 2]; MAX_CONSTRAINTS] {
        let mut measures = [[0.0; 2]; MAX_CONSTRAINTS];
        measures[0] = [x[0], x[1]];
        measures
    }

    fn response(&self, t: f64, x: &SVector<f64, 2>, forces: &[f64; MAX_CONSTRAINTS]) -> Response<f64, 2> {
        let mut response = Response::new(self.eval(t, x, forces));
        response.accelerations[0] = response.rates[1];
        response.columns[0] = SVector::from([0.0, 1.0]);
        response.matrix[0][0] = 1.0;
        response
    }
}

/// Runs a test for methods of all kinds, each with its name.
macro_rules! each {
    ($test:ident: $($method:expr;)*) => { $( $test(stringify!($method), &$method); )* };
}

#[test]
fn a_ball_rests_when_the_series_of_its_rebounds_ends() {
    fn bounces(name: &str, method: &impl Method<Ball, f64, 2>) {
        let ball = Ball {
            restitution: 0.8,
            slow: 0.0,
        };
        let solution = method.solve(&ball, 0.0, 5.0, [1.0, 0.0]).expect("regular");
        let fall = (2.0 / GRAVITY).sqrt();
        let (mut expected, mut flight) = (fall, 2.0 * fall);
        let (first, rest) = solution.modes().split_first().expect("a mode");
        let ((rests, last), rebounds) = rest.split_last().expect("a mode");
        assert!(first.0 == 0.0 && !first.1.is_held(0) && rebounds.len() > 60, "{name}");
        for (t, mode) in rebounds {
            assert!(
                (t - expected).abs() < 1e-12 && !mode.is_held(0),
                "{name}: {t} for {expected}"
            );
            flight *= 0.8;
            expected += flight;
        }
        assert!((rests - 9.0 * fall).abs() < 1e-12, "{name}: {rests}");
        assert_eq!(last.0[0], Status::Low);
        assert_eq!(solution.end(), SVector::from([0.0, 0.0]), "{name}");
        let lowest = solution.x().iter().map(|x| x[0]).fold(f64::INFINITY, f64::min);
        assert!(lowest > -1e-14, "{name}: {lowest:e}");
    }
    each! { bounces:
        Rk4::new(0.01);
        Rk45::new().rtol(1e-12).atol(1e-12);
        Tsit5::new().rtol(1e-12).atol(1e-12);
        Vern7::new().rtol(1e-12).atol(1e-12);
        Vern9::new();
    }
}

#[test]
fn slow_impacts_do_not_rebound_and_elastic_ones_go_on() {
    let slow = Ball {
        restitution: 0.5,
        slow: 3.0,
    };
    let solution = Tsit5::new().solve(&slow, 0.0, 5.0, [1.0, 0.0]).expect("regular");
    // impact speeds 4.43 m/s, and 2.2 m/s, which is below `slow`
    assert_eq!(solution.modes().len(), 3);
    assert_eq!(solution.end(), SVector::from([0.0, 0.0]));
    let elastic = Ball {
        restitution: 1.0,
        slow: 0.0,
    };
    let solution = Vern9::new().solve(&elastic, 0.0, 100.0, [1.0, 0.0]).expect("regular");
    for x in solution.x() {
        let energy = GRAVITY * x[0] + x[1] * x[1] / 2.0;
        assert!((energy - GRAVITY).abs() < 1e-11, "{energy}");
    }
    assert_eq!(
        solution.modes().len(),
        1 + (50.0 * (GRAVITY / 2.0).sqrt() + 0.5) as usize
    );
}

/// A ball whose evaluations are not finite after the first `good` ones.
struct Failing {
    ball: Ball,
    good: usize,
    evaluations: Cell<usize>,
}

impl System<f64, 2> for Failing {
    fn rhs(&self, t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        self.eval(t, x, &[0.0; MAX_CONSTRAINTS])
    }

    fn hybrid(&self) -> Option<&dyn Hybrid<f64, 2>> {
        Some(self)
    }
}

impl Plant<f64, 2> for Failing {
    type Given = [f64; MAX_CONSTRAINTS];

    fn eval(&self, t: f64, x: &SVector<f64, 2>, forces: &[f64; MAX_CONSTRAINTS]) -> SVector<f64, 2> {
        self.evaluations.set(self.evaluations.get() + 1);
        let is_bad = self.evaluations.get() > self.good;
        self.ball.eval(t, x, forces) * if is_bad { f64::NAN } else { 1.0 }
    }

    fn constraints(&self) -> &[Constraint<'_>] {
        self.ball.constraints()
    }

    fn laws(&self) -> [Law<f64>; MAX_CONSTRAINTS] {
        self.ball.laws()
    }

    fn measures(&self, t: f64, x: &SVector<f64, 2>) -> [[f64; 2]; MAX_CONSTRAINTS] {
        self.ball.measures(t, x)
    }

    fn response(&self, t: f64, x: &SVector<f64, 2>, forces: &[f64; MAX_CONSTRAINTS]) -> Response<f64, 2> {
        self.ball.response(t, x, forces)
    }
}

/// A step with a mode switch is retaken up to the switch. If the retake fails, the original step still locates the
/// switch.
#[test]
fn a_good_step_that_cannot_be_taken_again_is_kept() {
    // one evaluation at the start, and four in the step
    for good in 5..9 {
        let ball = Ball {
            restitution: 0.5,
            slow: 0.0,
        };
        let evaluations = Cell::new(0);
        let ball = Failing {
            ball,
            good,
            evaluations,
        };
        let mut stepper = Rk4::new(0.7).stepper(&ball, 0.0, 0.7, [1.0, 0.0]).expect("a start");
        let hit = stepper.step().expect("a good step").expect("a step");
        assert!(ball.evaluations.get() > good);
        assert!((hit.t1 - (2.0 / GRAVITY).sqrt()).abs() < 1e-14, "{good}: {}", hit.t1);
    }
}

/// Derivatives of a measure equal to the state.
fn identity() -> MeasureDerivatives<f64, 2> {
    let mut derivatives = MeasureDerivatives {
        by_state: [[SVector::zeros(); 2]; MAX_CONSTRAINTS],
        by_time: [[0.0; 2]; MAX_CONSTRAINTS],
    };
    derivatives.by_state[0] = [SVector::from([1.0, 0.0]), SVector::from([0.0, 1.0])];
    derivatives
}

/// A block on a belt that runs at 1 m/s, held by a spring to the ground. The state is its position on the belt and the
/// rate of this position.
struct Belt {
    mass: f64,
    stiffness: f64,
    slipping: f64,
    sticking: f64,
}

impl System<f64, 2> for Belt {
    fn rhs(&self, t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        self.eval(t, x, &[0.0; MAX_CONSTRAINTS])
    }

    fn hybrid(&self) -> Option<&dyn Hybrid<f64, 2>> {
        Some(self)
    }
}

impl Jacobian<f64, 2> for Belt {
    fn jacobian(&self, t: f64, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        self.eval_with_jacobian(t, x, &[0.0; MAX_CONSTRAINTS]).1
    }

    fn hybrid_jacobian(&self) -> Option<&dyn HybridJacobian<f64, 2>> {
        Some(self)
    }
}

impl Plant<f64, 2> for Belt {
    type Given = [f64; MAX_CONSTRAINTS];

    fn eval(&self, t: f64, x: &SVector<f64, 2>, forces: &[f64; MAX_CONSTRAINTS]) -> SVector<f64, 2> {
        SVector::from([x[1], (forces[0] - self.stiffness * (x[0] + t)) / self.mass])
    }

    fn constraints(&self) -> &[Constraint<'_>] {
        const {
            &[Constraint {
                name: "block",
                rate: &[(1, 1)],
            }]
        }
    }

    fn laws(&self) -> [Law<f64>; MAX_CONSTRAINTS] {
        let mut laws = [Law::default(); MAX_CONSTRAINTS];
        laws[0] = Law {
            slipping: self.slipping,
            sticking: self.sticking,
            ..Law::default()
        };
        laws
    }

    fn measures(&self, _t: f64, x: &SVector<f64, 2>) -> [[f64; 2]; MAX_CONSTRAINTS] {
        let mut measures = [[0.0; 2]; MAX_CONSTRAINTS];
        measures[0] = [x[0], x[1]];
        measures
    }

    fn response(&self, t: f64, x: &SVector<f64, 2>, forces: &[f64; MAX_CONSTRAINTS]) -> Response<f64, 2> {
        let mut response = Response::new(self.eval(t, x, forces));
        response.accelerations[0] = response.rates[1];
        response.columns[0] = SVector::from([0.0, 1.0 / self.mass]);
        response.matrix[0][0] = 1.0 / self.mass;
        response
    }
}

impl PlantJacobian<f64, 2> for Belt {
    fn eval_with_jacobian(
        &self,
        t: f64,
        x: &SVector<f64, 2>,
        forces: &[f64; MAX_CONSTRAINTS],
    ) -> (SVector<f64, 2>, SMatrix<f64, 2, 2>) {
        (
            self.eval(t, x, forces),
            SMatrix::from([[0.0, -self.stiffness / self.mass], [1.0, 0.0]]),
        )
    }

    fn response_derivative(
        &self,
        t: f64,
        x: &SVector<f64, 2>,
        forces: &[f64; MAX_CONSTRAINTS],
    ) -> ResponseDerivative<f64, 2> {
        let slope = -self.stiffness / self.mass;
        let mut derivative = ResponseDerivative {
            response: self.response(t, x, forces),
            rates: self.eval_with_jacobian(t, x, forces).1,
            accelerations: [SVector::zeros(); MAX_CONSTRAINTS],
            rates_by_time: SVector::from([0.0, slope]),
            accelerations_by_time: [0.0; MAX_CONSTRAINTS],
        };
        derivative.accelerations[0][0] = slope;
        derivative.accelerations_by_time[0] = slope;
        derivative
    }

    fn measure_derivatives(&self, _t: f64, _x: &SVector<f64, 2>) -> MeasureDerivatives<f64, 2> {
        identity()
    }
}

#[test]
fn a_block_on_a_belt_sticks_and_slips_as_the_analytic_solution() {
    fn sticks(name: &str, method: &impl Method<Belt, f64, 2>, tolerance: f64) {
        let belt = Belt {
            mass: 2.0,
            stiffness: 50.0,
            slipping: 10.0,
            sticking: 16.0,
        };
        let solution = method
            .solve(&belt, 0.0, 20.0, [0.0, 0.0])
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        let w = (belt.stiffness / belt.mass).sqrt();
        let beyond = (belt.sticking - belt.slipping) / belt.stiffness;
        // from the largest extension it slips back until it reaches the belt velocity
        let angle = 2.0 * (std::f64::consts::PI - (beyond * w).atan());
        let (slips, least) = (
            angle / w,
            belt.slipping / belt.stiffness + beyond * angle.cos() + angle.sin() / w,
        );
        let most = belt.sticking / belt.stiffness;
        let mut expected = most;
        let modes = &solution.modes()[1..];
        assert!(modes.len() > 20, "{name}: {} modes", modes.len());
        for (n, (t, mode)) in modes.iter().enumerate() {
            assert!(
                (t - expected).abs() < tolerance,
                "{name}: mode {n} from {t}, not {expected}, {:e}",
                t - expected
            );
            assert_eq!(mode.0[0], [Status::Backward, Status::Stuck][n % 2], "{name}");
            expected += if n % 2 == 0 { slips } else { most - least };
        }
        // exactly at rest on the belt while sticking
        for pair in solution.modes().windows(2).filter(|pair| pair[0].1.is_held(0)) {
            let middle = solution.at(0.5 * (pair[0].0 + pair[1].0)).expect("inside");
            assert_eq!(middle[1], 0.0, "{name}");
        }
    }
    sticks("Rk4", &Rk4::new(1e-3), 1e-10);
    sticks("Tsit5", &Tsit5::new().rtol(1e-13).atol(1e-13), 1e-12);
    sticks("Vern9", &Vern9::new().rtol(1e-13).atol(1e-13), 1e-12);
    sticks("Rodas5P", &Rodas5P::new().rtol(1e-12).atol(1e-12), 1e-10);
    sticks("Radau5", &Radau5::new().rtol(1e-12).atol(1e-12), 1e-10);
    sticks("Auto", &Auto::new().rtol(1e-12).atol(1e-12), 1e-10);
}

impl Jacobian<f64, 2> for Ball {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        SMatrix::from([[0.0, 0.0], [1.0, 0.0]])
    }

    fn hybrid_jacobian(&self) -> Option<&dyn HybridJacobian<f64, 2>> {
        Some(self)
    }
}

impl PlantJacobian<f64, 2> for Ball {
    fn eval_with_jacobian(
        &self,
        t: f64,
        x: &SVector<f64, 2>,
        forces: &[f64; MAX_CONSTRAINTS],
    ) -> (SVector<f64, 2>, SMatrix<f64, 2, 2>) {
        (self.eval(t, x, forces), self.jacobian(t, x))
    }

    fn response_derivative(
        &self,
        t: f64,
        x: &SVector<f64, 2>,
        forces: &[f64; MAX_CONSTRAINTS],
    ) -> ResponseDerivative<f64, 2> {
        ResponseDerivative {
            response: self.response(t, x, forces),
            rates: self.jacobian(t, x),
            accelerations: [SVector::zeros(); MAX_CONSTRAINTS],
            rates_by_time: SVector::zeros(),
            accelerations_by_time: [0.0; MAX_CONSTRAINTS],
        }
    }

    fn measure_derivatives(&self, _t: f64, _x: &SVector<f64, 2>) -> MeasureDerivatives<f64, 2> {
        identity()
    }
}

/// Derivative of the state at `t1` with respect to the state at 0, by differences, where it is defined.
fn by_differences<S: System<f64, 2>>(system: &S, t1: f64, x: SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
    let end = |x: SVector<f64, 2>| {
        Vern9::new()
            .rtol(1e-13)
            .atol(1e-13)
            .solve(system, 0.0, t1, x)
            .expect("regular")
            .end()
    };
    let reach = 1e-5;
    let columns = [0, 1].map(|j| {
        let mut step = SVector::zeros();
        step[j] = reach;
        (end(x + step) - end(x - step)) / (2.0 * reach)
    });
    SMatrix::from_columns(&columns)
}

#[test]
fn tangents_jump_as_neighbours_do() {
    let ball = Ball {
        restitution: 0.8,
        slow: 0.0,
    };
    for t in [0.3, 1.0, 1.6, 3.0] {
        let start = SVector::from([1.0, 0.2]);
        let (_, matrix) = transition(&ball, 0.0, t, start, 1e-12).expect("regular");
        let expected = by_differences(&ball, t, start);
        assert!(
            (matrix - expected).norm() < 1e-7 * expected.norm(),
            "{t}: {matrix} for {expected}"
        );
    }
    let belt = Belt {
        mass: 2.0,
        stiffness: 50.0,
        slipping: 10.0,
        sticking: 16.0,
    };
    for (t, start) in [(0.6, [0.1, -0.3]), (2.5, [0.0, -0.1]), (0.3, [0.2, 0.5])] {
        let start = SVector::from(start);
        let (_, matrix) = transition(&belt, 0.0, t, start, 1e-12).expect("regular");
        let expected = by_differences(&belt, t, start);
        assert!((matrix - expected).norm() < 1e-7, "{t}: {matrix} for {expected}");
    }
    // neighbours of a sticking state stick at once, and their initial rates no longer matter
    let (_, matrix) = transition(&belt, 0.0, 0.2, [0.0, 0.0], 1e-12).expect("regular");
    assert_eq!(matrix, SMatrix::from([[1.0, 0.0], [0.0, 0.0]]));
}

#[test]
fn what_sticks_forgets_where_it_came_from() {
    let belt = Belt {
        mass: 2.0,
        stiffness: 50.0,
        slipping: 10.0,
        sticking: 16.0,
    };
    let exponents = Lyapunov::new()
        .duration(100.0)
        .exponents::<2, _>(&belt, [0.0, 0.0])
        .expect("regular");
    // no growth or decay except within each cycle: in total a factor of order one
    assert!(exponents.values[0].abs() < 1.0 / 100.0, "{:?}", exponents.values);
    assert_eq!(exponents.values[1], f64::NEG_INFINITY);
}

/// Two carts on one rough track, with a spring between them that is longer than their minimum distance, and a spring to
/// the ground.
struct Carts {
    masses: [f64; 2],
    /// Springs to the ground and between the carts.
    stiffness: [f64; 2],
    friction: [f64; 2],
    restitution: f64,
}

/// Minimum distance of the carts.
const CLOSE: f64 = 0.5;

impl System<f64, 4> for Carts {
    fn rhs(&self, t: f64, x: &SVector<f64, 4>) -> SVector<f64, 4> {
        self.eval(t, x, &[0.0; MAX_CONSTRAINTS])
    }

    fn hybrid(&self) -> Option<&dyn Hybrid<f64, 4>> {
        Some(self)
    }
}

impl Plant<f64, 4> for Carts {
    type Given = [f64; MAX_CONSTRAINTS];

    fn eval(&self, _t: f64, x: &SVector<f64, 4>, forces: &[f64; MAX_CONSTRAINTS]) -> SVector<f64, 4> {
        let [to_ground, between] = [self.stiffness[0] * x[0], self.stiffness[1] * (x[1] - x[0] - 1.0)];
        let first = forces[0] - forces[2] - to_ground + between;
        let second = forces[1] + forces[2] - between;
        SVector::from([x[2], x[3], first / self.masses[0], second / self.masses[1]])
    }

    fn constraints(&self) -> &[Constraint<'_>] {
        const {
            &[
                Constraint {
                    name: "first",
                    rate: &[(2, 1)],
                },
                Constraint {
                    name: "second",
                    rate: &[(3, 1)],
                },
                Constraint {
                    name: "buffer",
                    rate: &[(2, -1), (3, 1)],
                },
            ]
        }
    }

    fn laws(&self) -> [Law<f64>; MAX_CONSTRAINTS] {
        let mut laws = [Law::default(); MAX_CONSTRAINTS];
        for (law, friction) in laws.iter_mut().zip(self.friction) {
            (law.slipping, law.sticking) = (friction, 1.2 * friction);
        }
        laws[2] = Law {
            low: Some(CLOSE),
            restitution: self.restitution,
            ..Law::default()
        };
        laws
    }

    fn measures(&self, _t: f64, x: &SVector<f64, 4>) -> [[f64; 2]; MAX_CONSTRAINTS] {
        let mut measures = [[0.0; 2]; MAX_CONSTRAINTS];
        measures[..3].copy_from_slice(&[[x[0], x[2]], [x[1], x[3]], [x[1] - x[0], x[3] - x[2]]]);
        measures
    }

    fn response(&self, t: f64, x: &SVector<f64, 4>, forces: &[f64; MAX_CONSTRAINTS]) -> Response<f64, 4> {
        let mut response = Response::new(self.eval(t, x, forces));
        let [a, b] = self.masses.map(|mass| 1.0 / mass);
        let rates = response.rates;
        response.accelerations[..3].copy_from_slice(&[rates[2], rates[3], rates[3] - rates[2]]);
        let columns = [[0.0, 0.0, a, 0.0], [0.0, 0.0, 0.0, b], [0.0, 0.0, -a, b]].map(SVector::from);
        response.columns[..3].copy_from_slice(&columns);
        for (row, entries) in response
            .matrix
            .iter_mut()
            .zip([[a, 0.0, -a], [0.0, b, b], [-a, b, a + b]])
        {
            row[..3].copy_from_slice(&entries);
        }
        response
    }
}

impl Carts {
    fn energy(&self, x: &SVector<f64, 4>) -> f64 {
        let [to_ground, between] = [x[0], x[1] - x[0] - 1.0];
        let kinetic = self.masses[0] * x[2] * x[2] + self.masses[1] * x[3] * x[3];
        0.5 * (kinetic + self.stiffness[0] * to_ground * to_ground + self.stiffness[1] * between * between)
    }
}

#[test]
fn carts_from_anywhere_lose_energy_and_come_to_rest() {
    let mut drawn = 0.0_f64;
    for case in 0..60 {
        let mut between = |low: f64, high: f64| {
            drawn += 1.0;
            low + (high - low) * (1e4 * drawn.sin()).rem_euclid(1.0)
        };
        let carts = Carts {
            masses: [between(0.2, 5.0), between(0.2, 5.0)],
            stiffness: [between(1.0, 50.0), between(0.0, 50.0)],
            friction: [between(0.1, 2.0), between(0.1, 2.0)],
            restitution: [0.0, 0.3, 0.9, 1.0][case % 4],
        };
        let first = between(-1.0, 1.0);
        let start = [
            first,
            first + CLOSE + between(0.0, 1.0),
            between(-3.0, 3.0),
            between(-3.0, 3.0),
        ];
        let solution = Vern7::new()
            .rtol(1e-10)
            .atol(1e-10)
            .max_steps(3000)
            .solve(&carts, 0.0, 300.0, start);
        let solution = solution.unwrap_or_else(|error| panic!("case {case}: {error}"));
        let mut energy = f64::INFINITY;
        for (t, x) in solution.points() {
            let now = carts.energy(x);
            assert!(now <= energy + 1e-8, "case {case}: {now:e} at {t} after {energy:e}");
            energy = now;
            assert!(
                x[1] - x[0] >= CLOSE - 1e-13,
                "case {case}: {:e} at {t}",
                x[1] - x[0] - CLOSE
            );
        }
        let end = solution.end();
        assert_eq!(
            [end[2], end[3]],
            [0.0, 0.0],
            "case {case} after {:?}: {:?}",
            solution.statistics(),
            solution.modes().last()
        );
    }
}

/// The carts with reversed coordinates.
struct Mirrored(Carts);

impl System<f64, 4> for Mirrored {
    fn rhs(&self, t: f64, x: &SVector<f64, 4>) -> SVector<f64, 4> {
        self.eval(t, x, &[0.0; MAX_CONSTRAINTS])
    }

    fn hybrid(&self) -> Option<&dyn Hybrid<f64, 4>> {
        Some(self)
    }
}

impl Plant<f64, 4> for Mirrored {
    type Given = [f64; MAX_CONSTRAINTS];

    fn eval(&self, t: f64, x: &SVector<f64, 4>, forces: &[f64; MAX_CONSTRAINTS]) -> SVector<f64, 4> {
        -self.0.eval(t, &-x, forces)
    }

    fn constraints(&self) -> &[Constraint<'_>] {
        const {
            &[
                Constraint {
                    name: "first",
                    rate: &[(2, -1)],
                },
                Constraint {
                    name: "second",
                    rate: &[(3, -1)],
                },
                Constraint {
                    name: "buffer",
                    rate: &[(2, 1), (3, -1)],
                },
            ]
        }
    }

    fn laws(&self) -> [Law<f64>; MAX_CONSTRAINTS] {
        self.0.laws()
    }

    fn measures(&self, t: f64, x: &SVector<f64, 4>) -> [[f64; 2]; MAX_CONSTRAINTS] {
        self.0.measures(t, &-x)
    }

    fn response(&self, t: f64, x: &SVector<f64, 4>, forces: &[f64; MAX_CONSTRAINTS]) -> Response<f64, 4> {
        let response = self.0.response(t, &-x, forces);
        Response {
            rates: -response.rates,
            columns: response.columns.map(|column| -column),
            ..response
        }
    }
}

#[test]
fn the_signs_of_coordinates_make_no_difference() {
    for restitution in [0.0, 0.8] {
        let carts = || Carts {
            masses: [1.0, 2.5],
            stiffness: [20.0, 1.0],
            friction: [0.2, 0.1],
            restitution,
        };
        let method = Vern7::new().rtol(1e-10).atol(1e-10).max_steps(3000);
        let start = SVector::from([-2.0, -1.4, 0.5, -0.5]);
        let solution = method.solve(&carts(), 0.0, 30.0, start).expect("regular");
        let mirrored = method.solve(&Mirrored(carts()), 0.0, 30.0, -start).expect("regular");
        let touch = solution.modes().iter().any(|(_, mode)| mode.is_held(2));
        assert_eq!(touch, restitution == 0.0);
        assert_eq!(mirrored.modes(), solution.modes());
        assert_eq!(mirrored.end(), -solution.end());
    }
}

/// An inconsistent ball: forces change its rate by a wrong factor `moves`, or its gap is a wrong function `value` of
/// the height.
struct Wrong {
    ball: Ball,
    moves: f64,
    value: fn(f64) -> f64,
}

impl System<f64, 2> for Wrong {
    fn rhs(&self, t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        self.ball.rhs(t, x)
    }

    fn hybrid(&self) -> Option<&dyn Hybrid<f64, 2>> {
        Some(self)
    }
}

impl Plant<f64, 2> for Wrong {
    type Given = [f64; MAX_CONSTRAINTS];

    fn eval(&self, t: f64, x: &SVector<f64, 2>, forces: &[f64; MAX_CONSTRAINTS]) -> SVector<f64, 2> {
        self.ball.eval(t, x, forces)
    }

    fn constraints(&self) -> &[Constraint<'_>] {
        // a constraint that is not on a coordinate
        const {
            &[Constraint {
                name: "floor",
                rate: &[],
            }]
        }
    }

    fn laws(&self) -> [Law<f64>; MAX_CONSTRAINTS] {
        self.ball.laws()
    }

    fn measures(&self, t: f64, x: &SVector<f64, 2>) -> [[f64; 2]; MAX_CONSTRAINTS] {
        let mut measures = self.ball.measures(t, x);
        measures[0][0] = (self.value)(measures[0][0]);
        measures
    }

    fn response(&self, t: f64, x: &SVector<f64, 2>, forces: &[f64; MAX_CONSTRAINTS]) -> Response<f64, 2> {
        let mut response = self.ball.response(t, x, forces);
        response.columns[0] *= self.moves;
        response
    }
}

#[test]
fn failures_name_what_failed() {
    let ball = || Ball {
        restitution: 0.8,
        slow: 0.0,
    };
    let method = Tsit5::new();
    let failure = method.stepper(&ball(), 0.0, 1.0, [-1e-9, 0.0]).err();
    let expected = Reason::BeyondLimit {
        constraint: "floor".into(),
        value: -1e-9,
        limit: 0.0,
    };
    assert_eq!(failure, Some(expected));
    let backward = method.stepper(&ball(), 1.0, 0.0, [1.0, 0.0]).err();
    assert!(
        matches!(backward, Some(Reason::InvalidInput { what: "t1", .. })),
        "{backward:?}"
    );
    // an impact without effect recurs at once
    let unmoved = Wrong {
        ball: ball(),
        moves: 0.0,
        value: |height| height,
    };
    let failure = method
        .stepper(&unmoved, 1e6, 1e6 + 1.0, [1.0, 0.0])
        .and_then(|mut stepper| stepper.run());
    assert_eq!(
        failure,
        Err(Reason::ModesAccumulate {
            constraint: "floor".into()
        })
    );
    let torn = Wrong {
        ball: ball(),
        moves: 1.0,
        value: |height| (height - 0.5).sqrt(),
    };
    let failure = method
        .stepper(&torn, 0.0, 1.0, [1.0, 0.0])
        .and_then(|mut stepper| stepper.run());
    assert!(
        matches!(
            failure,
            Err(Reason::ConstraintNotFinite { constraint, .. }) if constraint == "floor"
        ),
        "{failure:?}"
    );
}

#[test]
fn a_restart_that_fails_changes_nothing() {
    let belt = Belt {
        mass: 2.0,
        stiffness: 50.0,
        slipping: 10.0,
        sticking: 16.0,
    };
    let method = Tsit5::new();
    let mut stepper = method.stepper(&belt, 0.0, 1.0, [0.0, 0.0]).expect("a start");
    stepper.step().expect("regular");
    let before = (stepper.t(), stepper.x(), stepper.mode());
    assert!(stepper.restart(before.0, [1e308, 1.0].into()).is_err());
    assert_eq!((stepper.t(), stepper.x(), stepper.mode()), before);
    let undisturbed = method.solve(&belt, 0.0, 1.0, [0.0, 0.0]).expect("regular");
    let end = stepper.run().expect("regular");
    assert!((end - undisturbed.end()).amax() < 1e-6, "{end} {}", undisturbed.end());
}

/// Rebounds too low to resolve are judged relative to the largest height since the last contact.
#[test]
fn a_small_hop_rebounds_as_often_as_a_large_one() {
    let ball = Ball {
        restitution: 0.8,
        slow: 0.0,
    };
    let hop = Event::new(|t, _: &SVector<f64, 2>| t - 5.0).reset(|_, _| [0.0, 1e-4].into());
    let method = Vern9::new().rtol(1e-13).atol(1e-13);
    let solution = method.solve_with(&ball, 0.0, 6.0, [1.0, 0.0], &[hop]).expect("regular");
    let modes = solution.modes();
    let large = modes.iter().filter(|(t, _)| *t < 5.0).count();
    let small = modes.iter().filter(|(t, _)| *t >= 5.0).count();
    assert!(large.abs_diff(small) <= 1, "{large} and {small}");
    let (rests, mode) = modes[modes.len() - 1];
    assert!(mode.is_held(0));
    let expected = 5.0 + 2e-4 / GRAVITY / (1.0 - 0.8);
    assert!((rests - expected).abs() < 1e-12, "{rests} for {expected}");
}

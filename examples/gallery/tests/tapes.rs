//! Tapes of every system of the gallery against its compiled code, bit for bit.

use std::sync::Arc;

use gallery::SYSTEMS;
use nalgebra::SVector;
use pendulum_core::hybrid::{Hybrid, Response};
use pendulum_core::prelude::*;
use pendulum_core::real::Fused;
use pendulum_core::shapes::Shapes;
use pendulum_core::tape::{Given, HybridModel, Tape};
use pendulum_core::{Cast, Float, Parametric};
use testbed::random::Random;

/// Number of random states.
const STATES: usize = 1000;

/// Numbers of both sides; those that are not numbers are all alike.
#[derive(Default)]
struct Bits([Vec<u64>; 2]);

impl Bits {
    fn add<T: Float>(&mut self, side: usize, numbers: impl IntoIterator<Item = T>) {
        let bits = numbers.into_iter().map(|number| match number.to_f64() {
            number if number.is_nan() => u64::MAX,
            number => number.to_bits(),
        });
        self.0[side].extend(bits);
    }

    fn name(&mut self, side: usize, name: &str) {
        self.0[side].extend(name.bytes().map(u64::from));
    }

    fn assert_same(&self, name: &str) {
        let [compiled, tape] = &self.0;
        assert!(
            !compiled.is_empty() && compiled.iter().any(|&bits| bits != u64::MAX),
            "{name}"
        );
        assert_eq!(compiled.len(), tape.len(), "{name}");
        let differing = compiled.iter().zip(tape).filter(|(a, b)| a != b).count();
        assert_eq!(differing, 0, "{name}: of {} numbers", compiled.len());
    }
}

/// Times and states at random.
fn states<const N: usize>() -> impl Iterator<Item = (f64, SVector<f64, N>)> {
    let mut random = Random::new(17);
    (0..STATES).map(move |_| {
        let x = SVector::from_fn(|_, _| random.between(-1.5, 1.5));
        (random.between(0.0, 10.0), x)
    })
}

/// Model of the tape of a declaration in the gallery.
fn tape<M: Parametric<N, P>, const N: usize, const P: usize>(name: &str, compiled: &M) -> HybridModel<f64, N> {
    let head = format!("pub {name} {{");
    let declarations = SYSTEMS.iter().flat_map(|system| system.declarations());
    let declaration = declarations
        .into_iter()
        .find(|text| text.contains(&head))
        .expect("it is declared");
    let inside = declaration
        .trim()
        .trim_start_matches("mechanism! {")
        .trim_end_matches('}');
    let program = pendulum_codegen::program(inside.parse().expect("tokens")).expect(name);
    let tape: Tape = pendulum_codegen::tape(&program).parse().expect(name);
    Arc::new(tape).model(&compiled.parameters()).expect(name)
}

/// Compares the motion in a number type.
fn motion<T: Float, const N: usize>(name: &str, compiled: &impl System<T, N>, tape: &HybridModel<T, N>) {
    let mut bits = Bits::default();
    assert_eq!(compiled.layout(), System::layout(tape), "{name}");
    for (t, x) in states::<N>() {
        let (t, x) = (T::from_f64(t), x.map(T::from_f64));
        let systems: [&dyn System<T, N>; 2] = [compiled, tape];
        for (side, system) in systems.into_iter().enumerate() {
            bits.add(side, system.rhs(t, &x).data.0[0]);
            let mut projected = x;
            system.project(t, &mut projected);
            bits.add(side, projected.data.0[0]);
            system.margins(t, &x, &mut |names, margin| {
                bits.name(side, &names.concat());
                bits.add(side, margin);
            });
            system.gaps(t, &x, &mut |names, gap| {
                bits.name(side, &names.concat());
                bits.add(side, gap);
            });
            system.each_output(t, &x, &mut |name, output| {
                bits.name(side, name);
                bits.add(side, [output]);
            });
            if let Some(system) = system.hybrid() {
                of_modes(&mut bits, side, system, t, &x);
            }
        }
    }
    bits.assert_same(name);
}

/// Constraints, their laws, and the response to forces along them.
fn of_modes<T: Float, const N: usize>(
    bits: &mut Bits,
    side: usize,
    system: &dyn Hybrid<T, N>,
    t: T,
    x: &SVector<T, N>,
) {
    let forces = [0.3, -0.2, 0.7, 0.1, -0.5, 0.4, 0.9, -0.8].map(T::from_f64);
    for constraint in system.constraints() {
        bits.name(side, constraint.name);
        bits.add(
            side,
            constraint
                .rate
                .iter()
                .map(|&(component, sign)| component as f64 + f64::from(sign)),
        );
    }
    for law in system.laws() {
        let limits = [law.low, law.high].into_iter().flatten();
        bits.add(
            side,
            [law.slipping, law.sticking, law.restitution, law.slow]
                .into_iter()
                .chain(limits),
        );
    }
    bits.add(side, [system.dof() as f64]);
    bits.add(side, system.measures(t, x).into_iter().flatten());
    response(bits, side, &system.response(t, x, &forces));
}

fn response<T: Float, const N: usize>(bits: &mut Bits, side: usize, response: &Response<T, N>) {
    bits.add(side, response.rates.data.0[0]);
    bits.add(side, response.accelerations);
    bits.add(side, response.columns.into_iter().flat_map(|column| column.data.0[0]));
    bits.add(side, response.matrix.into_iter().flatten());
}

fn jacobian<T: Float, const N: usize>(name: &str, compiled: &impl Jacobian<T, N>, tape: &HybridModel<T, N>) {
    let mut bits = Bits::default();
    for (t, x) in states::<N>() {
        let (t, x) = (T::from_f64(t), x.map(T::from_f64));
        let systems: [&dyn Jacobian<T, N>; 2] = [compiled, tape];
        for (side, system) in systems.into_iter().enumerate() {
            let (rhs, jacobian) = system.rhs_and_jacobian(t, &x);
            bits.add(side, rhs.data.0[0]);
            bits.add(side, jacobian.data.0.into_iter().flatten());
            bits.add(side, system.time_derivative(t, &x).data.0[0]);
        }
    }
    bits.assert_same(name);
}

fn energy<T: Float, const N: usize>(name: &str, compiled: &impl Energy<T, N>, tape: &HybridModel<T, N>) {
    let mut bits = Bits::default();
    for (t, x) in states::<N>() {
        let (t, x) = (T::from_f64(t), x.map(T::from_f64));
        bits.add(0, [compiled.kinetic(t, &x), compiled.potential(t, &x)]);
        bits.add(1, [tape.kinetic(t, &x), tape.potential(t, &x)]);
    }
    bits.assert_same(name);
}

fn shapes<const N: usize>(name: &str, compiled: &impl Shapes<N>, tape: &HybridModel<f64, N>) {
    assert!(!compiled.shapes(0.0, &SVector::zeros()).is_empty(), "{name}");
    for (t, x) in states::<N>() {
        // those that are not numbers are unequal to themselves
        let text = |shapes: Vec<_>| format!("{shapes:?}");
        assert_eq!(text(compiled.shapes(t, &x)), text(tape.shapes(t, &x)), "{name}");
    }
}

/// Compares a routine that is no function of a trait.
fn routine<I: IntoIterator<Item = f64>, const N: usize>(
    name: &str,
    tape: &HybridModel<f64, N>,
    compiled: impl Fn(f64, &SVector<f64, N>) -> I,
) {
    let routines = tape.tape().routines();
    let index = routines.iter().position(|routine| routine.name() == name).expect(name);
    let mut results = vec![0.0; routines[index].results()];
    let mut bits = Bits::default();
    for (t, x) in states::<N>() {
        tape.evaluate(index, t, &x, &Given::default(), &mut results);
        bits.add(0, compiled(t, &x));
        bits.add(1, results.iter().copied());
    }
    bits.assert_same(name);
}

/// Compares the motion of systems of the gallery in two number types, and what else they have; lists their names.
macro_rules! check {
    ($($module:ident::$name:ident ($($function:ident)*) [$($routine:ident)*] $($shapes:ident)?,)*) => {[$({
        let name = stringify!($name);
        let compiled = gallery::$module::$name::new(Default::default()).expect(name);
        let tape = tape(name, &compiled);
        let in_fused = (compiled.cast::<Fused<f64>>(), tape.cast::<Fused<f64>>());
        motion(name, &compiled, &tape);
        motion(name, &in_fused.0, &in_fused.1);
        $($shapes(name, &compiled, &tape);)?
        $(
            $function(name, &compiled, &tape);
            $function(name, &in_fused.0, &in_fused.1);
        )*
        $(routine(stringify!($routine), &tape, |t, x| entries(&compiled.$routine(t, x)));)*
        name
    }),*]};
}

/// Entries of a vector, or of the upper triangle of a symmetric matrix.
fn entries<const R: usize, const C: usize>(of: &SMatrix<f64, R, C>) -> Vec<f64> {
    let triangle = |i: usize| if C == 1 { 0..1 } else { i..C };
    (0..R).flat_map(|i| triangle(i).map(move |j| of[(i, j)])).collect()
}

#[test]
fn every_system_has_the_bits_of_its_tape() {
    let checked = check! {
        arm::Arm (energy) [mass_matrix bias] shapes,
        asymmetric::Asymmetric (jacobian energy) [] shapes,
        ball_pendulum::BallPendulum (jacobian energy) [momentum] shapes,
        bars_and_squares::DoubleBar (jacobian) [mass_matrix],
        bars_and_squares::DoubleSquare (jacobian energy) [mass_matrix] shapes,
        bennett::Bennett (jacobian energy) [] shapes,
        bouncing_ball::BouncingBall (energy) [] shapes,
        cart_pole::CartPole (energy) [mass_matrix] shapes,
        coupled_pendulums::Coupled (jacobian energy) [] shapes,
        cubic::Cubic (energy) [] shapes,
        double_four_bar::DoubleFourBar (jacobian energy) [] shapes,
        driven_pivot::DrivenPivot (jacobian energy) [drive_forces] shapes,
        five_bar::FiveBar (jacobian energy) [] shapes,
        four_bar::FourBar (jacobian energy) [] shapes,
        furuta::Furuta (energy) [] shapes,
        kapitza::Kapitza (jacobian energy) [drive_forces] shapes,
        leg::Leg (energy) [drive_forces] shapes,
        magnets::Magnets (jacobian energy) [] shapes,
        motor::Motor (jacobian energy) [] shapes,
        point_masses::PointMasses (jacobian energy) [] shapes,
        quadruped::Quadruped (energy) [] shapes,
        rocking_block::RockingBlock (energy) [] shapes,
        rods_and_wall::RodsAndWall (energy) [] shapes,
        slider_crank::SliderCrank (jacobian energy) [] shapes,
        spring_suspended::SpringSuspended (jacobian energy) [] shapes,
        squeezer::Squeezer (jacobian energy) [] shapes,
        stick_slip::StickSlip (energy) [drive_forces] shapes,
        thrown_die::ThrownDie (energy) [] shapes,
        triple::Triple (energy) [] shapes,
        tumbling_body::TumblingBody (jacobian energy) [] shapes,
        two_bodies::TwoBodies (energy) [] shapes,
    };
    let declarations = SYSTEMS.iter().map(|system| system.declarations().len());
    assert_eq!(checked.len(), declarations.sum::<usize>(), "{checked:?}");
}

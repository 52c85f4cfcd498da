//! Results to the last bit, on every machine and in every build: their digests against those in `bits.txt`, and in
//! fused arithmetic against those in `bits_fused.txt`.
//!
//! `cargo test` compares the digests of an unoptimised build. `.ci/run` also compares those of an optimised build, and
//! of both for all instruction sets of the machine.
//!
//! `UPDATE_EXPECT=1 cargo test -p tests --test bits` rewrites the digests. A change of the emitted code, or of a
//! method, may change them; nothing else should.
#![forbid(unsafe_code)]

use std::fmt::Write;

use expect_test::expect_file;
use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use pendulum_core::real::Fused;
use pendulum_core::real::lanes::{Isa, LaneElement};
use pendulum_core::{Canonical, Cast, Float, TaylorSeries};
use testbed::digest::Digest;
use testbed::mechanisms::*;
use testbed::random::Random;
use testbed::robots::*;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

mechanism! {
    /// Every available function.
    pub Functions {
        units: none,
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, taylor],
        body cart on ground {
            mass: 2,
            joint: prismatic(x),
            coordinate: s,
            spring: (3, 0.2),
            torque: -0.1 * tanh(5*qd) * abs(qd)^(1/3) * exp(-q^2) + tan(q/4) * ln(2 + q^2),
        }
        body rod on cart {
            solids: [rod(0.4, [0, 0, 0], [0, -0.7, 0])],
            joint: revolute(z),
            coordinate: angle,
            torque: 0.3 * sin(3*t) - 0.02 * dot(s) * atan2(sin(q), 2 + cos(q)) * sqrt(1 + qd^2),
        }
    }
}

mechanism! {
    /// Two rods with dry axles; the lower one rebounds from stops. See `DRY_START`.
    pub Dry {
        params { mu: N m = 1.5 }
        gravity: [0, -9.81, 0],
        shape rod { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: rod { joint: revolute(z), coordinate: a, dry_friction: mu, static_friction: 2*mu }
        body lower on upper: rod {
            joint: revolute(z) at [0, -1, 0], coordinate: b, dry_friction: 0.1, stop: [-1.5, 0.6] restitution(0.5),
        }
    }
}

/// Bytes of numbers. The conversion to `f64` is exact and one-to-one for both types.
fn bytes<T: Float>(numbers: impl IntoIterator<Item = T>) -> impl Iterator<Item = u8> {
    numbers
        .into_iter()
        .flat_map(|number| number.to_f64().to_bits().to_le_bytes())
}

/// Digests, a line for each function of each model and for each method.
#[derive(Default)]
struct Table(String);

impl Table {
    fn row(&mut self, subject: &str, what: &str, digest: &Digest) {
        writeln!(self.0, "{subject:<18}{what:<18}{:016x}", digest.value()).expect("text");
    }

    /// Digests a function of time and state at many states, some with angles of many turns.
    fn function<T: Float, const N: usize, I: IntoIterator<Item = T>>(
        &mut self,
        (model, function): (&str, &str),
        f: impl Fn(T, &SVector<T, N>) -> I,
    ) {
        let (mut random, mut digest) = (Random::new(1), Digest::default());
        for reach in [4.0, 4.0, 4.0, 4.0, 1e3, 2e5].into_iter().cycle().take(600) {
            let x = SVector::from_fn(|i, _| {
                let reach = if i < N / 2 { reach } else { 4.0 };
                T::from_f64(random.between(-reach, reach))
            });
            let values = f(T::from_f64(random.between(0.0, 10.0)), &x).into_iter();
            digest.add(bytes(
                values.inspect(|value| assert!(value.is_finite(), "{model} {function} at {x:?}")),
            ));
        }
        self.row(model, function, &digest);
    }

    fn motion<T: Float, S: Jacobian<T, N> + Energy<T, N>, const N: usize>(&mut self, name: &str, model: &S) {
        self.function((name, "rhs"), |t, x: &SVector<T, N>| model.rhs(t, x).data.0[0]);
        self.function((name, "jacobian"), |t, x: &SVector<T, N>| {
            let (rhs, jacobian) = model.rhs_and_jacobian(t, x);
            all(rhs).chain(all(jacobian)).chain(all(model.time_derivative(t, x)))
        });
        self.function((name, "energy"), |t, x: &SVector<T, N>| {
            [model.kinetic(t, x), model.potential(t, x)]
        });
    }

    fn canonical<T: Float, S: Canonical<T, N>, const N: usize>(&mut self, name: &str, model: &S) {
        self.function((name, "canonical"), |t, x: &SVector<T, N>| {
            let ((y, rates), (by_x, rates_by_x)) = (model.canonical(t, x), model.canonical_jacobian(t, x));
            all(y).chain(all(rates)).chain(all(by_x)).chain(all(rates_by_x))
        });
    }

    fn series<T: Float, S: TaylorSeries<T, N>, const N: usize>(&mut self, name: &str, model: &S) {
        self.function((name, "taylor"), |t, x: &SVector<T, N>| {
            let mut series = [*x; 13];
            model.series(t, &mut series, &mut model.workspace());
            series.into_iter().flat_map(all)
        });
    }

    /// Digests the state after a short motion.
    fn end<A, S, T, const N: usize>(
        &mut self,
        (model, method): (&str, &str),
        by: &A,
        system: &S,
        start: [f64; N],
    ) -> SVector<T, N>
    where
        A: Method<S, T, N>,
        S: System<T, N>,
        T: Float,
    {
        let span = [0.0, 1.0].map(T::from_f64);
        let end = by.stepper(system, span[0], span[1], start.map(T::from_f64));
        let end = end.and_then(|mut stepper| stepper.run()).expect("regular");
        let mut digest = Digest::default();
        digest.add(bytes(all(end)));
        self.row(model, method, &digest);
        end
    }

    /// Digests the final states in every lane of every instruction set.
    fn ensemble<A, S, T, const N: usize>(&mut self, names: (&str, &str), by: &A, model: &S, start: [f64; N])
    where
        A: Ensemble<S, T, N> + Method<S::In<T>, T, N>,
        S: Cast<N>,
        T: LaneElement,
    {
        let end = self.end(names, by, &model.cast::<T>(), start);
        let starts = [SVector::from(start.map(T::from_f64)); 17];
        for isa in Isa::available() {
            let models = std::slice::from_ref(model);
            let ends = by
                .ensemble_on(isa, models, T::from_f64(0.0), T::from_f64(1.0), &starts)
                .expect("regular");
            assert!(ends.iter().all(|other| *other == end), "{names:?} on {isa:?}");
        }
    }
}

/// Entries of a matrix, in column-major order.
fn all<T: Float, const R: usize, const C: usize>(matrix: SMatrix<T, R, C>) -> impl Iterator<Item = T> {
    matrix.data.0.into_iter().flatten()
}

const START: [f64; 4] = [2.0, 2.5, 0.0, 0.0];
/// Initial condition of `Dry`: the upper axle sticks, breaks loose, and sticks again after the lower rod hits its stop.
const DRY_START: [f64; 4] = [0.1, 0.3, 0.0, 3.0];

fn pendulum() -> DoublePendulum {
    DoublePendulum::new(DoublePendulumParams::default()).expect("physical")
}

/// Digests of motions by several methods.
macro_rules! rows {
    ($table:ident, $row:ident, $number:ident, $name:literal, $model:expr, $start:expr; $($method:expr),*) => { $( {
        let method = stringify!($method).split(':').next().unwrap_or_default();
        let method = format!("{method} in {}", stringify!($number));
        $table.$row::<_, _, $number, _>(($name, &method), &$method, $model, $start);
    } )* };
}

#[test]
fn are_those_of_every_machine_and_build() {
    let mut table = Table::default();
    functions(&mut table);
    models(&mut table);
    methods(&mut table);
    expect_file!["bits.txt"].assert_eq(&table.0);
}

type Fused64 = Fused<f64>;

#[test]
fn in_fused_arithmetic_too() {
    let mut table = Table::default();
    functions_of::<Fused64>(&mut table, "fused");
    let start = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let (model, arm) = (&pendulum(), &Ur5::new(Ur5Params {}).expect("physical"));
    let (fused, fused_arm) = (&model.cast::<Fused64>(), &arm.cast::<Fused64>());
    table.motion("DoublePendulum", fused);
    table.canonical("DoublePendulum", fused);
    table.series("DoublePendulum", fused);
    table.motion("Ur5", fused_arm);
    rows!(table, ensemble, Fused64, "DoublePendulum", model, START;
        Rk4::new(0.02), Rk45::new(), Vern9::new(), Taylor::new(), Rodas4::new(), Auto::new());
    rows!(table, end, Fused64, "DoublePendulum", fused, START; Radau5::new(), Gauss6::new(0.02));
    rows!(table, ensemble, Fused64, "Ur5", arm, start; Rk4::new(0.02));
    let dry = &Dry::new(DryParams::default()).expect("physical");
    rows!(table, ensemble, Fused64, "Dry", dry, DRY_START; Tsit5::new());
    expect_file!["bits_fused.txt"].assert_eq(&table.0);
}

/// Digests the functions of the number types alone, over a wider range.
fn functions(table: &mut Table) {
    functions_of::<f64>(table, "f64");
    functions_of::<f32>(table, "f32");
}

fn functions_of<T: Float>(table: &mut Table, name: &str) {
    macro_rules! each {
            ($($function:ident: $value:expr;)*) => { $(
                table.function((name, stringify!($function)), |_, x: &SVector<T, 2>| {
                    let function: fn(T, T) -> T = $value;
                    [function(x[0], x[1])]
                });
            )* };
        }
    each! {
        sin: |a, _| a.sin_cos().0;
        cos: |a, _| a.sin_cos().1;
        tan: |a, _| a.tan();
        exp: |_, b| (b * T::from_f64(20.0)).exp();
        ln: |a, _| (a.abs() + T::MIN_POSITIVE).ln();
        sqrt: |a, _| a.abs().sqrt();
        tanh: |_, b| b.tanh();
        atan2: |a, b| a.atan2(b);
        powf: |a, b| a.abs().powf(b);
    }
}

fn models(table: &mut Table) {
    let model = pendulum();
    table.motion("DoublePendulum", &model);
    table.canonical("DoublePendulum", &model);
    table.series("DoublePendulum", &model);
    let single = model.cast::<f32>();
    table.function(("DoublePendulum", "rhs in f32"), |t, x: &SVector<f32, 4>| {
        single.rhs(t, x).data.0[0]
    });
    let model = Functions::new(FunctionsParams {}).expect("physical");
    table.motion("Functions", &model);
    table.series("Functions", &model);
    macro_rules! mechanisms {
        ($($name:ident $($more:ident)?;)*) => { $( {
            let name = stringify!($name);
            let model = $name::new(Default::default()).expect("physical");
            table.motion(name, &model);
            $( table.$more(name, &model); )?
            table.function((name, "dynamics"), |t, x| {
                let (mass, bias, momentum) = (model.mass_matrix(t, x), model.bias(t, x), model.momentum(t, x));
                all(mass).chain(all(bias)).chain(all(momentum)).chain(all(model.inverse_dynamics(t, x, &bias)))
            });
        } )* };
    }
    mechanisms! {
        IrregularPlates canonical;
        Furuta canonical;
        Tree canonical;
        SpringPendulumRig canonical;
        Ur5 series;
    }
}

fn methods(table: &mut Table) {
    let model = &pendulum();
    rows!(table, ensemble, f64, "DoublePendulum", model, START; Rk4::new(0.02), Rk45::new());
    rows!(table, end, f64, "DoublePendulum", model, START; Tsit5::new(), Vern7::new(), Vern9::new(), Taylor::new());
    rows!(table, end, f64, "DoublePendulum", model, START; Rodas4::new(), Rodas5P::new(), Radau5::new(), Auto::new());
    rows!(table, end, f64, "DoublePendulum", model, START; Radau9::new(), Radau13::new());
    rows!(table, end, f64, "DoublePendulum", model, START; Gauss4::new(0.02), Gauss6::new(0.02), Gauss16::new(0.1));
    rows!(table, ensemble, f32, "DoublePendulum", model, START; Rk4::new(0.02));
    let single = &model.cast::<f32>();
    rows!(table, end, f32, "DoublePendulum", single, START; Rk45::new(), Taylor::new(), Radau5::new());
    let model = &Functions::new(FunctionsParams {}).expect("physical");
    let start = [0.3, 0.5, 1.0, 0.7];
    rows!(table, ensemble, f64, "Functions", model, start; Rk4::new(0.02));
    rows!(table, end, f64, "Functions", model, start; Rk45::new(), Radau5::new());
    let model = &Dry::new(DryParams::default()).expect("physical");
    let motion = Vern9::new().solve(model, 0.0, 1.0, DRY_START).expect("regular");
    let sticks = motion.modes().iter().filter(|(_, mode)| mode.is_held(0)).count();
    assert!(sticks == 2 && motion.x().iter().any(|x| x[1] == 0.6));
    rows!(table, ensemble, f64, "Dry", model, DRY_START; Tsit5::new());
    rows!(table, end, f64, "Dry", model, DRY_START; Vern9::new(), Rodas5P::new(), Rk4::new(0.02));
    let model = &Ur5::new(Ur5Params {}).expect("physical");
    let start = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    rows!(table, end, f64, "Ur5", model, start; Rk4::new(0.02));
}

//! Tapes against compiled code, bit for bit, and tapes that are none.
//!
//! The tests of the package `gallery` compare every system there.

use std::sync::Arc;

use nalgebra::SVector;
use pendulum_core::hybrid::{Hold, MAX_CONSTRAINTS};
use pendulum_core::inputs::TimeTable;
use pendulum_core::prelude::*;
use pendulum_core::real::Real;
use pendulum_core::real::lanes::{F64x4, Lanes};
use pendulum_core::sensitivity::{self, Variable};
use pendulum_core::tape::{Given, HybridModel, Model, ModelError, Tape};
use pendulum_core::{Canonical, Parametric, Plant, TaylorSeries, stability};
use testbed::random::Random;
use testbed::scenes::{DoublePendulum, DoublePendulumParams};
use testbed::source::{SCENES, declaration};

mechanism! {
    /// A rod with dry friction and a stop on a cart, and a moving wall.
    pub Constrained {
        params { mu: N m = 0.3 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, canonical, taylor],
        point tip on rod at [0, -1, 0],
        output height: tip.y,
        wall side { gap: 2 - tip.x + 0.125 m/s^2*t^2, restitution: 0.5 }
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s }
        body rod on cart {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: turn, dry_friction: mu, stop: [-1, 1],
        }
    }
}

mechanism! {
    /// Two inputs, a first-order state, and every function.
    pub Driven {
        units: none,
        params { l: m = 0.4, tau: s = 0.2 }
        input force: N,
        input moment: N m,
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, parameter_jacobian, adjoint, hessian_product, inverse_dynamics],
        state lag { unit: N, rate: (force - lag)/tau }
        body cart on ground {
            mass: 2,
            joint: prismatic(x),
            coordinate: s,
            torque: lag - 0.1 * tanh(5*qd) * abs(qd)^(1/3) * exp(-q^2) + tan(q/4) * ln(2 + q^2),
        }
        body rod on cart {
            solids: [rod(l, [0, 0, 0], [0, -0.7, 0])],
            joint: revolute(z),
            coordinate: turn,
            torque: moment + clamp(moment * qd, -l, l) - 0.02 * dot(s) * atan2(sin(q), 2 + cos(q)) * sqrt(1 + qd^2),
        }
    }
}

/// Tape that reads numbers at every place of an operation, alone, two at a time and as a result.
const NUMBERS: &str = "pendulum tape\t2
name\tNumbers
slot\tq\tlength\t0 1\t1 2\t
autonomous
open_loops\t
code\tchecked
registers\t0
result\t
code\tconstants
registers\t0
result\t
code\tlaws
registers\t0
result\t
routine\trhs\t\tvector 2
registers\t5
read\tstate\t0 1
number\t2\t0.3
number\t3\t-1.7
mul\t4 0 2
add\t4 4 3
sub\t4 4 2
sub\t4 3 4
mul\t4 2 4
div\t4 3 4
mul_add\t4 4 2 0
mul_add\t4 3 1 4
mul_neg_add\t4 0 2 4
mul_sub\t4 4 3 2
result\t1 4
routine\tothers\t\tvector 8
registers\t10
read\tstate\t0 1
number\t2\t0.7
number\t3\t2.5
number\t4\t0.1
add\t5 4 1
mul\t6 2 3
sub\t7 4 0
mul_add\t8 2 4 6
div\t9 8 3
mul_add\t8 3 4 9
mul_neg_add\t7 7 3 4
neg\t6 4
result\t3 5 6 7 8 9 0 2
";

/// Text of the tape of a declaration in a source.
fn text(source: &str, name: &str) -> String {
    let program = pendulum_codegen::program(declaration(source, name).parse().expect("tokens"));
    pendulum_codegen::tape(&program.expect(name))
}

fn tape(source: &str, name: &str) -> Arc<Tape> {
    Arc::new(text(source, name).parse().expect(name))
}

fn tape_of_double_pendulum() -> Arc<Tape> {
    tape(SCENES, "DoublePendulum")
}

fn states<const N: usize>(count: usize) -> impl Iterator<Item = SVector<f64, N>> {
    let mut random = Random::new(5);
    (0..count).map(move |_| SVector::from_fn(|_, _| random.between(-1.5, 1.5)))
}

#[test]
fn integrations_end_in_the_same_states() {
    let params = DoublePendulumParams::default();
    let compiled = DoublePendulum::new(params).expect("valid");
    let own: Model<f64, 4> = tape(SCENES, "DoublePendulum").model(&params.to_array()).expect("valid");
    assert_eq!(System::<f64, 4>::layout(&own), System::<f64, 4>::layout(&compiled));
    let start = [1.0, 0.5, 0.0, 0.2];
    fn ends(system: &impl Jacobian<f64, 4>, start: [f64; 4]) -> [SVector<f64, 4>; 2] {
        let explicit = Vern9::new().solve(system, 0.0, 5.0, start).expect("regular");
        let implicit = Radau5::new().solve(system, 0.0, 5.0, start).expect("regular");
        [explicit.end(), implicit.end()]
    }
    assert_eq!(ends(&compiled, start), ends(&own, start));
    // in lanes, some of them not full, and each with parameters of its own
    let starts: Vec<SVector<f64, 4>> = states(21).collect();
    let lengths = (0..starts.len()).map(|n| 1.0 + 0.01 * n as f64);
    let with = |d| DoublePendulumParams { d, ..params };
    let compiled: Vec<_> = lengths
        .clone()
        .map(|d| compiled.with_params(with(d)).expect("valid"))
        .collect();
    let own: Vec<_> = lengths
        .map(|d| own.with_params(&with(d).to_array()).expect("valid"))
        .collect();
    let fixed = Rk4::new(0.01);
    assert_eq!(
        fixed.ensemble(&compiled, 0.0, 1.0, &starts).expect("regular"),
        fixed.ensemble(&own, 0.0, 1.0, &starts).expect("regular")
    );
    let adaptive = Rk45::new();
    assert_eq!(
        adaptive.ensemble(&compiled, 0.0, 1.0, &starts).expect("regular"),
        adaptive.ensemble(&own, 0.0, 1.0, &starts).expect("regular")
    );
}

#[test]
fn hybrid_systems_switch_modes_alike() {
    let compiled = Constrained::new(ConstrainedParams::default()).expect("valid");
    let tape = tape(include_str!("tapes.rs"), "Constrained");
    assert_eq!(tape.model::<4, false>(&[0.3]).map(|_| ()), Err(ModelError::Hybrid));
    let own: HybridModel<f64, 4> = tape.model(&[0.3]).expect("valid");
    let start = [1.5, 0.4, 0.8, 1.0];
    macro_rules! same {
        ($($method:expr),*) => {$({
            let of_compiled = $method.solve(&compiled, 0.0, 3.0, start).expect("regular");
            let of_tape = $method.solve(&own, 0.0, 3.0, start).expect("regular");
            assert!(!of_compiled.impacts().is_empty());
            assert_eq!(of_compiled.impacts(), of_tape.impacts());
            assert_eq!(of_compiled.last(), of_tape.last());
            assert_eq!(of_compiled.statistics(), of_tape.statistics());
        })*};
    }
    same!(Vern9::new(), Rodas5P::new(), Gauss4::new(0.01), Taylor::new());
}

/// First components of a state.
fn first<const N: usize>(x: SVector<f64, N>) -> SVector<f64, 4> {
    assert!(x.iter().skip(4).all(|&padding| padding == 0.0), "{x}");
    SVector::from_fn(|n, _| x[n])
}

#[test]
fn padding_changes_no_bit() {
    let tape = tape(include_str!("tapes.rs"), "Constrained");
    let exact: HybridModel<f64, 4> = tape.model(&[0.3]).expect("valid");
    let padded: HybridModel<f64, 9> = tape.padded(&[0.3]).expect("valid");
    let longer = |start: [f64; 4]| SVector::<f64, 9>::from_fn(|n, _| start.get(n).copied().unwrap_or(0.0));
    let start = [1.5, 0.4, 0.8, 1.0];
    macro_rules! same {
        // in closures, whose numbers leave the stack
        ($($method:expr),*) => {$({
            let check = || {
            let of_exact = $method.solve(&exact, 0.0, 3.0, start).expect("regular");
            let of_padded = $method.solve(&padded, 0.0, 3.0, longer(start)).expect("regular");
            assert!(!of_exact.impacts().is_empty());
            assert_eq!(of_exact.t(), of_padded.t());
            assert_eq!(of_exact.end(), first(of_padded.end()));
            assert_eq!(of_exact.modes(), of_padded.modes());
            assert_eq!(of_exact.statistics(), of_padded.statistics());
            let starts: Vec<_> = states(9).map(|x| 0.2 * x).collect();
            let longer: Vec<_> = starts.iter().map(|start| longer(start.data.0[0])).collect();
            let of_exact = $method.ensemble(std::slice::from_ref(&exact), 0.0, 2.0, &starts).expect("regular");
            let of_padded = $method.ensemble(std::slice::from_ref(&padded), 0.0, 2.0, &longer).expect("regular");
            assert_eq!(of_exact, of_padded.into_iter().map(first).collect::<Vec<_>>());
            };
            check();
        })*};
    }
    same!(
        Rk4::new(0.01),
        Tsit5::new().atol(1e-12),
        Vern9::new(),
        Taylor::new(),
        Rodas5P::new(),
        Radau5::new()
    );
    same!(Auto::new(), Gauss4::new(0.01));
    // one mode, whose norms and matrices are those of lanes
    let exact: Model<f64, 4> = tape_of_double_pendulum()
        .model(&DoublePendulumParams::default().to_array())
        .expect("valid");
    let padded: Model<f64, 9> = tape_of_double_pendulum()
        .padded(&DoublePendulumParams::default().to_array())
        .expect("valid");
    let starts: Vec<SVector<f64, 4>> = states(21).collect();
    let longer: Vec<_> = starts.iter().map(|start| longer(start.data.0[0])).collect();
    macro_rules! same_in_lanes {
        ($($method:expr),*) => {$(
            let of_exact = $method.ensemble(std::slice::from_ref(&exact), 0.0, 2.0, &starts).expect("regular");
            let of_padded = $method.ensemble(std::slice::from_ref(&padded), 0.0, 2.0, &longer).expect("regular");
            assert_eq!(of_exact, of_padded.into_iter().map(first).collect::<Vec<_>>());
        )*};
    }
    same_in_lanes!(Vern7::new().atol(1e-12), Taylor::new(), Rodas4::new(), Auto::new());
}

#[test]
fn analyses_leave_padding_out() {
    let parameters = DoublePendulumParams::default();
    let compiled = DoublePendulum::new(parameters).expect("valid");
    let padded: Model<f64, 9> = tape_of_double_pendulum().padded(&parameters.to_array()).expect("valid");
    let seed = |x: [f64; 2]| SVector::<f64, 9>::from_fn(|n, _| x.get(n).copied().unwrap_or(0.0));
    let found = stability::equilibria(&padded, [seed([0.1, 0.2])]).expect("autonomous");
    let of_compiled = stability::equilibria(&compiled, [SVector::from([0.1, 0.2, 0.0, 0.0])]).expect("autonomous");
    assert_eq!(found.len(), 4);
    for (own, other) in found.iter().zip(of_compiled.iter()) {
        assert!((first(own.x) - other.x).norm() < 1e-9);
        assert_eq!(own.spectrum.modes().len(), 4);
        assert_eq!(own.stability(), other.stability());
    }
    // at rest all exponents are those of the linearisation, and none is the zero of padding
    let exponents = stability::Lyapunov::new().duration(200.0);
    let own = exponents.exponents::<4, 9>(&padded, seed([0.0, 0.0])).expect("regular");
    let other = exponents.exponents::<4, 4>(&compiled, [0.0; 4]).expect("regular");
    for (own, other) in own.values.iter().zip(other.values) {
        assert!((own - other).abs() < 1e-3 && *own < -1e-3, "{own} {other}");
    }
    assert!(exponents.exponents::<5, 9>(&padded, seed([0.0, 0.0])).is_err());
}

#[test]
fn derivatives_by_parameters_have_the_same_bits() {
    let compiled = Constrained::new(ConstrainedParams::default()).expect("valid");
    let own: HybridModel<f64, 4> = tape(include_str!("tapes.rs"), "Constrained")
        .model(&[0.3])
        .expect("valid");
    let by = [Variable::Start(1), Variable::Parameter(0)];
    let start = [1.5, 0.4, 0.8, 1.0];
    let of_compiled = sensitivity::end::<_, _, _, 4, 1, 2>(&Vern9::new(), &compiled, 0.0, 2.0, start, by);
    // three parameters, two of which are padding
    let of_tape = sensitivity::end::<_, _, _, 4, 3, 2>(&Vern9::new(), &own, 0.0, 2.0, start, by);
    assert!(of_compiled.is_ok());
    assert_eq!(of_compiled, of_tape);
    let names: [&str; 3] = Parametric::<4, 3>::parameter_names(&own);
    assert_eq!(names, ["mu", "", ""]);
    let negative = Parametric::<4, 3>::check_parameters(&own, &[-0.1, 0.0, 0.0]);
    assert_eq!(negative, Parametric::<4, 1>::check_parameters(&compiled, &[-0.1]));
    assert!(negative.is_err());
}

#[test]
fn series_and_canonical_equations_have_the_same_bits() {
    let compiled = Constrained::new(ConstrainedParams::default()).expect("valid");
    let own: HybridModel<f64, 4> = tape(include_str!("tapes.rs"), "Constrained")
        .model(&[0.3])
        .expect("valid");
    for x in states(200) {
        assert_eq!(compiled.canonical(0.7, &x), own.canonical(0.7, &x));
        assert_eq!(compiled.canonical_jacobian(0.7, &x), own.canonical_jacobian(0.7, &x));
        let hold = Hold {
            forces: [0.3, -0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            held: 1,
            solved: 1,
        };
        let [mut series, mut of_tape] = [[x; 13]; 2];
        compiled.eval_series(&hold, 0.7, &mut series, &mut compiled.workspace());
        own.eval_series(&hold, 0.7, &mut of_tape, &mut own.workspace());
        assert_eq!(series, of_tape);
    }
}

#[test]
fn inputs_and_arguments_have_their_places() {
    let compiled = Driven::new(DrivenParams::default()).expect("valid");
    let params = DrivenParams::default().to_array();
    let mut own: Model<f64, 5> = tape(include_str!("tapes.rs"), "Driven").model(&params).expect("valid");
    let results = |model: &Model<f64, 5>, name: &str, x: &SVector<f64, 5>, given: &Given<'_, f64>| {
        let routines = model.tape().routines();
        let index = routines.iter().position(|routine| routine.name() == name).expect(name);
        let mut results = vec![0.0; routines[index].results()];
        model.evaluate(index, 0.0, x, given, &mut results);
        results
    };
    for x in states(200) {
        let inputs = [0.3 + x[0], x[1]];
        own.set_inputs(&inputs);
        let named = DrivenInputs::from(inputs);
        assert_eq!(compiled.eval(0.0, &x, &named), own.rhs(0.0, &x));
        assert_eq!(
            compiled.eval_with_jacobian(0.0, &x, &named),
            own.rhs_and_jacobian(0.0, &x)
        );
        let given = Given {
            inputs: &inputs,
            ..Given::default()
        };
        let by_inputs = compiled.input_jacobian(0.0, &x, &named);
        assert!(by_inputs.iter().eq(&results(&own, "input_jacobian", &x, &given)));
        let by_parameters = compiled.parameter_jacobian(0.0, &x, &named);
        assert!(
            by_parameters
                .iter()
                .eq(&results(&own, "parameter_jacobian", &x, &given))
        );
        let weights = SVector::from([0.1, -0.4, 0.3, 0.7, 0.2]);
        let given = Given {
            weights: weights.as_slice(),
            ..given
        };
        let (by_state, by_parameters, by_inputs) = compiled.adjoint(0.0, &x, &named, &weights);
        let all = by_state.iter().chain(by_parameters.iter()).chain(by_inputs.iter());
        assert!(all.eq(&results(&own, "adjoint", &x, &given)));
    }
    let x = SVector::from([0.1, 0.2, 0.3, 0.4, 0.5]);
    let same_inputs = own.with_params(&params).expect("valid");
    assert_eq!(same_inputs.rhs(0.0, &x), own.rhs(0.0, &x));
    own.set_inputs(&[0.0; 2]);
    let idle: Model<f64, 5> = tape(include_str!("tapes.rs"), "Driven").model(&params).expect("valid");
    assert_eq!(idle.rhs(0.0, &x), own.rhs(0.0, &x));
}

#[test]
fn inputs_follow_samples_in_each_lane() {
    let params = DrivenParams::default().to_array();
    let of_tape: Model<f64, 5> = tape(include_str!("tapes.rs"), "Driven").model(&params).expect("valid");
    let compiled = Driven::new(DrivenParams::default()).expect("valid");
    let times = [0.0, 0.4, 1.1, 2.0];
    let samples = |n: usize| [0.3, -0.7].map(|x| times.map(|t| x * (1.0 + t + n as f64).sin()));
    let models: Vec<Model<f64, 5>> = (0..4)
        .map(|n| {
            let each = samples(n).map(|samples| TimeTable::cubic(&times, [&samples]).expect("samples"));
            let mut model = of_tape.clone();
            model.set_laws(each.into_iter().enumerate().collect());
            model
        })
        .collect();
    assert!(models[1].shares_lanes(&models[0]) && !of_tape.shares_lanes(&models[0]));
    assert_eq!(models[0].is_autonomous(), Some(false));
    for t in [-0.1, 0.2, 1.5, 3.0] {
        for x in states::<5>(20) {
            for apart in [false, true] {
                let own = |lane: usize| if apart { lane } else { 2 };
                let in_lanes = Model::<f64, 5>::gather::<F64x4>(|lane| &models[own(lane)]);
                let (t_of, x_of) = (F64x4::splat(t), x.map(F64x4::splat));
                let (rates, by_time) = (in_lanes.rhs(t_of, &x_of), in_lanes.time_derivative(t_of, &x_of));
                for lane in 0..4 {
                    let [force, moment] = samples(own(lane));
                    let both = TimeTable::cubic(&times, [&force, &moment]).expect("samples");
                    let driven = compiled.with_law(both);
                    assert_eq!(driven.rhs(t, &x), models[own(lane)].rhs(t, &x));
                    assert_eq!(driven.rhs(t, &x), rates.map(|rate| rate.lane(lane)));
                    assert_eq!(driven.time_derivative(t, &x), by_time.map(|rate| rate.lane(lane)));
                }
            }
        }
    }
}

/// Results of a routine at a state, a time and arguments, all given by their numbers.
fn results<T: Real>(model: &HybridModel<T, 5>, routine: usize, value: impl Fn(usize) -> T) -> Vec<T> {
    let numbers: [T; MAX_CONSTRAINTS] = std::array::from_fn(&value);
    let given = Given {
        inputs: &numbers,
        forces: &numbers,
        accelerations: &numbers,
        weights: &numbers,
        direction: &numbers,
    };
    let x = SVector::from_fn(|n, _| value(20 + n));
    let mut results = vec![T::default(); model.tape().routines()[routine].results()];
    model.evaluate(routine, value(30), &x, &given, &mut results);
    results
}

/// Lanes run the operations in another order than scalars.
#[test]
fn every_routine_has_the_same_bits_in_lanes() {
    let own = include_str!("tapes.rs");
    let numbers = Arc::new(NUMBERS.parse().expect("a tape"));
    for tape in [
        tape_of_double_pendulum(),
        tape(own, "Constrained"),
        tape(own, "Driven"),
        numbers,
    ] {
        let params: Vec<f64> = tape.parameters().iter().map(|own| own.default.unwrap_or(1.0)).collect();
        let alone: HybridModel<f64, 5> = tape.padded(&params).expect("valid");
        let in_lanes = alone.cast::<F64x4>();
        for (routine, round) in (0..tape.routines().len()).flat_map(|routine| [(routine, 0), (routine, 1)]) {
            let value = |n: usize, lane: usize| (0.7 * n as f64 + lane as f64 + 5.0 * f64::from(round)).sin();
            let of_lanes = results(&in_lanes, routine, |n| F64x4::from_fn(|lane| value(n, lane)));
            for lane in 0..F64x4::LANES {
                let bits = results(&alone, routine, |n| value(n, lane))
                    .into_iter()
                    .map(f64::to_bits);
                let name = tape.routines()[routine].name();
                assert!(bits.eq(of_lanes.iter().map(|x| x.lane(lane).to_bits())), "{name}");
            }
        }
    }
}

#[test]
fn outputs_in_lanes_may_be_asked_for_while_they_are_told() {
    let text = "mechanism! {\npub Rod { point tip on rod at [0, -1, 0], output height: tip.y, output width: tip.x, \
        body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: turn } }\n}\n";
    let model: Model<f64, 2> = tape(text, "Rod").model(&[]).expect("physical");
    let (lanes, x) = (model.cast::<F64x4>(), SVector::from([0.3, 0.4]));
    let [first, second] = [x, 2.0 * x].map(|x| {
        let mut told = Vec::new();
        model.each_output(0.0, &x, &mut |_, value| told.push(value));
        told
    });
    let [x, other] = [x, 2.0 * x].map(|x| x.map(F64x4::splat));
    let mut told = Vec::new();
    lanes.each_output(F64x4::splat(0.0), &x, &mut |_, value| {
        let mut inner = Vec::new();
        lanes.each_output(F64x4::splat(0.0), &other, &mut |_, value| inner.push(value.lane(1)));
        assert_eq!(inner, second);
        told.push(value.lane(2));
    });
    assert_eq!((told.len(), told), (2, first));
}

#[test]
fn what_is_wrong_is_said() {
    let text = text(SCENES, "DoublePendulum");
    let line = |keyword: &str| {
        let lines = text.lines().position(|line| line.split('\t').next() == Some(keyword));
        lines.expect(keyword) + 1
    };
    let cases = [
        (
            "pendulum tape\t2",
            "pendulum tape\t3",
            1,
            "the version is `3`, and this program reads 1 and 2",
        ),
        ("pendulum tape\t2", "tape\t2", 1, "`pendulum tape` is expected here"),
        (
            "slot\ttheta1\tangle",
            "slot\ttheta1\tangel",
            line("slot"),
            "`angel` is no kind of a coordinate",
        ),
        (
            "parameter\tm\tkg\t1.0",
            "parameter\tm\tkg\t1,0",
            line("parameter"),
            "`1,0` is not a number that can stand here",
        ),
        (
            "parameter\tm\tkg\t1.0",
            "parameter\tm\tkg",
            line("parameter"),
            "`parameter` has 3 fields, not 2",
        ),
        (
            "routine\trhs\t",
            "routine\trhs\tforce",
            line("routine"),
            "`force` is no argument of a routine",
        ),
    ];
    for (from, to, line, fact) in cases {
        assert!(text.contains(from), "{from}");
        let error = text.replacen(from, to, 1).parse::<Tape>().expect_err(to);
        assert_eq!(error.to_string(), format!("line {line} of the tape: {fact}"));
    }
    // the first constant of the right-hand side follows what is read before it; an operation writes there
    let (head, rhs) = text.split_at(text.find("routine\trhs").expect("a right-hand side"));
    let (before, after) = rhs.split_once("read\tconstant").expect("constants");
    let reads = before.lines().filter_map(|line| line.strip_prefix("read\t"));
    let place: usize = reads.map(|read| read.split([' ', '\t']).count() - 1).sum();
    let (before_product, product) = after.split_once("\nmul\t").expect("a product");
    let (_, others) = product.split_once(' ').expect("registers");
    let overwritten = format!("{head}{before}read\tconstant{before_product}\nmul\t{place} {others}");
    // no operation writes to a last register
    let (start, count) = rhs.split_once("registers\t").expect("registers");
    let (count, code) = count.split_once('\n').expect("code");
    let last: usize = count.parse().expect("a number");
    let (operations, results) = code.split_once("result\t").expect("results");
    let (_, others) = results.split_once(' ').expect("results");
    let with_last = |operations: &str, results: &str| {
        format!("{head}{start}registers\t{}\n{operations}result\t{results}", last + 1)
    };
    let (before_product, product) = operations.split_once("\nmul\t").expect("a product");
    let (of_product, following) = product.split_once(' ').expect("registers");
    let (_, following) = following.split_once(' ').expect("operands");
    let unset = format!("{before_product}\nmul\t{of_product} {last} {following}");
    let cases = [
        (
            overwritten,
            "an operation writes to the register of a constant or of a number",
        ),
        (
            with_last(&unset, results),
            "an operation reads a register before anything is written to it",
        ),
        (
            with_last(operations, &format!("{last} {others}")),
            "a result is a register that nothing is written to",
        ),
    ];
    for (text, fact) in cases {
        let error = text.parse::<Tape>().expect_err(fact).to_string();
        assert!(error.ends_with(fact), "{error}");
    }
    // a register of a variable, that of another number, and more numbers than registers
    let first = "number\t2\t0.3\n";
    let also = |register| NUMBERS.replacen(first, &format!("{first}number\t{register}\t0.5\n"), 1);
    let many = (0..1 << 16).map(|n| format!("number\t{}\t0.3\n", 2 + n % 65_534));
    let many = NUMBERS.replacen("registers\t5", "registers\t65536", 1).replacen(
        "number\t2\t0.3\nnumber\t3\t-1.7\n",
        &many.collect::<String>(),
        1,
    );
    let cases = [(also(1), 19, 1), (also(2), 19, 2), (many, 18 + 65_534, 2)];
    for (text, line, register) in cases {
        let error = text.parse::<Tape>().expect_err("a register is set twice").to_string();
        assert_eq!(
            error,
            format!(
                "line {line} of the tape: register {register} has a value already: each number has one of its own, \
                 out of 65536 at most"
            )
        );
    }
    let tape: Arc<Tape> = Arc::new(text.parse().expect("a tape"));
    let message = |error: ModelError| error.to_string();
    let wrong_length = tape.model::<6, false>(&[1.0; 7]).map(|_| ()).map_err(message);
    assert_eq!(wrong_length, Err("the state has 4 components, not 6".to_owned()));
    let too_few = tape.model::<4, false>(&[1.0; 2]).map(|_| ()).map_err(message);
    let names = "the model has the parameters m, inertia, c, d, g, gamma1, gamma2, which are 7, not 2";
    assert_eq!(too_few, Err(names.to_owned()));
    let massless = tape
        .model::<4, false>(&[-1.0, 1.0, 1.0, 1.0, 9.8, 0.1, 0.1])
        .map(|_| ());
    let params = DoublePendulumParams {
        m: -1.0,
        ..Default::default()
    };
    let of_compiled = DoublePendulum::new(params).map(|_| ()).expect_err("a negative mass");
    assert_eq!(massless, Err(ModelError::Parameter(of_compiled)));
}

/// Lines of a tape are dropped, doubled, swapped and changed at random: the text is refused, or evaluates without a
/// panic, in lanes to the bits of scalars.
#[test]
fn damaged_tapes_do_not_panic() {
    let texts = [
        text(SCENES, "DoublePendulum"),
        text(include_str!("tapes.rs"), "Constrained"),
    ];
    let mut random = Random::new(11);
    let mut refused = 0;
    for n in 0..2000 {
        let mut lines: Vec<String> = texts[n % 2].lines().map(str::to_owned).collect();
        let (line, other) = (random.below(lines.len()), random.below(lines.len()));
        match random.below(4) {
            0 => _ = lines.remove(line),
            1 => lines.insert(other, lines[line].clone()),
            2 => lines.swap(line, other),
            _ => {
                let characters: Vec<char> = lines[line].chars().collect();
                let place = random.below(characters.len().max(1));
                let new = *random.of(&['0', '9', '-', '\t', ' ', 'x', '.']);
                lines[line] = characters
                    .iter()
                    .enumerate()
                    .map(|(n, &c)| if n == place { new } else { c })
                    .collect();
            }
        }
        let Ok(tape) = lines.join("\n").parse::<Tape>().map(Arc::new) else {
            refused += 1;
            continue;
        };
        let params: Vec<f64> = tape.parameters().iter().map(|own| own.default.unwrap_or(1.0)).collect();
        let Ok(model) = tape.model::<4, true>(&params) else {
            continue;
        };
        let (x, forces) = (SVector::from([0.1, 0.2, 0.3, 0.4]), [0.1; MAX_CONSTRAINTS]);
        let in_lanes = model.cast::<F64x4>().rhs(F64x4::splat(0.0), &x.map(F64x4::splat));
        let alone = model.rhs(0.0, &x);
        let is_same =
            |(ours, theirs): (f64, f64)| ours.to_bits() == theirs.to_bits() || (ours.is_nan() && theirs.is_nan());
        let ours = in_lanes.map(|x| x.lane(3));
        assert!(
            ours.iter().copied().zip(alone.iter().copied()).all(is_same),
            "{ours} {alone}, {n}"
        );
        let mut projected = x;
        model.project(0.0, &mut projected);
        model.margins(0.0, &x, &mut |_, _| {});
        model.gaps(0.0, &x, &mut |_, _| {});
        model.each_output(0.0, &x, &mut |_, _| {});
        std::hint::black_box((model.response(0.0, &x, &forces), model.laws()));
        let motion = Rk4::new(0.1).solve(&model, 0.0, 0.3, x);
        std::hint::black_box((model.measures(0.0, &x), motion.is_ok()));
    }
    assert!((1000..2000).contains(&refused), "{refused}");
}

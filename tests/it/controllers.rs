//! Controllers in C against those in Rust, bit for bit.

use std::collections::BTreeSet;
use std::path::Path;

use nalgebra::{SMatrix, SVector};
use pendulum_codegen::Controller;
use pendulum_codegen::program::Program;
use pendulum_core::control::{Ilqr, LinearLaw, Objective, Quadratic, linearize};
use pendulum_core::prelude::*;
use pendulum_core::real::Float;
use pendulum_core::{Controlled, control};
use testbed::random::Random;
use testbed::source::declaration;

use crate::c_code::{compiled_with, folder, output};

mechanism! {
    /// A pole that is hinged to a cart; the angle is 0 upright.
    pub CartPole {
        params { cart: kg = 1, pole: kg = 0.2, l: m = 0.6, g: m/s^2 = 9.81 }
        input push: N,
        gravity: [0, -g, 0],
        body slider on ground { mass: cart, joint: prismatic(x), coordinate: s, torque: push }
        body rod on slider {
            solids: [rod(pole, [0, 0, 0], [0, l, 0])], joint: revolute(z), coordinate: theta,
        }
    }
}

mechanism! {
    /// Two motors on an arm whose shoulder shakes, with names that C cannot take.
    pub Shaken {
        params { amplitude: m = 0.05, w: rad/s = 5 }
        input double: N m,
        input N: N m,
        gravity: [0, -9.81, 0],
        body shoulder on ground { joint: prismatic(x), motion: amplitude*sin(w*t) }
        body upper on shoulder {
            solids: [rod(1, [0, 0, 0], [0, -0.5, 0])], joint: revolute(z), coordinate: a, torque: double,
        }
        body lower on upper {
            solids: [rod(0.7, [0, 0, 0], [0, -0.4, 0])], joint: revolute(z) at [0, -0.5, 0], coordinate: b, torque: N,
            friction: 0.01,
        }
    }
}

mechanism! {
    /// A body about its center, with three motors.
    pub Craft {
        input roll: N m, input pitch: N m, input yaw: N m,
        dissipation: -roll*dot(attitude).x - pitch*dot(attitude).y - yaw*dot(attitude).z,
        body hull on ground {
            mass: 1, inertia: [0.03, 0.05, 0.07], joint: ball, orientation: attitude,
        }
    }
}

/// Source of this file, with its declarations.
const OWN: &str = include_str!("controllers.rs");
/// Number of states in which the laws and the step are compared.
const STATES: usize = 1000;
/// Number of samples from the end at which samples are missed, and how many: more than a plan has steps.
const LATE: usize = 8;
const MISSED: f64 = 100.0;
/// Number of projections that bring a state onto its invariants to the last bit.
const PROJECTIONS: usize = 4;
/// Options beyond those of all C code.
const STRICT: [&str; 3] = ["-pedantic", "-Wconversion", "-Wdouble-promotion"];

/// Controller of a model in both languages.
struct Case<const N: usize, const M: usize> {
    h: f64,
    q: SMatrix<f64, N, N>,
    r: SMatrix<f64, M, M>,
    end: SMatrix<f64, N, N>,
    goal: SVector<f64, N>,
    rest: [f64; M],
    low: [f64; M],
    high: [f64; M],
    law: LinearLaw<N, M>,
    /// True if the state begins with a quaternion.
    turns: bool,
    /// State at the start of the run, and number of its samples.
    x0: SVector<f64, N>,
    samples: usize,
}

impl<const N: usize, const M: usize> Case<N, M> {
    fn rust<T: Float, const K: usize>(&self) -> Ilqr<Quadratic<T, N, M>, T, N, M, K> {
        let cost = Quadratic::new(self.q.map(T::from_f64), self.r.map(T::from_f64))
            .end(self.end.map(T::from_f64))
            .goal(self.goal.map(T::from_f64), self.rest.map(T::from_f64));
        let limits = [self.low, self.high].map(|limits| limits.map(T::from_f64));
        Ilqr::new(T::from_f64(self.h), cost).limits(limits[0], limits[1])
    }

    fn c<const K: usize>(&self, start: &[[f64; M]; K]) -> Controller {
        let ilqr = pendulum_codegen::Ilqr::new(self.h, K, self.q.as_slice(), self.r.as_slice())
            .end(self.end.as_slice())
            .goal(self.goal.as_slice(), &self.rest)
            .start_from(start.as_flattened());
        let law = &self.law;
        Controller::new()
            .limits(&self.low, &self.high)
            .linear_law(law.gain.as_slice(), law.x0.as_slice(), &law.u0)
            .ilqr(ilqr)
    }

    /// The start of the run, and the states of the comparison.
    fn given(&self) -> Vec<Vec<f64>> {
        let mut random = Random::new(3);
        let start = [&[0.0], self.x0.as_slice()].concat();
        let states = (0..STATES).map(|_| {
            let mut state: Vec<f64> = (0..=N).map(|_| random.between(-2.0, 2.0)).collect();
            // quaternions of unit length to the last bit
            state[1..=4]
                .iter_mut()
                .filter(|_| self.turns)
                .for_each(|part| *part = 0.5_f64.copysign(*part));
            state
        });
        [start].into_iter().chain(states).collect()
    }

    /// Results of Rust, in the order of `run.c`, with a step of the model by `rk4`.
    fn expected<S, T, const K: usize>(
        &self,
        model: S,
        start: &[[f64; M]; K],
        rk4: impl Fn([T; 2], SVector<T, N>, [T; M]) -> SVector<T, N>,
    ) -> Vec<f64>
    where
        S: Controlled<T, N, M> + Copy,
        T: Float,
    {
        use control::Controller;
        let given = self.given().into_iter().map(|given| {
            let x = SVector::<f64, N>::from_column_slice(&given[1..]).map(T::from_f64);
            (T::from_f64(given[0]), x)
        });
        let mut given = given;
        // until nothing changes, since a trajectory begins with a projection
        let placed = |t: T, mut x: SVector<T, N>| {
            for _ in 0..PROJECTIONS {
                model.project(t, &mut x);
            }
            x
        };
        let mut out: Vec<T> = Vec::new();
        let ilqr = self.rust::<T, K>().start_from(start.map(|u| u.map(T::from_f64)));
        let controller = ilqr.controller(model).expect("settings");
        let mut state = controller.start(T::from_f64(self.h));
        let (mut t, mut x) = given.next().expect("a start");
        let h = T::from_f64(self.h);
        for sample in 0..self.samples {
            let u = controller.sample(t, &x, &mut state);
            assert_eq!(state.failure, None);
            x = rk4([t, t + h], placed(t, x), u);
            let gain = state.ilqr.gain(3).transpose();
            out.extend(u.iter().chain(&x).chain(state.ilqr.end()).chain(&gain));
            t += h;
            if sample + LATE == self.samples {
                t += T::from_f64(MISSED) * h;
            }
        }
        for (t, x) in given {
            let law = pendulum_core::inputs::InputLaw::inputs(&self.law, t, &x);
            let limited = std::array::from_fn::<T, M, _>(|m| {
                law[m]
                    .at_least(T::from_f64(self.low[m]))
                    .at_most(T::from_f64(self.high[m]))
            });
            let u = state.ilqr.command(5, &x);
            let end = rk4([t, t + h], placed(t, x), u);
            out.extend(limited.iter().chain(&u).chain(&end));
        }
        out.into_iter().map(T::to_f64).collect()
    }

    /// Results of C in double or single precision.
    fn results(&self, folder: &Path, program: &Program, controller: &Controller, real: &str) -> Vec<f64> {
        let sources = controller.print(program).expect("a controller");
        let project = match program.layout.quaternions().next() {
            Some(_) => format!("for (int n = 0; n < {PROJECTIONS}; n++) name_project(x);"),
            None => String::new(),
        };
        let main = include_str!("controllers/run.c")
            .replace("PROJECT;", &project)
            .replace("name", &sources.name)
            .replace("NAME", &sources.name.to_uppercase())
            .replace("REAL", real)
            .replace("LATE", &LATE.to_string())
            .replace(
                "MISSED",
                &format!("{MISSED}.0{}", if real == "float" { "f" } else { "" }),
            )
            .replace("SAMPLES", &self.samples.to_string());
        let bytes = output(&compiled_with(folder, &sources, &main, &STRICT), &self.given());
        bytes
            .as_chunks()
            .0
            .iter()
            .map(|bytes| f64::from_le_bytes(*bytes))
            .collect()
    }
}

/// Compares a model in both precisions, of which both have the same bits in C and in Rust.
macro_rules! same {
    ($name:ident, $kind:literal, $params:expr, $case:expr, $start:expr) => {{
        let name = stringify!($name);
        let Some(folder) = folder(&format!("{name}{}", $kind)) else {
            return;
        };
        let (case, start) = ($case, $start);
        let program = pendulum_codegen::program(declaration(OWN, name).parse().expect("tokens")).expect("no errors");
        let model = $name::new($params).expect("physical");
        let single = model.cast::<f32>();
        // steps of twice the length are cut to one that ends at the end
        let rk4 = Rk4::new(2.0 * case.h);
        let double = case.expected(model, &start, |[t, t1], x, u| {
            rk4.solve(&model.with_inputs(|_, _| u.into()), t, t1, x)
                .expect("regular")
                .end()
        });
        let of_single = case.expected(single, &start, |[t, t1]: [f32; 2], x, u| {
            rk4.solve(&single.with_inputs(|_, _| u.into()), t, t1, x)
                .expect("regular")
                .end()
        });
        agree(
            &format!("{name} in double"),
            &double,
            &case.results(&folder, &program, &case.c(&start), "double"),
        );
        agree(
            &format!("{name} in float"),
            &of_single,
            &case.results(&folder, &program, &case.c(&start).single(), "float"),
        );
        double
    }};
}

fn agree(name: &str, rust: &[f64], c: &[f64]) {
    assert_eq!(rust.len(), c.len(), "{name}");
    for (n, (rust, c)) in rust.iter().zip(c).enumerate() {
        assert_eq!(
            rust.to_bits(),
            c.to_bits(),
            "{name}: result {n}: {rust:e} in Rust, {c:e} in C"
        );
    }
}

/// The swing-up of the recipe, and its inputs.
fn swing_up() -> (Case<4, 1>, [[f64; 1]; 80]) {
    let model = CartPole::new(CartPoleParams::default()).expect("physical");
    let (h, q, r) = (
        0.025,
        SMatrix::from_diagonal(&[1.0, 1.0, 0.1, 0.1].into()),
        SMatrix::from([[0.1]]),
    );
    let upright = linearize(&model, 0.0, [0.0; 4], [0.0]).expect("regular");
    let case = Case {
        h,
        q,
        r,
        end: upright.lqr(&q, &r).expect("stabilizable").cost,
        goal: SVector::zeros(),
        rest: [0.0],
        low: [-8.0],
        high: [8.0],
        law: upright
            .discretize(h)
            .expect("regular")
            .lqr(&q, &r)
            .expect("stabilizable")
            .law,
        turns: false,
        x0: [0.0, 3.2, 0.0, 0.0].into(),
        samples: 200,
    };
    let mut ilqr = case.rust::<f64, 80>();
    ilqr.solve(&model, 0.0, case.x0).expect("a swing-up");
    let inputs = *ilqr.inputs();
    (case, inputs)
}

#[test]
fn a_swing_up_is_the_same() {
    let (case, start) = swing_up();
    let results = same!(CartPole, "Controller", CartPoleParams::default(), case, start);
    let results: Vec<&[f64]> = results[..200 * 13].chunks(13).collect();
    assert!(results.iter().any(|sample| sample[0].abs() == 8.0), "at the limit");
    assert!(results[199][1..5].iter().all(|number| number.abs() < 0.05), "upright");
}

/// Steps too long for the method, and a start without a motion: the line search fails, and damping grows.
#[test]
fn rough_plans_are_the_same() {
    let (case, _) = swing_up();
    let case = Case {
        h: 0.15,
        x0: [0.0, 6.45, 0.0, 6.5].into(),
        samples: 60,
        ..case
    };
    same!(CartPole, "Rough", CartPoleParams::default(), case, [[0.0]; 80]);
}

#[test]
fn two_motors_in_time_are_the_same() {
    let case = Case {
        h: 0.02,
        q: SMatrix::from_fn(|i, j| if i == j { 2.0 } else { 0.1 }),
        r: [[0.05, 0.01], [0.01, 0.02]].into(),
        end: SMatrix::identity() * 20.0,
        goal: [2.0, 0.5, 0.0, 0.0].into(),
        rest: [1.5, 0.3],
        low: [f64::NEG_INFINITY, -0.8],
        high: [4.0, 1.0],
        law: LinearLaw {
            gain: SMatrix::from_fn(|i, j| 1.0 / (1 + i + 2 * j) as f64),
            x0: [0.1, 0.2, 0.3, 0.4].into(),
            u0: [0.7, 0.1],
        },
        turns: false,
        x0: [-0.5, 0.3, 0.0, 0.0].into(),
        samples: 60,
    };
    let results = same!(Shaken, "Controller", ShakenParams::default(), case, [[0.5, -0.1]; 30]);
    let both = results[..60 * 18]
        .chunks(18)
        .filter(|sample| sample[0] == 4.0 && sample[1].abs() >= 0.8);
    assert!(both.count() > 0, "both at their limits");
}

#[test]
fn orientations_are_the_same() {
    let case = Case {
        h: 0.03,
        q: SMatrix::from_diagonal(&[0.0, 4.0, 4.0, 4.0, 0.1, 0.1, 0.1].into()),
        r: SMatrix::identity() * 10.0,
        end: SMatrix::from_diagonal(&[0.0, 40.0, 40.0, 40.0, 1.0, 1.0, 1.0].into()),
        goal: [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0].into(),
        rest: [0.0; 3],
        low: [-0.1; 3],
        high: [0.1; 3],
        law: LinearLaw {
            gain: SMatrix::from_fn(|i, j| if (i + 1) == j || (i + 4) == j { 0.1 } else { 0.0 }),
            x0: [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0].into(),
            u0: [0.0; 3],
        },
        turns: true,
        x0: [0.6, 0.0, 0.8, 0.0, 1.0, -0.5, 0.3].into(),
        samples: 40,
    };
    same!(Craft, "Controller", CraftParams {}, case, [[0.0; 3]; 20]);
}

/// Names of functions and types of every header.
const OF_HEADERS: [&str; 8] = [
    "defaults",
    "error",
    "ilqr_pass",
    "inputs",
    "linear_law",
    "model",
    "project",
    "work",
];

/// A scene whose functions have the prefix of the helpers, and an output for each of these outputs. Its derivatives are
/// NaN at the angle 0.
fn of_prefix(outputs: &[&str]) -> Program {
    let outputs: String = outputs.iter().map(|name| format!("output {name}: angle,")).collect();
    let scene = format!(
        "pub Pendulum {{
            input motor: N m,
            gravity: [0, -9.81, 0],
            {outputs}
            body rod on ground {{
                mass: 1, com: [0, 1, 0], joint: revolute(z), coordinate: angle,
                torque: motor - (0.1 N m)*sqrt(abs(angle))*clamp(angle, -2, 2),
            }}
        }}"
    );
    pendulum_codegen::program(scene.parse().expect("tokens")).expect("no errors")
}

#[test]
fn outputs_take_no_other_name_and_what_is_refused_changes_nothing() {
    let Some(folder) = folder("Prefix") else { return };
    let ilqr = pendulum_codegen::Ilqr::new(0.02, 5, &[1.0, 0.0, 0.0, 0.1], &[0.1]).end(&[1.0, 0.0, 0.0, 1.0]);
    let controller = Controller::new().linear_law(&[3.0, 0.0], &[0.0; 2], &[0.0]).ilqr(ilqr);
    for (controller, real) in [(controller.clone().single(), "float"), (controller, "double")] {
        let plain = controller.print(&of_prefix(&[])).expect("a controller").source;
        let words = plain.split(|letter: char| !(letter.is_ascii_alphanumeric() || letter == '_'));
        let words: BTreeSet<&str> = words.collect();
        let names: BTreeSet<&str> = words
            .iter()
            .filter_map(|word| word.get(9..).filter(|_| word[..9].eq_ignore_ascii_case("pendulum_")))
            .filter(|name| name.chars().all(|letter| letter.is_ascii_lowercase() || letter == '_'))
            .collect();
        for helper in ["abs", "cost", "end", "sincos"] {
            let helper = if real == "float" && ["abs", "sincos"].contains(&helper) {
                format!("{helper}f")
            } else {
                helper.to_owned()
            };
            assert!(names.contains(&*helper), "{helper} in {names:?}");
        }
        let helpers = names
            .into_iter()
            .filter(|name| words.contains(&*format!("Pendulum_{name}")));
        let outputs: Vec<&str> = helpers.chain(OF_HEADERS).collect();
        let sources = controller.print(&of_prefix(&outputs)).expect("a controller");
        let main = include_str!("controllers/refused.c")
            .replace("name", &sources.name)
            .replace("NAME", &sources.name.to_uppercase())
            .replace("REAL", real);
        output(&compiled_with(&folder, &sources, &main, &STRICT), &[]);
    }
}

/// Verdict of both languages on the weights of a state with four components, in single precision or double.
fn verdicts(program: &Program, q: &SMatrix<f64, 4, 4>, is_single: bool) -> [String; 2] {
    let text = |error: Option<&dyn std::fmt::Display>| error.map_or("none".to_owned(), ToString::to_string);
    let own = match is_single {
        true => Quadratic::new(q.map(|entry| entry as f32), SMatrix::<f32, 1, 1>::identity()).check(),
        false => Quadratic::new(*q, SMatrix::<f64, 1, 1>::identity()).check(),
    };
    let controller = Controller::new().ilqr(pendulum_codegen::Ilqr::new(0.02, 5, q.as_slice(), &[1.0]));
    let controller = if is_single { controller.single() } else { controller };
    let printed = controller.print(program);
    [
        text(own.as_ref().err().map(|error| error as _)),
        text(printed.as_ref().err().map(|error| error as _)),
    ]
}

#[test]
fn weights_are_judged_alike() {
    let program = pendulum_codegen::program(declaration(OWN, "CartPole").parse().expect("tokens")).expect("no errors");
    let mut random = Random::new(7);
    let mut seen = [0; 3];
    for _ in 0..60 {
        let rank = 1 + (random.between(0.0, 4.0) as usize).min(3);
        let rows = SMatrix::<f64, 4, 4>::from_fn(|i, _| if i < rank { random.between(-1.0, 1.0) } else { 0.0 });
        let units = SVector::<f64, 4>::from_fn(|_, _| 10_f64.powi(random.between(-4.0, 4.0) as i32));
        let exact = SMatrix::from_diagonal(&units) * rows.transpose() * rows * SMatrix::from_diagonal(&units);
        let is_single = random.between(0.0, 1.0) < 0.5;
        let epsilon = if is_single {
            f64::from(f32::EPSILON)
        } else {
            f64::EPSILON
        };
        // errors far from the limits of both checks, 1e4 and 256 ulps
        let ulps = [0.0, 2.0, 3e3, 1e6][random.between(0.0, 4.0) as usize];
        let kind = random.between(0.0, 2.0) as usize;
        let mut q = exact;
        let scale = |i: usize| exact[(i, i)].sqrt();
        match kind {
            0 => q[(2, 1)] += ulps * epsilon * scale(2) * scale(1),
            _ => (0..4).for_each(|i| q[(i, i)] -= ulps * epsilon * exact[(i, i)]),
        }
        if is_single {
            q = q.map(|entry| f64::from(entry as f32));
        }
        let [own, printed] = verdicts(&program, &q, is_single);
        assert_eq!(
            own, printed,
            "{q:e}, rank {rank}, {ulps} ulps, single precision: {is_single}"
        );
        let sort = if own.contains("symmetric") {
            1
        } else {
            2 * usize::from(own != "none")
        };
        seen[sort] += 1;
    }
    assert!(seen.iter().all(|&number| number > 5), "{seen:?}");
}

#[test]
fn the_example_swings_up() {
    let Some(folder) = folder("SwingUp") else { return };
    let page = include_str!("../../docs/src/recipes/controller-in-c.md");
    let main = include_str!("../../examples/emitted_c/swing_up.c");
    let program = pendulum_codegen::program(declaration(OWN, "CartPole").parse().expect("tokens")).expect("no errors");
    let (case, start) = swing_up();
    let output = output(
        &compiled_with(
            &folder,
            &case.c(&start).print(&program).expect("a controller"),
            main,
            &STRICT,
        ),
        &[],
    );
    let text = String::from_utf8(output).expect("text");
    let last = text.lines().last().expect("a table").split(',');
    let last: Vec<f64> = last.map(|number| number.parse().expect("a number")).collect();
    assert!(last[2..].iter().all(|number| number.abs() < 0.02), "{last:?}");
    for function in ["new", "rk4_step", "linear_law", "ilqr_start", "ilqr_sample"] {
        let function = format!("cart_pole_{function}(");
        assert!(page.contains(&function) && main.contains(&function), "{function}");
    }
}

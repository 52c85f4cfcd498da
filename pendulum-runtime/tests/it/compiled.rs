//! Every method ends in the state of compiled code, bit for bit.

use std::sync::atomic::{AtomicBool, Ordering};

use pendulum_core::prelude::*;
use pendulum_runtime::{Error, Event, Members, Method as Named, Model, Options};

mod smooth {
    use super::*;

    twice! {
        pub Double {
            params { l: m = 0.5, m: kg = 1.0, gamma: N m s = 0.05 }
            gravity: [0, -9.81, 0],
            generate: [rhs, jacobian, energy, canonical, taylor, shapes, mass_matrix],
            point tip on lower at [0, -l, 0],
            output tip: tip,
            event level: dot(theta2),
            body upper on ground { mass: m, com: [0, -l, 0], joint: revolute(z), coordinate: theta1, friction: gamma }
            body lower on upper {
                mass: m,
                com: [0, -l, 0],
                joint: revolute(z) at [0, -l, 0],
                coordinate: theta2,
            }
        }
    }

    pub(super) fn model() -> (Double, Model) {
        let compiled = Double::new(DoubleParams::default()).expect("valid");
        (compiled, Model::parse(TEXT).expect("valid"))
    }
}

mod hybrid {
    use super::*;

    twice! {
        /// A rod with dry friction and a stop on a cart.
        pub Stick {
            params { mu: N m = 0.3 }
            gravity: [0, -9.81, 0],
            generate: [rhs, jacobian, energy, canonical, taylor],
            body cart on ground { mass: 2, joint: prismatic(x), coordinate: s }
            body rod on cart {
                mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: turn, dry_friction: mu, stop: [-1, 1],
            }
        }
    }

    pub(super) fn model() -> (Stick, Model) {
        let compiled = Stick::new(StickParams::default()).expect("valid");
        (compiled, Model::parse(TEXT).expect("valid"))
    }
}

mod short {
    use super::*;

    twice! {
        /// Two components, padded to four.
        pub Single {
            gravity: [0, -9.81, 0],
            generate: [rhs, jacobian, energy, canonical, taylor],
            body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: turn, friction: 0.1 }
        }
    }

    pub(super) fn model() -> (Single, Model) {
        let compiled = Single::new(SingleParams {}).expect("valid");
        (compiled, Model::parse(TEXT).expect("valid"))
    }
}

mod long {
    use super::*;

    twice! {
        /// Six components, padded to eight, in a mechanism that turns and slides.
        pub Three {
            gravity: [0, -9.81, 0],
            generate: [rhs, jacobian, energy, canonical, taylor],
            body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, spring: (30, 0) }
            body upper on cart { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a, friction: 0.1 }
            body lower on upper {
                mass: 1, com: [0, -1, 0], joint: revolute(z) at [0, -1, 0], coordinate: b, dry_friction: 0.2,
            }
        }
    }

    pub(super) fn model() -> (Three, Model) {
        let compiled = Three::new(ThreeParams {}).expect("valid");
        (compiled, Model::parse(TEXT).expect("valid"))
    }
}

const START: [f64; 4] = [1.5, 0.9, 0.8, 3.0];

fn named(name: &str) -> Named {
    let method = Named::new(name).expect("known");
    if method.is_fixed() {
        method.h(0.01)
    } else {
        method.rtol(1e-8).atol(1e-9)
    }
}

/// Compares each method on a compiled model and on one of the text.
macro_rules! same {
    ($compiled:expr, $model:expr, $start:expr) => {
        same!($compiled, $model, $start; Rk4 Gauss4 Gauss6 Gauss16 Rk45 Tsit5 Vern7 Vern9 Taylor Rodas4 Rodas5P Radau5
            Radau9 Radau13 Auto)
    };
    ($compiled:expr, $model:expr, $start:expr; $($name:ident)*) => { $({
        let method = named(stringify!($name));
        let own = $model.solve(&method, [0.0, 3.0], &$start).expect("regular");
        let compiled = set!($name).solve(&$compiled, 0.0, 3.0, $start).expect("regular");
        assert_eq!(own.end().1, compiled.end().as_slice(), stringify!($name));
        assert_eq!(own.t(), compiled.t());
        assert_eq!(own.statistics(), compiled.statistics());
        assert_eq!(own.modes().len(), compiled.modes().len());
        assert_eq!(own.impacts().len(), compiled.impacts().len());
        assert_eq!(own.at(1.234).expect("inside"), compiled.at(1.234).expect("inside").as_slice());
    })* };
}

macro_rules! set {
    (Rk4) => {
        Rk4::new(0.01)
    };
    (Gauss4) => {
        Gauss4::new(0.01)
    };
    (Gauss6) => {
        Gauss6::new(0.01)
    };
    (Gauss16) => {
        Gauss16::new(0.01)
    };
    ($name:ident) => {
        $name::new().rtol(1e-8).atol(1e-9)
    };
}

#[test]
fn every_method_has_the_bits_of_compiled_code() {
    let (compiled, model) = smooth::model();
    same!(compiled, model, START);
    let (compiled, model) = short::model();
    same!(compiled, model, [2.0, 0.3]);
    let (compiled, model) = long::model();
    let start = [0.1, 1.5, 0.9, 0.0, 0.8, -0.4];
    same!(compiled, model, start);
    let (compiled, model) = hybrid::model();
    same!(compiled, model, START);
    assert!(
        !model
            .solve(&named("Vern9"), [0.0, 3.0], &START)
            .expect("regular")
            .impacts()
            .is_empty()
    );
}

#[test]
fn functions_have_the_bits_of_compiled_code() {
    let (compiled, model) = smooth::model();
    let x = SVector::from(START);
    assert_eq!(model.rhs(0.5, &START).expect("4"), compiled.rhs(0.5, &x).as_slice());
    assert_eq!(
        model.jacobian(0.5, &START).expect("4").as_slice(),
        compiled.jacobian(0.5, &x).as_slice()
    );
    let energy = [compiled.kinetic(0.5, &x), compiled.potential(0.5, &x)];
    assert_eq!(model.energy(0.5, &START).expect("4"), energy);
    let tip = compiled.tip(0.5, &x);
    assert_eq!(model.outputs(), ["tip.x", "tip.y", "tip.z"]);
    assert_eq!(model.outputs_at(0.5, &START).expect("4"), [tip.x, tip.y, tip.z]);
    let matrix = &model.evaluate("mass_matrix", 0.5, &START, &[]).expect("generated")[0];
    assert_eq!(matrix.as_slice(), compiled.mass_matrix(0.5, &x).as_slice());
    let shapes = model.shapes(0.5, &START).expect("generated");
    assert_eq!(shapes, pendulum_core::shapes::Shapes::shapes(&compiled, 0.5, &x));
}

#[test]
fn a_model_says_what_it_is() {
    let (_, model) = smooth::model();
    assert_eq!(model.name(), "Double");
    let components: Vec<_> = model
        .components()
        .iter()
        .map(|own| (own.name.as_str(), own.unit.as_str()))
        .collect();
    let expected = [
        ("theta1", "rad"),
        ("theta2", "rad"),
        ("dot(theta1)", "rad/s"),
        ("dot(theta2)", "rad/s"),
    ];
    assert_eq!(components, expected);
    let parameters: Vec<_> = model
        .parameters()
        .iter()
        .map(|own| (own.name.as_str(), own.unit.as_str()))
        .collect();
    assert_eq!(parameters, [("l", "m"), ("m", "kg"), ("gamma", "N m s")]);
    assert_eq!(model.values(), [0.5, 1.0, 0.05]);
    assert!(
        model.equations().contains("A[theta1, theta1] ="),
        "{}",
        model.equations()
    );
    assert!(model.latex().contains(r"\ddot"), "{}", model.latex());
    let rhs = model
        .functions()
        .iter()
        .find(|function| function.name == "rhs")
        .expect("generated");
    assert_eq!(
        rhs.operations[3], 2,
        "a sine with its cosine for each angle: {:?}",
        rhs.operations
    );
    assert_eq!(model.events().collect::<Vec<_>>(), ["level"]);
    let (_, model) = hybrid::model();
    assert_eq!(model.docs(), "A rod with dry friction and a stop on a cart.");
    assert_eq!(model.constraints().collect::<Vec<_>>(), ["turn"]);
}

#[test]
fn ensembles_have_the_bits_of_single_motions() {
    for (model, name) in [
        (smooth::model().1, "Vern9"),
        (smooth::model().1, "Rk4"),
        (smooth::model().1, "Radau5"),
        (hybrid::model().1, "Vern9"),
    ] {
        let method = named(name);
        let count = 70;
        let starts: Vec<[f64; 4]> = (0..count).map(|n| START.map(|x| x * (1.0 - 0.01 * n as f64))).collect();
        let parameters: Vec<f64> = (0..count)
            .flat_map(|n| model.values().iter().map(move |value| value * (1.0 + 0.001 * n as f64)))
            .collect();
        let times = [0.5, 1.0, 2.0];
        let members = Members {
            starts: starts.as_flattened(),
            parameters: Some(&parameters),
            laws: &[],
            times: &times,
            cancel: None,
        };
        let together = model.ensemble(&method, [0.0, 2.0], &members).expect("valid");
        assert!(together.stopped.is_empty());
        for (n, start) in starts.iter().enumerate() {
            let length = model.values().len();
            let own = model
                .with_values(&parameters[n * length..(n + 1) * length])
                .expect("valid");
            let options = Options {
                times: Some(times.to_vec()),
                ..Options::default()
            };
            let alone = own.solve_with(&method, [0.0, 2.0], start, &options).expect("regular");
            assert_eq!(alone.t(), times);
            assert_eq!(&together.ends[4 * n..4 * n + 4], alone.end().1, "{name} {n}");
            assert_eq!(&together.samples[12 * n..12 * n + 12], alone.x(), "{name} {n}");
        }
    }
}

#[test]
fn events_are_those_of_functions_declarations_and_values() {
    let (_, model) = smooth::model();
    let declared = Options {
        events: vec![
            Event::declared("level"),
            Event::new(|_, x| x[3]).falling(),
            Event::value("theta1", 0.0).rising(),
            Event::value("tip.y", -0.5),
            Event::new(|t, _| t - 4.0).terminal(),
        ],
        ..Options::default()
    };
    let motion = model
        .solve_with(&named("Vern9"), [0.0, 10.0], &START, &declared)
        .expect("regular");
    assert_eq!(motion.ended_by(), Some(4));
    assert!((motion.end().0 - 4.0).abs() < 1e-12);
    for event in motion.occurrences() {
        let value = match event.index {
            0 | 1 => event.x[3],
            2 => event.x[0],
            3 => model.outputs_at(event.t, &event.x).expect("4")[1] + 0.5,
            _ => 0.0,
        };
        assert!(value.abs() < 1e-7, "{event:?}");
    }
    let count = |index| motion.occurrences().iter().filter(|event| event.index == index).count();
    assert!(count(0) >= count(1) && count(1) > 0 && count(2) > 0 && count(3) > 0);
}

#[test]
fn a_cancelled_motion_has_what_was_reached() {
    let (_, model) = smooth::model();
    let cancel = AtomicBool::new(false);
    let options = Options {
        events: vec![Event::new(|t, _| {
            if t > 1.0 {
                cancel.store(true, Ordering::Relaxed);
            }
            1.0
        })],
        cancel: Some(&|| cancel.load(Ordering::Relaxed)),
        ..Options::default()
    };
    let stopped = model
        .solve_with(&named("Vern9"), [0.0, 1e9], &START, &options)
        .expect_err("cancelled");
    assert_eq!(*stopped.error, Error::Integration(pendulum_core::Reason::Cancelled));
    let motion = stopped.motion.expect("it started");
    assert!(1.0 < motion.end().0 && motion.end().0 < 3.0);
    let members = Members {
        starts: &START.repeat(40),
        parameters: None,
        laws: &[],
        times: &[],
        cancel: Some(&cancel),
    };
    let together = model.ensemble(&named("Vern9"), [0.0, 1e9], &members).expect("valid");
    assert_eq!(together.stopped.len(), 40);
}

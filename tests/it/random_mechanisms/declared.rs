//! Some random mechanisms through the macro: in double and single precision, and in lanes.
//!
//! A test compares each text with the declaration for its seed, and prints the expected one.

use nalgebra::SVector;
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::{F32x8, F64x4, Lanes};
use pendulum_core::{Cast, InputLaw, Real};
use testbed::random::Random;
use testbed::source::declaration;
use testbed::trees::{Kind, Tree};

use super::compare::{Comparison, places};
use super::evaluate::Place;

mechanism! {
    /// Of the kind `Uneven`.
    pub Tree5 {
        units: none,
        params { p0: 1 = 0.5625, p1: 1 = -0.3125, p2: 1 = 1.625 }
        input u0: 1,
        gravity: [0, 0, 0],
        generate: [rhs, jacobian, energy],
        point a0 on ground at [-0.1875, 0.25, 0.6875],
        point a1 on b1 at [0, 0, 0.8125],
        point a2 on b0 at [-0.25, 0, p1],
        point a3 on b0 at [-0.25, -0.125, -0.625],
        force on a1: [p2, -0.75, -0.4375],
        spring between a0 and a1: (2.8125, 0.4375),
        force on a2: [0, 0.125, 0],
        spring between a1 and a2: (4.3125, 0),
        damper between a1 and a2: 0.875,
        force q0: -u0*dot(q0)^3,
        force q0: -u0*dot(q0)^3,
        output o0: [dot(a3.x), dot(a3.y), dot(a3.z)],
        body b0 on ground { mass: 0.00390625, com: [-0.5, 0.625, -0.0625],
            inertia: [0.00006103515625, 0.0009765625, 0.00103759765625],
            joint: revolute([3, 2, 0]) at [0, 0.1875, -0.75], coordinate: q0 }
        body b1 on b0 { mass: 0.03125, com: [0, 0.0625, 0], inertia: [0.01220703125, 0.016845703125, 0.01318359375,
            -0.0032958984375, -0.005126953125, 0.0015869140625], joint: prismatic([3, -1, -1]) rpy [0, 0, 0],
            coordinate: q1, torque: p0*q*cos(2*t) }
    }
}

mechanism! {
    /// Of the kind `Even`.
    pub Tree12 {
        units: none,
        params { p0: 1 = 0.5, p1: 1 = 0.125 }
        input u0: 1,
        gravity: [0, 0, 0],
        generate: [rhs, jacobian, energy],
        point a0 on ground at [0, p1, -0.625],
        point a1 on b2 at [0, 0, 0],
        point a2 on b2 at [-0.0625, -0.3125, 0.4375],
        point a3 on b2 at [-0.3125, -0.375, -0.5625],
        force on a1: [1.0625, -2, -0.5],
        spring between a0 and a1: (1.25, 0),
        damper between a0 and a1: 0.4375,
        force on a2: [0.3125, -1.3125, -0.25],
        force q0: -u0*dot(q1)^3,
        output o0: 0.1875*a3.z + a3.z*dot(a3.z),
        output o1: rotation(b0),
        body b0 on ground { mass: 0.125, com: [0.1875, 0.3125, 0.75],
            inertia: [0.0185546875, 0.0361328125, 0.03515625, 0.01318359375, -0.0146484375, 0.0087890625],
            joint: fixed rpy [-1.125, 0, 1.0625] }
        body b1 on b0 { solids: [cylinder(0.25, 0.375, [0, 0, 0], [0, 0, 0.3125])],
            joint: revolute([-3, 2, 0]) at [-0.0625, p0, 0.1875], coordinate: q0, torque: u0 }
        body b2 on b1 { mass: 0.5, com: [-0.25, -0.5, -0.625],
            inertia: [0.404296875, 0.435546875, 0.4140625, -0.08984375, 0.21484375, 0.08984375],
            joint: screw([1, 0, 0, -1, 0, -2]) at [0, 0, 0], coordinate: q1, spring: (6.75, -0.875) }
    }
}

mechanism! {
    /// Of the kind `Uneven`.
    pub Tree17 {
        units: none,
        params { p0: 1 = -0.1875 }
        gravity: [0, -9.8125, 0],
        generate: [rhs, jacobian, energy],
        dissipation: 0.875/2*(dot(q0) + dot(q1))^2,
        output o0: rotation(b0),
        body b0 on ground { joint: revolute([2, -3, 3]) at [-0.9375, 0, 0], motion: 3/8 }
        body b1 on b0 { solids: [cylinder(8, 0.25, [-0.25, 0.5625, -0.5625], [0.6875, 0.0625, -0.5625])],
            joint: revolute(z), coordinate: q0, friction: 0.9375, torque: -1.125*qd^3 }
        body b2 on b1 { solids: [cylinder(64, 0.5, [p0, 0, 0.375], [0.625, -0.5, 0.375]),
            cylinder(16, 0.375, [0, 0, 0.125], [0.375, -0.5, 0.125])], joint: revolute([1, -2, -2]) at [0, 0,
            0.875] rpy [0, 2.75, 0], coordinate: q1 }
    }
}

mechanism! {
    /// Of the kind `Even`.
    pub Tree24 {
        units: none,
        gravity: [0, 0, 0],
        generate: [rhs, jacobian, energy],
        point a0 on b0 at [0, 0.75, 0.625],
        event e0: a0.z - 0.625,
        body b0 on ground { mass: 1, com: [0, 0.0625, 0], inertia: [0.77734375, 0.7578125, 0.67578125, -0.0625,
            -0.0859375, 0.34765625], joint: revolute([1, -3, -3]) at [0.5625, 0.875, -0.6875], coordinate: q0,
            torque: 0.75*q*cos(2*t) }
        body b1 on b0 { mass: 4, com: [-0.25, 0, 0], inertia: [0.703125, 0.28125, 0.703125],
            joint: revolute(z) at [-0.4375, 0.3125, -0.5625] rpy [0, 0, 0], coordinate: q1, friction: 0.1875 }
        body b2 on ground { solids: [plate(8, [[0.3125, 0.0625], [-0.25, 0.625], [-1.1875, 0.5625],
            [-0.9375, -0.6875]])], joint: revolute(-x) at [0, 0, 0.125] rpy [0.3125, 2.4375, -0.125], coordinate: q2 }
    }
}

mechanism! {
    /// Of the kind `Uneven`.
    pub Tree27 {
        units: none,
        params { p0: 1 = 0.015625 }
        gravity: [0, 0, 0],
        generate: [rhs, jacobian, energy],
        point a0 on ground at [0.0625, -0.75, 0.875],
        point a1 on b2 at [-0.25, 0.5, -0.6875],
        point a2 on b1 at [0.5625, -0.9375, -0.0625],
        point a3 on b0 at [0.125, 0.9375, 0.375],
        spring between a0 and a1: (3, 0.125),
        spring between a1 and a2: (2.5, 0.625),
        output o0: [dot(a2.x), dot(a2.y), dot(a2.z)],
        output o1: [dot(a3.x), dot(a3.y), dot(a3.z)],
        event e0: a2.z - 0.3125,
        body b0 on ground { solids: [cylinder(128, 0.25, [0.6875, 0.6875, 0], [1.5, 0.1875, 0])],
            joint: revolute([-2, -1, -3]) at [-0.6875, 0.25, -0.25], coordinate: q0 }
        body b1 on b0 { mass: 0.0078125, com: [0.625, 0, -0.0625],
            inertia: [0.00506591796875, 0.00238037109375, 0.003173828125, 0, -0.00054931640625, -0.0015869140625],
            joint: helical([2, -1, 2], -0.3125), motion: sin(3*t/2)/2 }
        body b2 on b1 { mass: p0, com: [0.375, 0.5625, 0.25],
            inertia: [0.0020751953125, 0.00372314453125, 0.00274658203125],
            joint: prismatic([-3, 3, 3]) at [0.3125, 0.875, 0.75], coordinate: q1, friction: 0.6875 }
    }
}

mechanism! {
    /// Of the kind `Even`.
    pub Tree36 {
        units: none,
        params { p0: 1 = -0.625 }
        gravity: [0, -9.8125, 0],
        generate: [rhs, jacobian, energy],
        body b0 on ground { solids: [rod(0.5, [-0.5625, p0, 0.6875], [-0.5625, 0.1875, 0.6875])],
            joint: helical(z, -0.5) at [0.3125, -0.125, -0.6875] rpy [-0.6875, -2.25, -0.4375], coordinate: q0,
            friction: 0.0625 }
        body b1 on b0 { mass: 2, com: [-0.75, -0.5, -0.5], inertia: [0.15625, 0.1328125, 0.0390625],
            joint: screw([0, 0, 0, -1, 0, 0]) at [0, 0, 0], coordinate: q1, torque: 1 }
        body b2 on b1 { mass: 0.5, com: [0, -0.1875, -0.375],
            inertia: [0.177734375, 0.138671875, 0.13671875, 0.0390625, -0.05859375, 0.072265625],
            joint: screw([0, 0, -2, 1, 0, 0]) rpy [2.5625, 0, -2.4375], coordinate: q2, friction: 0.75 }
    }
}

mechanism! {
    /// Of the kind `Even`.
    pub Tree38 {
        units: none,
        params { p0: 1 = -0.875, p1: 1 = 0.125 }
        input u0: 1,
        input u1: 1,
        gravity: [p0, 0, 1.625],
        generate: [rhs, jacobian, energy],
        point a0 on b1 at [0, 0.5, 0],
        force q2: -u0*dot(q1)^3,
        force on a0: [0.75, 0, u1] in b0,
        output o0: [dot(a0.x), dot(a0.y), dot(a0.z)],
        body b0 on ground { mass: 0.125, com: [0, 0, 0], inertia: [0.03515625, 0.01318359375, 0.04345703125,
            0.0087890625, -0.00439453125, 0.00048828125], joint: revolute(x), coordinate: q0 }
        body b1 on ground { mass: 0.125, com: [-0.75, p1, 0.4375],
            inertia: [0.0595703125, 0.021484375, 0.041015625, -0.00048828125, -0.00341796875, 0.0185546875],
            joint: helical(x, -0.375), coordinate: q1 absolute, spring: (4.125, 0.5), torque: u0*q*cos(2*t) }
        body b2 on ground { mass: 4, com: [0.375, -0.0625, -0.4375],
            inertia: [0.734375, 2.640625, 2.34375, 0.125, 1, 0.03125], joint: prismatic(y) at [0.125, 0.9375, 0.25],
            coordinate: q2, torque: -0.25*sin(q) }
    }
}

mechanism! {
    /// Of the kind `Uneven`.
    pub Tree63 {
        units: none,
        gravity: [0, -9.8125, 0],
        generate: [rhs, jacobian, energy],
        body b0 on ground { mass: 0.0078125, com: [0.3125, -0.3125, 0.25],
            inertia: [0.001953125, 0.00244140625, 0.00323486328125, 0.001312255859375, 0.000457763671875,
            -0.000762939453125], joint: prismatic([-2, 1, 3]) at [0, 0, 0], motion: sin(3*t/2)/2 }
        body b1 on b0 { solids: [point(0.03125, [-0.4375, 0, -0.3125])], joint: fixed }
        body b2 on b1 { mass: 128, com: [-0.1875, 0.5625, 0.375], inertia: [4, 10, 10],
            joint: prismatic([-1, -1, 3]) at [-0.375, 0.625, 0.5625], coordinate: q0 }
        body b3 on ground { mass: 0.015625, com: [0, 0, 0], inertia: [0.0045166015625, 0.00250244140625,
            0.00396728515625], joint: prismatic([-1, -2, 3]), coordinate: q1 }
    }
}

macro_rules! each {
    ($($name:ident, $seed:literal, $kind:ident $(, $with_law:ident)?;)*) => {
        #[test]
        fn declarations_are_those_of_their_seeds() {
            $( {
                let tree = Tree::draw($seed, Kind::$kind, 3);
                let text = tree.declaration(stringify!($name), &["rhs", "jacobian", "energy"]);
                let own = declaration(include_str!("declared.rs"), stringify!($name));
                let own: String = own.lines().filter(|line| !line.contains("///")).collect();
                let plain = |text: &str| text.replace(char::is_whitespace, "").replace(",}", "}");
                assert_eq!(plain(&own), plain(&text), "it reads:\n{text}");
            } )*
        }

        #[test]
        fn number_types_move_as_newton_and_euler_say() {
            $( {
                let tree = Tree::draw($seed, Kind::$kind, 3);
                let model = $name::new(Default::default()).expect("physical");
                $( let model = model.$with_law(Held(tree.inputs[..].try_into().expect("all inputs"))); )?
                moves(stringify!($name), &tree, &model);
            } )*
        }
    };
}

each! {
    Tree5, 5, Uneven, with_law;
    Tree12, 12, Even, with_law;
    Tree17, 17, Uneven;
    Tree24, 24, Even;
    Tree27, 27, Uneven;
    Tree36, 36, Even;
    Tree38, 38, Even, with_law;
    Tree63, 63, Uneven;
}

/// Constant inputs.
#[derive(Clone, PartialEq)]
struct Held<const M: usize>([f64; M]);

impl<const N: usize, const M: usize> InputLaw<N, M> for Held<M> {
    fn inputs<T: Real>(&self, _t: T, _x: &SVector<T, N>) -> [T; M] {
        self.0.map(T::from_f64)
    }
}

/// Checks the right-hand side and the Jacobian against the oracle, and lanes against scalars, bit for bit.
fn moves<M, const N: usize>(name: &str, tree: &Tree, model: &M)
where
    M: Cast<N> + Jacobian<f64, N>,
{
    let mut random = Random::new(3);
    for place in places(tree, &mut random) {
        // numbers representable in single precision
        let single = |x: &f64| f64::from(*x as f32);
        let place = Place {
            t: single(&place.t),
            state: place.state.iter().map(single).collect(),
            inputs: tree.inputs.clone(),
            ..place
        };
        let (truth, x) = (
            Comparison::new(tree, &place),
            SVector::<f64, N>::from_column_slice(&place.state),
        );
        let (rates, jacobian) = model.rhs_and_jacobian(place.t, &x);
        let errors = [
            truth.of_rates(model.rhs(place.t, &x).as_slice()),
            truth.of_rates(rates.as_slice()),
            truth.of_jacobian(rates.as_slice(), jacobian.as_slice()),
        ];
        assert!(errors.iter().all(|error| *error < 1e-12), "{name}: {errors:?}");
        let rates = model.cast::<f32>().rhs(place.t as f32, &x.map(|x| x as f32));
        let error = truth.of_rates(&rates.iter().map(|&rate| f64::from(rate)).collect::<Vec<_>>());
        assert!(error < 1e-5, "{name} in single precision: {error:e}");
        same_in_lanes::<M, F64x4, N>(name, model, &place);
        same_in_lanes::<M, F32x8, N>(name, model, &place);
    }
}

/// Checks lanes with a different state in each.
fn same_in_lanes<M: Cast<N>, V: Lanes, const N: usize>(name: &str, model: &M, place: &Place) {
    let scalar = |value: f64| <V::Scalar as Real>::from_f64(value);
    let state = |lane: usize| SVector::<V::Scalar, N>::from_fn(|n, _| scalar(place.state[n] + 0.1 * lane as f64));
    let time = |lane: usize| scalar(place.t - 0.2 * lane as f64);
    let x = SVector::<V, N>::from_fn(|n, _| V::from_fn(|lane| state(lane)[n]));
    let rates = model.cast::<V>().rhs(V::from_fn(time), &x);
    for lane in 0..V::LANES {
        let own = model.cast::<V::Scalar>().rhs(time(lane), &state(lane));
        assert_eq!(rates.map(|rate| rate.lane(lane)), own, "{name} in lane {lane}");
    }
}

//! Reference motions of `testbed/data/motions.json`, which records their origin, and hand-written equations for them.

use nalgebra::SVector;
use pendulum_core::real::Real;
use pendulum_core::real::lanes::Lanes;
use pendulum_core::{Cast, System};
use serde_json::Value;

/// Motion of a body about a fixed point, with sampled states `[w, x, y, z, wx, wy, wz]`.
#[derive(Clone, Debug)]
pub struct Motion {
    pub x0: SVector<f64, 7>,
    /// Sample times, each with the state.
    pub states: Vec<(f64, SVector<f64, 7>)>,
}

/// Loads the motion named `name`.
pub fn motion(name: &str) -> Motion {
    let data: Value = serde_json::from_str(include_str!("../data/motions.json")).expect("motions.json is JSON");
    let motions = list(&data["motions"]);
    let motion = motions
        .iter()
        .find(|motion| motion["name"] == name)
        .expect("a motion of that name");
    let times = list(&motion["times"]).iter().map(number);
    let states = list(&motion["states"]).iter().map(state);
    Motion {
        x0: state(&motion["x0"]),
        states: times.zip(states).collect(),
    }
}

fn list(value: &Value) -> &Vec<Value> {
    value.as_array().expect("a list")
}

fn state(value: &Value) -> SVector<f64, 7> {
    SVector::from_iterator(list(value).iter().map(number))
}

fn number(value: &Value) -> f64 {
    value.as_str().and_then(|text| text.parse().ok()).expect("a number")
}

/// Euler's equations of a body with a fixed point, whose centre of mass lies on the z axis of its frame.
#[derive(Clone, Copy, Debug)]
pub struct Top<T = f64> {
    /// Principal moments of inertia about the fixed point.
    pub inertia: [T; 3],
    /// Mass, times gravity along -z, times the z coordinate of the centre of mass.
    pub weight: T,
    pub friction: T,
}

impl Top {
    /// The heavy top of Kynema's tests.
    pub const HEAVY: Self = Self {
        inertia: [15.234_375, 15.234_375, 0.468_75],
        weight: 15.0 * 9.81,
        friction: 0.0,
    };
    /// A spherical pendulum with friction.
    pub const SPHERICAL: Self = Self {
        inertia: [0.04 + 1.3 * 0.36, 0.07 + 1.3 * 0.36, 0.05],
        weight: -1.3 * 9.81 * 0.6,
        friction: 0.02,
    };
    /// A body that tumbles about its intermediate axis.
    pub const FREE: Self = Self {
        inertia: [2.0, 1.0, 0.3],
        weight: 0.0,
        friction: 0.0,
    };
}

impl<T: Real> Top<T> {
    /// Twice the kinetic energy, and the potential energy.
    pub fn energies(&self, x: &SVector<T, 7>) -> [T; 2] {
        let [a, b, c] = self.inertia;
        let (w, q) = ([x[4], x[5], x[6]], [x[0], x[1], x[2], x[3]]);
        let up = q[0] * q[0] - q[1] * q[1] - q[2] * q[2] + q[3] * q[3];
        [a * w[0] * w[0] + b * w[1] * w[1] + c * w[2] * w[2], self.weight * up]
    }
}

impl<T: Real> System<T, 7> for Top<T> {
    fn rhs(&self, _t: T, x: &SVector<T, 7>) -> SVector<T, 7> {
        let [a, b, c] = self.inertia;
        let [s, i, j, k, p, q, r] = x.data.0[0];
        let (half, two) = (T::from_f64(0.5), T::from_f64(2.0));
        // the vertical in body coordinates
        let [ux, uy] = [two * (i * k - s * j), two * (j * k + s * i)];
        let (weight, friction) = (self.weight, self.friction);
        SVector::from([
            -half * (i * p + j * q + k * r),
            half * (s * p + j * r - k * q),
            half * (s * q + k * p - i * r),
            half * (s * r + i * q - j * p),
            ((b - c) * q * r + weight * uy - friction * p) / a,
            ((c - a) * r * p - weight * ux - friction * q) / b,
            ((a - b) * p * q - friction * r) / c,
        ])
    }

    fn project(&self, _t: T, x: &mut SVector<T, 7>) {
        let square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3];
        let norm = square.sqrt();
        for n in 0..4 {
            x[n] /= norm;
        }
    }
}

impl Cast<7> for Top {
    type In<T: Real> = Top<T>;

    fn cast<T: Real>(&self) -> Top<T> {
        Top {
            inertia: self.inertia.map(T::from_f64),
            weight: T::from_f64(self.weight),
            friction: T::from_f64(self.friction),
        }
    }

    fn gather<'m, V: Lanes>(models: impl Fn(usize) -> &'m Self) -> Top<V> {
        let each = |of: &dyn Fn(&Self) -> f64| V::from_fn(|lane| Real::from_f64(of(models(lane))));
        Top {
            inertia: [0, 1, 2].map(|n| each(&|top| top.inertia[n])),
            weight: each(&|top| top.weight),
            friction: each(&|top| top.friction),
        }
    }
}

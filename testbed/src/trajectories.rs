//! Reference trajectories of `testbed/data/trajectories.json`, which records their origin.

use nalgebra::SVector;
use serde_json::Value;

use crate::eq22::{Eq22, Plate};

/// Planar scene with sampled states, rounded to the nearest double.
#[derive(Clone, Debug)]
pub struct Scene {
    pub name: String,
    pub g: f64,
    /// Initial angles, absolute and from the downward vertical, then their rates.
    pub x0: Vec<f64>,
    pub times: Vec<f64>,
    /// State at each of `times`.
    pub states: Vec<Vec<f64>>,
    pub bodies: Vec<Body>,
}

/// Body of a scene; `d` is the distance between its two joints.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    pub mass: f64,
    pub inertia: f64,
    pub c: f64,
    pub d: f64,
    pub friction: f64,
}

/// Loads the scene named `name`.
pub fn scene(name: &str) -> Scene {
    scenes()
        .into_iter()
        .find(|scene| scene.name == name)
        .unwrap_or_else(|| panic!("no scene {name}"))
}

/// Loads all scenes.
pub fn scenes() -> Vec<Scene> {
    let text = include_str!("../data/trajectories.json");
    let data: Value = serde_json::from_str(text).expect("trajectories.json is JSON");
    list(&data["scenes"]).iter().map(read_scene).collect()
}

impl Scene {
    /// Initial state as an array.
    pub fn start<const N: usize>(&self) -> [f64; N] {
        self.x0.as_slice().try_into().expect("length of the state")
    }

    /// Reference states as arrays, each with its time.
    pub fn points<const N: usize>(&self) -> Vec<(f64, [f64; N])> {
        let state = |state: &Vec<f64>| state.as_slice().try_into().expect("length of the state");
        let states = self.states.iter().map(state);
        self.times.iter().copied().zip(states).collect()
    }

    /// Returns the reference state at a sample time.
    ///
    /// # Panics
    /// If `t` is not one of `times`.
    pub fn state<const N: usize>(&self, t: f64) -> SVector<f64, N> {
        let mut points = self.points().into_iter();
        let point = points.find(|point| point.0 == t);
        SVector::from(point.expect("a time of the scene").1)
    }

    /// Hand-written model of a scene with two bodies.
    pub fn eq22(&self) -> Eq22 {
        let [upper, lower] = self.bodies[..] else {
            panic!("{} has {} bodies", self.name, self.bodies.len())
        };
        let plate = |body: Body| Plate {
            mass: body.mass,
            inertia: body.inertia,
            c: body.c,
            friction: body.friction,
        };
        Eq22::new(plate(upper), plate(lower), upper.d, self.g)
    }
}

fn read_scene(scene: &Value) -> Scene {
    Scene {
        name: scene["name"].as_str().expect("name").to_owned(),
        g: number(&scene["g"]),
        x0: numbers(&scene["x0"]),
        times: numbers(&scene["times"]),
        states: list(&scene["states"]).iter().map(numbers).collect(),
        bodies: list(&scene["bodies"]).iter().map(read_body).collect(),
    }
}

fn read_body(body: &Value) -> Body {
    Body {
        mass: number(&body["mass"]),
        inertia: number(&body["inertia"]),
        c: number(&body["c"]),
        d: number(&body["d"]),
        friction: number(&body["friction"]),
    }
}

fn list(value: &Value) -> &Vec<Value> {
    value.as_array().expect("a list")
}

fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

/// Parses a number, a decimal string, or degrees: "4deg" stands for the double nearest to 4 pi/180.
fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) if text == "4deg" => 0.069_813_170_079_773_18,
        Value::String(text) => text.parse().expect("a decimal number"),
        _ => value.as_f64().expect("a number"),
    }
}

//! Accelerations for mass ratios from 1e-8 to 1e8 with their condition numbers, from `testbed/data/mass_ratios.json`,
//! which records their origin, and the generated right-hand sides of the same scenes.

use std::collections::BTreeMap;

use nalgebra::SVector;
use pendulum_core::prelude::*;
use serde_json::Value;

use crate::lopsided::*;
use crate::plates::{Plates, PlatesParams};

/// Scene with its samples.
#[derive(Clone, Debug)]
pub struct Scene {
    pub name: String,
    pub samples: Vec<Sample>,
}

/// State of a scene for one mass ratio.
#[derive(Clone, Debug)]
pub struct Sample {
    pub ratio: f64,
    pub parameters: Parameters,
    /// Coordinates, then rates.
    pub state: Vec<f64>,
    /// Rounded to the nearest double, with an error of up to half an ulp.
    pub acceleration: Vec<f64>,
    /// For each acceleration, the sum over all parameters and state variables `p` of `|p dqdd/dp|`.
    pub condition: Vec<f64>,
}

/// Parameters by name; the reference treats their doubles as exact.
#[derive(Clone, Debug)]
pub struct Parameters(BTreeMap<String, f64>);

/// Loads all scenes.
pub fn scenes() -> Vec<Scene> {
    let data: Value = serde_json::from_str(include_str!("../data/mass_ratios.json")).expect("valid JSON");
    list(&data["scenes"]).iter().map(scene).collect()
}

impl Sample {
    /// Condition number: the largest change of an acceleration, relative to the largest acceleration, per unit of
    /// relative change of all inputs.
    pub fn kappa(&self) -> f64 {
        largest(&self.condition) / largest(&self.acceleration)
    }

    /// Relative error that the conditioning explains.
    pub fn bound(&self) -> f64 {
        f64::EPSILON * (1.0 + self.kappa())
    }

    /// Largest error of `accelerations`, relative to the largest acceleration.
    pub fn error_of(&self, accelerations: &[f64]) -> f64 {
        let errors = accelerations
            .iter()
            .zip(&self.acceleration)
            .map(|(ours, exact)| ours - exact);
        largest(&errors.collect::<Vec<f64>>()) / largest(&self.acceleration)
    }
}

impl Parameters {
    /// Returns the parameter named `name`.
    pub fn get(&self, name: &str) -> f64 {
        *self.0.get(name).unwrap_or_else(|| panic!("no parameter {name}"))
    }
}

/// Builds a model, with parameters from the data by name.
macro_rules! model {
    ($model:ident, $params:ident { $($name:ident),* }, $given:expr) => {
        $model::new($params { $($name: $given.get(stringify!($name))),* }).expect("physical")
    };
}

/// Accelerations of the generated right-hand side of a scene for a sample.
pub fn generated(scene: &str, sample: &Sample) -> Vec<f64> {
    let (p, x) = (&sample.parameters, &sample.state);
    match scene {
        "points" => accelerations(&model!(Points, PointsParams { m1, m2, l1, l2, g }, p), x),
        "points_relative" => accelerations(
            &model!(RelativePoints, RelativePointsParams { m1, m2, l1, l2, g }, p),
            x,
        ),
        "plates" | "plates_slight" => {
            let plates = model!(
                Plates,
                PlatesParams {
                    m1,
                    m2,
                    inertia1,
                    inertia2,
                    c1,
                    c2,
                    d,
                    g,
                    gamma1,
                    gamma2
                },
                p
            );
            accelerations(&plates, x)
        }
        "cart" => accelerations(&model!(Cart, CartParams { m1, m2, l, g }, p), x),
        "chain_last" | "chain_middle" => accelerations(
            &model!(
                Chain,
                ChainParams {
                    m1,
                    m2,
                    m3,
                    l1,
                    l2,
                    l3,
                    g
                },
                p
            ),
            x,
        ),
        "arm" => accelerations(
            &model!(
                Arm,
                ArmParams {
                    m1,
                    m2,
                    m3,
                    l1,
                    l2,
                    l3,
                    g
                },
                p
            ),
            x,
        ),
        _ => panic!("no scene {scene}"),
    }
}

fn accelerations<const N: usize>(model: &impl System<f64, N>, state: &[f64]) -> Vec<f64> {
    let rhs = model.rhs(0.0, &SVector::from_column_slice(state));
    rhs.as_slice()[N / 2..].to_vec()
}

fn scene(scene: &Value) -> Scene {
    let name = scene["name"].as_str().expect("a name").to_owned();
    let states: Vec<Vec<f64>> = list(&scene["states"]).iter().map(numbers).collect();
    let samples = list(&scene["cases"])
        .iter()
        .flat_map(|case| samples(case, &states))
        .collect();
    Scene { name, samples }
}

fn samples(case: &Value, states: &[Vec<f64>]) -> Vec<Sample> {
    let given = case["parameters"].as_object().expect("parameters");
    let parameters = Parameters(
        given
            .iter()
            .map(|(name, value)| (name.clone(), number(value)))
            .collect(),
    );
    let samples = list(&case["samples"]);
    assert_eq!(samples.len(), states.len(), "one sample for each state");
    let ratio = number(&case["ratio"]);
    let sample = |(sample, state): (&Value, &Vec<f64>)| Sample {
        ratio,
        parameters: parameters.clone(),
        state: state.clone(),
        acceleration: numbers(&sample["acceleration"]),
        condition: numbers(&sample["condition"]),
    };
    samples.iter().zip(states).map(sample).collect()
}

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

/// Parses a number. The digits are strings, as they are more than a double holds; `parse` rounds to the nearest double.
fn number(value: &Value) -> f64 {
    value.as_str().expect("digits").parse().expect("a number")
}

/// Largest magnitude; NaN if any value is NaN.
fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| {
        if value.is_nan() || value.abs() > most {
            value.abs()
        } else {
            most
        }
    })
}

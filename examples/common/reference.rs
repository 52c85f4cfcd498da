//! The reference trajectories of `tests/data/trajectories.json`: extrapolation in 45-digit arithmetic.

use std::error::Error;

use pendulum_core::prelude::SVector;
use serde_json::Value;

/// The state of a scene at one of its times: the angles (absolute, rad), then their rates (rad/s).
pub(crate) fn state(scene: &str, t: f64) -> Result<SVector<f64, 4>, Box<dyn Error>> {
    let data: Value = serde_json::from_str(include_str!("../../tests/data/trajectories.json"))?;
    let missing = || format!("the reference data have no state of {scene} at {t} s");
    let scene = items(&data["scenes"]).find(|item| item["name"] == scene);
    let scene = scene.ok_or_else(missing)?;
    let n = items(&scene["times"]).position(|time| time.as_f64() == Some(t));
    // The digits are written as strings, since they are more than a double holds.
    let digits: [String; 4] = serde_json::from_value(scene["states"][n.ok_or_else(missing)?].clone())?;
    let mut state = SVector::<f64, 4>::zeros();
    for (component, digits) in state.iter_mut().zip(digits) {
        *component = digits.parse()?;
    }
    Ok(state)
}

fn items(list: &Value) -> impl Iterator<Item = &Value> {
    list.as_array().into_iter().flatten()
}

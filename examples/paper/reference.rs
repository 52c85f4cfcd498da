//! The reference trajectories, computed in 45-digit arithmetic; the file says how.

use std::error::Error;

use pendulum_core::prelude::SVector;
use serde_json::Value;

use crate::END;

/// What is known of the motion with one friction.
pub struct Reference {
    /// The state at [`END`], to the nearest double.
    pub end: SVector<f64, 4>,
}

impl Reference {
    /// The paper's pendulum with the friction `gamma`.
    pub fn of(gamma: f64) -> Result<Self, Box<dyn Error>> {
        let name = format!("paper_gamma_{gamma}");
        let data: Value = serde_json::from_str(include_str!("../../tests/data/trajectories.json"))?;
        let mut scenes = data["scenes"].as_array().into_iter().flatten();
        let scene = scenes.find(|scene| scene["name"] == name.as_str());
        let end = scene
            .and_then(end_state)
            .ok_or_else(|| format!("no end state at {END} s of {name}"))?;
        Ok(Self { end })
    }
}

/// The last state of a scene, whose numbers are decimal strings.
fn end_state(scene: &Value) -> Option<SVector<f64, 4>> {
    let last = scene["times"].as_array()?.last()?.as_f64()?;
    let state = scene["states"].as_array()?.last()?.as_array()?;
    let numbers: Option<Vec<f64>> = state.iter().map(|number| number.as_str()?.parse().ok()).collect();
    let numbers: [f64; 4] = numbers?.try_into().ok()?;
    (last == END).then(|| SVector::from(numbers))
}

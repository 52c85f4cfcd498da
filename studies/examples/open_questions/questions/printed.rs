//! Rust from symbols: the tip of an arm and its Jacobian.

use std::error::Error;

use pendulum_core::prelude::*;

use super::Answer;

mechanism! {
    /// An arm of three joints; only the position of its tip is generated.
    pub Arm {
        params { a: m = 0.4, b: m = 0.4, c: m = 0.2 }
        body column on ground { joint: revolute(z), coordinate: yaw }
        body upper on column { joint: revolute(y), coordinate: shoulder }
        body lower on upper { joint: revolute(y) at [a, 0, 0], coordinate: elbow }
        point tip on lower at [b, 0, c],
        output tip: tip,
        generate: [],
    }
}

pub(crate) fn answer() -> Result<Answer, Box<dyn Error>> {
    let cost = &Arm::<f64>::COST["tip_and_jacobian"];
    let text = format!("the tip and its Jacobian: {cost}");
    Ok(Answer::new(cost.flops() as f64, text))
}

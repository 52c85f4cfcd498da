//! Equations that are generated at once: ten links on a cart.

use std::error::Error;
use std::time::Instant;

use pendulum_core::prelude::*;
use testbed::source::declaration;

use super::Answer;

mechanism! {
    /// Ten massless links with a bob each, on a cart that a force pushes.
    pub Links {
        params { m: kg = 0.1, l: m = 0.1 }
        input push: N,
        gravity: [0, -9.81, 0],
        shape link { solids: [point(m, [0, -l, 0])] }
        body cart on ground { mass: m, joint: prismatic(x), coordinate: s, torque: push }
        body link1 on cart: link { joint: revolute(z), coordinate: q1 absolute }
        body link2 on link1: link { joint: revolute(z) at [0, -l, 0], coordinate: q2 absolute }
        body link3 on link2: link { joint: revolute(z) at [0, -l, 0], coordinate: q3 absolute }
        body link4 on link3: link { joint: revolute(z) at [0, -l, 0], coordinate: q4 absolute }
        body link5 on link4: link { joint: revolute(z) at [0, -l, 0], coordinate: q5 absolute }
        body link6 on link5: link { joint: revolute(z) at [0, -l, 0], coordinate: q6 absolute }
        body link7 on link6: link { joint: revolute(z) at [0, -l, 0], coordinate: q7 absolute }
        body link8 on link7: link { joint: revolute(z) at [0, -l, 0], coordinate: q8 absolute }
        body link9 on link8: link { joint: revolute(z) at [0, -l, 0], coordinate: q9 absolute }
        body link10 on link9: link { joint: revolute(z) at [0, -l, 0], coordinate: q10 absolute }
        generate: [rhs],
    }
}

pub(crate) fn answer() -> Result<Answer, Box<dyn Error>> {
    let text = declaration(include_str!("generation.rs"), "Links");
    let tokens = text.parse()?;
    let since = Instant::now();
    let items = pendulum_codegen::expand(tokens);
    let seconds = since.elapsed().as_secs_f64();
    if items.to_string().contains("compile_error") {
        return Err("the declaration is rejected".into());
    }
    let operations = Links::<f64>::COST["rhs"].flops();
    let text = format!("the accelerations of ten links take {operations} operations");
    Ok(Answer {
        figure: operations as f64,
        text,
        seconds: Some(seconds),
    })
}

//! Finds the simplest model of a double pendulum with a stiff joint at its end, for a motion that starts at an angle.
//!
//! `cargo run --release --example simplest -- 5` takes the angle in degrees.

use pendulum_runtime::{Declaration, Question, simplest};

const TEXT: &str = "pub Double {
    params { gamma: N m s = 0.001, k: N m/rad = 300 }
    gravity: [0, -9.8, 0],
    shape link { mass: 1, com: [0, -1, 0], inertia: 1 }
    body upper on ground: link { joint: revolute(z), coordinate: theta1, friction: gamma }
    body lower on upper: link { joint: revolute(z) at [0, -1, 0], coordinate: theta2 }
    body tip on lower {
        mass: 0.1, com: [0, -0.1, 0],
        joint: revolute(z) at [0, -2, 0],
        coordinate: beta,
        spring: (k, 0),
    }
    point end on tip at [0, -0.2, 0],
    output end: end,
}";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let degrees: f64 = std::env::args().nth(1).map_or(Ok(5.0), |text| text.parse())?;
    let question = Question {
        starts: vec![vec![degrees.to_radians(), 0.0, 0.0, 0.0, 0.0, 0.0]],
        horizon: 5.0,
        outputs: ["theta1", "end.x"].map(str::to_owned).into(),
        ..Question::default()
    };
    let answer = simplest(&Declaration::new(TEXT), &question)?;
    println!("{answer}");
    if let Some(simplest) = answer.simplest() {
        println!("\n{}", simplest.declaration);
    }
    Ok(())
}

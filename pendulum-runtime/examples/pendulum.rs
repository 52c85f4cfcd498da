//! Declares a double pendulum in a string, and integrates it by every method.

use pendulum_runtime::{Members, Method, Model, Options};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let begin = std::time::Instant::now();
    let text = "pub DoublePendulum {
        params { l: m = 0.5, m: kg = 1.0 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, canonical, taylor],
        body upper on ground { mass: m, com: [0, -l, 0], joint: revolute(z), coordinate: theta1 }
        body lower on upper { mass: m, com: [0, -l, 0], joint: revolute(z) at [0, -l, 0], coordinate: theta2 }
    }";
    let model = Model::parse(text)?;
    let start = model.state(&[("theta1", 1.0), ("theta2", 0.5)])?;
    println!("{}", model.equations());
    println!(
        "the first evaluation after {:.1} ms: {:?}",
        begin.elapsed().as_secs_f64() * 1e3,
        model.rhs(0.0, &start)?
    );
    for name in Method::NAMES {
        let method = Method::new(name)?;
        let method = if method.is_fixed() {
            method.h(0.01)
        } else {
            method.rtol(1e-9).atol(1e-9)
        };
        let motion = model.solve_with(&method, [0.0, 2.0], &start, &Options::default())?;
        let members = Members {
            starts: &start.repeat(10),
            parameters: None,
            laws: &[],
            times: &[],
            cancel: None,
        };
        let together = model.ensemble(&method, [0.0, 2.0], &members)?;
        assert_eq!(&together.ends[36..], motion.end().1);
        println!("{name:8} {:?}", motion.end().1);
    }
    Ok(())
}

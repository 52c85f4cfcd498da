//! Robots from files.

use std::path::Path;

use pendulum_runtime::{Method, Model, Robot};

fn file(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../testbed/data/urdf")
        .join(name)
}

#[test]
fn a_robot_moves() {
    let model = Model::urdf(file("ur5.urdf")).expect("valid");
    assert_eq!(model.components().len(), 12);
    let x: Vec<f64> = (0..12).map(|n| 0.1 * f64::from(n)).collect();
    let method = Method::new("Vern9").expect("known");
    let motion = model.solve(&method, [0.0, 0.5], &x).expect("regular");
    assert_eq!(motion.end().0, 0.5);
    // inverse dynamics at the accelerations of the motion is zero torque, but for the damping of the joints
    let rates = model.rhs(0.0, &x).expect("12");
    let torques = &model
        .evaluate("inverse_dynamics", 0.0, &x, &[&rates[6..]])
        .expect("generated")[0];
    assert!(torques.amax() < 1e-9, "{torques}");
}

#[test]
fn a_robot_has_options() {
    let robot = Robot::new(file("ur5.urdf"))
        .gravity([0.0; 3])
        .limits(true)
        .generate(["rhs"]);
    let model = Model::robot(&robot).expect("valid");
    assert_eq!(model.constraints().count(), 6);
    let rest = [0.0; 12];
    assert_eq!(model.rhs(0.0, &rest).expect("12"), rest);
}

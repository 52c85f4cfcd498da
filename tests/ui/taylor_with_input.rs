pendulum_core::mechanism! {
    pub Arm {
        input push: N m,
        generate: [rhs, taylor],
        body a on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: x1, torque: push }
    }
}

fn main() {
    let arm = Arm::new(ArmParams {}).unwrap();
    let mut x = [pendulum_core::nalgebra::SVector::from([0.0_f64, 1.0]); 3];
    let mut work = pendulum_core::TaylorSeries::<f64, 2>::workspace(&arm);
    pendulum_core::TaylorSeries::series(&arm, 0.0, &mut x, &mut work);
}

//! One mistake is one error, whatever the model is used for.

use pendulum_core::prelude::*;

mechanism! {
    pub Cart {
        params { m: kg = 1 }
        input push: N,
        generate: [rhs, jacobian, energy, mass_matrix, bias, momentum, inverse_dynamics, parameter_jacobian,
            drive_forces, shapes],
        point tip on cart at [1, 0, 0],
        output tip: tip,
        output turned: rotation(cart),
        output reach: tip.x,
        output speed: dot(tip.x),
        event arrives: tip.x - 1,
        let swing = 1*sin(1 rad/s*t),
        body still on ground { joint: prismatic(x), motion: 1 }
        body shaken on still { joint: prismatic(x), motion: swing }
        body cart ground { mass: m, joint: prismatic(x), coordinate: s, torque: push }
    }
}

mechanism! {
    pub Rusty {
        body rod on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta, dry_friction: -1 }
    }
}

mechanism! {
    pub Top {
        body top on ground { mass: 1, com: [0, 0, 1], inertia: [1, 1, 1], joint: ball, orientation: o depends }
    }
}

mechanism! {
    pub Arm {
        robot: urdf("../pendulum-codegen/tests/robots/bad_number.urdf"),
        body load on hand { mass: 1, joint: revolute(x), coordinate: swing }
    }
}

mechanism! {
    pub Crank {
        body crank on ground { mass: 1, com: [0.1, 0, 0], joint: revolute(z), coordinate: a, friction: 1 kg }
        body coupler on crank { mass: 1, joint: revolute(z) at [0.2, 0, 0], coordinate: b depends near -1 }
        body slide on ground { mass: 1, joint: prismatic(x), coordinate: x depends near 0.5 }
        close coupler at [0.4, 0, 0] to slide: revolute(z),
    }
}

mechanism! {
    pub Bennett {
        body first on ground { mass: 1, joint: revolute(z), coordinate: u, dry_friction: a }
        body second on first { mass: 1, joint: revolute([0, 1, 1]) at [0.5, 0, 0], coordinate: v depends near 1 }
        body third on ground { mass: 1, joint: revolute([0, 1, 2]) at [0.3, 0, 0], coordinate: w depends near 1 }
        close second at [0.3, 0, 0] to third at [0.5, 0, 0]: ball,
    }
}

fn main() {
    let crank = Crank::new(CrankParams {}).unwrap();
    let rest = crank.potential(0.0, &SVector::zeros());
    let moved = Rodas5P::new().solve(&crank, 0.0, 1.0, [rest, 0.0]).unwrap();
    let torques = crank.inverse_dynamics(0.0, &SVector::zeros(), &SVector::zeros());
    println!("{torques} {}", moved.end().transpose());
    let bennett = Bennett::new(BennettParams {}).unwrap();
    let closed = bennett.assemble(0.0, [0.1, 1.0, 1.0, 0.0]).unwrap();
    println!("{}", Vern9::new().solve(&bennett, 0.0, 1.0, closed).unwrap().end()[Bennett::W]);
    let top = Top::new(TopParams {}).unwrap();
    let spun = Vern9::new().solve(&top, 0.0, 1.0, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
    let arm = Arm::new(ArmParams {}).unwrap();
    let swung = Rodas5P::new().solve(&arm, 0.0, 1.0, [0.0; 4]).unwrap();
    println!("{} {} {}", spun.end()[Top::O], swung.end()[Arm::WRIST], swung.end()[Arm::DOT_SWING]);
    let rusty = Rusty::new(RustyParams {}).unwrap();
    let stuck = Rodas5P::new().solve(&rusty, 0.0, 1.0, [0.0, 0.0]).unwrap();
    let (_, mode) = stuck.modes()[0];
    println!("{}", mode.describe(rusty.constraints()));
    let cart = Cart::new(CartParams { m: 2.0 }).unwrap();
    let pushed = cart.with_inputs(|_t, _x: &SVector<f64, 2>| CartInputs { push: 1.0 });
    let solution = Rk45::new().solve(&pushed, 0.0, 1.0, [0.0, 0.0]).unwrap();
    let mut x = solution.end();
    cart.project(0.0, &mut x);
    cart.margins(0.0, &x, &mut |_, _| {});
    let _ = (cart.layout(), cart.mass_matrix(0.0, &x), cart.bias(0.0, &x), cart.energy(0.0, &x), cart.params().m);
    let _ = (cart.momentum(0.0, &x), cart.inverse_dynamics(0.0, &x, &[1.0]));
    let _ = cart.parameter_jacobian(0.0, &x, &CartInputs { push: 1.0 });
    let _: (SVector<f64, 3>, f64) = (cart.tip(0.0, &x), cart.reach_rate(0.0, &x));
    let _: (SMatrix<f64, 3, 3>, SMatrix<f64, 9, 2>) = cart.turned_and_jacobian(0.0, &x);
    let u = CartInputs { push: 1.0 };
    let _ = (cart.speed_rate(0.0, &x, &u), cart.output_rates(0.0, &x, &u));
    let _: SVector<f64, 1> = cart.drive_forces(0.0, &x, &u);
    let _ = (cart.outputs(0.0, &x), cart.arrives(0.0, &x), cart.shapes(0.0, &x));
    let _ = Rk45::new().solve_with(&pushed, 0.0, 1.0, [0.0, 0.0], &[cart.arrives_event().terminal()]);
    let _ = (Cart::DOF, Cart::COORDINATES, Cart::COST, Cart::LAYOUT, Cart::EQUATIONS, cart.cast::<f32>());
}

//! Controllers in C: what is printed, and what is refused. `tests/it/controllers.rs` compiles and runs them.

use pendulum_codegen::program::Program;
use pendulum_codegen::{Controller, Ilqr, NoController};

const ARM: &str = "
    pub Arm {
        input motor: N m,
        input brake: N m,
        body rod on ground {
            mass: 1, com: [0, 1, 0], joint: revolute(z), coordinate: angle, torque: motor - brake*qd/(1 rad/s),
        }
    }";

fn program(scene: &str) -> Program {
    pendulum_codegen::program(scene.parse().expect("tokens")).expect("no errors")
}

fn plan() -> Ilqr {
    Ilqr::new(0.02, 2, &[1.0, 0.0, 0.0, 0.3], &[0.1, 0.0, 0.0, 0.2])
}

#[test]
fn numbers_parse_back_to_the_same_value() {
    let third = 1.0 / 3.0;
    let controller = Controller::new()
        .limits(&[-2.0, f64::NEG_INFINITY], &[2.0, f64::INFINITY])
        .linear_law(&[third, 2.0, -1e-7, 4.0], &[third, 0.0], &[0.0, 1e300])
        .ilqr(
            plan()
                .start_from(&[1.0, 2.0, third, 4.0])
                .goal(&[0.0, third], &[1.0, 0.0]),
        );
    let source = controller.print(&program(ARM)).expect("a controller").source;
    let lines = [
        "static const double Pendulum_low[ARM_INPUTS] = {-2.0, -HUGE_VAL};",
        "static const double gain[2][ARM_INPUTS] = {",
        "{0.3333333333333333, 2.0},",
        "{-1e-7, 4.0},",
        "static const double Pendulum_q[N * N] = {",
        "0.0, 0.3,",
        "static const double Pendulum_goal[N] = {0.0, 0.3333333333333333};",
        "{0.3333333333333333, 4.0},",
        "#include <math.h>",
    ];
    for line in lines {
        assert!(source.lines().any(|own| own.trim_start() == line), "{line}");
    }
    let single = controller.clone().single().print(&program(ARM));
    assert_eq!(
        single,
        Err(NoController::NotFinite {
            what: "the inputs of the law"
        })
    );
    let single = controller.linear_law(&[third; 4], &[0.0; 2], &[0.0; 2]).single();
    let source = single.print(&program(ARM)).expect("a controller").source;
    assert!(source.contains("{0.33333334f, 0.33333334f},"));
    let own = source
        .split("ARM_ILQR_H")
        .next()
        .expect("text")
        .split("const float")
        .nth(1)
        .expect("text");
    assert!(!own.contains("double"), "{own}");
}

#[test]
fn what_makes_no_controller_is_refused() {
    let of = |scene: &str, controller: Controller| controller.print(&program(scene)).expect_err("refused");
    let refused = [
        (
            of(
                "pub A { body b on ground { mass: 1, joint: prismatic(x), coordinate: s } }",
                Controller::new(),
            ),
            "a controller needs inputs, and the scene declares none",
        ),
        (
            of(
                "pub A {
                    input f: N,
                    body b on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: f, dry_friction: 1 }
                }",
                Controller::new(),
            ),
            "steps of fixed length do not switch modes, as at `s`",
        ),
        (
            of(
                "pub A {
                    input f: N,
                    generate: [energy],
                    body b on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: f }
                }",
                Controller::new(),
            ),
            "a controller needs equations of motion",
        ),
        (
            of(ARM, Controller::new().limits(&[-1.0], &[1.0])),
            "a list of limits has 1 numbers, and the scene requires 2",
        ),
        (
            of(ARM, Controller::new().limits(&[-1.0, 2.0], &[1.0, 1.0])),
            "the limits of `brake` are 2 and 1",
        ),
        (
            of(ARM, Controller::new().limits(&[f64::NAN, 0.0], &[1.0, 1.0])),
            "the limits of `motor` are NaN and 1",
        ),
        (
            of(ARM, Controller::new().linear_law(&[1.0; 2], &[0.0; 2], &[0.0; 2])),
            "the gain has 2 numbers, and the scene requires 4",
        ),
        (
            of(ARM, Controller::new().linear_law(&[f64::NAN; 4], &[0.0; 2], &[0.0; 2])),
            "the gain has a number that is infinite or NaN, or too large for the precision",
        ),
        (
            of(
                ARM,
                Controller::new().ilqr(Ilqr::new(0.1, 2, &[1.0, 0.5, 0.4, 1.0], &[1.0, 0.0, 0.0, 1.0])),
            ),
            "Q is not symmetric: entry (1, 0) is 0.5, and entry (0, 1) is 0.4",
        ),
        (
            of(ARM, Controller::new().ilqr(plan().end(&[1.0, 2.0, 2.0, 1.0]))),
            "Qf is not positive semidefinite",
        ),
        (
            of(ARM, Controller::new().ilqr(Ilqr::new(0.1, 2, &[0.0; 4], &[1.0; 4]))),
            "R is not positive definite",
        ),
        (
            of(
                ARM,
                Controller::new()
                    .ilqr(Ilqr::new(0.1, 2, &[0.0; 4], &[1.0, 0.0, 0.0, 1e-60]))
                    .single(),
            ),
            "R is not positive definite",
        ),
        (
            of(ARM, Controller::new().ilqr(plan().end(&[1.0]))),
            "Qf has 1 numbers, and the scene requires 4",
        ),
        (
            of(
                ARM,
                Controller::new()
                    .limits(&[0.0; 2], &[1.0; 2])
                    .ilqr(plan().start_from(&[0.0, 1.0, 0.5, 1.5])),
            ),
            "the plan starts with 1.5 for `brake` at step 1, beyond its limits 0 and 1",
        ),
        (
            of(
                ARM,
                Controller::new().ilqr(Ilqr::new(0.0, 2, &[1.0; 4], &[1.0, 0.0, 0.0, 1.0])),
            ),
            "the length of a step is 0 s",
        ),
        (
            of(
                ARM,
                Controller::new()
                    .ilqr(Ilqr::new(1e-50, 2, &[1.0; 4], &[1.0, 0.0, 0.0, 1.0]))
                    .single(),
            ),
            "the length of a step is 0.00000000000000000000000000000000000000000000000001 s",
        ),
        (
            of(
                ARM,
                Controller::new().ilqr(Ilqr::new(0.1, 0, &[1.0; 4], &[1.0, 0.0, 0.0, 1.0])),
            ),
            "a plan has no steps",
        ),
    ];
    for (error, fact) in refused {
        let text = error.to_string();
        assert_eq!(text.split("\nhelp: ").next(), Some(fact));
        assert!(text.contains("\nhelp: "), "{text}");
    }
}

#[test]
fn open_loops_have_steps_but_no_plans() {
    let program = program(
        "pub Coupled {
            input f: N m,
            gravity: [0, 1, -9.81],
            body crank on ground { mass: 2, com: [0.01, 0, 0], inertia: 0.1, joint: revolute(z),
                coordinate: theta near 0.8, torque: f }
            body yoke on crank { mass: 0.1, inertia: 0.001, joint: revolute(z) at [0.06, 0, 0.02],
                coordinate: alpha depends near 0.1 }
            body rod on yoke { mass: 0.4, com: [0.4, 0, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(y),
                coordinate: beta depends near -0.7 }
            body rocker on ground { mass: 0.9, com: [0, 0.3, 0.1], inertia: 0.02,
                joint: revolute([1, 0, 0.02]) at [0.4, 0, 0.1], coordinate: gamma depends near 0.6 }
            close rod at [0.815, 0, 0] to rocker at [0, 0.7, 0.1]: ball,
        }",
    );
    let n = program.layout.len();
    let source = Controller::new().print(&program).expect("a controller").source;
    assert!(source.contains("    coupled_project(model, t1, out);\n"));
    let plan = Ilqr::new(0.01, 5, &vec![0.0; n * n], &[1.0]);
    let bodies = ["rod", "rocker"].map(String::from);
    assert_eq!(
        Controller::new().ilqr(plan).print(&program),
        Err(NoController::ClosedLoop(bodies))
    );
}

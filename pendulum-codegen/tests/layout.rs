//! Layout of the state: angles, periodic and cyclic coordinates, and dependence on time.

use pendulum_codegen::program::SlotKind::{self, Angle, Length};

/// Expected properties of a coordinate: kind, periodic, cyclic.
#[derive(Clone, Copy)]
struct Coordinate(SlotKind, bool, bool);

fn check(scene: &str, autonomous: bool, expected: &[Coordinate]) {
    let source = format!("pub Scene {{ units: none, {scene} }}");
    let program = pendulum_codegen::program(source.parse().expect("tokens")).expect("a scene");
    let dof = expected.len();
    assert_eq!(program.layout.autonomous, autonomous, "{scene}");
    assert_eq!(program.layout.slots.len(), dof, "{scene}");
    for (k, (slot, &Coordinate(kind, periodic, cyclic))) in program.layout.slots.iter().zip(expected).enumerate() {
        assert_eq!(
            (slot.positions.clone(), slot.rates.clone()),
            (k..k + 1, dof + k..dof + k + 1)
        );
        assert_eq!(
            (slot.kind, slot.periodic, slot.cyclic),
            (kind, periodic, cyclic),
            "{}: {scene}",
            slot.name
        );
    }
}

const SWINGS: Coordinate = Coordinate(Angle, true, false);
const COUNTS_TURNS: Coordinate = Coordinate(Angle, false, false);
const SPINS: Coordinate = Coordinate(Angle, true, true);

/// Returns a pendulum with this joint, and with further fields in its body.
fn pendulum(joint: &str, more: &str) -> String {
    format!(
        "params {{ k: N m, pitch: m }} gravity: [0, -9.81, 0],
         body bob on ground {{
            mass: 1, com: [0, -1, 0], inertia: [1, 1, 1],
            joint: {joint}, coordinate: theta, friction: k * pitch, {more}
         }}"
    )
}

#[test]
fn a_turn_that_leads_half_a_turn_is_no_period() {
    for (factor, expected) in [("2", SWINGS), ("1/2", COUNTS_TURNS), ("-1.5", COUNTS_TURNS)] {
        let weight =
            format!("body weight on ground {{ mass: 1, com: [0, -1, 0], joint: revolute(z), motion: {factor}*theta }}");
        check(&format!("{} {weight}", pendulum("revolute(z)", "")), true, &[expected]);
        // the angle of a wheel that turns about its centre of mass affects outputs only
        let wheel =
            format!("body wheel on ground {{ inertia: 1, mass: 1, joint: revolute(z), motion: {factor}*theta }}");
        check(&format!("{} {wheel}", pendulum("revolute(z)", "")), true, &[expected]);
    }
}

#[test]
fn a_torque_by_sines_of_whole_multiples_is_periodic() {
    for torque in [
        "k * sin(q)",
        "k * sin(2 * q + pitch) * cos(q)^2",
        "k * tanh(cos(3 * q)) / (2 + sin(-q))",
        "k * atan2(sin(q), cos(q))",
        "k * sin(q + sin(q))",
        "k * sin(2 * (q / 2))",
    ] {
        check(&pendulum("revolute(z)", &format!("torque: {torque},")), true, &[SWINGS]);
    }
    for torque in [
        "k * q",
        "k * sin(q / 2)",
        "k * sin(k * q)",
        "k * sin(pi * q)",
        "q * sin(q)",
        "k * q^2",
        "abs(q)",
    ] {
        check(
            &pendulum("revolute(z)", &format!("torque: {torque},")),
            true,
            &[COUNTS_TURNS],
        );
    }
    check(&pendulum("revolute(z)", "spring: (k, 0)"), true, &[COUNTS_TURNS]);
}

#[test]
fn a_joint_that_slides_does_not_return() {
    for joint in ["revolute([1, 2, 3])", "screw([0, 0, 1, 0.5, 1, 0])", "helical(z, 0)"] {
        check(&pendulum(joint, ""), true, &[SWINGS]);
    }
    for joint in ["helical(z, pitch)", "screw([0, 0, 1, 0, 0, 0.1])"] {
        check(&pendulum(joint, ""), true, &[COUNTS_TURNS]);
    }
}

#[test]
fn time_and_inputs_are_seen() {
    check(&pendulum("revolute(z)", "torque: k * sin(q - t)"), false, &[SWINGS]);
    let controlled = "input u: N m, gravity: [0, -9.81, 0],
        body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta, torque: u }";
    check(controlled, false, &[COUNTS_TURNS]);
}

#[test]
fn what_the_motion_does_not_depend_on_is_cyclic() {
    let cart = "gravity: [0, -9.81, 0],
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s }
        body bob on cart { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }";
    check(cart, true, &[Coordinate(Length, false, true), SWINGS]);
    let table = "gravity: [0, 0, -9.81],
        body table on ground { mass: 2, inertia: [1, 1, 1], joint: revolute(z), coordinate: turn }
        body bob on table { mass: 1, com: [0, 0, -1], inertia: [1, 1, 1], joint: revolute(y) at [1, 0, 0], \
            coordinate: theta }";
    check(table, true, &[SPINS, SWINGS]);
    let without_rhs = format!("generate: [energy], {cart}");
    check(&without_rhs, true, &[Coordinate(Length, false, true), SWINGS]);
}

/// A spring between two links depends on the difference of their absolute angles, so neither angle is periodic.
#[test]
fn a_spring_of_absolute_angles_counts_turns_of_both() {
    let chain = |spring: &str| {
        format!(
            "gravity: [0, -9.81, 0],
             body upper on ground {{ mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: a }}
             body lower on upper {{ mass: 1, com: [0, -1, 0], joint: revolute(z) at [0, -1, 0], \
                coordinate: b absolute {spring} }}"
        )
    };
    check(&chain(""), true, &[SWINGS, SWINGS]);
    check(&chain(", spring: (1, 0)"), true, &[COUNTS_TURNS, COUNTS_TURNS]);
}

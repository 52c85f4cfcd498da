//! Robots from files against the same bodies written by hand.

use std::path::Path;

use crate::{expand, expand_in, program_in};

/// Path of `tests/robots`.
fn folder() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/robots")
}

/// Code of a scene.
fn code(items: &str) -> String {
    let text = format!("pub Arm {{ gravity: [0, 0, -9.81], {items} }}");
    let code = expand_in(&folder(), text.parse().expect("tokens")).to_string();
    assert!(!code.contains("compile_error"), "{items}\n{code}");
    code
}

/// Code of a scene with a robot, without the documentation of the file and without its limits.
fn from_file(items: &str) -> String {
    let code = code(items);
    let (before, note) = code
        .split_once("# [doc = \"\"] # [doc = \" Links and joints from")
        .expect("documentation");
    let (_, after) = note.split_once("\"]").expect("its end");
    let code = format!("{before}{}", after.trim_start());
    let Some((before, limits)) = code.split_once("# [doc = r\" The largest force along") else {
        return code;
    };
    let (_, after) = limits.split_once("VELOCITY_LIMITS : ").expect("both");
    let (_, after) = after.split_once("] = [").expect("its type");
    let (_, after) = after.split_once("] ;").expect("its end");
    format!("{before}{}", after.trim_start())
}

/// Asserts that a scene with the robot `arm.urdf` and other bodies gives the same code as bodies written by hand.
fn assert_same(robot: &str, by_hand: &str) {
    assert!(from_file(robot) == code(by_hand), "{robot}\n{by_hand}");
}

const BASE: &str = "body base on ground { }";

const UPPER: &str = "body upper_arm on base {
    mass: 1, com: [0, 0, 0], inertia: [1, 1, 1], joint: revolute([0, 1, 0]) at [0, 0, 1], coordinate: shoulder,
}";

const FOREARM: &str = "body forearm on upper_arm {
    mass: 1, com: [0, 0, 0], inertia: [1, 1, 1], joint: revolute(y) at [0, 0, -1], coordinate: elbow, friction: 0.1,
}";

#[test]
fn a_robot_is_its_links() {
    assert_same("robot: urdf(\"arm.urdf\"),", &format!("{BASE} {UPPER} {FOREARM}"));
    // the order of items does not matter, but bodies of the scene follow those of the robot
    let hand = "body hand on forearm { mass: 0.5, com: [0.1, 0.2, 0], joint: revolute(x), coordinate: wrist }";
    let tip = "point tip on hand at [0, 0, 1], output tip: tip, force on tip: [1, 0, 0] in forearm, force elbow: 2,";
    assert_same(
        &format!("{hand} {tip} robot: urdf(\"arm.urdf\"),"),
        &format!("{BASE} {UPPER} {FOREARM} {hand} {tip}"),
    );
}

#[test]
fn elements_in_the_name_space_of_the_file_are_its_own() {
    assert_same(
        "robot: urdf(\"name_space.urdf\"),",
        &format!("{BASE} {UPPER} {FOREARM}"),
    );
}

#[test]
fn a_scene_may_turn_by_more_than_a_turn() {
    let robot = "robot: urdf(\"degrees.urdf\", limits),";
    let turned =
        "inertia: [1, 1, 1.5] rpy [0, -45 rad, 0], joint: revolute(x) rpy [90 rad, 0, 0], stop: [-90 rad, 1 turn]";
    let by_hand = "body base on ground { } body a on base { mass: 1, com: [0, 0, 0], coordinate: j,";
    assert_same(
        &format!("{robot} body a on base {{ {turned} }}"),
        &format!("{by_hand} {turned} }}"),
    );
}

#[test]
fn limits_are_stops_where_that_is_said() {
    let stop = FOREARM.replace("friction", "stop: [-2, 2.5], friction");
    assert_same("robot: urdf(\"arm.urdf\", limits),", &format!("{BASE} {UPPER} {stop}"));
}

#[test]
fn dry_friction_is_that_of_the_file() {
    let rusty = |name: &str| {
        format!("body {name} on base {{ mass: 1, com: [0, 1, 0], joint: revolute(x), coordinate: {name}_joint")
    };
    let by_hand = |friction: &str| format!("body base on ground {{ }} {}, {friction} }}", rusty("lever"));
    assert_same(
        "robot: urdf(\"rusty.urdf\"),",
        &by_hand("friction: 0.2, dry_friction: 0.3"),
    );
    assert_same(
        "robot: urdf(\"rusty.urdf\", without dry_friction),",
        &by_hand("friction: 0.2"),
    );
}

#[test]
fn a_body_of_the_name_of_a_link_changes_it() {
    let same = |change: &str, upper: &str, forearm: &str| {
        assert_same(
            &format!("robot: urdf(\"arm.urdf\"), {change}"),
            &format!("{BASE} {upper} {forearm}"),
        );
    };
    let replaced = |from: &str, to: &str| {
        assert!(FOREARM.contains(from));
        FOREARM.replace(from, to)
    };
    same(
        "body forearm on upper_arm { mass: 3, friction: 0, spring: (2, 0) }",
        UPPER,
        &replaced("mass: 1", "spring: (2, 0), mass: 3").replace("friction: 0.1,", "friction: 0,"),
    );
    same(
        "body forearm on upper_arm { com: [0, 0, 0.5], inertia: [2, 2, 3] }",
        UPPER,
        &replaced("[0, 0, 0]", "[0, 0, 0.5]").replace("[1, 1, 1]", "[2, 2, 3]"),
    );
    same(
        "body forearm on upper_arm { solids: [rod(1, [0, 0, 0], [0, 0, -1])] }",
        UPPER,
        &replaced(
            "mass: 1, com: [0, 0, 0], inertia: [1, 1, 1]",
            "solids: [rod(1, [0, 0, 0], [0, 0, -1])]",
        ),
    );
    same(
        "shape stick { mass: 2 } body upper_arm on base: stick { coordinate: s }",
        "shape stick { mass: 2 } body upper_arm on base: stick { joint: revolute(y) at [0, 0, 1], coordinate: s }",
        FOREARM,
    );
    // a joint without a placement of its own keeps the one of the file
    same(
        "body forearm on upper_arm { joint: prismatic(z), friction: 5 }",
        UPPER,
        &replaced("revolute(y)", "prismatic(z)").replace("0.1", "5"),
    );
    same(
        "body forearm on upper_arm { joint: revolute(y) at [0, 0, -2] }",
        UPPER,
        &replaced("[0, 0, -1]", "[0, 0, -2]"),
    );
    let held = "body forearm on upper_arm { mass: 1, inertia: [1, 1, 1], joint: fixed at [0, 0, -1] }";
    same("body forearm on upper_arm { joint: fixed }", UPPER, held);
    let driven = replaced("coordinate: elbow, friction: 0.1", "motion: 2 rad/s*t");
    same("body forearm on upper_arm { motion: 2 rad/s*t }", UPPER, &driven);
}

#[test]
fn a_joint_that_mimics_follows() {
    let finger = |name: &str, moves: &str| {
        format!(
            "body {name} on base {{ mass: 1, com: [1, 0, 0], joint: prismatic(y) at [0, 0, 1], {moves}, \
                friction: 0.1 }}"
        )
    };
    let left = finger("left", "coordinate: l");
    let by_hand = |moves: &str| format!("{BASE} {left} {}", finger("right", moves));
    assert_same("robot: urdf(\"gripper.urdf\"),", &by_hand("motion: 0.02 - 2*l"));
    let renamed = "robot: urdf(\"gripper.urdf\"), body left on base { coordinate: grip }";
    assert_same(
        renamed,
        &by_hand("motion: 0.02 - 2*grip").replace("coordinate: l", "coordinate: grip"),
    );
    let free = "robot: urdf(\"gripper.urdf\"), body right on base { coordinate: r }";
    assert_same(free, &by_hand("coordinate: r"));
}

#[test]
fn joints_whose_names_are_words_of_the_language_are_renamed() {
    let has = "mass: 1, com: [0, 0, 0], inertia: [1, 1, 1]";
    let bodies = |moves: [&str; 3]| {
        let [slider, arm, finger] = moves;
        format!(
            "{BASE} body slider on base {{ {has}, joint: prismatic(y), {slider} }}
            body arm on slider {{ {has}, joint: revolute(y), {arm} }}
            body finger on arm {{ {has}, joint: prismatic(y), {finger} }} body thumb on arm {{ {has} }}"
        )
    };
    let robot = "robot: urdf(\"words.urdf\"),";
    assert_same(
        &format!("{robot} body slider on base {{ coordinate: pos }} body arm on slider {{ coordinate: angle }}"),
        &bodies(["coordinate: pos", "coordinate: angle", "motion: pos"]),
    );
    let held = "body slider on base { coordinate: pos } body arm on slider { motion: 2 rad/s*t }";
    assert_same(
        &format!("{robot} {held}"),
        &bodies(["coordinate: pos", "motion: 2 rad/s*t", "motion: pos"]),
    );
}

/// A floating and a planar joint, with limits and dynamics that have no effect.
#[test]
fn joints_of_more_coordinates_are_written_in_the_language() {
    let world = "body world on ground { }";
    let hull = "mass: 3, com: [0, 0, 0.1], inertia: [0.1, 0.2, 0.25],";
    let flies = "joint: free at [0, 0, 1] rpy [0, 0, pi/2], orientation: base_orientation, position: base_position";
    let hull_on_world = format!("body hull on world {{ {hull} {flies} }}");
    let slides = "
        body table_x on hull { joint: prismatic(x) at [0, 0, 0.2] rpy [0.5, 0, 0], coordinate: table_x }
        body table_y on table_x { joint: prismatic(y), coordinate: table_y }";
    let puck = "body puck on table_y { mass: 0.5, com: [0.1, 0, 0], inertia: [1e-3, 1e-3, 2e-3],";
    let turns = "joint: revolute([0, 0, -1]), coordinate: table_turn }";
    let lid = "
        body r#type_y on puck { joint: prismatic(y), coordinate: r#type_y }
        body type_z on type_y { joint: prismatic(z), coordinate: type_z }
        body lid on type_z { mass: 0.2, com: [0, 0, 0], inertia: [1e-3, 1e-3, 1e-3], joint: revolute(x), \
            coordinate: type_turn }";
    let lid = lid.replace("r#", "");
    let all = |hull: &str, slides: &str, puck: &str| format!("{world} {hull} {slides} {puck} {lid}");
    let same = |changes: &str, by_hand: &str| {
        let brief = "generate: [rhs],";
        assert_same(
            &format!("robot: urdf(\"floating.urdf\"), {brief} {changes}"),
            &format!("{brief} {by_hand}"),
        );
    };
    let moves = format!("{puck} {turns}");
    same("", &all(&hull_on_world, slides, &moves));
    // names
    let renamed = "body hull on world { orientation: o, position: p } body table_y on table_x { coordinate: along }";
    let hull_named = hull_on_world
        .replace("base_orientation", "o")
        .replace("base_position", "p");
    let slides_named = slides.replace("coordinate: table_y", "coordinate: along");
    same(renamed, &all(&hull_named, &slides_named, &moves));
    // other joints
    let stays = "at [0, 0, 1] rpy [0, 0, pi/2]";
    for (joint, names) in [
        ("fixed", ""),
        ("revolute(x)", "coordinate: lean, friction: 0.1"),
        ("ball", "friction: 0.1"),
        ("prismatic(x)", "motion: 0.1 m/s*t"),
    ] {
        let orientation = if joint == "ball" {
            ", orientation: base_orientation"
        } else {
            ""
        };
        let hull = format!("body hull on world {{ {hull} joint: {joint} {stays}, {names} {orientation} }}");
        let change = format!("body hull on world {{ joint: {joint}, {names} }}");
        same(&change, &all(&hull, slides, &moves));
    }
    // parts with forces, drives or fixed joints
    let changes = "
        body table_x on hull { spring: (3, 0), stop: [-1, 1] }
        body table_y on table_x { motion: 0.2 m*sin(1 rad/s*t) }
        body puck on table_y { joint: fixed }";
    let without = "body hull on world { joint: fixed }";
    let hull = format!("body hull on world {{ {hull} joint: fixed {stays} }}");
    let slides = slides
        .replace(
            "coordinate: table_x",
            "coordinate: table_x, spring: (3, 0), stop: [-1, 1]",
        )
        .replace("coordinate: table_y", "motion: 0.2 m*sin(1 rad/s*t)");
    same(
        &format!("{without} {changes}"),
        &all(&hull, &slides, &format!("{puck} joint: fixed }}")),
    );
}

/// A joint of the file with one axis may get an orientation, and the root may become a free body.
#[test]
fn a_joint_may_be_set_free() {
    let flies = "joint: free, orientation: o, position: p";
    let on_ground = format!("body base on ground {{ mass: 1, inertia: [1, 1, 1], {flies} }}");
    let change = on_ground.clone();
    assert_same(
        &format!("robot: urdf(\"arm.urdf\"), {change}"),
        &format!("{on_ground} {UPPER} {FOREARM}"),
    );
    let freed = FOREARM
        .replace("revolute(y)", "free")
        .replace("coordinate: elbow, friction: 0.1", "orientation: o, position: p");
    assert_same(
        &format!("robot: urdf(\"arm.urdf\", limits), body forearm on upper_arm {{ {flies} }}"),
        &format!("{BASE} {UPPER} {freed}"),
    );
}

/// Planar parts in a closed loop: a slider-crank whose slider is the planar joint of the file.
#[test]
fn parts_of_a_planar_joint_close_loops() {
    let crank = "body crank on ground { mass: 1, com: [0.1, 0, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(z), \
        coordinate: theta near 0.5 }";
    let close = "close crank at [0.2, 0, 0] to puck at [0, 0, 0]: revolute(z),";
    let hull = "body hull on world { joint: fixed at [0, 0, 0] } ";
    let held = "body type_y on puck { joint: fixed } body type_z on type_y { joint: fixed } body lid on type_z { \
        joint: fixed }";
    let changes = "body table_x on hull { joint: prismatic(x) at [0, 0, 0], coordinate: table_x depends near 0.2 }
        body table_y on table_x { coordinate: table_y depends near 0.1 }";
    let text = from_file(&format!(
        "robot: urdf(\"floating.urdf\"), {hull} {changes} {held} {crank} {close}"
    ));
    assert!(text.contains("\"theta\"") && text.contains("\"table_turn\""));
}

/// The orientation of the inertia, and names that are not valid in Rust.
#[test]
fn what_a_file_may_have_is_read() {
    assert_same(
        "robot: urdf(\"turned.urdf\"),",
        "body ground_ on ground { mass: 1, com: [0, 0, 0] }
         body _2nd on ground_ {
            mass: 0.25, com: [0, 0.5, 0], inertia: [1, 2, 2.5, 0.1, 0.2, 0.3] rpy [pi/2, 0.3, -3*pi/4],
            joint: revolute([1, 0, 0]) rpy [0, 0, pi], coordinate: r#type,
         }",
    );
}

/// Angles and lengths follow each other by any factor.
#[test]
fn joints_follow_by_fractions() {
    let part = |name: &str, moves: &str| {
        format!("body {name} on palm {{ mass: 1, com: [0, 0, 0], inertia: [1, 1, 1], joint: {moves} }}")
    };
    let bodies = [
        part("wheel", "revolute(x), coordinate: w"),
        part("rack", "prismatic(x), motion: 0.02 - w/8 * 1 m/rad"),
        part("thumb", "revolute(x), motion: 3*w/2"),
    ];
    let by_hand = format!("body palm on ground {{ }} {}", bodies.concat());
    assert_same("robot: urdf(\"mimic_fractions.urdf\"),", &by_hand);
    let moves = "body wheel on palm { joint: prismatic(x) } body rack on palm { joint: fixed }";
    let slides = [
        part("wheel", "prismatic(x), coordinate: w"),
        part("rack", "fixed"),
        part("thumb", "revolute(x), motion: 3*w/2 * 1 rad/m"),
    ];
    let by_hand = format!("body palm on ground {{ }} {}", slides.concat());
    let thumb = "body thumb on palm { motion: 1.5*w * 1 rad/m }";
    assert_same(
        &format!("robot: urdf(\"mimic_fractions.urdf\"), {moves} {thumb}"),
        &by_hand,
    );
}

/// Dry friction of a follower is an error, unless the scene declares the motion of the joint.
#[test]
fn what_cannot_follow_may_be_replaced() {
    let moves = "body right on forearm { coordinate: r } body third on forearm { joint: fixed }";
    assert!(from_file(&format!("robot: urdf(\"mimic.urdf\"), {moves}")).contains("\"r\""));
}

#[test]
fn the_documentation_names_what_is_left_out() {
    let docs = |items: &str| {
        let code = code(items);
        let (_, note) = code
            .split_once("[doc = \" Links and joints from ")
            .expect("documentation");
        note.split_once("\"]").expect("its end").0.to_owned()
    };
    assert_eq!(docs("robot: urdf(\"arm.urdf\"),"), "`arm.urdf`. Left out: `limit`.");
    assert_eq!(docs("robot: urdf(\"arm.urdf\", limits),"), "`arm.urdf`.");
    // limits of joints with more than one coordinate are always left out
    let floating = "`floating.urdf`. Left out: `limit`.";
    assert_eq!(docs("robot: urdf(\"floating.urdf\", limits),"), floating);
    let rusty = docs("robot: urdf(\"rusty.urdf\", without dry_friction),");
    assert_eq!(
        rusty,
        "`rusty.urdf`. Left out: `friction`, `gazebo`, `joint_properties`, `visual`."
    );
}

#[test]
fn cargo_builds_anew_when_the_file_changes() {
    let scene = |path: &str| {
        format!("pub Arm {{ robot: urdf(\"{path}\"), }}")
            .parse()
            .expect("tokens")
    };
    let path = "tests/robots/arm.urdf";
    let tracked = "include_bytes ! (:: core :: concat ! (:: core :: env ! (\"CARGO_MANIFEST_DIR\") , \"/\" , \
        \"tests/robots/arm.urdf\"))";
    assert!(expand(scene(path)).to_string().contains(tracked));
    // tracking the file lets the message disappear once a broken file is fixed
    assert!(
        expand(scene("tests/robots/loop.urdf"))
            .to_string()
            .contains("include_bytes")
    );
    assert!(
        !expand(scene("tests/robots/none.urdf"))
            .to_string()
            .contains("include_bytes")
    );
    let absolute = folder().join("arm.urdf").display().to_string();
    let code = expand(scene(&absolute)).to_string();
    assert!(code.contains(&format!("include_bytes ! ({absolute:?})")), "{code}");
    assert!(
        !expand_in(&folder(), scene("arm.urdf"))
            .to_string()
            .contains("include_bytes")
    );
    assert!(program_in(&folder(), scene("arm.urdf")).is_ok());
}

#[test]
fn what_is_fixed_together_is_judged_together() {
    let code = code("robot: urdf(\"sound_together.urdf\"),");
    assert!(code.contains("Left out: `tag`."), "{code}");
}

#[test]
fn an_inertia_that_no_body_has_becomes_the_nearest_that_one_has() {
    let robot = "robot: urdf(\"unphysical.urdf\", repair),";
    let code = code(&format!(
        "{robot} body cap on hand {{ mass: 1, com: [0, 1, 0], joint: revolute(x) }}"
    ));
    assert!(code.contains("REPAIRED : [& 'static str ; 2]"), "{code}");
    assert!(code.contains(" * inertia of `arm`, by "), "{code}");
    // the hand has moments of inertia 1, 2, 5, hence second moments of mass 3, 2, -1; the nearest valid ones are 3, 2,
    // 0
    let hand = "body hand on arm { inertia: [2, 3, 5] }";
    // all products of inertia matter here, and none is rounded
    let robot =
        &format!("{robot} body base on ground {{ inertia: [1, 1, 1], joint: free, orientation: o, position: p }}");
    let with = |items: &str| {
        let text = format!(
            "pub Arm {{ {robot} {items} generate: [inverse_dynamics], body cap on hand {{ mass: 1, com: [0, 1, 0], \
                joint: revolute(x) }} }}"
        );
        let program = program_in(&folder(), text.parse().expect("tokens")).expect("a scene");
        program.routines[0].block.clone()
    };
    assert_eq!(with(""), with(hand));
}

#[test]
fn the_largest_forces_and_rates_are_those_of_the_file() {
    let lone = "robot: urdf(\"unphysical.urdf\", repair), body cap on hand { mass: 1, com: [0, 1, 0], joint: fixed }";
    let renamed = format!(
        "{lone} body hand on arm {{ coordinate: bend }} body free on hand {{ mass: 1, com: [0, 1, 0], \
            joint: revolute(x), coordinate: f }}"
    );
    let code = code(&renamed);
    assert!(
        code.contains("EFFORT_LIMITS : [f64 ; 3] = [87f64 , 12f64 , f64 :: INFINITY]"),
        "{code}"
    );
    assert!(
        code.contains("VELOCITY_LIMITS : [f64 ; 3] = [2.5f64 , 4f64 , f64 :: INFINITY]"),
        "{code}"
    );
    // a replaced joint loses the limits of the file, and a joint of the scene that takes its name does not get them
    let held = format!(
        "{lone} body hand on arm {{ joint: fixed }} body free on hand {{ mass: 1, com: [0, 1, 0], joint: revolute(x), \
            coordinate: wrist }}"
    );
    let code = self::code(&held);
    assert!(
        code.contains("EFFORT_LIMITS : [f64 ; 2] = [87f64 , f64 :: INFINITY]"),
        "{code}"
    );
    assert!(
        !expand(
            "pub A { body a on ground { mass: 1, joint: prismatic(x), coordinate: x } }"
                .parse()
                .expect("tokens")
        )
        .to_string()
        .contains("EFFORT")
    );
}

#[test]
fn joints_that_move_no_mass_are_held_where_that_is_said() {
    let gripper = "robot: urdf(\"massless.urdf\", repair)";
    let program = |scene: &str| program_in(&folder(), format!("pub Arm {{ {scene} }}").parse().expect("tokens"));
    let names = |scene: &str| {
        let slots = program(scene).expect("a program").layout.slots;
        slots.iter().map(|slot| slot.name.clone()).collect::<Vec<_>>().join(" ")
    };
    let repaired = |scene: &str| program(scene).expect("a program").repaired.join(", ");
    assert_eq!(names(gripper), "shoulder");
    assert_eq!(
        repaired(gripper),
        "joint `claw`, which moves no mass, is held, joint `thumb_claw`, which moves no mass, is held, \
         joint `axle`, which moves no mass, is held"
    );
    // bodies of the scene on a link are moved by the joints below it, and by those that they mimic
    let tip = "body tip on thumb { mass: 1, com: [0.1, 0, 0], inertia: [1, 1, 1], joint: fixed }";
    assert_eq!(names(&format!("{gripper}, {tip}")), "shoulder claw");
    assert_eq!(
        repaired(&format!("{gripper}, {tip}")),
        "joint `axle`, which moves no mass, is held"
    );
    // the same holds for a link that gets mass, or a joint of the scene
    let heavy = "body finger on arm { mass: 1, com: [0.1, 0, 0], inertia: [1, 1, 1] }";
    assert_eq!(names(&format!("{gripper}, {heavy}")), "shoulder claw");
    let refused = program("robot: urdf(\"massless.urdf\")")
        .expect_err("no inertia")
        .to_string();
    assert!(
        refused.contains("coordinate `axle` has no inertia") && refused.contains("`repair`"),
        "{refused}"
    );
}

/// Inertias given by the scene are checked together with the others, or by themselves. Other changes by the scene do
/// not hide errors.
#[test]
fn what_a_scene_changes_is_judged() {
    let refused = |scene: &str| {
        let text = format!("pub Arm {{ robot: urdf(\"sensor.urdf\"), {scene} }}");
        program_in(&folder(), text.parse().expect("tokens")).map_or_else(|errors| errors.to_string(), |_| String::new())
    };
    // a sensor that is valid only together with its arm, which the scene redefines
    let arm = |izz: f64| format!("body arm on base {{ mass: 10, com: [0, 0, 0], inertia: [1, 1, {izz}] }}");
    assert_eq!(refused(""), "");
    assert_eq!(refused(&arm(1.0)), "");
    assert!(refused(&arm(2.5)).contains("triangle inequality"), "that of the scene");
    // the inertia of the file about a centre of mass given by the scene is checked by itself
    assert!(refused("body hand on arm { com: [0.1, 0, 0] }").contains("triangle inequality"));
    assert_eq!(refused("body hand on arm { com: [0.1, 0, 0], inertia: [1, 1, 1] }"), "");
}

#[test]
fn joints_follow_those_that_follow() {
    let inertia = "mass: 1, com: [0, 0, 0], inertia: [1, 1, 1]";
    let by_hand = format!(
        "body palm on ground {{ }} body first on palm {{ {inertia}, joint: revolute(x), coordinate: a }}
         body second on palm {{ {inertia}, joint: revolute(x), motion: 0.25 - a/2 }}
         body rack on palm {{ joint: prismatic(x), motion: 0.125 + a/4 * 1 m/rad }}"
    );
    assert_same("robot: urdf(\"mimic_chain.urdf\"),", &by_hand);
    // a joint that others mimic is kept, although it moves no mass
    assert_same("robot: urdf(\"mimic_chain.urdf\", repair),", &by_hand);
    let free = "body first on palm { joint: fixed } body rack on palm { coordinate: b }";
    let text = format!("pub A {{ robot: urdf(\"mimic_chain.urdf\"), {free} }}");
    let slots = program_in(&folder(), text.parse().expect("tokens"))
        .expect("a program")
        .layout
        .slots;
    assert_eq!(slots.len(), 1);
    let text = std::fs::read_to_string(folder().join("mimic_chain.urdf")).expect("a file");
    let around = text.replace("<child link=\"first\"/>", "<child link=\"first\"/><mimic joint=\"c\"/>");
    let read = |_: &str| Ok(around.clone());
    let scene = "pub A { robot: urdf(\"around.urdf\") }".parse().expect("tokens");
    let refused = crate::pipeline::program(scene, crate::Wanted::Also(&[]), &read)
        .expect_err("a circle")
        .to_string();
    assert!(
        refused.contains("mimics `c`, which mimics itself through other joints"),
        "{refused}"
    );
}

//! The page's requests, answered natively: the answers in a browser are the same.

use pendulum_web::Page;
use serde_json::{Value, json};

const DOUBLE: &str = "pub Double {
    params { l: m = 1.0, g: m/s^2 = 9.81 }
    gravity: [0, -g, 0],
    body upper on ground { solids: [point(1, [0, -l, 0])], joint: revolute(z), coordinate: a }
    body lower on upper { solids: [point(1, [0, -l, 0])], joint: revolute(z) at [0, -l, 0], coordinate: b }
}";

const VIEW: [[f64; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn ask(page: &mut Page, request: &Value) -> (Value, Vec<f64>) {
    let (text, numbers) = page.answer_json(request.to_string().as_bytes());
    (serde_json::from_str(&text).expect("valid JSON"), numbers)
}

fn declared(text: &str) -> (Page, Value) {
    let mut page = Page::default();
    let (answer, _) = ask(&mut page, &json!({ "do": "declare", "text": text, "method": "Vern9" }));
    (page, answer)
}

fn numbers(value: &Value) -> Vec<f64> {
    serde_json::from_value(value.clone()).expect("numbers")
}

/// Index of the shape of a kind on a body.
fn shape(about: &Value, kind: &str, body: &str) -> usize {
    let shapes = about["shapes"].as_array().expect("shapes");
    let found = shapes
        .iter()
        .position(|shape| shape["kind"] == kind && shape["body"] == body);
    found.unwrap_or_else(|| panic!("no {kind} on {body} among {shapes:?}"))
}

/// Place on the screen of a point of a shape, in a frame.
fn place(about: &Value, frame: &[f64], shape: usize, point: usize) -> [f64; 2] {
    let before = about["shapes"].as_array().into_iter().flatten().take(shape);
    let before: usize = before
        .map(|own| 3 * own["points"].as_u64().expect("a number") as usize + 1)
        .sum();
    let place = 3 + about["components"].as_array().map_or(0, Vec::len) + before + 3 * point;
    [frame[place], frame[place + 1]]
}

#[test]
fn a_declaration_is_described() {
    let (_, answer) = declared(DOUBLE);
    assert_eq!(answer["is"], "mechanism");
    assert_eq!(answer["name"], "Double");
    assert_eq!(
        answer["components"][2],
        json!({ "name": "dot(a)", "unit": "rad/s", "periodic": false })
    );
    assert_eq!(
        answer["parameters"][1],
        json!({ "name": "g", "unit": "m/s^2", "docs": "", "value": 9.81 })
    );
    // words that the page adds
    assert_eq!(answer["has_energy"], true);
    assert_eq!(answer["shapes"][0]["kind"], "Mass");
}

#[test]
fn errors_have_places_and_help() {
    let (_, answer) = declared(&DOUBLE.replace("gravity", "gravty"));
    let problem = &answer["problems"][0];
    assert_eq!(
        (answer["is"].as_str(), problem["line"].as_u64()),
        (Some("problems"), Some(3))
    );
    assert_eq!(
        (problem["column"].as_u64(), problem["width"].as_u64()),
        (Some(5), Some(6))
    );
    assert!(
        problem["help"]
            .as_str()
            .is_some_and(|help| help.contains("did you mean `gravity`?"))
    );
}

#[test]
fn robots_come_from_opened_files() {
    let text = "pub Arm { robot: urdf(\"ur5.urdf\"), gravity: [0, 0, -9.81] }";
    let (mut page, answer) = declared(text);
    assert!(
        answer["problems"][0]["help"]
            .as_str()
            .is_some_and(|help| help.contains("Robot file")),
        "{answer}"
    );
    let file = include_str!("../../testbed/data/urdf/declared/ur5.urdf");
    let request = json!({ "do": "declare", "text": text, "method": "Vern9", "files": { "ur5.urdf": file } });
    let (answer, _) = ask(&mut page, &request);
    assert_eq!(answer["components"].as_array().map(Vec::len), Some(12), "{answer}");
}

#[test]
fn the_last_mechanism_remains_while_a_text_is_wrong() {
    let (mut page, _) = declared(DOUBLE);
    ask(&mut page, &json!({ "do": "declare", "text": "pub", "method": "Vern9" }));
    let (answer, numbers) = ask(&mut page, &json!({ "do": "look", "t": 0.0, "x": [0.5, 0.0, 0.0, 0.0] }));
    assert_eq!((answer["is"].as_str(), numbers[1]), (Some("state"), 0.5));
}

#[test]
fn parameters_without_defaults_are_assumed() {
    let (_, answer) = declared(&DOUBLE.replace("l: m = 1.0", "l: m"));
    assert!(
        answer["notes"][0].as_str().is_some_and(|note| note.contains("`l`")),
        "{answer}"
    );
}

#[test]
fn frames_are_equally_spaced_and_keep_the_energy() {
    let (mut page, _) = declared(DOUBLE);
    let by = json!({ "method": "Vern9", "tolerance": 1e-12 });
    let request = json!({ "do": "move", "by": by, "span": [1.0, 2.0], "x": [2.0, 1.0, 0.0, 0.0], "frames": 10 });
    let (answer, numbers) = ask(&mut page, &request);
    let width = answer["width"].as_u64().expect("a width") as usize;
    assert_eq!(numbers.len(), 10 * width);
    assert_eq!((numbers[0], numbers[9 * width]), (1.1, 2.0));
    let energy = |n: usize| numbers[n * width + 5] + numbers[n * width + 6];
    assert!((energy(9) - energy(0)).abs() < 1e-10, "{} {}", energy(0), energy(9));
}

/// The browser must have these bits, too: `test/page.test.mjs` reads the same file. The first motion is 1e5 steps of a
/// double pendulum, the second goes through stops, walls and sticking friction.
#[test]
fn bits_of_motions() {
    let cases: Value = serde_json::from_str(include_str!("bits.json")).expect("valid JSON");
    for case in cases.as_array().expect("a list") {
        let (mut page, about) = declared(case["text"].as_str().expect("a text"));
        assert_eq!(about["is"], "mechanism", "{about}");
        let (answer, _) = ask(&mut page, &case["request"]);
        assert_eq!(answer["stopped"], Value::Null);
        let bits: Vec<String> = numbers(&answer["x"])
            .iter()
            .map(|x| format!("{:016x}", x.to_bits()))
            .collect();
        assert_eq!(json!(bits), case["x"], "{answer}");
    }
}

#[test]
fn a_description_follows_with_the_values_that_were_set() {
    let (mut page, about) = declared(&DOUBLE.replace("l: m = 1.0", "l: m"));
    assert_eq!(about["functions"], Value::Null);
    ask(&mut page, &json!({ "do": "set", "values": [2.0, 9.81], "inputs": [] }));
    let (answer, _) = ask(&mut page, &json!({ "do": "describe" }));
    assert!(
        answer["latex"].as_str().is_some_and(|latex| latex.contains("\\ddot")),
        "{answer}"
    );
    let names = answer["functions"].as_array().expect("functions").iter();
    let names: Vec<_> = names.filter_map(|function| function["name"].as_str()).collect();
    assert!(names.contains(&"jacobian"), "{names:?}");
}

#[test]
fn flat_walls_have_shapes() {
    let text = DOUBLE.replace(
        "gravity:",
        "point tip on lower at [0, -l, 0], wall floor { gap: tip.y + 3*l } gravity:",
    );
    let (mut page, about) = declared(&text);
    let wall = shape(&about, "Wall", "ground");
    let (_, frame) = ask(&mut page, &json!({ "do": "look", "t": 0.0, "x": [0.0, 1.0, 0.0, 0.0] }));
    let foot = place(&about, &frame, wall, 0);
    assert!(
        (foot[0] - 1_f64.sin()).abs() < 1e-15 && (foot[1] + 3.0).abs() < 1e-15,
        "{foot:?}"
    );
}

#[test]
fn a_hand_moves_a_body_to_where_it_points() {
    let (mut page, about) = declared(DOUBLE);
    let bob = shape(&about, "Mass", "lower");
    let request = json!({
        "do": "drag", "t": 0.0, "x": [0.3, 0.2, 5.0, 5.0], "shape": bob, "point": 0, "to": [1.2, -0.5], "view": VIEW,
    });
    let (answer, frame) = ask(&mut page, &request);
    let at = place(&about, &frame, bob, 0);
    assert!((at[0] - 1.2).abs() < 1e-6 && (at[1] + 0.5).abs() < 1e-6, "{at:?}");
    assert_eq!(numbers(&answer["x"])[2..], [0.0, 0.0]);
    // out of reach: stretched towards it
    let far = json!({
        "do": "drag", "t": 0.0, "x": [0.3, 0.2, 0.0, 0.0], "shape": bob, "point": 0, "to": [8.0, 0.0], "view": VIEW,
    });
    let at = place(&about, &ask(&mut page, &far).1, bob, 0);
    assert!((at[0] - 2.0).abs() < 1e-3 && at[1].abs() < 0.02, "{at:?}");
}

#[test]
fn a_hand_closes_loops_and_stays_within_stops() {
    let linkage = "pub FourBar {
        gravity: [0, -9.81, 0],
        body crank on ground { solids: [rod(1, [0, 0, 0], [0, 1, 0])], joint: revolute(z), coordinate: a }
        body coupler on crank {
            solids: [rod(1, [0, 0, 0], [3, 0, 0])], joint: revolute(z) at [0, 1, 0], coordinate: b depends near 0.3,
        }
        body rocker on ground {
            solids: [rod(1, [0, 0, 0], [0, 2, 0])], joint: revolute(z) at [3, 0, 0], coordinate: c depends near 0,
        }
        close coupler at [3, 0, 0] to rocker at [0, 2, 0]: revolute(z),
    }";
    let (mut page, about) = declared(linkage);
    assert_eq!(about["is"], "mechanism", "{about}");
    let rods = ["crank", "coupler", "rocker"].map(|body| shape(&about, "Rod", body));
    let drag = json!({
        "do": "drag", "t": 0.0, "x": about["start"], "shape": rods[0], "point": 1, "to": [-0.8, 0.6], "view": VIEW,
    });
    let (_, frame) = ask(&mut page, &drag);
    let [crank, coupler, rocker] = rods.map(|rod| place(&about, &frame, rod, 1));
    assert!(
        (crank[0] + 0.8).abs() < 1e-6 && (crank[1] - 0.6).abs() < 1e-6,
        "{crank:?}"
    );
    assert!(
        (coupler[0] - rocker[0]).abs() < 1e-9 && (coupler[1] - rocker[1]).abs() < 1e-9,
        "{coupler:?} {rocker:?}"
    );
    let stopped = "pub Stopped {
        gravity: [0, -9.81, 0],
        body bob on ground {
            solids: [point(1, [0, -1, 0])], joint: revolute(z), coordinate: a, stop: [-0.5, 0.5] restitution(0.5),
        }
    }";
    let (mut page, answer) = declared(stopped);
    assert_eq!(answer["is"], "mechanism", "{answer}");
    let drag =
        json!({ "do": "drag", "t": 0.0, "x": [0.1, 0.0], "shape": 0, "point": 0, "to": [1.0, 0.0], "view": VIEW });
    let (answer, _) = ask(&mut page, &drag);
    let angle = numbers(&answer["x"])[0];
    assert!(angle > 0.3 && angle <= 0.5, "{angle}");
}

#[test]
fn a_thousand_motions_begin_near_each_other() {
    let (mut page, _) = declared(DOUBLE);
    let gather = json!({ "do": "gather", "t": 0.0, "x": [2.0, 1.0, 0.0, 0.0], "count": 1000, "spread": 1e-3 });
    assert_eq!(ask(&mut page, &gather).0["is"], "done");
    let go = json!({ "do": "move_all", "span": [0.0, 0.1], "frames": 2 });
    let (answer, frames) = ask(&mut page, &go);
    // a time, and for each motion the ends of the lines to two masses, and of the rod between two joints
    assert_eq!(
        (answer["is"].as_str(), frames.len()),
        (Some("frames"), 2 * (1 + 1000 * 3 * 6))
    );
    assert_eq!(frames[0], 0.05);
}

#[test]
fn sections_are_passed_upward() {
    let (mut page, _) = declared(DOUBLE);
    let by = json!({ "method": "Vern9", "tolerance": 1e-9 });
    let mut passages = |x: [f64; 4]| -> Vec<(f64, Vec<f64>)> {
        let request = json!({
            "do": "move", "by": by, "span": [0.0, 20.0], "x": x, "frames": 1,
            "section": { "component": 0, "value": 0.0 },
        });
        serde_json::from_value(ask(&mut page, &request).0["passages"].clone()).expect("times and states")
    };
    let swings = passages([0.5, 0.0, 0.0, 0.0]);
    assert!(swings.len() > 5, "{}", swings.len());
    assert!(swings.iter().all(|(_, x)| x[0].abs() < 1e-9 && x[2] > 0.0));
    // turning over backwards, the sine of the angle rises half a turn from the section
    assert_eq!(passages([0.5, 0.0, -30.0, 0.0]), []);
}

#[test]
fn neighbours_differ_in_the_first_coordinate_or_orientation() {
    let (mut page, _) = declared(DOUBLE);
    let request = json!({ "do": "near", "t": 0.0, "x": [1.0, 0.0, 0.0, 0.0], "by": 1e-6 });
    assert_eq!(numbers(&ask(&mut page, &request).0["x"]), [1.0 + 1e-6, 0.0, 0.0, 0.0]);
    let ball = "pub Ball {
        gravity: [0, -9.81, 0],
        body bob on ground { solids: [sphere(1, 0.1, [0, -1, 0])], joint: ball, orientation: o }
    }";
    let (mut page, about) = declared(ball);
    assert_eq!(about["is"], "mechanism", "{about}");
    let request = json!({ "do": "near", "t": 0.0, "x": [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], "by": 1e-3 });
    let x = numbers(&ask(&mut page, &request).0["x"]);
    assert!(
        (x[1] - 5e-4).abs() < 1e-9 && (x[0] * x[0] + x[1] * x[1] - 1.0).abs() < 1e-15,
        "{x:?}"
    );
    // what is typed for an orientation is normalised
    let request = json!({ "do": "look", "t": 0.0, "x": [1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0] });
    let x = numbers(&ask(&mut page, &request).0["x"]);
    assert!((x[0] - 0.5_f64.sqrt()).abs() < 1e-15, "{x:?}");
}

#[test]
fn what_makes_no_sense_is_refused_with_a_reason() {
    let mut page = Page::default();
    let why = |(answer, _): (Value, Vec<f64>)| {
        assert_eq!(answer["is"], "refused", "{answer}");
        answer["why"].as_str().expect("a reason").to_owned()
    };
    assert!(why(ask(&mut page, &json!({ "do": "look", "t": 0.0, "x": [] }))).contains("declare one"));
    let (mut page, _) = declared(DOUBLE);
    assert!(why(ask(&mut page, &json!({ "do": "dance" }))).contains("dance"));
    assert!(why(ask(&mut page, &json!({ "do": "look", "t": 0.0, "x": [1.0] }))).contains("4 are needed"));
    assert!(why(ask(&mut page, &json!({ "do": "set", "values": [-1.0], "inputs": [] }))).contains("2"));
    let by = json!({ "method": "Vern", "tolerance": 1e-9 });
    let moved = json!({ "do": "move", "by": by, "span": [0.0, 1.0], "x": [0.0, 0.0, 0.0, 0.0], "frames": 1 });
    assert!(why(ask(&mut page, &moved)).contains("did you mean `Vern9`?"));
    let (text, numbers) = page.answer_json(b"\xff{");
    assert!(text.contains("refused") && numbers.is_empty());
}

#[test]
fn code_is_printed() {
    let (mut page, _) = declared(DOUBLE);
    let rust = ask(&mut page, &json!({ "do": "code", "language": "rust" })).0;
    assert!(
        rust["text"].as_str().is_some_and(|text| text.contains("fn rhs(")),
        "{rust}"
    );
    let c = ask(&mut page, &json!({ "do": "code", "language": "c" })).0;
    let text = c["text"].as_str().expect("a text");
    let (header, source) = text.split_once("/* double.c */").expect("two files");
    assert!(
        header.starts_with("/* double.h */") && source.contains("#include \"double.h\""),
        "{c}"
    );
}

#[test]
fn steps_of_a_thousand_are_as_short_as_their_motion_is_fast() {
    let (mut page, _) = declared(DOUBLE);
    let mut steps = |rate: f64| {
        let gather = json!({ "do": "gather", "t": 0.0, "x": [0.1, 0.1, rate, 0.0], "count": 10, "spread": 1e-3 });
        assert_eq!(ask(&mut page, &gather).0["is"], "done");
        let (answer, _) = ask(&mut page, &json!({ "do": "move_all", "span": [0.0, 0.1], "frames": 1 }));
        let accuracy = &answer["accuracy"];
        [&accuracy["h"], &accuracy["error"]].map(|own| own.as_f64().expect("a number"))
    };
    let [[slow, error], [fast, other]] = [0.1, 20.0].map(&mut steps);
    assert!(slow == 1.0 / 240.0 && fast < slow, "{slow} {fast}");
    assert!(error < 1e-5 && other < 1e-5, "{error} {other}");
    // the shortest ones do not reach the accuracy, and the answer says so
    let [shortest, error] = steps(2000.0);
    assert!(shortest == slow / 16.0 && error > 1e-5, "{shortest} {error}");
}

#[test]
fn walls_that_are_not_drawn_are_named() {
    let (_, answer) = declared(
        "pub Ball {
            gravity: [0, -9.81, 0],
            body slider on ground { mass: 1, joint: prismatic(x), coordinate: x, dry_friction: 0.1 }
            body ball on slider { solids: [point(1, [0, 0, 0])], joint: prismatic(y), coordinate: y }
            wall floor { gap: y + 1 },
            wall bowl { gap: y + 0.5 - x^2*0.1/1 m },
        }",
    );
    let constraints: Vec<String> = serde_json::from_value(answer["constraints"].clone()).expect("names");
    assert_eq!(constraints, ["x", "floor", "bowl"], "{answer}");
    assert_eq!(
        answer["notes"],
        json!(["`bowl` is not drawn: only flat walls at rest are"])
    );
}

#[test]
fn what_slides_above_walls_is_tilted_a_little() {
    let (_, answer) = declared(
        "pub Block {
            gravity: [0, -9.81, 0],
            point left on block at [-0.1, -0.25, 0],
            point right on block at [0.1, -0.25, 0],
            wall under_left { gap: left.y },
            wall under_right { gap: right.y },
            body up on ground { joint: prismatic(y), coordinate: y }
            body block on up { mass: 2, com: [0, 0, 0], inertia: [0.1, 0.1, 0.1], joint: revolute(z), coordinate: phi }
        }",
    );
    assert_eq!(numbers(&answer["start"]), [0.5, 0.1, 0.0, 0.0], "{answer}");
}

//! Pictures and animations are written, or rejected with a reason.

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use pendulum_core::prelude::*;
use pendulum_core::shapes::{ShapeKind, Shapes};
use pendulum_draw::Drawing;

mechanism! {
    /// One of each kind of shape.
    Zoo {
        params { r: m = 0.1 }
        gravity: [0, -9.81, 0],
        point nail on ground at [1, 0, 0],
        point tip on arm at [0, -1, 0],
        spring between nail and tip: (3, 0.5),
        damper between tip and nail: 0.1,
        body arm on ground {
            solids: [
                rod(0.1, [0, 0, 0], [0, -1, 0]), point(0.1, [0, -1, 0]),
                disk(0.2, r, [0.3, 0, 0]), sphere(0.1, r, [0, -0.5, 0]),
                plate(0.1, [[0, 0], [0.1, 0], [0, 0.1]]), cuboid(0.1, [0.2, 0.1, 0.3], [-0.3, 0, 0]),
                cylinder(0.1, r, [0, 0, 0], [0, 0.3, 0]),
            ],
            joint: revolute(z), coordinate: theta,
        }
        generate: [rhs, shapes],
    }
}

fn zoo() -> Result<(Zoo, Solution<f64, 2>), Box<dyn Error>> {
    let zoo = Zoo::new(ZooParams::default())?;
    let solution = Rk45::new().solve(&zoo, 0.0, 0.2, [0.5, 0.0])?;
    Ok((zoo, solution))
}

fn stem(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

#[test]
fn shapes_are_where_the_declaration_puts_them() -> Result<(), Box<dyn Error>> {
    let (zoo, _) = zoo()?;
    let shapes = zoo.shapes(0.0, &SVector::from([std::f64::consts::FRAC_PI_2, 0.0]));
    let of = |kind| {
        shapes
            .iter()
            .find(|shape| shape.kind == kind)
            .ok_or("a shape is missing")
    };
    // a quarter turn maps (x, y) to (-y, x)
    let near = |shape: &pendulum_core::shapes::Shape, n: usize, place: [f64; 3]| {
        let apart = shape.points[n].coords - SVector::from(place);
        assert!(apart.norm() < 1e-15, "{shape:?}");
    };
    near(of(ShapeKind::Rod)?, 1, [1.0, 0.0, 0.0]);
    near(of(ShapeKind::Mass)?, 0, [1.0, 0.0, 0.0]);
    near(of(ShapeKind::Disk)?, 0, [0.0, 0.3, 0.0]);
    near(of(ShapeKind::Plate)?, 1, [0.0, 0.1, 0.0]);
    near(of(ShapeKind::Cuboid)?, 0, [-0.05, -0.2, 0.15]);
    near(of(ShapeKind::Cylinder)?, 1, [-0.3, 0.0, 0.0]);
    near(of(ShapeKind::Spring)?, 0, [1.0, 0.0, 0.0]);
    near(of(ShapeKind::Damper)?, 1, [1.0, 0.0, 0.0]);
    near(of(ShapeKind::Anchor)?, 0, [1.0, 0.0, 0.0]);
    near(of(ShapeKind::Point)?, 0, [1.0, 0.0, 0.0]);
    near(of(ShapeKind::Support)?, 0, [0.0; 3]);
    for kind in [ShapeKind::Disk, ShapeKind::Sphere, ShapeKind::Cylinder] {
        assert!((of(kind)?.radius - 0.1).abs() < 1e-15);
    }
    let names: Vec<&str> = shapes.iter().map(|shape| shape.name).collect();
    assert_eq!(names[7..], ["arm", "ground", "arm", "nail", "tip"]);
    let bodies: Vec<&str> = shapes.iter().map(|shape| shape.body).collect();
    assert_eq!(bodies[7..], ["arm", "ground", "arm", "ground", "arm"]);
    Ok(())
}

#[test]
fn a_motion_becomes_a_picture_and_an_animation() -> Result<(), Box<dyn Error>> {
    let (zoo, solution) = zoo()?;
    let drawing = Drawing::new(&zoo, &solution).ghosts(1);
    let [svg, png] = drawing.picture(&stem("zoo"))?;
    assert!(fs::read_to_string(svg)?.contains("<polygon"));
    assert!(fs::read(png)?.starts_with(b"\x89PNG"));
    let gif = fs::read(drawing.speed(2.0).animation(&stem("zoo"))?)?;
    assert!(gif.starts_with(b"GIF89a") && gif.len() > 1000);
    Ok(())
}

/// With careless rounding, times would exceed the end: the last point of the trail in the first span, the shadows in
/// the second, and the animation in the third.
#[test]
fn rounding_does_not_pass_the_end() -> Result<(), Box<dyn Error>> {
    let zoo = Zoo::new(ZooParams::default())?;
    for (start, end) in [(0.1, 0.3), (0.3, 0.9)] {
        let solution = Rk45::new().solve(&zoo, start, end, [0.5, 0.0])?;
        let drawing = Drawing::new(&zoo, &solution).ghosts(3).speed(5.0);
        drawing.picture(&stem("end"))?;
        drawing.animation(&stem("end"))?;
    }
    Ok(())
}

mechanism! {
    /// A freely rotating wheel.
    Wheel {
        body wheel on ground { solids: [disk(1, 1, [0, 0, 0])], joint: revolute(z), coordinate: theta }
        point rim on wheel at [1, 0, 0],
        generate: [rhs, shapes],
    }
}

/// A bitmap fills a line that covers itself only once, so the trail of a wheel that makes many turns is drawn in
/// pieces.
#[test]
fn trails_cover_themselves() -> Result<(), Box<dyn Error>> {
    let wheel = Wheel::new(WheelParams {})?;
    let solution = Rk45::new().solve(&wheel, 0.0, 3.0, [0.3, std::f64::consts::TAU])?;
    let [svg, _] = Drawing::new(&wheel, &solution).ghosts(0).picture(&stem("wheel"))?;
    let svg = fs::read_to_string(svg)?;
    let mut pieces: Vec<Vec<[f64; 2]>> = Vec::new();
    for line in svg
        .split("<polyline ")
        .skip(1)
        .filter(|line| line.contains("fill=\"none\""))
    {
        let places = line.split("points=\"").nth(1).and_then(|rest| rest.split('"').next());
        let places = places.ok_or("no points")?.split_whitespace();
        let place = |place: &str| {
            let (x, y) = place.split_once(',').ok_or("no pair")?;
            Ok::<_, Box<dyn Error>>([x.parse()?, y.parse()?])
        };
        pieces.push(places.map(place).collect::<Result<_, _>>()?);
    }
    // symbols have fewer points
    pieces.retain(|piece| piece.len() > 5);
    assert!((5..=20).contains(&pieces.len()), "{}", pieces.len());
    let step = |pair: &[[f64; 2]]| [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
    let mut length = 0.0;
    for piece in &pieces {
        let ahead = step(piece);
        for pair in piece.windows(2) {
            let [x, y] = step(pair);
            length += x.hypot(y);
            assert!(x * ahead[0] + y * ahead[1] >= 0.0, "turns back at {pair:?}");
        }
    }
    for pair in pieces.windows(2) {
        assert_eq!(pair[0].last(), pair[1].first());
    }
    let across = pieces.iter().flatten().map(|place| place[0]);
    let (low, high) = across.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
    let turns = length / (std::f64::consts::PI * (high - low));
    assert!((turns - 3.0).abs() < 0.01, "{turns} turns");
    Ok(())
}

mechanism! {
    /// A ball joint and a free joint.
    Loose {
        body arm on ground { solids: [sphere(1, 0.1, [0, 0, -1])], joint: ball, orientation: a }
        body stone on ground { solids: [sphere(1, 0.1, [0, 0, 0])], joint: free, orientation: b, position: p }
        generate: [rhs, shapes],
    }
}

#[test]
fn bodies_that_move_freely_have_no_pivot() -> Result<(), Box<dyn Error>> {
    let mut x = SVector::from([0.0; 20]);
    (x[Loose::A], x[Loose::B], x[Loose::P_X]) = (1.0, 1.0, 2.0);
    let loose = Loose::new(LooseParams {})?;
    let shapes = loose.shapes(0.0, &x);
    let seen: Vec<_> = shapes.iter().map(|shape| (shape.name, shape.kind)).collect();
    let (sphere, support) = (ShapeKind::Sphere, ShapeKind::Support);
    assert_eq!(seen, [("arm", sphere), ("stone", sphere), ("arm", support)]);
    assert!((shapes[1].points[0].x - 2.0).abs() < 1e-15);
    Ok(())
}

mechanism! {
    /// A cart on a guide with a pole given by its mass and centre, and a block that slides and turns in the plane.
    Cart {
        gravity: [0, -9.81, 0],
        body base on ground { solids: [cuboid(1, [1, 0.1, 0.1], [0, -1, 0])] }
        body cart on base {
            solids: [cuboid(2, [0.5, 0.2, 0.2], [0, 0, 0])], joint: prismatic(x) at [0, 0.1, 0], coordinate: s,
        }
        body pole on cart {
            mass: 0.4, com: [0, -0.6, 0], inertia: 0.05, joint: revolute(z), coordinate: theta,
        }
        point tip on pole at [0, -1.2, 0],
        point end on pole at [0, -1.2, 0],
        body across on ground { joint: prismatic(x), coordinate: x }
        body up on across { joint: prismatic(y), coordinate: y }
        body block on up { solids: [cuboid(1, [0.1, 0.1, 0.1], [0, 0, 0])], joint: revolute(z), coordinate: phi }
        generate: [rhs, shapes],
    }
}

#[test]
fn bodies_reach_their_points_and_slide_on_guides() -> Result<(), Box<dyn Error>> {
    let cart = Cart::new(CartParams {})?;
    let mut x = SVector::from([0.0; 10]);
    x[Cart::S] = 2.0;
    let shapes = cart.shapes(0.0, &x);
    let seen: Vec<_> = shapes
        .iter()
        .map(|shape| (shape.name, shape.body, shape.kind))
        .collect();
    use ShapeKind::{Cuboid, Guide, Mass, Pivot, Point, Rod};
    let expected = [
        ("base", "ground", Cuboid),
        ("cart", "cart", Cuboid),
        ("pole", "pole", Mass),
        ("block", "block", Cuboid),
        // one rod to both points, which are at one place
        ("pole", "pole", Rod),
        ("cart", "ground", Guide),
        ("pole", "pole", Pivot),
        ("tip", "pole", Point),
        ("end", "pole", Point),
    ];
    assert_eq!(seen, expected);
    let near = |n: usize, end: usize, place: [f64; 3]| {
        let apart = shapes[n].points[end].coords - SVector::from(place);
        assert!(apart.norm() < 1e-15, "{:?}", shapes[n]);
    };
    near(4, 0, [2.0, 0.1, 0.0]);
    near(4, 1, [2.0, -1.1, 0.0]);
    near(5, 0, [0.0, 0.1, 0.0]);
    near(5, 1, [1.0, 0.1, 0.0]);
    Ok(())
}

/// The caption of a picture, and the number of its lines.
fn caption_and_lines<M: Shapes<N>, const N: usize>(
    name: &str,
    drawing: &Drawing<'_, M, N>,
) -> Result<(Vec<String>, usize), Box<dyn Error>> {
    let [svg, _] = drawing.picture(&stem(name))?;
    let svg = fs::read_to_string(svg)?;
    let texts = svg
        .split("<text")
        .skip(1)
        .filter_map(|text| text.split('>').nth(1)?.split('<').next());
    Ok((
        texts.map(|text| text.trim().to_owned()).collect(),
        svg.matches("<polyline").count(),
    ))
}

#[test]
fn pictures_have_scale_times_walls_and_springs() -> Result<(), Box<dyn Error>> {
    let cart = Cart::new(CartParams {})?;
    let solution = Rk45::new().solve(&cart, 0.0, 3.0, [0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])?;
    let drawing = Drawing::new(&cart, &solution);
    let (texts, lines) = caption_and_lines("caption", &drawing)?;
    assert_eq!(texts[1], "t = 0, 0.75, .., 3 s");
    assert!(texts[0].ends_with(" m"), "{texts:?}");
    let (few, _) = caption_and_lines("caption", &drawing.clone().ghosts(1))?;
    assert_eq!(few[1], "t = 0, 3 s");
    let (_, walled) = caption_and_lines("caption", &drawing.clone().wall([-20.0, -1.0, 0.0], [20.0, -1.0, 0.0]))?;
    assert!(walled > lines + 10, "{walled} {lines}");
    let (_, sprung) = caption_and_lines("caption", &drawing.clone().spring("tip", "end"))?;
    assert_ne!(sprung, lines);
    let error = drawing
        .spring("tip", "nail")
        .picture(&stem("unknown"))
        .expect_err("no such point");
    assert!(
        error.to_string().contains("no point `nail`") && error.to_string().contains("tip, end"),
        "{error}"
    );
    Ok(())
}

#[test]
fn what_cannot_be_drawn_is_an_error() -> Result<(), Box<dyn Error>> {
    let (zoo, solution) = zoo()?;
    let along = Drawing::new(&zoo, &solution).seen_from([0.0, 1.0, 0.0], [0.0, 2.0, 0.0]);
    let error = along.picture(&stem("along")).expect_err("no view");
    assert!(error.to_string().contains("parallel"), "{error}");
    let wall = Drawing::new(&zoo, &solution).wall([0.0, f64::NAN, 0.0], [1.0, 0.0, 0.0]);
    let error = wall.picture(&stem("wall")).expect_err("no place");
    assert!(error.to_string().contains("must be finite"), "{error}");
    let still = Drawing::new(&zoo, &solution).speed(0.0).animation(&stem("still"));
    assert!(still.expect_err("no speed").to_string().contains("positive"));
    Ok(())
}

mechanism! {
    /// A ball among walls of several forms.
    Court {
        params { room: m = 2 }
        gravity: [0, -9.81, 0],
        body slide on ground { joint: prismatic(x), coordinate: x }
        body ball on slide { mass: 1, joint: prismatic(y), coordinate: y }
        point tip on ball at [0, 0.5, 0],
        wall floor { gap: y },
        wall side { gap: room - tip.x + 0.1 m*sin(t*1 rad/s) },
        wall slope { gap: 3*x + 4*y + 10 },
        wall bowl { gap: y + 9 - x^2*0.1/1 m },
        generate: [rhs, shapes],
    }
}

mechanism! {
    /// A ball whose height is measured at its lowest point.
    Bounce {
        gravity: [0, -9.81, 0],
        wall floor { gap: y },
        body ball on ground { solids: [sphere(1, 0.25, [0, 0, 0])], joint: prismatic(y) at [0, 0.25, 0], coordinate: y }
        generate: [rhs, shapes],
    }
}

#[test]
fn balls_touch_walls() -> Result<(), Box<dyn Error>> {
    let shapes = Bounce::new(BounceParams {})?;
    let shapes = shapes.shapes(0.0, &SVector::from([0.5, 0.0]));
    let of = |kind| {
        shapes
            .iter()
            .find(|shape| shape.kind == kind)
            .map(|shape| shape.points[0])
    };
    assert_eq!(of(ShapeKind::Sphere), Some([0.0, 0.75, 0.0].into()));
    assert_eq!(of(ShapeKind::Wall), Some([0.0, 0.0, 0.0].into()));
    Ok(())
}

#[test]
fn flat_walls_are_below_their_points() -> Result<(), Box<dyn Error>> {
    let court = Court::new(CourtParams::default())?;
    let t = 0.25_f64;
    let shapes = court.shapes(t, &SVector::from([1.0, 2.0, 0.0, 0.0]));
    let walls: Vec<_> = shapes.iter().filter(|shape| shape.kind == ShapeKind::Wall).collect();
    let names: Vec<&str> = walls.iter().map(|wall| wall.name).collect();
    assert_eq!(names, ["floor", "side", "slope"]);
    // the gap of the slope is 5 times the distance from it, 21/5
    let feet = [
        [1.0, 0.0, 0.0],
        [2.0 + 0.1 * t.sin(), 2.5, 0.0],
        [1.0 - 0.6 * 4.2, 2.0 - 0.8 * 4.2, 0.0],
    ];
    let normals = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.6, 0.8, 0.0]];
    for ((wall, foot), normal) in walls.iter().zip(feet).zip(normals) {
        assert!((wall.points[0].coords - SVector::from(foot)).norm() < 1e-15, "{wall:?}");
        assert!(
            (wall.points[1] - wall.points[0] - SVector::from(normal)).norm() < 1e-15,
            "{wall:?}"
        );
    }
    Ok(())
}

#[test]
fn declared_walls_are_drawn_unless_surfaces_are_added() -> Result<(), Box<dyn Error>> {
    let court = Court::new(CourtParams::default())?;
    let solution = Rk45::new().solve(&court, 0.0, 1.0, [0.0, 1.0, 0.5, 0.0])?;
    let drawing = Drawing::new(&court, &solution);
    // a line, and strokes 5 pixels apart, across the picture of 240 pixels or more
    let (_, across) = caption_and_lines("walls", &drawing)?;
    assert!(across > 40, "{across}");
    let (_, added) = caption_and_lines("walls", &drawing.clone().wall([0.0, 0.0, 0.0], [0.01, 0.0, 0.0]))?;
    assert!(added < across - 40, "{added} {across}");
    // from above, the floor is seen from no side, and the others are
    let (_, above) = caption_and_lines("walls", &drawing.seen_from([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]))?;
    assert!(above < across, "{above} {across}");
    Ok(())
}

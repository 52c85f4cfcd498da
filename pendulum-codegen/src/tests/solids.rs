//! Mass, centre of mass and inertia of solids: against sums over many small masses, and against each other. Also the
//! plates that are rejected, and the drawing of solids.

use super::{dynamics, model, parse};
use crate::expr::Graph;
use crate::lower::lower;

/// Mass, first moment, and inertia about the origin `[xx, yy, zz, xy, xz, yz]`.
type Moments = [f64; 10];

fn moments(fields: &str) -> Moments {
    // a joint that turns about every axis but one keeps all entries meaningful
    let text = format!(
        "pub Solid {{ body base on ground {{ joint: revolute(x), coordinate: a }}
         body b on base {{ {fields}, joint: revolute(y), coordinate: b }} }}"
    );
    let graph = Graph::new();
    let model = model(&graph, &text);
    let inertia = &model.bodies[1].inertia;
    let mut parts = vec![inertia.mass];
    parts.extend(inertia.moment.0);
    parts.extend(inertia.about_origin.0);
    let values = model
        .graph
        .evaluate(&parts, |symbol| panic!("{} in numbers", symbol.name));
    values.try_into().expect("ten numbers")
}

fn of_points(mass: f64, points: &[[f64; 3]]) -> Moments {
    let each = mass / points.len() as f64;
    let mut sum = [0.0; 10];
    for &[x, y, z] in points {
        let parts = [
            1.0,
            x,
            y,
            z,
            y * y + z * z,
            x * x + z * z,
            x * x + y * y,
            -x * y,
            -x * z,
            -y * z,
        ];
        for (total, part) in sum.iter_mut().zip(parts) {
            *total += each * part;
        }
    }
    sum
}

/// Points of a lattice over a box that lie in a solid.
fn lattice(low: [f64; 3], high: [f64; 3], n: usize, inside: impl Fn([f64; 3]) -> bool) -> Vec<[f64; 3]> {
    let at = |k: usize, axis: usize| low[axis] + (high[axis] - low[axis]) * (k as f64 + 0.5) / n as f64;
    let all = (0..n * n * n).map(|k| [at(k / n / n, 0), at(k / n % n, 1), at(k % n, 2)]);
    all.filter(|&point| inside(point)).collect()
}

fn assert_moments(what: &str, ours: Moments, theirs: Moments, tolerance: f64) {
    for (n, (x, y)) in ours.iter().zip(theirs).enumerate() {
        assert!((x - y).abs() < tolerance, "{what}, number {n}: {x} is not {y}");
    }
}

/// Lattices of 60 points a side miss curved faces by about 1/60 of a cell each way and match plane ones exactly.
#[test]
fn solids_weigh_what_their_points_weigh() {
    let cuboid = lattice([0.5, -0.5, 0.0], [1.5, 0.0, 2.0], 60, |_| true);
    assert_moments(
        "cuboid",
        moments("solids: [cuboid(1.2, [1, 0.5, 2], [1, -0.25, 1])]"),
        of_points(1.2, &cuboid),
        1e-3,
    );
    let ball = lattice([0.0, 0.0, 0.0], [1.0, 1.0, 1.0], 60, |p| {
        p.iter().map(|x| (x - 0.5).powi(2)).sum::<f64>() < 0.25
    });
    assert_moments(
        "sphere",
        moments("solids: [sphere(2, 0.5, [0.5, 0.5, 0.5])]"),
        of_points(2.0, &ball),
        2e-3,
    );
    let (from, along) = ([0.1, 0.2, -0.3], [0.6, 0.0, 0.8]);
    let tube = lattice([-0.5, -0.5, -1.0], [1.5, 1.0, 1.5], 100, |p| {
        let d = [p[0] - from[0], p[1] - from[1], p[2] - from[2]];
        let height = d[0] * along[0] + d[1] * along[1] + d[2] * along[2];
        let radius2 = d.iter().map(|x| x * x).sum::<f64>() - height * height;
        (0.0..1.0).contains(&height) && radius2 < 0.16
    });
    let cylinder = moments("solids: [cylinder(1.5, 0.4, [0.1, 0.2, -0.3], [0.7, 0.2, 0.5])]");
    assert_moments("cylinder", cylinder, of_points(1.5, &tube), 5e-3);
}

#[test]
fn limits_of_solids_are_other_solids() {
    let same = |a: &str, b: &str| assert_moments(a, moments(a), moments(b), 1e-14);
    same(
        "solids: [rod(2, [0, 1, 0], [0.5, -1, 2])]",
        "solids: [cylinder(2, 0, [0, 1, 0], [0.5, -1, 2])]",
    );
    same(
        "solids: [rod(2, [0.5, -1, 2], [0, 1, 0])]",
        "solids: [rod(2, [0, 1, 0], [0.5, -1, 2])]",
    );
    same("solids: [point(2, [1, 2, 3])]", "solids: [sphere(2, 0, [1, 2, 3])]");
    same("solids: [point(2, [1, 2, 3])]", "mass: 2, com: [1, 2, 3]");
    same(
        "solids: [plate(3, [[0, 0], [2, 0], [2, 1], [0, 1]])]",
        "solids: [cuboid(3, [2, 1, 0], [1, 0.5, 0])]",
    );
    // opposite orientation, from another corner
    same(
        "solids: [plate(3, [[0, 0], [2, 0], [2, 1], [0, 1]])]",
        "solids: [plate(3, [[2, 1], [2, 0], [0, 0], [0, 1]])]",
    );
    // an irregular plate is the sum of its parts
    let parts = "solids: [cuboid(2, [2, 1, 0], [1, 0.5, 0]), cuboid(1, [1, 1, 0], [0.5, 1.5, 0])]";
    same(
        "solids: [plate(3, [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]])]",
        parts,
    );
    // a disk is a flat cylinder: its height vanishes
    let flat = moments("solids: [cylinder(2, 0.3, [1, 2, -1e-9], [1, 2, 1e-9])]");
    assert_moments("disk", moments("solids: [disk(2, 0.3, [1, 2, 0])]"), flat, 1e-14);
}

/// The integral of a quadratic over a triangle follows from its values at the corners and the centroid (Hammer and
/// Stroud).
#[test]
fn a_triangle_weighs_what_its_corners_and_its_middle_weigh() {
    let plate = moments("solids: [plate(12, [[2, 1], [7, -3], [-3, 8]])]");
    let points = "solids: [point(1, [2, 1, 0]), point(1, [7, -3, 0]), point(1, [-3, 8, 0]), point(9, [2, 2, 0])]";
    assert_moments("triangle", plate, moments(points), 1e-12);
}

/// Scene of a plate with these corners on one body.
fn scene_of_plate(parameters: &str, corners: &str) -> String {
    format!(
        "pub Plate {{ units: none, params {{ {parameters} }}
         body b on ground {{ solids: [plate(1, [{corners}])], joint: revolute(z), coordinate: a }} }}"
    )
}

/// Errors of a plate. Empty if it is valid.
fn errors_of_plate(parameters: &str, corners: &str) -> String {
    let (scene, errors) = parse(scene_of_plate(parameters, corners).parse().expect("tokens"));
    let graph = Graph::new();
    let lowered = scene
        .ok_or(errors)
        .and_then(|scene| lower(&graph, &scene, Default::default()));
    lowered.err().map(|errors| errors.to_string()).unwrap_or_default()
}

/// Variants of an outline: from each corner, in both orientations, and moved, turned and sheared.
fn outlines(corners: &[[i32; 2]]) -> Vec<String> {
    let mut outlines = Vec::new();
    let maps: [fn([i32; 2]) -> [i32; 2]; 3] = [
        |corner| corner,
        |[x, y]| [5 - y, x - 3],
        |[x, y]| [2 * x + y - 7, x + 3 * y + 2],
    ];
    for map in maps {
        let mut corners: Vec<_> = corners.iter().copied().map(map).collect();
        for _ in 0..2 {
            for _ in 0..corners.len() {
                corners.rotate_left(1);
                let corners: Vec<_> = corners.iter().map(|[x, y]| format!("[{x}, {y}]")).collect();
                outlines.push(corners.join(", "));
            }
            corners.reverse();
        }
    }
    outlines
}

#[test]
fn plates_of_numbers_have_a_simple_outline() {
    let simple: [&[[i32; 2]]; 5] = [
        &[[0, 0], [1, 0], [0, 1]],
        // a reflex corner, and a straight one
        &[[0, 0], [4, 0], [1, 1], [0, 4]],
        &[[0, 0], [1, 0], [2, 0], [0, 1]],
        // collinear sides apart from each other, and corners on the lines of other sides
        &[[0, 0], [3, 0], [3, 2], [2, 2], [2, 1], [1, 1], [1, 2], [0, 2]],
        &[[0, 0], [6, 0], [6, 1], [4, 1], [4, 4], [3, 4], [3, 1], [0, 1]],
    ];
    for outline in simple.iter().flat_map(|corners| outlines(corners)) {
        assert_eq!(errors_of_plate("", &outline), "", "{outline}");
    }
    let refused: [&[[i32; 2]]; 10] = [
        // crossing sides, with and without an area
        &[[0, 0], [2, 2], [2, 0], [0, 1]],
        &[[0, 0], [1, 1], [1, 0], [0, 1]],
        &[[0, 0], [4, 0], [4, 4], [1, -1], [0, 4]],
        // a corner on a side, on another corner, and next to an equal one
        &[[0, 0], [4, 0], [4, 2], [2, 0], [0, 2]],
        &[[0, 0], [2, 0], [1, 1], [2, 2], [0, 2], [1, 1]],
        &[[0, 0], [1, 0], [1, 0], [0, 1]],
        // overlapping sides that turn back
        &[[0, 0], [3, 0], [3, 1], [2, 0], [1, 0], [0, 1]],
        &[[0, 0], [2, 0], [1, 0], [1, 1]],
        &[[0, 0], [2, 0], [-1, 0], [-1, 1]],
        // all on one line
        &[[0, 0], [1, 1], [3, 3]],
    ];
    for outline in refused.iter().flat_map(|corners| outlines(corners)) {
        let errors = errors_of_plate("", &outline);
        assert!(
            errors.contains("the sides of a plate of `b` cross or touch"),
            "{outline}: {errors}"
        );
    }
    let of_numbers = errors_of_plate("", "[0, 0], [1, 0]");
    assert!(of_numbers.contains("a plate of `b` has 2 corners"), "{of_numbers}");
    // numeric sides that cross wherever another corner is, and a repeated corner
    for outline in [
        "[0, 0], [2, 2], [2, 0], [0, 1], [w, 9]",
        "[w, 9], [0, 0], [0, 0], [1, 0]",
    ] {
        let errors = errors_of_plate("w: m = -5", outline);
        assert!(
            errors.contains("the sides of a plate of `b` cross or touch"),
            "{outline}: {errors}"
        );
    }
}

/// Coordinates `w*x`, with a parameter `w`, hide the outline from checks of numbers, so the rules must reject it.
#[test]
fn plates_with_parameters_have_rules_for_sides_that_cross() {
    let of = |width: &str, outline: &str| errors_of_plate(&format!("w: 1 = {width}"), &outline.replace('[', "[w*"));
    let simple: [&[[i32; 2]]; 4] = [
        &[[0, 0], [1, 0], [0, 1]],
        &[[0, 0], [4, 0], [1, 1], [0, 4]],
        &[[0, 0], [3, 0], [4, 2], [2, 3], [2, 1], [1, 1], [1, 2], [0, 2]],
        // the line of the first side crosses the third one just beyond its own end
        &[[0, 0], [10, 0], [11, -1], [11, 1]],
    ];
    let crossed: [&[[i32; 2]]; 3] = [
        &[[0, 0], [2, 2], [2, 0], [0, 1]],
        &[[0, 0], [4, 0], [4, 4], [1, -1], [0, 4]],
        // one side ends at equal distances on both sides of another
        &[[0, 0], [4, 0], [5, 3], [3, 1], [1, -1]],
    ];
    // the check does not depend on the size of the plate
    for width in ["1", "0.001"] {
        for outline in simple.iter().flat_map(|corners| outlines(corners)) {
            assert_eq!(of(width, &outline), "", "{outline}");
        }
        for outline in crossed.iter().flat_map(|corners| outlines(corners)) {
            let errors = of(width, &outline);
            assert!(
                errors.contains("the sides of a plate of `b` must not cross"),
                "{outline}: {errors}"
            );
        }
    }
    // a corner that crosses a side by no more than rounding errors
    for outline in [
        "[0, 0], [4, 0], [4, 2], [2, -1e-14], [0, 2]",
        "[0, 2], [2, -1e-14], [4, 2], [4, 0], [0, 0]",
    ] {
        assert_eq!(of("1", outline), "", "{outline}");
    }
}

/// Corner `n` is on the low side of axis `k` if bit `k` of `n` is set.
#[test]
fn a_cuboid_is_drawn_by_its_corners() {
    let graph = Graph::new();
    let scene = "pub C { body b on ground {
        solids: [cuboid(1, [2, 4, 6], [10, 20, 30])], joint: revolute(z), coordinate: a
    } }";
    let [figure] = &model(&graph, scene).bodies[0].figures[..] else {
        panic!("one figure")
    };
    let corners: Vec<[f64; 3]> = figure
        .points
        .iter()
        .map(|point| point.0.map(|x| x.constant().expect("a number")))
        .collect();
    let expected = [
        [11.0, 22.0, 33.0],
        [9.0, 22.0, 33.0],
        [11.0, 18.0, 33.0],
        [9.0, 18.0, 33.0],
        [11.0, 22.0, 27.0],
        [9.0, 22.0, 27.0],
        [11.0, 18.0, 27.0],
        [9.0, 18.0, 27.0],
    ];
    assert_eq!(corners, expected);
}

#[test]
fn inertia_about_the_joint_is_moved_to_the_centre_of_mass() {
    let direct = "mass: 2, com: [0.1, -0.4, 0.2], inertia: [0.3, 0.2, 0.25, 0.01, -0.02, 0.03]";
    // J + m (|c|^2 1 - c c^T)
    let moved = "mass: 2, com: [0.1, -0.4, 0.2], inertia: [0.7, 0.3, 0.59, 0.09, -0.06, 0.19] about joint";
    assert_moments("about joint", moments(moved), moments(direct), 1e-15);
}

#[test]
fn a_number_for_the_inertia_is_about_the_axis_of_the_scene() {
    let entry = |inertia: &str| {
        let text = format!(
            "pub P {{ body b on ground {{ mass: 2, com: [0, -0.5, 0], {inertia}, joint: revolute(z), \
                coordinate: theta }} }}"
        );
        let graph = Graph::new();
        let (_, dynamics) = dynamics(&graph, &text);
        graph.evaluate(&[dynamics.balance.mass_matrix[0][0]], |_| 0.3)[0]
    };
    assert_eq!(entry("inertia: 0.25"), 0.75);
    assert_eq!(entry("inertia: [9, 9, 0.25]"), 0.75);
    assert_eq!(entry("inertia: 0.75 about joint"), 0.75);
}

//! Lines and outlines of the symbols of a drawing, in pixels of the page.

use charts::page::px;

/// A point of the page.
pub(crate) type Place = (i32, i32);

/// Points of the line at `length` pixels along the way from one place to another, and `side` to its left.
fn along(from: Place, to: Place) -> impl Fn(f64, f64) -> Place {
    let (dx, dy) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
    let whole = dx.hypot(dy).max(1.0);
    let (ahead, left) = ((dx / whole, dy / whole), (dy / whole, -dx / whole));
    move |length, side| {
        let at = |from: i32, ahead: f64, left: f64| from + (length * ahead + side * left).round() as i32;
        (at(from.0, ahead.0, left.0), at(from.1, ahead.1, left.1))
    }
}

fn distance(from: Place, to: Place) -> f64 {
    f64::from(to.0 - from.0).hypot(f64::from(to.1 - from.1))
}

/// Ends of the line from one place to another, moved to its left by `side` pixels of the picture.
pub(crate) fn beside(from: Place, to: Place, side: f64) -> [Place; 2] {
    let place = along(from, to);
    [0.0, distance(from, to)].map(|length| place(length, f64::from(px(side))))
}

/// Spring with a number of coils and straight ends.
pub(crate) fn spring(from: Place, to: Place, coils: usize) -> Vec<Place> {
    let (place, length) = (along(from, to), distance(from, to));
    let straight = f64::from(px(6.0)).min(0.15 * length);
    let pitch = (length - 2.0 * straight) / coils as f64;
    let coil = |n: usize| {
        let start = straight + n as f64 * pitch;
        let half = f64::from(px(4.5));
        [(start + 0.25 * pitch, half), (start + 0.75 * pitch, -half)]
    };
    let ends = [(0.0, 0.0), (straight, 0.0)];
    let line = ends
        .into_iter()
        .chain((0..coils).flat_map(coil))
        .chain([(length - straight, 0.0), (length, 0.0)]);
    line.map(|(length, side)| place(length, side)).collect()
}

/// Damper: its piston with the rod, and its open cylinder with the other rod.
pub(crate) fn damper(from: Place, to: Place) -> [Vec<Place>; 4] {
    let (place, length) = (along(from, to), distance(from, to));
    let (half, middle) = (f64::from(px(4.5)), 0.5 * length);
    let deep = f64::from(px(12.0)).min(0.3 * length);
    [
        vec![place(0.0, 0.0), place(middle, 0.0)],
        vec![place(middle, 0.7 * half), place(middle, -0.7 * half)],
        vec![
            place(middle - 0.5 * deep, half),
            place(middle + 0.5 * deep, half),
            place(middle + 0.5 * deep, -half),
            place(middle - 0.5 * deep, -half),
        ],
        vec![place(middle + 0.5 * deep, 0.0), place(length, 0.0)],
    ]
}

/// Strokes behind a surface, on the right-hand side of the way along it.
pub(crate) fn hatching(from: Place, to: Place) -> Vec<[Place; 2]> {
    let (place, length) = (along(from, to), distance(from, to));
    let (spacing, deep) = (f64::from(px(5.0)), f64::from(px(5.0)));
    let count = (length / spacing).floor().max(1.0) as usize;
    let stroke = |n: usize| {
        let end = length * (n as f64 + 1.0) / count as f64;
        [place(end, 0.0), place(end - deep, -deep)]
    };
    (0..count).map(stroke).collect()
}

/// Part of the line through two places, in its direction, within a drawing whose size is given in pixels of the picture
/// (Liang and Barsky 1984).
pub(crate) fn clipped([from, to]: [Place; 2], extent: [f64; 2]) -> Option<[Place; 2]> {
    let (x, y) = (f64::from(from.0), f64::from(from.1));
    let (dx, dy) = (f64::from(to.0) - x, f64::from(to.1) - y);
    let (mut first, mut last) = (f64::NEG_INFINITY, f64::INFINITY);
    for (at, ahead, end) in [(x, dx, extent[0]), (y, dy, extent[1])] {
        let ends = [-at, f64::from(px(end)) - at];
        if ahead == 0.0 {
            let is_within = ends[0] <= 0.0 && 0.0 <= ends[1];
            is_within.then_some(())?;
        } else {
            let ends = ends.map(|end| end / ahead);
            first = first.max(ends[0].min(ends[1]));
            last = last.min(ends[0].max(ends[1]));
        }
    }
    let place = |by: f64| ((x + by * dx).round() as i32, (y + by * dy).round() as i32);
    (first < last).then(|| [place(first), place(last)])
}

/// Support below a pivot: its triangle, and the ends of the ground under it.
pub(crate) fn support((x, y): Place) -> (Vec<Place>, [Place; 2]) {
    let (half, high, wide) = (px(5.0), px(9.0), px(8.0));
    let triangle = vec![(x, y), (x - half, y + high), (x + half, y + high), (x, y)];
    (triangle, [(x - wide, y + high), (x + wide, y + high)])
}

/// Splits a line into pieces that do not turn back, since a bitmap shows no line where it covers itself.
pub(crate) fn pieces(line: &[Place]) -> Vec<&[Place]> {
    let (mut pieces, mut from, mut ahead) = (Vec::new(), 0, (0, 0));
    for n in 1..line.len() {
        let step = (line[n].0 - line[n - 1].0, line[n].1 - line[n - 1].1);
        if ahead == (0, 0) {
            ahead = step;
        }
        if i64::from(step.0) * i64::from(ahead.0) + i64::from(step.1) * i64::from(ahead.1) < 0 {
            pieces.push(&line[from..n]);
            (from, ahead) = (n - 1, step);
        }
    }
    pieces.push(&line[from..]);
    pieces
}

/// Convex hull of points (Andrew 1979).
pub(crate) fn hull(mut points: Vec<Place>) -> Vec<Place> {
    points.sort_unstable();
    points.dedup();
    let half = |points: &mut dyn Iterator<Item = Place>| {
        let mut chain: Vec<Place> = Vec::new();
        for p in points {
            while let [.., a, b] = chain[..] {
                let turn = i64::from(b.0 - a.0) * i64::from(p.1 - a.1) - i64::from(b.1 - a.1) * i64::from(p.0 - a.0);
                if turn > 0 {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let lower = half(&mut points.iter().copied());
    let upper = half(&mut points.iter().rev().copied());
    [lower, upper].concat()
}

//! Frames: for each, the time, the state, kinetic and potential energy, and the coordinates of the points and the
//! radius of each shape.

use pendulum_runtime::{Error, Model, Shape, ShapeKind};

/// Adds a frame.
pub(crate) fn push(numbers: &mut Vec<f64>, model: &Model, t: f64, x: &[f64]) -> Result<(), Error> {
    numbers.push(t);
    numbers.extend_from_slice(x);
    numbers.extend(energy(model, t, x)?);
    for shape in shapes(model, t, x)? {
        numbers.extend(shape.points.iter().flat_map(|point| [point.x, point.y, point.z]));
        numbers.push(shape.radius);
    }
    Ok(())
}

/// Kinetic and potential energy; zero if nothing moves in space.
fn energy(model: &Model, t: f64, x: &[f64]) -> Result<[f64; 2], Error> {
    match model.energy(t, x) {
        Err(Error::NotGenerated { .. }) => Ok([0.0; 2]),
        energy => energy,
    }
}

/// Shapes of the mechanism; none if nothing moves in space.
pub(crate) fn shapes<'m>(model: &'m Model, t: f64, x: &[f64]) -> Result<Vec<Shape<'m>>, Error> {
    match model.shapes(t, x) {
        Err(Error::NotGenerated { .. }) => Ok(Vec::new()),
        shapes => shapes,
    }
}

/// True for shapes that a hand can move, and whose motion is drawn.
pub(crate) fn moves(shape: &Shape<'_>) -> bool {
    shape.body != "ground" && !matches!(shape.kind, ShapeKind::Guide | ShapeKind::Wall)
}

/// Times of frames, equally spaced, the last at the end of the span.
pub(crate) fn times([t0, t1]: [f64; 2], frames: usize) -> Vec<f64> {
    let time = |n: usize| {
        if n == frames {
            t1
        } else {
            t0 + (t1 - t0) * (n as f64 / frames as f64)
        }
    };
    (1..=frames).map(time).collect()
}

//! Frames: for each, the time, the state, kinetic and potential energy, and the coordinates of the points and the
//! radius of each shape.

use pendulum_runtime::{Error, Model};

/// Adds a frame.
pub(crate) fn push(numbers: &mut Vec<f64>, model: &Model, t: f64, x: &[f64]) -> Result<(), Error> {
    numbers.push(t);
    numbers.extend_from_slice(x);
    numbers.extend(energy(model, t, x)?);
    push_shapes(numbers, model, t, x)
}

/// Kinetic and potential energy; zero if nothing moves in space.
fn energy(model: &Model, t: f64, x: &[f64]) -> Result<[f64; 2], Error> {
    match model.energy(t, x) {
        Err(Error::NotGenerated { .. }) => Ok([0.0; 2]),
        energy => energy,
    }
}

/// Adds the coordinates of the points and the radius of each shape.
pub(crate) fn push_shapes(numbers: &mut Vec<f64>, model: &Model, t: f64, x: &[f64]) -> Result<(), Error> {
    for shape in shapes(model, t, x)? {
        numbers.extend(shape.points.iter().flat_map(|point| [point.x, point.y, point.z]));
        numbers.push(shape.radius);
    }
    Ok(())
}

/// Shapes of the mechanism; none if nothing moves in space.
pub(crate) fn shapes<'m>(model: &'m Model, t: f64, x: &[f64]) -> Result<Vec<pendulum_runtime::Shape<'m>>, Error> {
    match model.shapes(t, x) {
        Err(Error::NotGenerated { .. }) => Ok(Vec::new()),
        shapes => shapes,
    }
}

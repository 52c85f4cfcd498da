//! Pictures and animations of mechanisms, from the shapes of their declarations.
//!
//! ```no_run
//! use pendulum_core::prelude::*;
//! use pendulum_draw::Drawing;
//!
//! mechanism! {
//!     pub Swing {
//!         gravity: [0, -9.81, 0],
//!         point tip on bob at [0, -1, 0],
//!         body bob on ground { solids: [rod(1, [0, 0, 0], [0, -1, 0])], joint: revolute(z), coordinate: theta }
//!         generate: [rhs, shapes],
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let swing = Swing::new(SwingParams {})?;
//! let solution = Vern7::new().solve(&swing, 0.0, 5.0, [2.0, 0.0])?;
//! Drawing::new(&swing, &solution).picture("out/swing".as_ref())?;
//! Drawing::new(&swing, &solution).animation("out/swing".as_ref())?;
//! # Ok(())
//! # }
//! ```
//!
//! Planar mechanisms are viewed along the z axis; others from a direction of choice ([`Drawing::seen_from`]).
#![forbid(unsafe_code)]

mod glyph;
mod still;

use std::error::Error;
use std::path::{Path, PathBuf};

use charts::animation::save_gif;
use charts::page::Picture;
use nalgebra::{Matrix2x3, Vector3};
use pendulum_core::Solution;
use pendulum_core::shapes::{Shape, ShapeKind, Shapes};

use still::{Frame, Motion, Part, Still};

/// Frame rate of an animation, in frames per second.
const RATE: u32 = 25;

/// Points of a trail per second, and their minimum and maximum number.
const TRAIL: (f64, f64, f64) = (100.0, 1500.0, 20_000.0);

/// Motion of a model, to be drawn.
#[derive(Clone, Debug)]
pub struct Drawing<'a, M, const N: usize> {
    model: &'a M,
    solution: &'a Solution<f64, N>,
    /// Projection from space to the plane of the picture.
    view: Matrix2x3<f64>,
    ghosts: usize,
    speed: f64,
    /// Surfaces, by their ends in the ground frame.
    walls: Vec<[Vector3<f64>; 2]>,
    /// Pairs of declared points between which a spring is drawn.
    springs: Vec<[&'a str; 2]>,
}

impl<'a, M: Shapes<N>, const N: usize> Drawing<'a, M, N> {
    /// The motion of a solution.
    pub fn new(model: &'a M, solution: &'a Solution<f64, N>) -> Self {
        Self {
            model,
            solution,
            view: Matrix2x3::identity(),
            ghosts: 4,
            speed: 1.0,
            walls: Vec::new(),
            springs: Vec::new(),
        }
    }

    /// Sets the direction of view from far away, in the ground frame, and the direction `up` that points upward in the
    /// picture: z and y by default. Both may have any length, and must not be parallel.
    #[must_use]
    pub fn seen_from(mut self, direction: [f64; 3], up: [f64; 3]) -> Self {
        let [direction, up] = [direction, up].map(|v| Vector3::from(v).normalize());
        let right = up.cross(&direction).normalize();
        let up = direction.cross(&right);
        self.view = Matrix2x3::from_rows(&[right.transpose(), up.transpose()]);
        self
    }

    /// Sets the number of earlier positions of the bodies that a picture shows besides the last one: 4 by default.
    #[must_use]
    pub fn ghosts(mut self, ghosts: usize) -> Self {
        self.ghosts = ghosts;
        self
    }

    /// Sets the speed of the animation relative to the motion: 1 by default.
    #[must_use]
    pub fn speed(mut self, speed: f64) -> Self {
        self.speed = speed;
        self
    }

    /// Adds a surface at rest, a line between two points of the ground frame. The right-hand side of the way from one
    /// to the other is solid. Flat [walls](ShapeKind::Wall) of the declaration are drawn only if no surface is added.
    #[must_use]
    pub fn wall(mut self, from: [f64; 3], to: [f64; 3]) -> Self {
        self.walls.push([from, to].map(Vector3::from));
        self
    }

    /// Adds a spring between two declared points, for a potential that is declared as a formula. The points leave no
    /// trail. Declared springs are drawn without it.
    #[must_use]
    pub fn spring(mut self, from: &'a str, to: &'a str) -> Self {
        self.springs.push([from, to]);
        self
    }

    /// Writes a picture of the whole motion to `stem` with the extensions svg and png, and returns the paths. It shows
    /// the bodies at the end and, as shadows, at some earlier times, the trails of the declared points, a scale and the
    /// times.
    ///
    /// # Errors
    ///
    /// If a file cannot be written, if the directions of the view are parallel, or if a spring is added to a point that
    /// is not declared.
    pub fn picture(&self, stem: &Path) -> Result<[PathBuf; 2], Box<dyn Error>> {
        let motion = self.motion()?;
        let at = |n: usize| match self.ghosts {
            0 => 1.0,
            ghosts => n as f64 / ghosts as f64,
        };
        let bodies = (0..=self.ghosts).map(|n| self.frame(self.time(at(n))));
        let bodies = bodies.collect::<Result<Vec<_>, _>>()?;
        Still::whole(&motion, bodies).save(stem)
    }

    /// Writes an endless animation to `stem` with the extension gif, at 25 frames per second, and returns its path.
    ///
    /// # Errors
    ///
    /// If the file cannot be written, if `speed` is not positive, and as [`picture`](Self::picture).
    pub fn animation(&self, stem: &Path) -> Result<PathBuf, Box<dyn Error>> {
        let (start, end) = self.span();
        let step = self.speed / f64::from(RATE);
        if step <= 0.0 || step.is_nan() {
            return Err(format!("the speed is {}: it must be positive", self.speed).into());
        }
        let count = ((end - start) / step).floor() as usize + 1;
        let part = |n: usize| (step * n as f64 / (end - start)).min(1.0);
        let frames = (0..count).map(|n| self.frame(self.time(part(n))));
        let frames = frames.collect::<Result<Vec<_>, _>>()?;
        let motion = self.motion()?;
        save_gif(stem, RATE, frames.into_iter().map(|frame| Still::at(&motion, frame)))
    }

    fn span(&self) -> (f64, f64) {
        (self.solution.t()[0], self.solution.last().0)
    }

    fn motion(&self) -> Result<Motion, Box<dyn Error>> {
        let ((start, end), (rate, fewest, most)) = (self.span(), TRAIL);
        let count = ((end - start).abs() * rate).clamp(fewest, most).floor();
        let times = (0..=count as usize).map(|n| self.time(n as f64 / count));
        let frames = times.map(|t| self.frame(t)).collect::<Result<_, _>>()?;
        let walls = self.walls.iter().map(|wall| wall.map(|end| self.seen(end)));
        let untraced = self.springs.iter().flatten().map(|&end| end.to_owned());
        Ok(Motion::new(frames, walls.collect(), untraced.collect())?)
    }

    /// Position in the plane of the picture.
    fn seen(&self, point: Vector3<f64>) -> [f64; 2] {
        (self.view * point).into()
    }

    /// Time at a fraction of the motion, from 0 to 1; at 1 exactly the end, which rounding must not exceed.
    fn time(&self, part: f64) -> f64 {
        let (start, end) = self.span();
        (1.0 - part) * start + part * end
    }

    /// The frame at a time.
    fn frame(&self, t: f64) -> Result<Frame, Box<dyn Error>> {
        let x = self.solution.at(t)?;
        let part = |shape: Shape<'_>| Part {
            name: shape.name.to_owned(),
            body: shape.body.to_owned(),
            kind: shape.kind,
            points: shape.points.iter().map(|point| self.seen(point.coords)).collect(),
            radius: shape.radius,
        };
        let mut parts: Vec<Part> = self.model.shapes(t, &x).into_iter().map(part).collect();
        for ends in &self.springs {
            let [from, to] = ends.map(|name| point(&parts, name));
            let (from, to) = (from?, to?);
            parts.push(Part {
                name: from.name.clone(),
                body: from.body.clone(),
                kind: ShapeKind::Spring,
                points: vec![from.points[0], to.points[0]],
                radius: 0.0,
            });
        }
        Ok(Frame { t, parts })
    }
}

/// The declared point of a name.
fn point<'p>(parts: &'p [Part], name: &str) -> Result<&'p Part, String> {
    let is_point = |part: &&Part| matches!(part.kind, ShapeKind::Point | ShapeKind::Anchor);
    let found = parts.iter().filter(is_point).find(|part| part.name == name);
    found.ok_or_else(|| {
        let names: Vec<&str> = parts.iter().filter(is_point).map(|part| part.name.as_str()).collect();
        format!(
            "no point `{name}` to which to draw a spring; declared are: {}",
            names.join(", ")
        )
    })
}

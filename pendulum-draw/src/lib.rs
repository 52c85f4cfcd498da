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
//! Plane mechanisms are seen as they are, along the z axis; others from a place of their own ([`Drawing::seen_from`]).

mod still;

use std::error::Error;
use std::path::{Path, PathBuf};

use charts::animation::save_gif;
use charts::page::Picture;
use nalgebra::{Matrix2x3, Point3, Vector3};
use pendulum_core::Solution;
use pendulum_core::shapes::{Shape, ShapeKind, Shapes};

use still::{Frame, Still};

/// Pictures in a second of an animation.
const RATE: u32 = 25;

/// Parts of the motion between two places of a trail.
const TRAIL: usize = 1500;

/// The motion of a model, to be drawn.
#[derive(Clone, Debug)]
pub struct Drawing<'a, M, const N: usize> {
    model: &'a M,
    solution: &'a Solution<f64, N>,
    view: Matrix2x3<f64>,
    ghosts: usize,
    speed: f64,
}

impl<'a, M: Shapes<N>, const N: usize> Drawing<'a, M, N> {
    /// The motion of a solution.
    pub fn new(model: &'a M, solution: &'a Solution<f64, N>) -> Self {
        Self {
            model,
            solution,
            view: Matrix2x3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0),
            ghosts: 4,
            speed: 1.0,
        }
    }

    /// Seen from a direction in which `up` points upward; both are any vectors of the ground frame that are not parallel.
    #[must_use]
    pub fn seen_from(mut self, direction: [f64; 3], up: [f64; 3]) -> Self {
        let [direction, up] = [direction, up].map(|v| Vector3::from(v).normalize());
        let right = up.cross(&direction).normalize();
        let up = direction.cross(&right);
        self.view = Matrix2x3::from_rows(&[right.transpose(), up.transpose()]);
        self
    }

    /// How many earlier places of the bodies a picture shows beside the last one: 4 by default.
    #[must_use]
    pub fn ghosts(mut self, ghosts: usize) -> Self {
        self.ghosts = ghosts;
        self
    }

    /// How much faster than the motion its animation runs: 1 by default.
    #[must_use]
    pub fn speed(mut self, speed: f64) -> Self {
        self.speed = speed;
        self
    }

    /// Writes a picture of the whole motion to `stem` with the endings svg and png, and says where: the bodies at the end, as
    /// shadows at some times before, and the trails of the declared points.
    ///
    /// # Errors
    ///
    /// Where a file cannot be written.
    pub fn picture(&self, stem: &Path) -> Result<[PathBuf; 2], Box<dyn Error>> {
        self.still()?.save(stem)
    }

    /// The same as an SVG alone.
    ///
    /// # Errors
    ///
    /// Where a file cannot be written.
    pub fn svg(&self) -> Result<String, Box<dyn Error>> {
        self.still()?.svg()
    }

    /// Writes an animation to `stem` with the ending gif, and says where: 25 pictures in a second, again and again.
    ///
    /// # Errors
    ///
    /// Where the file cannot be written, or where `speed` is not positive.
    pub fn animation(&self, stem: &Path) -> Result<PathBuf, Box<dyn Error>> {
        let (start, end) = self.span();
        let step = self.speed / f64::from(RATE);
        if step <= 0.0 || step.is_nan() {
            return Err(format!("the speed is {}: it must be positive", self.speed).into());
        }
        let count = ((end - start) / step).floor() as usize + 1;
        let trails = self.frames(TRAIL)?;
        let bounds = still::bounds(&trails);
        let stills = (0..count).map(|n| {
            let t = start + step * n as f64;
            let so_far = trails.iter().take_while(|frame| frame.t <= t).cloned().collect();
            Ok(Still::new(so_far, vec![self.frame(t)?], bounds))
        });
        let stills = stills.collect::<Result<Vec<_>, Box<dyn Error>>>()?;
        save_gif(stem, RATE, stills)
    }

    fn still(&self) -> Result<Still, Box<dyn Error>> {
        let (start, end) = self.span();
        let trails = self.frames(TRAIL)?;
        let last = self.ghosts as f64;
        let at = |n: usize| {
            if self.ghosts == 0 {
                end
            } else {
                start + (end - start) * n as f64 / last
            }
        };
        let bodies = (0..=self.ghosts)
            .map(|n| self.frame(at(n)))
            .collect::<Result<Vec<_>, _>>()?;
        let bounds = still::bounds(&trails);
        Ok(Still::new(trails, bodies, bounds))
    }

    fn span(&self) -> (f64, f64) {
        let (first, last) = (self.solution.t()[0], self.solution.last().0);
        (first, last)
    }

    fn frames(&self, count: usize) -> Result<Vec<Frame>, Box<dyn Error>> {
        let (start, end) = self.span();
        (0..=count)
            .map(|n| self.frame(start + (end - start) * n as f64 / count as f64))
            .collect()
    }

    /// What is seen at a time.
    fn frame(&self, t: f64) -> Result<Frame, Box<dyn Error>> {
        let x = self.solution.at(t)?;
        let shapes = self.model.shapes(t, &x);
        Ok(Frame {
            t,
            parts: shapes.iter().map(|shape| self.part(shape)).collect(),
        })
    }

    fn part(&self, shape: &Shape) -> still::Part {
        let flat = |point: &Point3<f64>| {
            let place = self.view * point.coords;
            [place.x, place.y]
        };
        still::Part {
            name: shape.name,
            kind: shape.kind,
            points: shape.points.iter().map(flat).collect(),
            radius: shape.radius,
        }
    }
}

/// Whether a kind is the solid of a body.
fn is_solid(kind: ShapeKind) -> bool {
    use ShapeKind::{Cuboid, Cylinder, Disk, Mass, Plate, Rod, Sphere};
    matches!(kind, Mass | Rod | Disk | Plate | Cuboid | Cylinder | Sphere)
}

//! Still picture of a mechanism.

use std::error::Error;

use charts::page::{BLUE, GREEN, GREY, ORANGE, PURPLE, Picture, RGBColor, SKY, VERMILION, px, width};
use pendulum_core::shapes::ShapeKind;
use plotters::coord::Shift;
use plotters::prelude::*;

/// Colours of bodies, in the order of the declaration.
const COLORS: [RGBColor; 6] = [BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY];

/// Longer side of a picture, in pixels.
const LONGEST: f64 = 480.0;
/// Minimum of the shorter side, in pixels.
const SHORTEST: f64 = 240.0;
/// Space around the drawing, in pixels.
const MARGIN: f64 = 24.0;

/// Bodies and other shapes at a time.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    pub(crate) t: f64,
    pub(crate) parts: Vec<Part>,
}

/// Shape in the plane of the picture, in m.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) name: String,
    pub(crate) kind: ShapeKind,
    pub(crate) points: Vec<[f64; 2]>,
    pub(crate) radius: f64,
}

/// Smallest and largest coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    low: [f64; 2],
    high: [f64; 2],
}

impl Bounds {
    /// Bounds of all frames together.
    pub(crate) fn of(frames: &[Frame]) -> Result<Self, String> {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for part in frames.iter().flat_map(|frame| &frame.parts) {
            for axis in 0..2 {
                for point in &part.points {
                    low[axis] = low[axis].min(point[axis] - part.radius);
                    high[axis] = high[axis].max(point[axis] + part.radius);
                }
            }
        }
        if low.iter().chain(&high).any(|bound| !bound.is_finite()) {
            return Err(
                "nothing can be drawn: the scene has no bodies, or is seen from a direction parallel to `up`"
                    .to_owned(),
            );
        }
        Ok(Self { low, high })
    }
}

/// Bodies on the trails of their points.
#[derive(Clone, Debug)]
pub(crate) struct Still<'a> {
    trails: &'a [Frame],
    /// In chronological order; all but the last are shadows.
    bodies: Vec<Frame>,
    /// Bodies with their own colours.
    names: Vec<String>,
    bounds: Bounds,
}

impl<'a> Still<'a> {
    pub(crate) fn new(trails: &'a [Frame], bodies: Vec<Frame>, bounds: Bounds) -> Self {
        let solids = bodies.iter().take(1).flat_map(|frame| &frame.parts);
        let mut names: Vec<String> = Vec::new();
        for part in solids.filter(|part| is_solid(part.kind)) {
            if !names.contains(&part.name) {
                names.push(part.name.clone());
            }
        }
        Self {
            trails,
            bodies,
            names,
            bounds,
        }
    }

    /// Pixels of the picture per metre.
    fn scale(&self) -> f64 {
        let Bounds { low, high } = self.bounds;
        let longest = (high[0] - low[0]).max(high[1] - low[1]);
        (LONGEST - 2.0 * MARGIN) / longest.max(f64::MIN_POSITIVE)
    }

    /// Size in pixels of the picture.
    fn extent(&self) -> [f64; 2] {
        let Bounds { low, high } = self.bounds;
        [0, 1].map(|axis| {
            (self.scale() * (high[axis] - low[axis]) + 2.0 * MARGIN)
                .max(SHORTEST)
                .ceil()
        })
    }

    /// Position of a point, in pixels of the drawing.
    fn place(&self, point: [f64; 2]) -> (i32, i32) {
        let (Bounds { low, high }, extent) = (self.bounds, self.extent());
        let from_middle = |axis: usize| self.scale() * (point[axis] - 0.5 * (low[axis] + high[axis]));
        (
            px(0.5 * extent[0] + from_middle(0)),
            px(0.5 * extent[1] - from_middle(1)),
        )
    }

    fn places(&self, points: &[[f64; 2]]) -> Vec<(i32, i32)> {
        points.iter().map(|&point| self.place(point)).collect()
    }

    /// Colour of a body, by its index among the visible ones.
    fn color(&self, name: &str) -> RGBColor {
        let place = self.names.iter().position(|known| *known == name).unwrap_or(0);
        COLORS[place % COLORS.len()]
    }

    fn draw_trails<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let parts = self.trails.first().map_or(&[][..], |frame| &frame.parts);
        let points = parts
            .iter()
            .enumerate()
            .filter(|(_, part)| part.kind == ShapeKind::Point);
        let mut colors = [VERMILION, BLUE, GREEN, PURPLE, ORANGE, SKY].into_iter().cycle();
        for (n, _) in points {
            let trail: Vec<_> = self
                .trails
                .iter()
                .map(|frame| self.place(frame.parts[n].points[0]))
                .collect();
            let color = on_white(colors.next().unwrap_or(VERMILION), 0.45);
            for piece in pieces(&trail) {
                page.draw(&PathElement::new(piece, color.stroke_width(width(1.2))))?;
            }
        }
        Ok(())
    }

    fn draw_part<B: DrawingBackend>(
        &self,
        page: &DrawingArea<B, Shift>,
        part: &Part,
        strength: f64,
    ) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let color = self.color(&part.name).mix(0.85 * strength);
        let grey = GREY.mix(strength);
        let places = self.places(&part.points);
        let line = |places: Vec<(i32, i32)>, thick: f64, color: RGBAColor| {
            PathElement::new(places, color.stroke_width(width(thick)))
        };
        match part.kind {
            ShapeKind::Mass => {
                let mass = Circle::new(places[0], px(6.0), color.filled());
                page.draw(&line(places, 2.0, color))?;
                page.draw(&mass)?;
            }
            ShapeKind::Rod => page.draw(&line(places, 5.0, color))?,
            ShapeKind::Plate => page.draw(&Polygon::new(places, color.filled()))?,
            ShapeKind::Cuboid => page.draw(&Polygon::new(hull(places), color.filled()))?,
            ShapeKind::Cylinder => {
                let thick = (2.0 * self.scale() * part.radius).max(3.0);
                page.draw(&line(places, thick, color))?;
            }
            ShapeKind::Disk | ShapeKind::Sphere => {
                let radius = px((self.scale() * part.radius).max(3.0));
                page.draw(&Circle::new(places[0], radius, color.filled()))?;
                if part.kind == ShapeKind::Disk {
                    page.draw(&line(places, 1.5, WHITE.mix(strength)))?;
                }
            }
            ShapeKind::Pivot if strength == 1.0 => {
                page.draw(&Circle::new(places[0], px(3.5), grey.filled()))?;
                page.draw(&Circle::new(places[0], px(1.5), WHITE.filled()))?;
            }
            ShapeKind::Spring => page.draw(&line(zigzag(places[0], places[1]), 1.5, grey))?,
            ShapeKind::Damper => page.draw(&line(places, 3.0, grey.mix(0.6)))?,
            ShapeKind::Anchor if strength == 1.0 => {
                let ((x, y), half) = (places[0], px(4.0));
                page.draw(&Polygon::new(
                    vec![(x, y), (x - half, y + 2 * half), (x + half, y + 2 * half)],
                    grey.filled(),
                ))?;
            }
            ShapeKind::Point if strength == 1.0 => page.draw(&Circle::new(places[0], px(2.0), grey.filled()))?,
            ShapeKind::Pivot | ShapeKind::Anchor | ShapeKind::Point => {}
        }
        Ok(())
    }
}

impl Picture for Still<'_> {
    fn size(&self) -> (u32, u32) {
        let [width, height] = self.extent();
        (width as u32, height as u32)
    }

    fn draw<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        page.fill(&WHITE)?;
        self.draw_trails(page)?;
        for (n, frame) in self.bodies.iter().enumerate() {
            let strength = if n + 1 == self.bodies.len() { 1.0 } else { 0.18 };
            for part in &frame.parts {
                self.draw_part(page, part, strength)?;
            }
        }
        page.present()?;
        Ok(())
    }
}

/// True if a shape is the solid of a body.
fn is_solid(kind: ShapeKind) -> bool {
    use ShapeKind::{Cuboid, Cylinder, Disk, Mass, Plate, Rod, Sphere};
    matches!(kind, Mass | Rod | Disk | Plate | Cuboid | Cylinder | Sphere)
}

/// Blends a colour with white; `part` is its share.
fn on_white(RGBColor(red, green, blue): RGBColor, part: f64) -> RGBColor {
    let [red, green, blue] = [red, green, blue].map(|of| (255.0 - part * (255.0 - f64::from(of))).round() as u8);
    RGBColor(red, green, blue)
}

/// Splits a line into pieces that do not turn back, since a bitmap shows no line where it covers itself.
fn pieces(line: &[(i32, i32)]) -> Vec<&[(i32, i32)]> {
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

/// Zigzag line between two ends.
fn zigzag(from: (i32, i32), to: (i32, i32)) -> Vec<(i32, i32)> {
    const BENDS: i32 = 12;
    let (dx, dy) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
    let length = dx.hypot(dy).max(1.0);
    let across = (-dy / length, dx / length);
    let place = |n: i32| {
        let part = f64::from(n) / f64::from(BENDS);
        let side = match n {
            0 | BENDS => 0.0,
            n => f64::from(px(4.0)) * f64::from(1 - 2 * (n % 2)),
        };
        let at = |start: i32, d: f64, across: f64| start + (part * d + side * across).round() as i32;
        (at(from.0, dx, across.0), at(from.1, dy, across.1))
    };
    (0..=BENDS).map(place).collect()
}

/// Convex hull of points (Andrew 1979).
fn hull(mut points: Vec<(i32, i32)>) -> Vec<(i32, i32)> {
    points.sort_unstable();
    points.dedup();
    let half = |points: &mut dyn Iterator<Item = (i32, i32)>| {
        let mut chain: Vec<(i32, i32)> = Vec::new();
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

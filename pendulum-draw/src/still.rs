//! Still picture of a mechanism.

use std::error::Error;

use charts::page::{BLUE, GREEN, GREY, INK, ORANGE, PURPLE, Picture, RGBColor, SKY, VERMILION, px, text, width};
use pendulum_core::shapes::ShapeKind;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::glyph::{self, Place};

/// Colours of bodies, in the order of the declaration.
const COLORS: [RGBColor; 6] = [BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY];
/// Strength of the colours of the first and the last shadow, relative to those of the bodies.
const SHADOWS: [f64; 2] = [0.2, 0.45];
/// Strength of the colours of trails.
const TRAIL: f64 = 0.6;

/// Longer side of the drawing, in pixels.
const LONGEST: f64 = 480.0;
/// Minimum of the shorter side, in pixels.
const SHORTEST: f64 = 240.0;
/// Space around the drawing, in pixels.
const MARGIN: f64 = 28.0;
/// Height of the caption below the drawing, in pixels.
const CAPTION: f64 = 26.0;
/// Half the length of a wall that is not seen from its side, in pixels.
const PATCH: f64 = 40.0;
/// Mean length of a coil of a spring, in pixels.
const COIL: f64 = 8.0;

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
    /// Body to which the shape belongs.
    pub(crate) body: String,
    pub(crate) kind: ShapeKind,
    pub(crate) points: Vec<[f64; 2]>,
    pub(crate) radius: f64,
}

/// All that the pictures of a motion share.
#[derive(Clone, Debug)]
pub(crate) struct Motion {
    /// Frames in chronological order, close enough to join the points of a trail by lines.
    frames: Vec<Frame>,
    /// Surfaces at rest, whose right-hand side is solid.
    walls: Vec<[[f64; 2]; 2]>,
    /// Points that leave no trail.
    untraced: Vec<String>,
    /// Moving bodies, in the order of the declaration.
    bodies: Vec<String>,
    /// Smallest and largest coordinates.
    low: [f64; 2],
    high: [f64; 2],
}

impl Motion {
    pub(crate) fn new(frames: Vec<Frame>, walls: Vec<[[f64; 2]; 2]>, untraced: Vec<String>) -> Result<Self, String> {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let mut include = |point: &[f64; 2], radius: f64| {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis] - radius);
                high[axis] = high[axis].max(point[axis] + radius);
            }
        };
        let extended = frames.iter().flat_map(|frame| &frame.parts);
        for part in extended.filter(|part| !matches!(part.kind, ShapeKind::Guide | ShapeKind::Wall)) {
            part.points.iter().for_each(|point| include(point, part.radius));
        }
        walls.iter().flatten().for_each(|point| include(point, 0.0));
        if let Some([from, to]) = walls.iter().find(|wall| wall.iter().flatten().any(|x| !x.is_finite())) {
            return Err(format!(
                "a wall from {from:?} to {to:?} cannot be drawn: its ends must be finite"
            ));
        }
        if low.iter().chain(&high).any(|bound| !bound.is_finite()) {
            return Err(
                "nothing can be drawn: the scene has no bodies, or is seen from a direction parallel to `up`"
                    .to_owned(),
            );
        }
        let mut bodies: Vec<String> = Vec::new();
        for part in frames.iter().take(1).flat_map(|frame| &frame.parts) {
            if is_solid(part.kind) && part.body != GROUND && !bodies.contains(&part.body) {
                bodies.push(part.body.clone());
            }
        }
        Ok(Self {
            frames,
            walls,
            untraced,
            bodies,
            low,
            high,
        })
    }

    /// Pixels of the picture per metre.
    fn scale(&self) -> f64 {
        let longest = (self.high[0] - self.low[0]).max(self.high[1] - self.low[1]);
        (LONGEST - 2.0 * MARGIN) / longest.max(f64::MIN_POSITIVE)
    }

    /// Size of the drawing without its caption, in pixels.
    fn extent(&self) -> [f64; 2] {
        [0, 1].map(|axis| {
            (self.scale() * (self.high[axis] - self.low[axis]) + 2.0 * MARGIN)
                .max(SHORTEST)
                .ceil()
        })
    }

    /// Position of a point on the page.
    fn place(&self, point: [f64; 2]) -> Place {
        let extent = self.extent();
        let from_middle = |axis: usize| self.scale() * (point[axis] - 0.5 * (self.low[axis] + self.high[axis]));
        (
            px(0.5 * extent[0] + from_middle(0)),
            px(0.5 * extent[1] - from_middle(1)),
        )
    }

    fn places(&self, points: &[[f64; 2]]) -> Vec<Place> {
        points.iter().map(|&point| self.place(point)).collect()
    }

    /// Colour of a body.
    fn color(&self, body: &str) -> RGBColor {
        let n = self.bodies.iter().position(|known| known == body);
        n.map_or(tint(GREY, 0.6), |n| COLORS[n % COLORS.len()])
    }

    /// Number of coils of a spring, by its mean length.
    fn coils(&self, n: usize) -> usize {
        let length = |frame: &Frame| {
            let [[ax, ay], [bx, by]] = [frame.parts[n].points[0], frame.parts[n].points[1]];
            (bx - ax).hypot(by - ay)
        };
        let mean = self.frames.iter().map(length).sum::<f64>() / self.frames.len() as f64;
        ((self.scale() * mean / COIL) as usize).clamp(4, 20)
    }

    /// Ends of a declared wall: across the drawing if it is seen from its side, else near the point that it keeps off.
    fn surface(&self, wall: &Part) -> Option<[Place; 2]> {
        let [[ax, ay], [bx, by]] = [wall.points[0], wall.points[1]];
        let (nx, ny) = (bx - ax, by - ay);
        let seen = nx.hypot(ny);
        let at = |length: f64| {
            let by = length / (self.scale() * seen);
            self.place([ax + by * ny, ay - by * nx])
        };
        match seen {
            0.999.. => glyph::clipped([at(-LONGEST), at(LONGEST)], self.extent()),
            0.05.. => Some([at(-PATCH), at(PATCH)]),
            _ => None,
        }
    }

    /// Ends of the part of a guide along which its body moves.
    fn rail(&self, guide: &Part) -> Option<[[f64; 2]; 2]> {
        let [[ax, ay], [bx, by]] = [guide.points[0], guide.points[1]];
        let (dx, dy) = (bx - ax, by - ay);
        let square = dx * dx + dy * dy;
        let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
        for part in self.frames.iter().flat_map(|frame| &frame.parts) {
            if part.body == guide.name && is_solid(part.kind) {
                for point in &part.points {
                    let along = ((point[0] - ax) * dx + (point[1] - ay) * dy) / square;
                    (first, last) = (first.min(along), last.max(along));
                }
            }
        }
        let at = |along: f64| [ax + along * dx, ay + along * dy];
        // an axis along the direction of view is a point
        (square > 1e-6 && first < last).then(|| [at(first), at(last)])
    }
}

/// Name of the body of shapes at rest.
const GROUND: &str = "ground";

/// Bodies on the trails of their points.
#[derive(Clone, Debug)]
pub(crate) struct Still<'a> {
    motion: &'a Motion,
    /// Number of frames of the trails.
    so_far: usize,
    /// In chronological order; all but the last are shadows.
    bodies: Vec<Frame>,
    /// Text about the time.
    time: String,
}

/// A page on which a picture is drawn.
type Page<B> = DrawingArea<B, Shift>;
type Drawn = Result<(), Box<dyn Error>>;

impl<'a> Still<'a> {
    /// Picture of a whole motion.
    pub(crate) fn whole(motion: &'a Motion, bodies: Vec<Frame>) -> Self {
        let times: Vec<String> = bodies.iter().map(|frame| digits(frame.t)).collect();
        let time = match &times[..] {
            [first, second, _, .., last] => format!("t = {first}, {second}, .., {last} s"),
            few => format!("t = {} s", few.join(", ")),
        };
        Self {
            motion,
            so_far: motion.frames.len(),
            bodies,
            time,
        }
    }

    /// Picture at a time of an animation.
    pub(crate) fn at(motion: &'a Motion, frame: Frame) -> Self {
        Self {
            motion,
            so_far: motion.frames.partition_point(|place| place.t <= frame.t),
            time: format!("t = {:.2} s", frame.t),
            bodies: vec![frame],
        }
    }

    fn draw_walls<B: DrawingBackend>(&self, page: &Page<B>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        for &[from, to] in &self.motion.walls {
            draw_surface(page, self.motion.place(from), self.motion.place(to))?;
        }
        if self.motion.walls.is_empty() {
            let last = self.bodies.last().map_or(&[][..], |frame| &frame.parts);
            let declared = last.iter().filter(|part| part.kind == ShapeKind::Wall);
            for [from, to] in declared.filter_map(|wall| self.motion.surface(wall)) {
                draw_surface(page, from, to)?;
            }
        }
        let parts = self.motion.frames.first().map_or(&[][..], |frame| &frame.parts);
        for guide in parts.iter().filter(|part| part.kind == ShapeKind::Guide) {
            if let Some(ends) = self.motion.rail(guide) {
                draw_line(page, self.motion.places(&ends), 1.5, tint(GREY, 0.5))?;
            }
        }
        Ok(())
    }

    fn draw_trails<B: DrawingBackend>(&self, page: &Page<B>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let frames = &self.motion.frames[..self.so_far];
        let parts = frames.first().map_or(&[][..], |frame| &frame.parts);
        let is_traced = |part: &Part| part.kind == ShapeKind::Point && !self.motion.untraced.contains(&part.name);
        for (n, point) in parts.iter().enumerate().filter(|(_, part)| is_traced(part)) {
            let trail: Vec<_> = frames
                .iter()
                .map(|frame| self.motion.place(frame.parts[n].points[0]))
                .collect();
            let color = tint(self.motion.color(&point.body), TRAIL);
            for piece in glyph::pieces(&trail) {
                page.draw(&PathElement::new(piece, color.stroke_width(width(1.2))))?;
            }
        }
        Ok(())
    }

    /// Draws the shapes of a frame in the order in which they cover each other. Shadows have no joints and points.
    fn draw_frame<B: DrawingBackend>(&self, page: &Page<B>, frame: &Frame, strength: f64) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let mut parts: Vec<_> = frame.parts.iter().enumerate().collect();
        parts.sort_by_key(|(_, part)| layer(part.kind));
        let is_shadow = strength < 1.0;
        for (n, part) in parts {
            let moves = is_solid(part.kind) && part.body != GROUND;
            if is_link(part.kind) {
                self.draw_link(page, frame, n, strength)?;
            } else if moves || !is_shadow {
                self.draw_part(page, part, strength)?;
            }
        }
        // above the rods that cover the supports
        let supports = frame
            .parts
            .iter()
            .filter(|part| !is_shadow && part.kind == ShapeKind::Support);
        for support in supports {
            draw_pivot(page, self.motion.place(support.points[0]))?;
        }
        Ok(())
    }

    /// Draws a spring or a damper, in a shadow as a line. The two stand side by side if they connect the same points.
    fn draw_link<B: DrawingBackend>(&self, page: &Page<B>, frame: &Frame, n: usize, strength: f64) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let part = &frame.parts[n];
        let (grey, ends) = (tint(GREY, strength), self.motion.places(&part.points));
        if strength < 1.0 {
            return draw_line(page, ends, 1.0, grey);
        }
        let is_beside = |other: &Part| is_link(other.kind) && other.kind != part.kind && other.points == part.points;
        let side = match frame.parts.iter().any(is_beside) {
            false => 0.0,
            true if part.kind == ShapeKind::Spring => 8.0,
            true => -8.0,
        };
        let [from, to] = glyph::beside(ends[0], ends[1], side);
        let lines = match part.kind {
            ShapeKind::Spring => vec![glyph::spring(from, to, self.motion.coils(n))],
            _ => glyph::damper(from, to).to_vec(),
        };
        for line in lines.into_iter().chain([vec![ends[0], from], vec![ends[1], to]]) {
            draw_line(page, line, 1.5, grey)?;
        }
        Ok(())
    }

    fn draw_part<B: DrawingBackend>(&self, page: &Page<B>, part: &Part, strength: f64) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let color = tint(self.motion.color(&part.body), strength);
        let places = self.motion.places(&part.points);
        let scale = self.motion.scale();
        match part.kind {
            ShapeKind::Mass => {
                let mass = Circle::new(places[0], px(6.0), color.filled());
                draw_line(page, places, 2.0, color)?;
                page.draw(&mass)?;
            }
            ShapeKind::Rod => draw_line(page, places, 5.0, color)?,
            ShapeKind::Plate => page.draw(&Polygon::new(places, color.filled()))?,
            ShapeKind::Cuboid => page.draw(&Polygon::new(glyph::hull(places), color.filled()))?,
            ShapeKind::Cylinder => draw_line(page, places, (2.0 * scale * part.radius).max(3.0), color)?,
            ShapeKind::Disk | ShapeKind::Sphere => {
                let radius = px((scale * part.radius).max(3.0));
                page.draw(&Circle::new(places[0], radius, color.filled()))?;
                if part.kind == ShapeKind::Disk {
                    draw_line(page, places, 1.5, WHITE)?;
                }
            }
            // the ends of springs that are added stand for other things
            ShapeKind::Anchor | ShapeKind::Point if self.motion.untraced.contains(&part.name) => {}
            ShapeKind::Support | ShapeKind::Anchor => {
                let (triangle, [from, to]) = glyph::support(places[0]);
                page.draw(&Polygon::new(triangle.clone(), WHITE.filled()))?;
                draw_line(page, triangle, 1.2, GREY)?;
                draw_surface(page, from, to)?;
            }
            ShapeKind::Pivot => draw_pivot(page, places[0])?,
            ShapeKind::Point => page.draw(&Circle::new(places[0], px(2.0), GREY.filled()))?,
            _ => {}
        }
        Ok(())
    }

    /// Draws a scale on the left and the time on the right.
    fn draw_caption<B: DrawingBackend>(&self, page: &Page<B>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        let [wide, high] = self.motion.extent();
        let length = round_length(0.25 * wide / self.motion.scale());
        let (left, y) = (12.0, high + 0.4 * CAPTION);
        let right = left + self.motion.scale() * length;
        for line in [
            [(left, y), (right, y)],
            [(left, y - 3.0), (left, y + 3.0)],
            [(right, y - 3.0), (right, y + 3.0)],
        ] {
            draw_line(page, line.map(|(x, y)| (px(x), px(y))).to_vec(), 1.2, INK)?;
        }
        let style = text(11.0, INK).pos(Pos::new(HPos::Left, VPos::Center));
        page.draw_text(&unit_of(length), &style, (px(right + 6.0), px(y)))?;
        let style = text(11.0, INK).pos(Pos::new(HPos::Right, VPos::Center));
        page.draw_text(&self.time, &style, (px(wide - 12.0), px(y)))?;
        Ok(())
    }
}

impl Picture for Still<'_> {
    fn size(&self) -> (u32, u32) {
        let [width, height] = self.motion.extent();
        (width as u32, (height + CAPTION) as u32)
    }

    fn draw<B: DrawingBackend>(&self, page: &Page<B>) -> Drawn
    where
        B::ErrorType: 'static,
    {
        page.fill(&WHITE)?;
        self.draw_walls(page)?;
        let (last, shadows) = self.bodies.split_last().ok_or("a picture without bodies")?;
        for (n, frame) in shadows.iter().enumerate() {
            let part = n as f64 / shadows.len().max(2).saturating_sub(1) as f64;
            self.draw_frame(page, frame, SHADOWS[0] + part * (SHADOWS[1] - SHADOWS[0]))?;
        }
        self.draw_trails(page)?;
        self.draw_frame(page, last, 1.0)?;
        self.draw_caption(page)?;
        page.present()?;
        Ok(())
    }
}

fn draw_line<B: DrawingBackend>(page: &Page<B>, line: Vec<Place>, thick: f64, color: RGBColor) -> Drawn
where
    B::ErrorType: 'static,
{
    page.draw(&PathElement::new(line, color.stroke_width(width(thick))))?;
    Ok(())
}

/// Draws a surface at rest, with strokes on the right-hand side.
fn draw_surface<B: DrawingBackend>(page: &Page<B>, from: Place, to: Place) -> Drawn
where
    B::ErrorType: 'static,
{
    for stroke in glyph::hatching(from, to) {
        draw_line(page, stroke.to_vec(), 1.0, tint(GREY, 0.7))?;
    }
    draw_line(page, vec![from, to], 1.5, GREY)
}

fn draw_pivot<B: DrawingBackend>(page: &Page<B>, place: Place) -> Drawn
where
    B::ErrorType: 'static,
{
    page.draw(&Circle::new(place, px(3.5), GREY.filled()))?;
    page.draw(&Circle::new(place, px(1.5), WHITE.filled()))?;
    Ok(())
}

/// True if a shape is the solid of a body.
fn is_solid(kind: ShapeKind) -> bool {
    use ShapeKind::{Cuboid, Cylinder, Disk, Mass, Plate, Rod, Sphere};
    matches!(kind, Mass | Rod | Disk | Plate | Cuboid | Cylinder | Sphere)
}

/// True for a spring or a damper.
fn is_link(kind: ShapeKind) -> bool {
    matches!(kind, ShapeKind::Spring | ShapeKind::Damper)
}

/// Order in which shapes cover each other: supports cover surfaces, and are covered by rods.
fn layer(kind: ShapeKind) -> usize {
    match kind {
        ShapeKind::Support | ShapeKind::Anchor => 1,
        ShapeKind::Rod => 2,
        ShapeKind::Mass => 3,
        ShapeKind::Spring | ShapeKind::Damper => 4,
        ShapeKind::Pivot | ShapeKind::Point => 5,
        _ => 0,
    }
}

/// Blends a colour with white; `part` is its share.
fn tint(RGBColor(red, green, blue): RGBColor, part: f64) -> RGBColor {
    let [red, green, blue] = [red, green, blue].map(|of| (255.0 - part * (255.0 - f64::from(of))).round() as u8);
    RGBColor(red, green, blue)
}

/// Largest of 1, 2 and 5 times a power of ten that is not above a length.
fn round_length(most: f64) -> f64 {
    let power = 10.0_f64.powf(most.log10().floor());
    let found = [5.0, 2.0].into_iter().find(|n| n * power <= most);
    found.unwrap_or(1.0) * power
}

/// A length with its unit.
fn unit_of(length: f64) -> String {
    match length {
        _ if length >= 1000.0 => format!("{} km", digits(1e-3 * length)),
        _ if length >= 0.1 => format!("{} m", digits(length)),
        _ if length >= 0.01 => format!("{} cm", digits(100.0 * length)),
        _ => format!("{} mm", digits(1000.0 * length)),
    }
}

/// Up to three significant digits of a number, and all of its integer part.
fn digits(value: f64) -> String {
    let decimals = (2.0 - value.abs().max(f64::MIN_POSITIVE).log10().floor()).clamp(0.0, 9.0) as usize;
    let text = format!("{value:.decimals$}");
    if decimals == 0 {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

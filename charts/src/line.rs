//! Line styles and their legends.

use std::error::Error;
use std::f64::consts::TAU;

use plotters::coord::{CoordTranslate, Shift};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::page::{INK, px, text, width, write_line};

/// Style of a curve.
#[derive(Clone, Copy)]
pub struct Line {
    pub color: RGBColor,
    /// In pixels.
    pub width: f64,
    pub stroke: Stroke,
    /// Mark at each point.
    pub marker: Option<Marker>,
}

/// Shape of a mark.
#[derive(Clone, Copy)]
pub enum Marker {
    Circle,
    Square,
    /// A triangle that points up.
    Up,
    /// A triangle that points down.
    Down,
    Diamond,
    Cross,
}

/// Drawn parts of a curve.
#[derive(Clone, Copy)]
pub enum Stroke {
    Solid,
    Dashed,
    /// Only the points.
    Dots,
    /// The enclosed area.
    Area,
}

impl Line {
    pub const fn solid(color: RGBColor) -> Self {
        Self {
            color,
            width: 3.2,
            stroke: Stroke::Solid,
            marker: None,
        }
    }

    pub const fn dashed(color: RGBColor) -> Self {
        Self {
            stroke: Stroke::Dashed,
            ..Self::solid(color)
        }
    }

    pub const fn area(color: RGBColor) -> Self {
        Self {
            stroke: Stroke::Area,
            ..Self::solid(color)
        }
    }

    /// Only the points.
    pub const fn dots(color: RGBColor) -> Self {
        Self {
            stroke: Stroke::Dots,
            ..Self::solid(color)
        }
    }

    /// The line with a mark at each point.
    pub const fn marked(self, marker: Marker) -> Self {
        Self {
            marker: Some(marker),
            ..self
        }
    }

    /// Draws the marks at the points of a curve.
    pub(crate) fn draw_marks<B, C>(self, area: &DrawingArea<B, C>, points: &[C::From]) -> Result<(), Box<dyn Error>>
    where
        B: DrawingBackend,
        B::ErrorType: 'static,
        C: CoordTranslate,
        C::From: Clone + 'static,
    {
        let Some(marker) = self.marker else {
            return Ok(());
        };
        let corners: Vec<(i32, i32)> = marker
            .corners()
            .into_iter()
            .map(|(x, y)| (px(2.0 * self.width * x), px(2.0 * self.width * y)))
            .collect();
        for point in points {
            area.draw(&(EmptyElement::at(point.clone()) + Polygon::new(corners.clone(), self.color.filled())))?;
        }
        Ok(())
    }

    /// Draws the symbol in a legend: a large dot for dots, a rectangle for an area.
    fn draw_key<B: DrawingBackend>(
        self,
        page: &DrawingArea<B, Shift>,
        [left, right]: [i32; 2],
        y: i32,
    ) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let [up, down] = [y - px(9.0), y + px(9.0)];
        match self.stroke {
            Stroke::Solid | Stroke::Dashed => {
                self.draw(page, vec![(left, y), (right, y)])?;
                self.draw_marks(page, &[((left + right) / 2, y)])
            }
            Stroke::Dots => Self { width: 9.0, ..self }.draw(page, vec![(right - px(9.0), y)]),
            Stroke::Area => self.draw(page, vec![(left, up), (right, up), (right, down), (left, down)]),
        }
    }

    /// The line in a lighter colour, three fifths of the way to white.
    pub fn lighter(self) -> Self {
        let RGBColor(r, g, b) = self.color;
        let [r, g, b] = [r, g, b].map(|part| part + (255 - part) / 5 * 3);
        Self {
            color: RGBColor(r, g, b),
            ..self
        }
    }

    pub(crate) fn draw<B, C>(self, area: &DrawingArea<B, C>, points: Vec<C::From>) -> Result<(), Box<dyn Error>>
    where
        B: DrawingBackend,
        B::ErrorType: 'static,
        C: CoordTranslate,
        C::From: Clone + 'static,
    {
        let style = self.color.stroke_width(width(self.width));
        match self.stroke {
            Stroke::Solid => area.draw(&PathElement::new(points, style))?,
            Stroke::Dashed => area.draw(&DashedPathElement::new(points, px(12.0), px(7.0), style))?,
            Stroke::Dots => {
                let dot = |point| area.draw(&Circle::new(point, px(0.5 * self.width), style.filled()));
                points.into_iter().try_for_each(dot)?;
            }
            Stroke::Area => area.draw(&Polygon::new(points, style.filled()))?,
        }
        Ok(())
    }
}

impl Marker {
    /// Corners of the mark about its point; all marks have about the same area as a circle of radius 0.7.
    pub(crate) fn corners(self) -> Vec<(f64, f64)> {
        let regular = |count: u32, radius: f64, turn: f64| {
            let corner = |n: u32| {
                let (sin, cos) = (TAU * (f64::from(n) / f64::from(count) + turn)).sin_cos();
                (radius * cos, radius * sin)
            };
            (0..count).map(corner).collect()
        };
        match self {
            Self::Circle => regular(24, 0.7, 0.0),
            Self::Square => regular(4, 0.88, 0.125),
            Self::Diamond => regular(4, 0.95, 0.0),
            // down is positive
            Self::Up => regular(3, 1.05, -0.25),
            Self::Down => regular(3, 1.05, 0.25),
            Self::Cross => {
                let arms = (0..4).flat_map(|n| [-0.06, 0.06, 0.125].map(|turn| (0.25 * f64::from(n) + turn, turn)));
                let corner = |(turn, part): (f64, f64)| {
                    let radius = if part == 0.125 { 0.42 } else { 1.05 };
                    let (sin, cos) = (TAU * (turn + 0.125)).sin_cos();
                    (radius * cos, radius * sin)
                };
                arms.map(corner).collect()
            }
        }
    }
}

/// Draws a legend from `(x, y)` to the right, in pixels of the drawing.
pub(crate) fn draw_legend<B: DrawingBackend>(
    page: &DrawingArea<B, Shift>,
    legend: &[(Line, String)],
    (mut x, y): (i32, i32),
) -> Result<(), Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    let style = text(24.0, INK).pos(Pos::new(HPos::Left, VPos::Center));
    for (line, name) in legend {
        let is_dots = matches!(line.stroke, Stroke::Dots);
        let end = x + px(if is_dots { 18.0 } else { 74.0 });
        line.draw_key(page, [x, end], y)?;
        let start = end + px(14.0);
        write_line(page, name, &style, (start, y))?;
        let (width, _) = page.estimate_text_size(name, &style)?;
        x = start + i32::try_from(width)? + px(56.0);
    }
    Ok(())
}

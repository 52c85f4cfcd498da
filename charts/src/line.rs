//! Line styles and their legends.

use std::error::Error;

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
            Stroke::Solid | Stroke::Dashed => self.draw(page, vec![(left, y), (right, y)]),
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
        let end = x + px(74.0);
        line.draw_key(page, [x, end], y)?;
        let start = end + px(14.0);
        write_line(page, name, &style, (start, y))?;
        let (width, _) = page.estimate_text_size(name, &style)?;
        x = start + i32::try_from(width)? + px(56.0);
    }
    Ok(())
}

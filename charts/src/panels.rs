//! Small panels with logarithmic axes, in rows and columns, with powers of x as guides for the slope.

use std::error::Error;

use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::label::{Path, Point, draw_labels};
use crate::page::{GREY, GRID, INK, MARGIN, Picture, bold, px, text, width, write_line};
use crate::scale::{Scale, label};

/// Panels that all share the x axis; the panels of a column share the y axis.
pub struct Panels {
    pub title: String,
    pub subtitle: String,
    /// Rows of a colour, width and name of a line.
    pub legend: Vec<Vec<(RGBColor, f64, String)>>,
    pub x: String,
    /// Marked values; the first and the last are the ends of the axis.
    pub x_ticks: Vec<f64>,
    /// Width and height of a panel, in pixels of the picture.
    pub panel: (f64, f64),
    pub columns: Vec<Column>,
    /// Caption, and the curves of the panel in each column.
    pub rows: Vec<(String, Vec<Vec<Curve>>)>,
}

/// Column of panels.
pub struct Column {
    pub label: String,
}

pub struct Curve {
    pub color: RGBColor,
    pub width: f64,
    pub points: Vec<(f64, f64)>,
    /// Exponents of the powers drawn through the first point.
    pub guides: Vec<i32>,
    /// Text beside the first point; may be empty.
    pub name: String,
}

// Lengths in pixels of the picture.
const LABELS: f64 = 72.0;
const RIGHT: f64 = 34.0;
const HEAD: f64 = 162.0;
const LEGEND: f64 = 34.0;
const CAPTION: f64 = 54.0;
const FOOTER: f64 = 96.0;
const BETWEEN: f64 = 48.0;

/// Panel on the page with its axes.
struct Frame {
    left: f64,
    top: f64,
    size: (f64, f64),
    x: Scale,
    y: Scale,
}

impl Frame {
    /// Place in the picture.
    fn at(&self, (x, y): (f64, f64)) -> Point {
        (
            self.left + self.size.0 * self.x.part(x),
            self.top + self.size.1 * (1.0 - self.y.part(y)),
        )
    }

    fn place(&self, point: (f64, f64)) -> (i32, i32) {
        let (x, y) = self.at(point);
        (px(x), px(y))
    }
}

impl Panels {
    fn frame(&self, row: usize, column: usize) -> Frame {
        let ends = (self.x_ticks.first(), self.x_ticks.last());
        let curves = self.rows.iter().flat_map(|(_, panels)| &panels[column]);
        Frame {
            left: MARGIN + LABELS + column as f64 * (self.panel.0 + LABELS + RIGHT),
            top: self.head() + CAPTION + row as f64 * (self.panel.1 + CAPTION + BETWEEN),
            size: self.panel,
            x: Scale::Logarithmic(ends.0.copied().unwrap_or(1.0), ends.1.copied().unwrap_or(10.0)),
            y: Scale::around(curves.flat_map(|curve| curve.points.iter().map(|point| point.1))),
        }
    }

    /// Height of the space above the panels.
    fn head(&self) -> f64 {
        HEAD + LEGEND * self.legend.len() as f64
    }

    fn draw_axes<B: DrawingBackend>(&self, frame: &Frame, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let line = |from, to, line: f64| {
            page.draw(&PathElement::new(
                vec![frame.place(from), frame.place(to)],
                GRID.stroke_width(width(line)),
            ))
        };
        let ((left, right), (bottom, top)) = (frame.x.ends(), frame.y.ends());
        let below = text(19.0, INK).pos(Pos::new(HPos::Center, VPos::Top));
        for &x in &self.x_ticks {
            line((x, bottom), (x, top), 1.0)?;
            let (at, end) = frame.place((x, bottom));
            page.draw_text(&label(x), &below, (at, end + px(8.0)))?;
        }
        let beside = text(19.0, INK).pos(Pos::new(HPos::Right, VPos::Center));
        for (y, _) in frame.y.ticks().into_iter().filter(|&(_, strong)| strong) {
            line((left, y), (right, y), 1.5)?;
            let (end, at) = frame.place((left, y));
            page.draw_text(&label(y), &beside, (end - px(9.0), at))?;
        }
        Ok(())
    }

    fn draw_curve<B: DrawingBackend>(
        curve: &Curve,
        frame: &Frame,
        page: &DrawingArea<B, Shift>,
    ) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let Some(&(x, y)) = curve.points.first() else {
            return Ok(());
        };
        let ((_, right), (_, highest)) = (frame.x.ends(), frame.y.ends());
        for &power in &curve.guides {
            // Clip the line at the edges of the panel.
            let exponent = f64::from(power);
            let end = right.min(x * (highest / y).powf(1.0 / exponent));
            let top = y * (end / x).powf(exponent);
            let ends = [(x, y), (end, top)].map(|point| frame.place(point));
            page.draw(&DashedPathElement::new(
                ends,
                px(6.0),
                px(5.0),
                GREY.stroke_width(width(1.0)),
            ))?;
            let name = ["n", "n²", "n³"].get(power as usize - 1).copied().unwrap_or_default();
            // Beside the end of the line, or below it if the line is cut off at the top.
            let down = if top < 0.999 * highest { 0.0 } else { 9.0 };
            let beside = text(18.0, GREY).pos(Pos::new(HPos::Left, VPos::Center));
            page.draw_text(name, &beside, (ends[1].0 + px(6.0), ends[1].1 + px(down)))?;
        }
        let points: Vec<(i32, i32)> = curve.points.iter().map(|&point| frame.place(point)).collect();
        if curve.width > 2.0 {
            for &point in &points {
                page.draw(&Circle::new(point, px(1.2 * curve.width), curve.color.filled()))?;
            }
        }
        page.draw(&PathElement::new(points, curve.color.stroke_width(width(curve.width))))?;
        Ok(())
    }

    fn draw_names<B: DrawingBackend>(
        curves: &[Curve],
        frame: &Frame,
        page: &DrawingArea<B, Shift>,
    ) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let path = |curve: &Curve| curve.points.iter().rev().map(|&point| frame.at(point)).collect();
        let paths: Vec<_> = curves
            .iter()
            .map(|curve| Path {
                points: path(curve),
                color: curve.color,
                name: Some(curve.name.as_str()).filter(|name| !name.is_empty()),
            })
            .collect();
        let end = (frame.left + frame.size.0, frame.top + frame.size.1);
        draw_labels(page, [(frame.left, frame.top), end], &paths, 17.0)
    }

    fn draw_legend<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let style = text(21.0, INK).pos(Pos::new(HPos::Left, VPos::Center));
        for (row, keys) in self.legend.iter().enumerate() {
            let (mut x, y) = (px(MARGIN), px(MARGIN + 100.0 + LEGEND * row as f64));
            for (color, line, name) in keys {
                let end = x + px(54.0);
                page.draw(&PathElement::new(
                    vec![(x, y), (end, y)],
                    color.stroke_width(width(*line)),
                ))?;
                page.draw_text(name, &style, (end + px(12.0), y))?;
                let (wide, _) = page.estimate_text_size(name, &style)?;
                x = end + i32::try_from(wide)? + px(52.0);
            }
        }
        Ok(())
    }
}

impl Picture for Panels {
    fn size(&self) -> (u32, u32) {
        let wide = 2.0 * MARGIN + self.columns.len() as f64 * (self.panel.0 + LABELS + RIGHT);
        let high = self.head() + self.rows.len() as f64 * (self.panel.1 + CAPTION + BETWEEN) + FOOTER - BETWEEN;
        (wide as u32, high as u32)
    }

    fn draw<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        page.fill(&WHITE)?;
        write_line(page, &self.title, &bold(32.0), (px(MARGIN), px(MARGIN)))?;
        write_line(page, &self.subtitle, &text(22.0, GREY), (px(MARGIN), px(MARGIN + 46.0)))?;
        self.draw_legend(page)?;
        for (row, (caption, panels)) in self.rows.iter().enumerate() {
            for (column, curves) in panels.iter().enumerate().filter(|(_, curves)| !curves.is_empty()) {
                let frame = self.frame(row, column);
                self.draw_axes(&frame, page)?;
                for curve in curves {
                    Self::draw_curve(curve, &frame, page)?;
                }
                Self::draw_names(curves, &frame, page)?;
                let title = format!("{caption}: {}", self.columns[column].label);
                let above = bold(20.0).pos(Pos::new(HPos::Left, VPos::Center));
                page.draw_text(&title, &above, (px(frame.left), px(frame.top - 32.0)))?;
                let below = self.rows.get(row + 1).map(|(_, panels)| &panels[column]);
                if below.is_none_or(Vec::is_empty) {
                    let below = text(20.0, INK).pos(Pos::new(HPos::Center, VPos::Center));
                    let at = (px(frame.left + 0.5 * frame.size.0), px(frame.top + frame.size.1 + 52.0));
                    page.draw_text(&self.x, &below, at)?;
                }
            }
        }
        page.present()?;
        Ok(())
    }
}

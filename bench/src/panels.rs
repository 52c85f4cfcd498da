//! Small panels with logarithmic axes, in rows and columns, with the powers of x to compare a slope with.

use std::error::Error;

use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::page::{GREY, GRID, INK, MARGIN, Picture, bold, px, text, width};

/// Panels of which all share the axis of x, and those of a column that of y.
pub(crate) struct Panels {
    pub title: String,
    pub subtitle: String,
    /// Colour, width and name of a line.
    pub legend: Vec<(RGBColor, f64, String)>,
    pub x: String,
    /// The first and the last are the ends of the axis.
    pub x_ticks: Vec<f64>,
    pub columns: Vec<Column>,
    /// A caption, and the curves of the panel in each column.
    pub rows: Vec<(String, Vec<Vec<Curve>>)>,
}

/// Panels below each other.
pub(crate) struct Column {
    pub label: String,
}

pub(crate) struct Curve {
    pub color: RGBColor,
    pub width: f64,
    pub points: Vec<(f64, f64)>,
    /// Exponents of the powers that are drawn through the first point.
    pub guides: Vec<i32>,
}

// Lengths in pixels of the picture.
const PANEL: (f64, f64) = (292.0, 300.0);
const LABELS: f64 = 72.0;
const RIGHT: f64 = 34.0;
const HEAD: f64 = 196.0;
const CAPTION: f64 = 54.0;
const FOOTER: f64 = 96.0;
const BETWEEN: f64 = 48.0;

/// A panel on the page, and its ranges.
struct Frame {
    left: f64,
    top: f64,
    x: (f64, f64),
    y: (f64, f64),
}

impl Frame {
    fn place(&self, (x, y): (f64, f64)) -> (i32, i32) {
        let part = |value: f64, (low, high): (f64, f64)| (value / low).ln() / (high / low).ln();
        (
            px(self.left + PANEL.0 * part(x, self.x)),
            px(self.top + PANEL.1 * (1.0 - part(y, self.y))),
        )
    }
}

impl Panels {
    /// Powers of ten that hold a column.
    fn range(&self, column: usize) -> (f64, f64) {
        let values = || {
            self.rows
                .iter()
                .flat_map(|(_, panels)| &panels[column])
                .flat_map(|curve| curve.points.iter().map(|point| point.1))
        };
        let low = values().fold(f64::INFINITY, f64::min).log10().floor();
        let high = values().fold(0.0, f64::max).log10().ceil();
        (10.0_f64.powf(low), 10.0_f64.powf(high.max(low + 1.0)))
    }

    fn frame(&self, row: usize, column: usize) -> Frame {
        let ends = (self.x_ticks.first(), self.x_ticks.last());
        Frame {
            left: MARGIN + LABELS + column as f64 * (PANEL.0 + LABELS + RIGHT),
            top: HEAD + CAPTION + row as f64 * (PANEL.1 + CAPTION + BETWEEN),
            x: (ends.0.copied().unwrap_or(1.0), ends.1.copied().unwrap_or(10.0)),
            y: self.range(column),
        }
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
        let below = text(19.0, INK).pos(Pos::new(HPos::Center, VPos::Top));
        for &x in &self.x_ticks {
            line((x, frame.y.0), (x, frame.y.1), 1.0)?;
            let (at, bottom) = frame.place((x, frame.y.0));
            page.draw_text(&x.to_string(), &below, (at, bottom + px(8.0)))?;
        }
        let beside = text(19.0, INK).pos(Pos::new(HPos::Right, VPos::Center));
        let (low, high) = (frame.y.0.log10().round() as i32, frame.y.1.log10().round() as i32);
        for power in low..=high {
            let y = 10.0_f64.powi(power);
            line((frame.x.0, y), (frame.x.1, y), 1.5)?;
            let (left, at) = frame.place((frame.x.0, y));
            page.draw_text(&power_of_ten(power), &beside, (left - px(9.0), at))?;
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
        for &power in &curve.guides {
            // As far as the panel reaches.
            let exponent = f64::from(power);
            let end = frame.x.1.min(x * (frame.y.1 / y).powf(1.0 / exponent));
            let top = y * (end / x).powf(exponent);
            let ends = [(x, y), (end, top)].map(|point| frame.place(point));
            page.draw(&DashedPathElement::new(
                ends,
                px(6.0),
                px(5.0),
                GREY.stroke_width(width(1.0)),
            ))?;
            let name = ["n", "n²", "n³"].get(power as usize - 1).copied().unwrap_or_default();
            // Beside its end; where that is cut off at the top, below it.
            let down = if top < 0.999 * frame.y.1 { 0.0 } else { 9.0 };
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

    fn draw_legend<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let style = text(21.0, INK).pos(Pos::new(HPos::Left, VPos::Center));
        let (mut x, y) = (px(MARGIN), px(MARGIN + 100.0));
        for (color, line, name) in &self.legend {
            let end = x + px(54.0);
            page.draw(&PathElement::new(
                vec![(x, y), (end, y)],
                color.stroke_width(width(*line)),
            ))?;
            page.draw_text(name, &style, (end + px(12.0), y))?;
            let (wide, _) = page.estimate_text_size(name, &style)?;
            x = end + i32::try_from(wide)? + px(52.0);
        }
        Ok(())
    }
}

/// In digits as far as they are read at sight.
fn power_of_ten(power: i32) -> String {
    if power < 5 {
        return 10.0_f64.powi(power).to_string();
    }
    let digits = ["⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"];
    format!("10{}", digits.get(power as usize).copied().unwrap_or("…"))
}

impl Picture for Panels {
    fn size(&self) -> (u32, u32) {
        let wide = 2.0 * MARGIN + self.columns.len() as f64 * (PANEL.0 + LABELS + RIGHT);
        let high = HEAD + self.rows.len() as f64 * (PANEL.1 + CAPTION + BETWEEN) + FOOTER - BETWEEN;
        (wide as u32, high as u32)
    }

    fn draw<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        page.fill(&WHITE)?;
        page.draw_text(&self.title, &bold(32.0), (px(MARGIN), px(MARGIN)))?;
        page.draw_text(&self.subtitle, &text(22.0, GREY), (px(MARGIN), px(MARGIN + 46.0)))?;
        self.draw_legend(page)?;
        for (row, (caption, panels)) in self.rows.iter().enumerate() {
            for (column, curves) in panels.iter().enumerate() {
                let frame = self.frame(row, column);
                self.draw_axes(&frame, page)?;
                for curve in curves {
                    Self::draw_curve(curve, &frame, page)?;
                }
                let title = format!("{caption}: {}", self.columns[column].label);
                let above = bold(20.0).pos(Pos::new(HPos::Left, VPos::Center));
                page.draw_text(&title, &above, (px(frame.left), px(frame.top - 32.0)))?;
                if row + 1 == self.rows.len() {
                    let below = text(20.0, INK).pos(Pos::new(HPos::Center, VPos::Center));
                    let at = (px(frame.left + 0.5 * PANEL.0), px(frame.top + PANEL.1 + 52.0));
                    page.draw_text(&self.x, &below, at)?;
                }
            }
        }
        page.present()?;
        Ok(())
    }
}

//! Charts in one style for all examples: panels in rows and columns.

use std::error::Error;
use std::ops::Range;

use plotters::coord::{CoordTranslate, Shift};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::label::draw_labels;
use crate::page::{GREY, GRID, INK, MARGIN, Picture, bold, px, text, width};
use crate::scale::power_of_ten;

/// Panels that share the axes in each column, so that they can be compared at sight.
pub struct Figure {
    pub title: String,
    pub subtitle: String,
    /// In pixels.
    pub size: (u32, u32),
    pub legend: Vec<(Line, String)>,
    pub columns: Vec<Column>,
    pub rows: Vec<Row>,
}

/// The axes of the panels below each other.
pub struct Column {
    pub x: Axis,
    pub y: Axis,
}

/// Panels beside each other, below a caption.
pub struct Row {
    pub caption: String,
    /// The keys of the lines that only this row has.
    pub legend: Vec<(Line, String)>,
    /// The curves of the panel in each column.
    pub panels: Vec<Vec<Curve>>,
}

/// An axis.
#[derive(Clone)]
pub struct Axis {
    pub label: String,
    pub scale: Scale,
    pub range: Range<f64>,
    /// About how many ticks.
    pub ticks: usize,
}

/// What the numbers of an axis are.
#[derive(Clone, Copy, PartialEq)]
pub enum Scale {
    Linear,
    /// Logarithms to base ten.
    Decades,
    /// The same with the opposite sign: small values are to the right.
    Falling,
}

/// How a curve looks.
#[derive(Clone, Copy)]
pub struct Line {
    pub color: RGBColor,
    /// In pixels.
    pub width: f64,
    pub dashed: bool,
}

/// Points joined by a line; those outside of the axes are left out.
#[derive(Clone)]
pub struct Curve {
    pub line: Line,
    pub points: Vec<(f64, f64)>,
    /// What stands beside the last point; the points of such a curve have dots.
    pub label: Option<String>,
}

impl Picture for Figure {
    fn size(&self) -> (u32, u32) {
        self.size
    }

    fn draw<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        draw_head(page, (&self.title, &self.subtitle), &self.legend)?;
        let rows = page
            .margin(px(MARGIN + head(&self.legend)), px(FOOTER), px(MARGIN), px(MARGIN))
            .split_evenly((self.rows.len(), 1));
        for (row, area) in self.rows.iter().zip(rows) {
            self.draw_row(row, &area)?;
        }
        self.draw_x_labels(page)?;
        page.present()?;
        Ok(())
    }
}

impl Figure {
    fn draw_row<B: DrawingBackend>(&self, row: &Row, area: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let (head, body) = area.split_vertically(px(56.0));
        let style = bold(25.0).pos(Pos::new(HPos::Left, VPos::Center));
        head.draw_text(&row.caption, &style, (px(LABELS), px(32.0)))?;
        let (width, _) = head.estimate_text_size(&row.caption, &style)?;
        let start = px(LABELS + 48.0) + i32::try_from(width)?;
        draw_legend(&head, &row.legend, (start, px(32.0)))?;
        let panels = body.split_evenly((1, self.columns.len()));
        for ((curves, column), panel) in row.panels.iter().zip(&self.columns).zip(panels) {
            self.draw_panel(curves, column, &panel)?;
        }
        Ok(())
    }

    fn draw_panel<B: DrawingBackend>(
        &self,
        curves: &[Curve],
        Column { x, y }: &Column,
        area: &DrawingArea<B, Shift>,
    ) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let mut chart = ChartBuilder::on(area)
            .set_label_area_size(LabelAreaPosition::Left, px(LABELS))
            .set_label_area_size(LabelAreaPosition::Bottom, px(36.0))
            .margin_right(px(self.right()))
            .build_cartesian_2d(x.range.clone(), y.range.clone())?;
        chart
            .configure_mesh()
            .x_labels(x.ticks)
            .y_labels(y.ticks)
            .max_light_lines(0)
            .bold_line_style(GRID.stroke_width(width(1.5)))
            .axis_style(GREY.stroke_width(width(1.5)))
            .set_all_tick_mark_size(px(7.0))
            .label_style(text(22.0, INK))
            .axis_desc_style(text(23.0, INK))
            .x_label_formatter(&|value| x.tick(*value))
            .y_label_formatter(&|value| y.tick(*value))
            .y_desc(&y.label)
            .draw()?;
        let plot = chart.plotting_area();
        let mut curves = curves.to_vec();
        for Curve { line, points, label } in &mut curves {
            points.retain(|point| x.shows(point.0) && y.shows(point.1));
            if label.is_none() || line.dashed {
                line.draw(plot, points.clone())?;
            } else {
                // One by one: where a curve turns back, its corner would be a long spike.
                points.windows(2).try_for_each(|ends| line.draw(plot, ends.to_vec()))?;
            }
            for &point in points.iter().filter(|_| label.is_some()) {
                plot.draw(&Circle::new(point, px(1.4 * line.width), line.color.filled()))?;
            }
        }
        draw_labels(area, plot, &curves)
    }

    /// The space to the right of each panel.
    fn right(&self) -> f64 {
        let curves = self.rows.iter().flat_map(|row| row.panels.iter().flatten());
        curves.fold(
            RIGHT,
            |right, curve| if curve.label.is_some() { WITH_LABELS } else { right },
        )
    }

    /// The axis of x is named once, below each column of panels.
    fn draw_x_labels<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let style = text(23.0, INK).pos(Pos::new(HPos::Center, VPos::Center));
        let (width, height) = (f64::from(self.size.0), f64::from(self.size.1));
        let column = (width - 2.0 * MARGIN) / self.columns.len() as f64;
        for (n, Column { x, .. }) in self.columns.iter().enumerate() {
            let middle = MARGIN + n as f64 * column + 0.5 * (LABELS + column - self.right());
            page.draw_text(&x.label, &style, (px(middle), px(height - 0.62 * FOOTER)))?;
        }
        Ok(())
    }
}

/// The space that the head of a page takes.
pub(crate) fn head(legend: &[(Line, String)]) -> f64 {
    if legend.is_empty() { 80.0 } else { 138.0 }
}

/// The head of a white page: title, subtitle, and the keys of lines.
pub(crate) fn draw_head<B: DrawingBackend>(
    page: &DrawingArea<B, Shift>,
    (title, subtitle): (&str, &str),
    legend: &[(Line, String)],
) -> Result<(), Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    page.fill(&WHITE)?;
    page.draw_text(title, &bold(32.0), (px(MARGIN), px(MARGIN)))?;
    page.draw_text(subtitle, &text(23.0, GREY), (px(MARGIN), px(MARGIN + 46.0)))?;
    draw_legend(page, legend, (px(MARGIN), px(MARGIN + 112.0)))
}

/// The keys of lines, beside each other from `(x, y)` on, in pixels of the drawing.
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
        line.draw(page, vec![(x, y), (end, y)])?;
        let start = end + px(14.0);
        page.draw_text(name, &style, (start, y))?;
        let (width, _) = page.estimate_text_size(name, &style)?;
        x = start + i32::try_from(width)? + px(56.0);
    }
    Ok(())
}

impl Axis {
    pub(crate) fn shows(&self, value: f64) -> bool {
        self.range.start <= value && value <= self.range.end
    }

    /// What stands beside a tick: a number with a true minus sign, or a power of ten.
    pub(crate) fn tick(&self, value: f64) -> String {
        // The sum rounds off what is left of steps like 0.1, and turns -0 into 0.
        let value = (value * 1e9).round() / 1e9 + 0.0;
        let value = match self.scale {
            Scale::Linear => return value.to_string().replace('-', "\u{2212}"),
            Scale::Decades => value,
            Scale::Falling => 0.0 - value,
        };
        power_of_ten(value.round() as i32)
    }
}

impl Line {
    pub const fn solid(color: RGBColor) -> Self {
        Self {
            color,
            width: 3.2,
            dashed: false,
        }
    }

    pub const fn dashed(color: RGBColor) -> Self {
        Self {
            dashed: true,
            ..Self::solid(color)
        }
    }

    /// The same line, three fifths of the way to white.
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
        if self.dashed {
            area.draw(&DashedPathElement::new(points, px(12.0), px(7.0), style))?;
        } else {
            area.draw(&PathElement::new(points, style))?;
        }
        Ok(())
    }
}

/// Space around the parts of the page, in pixels of the picture.
const FOOTER: f64 = 62.0;
pub(crate) const LABELS: f64 = 96.0;
const RIGHT: f64 = 24.0;
const WITH_LABELS: f64 = 104.0;

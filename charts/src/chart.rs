//! Charts in one style for all examples: titled panels in rows and columns.

use std::error::Error;
use std::ops::Range;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

pub use crate::curve::Curve;
use crate::label::draw_labels;
use crate::line::draw_legend;
pub use crate::line::{Line, Stroke};
use crate::page::{GREY, GRID, INK, MARGIN, Picture, bold, px, text, width, write_line};
use crate::scale::power_of_ten;

/// Panels that share the axes of each column, for direct comparison.
pub struct Figure {
    pub title: String,
    pub subtitle: String,
    /// Width and height, in pixels.
    pub size: (u32, u32),
    pub legend: Vec<(Line, String)>,
    pub columns: Vec<Column>,
    pub rows: Vec<Row>,
}

/// Column of panels with common axes and a title.
pub struct Column {
    pub title: String,
    pub x: Axis,
    pub y: Axis,
}

/// Row of panels. The title of each panel is the caption of its row and the title of its column.
pub struct Row {
    pub caption: String,
    /// Legend of the lines that only this row has, above its panels.
    pub legend: Vec<(Line, String)>,
    /// Curves of the panel in each column.
    pub panels: Vec<Vec<Curve>>,
}

/// An axis.
#[derive(Clone)]
pub struct Axis {
    pub label: String,
    pub scale: Scale,
    pub range: Range<f64>,
    /// Approximate number of ticks.
    pub ticks: usize,
}

/// Meaning of the numbers on an axis.
#[derive(Clone, Copy, PartialEq)]
pub enum Scale {
    Linear,
    /// Logarithms to base ten.
    Decades,
    /// Negated logarithms to base ten: small values are to the right.
    Falling,
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
    /// Sets the height such that both axes of the first column have the same scale.
    #[must_use]
    pub fn with_equal_scales(mut self) -> Self {
        let length = |axis: &Axis| axis.range.end - axis.range.start;
        let panel = (self.column() - LABELS - self.right()) * length(&self.columns[0].y) / length(&self.columns[0].x);
        let rows: f64 = self.rows.iter().map(|row| row.head() + CAPTION + panel + TICKS).sum();
        self.size.1 = (MARGIN + head(&self.legend) + rows + FOOTER).round() as u32;
        self
    }

    /// Width of a panel with its labels, in pixels.
    fn column(&self) -> f64 {
        (f64::from(self.size.0) - 2.0 * MARGIN) / self.columns.len() as f64
    }

    fn draw_row<B: DrawingBackend>(&self, row: &Row, area: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let (head, body) = area.split_vertically(px(row.head()));
        draw_legend(&head, &row.legend, (0, px(0.62 * LEGEND)))?;
        let panels = body.split_evenly((1, self.columns.len()));
        for ((curves, column), panel) in row.panels.iter().zip(&self.columns).zip(panels) {
            let (head, body) = panel.split_vertically(px(CAPTION));
            let style = bold(25.0).pos(Pos::new(HPos::Left, VPos::Center));
            write_line(&head, &row.title(column), &style, (px(LABELS), px(32.0)))?;
            self.draw_panel(curves, column, &body)?;
        }
        Ok(())
    }

    fn draw_panel<B: DrawingBackend>(
        &self,
        curves: &[Curve],
        Column { x, y, .. }: &Column,
        area: &DrawingArea<B, Shift>,
    ) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let mut chart = ChartBuilder::on(area)
            .set_label_area_size(LabelAreaPosition::Left, px(LABELS))
            .set_label_area_size(LabelAreaPosition::Bottom, px(TICKS))
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
            let outside = |point: &(f64, f64)| !(x.shows(point.0) && y.shows(point.1));
            for run in points.split(outside).filter(|run| !run.is_empty()) {
                if label.is_some() {
                    // Segment by segment: a joined corner would be a long spike where a curve turns back.
                    run.windows(2).try_for_each(|ends| line.draw(plot, ends.to_vec()))?;
                } else {
                    line.draw(plot, run.to_vec())?;
                }
            }
            points.retain(|point| !outside(point));
            for &point in points.iter().filter(|_| label.is_some()) {
                plot.draw(&Circle::new(point, px(1.4 * line.width), line.color.filled()))?;
            }
        }
        draw_labels(area, plot, &curves)
    }

    /// Space to the right of each panel.
    fn right(&self) -> f64 {
        let curves = self.rows.iter().flat_map(|row| row.panels.iter().flatten());
        curves.fold(
            RIGHT,
            |right, curve| if curve.label.is_some() { WITH_LABELS } else { right },
        )
    }

    /// Labels the x axis once, below each column of panels.
    fn draw_x_labels<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let style = text(23.0, INK).pos(Pos::new(HPos::Center, VPos::Center));
        let (column, height) = (self.column(), f64::from(self.size.1));
        for (n, Column { x, .. }) in self.columns.iter().enumerate() {
            let middle = MARGIN + n as f64 * column + 0.5 * (LABELS + column - self.right());
            page.draw_text(&x.label, &style, (px(middle), px(height - 0.62 * FOOTER)))?;
        }
        Ok(())
    }
}

impl Column {
    pub fn new(title: &str, x: Axis, y: Axis) -> Self {
        Self {
            title: title.to_owned(),
            x,
            y,
        }
    }
}

impl Row {
    /// A row without a caption.
    pub fn new(panels: Vec<Vec<Curve>>) -> Self {
        Self {
            caption: String::new(),
            legend: Vec::new(),
            panels,
        }
    }

    /// Height of the legend above the panels, in pixels.
    fn head(&self) -> f64 {
        if self.legend.is_empty() { 0.0 } else { LEGEND }
    }

    fn title(&self, column: &Column) -> String {
        let parts = [&self.caption, &column.title];
        parts
            .map(String::as_str)
            .into_iter()
            .filter(|part| !part.is_empty())
            .collect::<Vec<_>>()
            .join(": ")
    }
}

/// Height of the head of a page.
pub(crate) fn head(legend: &[(Line, String)]) -> f64 {
    if legend.is_empty() { 80.0 } else { 138.0 }
}

/// Draws the head of a white page: title, subtitle and legend.
pub(crate) fn draw_head<B: DrawingBackend>(
    page: &DrawingArea<B, Shift>,
    (title, subtitle): (&str, &str),
    legend: &[(Line, String)],
) -> Result<(), Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    page.fill(&WHITE)?;
    write_line(page, title, &bold(32.0), (px(MARGIN), px(MARGIN)))?;
    write_line(page, subtitle, &text(23.0, GREY), (px(MARGIN), px(MARGIN + 46.0)))?;
    draw_legend(page, legend, (px(MARGIN), px(MARGIN + 112.0)))
}

impl Axis {
    /// A linear axis.
    pub fn linear(label: &str, range: Range<f64>) -> Self {
        Self {
            label: label.to_owned(),
            scale: Scale::Linear,
            range,
            ticks: 5,
        }
    }

    /// An axis of logarithms to base ten; the range is of logarithms as well.
    pub fn decades(label: &str, range: Range<f64>) -> Self {
        Self {
            scale: Scale::Decades,
            ..Self::linear(label, range)
        }
    }

    pub(crate) fn shows(&self, value: f64) -> bool {
        self.range.start <= value && value <= self.range.end
    }

    /// Label of a tick: a number with a true minus sign, or a power of ten; empty between powers of ten.
    pub(crate) fn tick(&self, value: f64) -> String {
        // The sum removes rounding errors of steps like 0.1, and turns -0 into 0.
        let value = (value * 1e9).round() / 1e9 + 0.0;
        let value = match self.scale {
            Scale::Linear => return value.to_string().replace('-', "\u{2212}"),
            Scale::Decades => value,
            Scale::Falling => 0.0 - value,
        };
        if value.fract() == 0.0 {
            power_of_ten(value as i32)
        } else {
            String::new()
        }
    }
}

impl Curve {
    /// A curve without a label.
    pub fn new(line: Line, points: Vec<(f64, f64)>) -> Self {
        Self {
            line,
            points,
            label: None,
        }
    }
}

/// Height of the legend of a row; like all lengths below in pixels of the picture.
const LEGEND: f64 = 52.0;
const CAPTION: f64 = 56.0;
const TICKS: f64 = 36.0;
const FOOTER: f64 = 62.0;
pub(crate) const LABELS: f64 = 96.0;
const RIGHT: f64 = 24.0;
const WITH_LABELS: f64 = 104.0;

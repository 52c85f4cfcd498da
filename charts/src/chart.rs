//! Charts in one style for all examples: titled panels in rows and columns.

use std::error::Error;
use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, ValueFormatter};
use plotters::coord::{CoordTranslate, Shift};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

pub use crate::curve::Curve;
use crate::label::{Path, Point, draw_labels};
use crate::line::draw_legend;
pub use crate::line::{Line, Marker, Stroke};
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
    /// Largest number of ticks.
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
        let panel = (self.column() - LABELS - RIGHT) * length(&self.columns[0].y) / length(&self.columns[0].x);
        let rows: f64 = self
            .rows
            .iter()
            .map(|row| row.head() + self.caption() + panel + TICKS)
            .sum();
        self.size.1 = (MARGIN + head(&self.legend) + rows + FOOTER).round() as u32;
        self
    }

    /// Height of a plot over its width.
    pub(crate) fn aspect(&self) -> f64 {
        let rows = self.rows.len() as f64;
        let heads: f64 = self.rows.iter().map(Row::head).sum();
        let height = f64::from(self.size.1) - MARGIN - head(&self.legend) - FOOTER - heads;
        (height / rows - self.caption() - TICKS) / (self.column() - LABELS - RIGHT)
    }

    /// Width of a panel with its labels, in pixels.
    fn column(&self) -> f64 {
        (f64::from(self.size.0) - 2.0 * MARGIN) / self.columns.len() as f64
    }

    /// Height of the titles above the panels, in pixels.
    fn caption(&self) -> f64 {
        let has_title = |row: &Row| self.columns.iter().any(|column| !row.title(column).is_empty());
        if self.rows.iter().any(has_title) {
            CAPTION
        } else {
            NO_CAPTION
        }
    }

    fn draw_row<B: DrawingBackend>(&self, row: &Row, area: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let (head, body) = area.split_vertically(px(row.head()));
        draw_legend(&head, &row.legend, (0, px(0.62 * LEGEND)))?;
        let panels = body.split_evenly((1, self.columns.len()));
        for ((curves, column), panel) in row.panels.iter().zip(&self.columns).zip(panels) {
            let (head, body) = panel.split_vertically(px(self.caption()));
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
            .margin_right(px(RIGHT))
            .build_cartesian_2d(x.clone(), y.clone())?;
        chart
            .configure_mesh()
            .max_light_lines(0)
            .bold_line_style(GRID.stroke_width(width(1.5)))
            .axis_style(GREY.stroke_width(width(1.5)))
            .set_all_tick_mark_size(px(7.0))
            .label_style(text(22.0, INK))
            .axis_desc_style(text(23.0, INK))
            .y_desc(&y.label)
            .draw()?;
        let plot = chart.plotting_area();
        let mut curves = curves.to_vec();
        for Curve { line, points, .. } in &mut curves {
            let outside = |point: &(f64, f64)| !(x.shows(point.0) && y.shows(point.1));
            for run in points.split(outside).filter(|run| !run.is_empty()) {
                if line.marker.is_some() {
                    // Segment by segment: a joined corner would be a long spike where a curve turns back.
                    run.windows(2).try_for_each(|ends| line.draw(plot, ends.to_vec()))?;
                } else {
                    line.draw(plot, run.to_vec())?;
                }
            }
            points.retain(|point| !outside(point));
            line.draw_marks(plot, points)?;
        }
        name_curves(area, plot, &curves)
    }

    /// Labels the x axis once, below each column of panels.
    fn draw_x_labels<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let style = text(23.0, INK).pos(Pos::new(HPos::Center, VPos::Center));
        let (column, height) = (self.column(), f64::from(self.size.1));
        for (n, Column { x, .. }) in self.columns.iter().enumerate() {
            let middle = MARGIN + n as f64 * column + 0.5 * (LABELS + column - RIGHT);
            page.draw_text(&x.label, &style, (px(middle), px(height - 0.62 * FOOTER)))?;
        }
        Ok(())
    }
}

/// Draws the labels of the curves of the panel `area`, whose points are in `plot`.
fn name_curves<B, C>(
    area: &DrawingArea<B, Shift>,
    plot: &DrawingArea<B, C>,
    curves: &[Curve],
) -> Result<(), Box<dyn Error>>
where
    B: DrawingBackend,
    B::ErrorType: 'static,
    C: CoordTranslate<From = (f64, f64)>,
{
    let (left, top) = area.get_base_pixel();
    let unit = f64::from(px(1.0));
    let place = |(x, y): (i32, i32)| (f64::from(x - left) / unit, f64::from(y - top) / unit);
    let (columns, rows) = plot.get_pixel_range();
    let frame = [place((columns.start, rows.start)), place((columns.end, rows.end))];
    let path = |curve: &'_ Curve| -> Vec<Point> {
        // labels may stand on areas
        let first = match curve.line.stroke {
            Stroke::Area => curve.points.len().saturating_sub(1),
            _ => 0,
        };
        let points = curve.points[first..].iter();
        points.map(|point| place(plot.map_coordinate(point))).collect()
    };
    let paths: Vec<_> = curves
        .iter()
        .map(|curve| Path {
            points: path(curve),
            color: curve.line.color,
            name: curve.label.as_deref(),
        })
        .collect();
    draw_labels(area, frame, &paths, 21.0)
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

    pub(crate) fn title(&self, column: &Column) -> String {
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

    /// Round numbers on the axis, at most `ticks`. On less than two decades these are powers of ten, their double and
    /// their fivefold.
    pub(crate) fn marks(&self) -> Vec<f64> {
        let (start, end) = (self.range.start, self.range.end);
        if self.is_short() {
            let decades = start.floor() as i32..=end as i32;
            let marks = decades.flat_map(|n| [1.0_f64, 2.0, 5.0].map(|factor| f64::from(n) + factor.log10()));
            return marks.filter(|&mark| self.shows(mark)).collect();
        }
        let least = if self.scale == Scale::Linear {
            f64::MIN_POSITIVE
        } else {
            1.0
        };
        let power = 10.0_f64.powf(((end - start) / self.ticks as f64).log10().floor());
        let marks = |step: f64| {
            let (first, last) = ((start / step - 1e-9).ceil() as i32, (end / step + 1e-9).floor() as i32);
            (first..=last).map(|n| step * f64::from(n)).collect::<Vec<_>>()
        };
        let steps = [1.0, 2.0, 5.0, 10.0].map(|n| n * power);
        let mut marks = steps.into_iter().filter(|&step| step >= least).map(marks);
        marks.find(|marks| marks.len() <= self.ticks).unwrap_or_default()
    }

    /// True for a logarithmic axis of at most two decades.
    fn is_short(&self) -> bool {
        self.scale != Scale::Linear && self.range.end - self.range.start <= 2.0
    }

    /// Label of a tick: a number with a true minus sign, or a power of ten.
    pub(crate) fn tick(&self, value: f64) -> String {
        // The sum removes rounding errors of steps like 0.1, and turns -0 into 0.
        let value = (value * 1e9).round() / 1e9 + 0.0;
        let exponent = match self.scale {
            Scale::Linear => return value.to_string().replace('-', "\u{2212}"),
            Scale::Decades => value,
            Scale::Falling => 0.0 - value,
        };
        if self.is_short() {
            let digit = format!("{:.0e}", 10.0_f64.powf(exponent));
            return digit.parse::<f64>().map_or(digit, |number| number.to_string());
        }
        power_of_ten(exponent.round() as i32)
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (start, end): (i32, i32)) -> i32 {
        let part = (value - self.range.start) / (self.range.end - self.range.start);
        start + (f64::from(end - start) * part).round() as i32
    }

    fn key_points<H: KeyPointHint>(&self, _hint: H) -> Vec<f64> {
        self.marks()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format(value: &f64) -> String {
        value.to_string()
    }

    fn format_ext(&self, value: &f64) -> String {
        self.tick(*value)
    }
}

impl Curve {
    /// A text beside a point.
    pub fn note(color: RGBColor, point: (f64, f64), text: &str) -> Self {
        Self {
            label: Some(text.to_owned()),
            ..Self::new(Line::solid(color), vec![point])
        }
    }

    /// A curve without a label.
    pub fn new(line: Line, points: Vec<(f64, f64)>) -> Self {
        Self {
            line,
            points,
            label: None,
            name: None,
            notes: Vec::new(),
        }
    }
}

/// Height of the legend of a row; like all lengths below in pixels of the picture.
const LEGEND: f64 = 52.0;
const CAPTION: f64 = 56.0;
const NO_CAPTION: f64 = 18.0;
const TICKS: f64 = 36.0;
const FOOTER: f64 = 62.0;
pub(crate) const LABELS: f64 = 96.0;
const RIGHT: f64 = 40.0;

//! Heat maps in the style of the charts: a number at each point of a plane, as a colour.

use std::error::Error;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::chart::{Axis, Curve, LABELS, Line, draw_head, head};
use crate::page::{GREY, INK, MARGIN, Picture, bold, px, text, width, write_line};
use crate::palette::viridis;

/// Maps in rows and columns, each with its own axes and colour bar.
pub struct Atlas {
    pub title: String,
    pub subtitle: String,
    /// Legend of the lines on the maps.
    pub legend: Vec<(Line, String)>,
    /// Number of maps per row.
    pub columns: usize,
    pub maps: Vec<Map>,
}

/// Numbers over a rectangle.
pub struct Map {
    pub x: Axis,
    pub y: Axis,
    /// Axis of the colours; its label is the caption of the map. Numbers beyond the range are clamped.
    pub colors: Axis,
    /// Number of colours.
    pub steps: usize,
    /// Numbers of equal cells, row by row from the bottom, and from the left in each row; NaN is white.
    pub cells: Vec<f64>,
    /// Number of cells per row.
    pub across: usize,
    /// Lines on top of the colours.
    pub curves: Vec<Curve>,
}

impl Picture for Atlas {
    fn size(&self) -> (u32, u32) {
        let rows = self.maps.len().div_ceil(self.columns) as f64;
        let width = 2.0 * MARGIN + self.columns as f64 * (LABELS + SIDE + BAR);
        let height = 2.0 * MARGIN + head(&self.legend) + rows * (CAPTION + SIDE + BELOW);
        (width as u32, height as u32)
    }

    fn draw<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        draw_head(page, (&self.title, &self.subtitle), &self.legend)?;
        let body = page.margin(px(MARGIN + head(&self.legend)), px(MARGIN), px(MARGIN), px(MARGIN));
        let rows = self.maps.len().div_ceil(self.columns);
        for (map, area) in self.maps.iter().zip(body.split_evenly((rows, self.columns))) {
            map.draw(&area)?;
        }
        page.present()?;
        Ok(())
    }
}

impl Map {
    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let (head, body) = area.split_vertically(px(CAPTION));
        let style = bold(25.0).pos(Pos::new(HPos::Left, VPos::Center));
        write_line(&head, &self.colors.label, &style, (px(LABELS), px(30.0)))?;
        let (body, bar) = body.split_horizontally(px(LABELS + SIDE));
        let mut chart = ChartBuilder::on(&body)
            .set_label_area_size(LabelAreaPosition::Left, px(LABELS))
            .set_label_area_size(LabelAreaPosition::Bottom, px(BELOW))
            .build_cartesian_2d(self.x.range.clone(), self.y.range.clone())?;
        self.fill(&chart.plotting_area().strip_coord_spec())?;
        for Curve { line, points, .. } in &self.curves {
            for run in points.split(|point| !(self.x.shows(point.0) && self.y.shows(point.1))) {
                line.draw(chart.plotting_area(), run.to_vec())?;
            }
        }
        chart
            .configure_mesh()
            .disable_mesh()
            .x_labels(self.x.ticks)
            .y_labels(self.y.ticks)
            .axis_style(GREY.stroke_width(width(1.5)))
            .set_all_tick_mark_size(px(7.0))
            .label_style(text(22.0, INK))
            .axis_desc_style(text(23.0, INK))
            .x_label_formatter(&|value| self.x.tick(*value))
            .y_label_formatter(&|value| self.y.tick(*value))
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .draw()?;
        self.draw_bar(&bar)
    }

    /// Draws the cells, whose edges lie on whole pixels.
    fn fill<B: DrawingBackend>(&self, plot: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let (width, height) = plot.dim_in_pixel();
        let down = self.cells.len() / self.across;
        let edge = |pixels: u32, n: usize, of: usize| (f64::from(pixels) * n as f64 / of as f64).round() as i32;
        for (n, &value) in self.cells.iter().enumerate().filter(|(_, value)| !value.is_nan()) {
            let (column, row) = (n % self.across, down - 1 - n / self.across);
            let [left, right] = [0, 1].map(|side| edge(width, column + side, self.across));
            let [top, bottom] = [0, 1].map(|side| edge(height, row + side, down));
            let corners = [(left, top), (right, bottom)];
            plot.draw(&Rectangle::new(corners, self.color(value).filled()))?;
        }
        Ok(())
    }

    /// Draws the colour bar, to the right of the map.
    fn draw_bar<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let range = self.colors.range.clone();
        let mut chart = ChartBuilder::on(area)
            .margin_left(px(24.0))
            .margin_bottom(px(BELOW))
            .set_label_area_size(LabelAreaPosition::Right, px(BAR - 24.0 - 30.0))
            .build_cartesian_2d(0.0..1.0, range.clone())?;
        let height = (range.end - range.start) / self.steps as f64;
        for n in 0..self.steps {
            let low = range.start + height * n as f64;
            let color = self.color(low + 0.5 * height);
            let corners = [(0.0, low), (1.0, low + height)];
            chart.plotting_area().draw(&Rectangle::new(corners, color.filled()))?;
        }
        chart
            .configure_mesh()
            .disable_mesh()
            .disable_x_axis()
            .y_labels(self.colors.ticks)
            .axis_style(GREY.stroke_width(width(1.5)))
            .set_all_tick_mark_size(px(7.0))
            .label_style(text(22.0, INK))
            .y_label_formatter(&|value| self.colors.tick(*value))
            .draw()?;
        Ok(())
    }

    /// Colour of the step that contains a value.
    fn color(&self, value: f64) -> RGBColor {
        let range = &self.colors.range;
        let last = (self.steps - 1) as f64;
        let step = ((value - range.start) / (range.end - range.start) * self.steps as f64).floor();
        viridis(step.clamp(0.0, last) / last)
    }
}

/// Side of the square map; like all lengths below in pixels of the picture.
const SIDE: f64 = 540.0;
/// Space above the map.
const CAPTION: f64 = 56.0;
/// Space below the map.
const BELOW: f64 = 84.0;
/// Space to the right of the map.
const BAR: f64 = 140.0;

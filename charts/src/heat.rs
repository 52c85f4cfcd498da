//! Heat maps in the style of the charts: a number at each point of a plane, as a colour.

use std::error::Error;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::chart::{Axis, Curve, LABELS, Line, draw_head, head};
use crate::contour;
use crate::page::{GREY, INK, MARGIN, Picture, bold, px, text, width, write_line};
pub use crate::palette::Palette;

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
    pub palette: Palette,
    /// Number of colours.
    pub steps: usize,
    /// Numbers of equal cells, row by row from the bottom, and from the left in each row. NaN is white, or grey where
    /// white stands for zero.
    pub cells: Vec<f64>,
    /// Number of cells per row.
    pub across: usize,
    /// Lines on top of the colours.
    pub curves: Vec<Curve>,
}

impl Picture for Atlas {
    fn size(&self) -> (u32, u32) {
        let rows = self.maps.len().div_ceil(self.columns) as f64;
        let width = 2.0 * MARGIN + self.columns as f64 * (LABELS + self.side() + BAR);
        let height = 2.0 * MARGIN + head(&self.legend) + rows * (CAPTION + self.side() + BELOW);
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
            map.draw(&area, self.side())?;
        }
        page.present()?;
        Ok(())
    }
}

impl Atlas {
    /// Side of the square maps, in pixels of the picture.
    fn side(&self) -> f64 {
        if self.columns == 1 { 760.0 } else { 540.0 }
    }
}

impl Map {
    /// Adds the contours of zero that are longer than `least` cells.
    #[must_use]
    pub fn with_zeros(mut self, line: Line, least: usize) -> Self {
        let inside = |axis: &Axis, count: usize| {
            let half = 0.5 * (axis.range.end - axis.range.start) / count as f64;
            axis.range.start + half..axis.range.end - half
        };
        let (x, y) = (
            inside(&self.x, self.across),
            inside(&self.y, self.cells.len() / self.across),
        );
        let zeros = contour::zeros(&self.cells, self.across, &x, &y);
        let long = zeros.into_iter().filter(|path| path.len() > least);
        self.curves.extend(long.map(|path| Curve::new(line, path)));
        self
    }

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>, side: f64) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let (head, body) = area.split_vertically(px(CAPTION));
        let style = bold(25.0).pos(Pos::new(HPos::Left, VPos::Center));
        write_line(&head, &self.colors.label, &style, (px(LABELS), px(30.0)))?;
        let (body, bar) = body.split_horizontally(px(LABELS + side));
        let mut chart = ChartBuilder::on(&body)
            .set_label_area_size(LabelAreaPosition::Left, px(LABELS))
            .set_label_area_size(LabelAreaPosition::Bottom, px(BELOW))
            .build_cartesian_2d(self.x.clone(), self.y.clone())?;
        self.fill(&chart.plotting_area().strip_coord_spec())?;
        for Curve { line, points, .. } in &self.curves {
            for run in points.split(|point| !(self.x.shows(point.0) && self.y.shows(point.1))) {
                line.draw(chart.plotting_area(), run.to_vec())?;
            }
        }
        chart
            .configure_mesh()
            .disable_mesh()
            .axis_style(GREY.stroke_width(width(1.5)))
            .set_all_tick_mark_size(px(7.0))
            .label_style(text(22.0, INK))
            .axis_desc_style(text(23.0, INK))
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
        for (n, &value) in self.cells.iter().enumerate() {
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
            .build_cartesian_2d(0.0..1.0, self.colors.clone())?;
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
            .axis_style(GREY.stroke_width(width(1.5)))
            .set_all_tick_mark_size(px(7.0))
            .label_style(text(22.0, INK))
            .draw()?;
        Ok(())
    }

    /// Colour of the step that contains a value, which is the colour at the middle of the step.
    pub(crate) fn color(&self, value: f64) -> RGBColor {
        if value.is_nan() {
            return if self.palette == Palette::Signed {
                MISSING
            } else {
                WHITE
            };
        }
        let range = &self.colors.range;
        let height = (range.end - range.start) / self.steps as f64;
        let step = ((value - range.start) / height)
            .floor()
            .clamp(0.0, (self.steps - 1) as f64);
        let middle = range.start + height * (step + 0.5);
        // the ends have the first and the last colour
        let ends = [range.start + 0.5 * height, range.end - 0.5 * height];
        self.palette.color(middle, ends)
    }
}

const MISSING: RGBColor = RGBColor(170, 170, 170);

/// Space above the map; like all lengths below in pixels of the picture.
const CAPTION: f64 = 56.0;
/// Space below the map.
const BELOW: f64 = 84.0;
/// Space to the right of the map.
const BAR: f64 = 140.0;

//! Charts in one style for all examples: panels in rows and columns, written as SVG and as PNG.

use std::error::Error;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use plotters::coord::{CoordTranslate, Shift};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::typeset::{FAMILY, LINE_PER_EM, Typeset, register_fonts};

/// Colours that people with any colour vision can tell apart (Okabe and Ito, 2008), the darker ones.
pub(crate) const BLUE: RGBColor = RGBColor(0, 114, 178);
pub(crate) const VERMILION: RGBColor = RGBColor(213, 94, 0);

const INK: RGBColor = RGBColor(34, 34, 34);
const GREY: RGBColor = RGBColor(95, 95, 95);
const GRID: RGBColor = RGBColor(226, 226, 226);

/// Panels that share the axis of x, and in each column that of y, so that they can be compared at sight.
pub(crate) struct Figure {
    pub title: String,
    pub subtitle: String,
    /// In pixels.
    pub size: (u32, u32),
    pub legend: Vec<(Line, String)>,
    pub x: Axis,
    /// The axis of y of each column.
    pub columns: Vec<Axis>,
    pub rows: Vec<Row>,
}

/// Panels beside each other, below a caption.
pub(crate) struct Row {
    pub caption: String,
    /// The curves of the panel in each column.
    pub panels: Vec<Vec<Curve>>,
}

/// A linear axis.
pub(crate) struct Axis {
    pub label: String,
    pub range: Range<f64>,
    /// About how many ticks.
    pub ticks: usize,
}

/// How a curve looks.
#[derive(Clone, Copy)]
pub(crate) struct Line {
    pub color: RGBColor,
    /// In pixels.
    pub width: f64,
    pub dashed: bool,
}

/// Points joined by a line.
pub(crate) struct Curve {
    pub line: Line,
    pub points: Vec<(f64, f64)>,
}

impl Figure {
    /// Writes `stem` with the endings svg and png, and says where.
    pub(crate) fn save(&self, stem: &Path) -> Result<[PathBuf; 2], Box<dyn Error>> {
        register_fonts()?;
        let files = [("svg", self.svg()?.into_bytes()), ("png", self.png()?)];
        if let Some(folder) = stem.parent() {
            fs::create_dir_all(folder)
                .map_err(|error| format!("cannot make the folder {}: {error}", folder.display()))?;
        }
        let mut paths = [PathBuf::new(), PathBuf::new()];
        for (path, (ending, contents)) in paths.iter_mut().zip(files) {
            *path = stem.with_added_extension(ending);
            fs::write(&path, contents).map_err(|error| format!("cannot write {}: {error}", path.display()))?;
        }
        Ok(paths)
    }

    /// plotters draws on whole pixels; in a drawing several times too large, scaled down by its view box, they do not show.
    fn svg(&self) -> Result<String, Box<dyn Error>> {
        let (width, height) = self.size;
        let fine = (width * FINENESS, height * FINENESS);
        let mut text = String::new();
        self.draw(&SVGBackend::with_string(&mut text, fine).into_drawing_area())?;
        Ok(text.replacen(
            &format!(r#"width="{}" height="{}""#, fine.0, fine.1),
            &format!(r#"width="{width}" height="{height}""#),
            1,
        ))
    }

    /// Drawn just as large and averaged down, which makes the edges smooth.
    fn png(&self) -> Result<Vec<u8>, Box<dyn Error>> {
        let (width, height) = self.size;
        let fine = (width * FINENESS, height * FINENESS);
        let mut pixels = vec![0; 3 * fine.0 as usize * fine.1 as usize];
        self.draw(&Typeset(BitMapBackend::with_buffer(&mut pixels, fine)).into_drawing_area())?;
        encode(&shrink(&pixels, fine.0 as usize), self.size)
    }

    fn draw<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        page.fill(&WHITE)?;
        page.draw_text(&self.title, &bold(32.0), (px(MARGIN), px(MARGIN)))?;
        page.draw_text(&self.subtitle, &text(23.0, GREY), (px(MARGIN), px(MARGIN + 46.0)))?;
        self.draw_legend(page, MARGIN + 112.0)?;
        let rows = page
            .margin(px(MARGIN + 138.0), px(FOOTER), px(MARGIN), px(MARGIN))
            .split_evenly((self.rows.len(), 1));
        for (row, area) in self.rows.iter().zip(rows) {
            self.draw_row(row, &area)?;
        }
        self.draw_x_labels(page)?;
        page.present()?;
        Ok(())
    }

    /// The keys of the lines, beside each other at the height `y`.
    fn draw_legend<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>, y: f64) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let style = text(24.0, INK).pos(Pos::new(HPos::Left, VPos::Center));
        let mut x = px(MARGIN);
        for (line, name) in &self.legend {
            let end = x + px(74.0);
            line.draw(page, vec![(x, px(y)), (end, px(y))])?;
            let start = end + px(14.0);
            page.draw_text(name, &style, (start, px(y)))?;
            let (width, _) = page.estimate_text_size(name, &style)?;
            x = start + i32::try_from(width)? + px(56.0);
        }
        Ok(())
    }

    fn draw_row<B: DrawingBackend>(&self, row: &Row, area: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let (head, body) = area.split_vertically(px(56.0));
        let style = bold(25.0).pos(Pos::new(HPos::Left, VPos::Center));
        head.draw_text(&row.caption, &style, (px(LABELS), px(32.0)))?;
        let panels = body.split_evenly((1, self.columns.len()));
        for ((curves, y), panel) in row.panels.iter().zip(&self.columns).zip(panels) {
            self.draw_panel(curves, y, &panel)?;
        }
        Ok(())
    }

    fn draw_panel<B: DrawingBackend>(
        &self,
        curves: &[Curve],
        y: &Axis,
        area: &DrawingArea<B, Shift>,
    ) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let mut chart = ChartBuilder::on(area)
            .set_label_area_size(LabelAreaPosition::Left, px(LABELS))
            .set_label_area_size(LabelAreaPosition::Bottom, px(36.0))
            .margin_right(px(RIGHT))
            .build_cartesian_2d(self.x.range.clone(), y.range.clone())?;
        chart
            .configure_mesh()
            .x_labels(self.x.ticks)
            .y_labels(y.ticks)
            .max_light_lines(0)
            .bold_line_style(GRID.stroke_width(width(1.5)))
            .axis_style(GREY.stroke_width(width(1.5)))
            .set_all_tick_mark_size(px(7.0))
            .label_style(text(22.0, INK))
            .axis_desc_style(text(23.0, INK))
            .x_label_formatter(&tick)
            .y_label_formatter(&tick)
            .y_desc(&y.label)
            .draw()?;
        for Curve { line, points } in curves {
            line.draw(chart.plotting_area(), points.clone())?;
        }
        Ok(())
    }

    /// The axis of x is named once, below each column.
    fn draw_x_labels<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let style = text(23.0, INK).pos(Pos::new(HPos::Center, VPos::Center));
        let (width, height) = (f64::from(self.size.0), f64::from(self.size.1));
        let column = (width - 2.0 * MARGIN) / self.columns.len() as f64;
        for n in 0..self.columns.len() {
            let middle = MARGIN + n as f64 * column + 0.5 * (LABELS + column - RIGHT);
            page.draw_text(&self.x.label, &style, (px(middle), px(height - 0.62 * FOOTER)))?;
        }
        Ok(())
    }
}

impl Line {
    fn draw<B, C>(self, area: &DrawingArea<B, C>, points: Vec<C::From>) -> Result<(), Box<dyn Error>>
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

/// How many pixels of the drawing make one of the picture, in each direction.
const FINENESS: u32 = 4;

/// Space around the page and its parts, in pixels of the picture.
const MARGIN: f64 = 36.0;
const FOOTER: f64 = 62.0;
const LABELS: f64 = 96.0;
const RIGHT: f64 = 24.0;

/// A length in pixels of the drawing, from one in pixels of the picture.
fn px(length: f64) -> i32 {
    (length * f64::from(FINENESS)).round() as i32
}

fn width(width: f64) -> u32 {
    px(width).unsigned_abs()
}

/// Text whose em has that many pixels of the picture.
fn text(em: f64, color: RGBColor) -> TextStyle<'static> {
    styled(em, color, FontStyle::Normal)
}

fn bold(em: f64) -> TextStyle<'static> {
    styled(em, INK, FontStyle::Bold)
}

fn styled(em: f64, color: RGBColor, style: FontStyle) -> TextStyle<'static> {
    let size = em * LINE_PER_EM * f64::from(FINENESS);
    let mut text = TextStyle::from((FAMILY, size, style).into_font());
    text.color = color.to_backend_color();
    text
}

/// A number beside a tick, with a true minus sign.
fn tick(value: &f64) -> String {
    // The sum rounds off what is left of steps like 0.1, and turns -0 into 0.
    let value = (value * 1e9).round() / 1e9 + 0.0;
    value.to_string().replace('-', "\u{2212}")
}

/// Averages squares of `FINENESS` by `FINENESS` pixels; `width` is that of the large picture.
fn shrink(pixels: &[u8], width: usize) -> Vec<u8> {
    let fineness = FINENESS as usize;
    let mut small = Vec::with_capacity(pixels.len() / (fineness * fineness));
    for rows in pixels.chunks_exact(3 * width * fineness) {
        for x in (0..width).step_by(fineness) {
            for channel in 0..3 {
                let row = |y: usize| (x..x + fineness).map(move |x| u32::from(rows[3 * (y * width + x) + channel]));
                let sum: u32 = (0..fineness).flat_map(row).sum();
                let count = FINENESS * FINENESS;
                small.push(((sum + count / 2) / count) as u8);
            }
        }
    }
    small
}

fn encode(pixels: &[u8], (width, height): (u32, u32)) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    // Plain colours beside each other pack best as they are.
    encoder.set_filter(png::Filter::NoFilter);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(file)
}

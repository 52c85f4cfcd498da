//! Pictures that are drawn once and written as SVG and as PNG, in the style of all charts.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use plotters::coord::Shift;
use plotters::prelude::*;
pub use plotters::style::RGBColor;

use crate::typeset::{FAMILY, LINE_PER_EM, Typeset, register_fonts};

/// Colours that are distinguishable with any colour vision (Okabe and Ito, 2008).
pub const BLUE: RGBColor = RGBColor(0, 114, 178);
pub const VERMILION: RGBColor = RGBColor(213, 94, 0);
pub const GREEN: RGBColor = RGBColor(0, 158, 115);
pub const PURPLE: RGBColor = RGBColor(204, 121, 167);
pub const ORANGE: RGBColor = RGBColor(230, 159, 0);
pub const SKY: RGBColor = RGBColor(86, 180, 233);

pub const INK: RGBColor = RGBColor(34, 34, 34);
pub const GREY: RGBColor = RGBColor(95, 95, 95);
pub const GRID: RGBColor = RGBColor(226, 226, 226);

/// Margin of the page, in pixels of the picture.
pub const MARGIN: f64 = 36.0;

/// Drawable picture.
pub trait Picture {
    /// Width and height, in pixels.
    fn size(&self) -> (u32, u32);

    /// Draws on a page whose lengths are given by [`px`].
    fn draw<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static;

    /// Writes `stem` with the extensions svg and png, and returns the paths.
    fn save(&self, stem: &Path) -> Result<[PathBuf; 2], Box<dyn Error>> {
        register_fonts()?;
        Ok([
            write(stem, "svg", self.svg()?.as_bytes())?,
            write(stem, "png", &self.png()?)?,
        ])
    }

    /// Writes only `stem` with the extension png, and returns its path: for pictures with too many parts for an SVG.
    fn save_png(&self, stem: &Path) -> Result<PathBuf, Box<dyn Error>> {
        register_fonts()?;
        write(stem, "png", &self.png()?)
    }

    /// Draws the SVG. As plotters rounds to whole pixels, the drawing is several times larger, and its view box scales
    /// it down.
    fn svg(&self) -> Result<String, Box<dyn Error>> {
        let (width, height) = self.size();
        let fine = (width * FINENESS, height * FINENESS);
        let mut text = String::new();
        self.draw(&SVGBackend::with_string(&mut text, fine).into_drawing_area())?;
        Ok(text.replacen(
            &format!(r#"width="{}" height="{}""#, fine.0, fine.1),
            &format!(r#"width="{width}" height="{height}""#),
            1,
        ))
    }

    fn png(&self) -> Result<Vec<u8>, Box<dyn Error>> {
        encode(&self.pixels()?, self.size())
    }

    /// Red, green and blue of each pixel: drawn as large as the SVG and averaged down, which antialiases the edges.
    fn pixels(&self) -> Result<Vec<u8>, Box<dyn Error>> {
        let (width, height) = self.size();
        let fine = (width * FINENESS, height * FINENESS);
        let mut pixels = vec![0; 3 * fine.0 as usize * fine.1 as usize];
        self.draw(&Typeset(BitMapBackend::with_buffer(&mut pixels, fine)).into_drawing_area())?;
        Ok(shrink(&pixels, fine.0 as usize))
    }
}

pub(crate) fn write(stem: &Path, ending: &str, contents: &[u8]) -> Result<PathBuf, Box<dyn Error>> {
    if let Some(folder) = stem.parent() {
        fs::create_dir_all(folder).map_err(|error| format!("cannot make the folder {}: {error}", folder.display()))?;
    }
    let path = stem.with_added_extension(ending);
    fs::write(&path, contents).map_err(|error| format!("cannot write {}: {error}", path.display()))?;
    Ok(path)
}

/// Pixels of the drawing per pixel of the picture, in each direction.
const FINENESS: u32 = 4;

/// Converts a length from pixels of the picture to pixels of the drawing.
pub fn px(length: f64) -> i32 {
    (length * f64::from(FINENESS)).round() as i32
}

pub fn width(width: f64) -> u32 {
    px(width).unsigned_abs()
}

/// Text style with an em in pixels of the picture.
pub fn text(em: f64, color: RGBColor) -> TextStyle<'static> {
    styled(em, color, FontStyle::Normal)
}

pub fn bold(em: f64) -> TextStyle<'static> {
    styled(em, INK, FontStyle::Bold)
}

/// Writes a line that begins at `(x, y)`; returns an error if it does not fit.
pub(crate) fn write_line<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    line: &str,
    style: &TextStyle<'_>,
    (x, y): (i32, i32),
) -> Result<(), Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    let (length, _) = area.estimate_text_size(line, style)?;
    if i64::from(x) + i64::from(length) > i64::from(area.dim_in_pixel().0) {
        return Err(format!("this text is too long for its place: {line}").into());
    }
    area.draw_text(line, style, (x, y))?;
    Ok(())
}

fn styled(em: f64, color: RGBColor, style: FontStyle) -> TextStyle<'static> {
    let size = em * LINE_PER_EM * f64::from(FINENESS);
    let mut text = TextStyle::from((FAMILY, size, style).into_font());
    text.color = color.to_backend_color();
    text
}

/// Averages squares of `FINENESS` by `FINENESS` pixels; `width` is the width of the large picture.
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
    // Uniform colours compress best without a filter.
    encoder.set_filter(png::Filter::NoFilter);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(file)
}

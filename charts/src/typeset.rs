//! Text of bitmaps, laid out like the text of an SVG in a browser.
//!
//! The layout of plotters (0.3.7) omits the spacing that a font prescribes beside each glyph, and puts the lines higher
//! than in its SVG.

use std::error::Error;

use ab_glyph::{Font, FontRef, InvalidFont, PxScaleFont, ScaleFont, point};
use plotters::prelude::BitMapBackend;
use plotters::style::text_anchor::{HPos, VPos};
use plotters::style::{FontStyle, register_font};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind};

/// Font families of the charts: the first is bundled, and every browser has one of them.
pub(crate) const FAMILY: &str = "Inter, Helvetica, Arial, sans-serif";

/// plotters takes the height of a line as the size of a text; its SVG divides it by this factor for the em.
pub(crate) const LINE_PER_EM: f64 = 1.24;

const REGULAR: &[u8] = include_bytes!("../fonts/Inter-Regular.otf");
const BOLD: &[u8] = include_bytes!("../fonts/Inter-SemiBold.otf");

/// Registers the fonts with plotters, which needs the widths of the glyphs.
pub(crate) fn register_fonts() -> Result<(), Box<dyn Error>> {
    for (style, font) in [(FontStyle::Normal, REGULAR), (FontStyle::Bold, BOLD)] {
        register_font(FAMILY, style, font).map_err(|_| "the font is not readable")?;
    }
    Ok(())
}

/// Bitmap backend with better text layout.
pub(crate) struct Typeset<'a>(pub BitMapBackend<'a>);

impl DrawingBackend for Typeset<'_> {
    type ErrorType = <BitMapBackend<'static> as DrawingBackend>::ErrorType;

    fn get_size(&self) -> (u32, u32) {
        self.0.get_size()
    }

    fn ensure_prepared(&mut self) -> Result<(), DrawingErrorKind<Self::ErrorType>> {
        self.0.ensure_prepared()
    }

    fn present(&mut self) -> Result<(), DrawingErrorKind<Self::ErrorType>> {
        self.0.present()
    }

    fn draw_pixel(&mut self, at: BackendCoord, color: BackendColor) -> Result<(), DrawingErrorKind<Self::ErrorType>> {
        self.0.draw_pixel(at, color)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Result<(), DrawingErrorKind<Self::ErrorType>> {
        self.0.draw_line(from, to, style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        bottom_right: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Result<(), DrawingErrorKind<Self::ErrorType>> {
        self.0.draw_rect(upper_left, bottom_right, style, fill)
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        at: BackendCoord,
    ) -> Result<(), DrawingErrorKind<Self::ErrorType>> {
        let font = font(style).map_err(|error| DrawingErrorKind::FontError(Box::new(error)))?;
        let (turn, color) = (style.transform(), style.color());
        for_each_pixel(&font, text, start(&font, text, style), |x, y, coverage| {
            let (x, y) = turn.transform(x, y);
            let alpha = color.alpha * f64::from(coverage.min(1.0));
            self.draw_pixel((at.0 + x, at.1 + y), BackendColor { alpha, ..color })
        })
    }
}

/// The font in the size in which a browser would show it.
fn font<S: BackendTextStyle>(style: &S) -> Result<PxScaleFont<FontRef<'static>>, InvalidFont> {
    let bold = matches!(style.style(), FontStyle::Bold);
    let font = FontRef::try_from_slice(if bold { BOLD } else { REGULAR })?;
    // The scale refers to the height of a line, not to the em.
    let line = font.height_unscaled() / font.units_per_em().ok_or(InvalidFont)?;
    Ok(font.into_scaled(em(style) * line))
}

fn em<S: BackendTextStyle>(style: &S) -> f32 {
    (style.size() / LINE_PER_EM) as f32
}

/// Start of `text` on its base line, relative to the anchor: the same offsets as in plotters' SVG.
fn start<S: BackendTextStyle>(font: &PxScaleFont<FontRef<'_>>, text: &str, style: &S) -> (f32, f32) {
    let em = em(style);
    let width: f32 = text.chars().map(|c| font.h_advance(font.glyph_id(c))).sum();
    let x = match style.anchor().h_pos {
        HPos::Left => 0.0,
        HPos::Center => -0.5 * width,
        HPos::Right => -width,
    };
    let ex = X_HEIGHT * em;
    let y = match style.anchor().v_pos {
        VPos::Top => 0.76 * em,
        VPos::Center => 0.5 * ex,
        VPos::Bottom => -0.5 * ex,
    };
    (x, y)
}

/// Height of the letter x, in ems.
const X_HEIGHT: f32 = 0.546;

/// Calls `draw(x, y, coverage)` for the pixels of a line that begins at `(x, y)`.
fn for_each_pixel<E>(
    font: &PxScaleFont<FontRef<'_>>,
    text: &str,
    (mut x, y): (f32, f32),
    mut draw: impl FnMut(i32, i32, f32) -> Result<(), E>,
) -> Result<(), E> {
    for c in text.chars() {
        let id = font.glyph_id(c);
        let glyph = id.with_scale_and_position(font.scale(), point(x, y));
        x += font.h_advance(id);
        let Some(outline) = font.outline_glyph(glyph) else {
            continue;
        };
        let corner = outline.px_bounds().min;
        let (left, top) = (corner.x as i32, corner.y as i32);
        let mut result = Ok(());
        outline.draw(|dx, dy, coverage| {
            if result.is_ok() && coverage > 0.0 {
                result = draw(left + dx as i32, top + dy as i32, coverage);
            }
        });
        result?;
    }
    Ok(())
}

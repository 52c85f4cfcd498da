//! Colour maps.

use plotters::style::RGBColor;

/// Colours for numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Palette {
    /// From dark blue for the smallest to yellow for the largest.
    ///
    /// Lightness increases evenly, so that the order is visible with any colour vision, and in grey: sixteen
    /// equidistant colours of viridis (N. Smith, S. van der Walt, "A Better Default Colormap for Matplotlib", SciPy
    /// 2015).
    Rising,
    /// Blue below zero, white at zero, red above zero; numbers of equal size are equally dark.
    ///
    /// Distinguishable with any colour vision: the diverging scheme "RdBu" (M. Harrower, C. A. Brewer,
    /// "ColorBrewer.org", Cartographic Journal 40 (2003) 27-37).
    Signed,
}

impl Palette {
    /// Colour of a number between `least` and `most`; other numbers are clamped.
    pub(crate) fn color(self, value: f64, [least, most]: [f64; 2]) -> RGBColor {
        match self {
            Self::Rising => mixed(&VIRIDIS, (value - least) / (most - least)),
            Self::Signed => mixed(&BLUE_TO_RED, 0.5 + 0.5 * value / least.abs().max(most.abs())),
        }
    }
}

/// Colour at a part, from 0 to 1, of the way through equidistant colours.
fn mixed(colors: &[u32], part: f64) -> RGBColor {
    let last = colors.len() - 1;
    let place = part.clamp(0.0, 1.0) * last as f64;
    let n = (place as usize).min(last - 1);
    let part = place - n as f64;
    let mix = |shift: u32| {
        let [a, b] = [colors[n], colors[n + 1]].map(|color| f64::from(color >> shift & 0xff));
        (a + part * (b - a)).round() as u8
    };
    RGBColor(mix(16), mix(8), mix(0))
}

/// Red, green and blue, a byte each.
const VIRIDIS: [u32; 16] = [
    0x440154, 0x481a6c, 0x472f7d, 0x414487, 0x39568c, 0x31688e, 0x2a788e, 0x23888e, 0x1f988b, 0x22a884, 0x35b779,
    0x54c568, 0x7ad151, 0xa5db36, 0xd2e21b, 0xfde725,
];

/// Red, green and blue, a byte each; white is in the middle.
const BLUE_TO_RED: [u32; 11] = [
    0x053061, 0x2166ac, 0x4393c3, 0x92c5de, 0xd1e5f0, 0xffffff, 0xfddbc7, 0xf4a582, 0xd6604d, 0xb2182b, 0x67001f,
];

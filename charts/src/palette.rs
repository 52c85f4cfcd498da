//! Colour map.

use plotters::style::RGBColor;

/// Colour of a number from 0 (dark blue) to 1 (yellow); other numbers are clamped.
///
/// Lightness increases evenly, so that the order is visible with any colour vision, and in grey: sixteen equidistant
/// colours of viridis (N. Smith, S. van der Walt, "A Better Default Colormap for Matplotlib", SciPy 2015), interpolated
/// linearly.
pub(crate) fn viridis(value: f64) -> RGBColor {
    let last = VIRIDIS.len() - 1;
    let place = value.clamp(0.0, 1.0) * last as f64;
    let n = (place as usize).min(last - 1);
    let part = place - n as f64;
    let mix = |shift: u32| {
        let [a, b] = [VIRIDIS[n], VIRIDIS[n + 1]].map(|color| f64::from(color >> shift & 0xff));
        (a + part * (b - a)).round() as u8
    };
    RGBColor(mix(16), mix(8), mix(0))
}

/// Red, green and blue, a byte each.
const VIRIDIS: [u32; 16] = [
    0x440154, 0x481a6c, 0x472f7d, 0x414487, 0x39568c, 0x31688e, 0x2a788e, 0x23888e, 0x1f988b, 0x22a884, 0x35b779,
    0x54c568, 0x7ad151, 0xa5db36, 0xd2e21b, 0xfde725,
];

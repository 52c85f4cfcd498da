//! Animations.

use std::error::Error;
use std::path::{Path, PathBuf};

use gif::{Encoder, Frame, Repeat};

use crate::page::{Picture, write};
use crate::typeset::register_fonts;

/// Writes an endless animation to `stem` with the extension gif, and returns its path. All pictures have the same size;
/// `rate` is their number per second.
pub fn save_gif<P: Picture>(
    stem: &Path,
    rate: u32,
    pictures: impl IntoIterator<Item = P>,
) -> Result<PathBuf, Box<dyn Error>> {
    register_fonts()?;
    let mut pictures = pictures.into_iter().peekable();
    let (width, height) = pictures.peek().ok_or("an animation has at least one picture")?.size();
    let (width, height) = (u16::try_from(width)?, u16::try_from(height)?);
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, width, height, &[])?;
    encoder.set_repeat(Repeat::Infinite)?;
    for picture in pictures {
        // speed 10 of the palette search keeps edges smooth
        let mut frame = Frame::from_rgb_speed(width, height, &picture.pixels()?, 10);
        // in hundredths of a second
        frame.delay = u16::try_from(100 / rate)?;
        encoder.write_frame(&frame)?;
    }
    drop(encoder);
    write(stem, "gif", &file)
}

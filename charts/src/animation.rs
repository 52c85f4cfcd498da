//! Moving pictures of plane scenes.

use std::error::Error;
use std::path::{Path, PathBuf};

use gif::{Encoder, Frame, Repeat};
use plotters::coord::Shift;
use plotters::prelude::*;

use crate::page::{GRID, Picture, px, width, write};

/// What one picture of an animation shows, in metres about the centre of the picture, `y` upward; later parts lie above
/// earlier ones.
pub struct Scene {
    pub polygons: Vec<(RGBColor, Vec<[f64; 2]>)>,
    /// Centres and radii.
    pub disks: Vec<(RGBColor, [f64; 2], f64)>,
}

/// Writes `stem` with the ending gif, and says where: squares of `size` pixels that show `reach` metres to each side of
/// the centre, `rate` in a second, again and again.
pub fn save_gif(stem: &Path, size: u16, reach: f64, rate: u32, scenes: &[Scene]) -> Result<PathBuf, Box<dyn Error>> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, size, size, &[])?;
    encoder.set_repeat(Repeat::Infinite)?;
    for scene in scenes {
        let pixels = Still { scene, size, reach }.pixels()?;
        // The slowest search for colours but ten: edges stay smooth.
        let mut frame = Frame::from_rgb_speed(size, size, &pixels, 10);
        // In hundredths of a second.
        frame.delay = u16::try_from(100 / rate)?;
        encoder.write_frame(&frame)?;
    }
    drop(encoder);
    write(stem, "gif", &file)
}

struct Still<'a> {
    scene: &'a Scene,
    size: u16,
    reach: f64,
}

impl Still<'_> {
    /// A point in pixels of the drawing.
    fn place(&self, [x, y]: [f64; 2]) -> (i32, i32) {
        let half = 0.5 * f64::from(self.size);
        let scale = half / self.reach;
        (px(half + scale * x), px(half - scale * y))
    }
}

impl Picture for Still<'_> {
    fn size(&self) -> (u32, u32) {
        (self.size.into(), self.size.into())
    }

    fn draw<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        page.fill(&WHITE)?;
        let level = [[-self.reach, 0.0], [self.reach, 0.0]].map(|end| self.place(end));
        page.draw(&PathElement::new(level, GRID.stroke_width(width(1.5))))?;
        for (color, corners) in &self.scene.polygons {
            let corners: Vec<_> = corners.iter().map(|&corner| self.place(corner)).collect();
            page.draw(&Polygon::new(corners, color.mix(0.85).filled()))?;
        }
        for &(color, centre, radius) in &self.scene.disks {
            let radius = 0.5 * f64::from(self.size) * radius / self.reach;
            page.draw(&Circle::new(self.place(centre), px(radius), color.filled()))?;
        }
        page.present()?;
        Ok(())
    }
}

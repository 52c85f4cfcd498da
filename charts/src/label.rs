//! Names of curves beside their last points.

use std::error::Error;

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::curve::Curve;
use crate::page::{px, text, width as page_width};

const EM: f64 = 21.0;
/// Distance of lines, in pixels of the picture.
const LINE: f64 = 25.0;
/// Distance from a point to its label, in pixels of the picture.
const GAP: f64 = 12.0;

/// Label whose position is adjusted until it covers no other.
struct Label<'c> {
    curve: &'c Curve,
    name: &'c str,
    /// Last point of the curve.
    from: (i32, i32),
    /// Start of the text.
    at: (i32, i32),
    width: i32,
}

/// Draws the labels of the curves of the panel `area`, whose points are in `plot`.
pub(crate) fn draw_labels<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    plot: &DrawingArea<B, Cartesian2d<RangedCoordf64, RangedCoordf64>>,
    curves: &[Curve],
) -> Result<(), Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    let (left, top) = area.get_base_pixel();
    let (_, rows) = plot.get_pixel_range();
    let mut labels = Vec::new();
    for curve in curves {
        if let (Some(name), Some(last)) = (&curve.label, curve.points.last()) {
            let (x, y) = plot.map_coordinate(last);
            let (width, _) = area.estimate_text_size(name, &text(EM, curve.line.color))?;
            labels.push(Label {
                curve,
                name,
                from: (x - left, y - top),
                at: (x - left + px(GAP), y - top),
                width: i32::try_from(width)?,
            });
        }
    }
    part(&mut labels);
    stay_below(rows.start - top + px(0.5 * LINE), &mut labels);
    for Label {
        curve,
        name,
        from,
        at,
        width,
    } in labels
    {
        if (at.1 - from.1).abs() > px(0.3 * LINE) {
            let style = curve.line.color.stroke_width(page_width(1.2));
            area.draw(&PathElement::new(vec![from, (at.0 - px(2.0), at.1)], style))?;
        }
        let [up, down] = [-0.45, 0.45].map(|lines| at.1 + px(lines * LINE));
        area.draw(&Rectangle::new(
            [(at.0 - px(2.0), up), (at.0 + width + px(2.0), down)],
            WHITE.mix(0.7).filled(),
        ))?;
        let style = text(EM, curve.line.color).pos(Pos::new(HPos::Left, VPos::Center));
        area.draw_text(name, &style, at)?;
    }
    Ok(())
}

/// Moves overlapping labels apart: neighbours move by half of the missing distance each, until none overlap.
fn part(labels: &mut [Label<'_>]) {
    labels.sort_by_key(|label| label.from.1);
    for _ in 0..200 {
        let mut moved = false;
        for n in 0..labels.len() {
            for m in n + 1..labels.len() {
                let (upper, lower) = (&labels[n], &labels[m]);
                let beside = upper.at.0 < lower.at.0 + lower.width && lower.at.0 < upper.at.0 + upper.width;
                let missing = px(LINE) - (lower.at.1 - upper.at.1);
                if beside && missing > 0 {
                    labels[n].at.1 -= missing / 2;
                    labels[m].at.1 += missing - missing / 2;
                    moved = true;
                }
            }
        }
        if !moved {
            break;
        }
    }
}

/// Moves labels below `top`, and labels that overlap these further down.
fn stay_below(top: i32, labels: &mut [Label<'_>]) {
    for n in 0..labels.len() {
        let (above, rest) = labels.split_at_mut(n);
        let label = &mut rest[0];
        label.at.1 = label.at.1.max(top);
        for other in above.iter() {
            if other.at.0 < label.at.0 + label.width && label.at.0 < other.at.0 + other.width {
                label.at.1 = label.at.1.max(other.at.1 + px(LINE));
            }
        }
    }
}

//! Names of curves beside their last points.

use std::error::Error;
use std::f64::consts::TAU;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::page::{px, text, width as page_width};

/// Height of a label over the size of its letters.
const HEIGHT: f64 = 8.0 / 7.0;
/// Distances from a point to its label, as all lengths here in pixels of the picture; from the second one on, a line
/// joins them.
const DISTANCES: [f64; 7] = [11.0, 20.0, 34.0, 50.0, 70.0, 95.0, 125.0];
/// Number of directions of a label from its point.
const DIRECTIONS: usize = 24;
/// Distance of the points at which curves are sampled.
const SAMPLES: f64 = 3.0;
/// Number of times that each label seeks its place among the others.
const ROUNDS: usize = 6;

/// Point in pixels of the picture.
pub(crate) type Point = (f64, f64);

/// Path of a curve, whose name belongs to its last point.
pub(crate) struct Path<'c> {
    pub points: Vec<Point>,
    pub color: RGBColor,
    pub name: Option<&'c str>,
}

/// Label of a curve.
struct Label<'c> {
    name: &'c str,
    color: RGBColor,
    /// Last point of the curve.
    from: Point,
    /// Width and height.
    size: (f64, f64),
}

/// Place of a label.
#[derive(Clone, Copy)]
struct Place {
    /// Left and right end.
    x: [f64; 2],
    /// Upper and lower end.
    y: [f64; 2],
    /// Line from the point to the label, if it is not beside it.
    line: Option<[Point; 2]>,
    /// Distance from the point.
    distance: f64,
    /// Direction from the point to the right, from -1 to 1.
    rightward: f64,
}

/// Draws the names of paths, in letters of the size `em`: inside of the frame, and as far as possible not on paths and
/// not on one another.
pub(crate) fn draw_labels<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    frame: [Point; 2],
    paths: &[Path<'_>],
    em: f64,
) -> Result<(), Box<dyn Error>>
where
    B::ErrorType: 'static,
{
    let unit = f64::from(px(1.0));
    let mut labels = Vec::new();
    for path in paths {
        if let (Some(name), Some(last)) = (path.name, path.points.last()) {
            let (width, _) = area.estimate_text_size(name, &text(em, path.color))?;
            labels.push(Label {
                name,
                color: path.color,
                from: *last,
                size: (f64::from(width) / unit, HEIGHT * em),
            });
        }
    }
    let obstacles: Vec<Point> = paths.iter().flat_map(|path| samples(&path.points)).collect();
    for (label, place) in labels.iter().zip(places(&labels, frame, &obstacles)) {
        label.draw(area, &place, em)?;
    }
    Ok(())
}

/// Points along a path.
fn samples(path: &[Point]) -> Vec<Point> {
    let between = |ends: &[Point]| {
        let ((x, y), (dx, dy)) = (ends[0], (ends[1].0 - ends[0].0, ends[1].1 - ends[0].1));
        let count = (dx.hypot(dy) / SAMPLES).ceil() as u32;
        (1..=count).map(move |n| {
            let part = f64::from(n) / f64::from(count);
            (x + part * dx, y + part * dy)
        })
    };
    path.first()
        .copied()
        .into_iter()
        .chain(path.windows(2).flat_map(between))
        .collect()
}

/// Seeks a place for each label: all take their best place in turns, until they stay. Each label once takes the first
/// turn, and the best result is kept.
fn places(labels: &[Label<'_>], frame: [Point; 2], obstacles: &[Point]) -> Vec<Place> {
    let alone = |n: usize, place: &Place| {
        let others = labels.iter().enumerate().filter(|&(m, _)| m != n);
        let nearer = others
            .filter(|(_, other)| place.gap(other.from) < place.distance + 4.0)
            .count();
        place.cost(frame, obstacles) + 25.0 * nearer as f64
    };
    let candidates = labels.iter().enumerate().map(|(n, label)| {
        let places = label.places().into_iter();
        places.map(|place| (place, alone(n, &place))).collect::<Vec<_>>()
    });
    let candidates: Vec<_> = candidates.collect();
    let taken = |first: usize| {
        let mut chosen: Vec<Option<(Place, f64)>> = vec![None; labels.len()];
        for turn in 0..ROUNDS * labels.len() {
            let n = (first + turn) % labels.len();
            let others = || {
                chosen
                    .iter()
                    .enumerate()
                    .filter(|&(m, _)| m != n)
                    .filter_map(|(_, other)| *other)
            };
            let conflict = |place: &Place| {
                let conflicts = others().map(|(other, _)| place.conflict(&other) + other.conflict(place));
                conflicts.sum::<f64>()
            };
            let places = candidates[n]
                .iter()
                .map(|&(place, alone)| (place, alone + conflict(&place)));
            chosen[n] = places.min_by(|a, b| a.1.total_cmp(&b.1));
        }
        let cost: f64 = chosen.iter().flatten().map(|(_, cost)| cost).sum();
        (chosen, cost)
    };
    let best = (0..labels.len()).map(taken).min_by(|a, b| a.1.total_cmp(&b.1));
    best.into_iter()
        .flat_map(|(chosen, _)| chosen)
        .flatten()
        .map(|(place, _)| place)
        .collect()
}

impl Label<'_> {
    /// Places around the point.
    fn places(&self) -> Vec<Place> {
        let mut places = Vec::new();
        for (n, distance) in DISTANCES.into_iter().enumerate() {
            for direction in 0..DIRECTIONS {
                let (sin, cos) = (TAU * direction as f64 / DIRECTIONS as f64).sin_cos();
                // the nearest point of the label is at the distance
                let (half, high) = (0.5 * self.size.0, 0.5 * self.size.1);
                let reach = distance + (half / cos.abs().max(1e-9)).min(high / sin.abs().max(1e-9));
                let (x, y) = (self.from.0 + cos * reach, self.from.1 + sin * reach);
                let end = (
                    self.from.0 + cos * (distance - 2.0),
                    self.from.1 + sin * (distance - 2.0),
                );
                places.push(Place {
                    x: [x - half, x + half],
                    y: [y - high, y + high],
                    line: (n > 0).then_some([self.from, end]),
                    distance,
                    rightward: cos,
                });
            }
        }
        places
    }

    fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        place: &Place,
        em: f64,
    ) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let color = self.color;
        if let Some(line) = place.line {
            let ends = line.map(|(x, y)| (px(x), px(y)));
            area.draw(&PathElement::new(ends, color.stroke_width(page_width(1.2))))?;
        }
        let corners = [(px(place.x[0]), px(place.y[0])), (px(place.x[1]), px(place.y[1]))];
        // covers the lines of the grid
        area.draw(&Rectangle::new(corners, WHITE.mix(0.75).filled()))?;
        let style = text(em, color).pos(Pos::new(HPos::Left, VPos::Center));
        area.draw_text(self.name, &style, (corners[0].0, px(0.5 * (place.y[0] + place.y[1]))))?;
        Ok(())
    }
}

impl Place {
    /// Cost of the place, whatever the other labels.
    fn cost(&self, [least, most]: [Point; 2], obstacles: &[Point]) -> f64 {
        let beyond = (least.0 + 4.0 - self.x[0]).max(self.x[1] - most.0 + 4.0).max(0.0)
            + (least.1 + 2.0 - self.y[0]).max(self.y[1] - most.1 + 2.0).max(0.0);
        let covered = obstacles.iter().filter(|&&point| self.covers(point, 4.0)).count();
        let crossed = self.line.map_or(0, |line| {
            let far = samples(&line).into_iter().skip(3);
            far.filter(|point| {
                obstacles
                    .iter()
                    .any(|other| (point.0 - other.0).hypot(point.1 - other.1) < SAMPLES)
            })
            .count()
        });
        1e4 * beyond + 20.0 * covered as f64 + 15.0 * crossed as f64 + 0.5 * self.distance - 4.0 * self.rightward
    }

    /// Cost of another label at its place beside this one.
    fn conflict(&self, other: &Self) -> f64 {
        let gap = 3.0;
        let overlap = |[a, b]: [f64; 2], [c, d]: [f64; 2]| (b.min(d) - a.max(c) + gap).max(0.0);
        let over = overlap(self.x, other.x).min(overlap(self.y, other.y));
        let crossed = other.line.map_or(0, |line| {
            let points = samples(&line);
            points.into_iter().filter(|&point| self.covers(point, 2.0)).count()
        });
        50.0 * over + 50.0 * crossed as f64
    }

    /// Distance of a point from the label.
    fn gap(&self, (x, y): Point) -> f64 {
        let across = (self.x[0] - x).max(x - self.x[1]).max(0.0);
        let along = (self.y[0] - y).max(y - self.y[1]).max(0.0);
        across.hypot(along)
    }

    fn covers(&self, (x, y): Point, margin: f64) -> bool {
        self.x[0] - margin < x && x < self.x[1] + margin && self.y[0] - margin < y && y < self.y[1] + margin
    }
}

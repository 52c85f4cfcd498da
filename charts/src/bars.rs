//! Horizontal bars, or dots on logarithmic axes, in rows and columns of panels.

use std::error::Error;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::page::{BLUE, GREY, GRID, INK, MARGIN, Picture, bold, px, text, width, write_line};
use crate::scale::Scale;

/// Panels of bars; all panels of a column share their axis. On a logarithmic axis dots replace the bars, as it has no
/// zero.
pub struct Bars {
    pub title: String,
    pub subtitle: String,
    /// Label of the axes: the quantity with its unit.
    pub axis: String,
    /// True for a logarithmic axis, false for a linear one from zero.
    pub logarithmic: bool,
    pub columns: Vec<String>,
    /// Caption, and the bars of the panel in each column.
    pub rows: Vec<(String, Vec<Vec<Bar>>)>,
}

pub struct Bar {
    pub label: String,
    /// Length of the bar; if not measured, a text replaces the bar.
    pub value: Option<f64>,
    /// True to highlight the bar.
    pub ours: bool,
}

// Lengths in pixels of the picture.
const WIDTH: u32 = 1280;
const HEAD: f64 = 190.0;
const CAPTION: f64 = 52.0;
const BAR: f64 = 30.0;
const GAP: f64 = 22.0;
const FOOTER: f64 = 70.0;
/// Width of the names.
const NAMES: f64 = 138.0;
/// Width of the number beside the longest bar.
const NUMBERS: f64 = 76.0;

const PALE: RGBColor = RGBColor(150, 156, 162);

impl Bars {
    fn height(&self) -> f64 {
        let rows: f64 = self.rows.iter().map(|row| row_height(&row.1)).sum();
        HEAD + rows + FOOTER + MARGIN
    }

    /// Left edge of a column's axis, and its length.
    fn axis(&self, column: usize) -> (f64, f64) {
        let wide = (f64::from(WIDTH) - 2.0 * MARGIN) / self.columns.len() as f64;
        (MARGIN + column as f64 * wide + NAMES, wide - NAMES - NUMBERS)
    }

    /// Scale that includes all bars of a column.
    fn scale(&self, column: usize) -> Scale {
        let values = || {
            self.rows
                .iter()
                .flat_map(|(_, panels)| &panels[column])
                .filter_map(|bar| bar.value)
        };
        if self.logarithmic {
            Scale::around(values())
        } else {
            Scale::Linear(values().fold(0.0, f64::max))
        }
    }

    fn column<B: DrawingBackend>(&self, column: usize, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let (left, length) = self.axis(column);
        let scale = self.scale(column);
        let x = |value: f64| left + length * scale.part(value);
        page.draw_text(&self.columns[column], &bold(25.0), (px(left - NAMES), px(HEAD - 46.0)))?;
        let (mut top, mut bottom) = (HEAD, HEAD);
        for (caption, panels) in &self.rows {
            let bars = &panels[column];
            if bars.is_empty() {
                top += row_height(panels);
                continue;
            }
            let (first, last) = (top + CAPTION, top + CAPTION + BAR * bars.len() as f64);
            let middle = Pos::new(HPos::Left, VPos::Center);
            page.draw_text(
                caption,
                &text(23.0, GREY).pos(middle),
                (px(left - NAMES), px(top + 0.62 * CAPTION)),
            )?;
            for (value, strong) in scale.ticks() {
                let line = GRID.stroke_width(width(if strong { 2.0 } else { 0.75 }));
                let x = px(x(value));
                page.draw(&PathElement::new(vec![(x, px(first - 3.0)), (x, px(last + 3.0))], line))?;
            }
            for (n, bar) in bars.iter().enumerate() {
                let y = first + BAR * (n as f64 + 0.5);
                let style = if bar.ours { bold(21.0) } else { text(21.0, INK) };
                let name = style.clone().pos(Pos::new(HPos::Right, VPos::Center));
                page.draw_text(&bar.label, &name, (px(left - 12.0), px(y)))?;
                let color = if bar.ours { BLUE } else { PALE };
                let Some(value) = bar.value else {
                    page.draw_text("not measured", &text(21.0, GREY).pos(middle), (px(left + 9.0), px(y)))?;
                    continue;
                };
                let (end, beside) = (x(value), if self.logarithmic { 16.0 } else { 9.0 });
                if self.logarithmic {
                    let line = GRID.stroke_width(width(2.0));
                    page.draw(&PathElement::new(vec![(px(left), px(y)), (px(end), px(y))], line))?;
                    page.draw(&Circle::new((px(end), px(y)), px(0.25 * BAR), color.filled()))?;
                } else {
                    let corners = [(px(left), px(y - 0.37 * BAR)), (px(end), px(y + 0.37 * BAR))];
                    page.draw(&Rectangle::new(corners, color.filled()))?;
                }
                let (number, style) = (short(value), style.pos(middle));
                let at = (px(end + beside), px(y));
                // covers the lines of the grid
                let wide = i32::try_from(page.estimate_text_size(&number, &style)?.0)?;
                let corners = [
                    (at.0 - px(3.0), px(y - 0.4 * BAR)),
                    (at.0 + wide + px(3.0), px(y + 0.4 * BAR)),
                ];
                page.draw(&Rectangle::new(corners, WHITE.filled()))?;
                page.draw_text(&number, &style, at)?;
            }
            top += row_height(panels);
            bottom = top;
        }
        let style = text(21.0, GREY).pos(Pos::new(HPos::Center, VPos::Center));
        for (value, _) in scale.ticks().into_iter().filter(|&(_, strong)| strong) {
            page.draw_text(&format!("{value}"), &style, (px(x(value)), px(bottom + 4.0)))?;
        }
        page.draw_text(&self.axis, &style, (px(left + 0.5 * length), px(bottom + 38.0)))?;
        Ok(())
    }
}

impl Picture for Bars {
    fn size(&self) -> (u32, u32) {
        (WIDTH, self.height().ceil() as u32)
    }

    fn draw<B: DrawingBackend>(&self, page: &DrawingArea<B, Shift>) -> Result<(), Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        page.fill(&WHITE)?;
        write_line(page, &self.title, &bold(32.0), (px(MARGIN), px(MARGIN)))?;
        write_line(page, &self.subtitle, &text(22.0, GREY), (px(MARGIN), px(MARGIN + 46.0)))?;
        for column in 0..self.columns.len() {
            self.column(column, page)?;
        }
        page.present()?;
        Ok(())
    }
}

/// Height of a row, determined by its fullest panel.
fn row_height(panels: &[Vec<Bar>]) -> f64 {
    CAPTION + GAP + BAR * panels.iter().map(Vec::len).max().unwrap_or(0) as f64
}

fn short(value: f64) -> String {
    if value < 100.0 {
        format!("{value:.1}")
    } else {
        format!("{value:.0}")
    }
}

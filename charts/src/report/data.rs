//! Data of charts, as `report.js` reads it.
//!
//! Coordinates are those of the axes: values, logarithms on `Decades`, negated ones on `Falling`.

use serde_json::{Value, json};

use crate::chart::{Axis, Curve, Figure, Line, Marker, Scale, Stroke};
use crate::heat::{Atlas, Map};
use crate::page::RGBColor;

/// A chart that a report can show.
pub trait Chart {
    /// Title and subtitle.
    fn head(&self) -> (&str, &str);

    /// Legend, lines and panels.
    fn data(&self) -> Value;
}

impl Chart for Figure {
    fn head(&self) -> (&str, &str) {
        (&self.title, &self.subtitle)
    }

    fn data(&self) -> Value {
        let of_rows = self.rows.iter().flat_map(|row| &row.legend);
        let mut key = Key::new(self.legend.iter().chain(of_rows));
        let mut panels = Vec::new();
        for row in &self.rows {
            for (curves, column) in row.panels.iter().zip(&self.columns) {
                panels.push(json!({
                    "title": row.title(column),
                    "aspect": self.aspect(),
                    "x": axis(&column.x),
                    "y": axis(&column.y),
                    "curves": key.curves(curves),
                }));
            }
        }
        key.chart(self.columns.len(), panels)
    }
}

impl Chart for Atlas {
    fn head(&self) -> (&str, &str) {
        (&self.title, &self.subtitle)
    }

    fn data(&self) -> Value {
        let mut key = Key::new(&self.legend);
        let panel = |map: &Map| {
            json!({
                "title": map.colors.label,
                "aspect": 1.0,
                "x": axis(&map.x),
                "y": axis(&map.y),
                "curves": key.curves(&map.curves),
                "map": cells(map),
            })
        };
        let panels = self.maps.iter().map(panel).collect();
        key.chart(self.columns, panels)
    }
}

/// Legend and lines of a chart, to which its curves refer.
struct Key {
    /// Name and line of each entry, and true if it has curves.
    legend: Vec<(String, Line, bool)>,
    /// Number of entries that the chart has itself.
    own: usize,
    lines: Vec<Value>,
}

impl Key {
    fn new<'l>(legend: impl IntoIterator<Item = &'l (Line, String)>) -> Self {
        let entries = legend.into_iter().map(|(line, name)| (name.clone(), *line, false));
        let legend: Vec<_> = entries.collect();
        Self {
            own: legend.len(),
            legend,
            lines: Vec::new(),
        }
    }

    fn curves(&mut self, curves: &[Curve]) -> Vec<Value> {
        curves.iter().map(|curve| self.curve(curve)).collect()
    }

    fn curve(&mut self, curve: &Curve) -> Value {
        let entry = self.entry(curve);
        if let Some(entry) = entry {
            self.legend[entry].2 = true;
        }
        let of_entry = entry.map(|entry| &self.legend[entry].0);
        let name = curve.name.as_ref().or(curve.label.as_ref()).or(of_entry).cloned();
        let points = curve.points.iter().map(|&(x, y)| json!([short(x, 7), short(y, 7)]));
        let points: Vec<Value> = points.collect();
        let line = self.line(curve.line);
        json!({
            "name": name,
            "label": curve.label,
            "entry": entry,
            "line": line,
            "points": points,
            "notes": curve.notes,
        })
    }

    /// Entry of a curve in the legend: that of its name, or else of its line. Others are added, but for single points,
    /// which have their labels beside them.
    fn entry(&mut self, curve: &Curve) -> Option<usize> {
        let name = curve.name.as_ref().or(curve.label.as_ref());
        let of_name = self.legend.iter().position(|(own, ..)| Some(own) == name);
        let mut own = self.legend[..self.own].iter();
        let found = of_name.or_else(|| own.position(|(_, line, _)| looks_alike(*line, curve.line)));
        match name {
            Some(name) if found.is_none() && curve.points.len() > 1 => {
                self.legend.push((name.clone(), curve.line, false));
                Some(self.legend.len() - 1)
            }
            _ => found,
        }
    }

    /// Index of a line.
    fn line(&mut self, line: Line) -> usize {
        let value = line_data(line);
        self.lines.iter().position(|own| *own == value).unwrap_or_else(|| {
            self.lines.push(value);
            self.lines.len() - 1
        })
    }

    fn chart(mut self, columns: usize, panels: Vec<Value>) -> Value {
        let mut legend = Vec::new();
        for (name, line, has_curves) in std::mem::take(&mut self.legend) {
            legend.push(json!({ "name": name, "line": self.line(line), "curves": has_curves }));
        }
        json!({ "columns": columns, "legend": legend, "lines": self.lines, "panels": panels })
    }
}

/// True for lines of one entry of a legend, which may differ in their width.
fn looks_alike(one: Line, other: Line) -> bool {
    let width = other.width;
    line_data(Line { width, ..one }) == line_data(other)
}

fn line_data(line: Line) -> Value {
    let stroke = match line.stroke {
        Stroke::Solid => "solid",
        Stroke::Dashed => "dashed",
        Stroke::Dots => "dots",
        Stroke::Area => "area",
    };
    let corners = |marker: Marker| -> Vec<Value> {
        let corners = marker.corners().into_iter();
        corners.map(|(x, y)| json!([short(x, 3), short(y, 3)])).collect()
    };
    json!({ "color": color(line.color), "width": line.width, "stroke": stroke, "marker": line.marker.map(corners) })
}

fn axis(axis: &Axis) -> Value {
    let scale = match axis.scale {
        Scale::Linear => "linear",
        Scale::Decades => "decades",
        Scale::Falling => "falling",
    };
    let ticks: Vec<Value> = axis
        .marks()
        .into_iter()
        .map(|mark| json!([mark, axis.tick(mark)]))
        .collect();
    json!({ "label": axis.label, "scale": scale, "range": [axis.range.start, axis.range.end], "ticks": ticks })
}

/// Cells of a map, with the colour of each step of the numbers.
fn cells(map: &Map) -> Value {
    let range = &map.colors.range;
    let height = (range.end - range.start) / map.steps as f64;
    let middles = (0..map.steps).map(|n| range.start + height * (n as f64 + 0.5));
    let table: Vec<String> = middles.map(|middle| color(map.color(middle))).collect();
    json!({
        "axis": axis(&map.colors),
        "colors": table,
        "missing": color(map.color(f64::NAN)),
        "across": map.across,
        "cells": base64(map.cells.iter().flat_map(|&cell| (cell as f32).to_le_bytes())),
    })
}

fn color(RGBColor(r, g, b): RGBColor) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// A number to some significant digits; null if it is not finite.
fn short(value: f64, digits: usize) -> Value {
    format!("{value:.*e}", digits - 1)
        .parse::<f64>()
        .map_or(Value::Null, |value| {
            if value.fract() == 0.0 && value.abs() < 1e9 {
                json!(value as i64)
            } else {
                json!(value)
            }
        })
}

/// Bytes in base64: cells are too many for numbers in digits.
fn base64(bytes: impl Iterator<Item = u8>) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let bytes: Vec<u8> = bytes.collect();
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let bits = three.iter().fold(0, |bits, &byte| bits << 8 | u32::from(byte)) << (8 * (3 - three.len()));
        for n in 0..4 {
            let digit = DIGITS[(bits >> (18 - 6 * n) & 63) as usize];
            text.push(if n <= three.len() { char::from(digit) } else { '=' });
        }
    }
    text
}

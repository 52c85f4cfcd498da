//! Writes a small report with lines of all kinds and a map.
//!
//! `cargo run -p charts --example report -- [STEM]` writes `STEM.html`, by default `out/report.html`. The tests of
//! reports in a browser, in `web/test`, open it.

use std::error::Error;
use std::path::Path;

use charts::chart::{Axis, Column, Curve, Figure, Line, Marker, Row, Scale, Stroke};
use charts::heat::{Atlas, Map, Palette};
use charts::page::{BLUE, GREY, GRID, INK, VERMILION};
use charts::report::Report;

fn main() -> Result<(), Box<dyn Error>> {
    let stem = std::env::args().nth(1).unwrap_or_else(|| "out/report".to_owned());
    let report = Report::new("A report")
        .text("Hover, tap, or use the arrow keys; `<script>` is text.")
        .chart(&figure())
        .heading("A table & a listing")
        .table("| method | order |\n|---|---|\n| `Slow` | 4 |\n| `Fast` | 8 |")
        .listing("steps  < 10\nsteps  > 10")
        .chart(&atlas());
    println!("{}", report.save(Path::new(&stem))?.display());
    Ok(())
}

/// Two methods over their errors, and motions over time.
fn figure() -> Figure {
    let tolerances: Vec<i32> = (3..=12).collect();
    let method = |name: &str, line: Line, start: f64, slope: f64| Curve {
        label: Some(name.to_owned()),
        notes: tolerances.iter().map(|n| format!("tolerance 1e-{n}")).collect(),
        ..Curve::new(
            line,
            tolerances
                .iter()
                .map(|&n| (f64::from(n), start + slope * f64::from(n)))
                .collect(),
        )
    };
    let unknown = Curve::new(
        Line::area(GRID),
        vec![(11.0, 0.0), (13.0, 0.0), (13.0, 4.0), (11.0, 4.0)],
    );
    let methods = vec![
        unknown,
        method("Slow", Line::solid(VERMILION).marked(Marker::Up), 0.25, 0.25),
        method("Fast & </script>", Line::dashed(INK).marked(Marker::Cross), 0.5, 0.125),
    ];
    let times = (0..=200).map(|n| 0.05 * f64::from(n));
    let swing = |phase: f64| {
        times
            .clone()
            .map(|t| (t, (t + phase).sin() * (-0.1 * t).exp()))
            .collect()
    };
    let dots = Line {
        stroke: Stroke::Dots,
        ..Line::solid(BLUE)
    };
    let motions = vec![
        Curve::new(dots, swing(0.0)),
        Curve::new(Line::solid(GREY), swing(1.0)),
        Curve {
            label: Some("start".to_owned()),
            ..Curve::new(Line::solid(INK).marked(Marker::Circle), vec![(0.0, 0.0)])
        },
    ];
    Figure {
        title: "Lines & marks".to_owned(),
        subtitle: "Errors < 1 on a falling axis, and motions".to_owned(),
        size: (1600, 800),
        legend: vec![
            (Line::area(GRID), "within the uncertainty".to_owned()),
            (dots, "measured".to_owned()),
            (Line::solid(GREY), "computed".to_owned()),
            (Line::dashed(INK), "implicit methods".to_owned()),
        ],
        columns: vec![
            Column::new(
                "cost",
                Axis {
                    scale: Scale::Falling,
                    ..Axis::decades("error (rad)", 2.0..13.0)
                },
                Axis::decades("time (µs)", 0.0..4.0),
            ),
            Column::new(
                "motion",
                Axis::linear("t (s)", 0.0..10.0),
                Axis::linear("angle (rad)", -1.0..1.0),
            ),
        ],
        rows: vec![Row::new(vec![methods, motions])],
    }
}

/// A map whose upper right corner is missing, with a line on top.
fn atlas() -> Atlas {
    let side: u32 = 40;
    let along = |n: u32| (f64::from(n) + 0.5) / f64::from(side);
    let cell = |n: u32| {
        let (x, y) = (along(n % side), along(n / side));
        if x + y > 1.8 { f64::NAN } else { 3.0 * x * y * y - 2.0 }
    };
    let diagonal = Line::dashed(INK);
    Atlas {
        title: "Cells".to_owned(),
        subtitle: "A product of powers of two numbers".to_owned(),
        legend: vec![(diagonal, "diagonal".to_owned())],
        columns: 2,
        maps: vec![Map {
            x: Axis::linear("x (m)", 0.0..1.0),
            y: Axis::linear("y (m)", 0.0..1.0),
            colors: Axis::decades("product (m³)", -2.0..1.0),
            palette: Palette::Rising,
            steps: 30,
            cells: (0..side * side).map(cell).collect(),
            across: side as usize,
            curves: vec![Curve::new(diagonal, vec![(0.0, 0.0), (1.0, 1.0)])],
        }],
    }
}

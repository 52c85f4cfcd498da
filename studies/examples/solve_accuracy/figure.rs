//! Errors over the mass ratio, compared with the bound by the conditioning.

use crate::{Run, Worst};
use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, GREEN, PURPLE, VERMILION};

/// Range of the error axis, in powers of ten; an exact value is drawn at the bottom.
const DECADES: [f64; 2] = [-17.0, -5.0];

/// Rows of runs: two coordinates, three coordinates, and textbook methods.
pub(crate) fn figure(runs: &[Run], textbook: &[Run]) -> Result<Figure, String> {
    let named = |names: &[(&str, &str)]| {
        let find = |(name, title): &(&str, &str)| {
            let run = runs.iter().find(|run| run.name == *name);
            Ok((run.ok_or_else(|| format!("no scene {name}"))?, (*title).to_owned()))
        };
        names.iter().map(find).collect::<Result<Vec<_>, String>>()
    };
    let axis = |label: &str, range| Axis {
        ticks: 9,
        ..Axis::decades(label, range)
    };
    let errors = |states: &str| {
        Column::new(
            states,
            axis("mass of one body over its usual mass", -8.0..8.0),
            axis("relative error", DECADES[0]..DECADES[1]),
        )
    };
    let textbook: Vec<_> = textbook.iter().map(|run| (run, run.name.clone())).collect();
    Ok(Figure {
        title: "Error of the accelerations over the ratio of masses".to_owned(),
        subtitle: "Largest over the states of a scene, relative to the largest acceleration, against 50-digit values; \
                   an error of 0 is drawn at the bottom"
            .to_owned(),
        size: (1600, 1600),
        legend: vec![
            (Line::solid(BLUE), "error".to_owned()),
            (
                Line::solid(BLUE).lighter(),
                "explained by the condition: ε (1 + κ)".to_owned(),
            ),
        ],
        columns: vec![errors("condition κ below 100"), errors("condition κ above 100")],
        rows: vec![
            row(
                "Two coordinates",
                &named(&[
                    ("points", "points"),
                    ("points_relative", "in joint angles"),
                    ("plates_slight", "slight plates"),
                    ("cart", "pole on a cart"),
                ])?,
            ),
            row(
                "Three coordinates",
                &named(&[
                    ("chain_last", "chain, last point"),
                    ("chain_middle", "chain, middle point"),
                    ("arm", "spatial arm, last rod"),
                ])?,
            ),
            row("Points", &textbook),
        ],
    })
}

fn row(caption: &str, runs: &[(&Run, String)]) -> Row {
    let lines = [BLUE, VERMILION, GREEN, PURPLE].map(Line::solid);
    let panel = |kind: usize| {
        let each = || runs.iter().zip(lines).map(|((run, _), line)| (&run.kinds[kind], line));
        let bounds = each()
            .rev()
            .map(|(worst, line)| curve(worst, line.lighter(), |worst| worst.bound));
        let errors = each().map(|(worst, line)| curve(worst, line, |worst| worst.error));
        bounds.chain(errors).collect()
    };
    Row {
        caption: caption.to_owned(),
        legend: lines
            .into_iter()
            .zip(runs.iter().map(|(_, title)| title.clone()))
            .collect(),
        panels: vec![panel(0), panel(1)],
    }
}

fn curve(worst: &[Worst], line: Line, value: fn(&Worst) -> f64) -> Curve {
    let [least, most] = DECADES;
    let point = |worst: &Worst| (worst.ratio.log10(), value(worst).log10().clamp(least, most));
    Curve::new(line, worst.iter().map(point).collect())
}

//! The errors over the mass ratio, beside what the condition explains.

use crate::{Run, Worst};
use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Scale};
use charts::page::{BLUE, GREEN, PURPLE, VERMILION};

/// What is drawn of the errors: an exact value stands at the bottom.
const DECADES: [f64; 2] = [-17.0, -5.0];

/// Rows of runs: two coordinates, three coordinates, and the textbook's ways.
pub(crate) fn figure(runs: &[Run], textbook: &[Run]) -> Result<Figure, String> {
    let named = |names: &[(&str, &str)]| {
        let find = |(name, title): &(&str, &str)| {
            let run = runs.iter().find(|run| run.name == *name);
            Ok((run.ok_or_else(|| format!("no scene {name}"))?, (*title).to_owned()))
        };
        names.iter().map(find).collect::<Result<Vec<_>, String>>()
    };
    let axis = |label: &str, range, ticks| Axis {
        label: label.to_owned(),
        scale: Scale::Decades,
        range,
        ticks,
    };
    let errors = |states: &str| Column {
        x: axis("mass of one body over its usual mass", -8.0..8.0, 9),
        y: axis(&format!("error, {states}"), DECADES[0]..DECADES[1], 8),
    };
    let textbook: Vec<_> = textbook.iter().map(|run| (run, run.name.clone())).collect();
    Ok(Figure {
        title: "Error of the accelerations over the ratio of masses".to_owned(),
        subtitle: "Largest over the states of a scene, in units of the largest acceleration, against 50-digit values; \
                   steady states have a condition κ below 100"
            .to_owned(),
        size: (1600, 1560),
        legend: vec![
            (Line::solid(BLUE), "error".to_owned()),
            (
                Line::solid(BLUE).lighter(),
                "what the condition explains: ε (1 + κ)".to_owned(),
            ),
        ],
        columns: vec![errors("steady states"), errors("sensitive states")],
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
    Curve {
        line,
        points: worst.iter().map(point).collect(),
        label: None,
    }
}

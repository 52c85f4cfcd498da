//! Output of the results as `lanes.md`, `lanes.json` and a chart.

use std::error::Error;
use std::path::{Path, PathBuf};

use super::{COUNT, Results, Row, START};
use crate::report::{list, number, table, write};
use charts::bars::{Bar, Bars};
use charts::page::Picture;

pub(crate) fn all(results: &Results, out: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let text = markdown(results);
    println!("\n{text}");
    let mut files = vec![
        write(out.join("lanes.md"), &text)?,
        write(out.join("lanes.json"), &serde_json::to_string_pretty(results)?)?,
    ];
    files.extend(chart(results).save(&out.join("lanes"))?);
    Ok(files)
}

fn markdown(results: &Results) -> String {
    let mut text = format!("# Many trajectories on one core\n\n{}\n", list(&results.header));
    if !results.notes.is_empty() {
        text += &format!("Left out:\n\n{}\n", list(&results.notes));
    }
    text += &format!(
        "RK4, h = 0.01, 1000 steps of the double pendulum with m = I = c = d = 1, g = 9.8 and no friction, \
         from {START:?}; \
         {COUNT} trajectories, one core.\n\n"
    );
    let head = [
        "by",
        "numbers",
        "million steps a second, most",
        "median",
        "over one at a time, median",
        "of the most",
        "difference of the end",
    ];
    text + &table(&head, 2, &results.rows.iter().map(cells).collect::<Vec<_>>())
}

fn cells(row: &Row) -> Vec<String> {
    vec![
        row.side.clone(),
        row.number.to_owned(),
        number(Some(row.most)),
        number(Some(row.median)),
        number(Some(row.ratio)),
        number(Some(row.ratio_of_most)),
        if row.difference == 0.0 {
            "0".to_owned()
        } else {
            format!("{:.0e}", row.difference)
        },
    ]
}

/// Short label beside a bar, such as "C++, 1 ulp".
fn label(row: &Row) -> String {
    let parts: Vec<&str> = row.side.split(", ").take(2).collect();
    parts.join(", ").replace("SLEEF to ", "")
}

fn chart(results: &Results) -> Bars {
    let numbers = ["f64", "f32"];
    let panel = |number| {
        let rows = results.rows.iter().filter(|row| row.number == number && !row.slower);
        let bar = |row: &Row| Bar {
            label: label(row),
            value: Some(row.most),
            ours: !row.side.starts_with("C++"),
        };
        rows.map(bar).collect()
    };
    Bars {
        title: "Trajectories in lanes: RK4 on the double pendulum".to_owned(),
        subtitle: "On one core; C++: AVX-512 intrinsics, and SLEEF's sines to 1 and 3.5 ulp".to_owned(),
        axis: "steps per second (millions)".to_owned(),
        logarithmic: false,
        columns: numbers.map(str::to_owned).into(),
        rows: vec![("Double pendulum".to_owned(), numbers.map(panel).into())],
    }
}

//! Cases in which methods fail: predictions, observations, and the methods that survive.
//!
//! `cargo run --release -p studies --example where_methods_fail` runs the cases of the test of the same name, prints
//! them as a table, and draws regions of stability, the energy over time, steps over friction, and the horizon of
//! prediction. A page with all of them shows values where the pointer hovers. It takes half a minute.

mod figures;
mod regions;
mod table;

use std::error::Error;
use std::path::Path;

use charts::page::Picture;
use charts::report::Report;
use testbed::where_methods_fail;
use testbed::where_methods_fail::row::{Row, Size};

const OUT: &str = "out/where_methods_fail";

fn main() -> Result<(), Box<dyn Error>> {
    let rows: Vec<Row> = where_methods_fail::ALL.iter().map(|row| row(Size::Full)).collect();
    println!("{}", table::text(&rows));
    println!("{}", table::markdown(&rows));

    let folder = Path::new(OUT);
    let charts = [
        ("regions", regions::figure()?),
        ("energy", figures::energy()),
        ("friction", figures::friction()),
        ("horizon", figures::horizon()?),
    ];
    let mut report = Report::new("Where methods fail").text(
        "Each failure is first predicted, from the coefficients of the method or from the generated Jacobian, and then \
        observed.",
    );
    let mut files = Vec::new();
    for (stem, figure) in &charts {
        files.extend(figure.save(&folder.join(stem))?);
        report = report.chart(figure);
    }
    let report = report.heading("All cases").listing(&table::text(&rows));
    files.push(report.save(&folder.join("index"))?);
    for path in files {
        println!("{}", path.display());
    }
    let broken: Vec<&str> = rows.iter().filter(|row| !row.holds()).map(|row| row.case).collect();
    if broken.is_empty() {
        Ok(())
    } else {
        Err(format!("predictions that do not hold: {broken:?}").into())
    }
}

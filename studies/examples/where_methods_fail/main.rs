//! Cases in which methods fail: predictions, observations, and the methods that survive.
//!
//! `cargo run --release -p studies --example where_methods_fail` runs the cases of the test of the same name, prints
//! them as a table, and draws regions of stability, the energy over time, steps over friction, and the horizon of
//! prediction. It takes half a minute.

mod figures;
mod regions;
mod table;

use std::error::Error;
use std::fs;
use std::path::Path;

use charts::page::Picture;
use testbed::where_methods_fail;
use testbed::where_methods_fail::row::{Row, Size};

const OUT: &str = "out/where_methods_fail";

fn main() -> Result<(), Box<dyn Error>> {
    let rows: Vec<Row> = where_methods_fail::ALL.iter().map(|row| row(Size::Full)).collect();
    println!("{}", table::text(&rows));
    println!("{}", table::markdown(&rows));

    let folder = Path::new(OUT);
    let mut files = Vec::new();
    for (stem, figure) in [
        ("regions", regions::figure()?),
        ("energy", figures::energy()),
        ("friction", figures::friction()),
        ("horizon", figures::horizon()?),
    ] {
        files.extend(figure.save(&folder.join(stem))?);
    }
    let page = folder.join("table.txt");
    fs::write(&page, table::text(&rows)).map_err(|error| format!("cannot write {}: {error}", page.display()))?;
    files.push(page);
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

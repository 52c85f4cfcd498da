//! Page with all charts and tables.

use charts::chart::Figure;
use charts::report::Report;

use testbed::work::Measurement;

use crate::scenes::Scene;
use crate::simpler::Simpler;

/// Writes the page around the charts, which have their file names and the text above them.
pub(crate) fn page(
    charts: &[(&str, &str, Figure)],
    scenes: &[(&Scene, Measurement)],
    simpler: &Simpler,
    table: &str,
) -> Report {
    let mut page = Report::new("Accuracy against speed").text(
        "Times are the shortest of many rounds, for one trajectory of which only the end is kept, all methods in turns \
        on one core. Errors are those of the largest component of the state. Runs that failed have no dot; the lists \
        below say why. Errors below 1e-17 are drawn at the edge.",
    );
    for (_, text, chart) in charts {
        page = page.text(text).chart(chart);
    }
    page = page.heading("Time to reach an error");
    for block in table.split("\n\n") {
        page = if block.starts_with('|') {
            page.table(block)
        } else {
            page.text(block)
        };
    }
    page = page.heading("Simpler models").listing(&simpler.to_string());
    for (scene, measurement) in scenes {
        let heading = format!("All settings: {}", scene.title);
        page = page.heading(&heading).listing(&measurement.report.to_string());
    }
    page
}

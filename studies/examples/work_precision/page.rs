//! Page with all charts and tables.

use charts::chart::Figure;
use charts::report::Report;

use crate::methods::Measurement;
use crate::scenes::Scene;
use crate::simpler::Simpler;

/// Text above each chart.
const TEXTS: [(&str, &str); 5] = [
    (
        "methods",
        "Operations are the additions and multiplications of the model and of the method, counted one by one: those of \
        power series and of linear systems, too. The control of the step size is not counted.",
    ),
    (
        "lanes",
        "With AVX-512 eight trajectories share a register, with AVX2 four. Each takes its own steps, and ends bit for \
        bit where it ends alone.",
    ),
    (
        "dense_and_energy",
        "Methods differ in their accuracy between the steps: the dense output of `Vern9` stops at 1e-13, because its \
        weights are large and of both signs. The energy of the small swing is a small difference of large numbers: \
        rounding stops it at 1e-12.",
    ),
    (
        "stiff",
        "Friction forces short steps on explicit methods, whatever the tolerance. `Auto` notices and switches to an \
        implicit method.",
    ),
    (
        "simpler_models",
        "Where the linear model is good enough, the state at any time is one product with a matrix: nanoseconds \
        instead of microseconds. Leaving out friction saves no time.",
    ),
];

/// Writes the page around the charts, which have their file names.
pub(crate) fn page(
    charts: &[(&str, Figure)],
    scenes: &[(&Scene, Measurement)],
    simpler: &Simpler,
    table: &str,
) -> Report {
    let mut page = Report::new("Accuracy against speed").text(
        "Times are the shortest of many rounds, for one trajectory of which only the end is kept, all methods in turns \
        on one core. Errors are those of the largest component of the state. Runs that failed have no dot; the lists \
        below say why. Errors below 1e-17 are drawn at the edge.",
    );
    for (stem, chart) in charts {
        for (_, text) in TEXTS.iter().filter(|(of, _)| of == stem) {
            page = page.text(text);
        }
        page = page.chart(chart);
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

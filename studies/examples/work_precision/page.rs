//! HTML page with all charts and tables.

use crate::methods::Measurement;
use crate::scenes::Scene;
use crate::simpler::Simpler;

const STYLE: &str = "body { font: 17px/1.5 Inter, Helvetica, Arial, sans-serif; color: #222; max-width: 1200px; \
margin: 2em auto; padding: 0 1em } \
                     img { width: 100%; border: 1px solid #ddd } td { padding-right: 1em } pre { font-size: 13px; \
                     line-height: 1.35; overflow-x: auto; background: #f6f6f6; padding: 1em }";

/// Formats the page, which links to the pictures beside it.
pub(crate) fn page(scenes: &[(&Scene, Measurement)], simpler: &Simpler, table: &str) -> String {
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Accuracy against \
        speed</title>\n<style>{STYLE}</style>\n\
         <h1>Accuracy against speed</h1>\n\
         <p>Times are the shortest of many rounds, for one trajectory of which only the end is kept, all methods in \
         turns on one core. Errors are those of the \
         largest component of the state. Runs that failed have no dot; the lists below say why. Errors below 1e-17 \
         are drawn at the edge.</p>\n"
    );
    for (stem, text) in [
        (
            "methods",
            "Operations are the additions and multiplications of the model and of the method, counted one by one: \
            those of power series and of linear systems, too. The control of the step size is not counted.",
        ),
        (
            "lanes",
            "With AVX-512 eight trajectories share a register, with AVX2 four. Each takes its own steps, and ends bit \
            for bit where it ends alone.",
        ),
        (
            "dense_and_energy",
            "Methods differ in their accuracy between the steps: the dense output of <code>Vern9</code> stops at \
            1e-13, because its weights are large and of both signs. \
             The energy of the small swing is a small difference of large numbers: rounding stops it at 1e-12.",
        ),
        (
            "stiff",
            "Friction forces short steps on explicit methods, whatever the tolerance. <code>Auto</code> notices and \
            switches to an implicit method.",
        ),
        (
            "simpler_models",
            "Where the linear model is good enough, the state at any time is one product with a matrix: nanoseconds \
            instead of microseconds. Leaving out friction saves no time.",
        ),
    ] {
        page += &format!("<p>{text}</p>\n<img src=\"{stem}.svg\" alt=\"{stem}\">\n");
    }
    page += &format!("<h2>Time to reach an error</h2>\n{}", tables(table));
    page += &format!(
        "<h2>Simpler models</h2>\n<pre>{}</pre>\n",
        escaped(&simpler.to_string())
    );
    for (scene, measurement) in scenes {
        page += &format!(
            "<h2>All settings: {}</h2>\n<pre>{}</pre>\n",
            scene.title,
            escaped(&measurement.report.to_string())
        );
    }
    page
}

/// Converts the tables of a Markdown text, and the text between them, to HTML.
fn tables(markdown: &str) -> String {
    let mut html = String::new();
    for block in markdown.split("\n\n") {
        let rows = block.lines().filter(|line| !line.starts_with("|---"));
        let row = |line: &str| match line.strip_prefix('|') {
            Some(cells) => format!("<tr><td>{}</tr>\n", cells.trim_end_matches('|').replace('|', "<td>")),
            None => format!("<tr><td>{line}</tr>\n"),
        };
        html += &format!("<table>\n{}</table>\n", rows.map(row).collect::<String>());
    }
    html
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

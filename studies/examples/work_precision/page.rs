//! The page with all charts and tables.

use pendulum_core::accuracy::Report;

use crate::scenes::Scene;
use crate::simpler::Simpler;

const STYLE: &str = "body { font: 17px/1.5 Inter, Helvetica, Arial, sans-serif; color: #222; max-width: 1200px; margin: 2em auto; padding: 0 1em } \
                     img { width: 100%; border: 1px solid #ddd } td { padding-right: 1em } pre { font-size: 13px; line-height: 1.35; overflow-x: auto; background: #f6f6f6; padding: 1em }";

/// As HTML, with the pictures beside it.
pub(crate) fn page(reports: &[(&Scene, Report)], simpler: &Simpler, table: &str) -> String {
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Accuracy against speed</title>\n<style>{STYLE}</style>\n\
         <h1>Accuracy against speed</h1>\n\
         <p>Times are the least of many, for one trajectory without a record, all methods in turns on one core. Errors are of the largest component of the state. \
         A setting that did not come to its end has no dot, and the lists below tell why; errors below 1e-14 stand at the border.</p>\n"
    );
    for (stem, text) in [
        (
            "methods",
            "An evaluation of <code>Taylor</code> is a whole power series, and implicit methods solve equations beside their evaluations: \
             the left charts tell what that takes.",
        ),
        (
            "lanes",
            "With AVX-512 eight trajectories share a register, with AVX2 four. Each has steps of its own, and the bits that it has alone.",
        ),
        (
            "dense_and_energy",
            "Methods differ in what lies between their steps: the dense output of <code>Vern9</code> ends at 1e-13, where its large weights of both signs round. \
             The energy of the small swing is a small difference of large numbers, whose rounding is the wall at 1e-12.",
        ),
        (
            "stiff",
            "Explicit methods take steps as short as the friction asks for, whatever the tolerance. <code>Auto</code> notices and changes over.",
        ),
        (
            "simpler_models",
            "Where the linear model is good enough, a state at any time is one product with a matrix: nanoseconds in place of microseconds. Leaving friction out saves hardly any time.",
        ),
    ] {
        page += &format!("<p>{text}</p>\n<img src=\"{stem}.svg\" alt=\"{stem}\">\n");
    }
    page += &format!("<h2>Time to reach an error</h2>\n{}", tables(table));
    page += &format!(
        "<h2>Simpler models</h2>\n<pre>{}</pre>\n",
        escaped(&simpler.to_string())
    );
    for (scene, report) in reports {
        page += &format!(
            "<h2>All settings, {}</h2>\n<pre>{}</pre>\n",
            scene.title,
            escaped(&report.to_string())
        );
    }
    page
}

/// The tables of a Markdown text, and what stands between them.
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

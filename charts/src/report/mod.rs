//! Reports: pages in the style of the page in `web`, on whose charts hovering, a tap or the arrow keys show values.
//!
//! A page is one file, which loads nothing else. It carries the data of its charts, and `report.js` draws
//! them in the size and the colours of the screen.

mod data;

use std::error::Error;
use std::path::{Path, PathBuf};

use serde_json::Value;

pub use self::data::Chart;
use crate::page::write;

/// Headings, text, tables and charts, in the order in which they are added.
pub struct Report {
    title: String,
    body: String,
    charts: Vec<Value>,
}

impl Report {
    pub fn new(title: &str) -> Self {
        Self {
            title: title.to_owned(),
            body: String::new(),
            charts: Vec::new(),
        }
    }

    #[must_use]
    pub fn heading(self, text: &str) -> Self {
        self.with(&format!("<h2>{}</h2>", escaped(text)))
    }

    /// Adds a paragraph.
    #[must_use]
    pub fn text(self, text: &str) -> Self {
        self.with(&format!("<p>{}</p>", with_code(text)))
    }

    /// Adds a table in Markdown: a row of headings, a rule, and rows of cells.
    #[must_use]
    pub fn table(self, markdown: &str) -> Self {
        let row = |line: &str, tag: &str| {
            let cells = line.trim_start_matches('|').trim_end_matches('|').split('|');
            let cells: String = cells
                .map(|cell| format!("<{tag}>{}</{tag}>", with_code(cell.trim())))
                .collect();
            format!("<tr>{cells}</tr>\n")
        };
        let rows: String = markdown
            .lines()
            .enumerate()
            .filter(|&(n, _)| n != 1)
            .map(|(n, line)| row(line, if n == 0 { "th" } else { "td" }))
            .collect();
        self.with(&format!("<div class=\"wide\"><table>\n{rows}</table></div>"))
    }

    /// Adds text that is laid out by spaces.
    #[must_use]
    pub fn listing(self, text: &str) -> Self {
        self.with(&format!("<pre class=\"wide\" tabindex=\"0\">{}</pre>", escaped(text)))
    }

    #[must_use]
    pub fn chart(mut self, chart: &impl Chart) -> Self {
        let (title, subtitle) = chart.head();
        self.charts.push(chart.data());
        let (title, subtitle) = (escaped(title), escaped(subtitle));
        self.with(&format!(
            "<section class=\"chart\">\n<h2>{title}</h2>\n<p>{subtitle}</p>\n</section>"
        ))
    }

    /// Writes `stem` with the extension html, and returns its path.
    pub fn save(&self, stem: &Path) -> Result<PathBuf, Box<dyn Error>> {
        write(stem, "html", self.html().as_bytes())
    }

    pub fn html(&self) -> String {
        // A `<` in a string would end the script, if `/script>` follows.
        let data = Value::from_iter(self.charts.iter().cloned())
            .to_string()
            .replace('<', "\\u003c");
        let (title, body) = (escaped(&self.title), &self.body);
        format!(
            "<!doctype html>
<html lang=\"en\">
<head>
<meta charset=\"utf-8\" />
<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />
<title>{title}</title>
<link rel=\"icon\" href=\"data:,\" />
<style>
{LOOK}{STYLE}</style>
</head>
<body>
<header><h1>{title}</h1></header>
<main>
{body}<p id=\"said\" aria-live=\"polite\"></p>
<noscript>The charts of this page need JavaScript; the pictures beside it show the same.</noscript>
</main>
<script id=\"charts\" type=\"application/json\">{data}</script>
<script type=\"module\">
{SCRIPT}</script>
</body>
</html>
"
        )
    }

    fn with(mut self, html: &str) -> Self {
        self.body += html;
        self.body += "\n";
        self
    }
}

/// Colours, fonts and controls of all pages.
const LOOK: &str = include_str!("../../../web/page/look.css");
const STYLE: &str = include_str!("report.css");
const SCRIPT: &str = include_str!("report.js");

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

/// Converts text with code between backticks to HTML.
fn with_code(text: &str) -> String {
    let parts = text.split('`').enumerate();
    let part = |(n, part)| {
        let part = escaped(part);
        if n % 2 == 1 {
            format!("<code>{part}</code>")
        } else {
            part
        }
    };
    parts.map(part).collect()
}

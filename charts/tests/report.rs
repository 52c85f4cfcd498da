//! Tests of reports: their pages carry the data of the charts, and nothing from elsewhere.

use charts::chart::{Axis, Column, Curve, Figure, Line, Marker, Row, Scale};
use charts::heat::{Atlas, Map, Palette};
use charts::page::{BLUE, GRID, INK, VERMILION};
use charts::report::Report;
use serde_json::{Value, json};

const AWKWARD: &str = "<b> & </script><!-- <script>";

/// Data of the charts, read from the page.
fn charts(html: &str) -> Value {
    let from = "<script id=\"charts\" type=\"application/json\">";
    let (_, rest) = html.split_once(from).expect("data in the page");
    let (text, _) = rest.split_once("</script>").expect("an end of the data");
    serde_json::from_str(text).expect("JSON")
}

fn data(figure: &Figure) -> Value {
    charts(&Report::new("Title").chart(figure).html())[0].clone()
}

fn figure(legend: Vec<(Line, String)>, curves: Vec<Curve>) -> Figure {
    let x = Axis {
        scale: Scale::Falling,
        ..Axis::decades("error (rad)", 0.0..10.0)
    };
    Figure {
        title: AWKWARD.to_owned(),
        subtitle: String::new(),
        size: (1200, 800),
        legend,
        columns: vec![Column::new("column", x, Axis::linear("time (s)", -0.5..4.5))],
        rows: vec![Row::new(vec![curves])],
    }
}

#[test]
fn points_axes_and_notes_are_those_of_the_figure() {
    let points = vec![(1.0, -0.25), (2.5, 1.0 / 3.0), (7.0, f64::INFINITY)];
    let curve = Curve {
        label: Some("Rk4".to_owned()),
        notes: ["a", "b", "c"].map(str::to_owned).into(),
        ..Curve::new(Line::dashed(BLUE).marked(Marker::Square), points)
    };
    let data = data(&figure(Vec::new(), vec![curve]));
    let panel = &data["panels"][0];
    assert_eq!(panel["title"], "column");
    assert_eq!(panel["x"]["label"], "error (rad)");
    assert_eq!(panel["x"]["scale"], "falling");
    assert_eq!(panel["x"]["range"], json!([0.0, 10.0]));
    assert_eq!(
        panel["x"]["ticks"],
        json!([[0.0, "10⁰"], [5.0, "10⁻⁵"], [10.0, "10⁻¹⁰"]])
    );
    assert_eq!(panel["y"]["scale"], "linear");
    assert_eq!(panel["y"]["ticks"][0], json!([0.0, "0"]));
    let curve = &panel["curves"][0];
    assert_eq!(curve["points"], json!([[1, -0.25], [2.5, 0.3333333], [7, null]]));
    assert_eq!(curve["notes"], json!(["a", "b", "c"]));
    assert_eq!(curve["name"], "Rk4");
    let line = &data["lines"][curve["line"].as_u64().expect("an index") as usize];
    assert_eq!((&line["color"], &line["stroke"]), (&json!("#0072b2"), &json!("dashed")));
    assert_eq!(line["marker"].as_array().map(Vec::len), Some(4));
}

#[test]
fn panels_have_the_shape_of_those_of_the_picture() {
    let figure = figure(Vec::new(), Vec::new()).with_equal_scales();
    let aspect = data(&figure)["panels"][0]["aspect"].as_f64().expect("a number");
    // the height is a whole number of pixels, of about 500
    assert!((aspect - 0.5).abs() < 1e-3, "{aspect}");
}

#[test]
fn legends_have_each_name_once() {
    let two = || vec![(1.0, 1.0), (2.0, 2.0)];
    let named = |name: &str, line: Line| Curve {
        name: Some(name.to_owned()),
        ..Curve::new(line, two())
    };
    let thin = Line {
        width: 1.0,
        ..Line::solid(VERMILION)
    };
    let legend = vec![
        (Line::solid(INK), "explicit".to_owned()),
        (Line::solid(VERMILION), "limit".to_owned()),
        (Line::area(GRID), "unknown".to_owned()),
    ];
    let curves = vec![
        Curve::new(Line::area(GRID), two()),
        named("Rk4", Line::solid(BLUE)),
        named("Rk4", Line::solid(BLUE)),
        // of the line in the legend, with a name of its own, and without
        named("limit of Rk4", thin),
        Curve::new(thin, two()),
        // a text in the panel, which is in no legend
        Curve::note(BLUE, (1.0, 1.0), "here"),
    ];
    let data = data(&figure(legend, curves));
    let legend = data["legend"].as_array().expect("entries");
    let entries: Vec<_> = legend.iter().map(|entry| (&entry["name"], &entry["curves"])).collect();
    let expected = [("explicit", false), ("limit", true), ("unknown", true), ("Rk4", true)];
    let expected = expected.map(|(name, curves)| (json!(name), json!(curves)));
    assert_eq!(entries, expected.each_ref().map(|(name, curves)| (name, curves)));
    let curves = data["panels"][0]["curves"].as_array().expect("curves");
    let refer: Vec<_> = curves.iter().map(|curve| (&curve["name"], &curve["entry"])).collect();
    let expected = [
        (json!("unknown"), json!(2)),
        (json!("Rk4"), json!(3)),
        (json!("Rk4"), json!(3)),
        (json!("limit of Rk4"), json!(1)),
        (json!("limit"), json!(1)),
        (json!("here"), json!(null)),
    ];
    assert_eq!(refer, expected.each_ref().map(|(name, entry)| (name, entry)));
}

#[test]
fn cells_are_those_of_the_map() {
    let map = Map {
        x: Axis::linear("x", 0.0..3.0),
        y: Axis::linear("y", 0.0..2.0),
        colors: Axis::linear("value (1/s)", -1.0..1.0),
        palette: Palette::Signed,
        steps: 3,
        cells: vec![-1.0, 0.1234567, f64::NAN, 7.0],
        across: 2,
        curves: vec![Curve::new(Line::dashed(INK), vec![(0.0, 0.0), (3.0, 2.0)])],
    };
    let atlas = Atlas {
        title: String::new(),
        subtitle: String::new(),
        legend: vec![(Line::dashed(INK), "diagonal".to_owned())],
        columns: 2,
        maps: vec![map],
    };
    let data = charts(&Report::new("Title").chart(&atlas).html())[0].clone();
    assert_eq!(data["columns"], 2);
    let panel = &data["panels"][0];
    assert_eq!(panel["title"], "value (1/s)");
    assert_eq!(panel["curves"][0]["name"], "diagonal");
    let map = &panel["map"];
    // -1, 0.1234567, NaN and 7 in single precision
    assert_eq!(map["cells"], "AACAv97W/D0AAMB/AADgQA==");
    assert_eq!(map["across"], 2);
    assert_eq!(map["colors"], json!(["#053061", "#ffffff", "#67001f"]));
    assert_eq!(map["missing"], "#aaaaaa");
    assert_eq!(map["axis"]["range"], json!([-1.0, 1.0]));
}

#[test]
fn text_stays_text() {
    let curve = Curve {
        label: Some(AWKWARD.to_owned()),
        ..Curve::new(Line::solid(BLUE), vec![(1.0, 1.0), (2.0, 2.0)])
    };
    let html = Report::new(AWKWARD)
        .heading(AWKWARD)
        .text("`a<b>` & more")
        .table("| a | `b<c` |\n|---|---|\n| 1 | 2 |")
        .listing(AWKWARD)
        .chart(&figure(Vec::new(), vec![curve]))
        .html();
    assert_eq!(charts(&html)[0]["panels"][0]["curves"][0]["name"], AWKWARD);
    assert_eq!(html.matches("</script>").count(), 2);
    assert!(!html.contains("<b>") && !html.contains("<!--"));
    let written = "&lt;b> &amp; &lt;/script>&lt;!-- &lt;script>";
    for tag in ["title", "h1", "h2"] {
        assert!(html.contains(&format!("<{tag}>{written}</{tag}>")), "{tag}");
    }
    assert!(html.contains("<p><code>a&lt;b></code> &amp; more</p>"));
    assert!(html.contains("<tr><th>a</th><th><code>b&lt;c</code></th></tr>\n<tr><td>1</td><td>2</td></tr>"));
}

#[test]
fn pages_ask_for_nothing_from_elsewhere() {
    let html = Report::new("Title").chart(&figure(Vec::new(), Vec::new())).html();
    assert!(!html.contains("http"));
    assert!(!html.contains("src=") && !html.contains("url(") && !html.contains("import "));
    let links: Vec<&str> = html.split("href=").skip(1).collect();
    assert!(links.len() == 1 && links[0].starts_with("\"data:,\""));
}

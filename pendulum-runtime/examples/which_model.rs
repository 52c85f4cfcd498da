//! Maps of the simplest model, and of the fastest method, over the amplitude and the friction.
//!
//! `cargo run --release --example which_model -- 20` takes the number of cells in each direction. It draws the cells of
//! a pendulum and of the paper's double pendulum, released at rest and followed for 10 s with an error of at most 1 %
//! of the amplitude, with boundaries that are predicted by leading terms.

use std::error::Error;
use std::path::Path;

use charts::chart::{Axis, Column, Curve, Figure, Line, Marker, Row, Stroke};
use charts::page::{BLUE, GREEN, INK, ORANGE, Picture, SKY, VERMILION};
use pendulum_runtime::{Answer, Declaration, Model, Question, simplest};

/// Time for which motions are followed, in s.
const HORIZON: f64 = 10.0;
/// Largest error relative to the amplitude.
const ERROR: f64 = 0.01;
/// Amplitudes in degrees, and frictions in N m s, in powers of ten.
const DEGREES: [f64; 2] = [-0.3, 2.0];
const FRICTION: [f64; 2] = [-4.0, 2.0];

const PENDULUM: &str = "pub Pendulum {
    params { gamma: N m s }
    generate: [rhs, jacobian, taylor],
    gravity: [0, -9.8, 0],
    body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta, friction: gamma }
}";

const DOUBLE: &str = "pub Double {
    params { gamma: N m s }
    generate: [rhs, jacobian, taylor],
    gravity: [0, -9.8, 0],
    shape plate { mass: 1, com: [0, -1, 0], inertia: 1 }
    body upper on ground: plate { joint: revolute(z), coordinate: theta1, friction: gamma }
    body lower on upper: plate { joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute, friction: gamma }
}";

/// Kinds of models, the simplest first.
const MODELS: [&str; 4] = ["linear, without a friction", "linear", "without a friction", "full"];
/// Kinds of methods.
const METHODS: [&str; 4] = ["order 4 or 5", "order 7 or 9", "Taylor", "implicit, or Auto"];

/// A pendulum of some amplitude and friction.
struct Cell {
    degrees: f64,
    friction: f64,
    /// Numbers of [`MODELS`] and [`METHODS`].
    model: usize,
    method: usize,
    answer: Answer,
}

fn main() -> Result<(), Box<dyn Error>> {
    let size: usize = std::env::args().nth(1).map_or(Ok(20), |text| text.parse())?;
    let (mut models, mut methods) = (Vec::new(), Vec::new());
    for (name, text, angles) in [("pendulum", PENDULUM, 1), ("double pendulum", DOUBLE, 2)] {
        let cells = measure(text, angles, size)?;
        print(name, &cells);
        let marks = |kind: fn(&Cell) -> usize| -> Vec<Curve> {
            let of = |n: usize| {
                let cells = cells.iter().filter(|cell| kind(cell) == n);
                Curve::new(
                    dot(n, size),
                    cells
                        .map(|cell| (cell.friction.log10(), cell.degrees.log10()))
                        .collect(),
                )
            };
            (0..MODELS.len()).map(of).collect()
        };
        let mut own = marks(|cell| cell.model);
        own.extend(boundaries(&cells));
        models.push(own);
        methods.push(marks(|cell| cell.method));
    }
    // kinds that occur
    let legend = |names: [&str; 4], panels: &[Vec<Curve>]| {
        let occurs = |n: &usize| panels.iter().any(|curves| !curves[*n].points.is_empty());
        let kinds = (0..names.len()).filter(occurs);
        kinds.map(|n| (dot(n, size), names[n].to_owned())).collect()
    };
    let column = |title: &str| {
        let amplitude = Axis::decades("amplitude (°)", DEGREES[0] - 0.1..DEGREES[1] + 0.1);
        Column::new(
            title,
            Axis::decades("friction (N m s)", FRICTION[0] - 0.2..FRICTION[1] + 0.2),
            amplitude,
        )
    };
    let row = |caption: &str, names, panels: Vec<Vec<Curve>>| Row {
        caption: caption.to_owned(),
        legend: legend(names, &panels),
        panels,
    };
    let figure = Figure {
        title: "Which model, and which method, is enough?".to_owned(),
        subtitle: format!(
            "Released at rest, followed for {HORIZON} s with at most {} % of the amplitude as error",
            100.0 * ERROR
        ),
        size: (1600, 1500),
        legend: vec![
            (
                Line::solid(INK),
                "boundary of the linear model by its leading term".to_owned(),
            ),
            (
                Line::dashed(GREEN),
                "boundary without any friction by its leading term".to_owned(),
            ),
        ],
        columns: vec![column("Pendulum"), column("Double pendulum")],
        rows: vec![
            row("Simplest model", MODELS, models),
            row("Fastest method of the full model", METHODS, methods),
        ],
    };
    for path in figure.save(Path::new("out/which_model/maps"))? {
        println!("{}", path.display());
    }
    Ok(())
}

/// Asks for the simplest model and the fastest method in each cell.
fn measure(text: &str, angles: usize, size: usize) -> Result<Vec<Cell>, Box<dyn Error>> {
    let model = Model::parse_with(text, &[("gamma", 1.0)])?;
    let between =
        |range: [f64; 2], n: usize| 10_f64.powf(range[0] + (range[1] - range[0]) * n as f64 / (size - 1) as f64);
    let mut cells = Vec::new();
    for n in 0..size * size {
        let (degrees, friction) = (between(DEGREES, n / size), between(FRICTION, n % size));
        let start = [vec![degrees.to_radians(); angles], vec![0.0; angles]].concat();
        let question = Question {
            starts: vec![start.clone()],
            horizon: HORIZON,
            outputs: model.components()[..angles]
                .iter()
                .map(|own| own.name.clone())
                .collect(),
            error: ERROR,
            values: vec![("gamma".to_owned(), friction)],
            ..Question::default()
        };
        let answer = simplest(&Declaration::new(text), &question)?;
        let choices =
            model
                .with(&[("gamma", friction)])?
                .tune([0.0, HORIZON], &[start], ERROR, degrees.to_radians())?;
        cells.push(Cell {
            degrees,
            friction,
            model: answer.simplest().map_or(3, |simplest| {
                let has = |word: &str| simplest.changes.iter().any(|change| change.contains(word));
                match (has("linear"), has("friction")) {
                    (true, true) => 0,
                    (true, false) => 1,
                    (false, true) => 2,
                    (false, false) => 3,
                }
            }),
            method: match choices[0].method.name() {
                "Rk4" | "Rk45" | "Tsit5" => 0,
                "Vern7" | "Vern9" => 1,
                "Taylor" => 2,
                _ => 3,
            },
            answer,
        });
    }
    Ok(cells)
}

/// Boundaries by leading terms. The error of the linear model grows as the square of the amplitude, so that its
/// prediction at the smallest amplitude gives the amplitude at which it is allowed; the error without friction does not
/// depend on the amplitude, and is proportional to small friction.
fn boundaries(cells: &[Cell]) -> Vec<Curve> {
    let smallest = cells.iter().map(|cell| cell.degrees).fold(f64::INFINITY, f64::min);
    let row = || cells.iter().filter(|cell| cell.degrees == smallest);
    let predicted = |cell: &Cell, is_it: &dyn Fn(&[String]) -> bool| {
        let own = cell.answer.simpler.iter().find(|own| is_it(&own.changes))?;
        own.predicted.iter().copied().reduce(f64::max)
    };
    let linear = row().filter_map(|cell| {
        let error = predicted(cell, &|changes| changes.len() == 1 && changes[0].contains("linear"))?;
        Some((cell.friction.log10(), (cell.degrees * (ERROR / error).sqrt()).log10()))
    });
    let linear: Vec<_> = linear.filter(|(_, degrees)| *degrees < DEGREES[1]).collect();
    let without = |changes: &[String]| changes.iter().all(|change| change.contains("friction"));
    let most = |changes: &[String]| without(changes) && changes.len() == cells[0].answer.outputs.len();
    let first = row()
        .next()
        .and_then(|cell| Some((cell.friction, predicted(cell, &most)?)));
    let friction = first.map(|(friction, error)| (friction * ERROR / error).log10());
    let vertical = friction.map(|x| Curve::new(Line::dashed(GREEN), vec![(x, DEGREES[0]), (x, DEGREES[1])]));
    std::iter::once(Curve::new(Line::solid(INK), linear))
        .chain(vertical)
        .collect()
}

fn dot(n: usize, size: usize) -> Line {
    let color = [SKY, BLUE, ORANGE, VERMILION][n];
    Line {
        width: 190.0 / size as f64,
        stroke: Stroke::Dots,
        ..Line::solid(color).marked(Marker::Square)
    }
}

/// Prints the number of cells of each kind.
fn print(name: &str, cells: &[Cell]) {
    println!("{name}: number of cells");
    for (n, kind) in MODELS.iter().enumerate() {
        println!("  {:4} {kind}", cells.iter().filter(|cell| cell.model == n).count());
    }
    for (n, kind) in METHODS.iter().enumerate() {
        println!("  {:4} {kind}", cells.iter().filter(|cell| cell.method == n).count());
    }
}

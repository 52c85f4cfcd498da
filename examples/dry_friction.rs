//! Time and place at which a double pendulum with dry and viscous friction comes to rest.
//!
//! `cargo run --release --example dry_friction` takes 200 x 200 initial conditions on all cores, and draws into
//! `out/dry_friction/` one motion until its rest, the rest positions over the initial angles, and the region in which
//! friction holds the pendulum; `-- SIZE` sets another number along each side.

use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::path::Path;
use std::slice::from_ref;
use std::time::Instant;

use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Stroke};
use charts::heat::{Atlas, Map, Palette};
use charts::page::{BLUE, Picture, RGBColor, VERMILION};
use pendulum_core::prelude::*;
use pendulum_core::stability::resting;

mechanism! {
    /// Two equal rods of 1 kg and 1 m with friction in both axles; both angles are measured from hanging.
    Rods {
        params { mu1: N m = 1.5, mu2: N m = 0.6, gamma: N m s = 0.02 }
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: arm {
            joint: revolute(z), coordinate: theta1, dry_friction: mu1, friction: gamma,
        }
        body lower on upper: arm {
            joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute, dry_friction: mu2, friction: gamma,
        }
    }
}

/// End time in seconds, by which all motions rest.
const T_END: f64 = 60.0;
/// Initial condition of the motion that is drawn.
const START: [f64; 4] = [2.0, -0.5, 0.0, 0.0];
const HELD: RGBColor = RGBColor(230, 230, 230);

fn method() -> Vern7 {
    Vern7::new().rtol(1e-8).atol(1e-8)
}

/// Moments that hold the two joints against gravity.
fn loads(x: &SVector<f64, 4>) -> [f64; 2] {
    let below = 9.81 * 0.5 * x[Rods::THETA2].sin();
    [9.81 * 1.5 * x[Rods::THETA1].sin() + below, below]
}

/// Reduces an angle to -180 to 180 degrees.
fn degrees(angle: f64) -> f64 {
    (angle - TAU * (angle / TAU).round()).to_degrees()
}

/// Figure of one motion: the angles over time, and the intervals in which each joint sticks.
fn one_motion(model: &Rods) -> Result<Figure, Box<dyn Error>> {
    let solution = method().solve(model, 0.0, T_END, START)?;
    let modes = solution.modes();
    let &(rests, mode) = modes.last().ok_or("no mode")?;
    let steps = solution.statistics().accepted;
    let end = solution.end();
    println!(
        "{} from {rests:.4} s on, after {steps} steps and {} changes: at {:.3}° and {:.3}°, with rates of {} and {}",
        mode.describe(model.constraints()),
        modes.len() - 1,
        degrees(end[0]),
        degrees(end[1]),
        end[2],
        end[3],
    );
    let shown = 1.1 * rests;
    let angles = Axis::linear("angle (°)", -120.0..120.0);
    let panel = |constraint: usize, color| -> Result<Vec<Curve>, Box<dyn Error>> {
        let ends = modes[1..].iter().map(|(t, _)| *t).chain([shown]);
        let stuck = modes.iter().zip(ends).filter(|((_, mode), _)| mode.is_held(constraint));
        let mut curves: Vec<Curve> = stuck
            .map(|(&(from, _), to)| {
                let (low, high) = (angles.range.start, angles.range.end);
                Curve::new(Line::area(HELD), vec![(from, low), (from, high), (to, high), (to, low)])
            })
            .collect();
        let times = (0..=2000).map(|n| shown * f64::from(n) / 2000.0);
        let points = times.map(|t| Ok((t, solution.at(t)?[constraint].to_degrees())));
        let points = points.collect::<Result<Vec<_>, Box<dyn Error>>>()?;
        curves.push(Curve::new(Line::solid(color), points));
        Ok(curves)
    };
    let row = |caption: &str, curves| Row {
        caption: caption.to_owned(),
        ..Row::new(vec![curves])
    };
    Ok(Figure {
        title: "A double pendulum until it rests".to_owned(),
        subtitle: format!("Equal rods of 1 m; friction holds both axles for good from {rests:.2} s on"),
        size: (1200, 900),
        legend: vec![(Line::area(HELD), "the axle sticks".to_owned())],
        columns: vec![Column::new("", Axis::linear("time (s)", 0.0..shown), angles.clone())],
        rows: vec![
            row("upper rod", panel(Rods::THETA1, BLUE)?),
            row("lower rod", panel(Rods::THETA2, VERMILION)?),
        ],
    })
}

/// Final states for a grid of both initial angles, row by row.
fn ends(model: &Rods, size: usize) -> Result<Vec<SVector<f64, 4>>, Box<dyn Error>> {
    // Cells are sampled at their centres.
    let angle = |i: usize| PI * ((2 * i + 1) as f64 / size as f64 - 1.0);
    let row = |i: usize| {
        let starts: Vec<_> = (0..size).map(|j| [angle(j), angle(i), 0.0, 0.0].into()).collect();
        let ends = method().ensemble(from_ref(model), 0.0, T_END, &starts);
        ends.map_err(|error| error.to_string())
    };
    // Rows are interleaved over the cores, since neighbours take about the same time.
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let mut rows = vec![Vec::new(); size];
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..cores)
            .map(|core| {
                scope.spawn(move || {
                    (core..size)
                        .step_by(cores)
                        .map(|i| Ok((i, row(i)?)))
                        .collect::<Result<Vec<_>, String>>()
                })
            })
            .collect();
        for worker in workers {
            for (i, row) in worker.join().map_err(|_| "a thread panicked".to_owned())?? {
                rows[i] = row;
            }
        }
        Ok::<(), String>(())
    })?;
    Ok(rows.concat())
}

/// Angles at rest over the initial angles.
fn map(ends: &[SVector<f64, 4>], size: usize) -> Atlas {
    let axis = |label: &str| Axis::linear(label, -180.0..180.0);
    let angles = |name: &str, coordinate: usize, most: f64| Map {
        x: axis("upper rod at the start (°)"),
        y: axis("lower rod at the start (°)"),
        colors: Axis::linear(&format!("{name} rod at rest (°)"), -most..most),
        palette: Palette::Signed,
        steps: 10,
        cells: ends
            .iter()
            .map(|x| if hangs(x) { degrees(x[coordinate]) } else { f64::NAN })
            .collect(),
        across: size,
        curves: Vec::new(),
    };
    Atlas {
        title: "Where a double pendulum with dry friction rests".to_owned(),
        subtitle: "Equal rods of 1 m, from rest; grey: a rod stays upright".to_owned(),
        legend: Vec::new(),
        columns: 2,
        maps: vec![angles("Upper", Rods::THETA1, 8.0), angles("Lower", Rods::THETA2, 8.0)],
    }
}

/// True if both rods point downward.
fn hangs(x: &SVector<f64, 4>) -> bool {
    x[Rods::THETA1].cos() > 0.0 && x[Rods::THETA2].cos() > 0.0
}

/// Region in which friction holds the pendulum, from the model and compared with the closed form, and the rest
/// positions in it.
fn held(model: &Rods, ends: &[SVector<f64, 4>]) -> Result<Figure, Box<dyn Error>> {
    let [mu1, mu2] = [model.params().mu1, model.params().mu2];
    let hanging = resting(model, [0.0; 4])?;
    let [lowest, highest] = hanging.interval(model, Rods::THETA2, 1.0)?;
    let (mut left, mut right, mut error) = (Vec::new(), Vec::new(), 0.0_f64);
    for n in 0..=40 {
        // Slightly inside the ends, where rounding decides.
        let theta2 = 0.999_999 * (lowest + (highest - lowest) * f64::from(n) / 40.0);
        // At this angle the upper joint carries no load, so friction holds it there if it does at any angle.
        let theta1 = (-theta2.sin() / 3.0).asin();
        let across = resting(model, [theta1, theta2, 0.0, 0.0])?;
        let [from, to] = across.interval(model, Rods::THETA1, 1.0)?;
        for (end, load) in [(from, -mu1), (to, mu1)] {
            let known = ((load / 9.81 - 0.5 * theta2.sin()) / 1.5).asin();
            error = error.max((end - known).abs());
        }
        left.push((from.to_degrees(), theta2.to_degrees()));
        right.push((to.to_degrees(), theta2.to_degrees()));
    }
    // a state rests where its accelerations are zero within 100 ulps of their terms
    assert!(error < 1e-13, "the border is off by {error:e} rad");
    println!("the border of what friction holds agrees with the closed form to {error:.1e} rad");
    for x in ends {
        let [first, second] = loads(x);
        let inside = first.abs() <= mu1 * (1.0 + 1e-12) && second.abs() <= mu2 * (1.0 + 1e-12);
        assert!(x[2] == 0.0 && x[3] == 0.0 && inside, "no rest at {x:?}");
        assert_eq!(resting(model, *x)?.x, *x, "friction does not hold it there");
    }
    let region = left.into_iter().chain(right.into_iter().rev()).collect();
    let places = ends.iter().filter(|x| hangs(x));
    let places = places.map(|x| (degrees(x[0]), degrees(x[1]))).collect();
    let dots = Line {
        width: 1.5,
        stroke: Stroke::Dots,
        ..Line::solid(BLUE)
    };
    Ok(Figure {
        title: "What friction can hold, and where the pendulums rest".to_owned(),
        subtitle: "Each dot is the end of a motion".to_owned(),
        size: (1000, 1000),
        legend: vec![
            (Line::area(HELD), "friction holds both axles".to_owned()),
            (dots, "at rest".to_owned()),
        ],
        columns: vec![Column::new(
            "",
            Axis::linear("upper rod (°)", -10.0..10.0),
            Axis::linear("lower rod (°)", -9.0..9.0),
        )],
        rows: vec![Row::new(vec![vec![
            Curve::new(Line::area(HELD), region),
            Curve::new(dots, places),
        ]])],
    }
    .with_equal_scales())
}

fn main() -> Result<(), Box<dyn Error>> {
    let size = match std::env::args().nth(1) {
        None => 200,
        Some(size) => size
            .parse::<usize>()
            .ok()
            .filter(|&size| size > 1)
            .ok_or("usage: dry_friction [SIZE], SIZE above 1")?,
    };
    let model = Rods::new(RodsParams::default())?;
    let motion = one_motion(&model)?;
    let before = Instant::now();
    let ends = ends(&model, size)?;
    let upright = ends.iter().filter(|x| !hangs(x)).count();
    println!(
        "{} trajectories of {T_END} s in {:.2} s; at the end all rest, {upright} of them with a rod upright",
        ends.len(),
        before.elapsed().as_secs_f64()
    );
    let held = held(&model, &ends)?;
    let folder = Path::new("out/dry_friction");
    for file in motion.save(&folder.join("motion"))? {
        println!("{}", file.display());
    }
    println!("{}", map(&ends, size).save_png(&folder.join("places"))?.display());
    println!("{}", held.save_png(&folder.join("held"))?.display());
    Ok(())
}

//! heyoka in a process of its own, as its integrators are compiled at Python's run time.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde::{Deserialize, Serialize};

use super::lanes::APART;
use super::results::{Curve, Point};
use super::scene::Scene;
use super::sweep::tolerances;
use crate::python::python;

/// Input of `heyoka_peer.py`.
#[derive(Serialize)]
struct Task {
    gamma: f64,
    x0: [f64; 4],
    t1: f64,
    apart: f64,
    tolerances: Vec<f64>,
}

/// Output of `heyoka_peer.py`: the settings of each scene.
#[derive(Deserialize)]
struct Measured {
    version: String,
    alone: Vec<Vec<Setting>>,
    batch: Vec<Vec<Setting>>,
}

#[derive(Deserialize)]
struct Setting {
    tolerance: f64,
    t: f64,
    x: [f64; 4],
    /// Nanoseconds of a call that integrates over no time.
    overhead: f64,
    /// Nanoseconds for a trajectory, without the overhead.
    least: f64,
    median: f64,
}

/// Curves of each scene, for one trajectory at a time and for eight; an error with the reason if there are none.
pub(crate) fn measure(
    root: &Path,
    build: &Path,
    scenes: &[Scene],
    header: &mut Vec<String>,
) -> Result<Vec<[Curve; 2]>, String> {
    let (tasks, results) = (build.join("heyoka_tasks.json"), build.join("heyoka.json"));
    run(root, scenes, [&tasks, &results]).map_err(|why| {
        let why = why.to_string();
        let line = why.lines().last().unwrap_or_default();
        format!("heyoka: {line}; `.venv/bin/pip install heyoka`, or set PYTHON")
    })?;
    let text = fs::read_to_string(&results).map_err(|error| error.to_string())?;
    let measured: Measured = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let overheads = measured.alone.iter().flatten().map(|setting| setting.overhead);
    header.push(format!(
        "heyoka {}, in a process of its own; up to {:.1} us that a call takes in Python are taken off",
        measured.version,
        1e-3 * overheads.fold(0.0, f64::max)
    ));
    let both = measured.alone.iter().zip(&measured.batch).zip(scenes);
    Ok(both
        .map(|((alone, batch), scene)| {
            [
                curve("Taylor", alone, scene),
                curve("Taylor, batches of 8", batch, scene),
            ]
        })
        .collect())
}

fn run(root: &Path, scenes: &[Scene], [tasks, results]: [&Path; 2]) -> Result<(), Box<dyn Error>> {
    let list: Vec<Task> = scenes
        .iter()
        .map(|scene| Task {
            gamma: scene.gamma,
            x0: scene.x0,
            t1: scene.t1,
            apart: APART,
            tolerances: tolerances(),
        })
        .collect();
    fs::write(tasks, serde_json::to_string(&list)?)?;
    let mut command = Command::new(python(root));
    let output = command
        .arg(root.join("methods/heyoka_peer.py"))
        .args([tasks, results])
        .output()?;
    if output.status.success() {
        Ok(())
    } else {
        Err(String::from_utf8_lossy(&output.stderr).trim().into())
    }
}

fn curve(method: &'static str, settings: &[Setting], scene: &Scene) -> Curve {
    let mut curve = Curve::new("heyoka", method);
    for setting in settings {
        if scene.is_end(setting.t) {
            curve.points.push(Point {
                least: setting.least,
                median: setting.median,
                ..Point::new(setting.tolerance, scene.error(&setting.x), None)
            });
        } else {
            curve
                .failures
                .push((setting.tolerance, format!("stopped at t = {}", setting.t)));
        }
    }
    curve
}

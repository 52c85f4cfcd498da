//! Sweeps over many initial conditions, compared with heyoka's batches and Numba's parallel loops.

use std::error::Error;
use std::fmt::Debug;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use nalgebra::SVector;
use pendulum_core::ParameterError;
use pendulum_core::prelude::*;
use pendulum_sweep::{Draw, Sweep};
use serde::{Deserialize, Serialize};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

use crate::machine;
use crate::python::python;
use crate::report::{list, number, table, write};

/// Number of trajectories of a sweep.
const TRAJECTORIES: usize = 40_000;
/// Duration of a trajectory, in seconds: short enough that errors do not grow beyond all bounds.
const END: f64 = 3.0;
/// Number of trajectories compared with the exact ends; their median error is shown.
const COMPARED: usize = 100;
const STEPS: usize = 300;
const TOLERANCES: [f64; 3] = [1e-6, 1e-9, 1e-12];

#[derive(Serialize)]
struct Task {
    end: f64,
    threads: usize,
    settings: Vec<(&'static str, f64)>,
}

/// Output of `peers.py` for one setting.
#[derive(Deserialize)]
struct Measured {
    kind: String,
    argument: f64,
    name: String,
    seconds: f64,
    ends: Vec<[f64; 4]>,
}

type State = SVector<f64, 4>;

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = root.join("out/sweeps");
    fs::create_dir_all(&folder)?;
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let sweep = sweep();
    let starts: Vec<State> = (0..TRAJECTORIES).map(|row| start(sweep.point(row))).collect();
    let bytes: Vec<u8> = starts.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    fs::write(folder.join("starts.bin"), bytes)?;
    let model = pendulum()?;
    let exact = Taylor::new().rtol(3e-15).atol(3e-15).order(24);
    let exact: Vec<State> = starts[..COMPARED]
        .iter()
        .map(|&start| Ok(exact.solve(&model, 0.0, END, start)?.end()))
        .collect::<Result<_, Box<dyn Error>>>()?;

    let mut rows = Vec::new();
    let steps = ("Rk4", STEPS as f64);
    let (seconds, ends) = ours(Rk4::new(END / STEPS as f64))?;
    rows.push(row(("Rk4", steps.1), "ours, lanes", seconds, error(&ends, &exact)));
    for tolerance in TOLERANCES {
        let of_taylor = ours(Taylor::new().rtol(tolerance).atol(tolerance))?;
        let of_vern9 = ours(Vern9::new().rtol(tolerance).atol(tolerance))?;
        for (name, (seconds, ends)) in [("ours, Taylor", of_taylor), ("ours, Vern9", of_vern9)] {
            rows.push(row(("tolerance", tolerance), name, seconds, error(&ends, &exact)));
        }
    }
    let mut settings = vec![steps];
    settings.extend(TOLERANCES.map(|tolerance| ("heyoka", tolerance)));
    let task = Task {
        end: END,
        threads,
        settings,
    };
    fs::write(folder.join("task.json"), serde_json::to_string(&task)?)?;
    let script = root.join("bench/sweeps/peers.py");
    let status = Command::new(python(&root)).arg(script).arg(&folder).status()?;
    if !status.success() {
        return Err("peers.py failed; `.venv/bin/pip install heyoka numba`, or set PYTHON".into());
    }
    let measured: Vec<Measured> = serde_json::from_str(&fs::read_to_string(folder.join("results.json"))?)?;
    for peer in measured {
        let ends: Vec<State> = peer.ends.into_iter().map(SVector::from).collect();
        let kind = if peer.kind == "Rk4" { "Rk4" } else { "tolerance" };
        rows.push(row(
            (kind, peer.argument),
            &peer.name,
            peer.seconds,
            error(&ends, &exact),
        ));
    }
    let head = ["setting", "", "microseconds each", "median error"];
    let mut text = list(&machine::describe());
    text += &format!("- {TRAJECTORIES} double pendulums without friction, {END} s, {threads} threads\n\n");
    text += &table(&head, 2, &rows);
    print!("{text}");
    println!("{}", write(folder.join("sweeps.md"), &text)?.display());
    Ok(())
}

fn sweep() -> Sweep<2> {
    let angle = |name| Draw::uniform(name, "rad", -3.0, 3.0);
    Sweep::random("double pendulums", [angle("upper"), angle("lower")], TRAJECTORIES, 1)
}

fn start([upper, lower]: [f64; 2]) -> State {
    SVector::from([upper, lower, 0.0, 0.0])
}

fn pendulum() -> Result<DoublePendulum, ParameterError> {
    DoublePendulum::new(DoublePendulumParams {
        gamma1: 0.0,
        gamma2: 0.0,
        ..DoublePendulumParams::default()
    })
}

/// Minimum time of three runs, and the first final states.
fn ours<X>(method: X) -> Result<(f64, Vec<State>), Box<dyn Error>>
where
    X: Ensemble<DoublePendulum, f64, 4> + Debug + Sync,
{
    let trial = |point| Ok((pendulum()?, start(point).into()));
    let job = sweep().ends(method, (0.0, END), trial).quiet();
    let (mut least, mut ends) = (f64::INFINITY, Vec::new());
    for _ in 0..3 {
        let since = Instant::now();
        let table = job.run()?;
        least = least.min(since.elapsed().as_secs_f64());
        let names = ["theta1", "theta2", "dot(theta1)", "dot(theta2)"];
        ends = (0..COMPARED)
            .map(|row| SVector::from(names.map(|name| table[name][row])))
            .collect();
    }
    Ok((least, ends))
}

fn error(ends: &[State], exact: &[State]) -> f64 {
    let mut errors: Vec<f64> = ends
        .iter()
        .zip(exact)
        .map(|(end, exact)| (end - exact).amax())
        .collect();
    errors.sort_by(f64::total_cmp);
    errors[COMPARED / 2]
}

fn row((kind, argument): (&str, f64), name: &str, seconds: f64, error: f64) -> Vec<String> {
    let setting = if kind == "Rk4" {
        format!("{argument:.0} steps of Rk4")
    } else {
        format!("tolerance {argument:e}")
    };
    let each = 1e6 * seconds / TRAJECTORIES as f64;
    vec![setting, name.to_owned(), number(Some(each)), format!("{error:.1e}")]
}

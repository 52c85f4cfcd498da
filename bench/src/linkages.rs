//! Closed loops and a top, compared with MuJoCo, Pinocchio, CVODES and heyoka.

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use nalgebra::SVector;
use pendulum_core::Reason;
use pendulum_core::prelude::*;
use pendulum_core::taylor::MAX_ORDER;
use serde::Deserialize;
use serde_json::{Value, json};
use testbed::linkages::{Andrews, AndrewsParams, FourBar, FourBarParams};
use testbed::motions::motion;

use crate::machine;
use crate::python::python;
use crate::report::{list, number, table, write};

mechanism! {
    /// The heavy top of Kynema's tests.
    HeavyTop {
        gravity: [0, 0, -9.81],
        body top on ground {
            mass: 15, com: [0, 0, 1], inertia: [0.234375, 0.234375, 0.46875], joint: ball, orientation: o,
        }
        generate: [rhs, taylor],
    }
}

/// Initial angle and rate of the crank of the four-bar, and the duration, in s.
const BARS: ([f64; 2], f64) = ([0.8, 10.0], 2.0);
/// Step sizes of methods with fixed steps, in s.
const STEPS: [f64; 2] = [1e-3, 1e-4];
const TOLERANCES: [f64; 3] = [1e-6, 1e-8, 1e-10];
const TOP_TOLERANCES: [f64; 4] = [1e-8, 1e-10, 1e-12, 1e-14];

/// Measurement of one setting of a program.
#[derive(Deserialize)]
struct Measured {
    scene: String,
    name: String,
    setting: f64,
    seconds: f64,
    evaluations: usize,
    end: Vec<f64>,
    gap: Option<f64>,
}

pub(crate) fn measure() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = root.join("out/linkages");
    fs::create_dir_all(&folder)?;
    let (bars, andrews, top) = (bars()?, andrews(&root)?, top()?);
    let task = json!({ "bars": bars.task, "andrews": andrews.task, "top": top.task });
    fs::write(folder.join("task.json"), serde_json::to_string(&task)?)?;
    let script = root.join("bench/linkages/peers.py");
    let status = Command::new(python(&root)).arg(script).arg(&folder).status()?;
    if !status.success() {
        return Err("peers.py failed; `.venv/bin/pip install mujoco pin casadi heyoka`, or set PYTHON".into());
    }
    let peers: Vec<Measured> = serde_json::from_str(&fs::read_to_string(folder.join("results.json"))?)?;
    let mut text = list(&machine::describe());
    for scene in [bars, andrews, top] {
        let own = peers.iter().filter(|peer| peer.scene == scene.name);
        let head = [
            "",
            "setting",
            "microseconds",
            "nanoseconds per evaluation",
            "error at the end",
            "largest gap",
        ];
        let rows: Vec<Vec<String>> = scene.ours.iter().chain(own).map(|seen| scene.row(seen)).collect();
        text += &format!("\n{}\n\n{}", scene.title, table(&head, 1, &rows));
    }
    print!("{text}");
    println!("{}", write(folder.join("linkages.md"), &text)?.display());
    Ok(())
}

/// Motion with its declaration for the peers and the measurements of our methods.
struct Scene {
    name: &'static str,
    title: String,
    task: Value,
    exact: Vec<f64>,
    ours: Vec<Measured>,
}

impl Scene {
    fn row(&self, seen: &Measured) -> Vec<String> {
        let errors = seen.end.iter().zip(&self.exact).map(|(end, exact)| (end - exact).abs());
        let each = (self.name != "top").then(|| 1e9 * seen.seconds / seen.evaluations as f64);
        vec![
            seen.name.clone(),
            format!("{:e}", seen.setting),
            number(Some(1e6 * seen.seconds)),
            number(each),
            format!("{:.1e}", errors.fold(0.0, f64::max)),
            seen.gap.map(|gap| format!("{gap:.0e}")).unwrap_or_default(),
        ]
    }
}

/// Minimum time over some rounds of several calls each.
fn least(mut call: impl FnMut()) -> f64 {
    const CALLS: u32 = 20;
    let mut least = f64::INFINITY;
    for _ in 0..20 {
        let since = Instant::now();
        (0..CALLS).for_each(|_| call());
        least = least.min(since.elapsed().as_secs_f64() / f64::from(CALLS));
    }
    least
}

/// Cost and result of a method for a motion.
struct Taken<const N: usize> {
    seconds: f64,
    evaluations: usize,
    end: SVector<f64, N>,
    /// Largest gap along the motion.
    gap: f64,
}

impl<const N: usize> Taken<N> {
    /// Makes a row of the results; the components `compared` of the state are compared.
    fn measured(self, name: &str, setting: f64, compared: &[usize]) -> Measured {
        Measured {
            scene: String::new(),
            name: format!("ours, {name}"),
            setting,
            seconds: self.seconds,
            evaluations: self.evaluations,
            end: compared.iter().map(|&n| self.end[n]).collect(),
            gap: Some(self.gap),
        }
    }
}

/// Integrates a system with a method.
fn follow<A, S, const N: usize>(
    method: &A,
    system: &S,
    (end, start): (f64, SVector<f64, N>),
    gap: impl Fn(f64, &SVector<f64, N>) -> f64,
) -> Result<Taken<N>, Reason>
where
    A: Method<S, f64, N>,
    S: System<f64, N>,
{
    let mut stepper = method.stepper(system, 0.0, end, start)?;
    let x = stepper.run()?;
    let evaluations = stepper.statistics().evaluations;
    let solution = method.solve(system, 0.0, end, start).map_err(|error| error.reason)?;
    let gap = solution.points().map(|(t, x)| gap(t, x)).fold(0.0, f64::max);
    let seconds = least(|| {
        let run = method
            .stepper(system, 0.0, end, start)
            .and_then(|mut stepper| stepper.run());
        _ = black_box(run);
    });
    Ok(Taken {
        seconds,
        evaluations,
        end: x,
        gap,
    })
}

fn bars() -> Result<Scene, Box<dyn Error>> {
    let model = FourBar::new(FourBarParams::default())?;
    let (start, end) = (SVector::from(BARS.0), BARS.1);
    let exact = Vern9::new()
        .rtol(1e-14)
        .atol(1e-14)
        .solve(&model, 0.0, end, start)?
        .end();
    let gap = |t: f64, x: &SVector<f64, 2>| model.gaps(t, x).norm();
    let mut ours = Vec::new();
    for step in STEPS {
        let taken = follow(&Rk4::new(step), &model, (end, start), gap)?;
        ours.push(taken.measured("Rk4", step, &[0, 1]));
    }
    for tolerance in TOLERANCES {
        let taken = follow(&Vern9::new().rtol(tolerance).atol(tolerance), &model, (end, start), gap)?;
        ours.push(taken.measured("Vern9", tolerance, &[0, 1]));
    }
    let following = (model.following(0.0, &start), model.following_rates(0.0, &start));
    Ok(Scene {
        name: "bars",
        title: format!(
            "A four-bar with friction, {end} s from a rate of the crank of {} rad/s; gaps in m:",
            start[1]
        ),
        task: json!({
            "q": [start[0], following.0[0], following.0[1]],
            "v": [start[1], following.1[0], following.1[1]],
            "steps": STEPS,
            "end": end,
        }),
        exact: exact.as_slice().to_vec(),
        ours,
    })
}

fn andrews(root: &Path) -> Result<Scene, Box<dyn Error>> {
    let read = |name: &str| -> Result<Value, Box<dyn Error>> {
        Ok(serde_json::from_str(&fs::read_to_string(
            root.join("testbed/data").join(name),
        )?)?)
    };
    let (mechanisms, published) = (read("loops.json")?, read("andrews.json")?);
    let motion = &published["motions"][0];
    let digits = |value: &Value| {
        value
            .as_str()
            .and_then(|text| text.parse::<f64>().ok())
            .ok_or("no number")
    };
    // two pairs of angles are swapped in the published order
    const ORDER: [usize; 7] = [0, 1, 2, 4, 3, 6, 5];
    let start: Vec<f64> = (0..2)
        .flat_map(|half| ORDER.map(|n| 7 * half + n))
        .map(|n| digits(&motion["x0"][n]))
        .collect::<Result<_, _>>()?;
    let last = motion["times"].as_array().map_or(0, Vec::len) - 1;
    let end = digits(&motion["times"][last])?;
    let exact = [0, 7].map(|n| digits(&motion["states"][last][n]));
    let [angle, rate] = exact;
    let exact = vec![angle?, rate?];
    let list = mechanisms["mechanisms"].as_array().ok_or("no mechanisms")?;
    let own = list
        .iter()
        .find(|mechanism| mechanism["name"] == "andrews")
        .ok_or("no Andrews")?;
    let bodies = own["bodies"].as_array().ok_or("no bodies")?.iter().map(|body| {
        json!({
            "parent": body["parent"], "at": body["joint"]["at"], "mass": body["mass"], "com": body["com"],
            "inertia": body["inertia"][2][2],
        })
    });
    let model = Andrews::new(AndrewsParams::default())?;
    let from = SVector::from([start[0], start[7]]);
    let gap = |t: f64, x: &SVector<f64, 2>| model.gaps(t, x).amax();
    let mut ours = Vec::new();
    for tolerance in TOLERANCES {
        let (vern7, vern9) = (Vern7::new(), Vern9::new());
        let vern7 = follow(&vern7.rtol(tolerance).atol(tolerance), &model, (end, from), gap)?;
        let vern9 = follow(&vern9.rtol(tolerance).atol(tolerance), &model, (end, from), gap)?;
        ours.push(vern7.measured("Vern7", tolerance, &[0, 1]));
        ours.push(vern9.measured("Vern9", tolerance, &[0, 1]));
    }
    Ok(Scene {
        name: "andrews",
        title: format!("Andrews' mechanism to t = {end} s, angle and rate of the driven body; gaps in m:"),
        task: json!({
            "bodies": bodies.collect::<Vec<_>>(), "loops": own["loops"], "springs": own["springs"],
            "torque": own["torque"],
            "start": start, "end": end, "tolerances": TOLERANCES,
        }),
        exact,
        ours,
    })
}

fn top() -> Result<Scene, Box<dyn Error>> {
    let model = HeavyTop::new(HeavyTopParams {})?;
    let reference = motion("heavy_top_kynema");
    let &(end, exact) = reference.states.last().ok_or("no states")?;
    let gap = |_: f64, x: &SVector<f64, 7>| (x.fixed_rows::<4>(0).norm() - 1.0).abs();
    let (motion, all) = ((end, reference.x0), [0, 1, 2, 3, 4, 5, 6]);
    let mut ours = Vec::new();
    for tolerance in TOP_TOLERANCES {
        let (taylor, vern9) = (Taylor::new().rtol(tolerance).atol(tolerance), Vern9::new());
        let highest = follow(&taylor.order(MAX_ORDER), &model, motion, gap)?;
        let taylor = follow(&taylor, &model, motion, gap)?;
        let vern9 = follow(&vern9.rtol(tolerance).atol(tolerance), &model, motion, gap)?;
        ours.push(taylor.measured("Taylor", tolerance, &all));
        ours.push(highest.measured("Taylor, order 24", tolerance, &all));
        ours.push(vern9.measured("Vern9", tolerance, &all));
    }
    Ok(Scene {
        name: "top",
        title: format!("A heavy top of 150 rad/s to t = {end} s; gaps of the length of the quaternion from 1:"),
        task: json!({ "start": reference.x0.as_slice(), "end": end, "tolerances": TOP_TOLERANCES }),
        exact: exact.as_slice().to_vec(),
        ours,
    })
}

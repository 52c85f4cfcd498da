//! Measurements as JSON.

use serde_json::{Value, json};

use crate::measure::Problem;

/// All runs of all problems that reached the end; errors that are not known are `null`.
pub(crate) fn of(problems: &[Problem]) -> Value {
    json!({
        "processor": processor(),
        "system": format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
        "problems": problems.iter().map(problem).collect::<Vec<_>>(),
    })
}

fn problem(problem: &Problem) -> Value {
    let methods = problem.measurement.report.methods.iter().enumerate();
    let runs = methods.flat_map(|(n, series)| {
        series.measured().map(move |(setting, run)| {
            let work = run.work.unwrap_or_default();
            json!({
                "method": series.name,
                "setting": setting,
                "error": run.errors.last,
                "largest_error": run.errors.largest,
                "dense_error": run.errors.dense,
                "least_time": run.minimum,
                "median_time": run.median,
                "evaluations": work.evaluations,
                "jacobians": work.jacobians,
                "factorizations": work.factorizations,
                "flops": problem.measurement.flops(n, setting),
            })
        })
    });
    json!({
        "name": problem.name,
        "t1": problem.t1,
        "size": problem.size,
        "uncertainty": problem.uncertainty[0] / problem.size,
        "runs": runs.collect::<Vec<_>>(),
    })
}

/// Name of the processor, on Linux.
fn processor() -> Option<String> {
    let info = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = info.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

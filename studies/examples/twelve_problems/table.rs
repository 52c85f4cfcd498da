//! Tables of the fastest method for each error.

use testbed::work::LANES;

use crate::measure::Problem;

const ERRORS: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Fastest method with its time, and the time of `Auto` over it, for each problem and relative error.
pub(crate) fn alone(problems: &[Problem]) -> String {
    let cell = |problem: &Problem, error| {
        let (name, time) = fastest(problem, error, |name| !name.ends_with(LANES) && name != "Auto")?;
        let auto = fastest(problem, error, |name| name == "Auto");
        let ratio = auto.map_or("-".to_owned(), |(_, auto)| format!("{:.1}", auto / time));
        Some(format!("{name} {}, {ratio}", digits(1e6 * time)))
    };
    markdown(
        "fastest method, us, and `Auto` over it, for a relative error of",
        problems,
        cell,
    )
}

/// Fastest method in lanes with the time for one of many trajectories, and that over the time of the fastest method
/// alone.
pub(crate) fn in_lanes(problems: &[Problem]) -> String {
    let cell = |problem: &Problem, error| {
        let (name, time) = fastest(problem, error, |name| name.ends_with(LANES))?;
        let ratio = fastest(problem, error, |name| !name.ends_with(LANES)).map(|(_, alone)| time / alone)?;
        let name = name.trim_end_matches(LANES);
        Some(format!("{name} {}, {ratio:.2}", digits(1e6 * time)))
    };
    markdown(
        "fastest method in lanes, us, over the fastest alone, for a relative error of",
        problems,
        cell,
    )
}

/// Fastest of some methods for a relative error.
fn fastest(problem: &Problem, error: f64, of: impl Fn(&str) -> bool) -> Option<(&str, f64)> {
    let methods = problem.to_reach(error).filter(|(name, _)| of(name));
    methods.min_by(|(_, a), (_, b)| a.total_cmp(b))
}

fn markdown(title: &str, problems: &[Problem], cell: impl Fn(&Problem, f64) -> Option<String>) -> String {
    let head: String = ERRORS.iter().map(|error| format!(" {error:.0e} |")).collect();
    let mut lines = vec![
        format!("| {title} |{head}"),
        format!("|---|{}", "---|".repeat(ERRORS.len())),
    ];
    for problem in problems {
        let cells = ERRORS.map(|error| cell(problem, error).map_or(" |".to_owned(), |cell| format!(" {cell} |")));
        lines.push(format!("| {} |{}", problem.title, cells.concat()));
    }
    lines.join("\n")
}

/// Three significant digits, or all before the point.
fn digits(time: f64) -> String {
    match time {
        time if time < 9.995 => format!("{time:.2}"),
        time if time < 99.95 => format!("{time:.1}"),
        _ => format!("{time:.0}"),
    }
}

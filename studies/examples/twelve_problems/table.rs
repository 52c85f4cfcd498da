//! Table of the fastest method for each error.

use crate::measure::Problem;

const ERRORS: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Fastest method with its time, and the time of `Auto` over it, for each problem and relative error.
pub(crate) fn markdown(problems: &[Problem]) -> String {
    let head: String = ERRORS.iter().map(|error| format!(" {error:.0e} |")).collect();
    let mut lines = vec![
        format!("| fastest method, us, and `Auto` over it, for a relative error of |{head}"),
        format!("|---|{}", "---|".repeat(ERRORS.len())),
    ];
    for problem in problems {
        let cells: String = ERRORS.iter().map(|&error| cell(problem, error)).collect();
        lines.push(format!("| {} |{cells}", problem.title));
    }
    lines.join("\n")
}

fn cell(problem: &Problem, error: f64) -> String {
    let single = problem.to_reach(error).filter(|(name, _)| *name != "Auto");
    let Some((name, time)) = single.min_by(|(_, a), (_, b)| a.total_cmp(b)) else {
        return " |".to_owned();
    };
    let auto = problem.to_reach(error).find(|(name, _)| *name == "Auto");
    let ratio = auto.map_or("-".to_owned(), |(_, auto)| format!("{:.1}", auto / time));
    format!(" {name} {}, {ratio} |", digits(1e6 * time))
}

/// Three significant digits, or all before the point.
fn digits(time: f64) -> String {
    match time {
        time if time < 9.995 => format!("{time:.2}"),
        time if time < 99.95 => format!("{time:.1}"),
        _ => format!("{time:.0}"),
    }
}

//! Tables of the book.

use pendulum_core::accuracy::{Measured, Report};

use crate::scenes::Scene;

/// Target errors.
const TARGETS: [f64; 3] = [1e-6, 1e-8, 1e-10];
/// Index of the target whose steps and evaluations are shown.
const SHOWN: usize = 1;

/// Cheapest settings of all methods on one scene.
struct Cheapest<'r> {
    /// Cheapest setting of each method, for each target.
    found: [Vec<Option<&'r Measured>>; TARGETS.len()],
    /// Shortest time of a method without lanes to reach each target, in seconds.
    fastest: [f64; TARGETS.len()],
}

/// Table of the times of methods, which are the same on all scenes, relative to the fastest method without lanes.
pub(crate) fn markdown(reports: &[(&Scene, Report)]) -> String {
    let columns: Vec<_> = reports.iter().map(|(_, report)| Cheapest::of(report)).collect();
    let shown = format!("steps, evaluations at {:.0e}", TARGETS[SHOWN]);
    let head = format!(
        "{} | {shown}",
        TARGETS.map(|target| format!("{target:.0e}")).join(" | ")
    );
    let names = reports.iter().map(|(scene, _)| format!(" {}: {head} |", scene.name));
    let rule = "---:|".repeat((TARGETS.len() + 1) * reports.len());
    let mut lines = vec![format!("| |{}", names.collect::<String>()), format!("|---|{rule}")];

    let methods = &reports[0].1.methods;
    let mut order: Vec<usize> = (0..methods.len()).collect();
    let place = |n: usize| columns[0].ratio(SHOWN, n).unwrap_or(f64::INFINITY);
    order.sort_by(|&a, &b| place(a).total_cmp(&place(b)));
    for n in order {
        let cells: String = columns.iter().map(|column| column.cells(n)).collect();
        lines.push(format!("| {} |{cells}", methods[n].name));
    }
    let units = columns.iter().zip(reports).map(|(column, (scene, _))| {
        let times = column.fastest.map(|time| format!("{:.1}", 1e6 * time));
        format!("{}: 1 stands for {} us.", scene.name, times.join(", "))
    });
    format!("{}\n\n{}", lines.join("\n"), units.collect::<Vec<_>>().join("\n"))
}

impl<'r> Cheapest<'r> {
    fn of(report: &'r Report) -> Self {
        let found = TARGETS.map(|target| {
            let each = report.time_to_reach(target);
            each.map(|(_, found)| Some(found?.1)).collect::<Vec<_>>()
        });
        let fastest = found.each_ref().map(|found| {
            let alone = found.iter().flatten().filter(|measured| measured.work.is_some());
            alone.map(|measured| measured.minimum).fold(f64::INFINITY, f64::min)
        });
        Self { found, fastest }
    }

    /// Relative time of method `n` for a target.
    fn ratio(&self, target: usize, n: usize) -> Option<f64> {
        Some(self.found[target][n]?.minimum / self.fastest[target])
    }

    /// Cells in the row of method `n`.
    fn cells(&self, n: usize) -> String {
        let ratios = (0..TARGETS.len()).map(|target| self.ratio(target, n).map_or(String::new(), digits));
        let work = self.found[SHOWN][n].and_then(|measured| measured.work);
        let work = work.map(|work| format!("{}, {}", work.accepted + work.rejected, work.evaluations));
        let cells = ratios.chain([work.unwrap_or_default()]);
        cells.map(|cell| format!(" {cell} |")).collect()
    }
}

/// Formats two significant digits, or all before the point.
fn digits(ratio: f64) -> String {
    match ratio {
        ratio if ratio < 0.995 => format!("{ratio:.2}"),
        ratio if ratio < 9.95 => format!("{ratio:.1}"),
        _ => format!("{ratio:.0}"),
    }
}

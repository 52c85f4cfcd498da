//! Tables of the book.

use pendulum_core::accuracy::Measured;

use testbed::work::Measurement;

use crate::scenes::Scene;

/// Target errors.
const TARGETS: [f64; 3] = [1e-6, 1e-8, 1e-10];
/// Index of the target whose steps and operations are shown.
const SHOWN: usize = 1;

/// Cheapest settings of all methods on one scene.
struct Cheapest<'r> {
    measurement: &'r Measurement,
    /// Cheapest setting of each method, for each target.
    found: [Vec<Option<(f64, &'r Measured)>>; TARGETS.len()],
    /// Shortest time of a method without lanes to reach each target, in seconds.
    fastest: [f64; TARGETS.len()],
}

/// Table of the times of methods, which are the same on all scenes, relative to the fastest method without lanes.
pub(crate) fn markdown(scenes: &[(&Scene, Measurement)]) -> String {
    let columns: Vec<_> = scenes
        .iter()
        .map(|(_, measurement)| Cheapest::of(measurement))
        .collect();
    let shown = format!("steps, 1000 operations at {:.0e}", TARGETS[SHOWN]);
    let head = format!(
        "{} | {shown}",
        TARGETS.map(|target| format!("{target:.0e}")).join(" | ")
    );
    let names = scenes.iter().map(|(scene, _)| format!(" {}: {head} |", scene.name));
    let rule = "---:|".repeat((TARGETS.len() + 1) * scenes.len());
    let mut lines = vec![format!("| |{}", names.collect::<String>()), format!("|---|{rule}")];

    let methods = &scenes[0].1.report.methods;
    let mut order: Vec<usize> = (0..methods.len()).collect();
    let place = |n: usize| columns[0].ratio(SHOWN, n).unwrap_or(f64::INFINITY);
    order.sort_by(|&a, &b| place(a).total_cmp(&place(b)));
    for n in order {
        let cells: String = columns.iter().map(|column| column.cells(n)).collect();
        lines.push(format!("| {} |{cells}", methods[n].name));
    }
    let units = columns.iter().zip(scenes).map(|(column, (scene, _))| {
        let times = column.fastest.map(|time| format!("{:.1}", 1e6 * time));
        format!("{}: 1 stands for {} us.", scene.name, times.join(", "))
    });
    format!("{}\n\n{}", lines.join("\n"), units.collect::<Vec<_>>().join("\n"))
}

impl<'r> Cheapest<'r> {
    fn of(measurement: &'r Measurement) -> Self {
        let found = TARGETS.map(|target| {
            let each = measurement.report.time_to_reach(target);
            each.map(|(_, found)| found).collect::<Vec<_>>()
        });
        let fastest = found.each_ref().map(|found| {
            let alone = found.iter().flatten().filter(|(_, measured)| measured.work.is_some());
            alone
                .map(|(_, measured)| measured.minimum)
                .fold(f64::INFINITY, f64::min)
        });
        Self {
            measurement,
            found,
            fastest,
        }
    }

    /// Relative time of method `n` for a target.
    fn ratio(&self, target: usize, n: usize) -> Option<f64> {
        Some(self.found[target][n]?.1.minimum / self.fastest[target])
    }

    /// Cells in the row of method `n`.
    fn cells(&self, n: usize) -> String {
        let ratios = (0..TARGETS.len()).map(|target| self.ratio(target, n).map_or(String::new(), digits));
        let work = self.found[SHOWN][n].and_then(|(setting, measured)| {
            let (steps, flops) = (measured.work?, self.measurement.flops(n, setting)?);
            Some(format!(
                "{}, {:.0}",
                steps.accepted + steps.rejected,
                1e-3 * flops as f64
            ))
        });
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

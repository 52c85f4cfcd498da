//! Cost of one more operation in a right-hand side.

use std::error::Error;

use serde::Serialize;

use super::subjects::Subject;
use super::time;

const OPERATIONS: [&str; 6] = ["addition", "multiplication", "division", "sincos", "sqrt", "exp"];
/// Places of the inserted operation, by the symbols and in words.
pub(crate) const PLACES: [(&str, &str); 3] = [
    ("on", "on the critical path"),
    ("off", "off it"),
    ("beside", "evaluations beside each other"),
];
const HOSTS: [&str; 4] = ["DoublePendulum", "Chain5", "Elbow3", "Ur5"];

/// Cost of one more operation.
#[derive(Serialize)]
pub(crate) struct Insertion {
    pub operation: &'static str,
    pub place: &'static str,
    /// Cost in nanoseconds in each of the hosts, by size.
    pub nanoseconds: Vec<f64>,
    /// Cost in units of an addition in the fit.
    pub weights: Vec<f64>,
}

pub(crate) fn measure(subjects: &[Subject], unit: f64) -> Result<Vec<Insertion>, Box<dyn Error>> {
    let mut runs = Vec::new();
    for (place, _) in PLACES {
        for operation in ["nothing"].iter().chain(&OPERATIONS) {
            for host in HOSTS {
                let subject = subjects
                    .iter()
                    .find(|subject| subject.name == host)
                    .ok_or("a host is missing")?;
                runs.push((subject, subject.load(&format!("{place}_{operation}"))?));
            }
        }
    }
    let times = time(&runs);
    let mut insertions = Vec::new();
    let groups = times.chunks_exact(HOSTS.len() * (1 + OPERATIONS.len()));
    for ((_, place), group) in PLACES.into_iter().zip(groups) {
        let (nothing, others) = group.split_at(HOSTS.len());
        for (operation, with) in OPERATIONS.into_iter().zip(others.chunks_exact(HOSTS.len())) {
            let nanoseconds: Vec<f64> = with
                .iter()
                .zip(nothing)
                .map(|(with, without)| with.minus(without))
                .collect();
            insertions.push(Insertion {
                operation,
                place,
                weights: nanoseconds.iter().map(|time| time / unit).collect(),
                nanoseconds,
            });
        }
    }
    Ok(insertions)
}

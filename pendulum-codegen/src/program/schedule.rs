//! Order of statements.

use std::collections::BTreeSet;

use rustc_hash::FxHashMap;

/// Number of values defined by a statement, and the statements it depends on.
#[derive(Debug, Default)]
pub(super) struct Step {
    /// Number of values that the step defines.
    pub(super) defines: usize,
    /// Indices of the steps whose values it needs.
    pub(super) needs: BTreeSet<usize>,
    /// True if its values are results, which need not stay alive.
    pub(super) is_result: bool,
}

/// Orders steps so that few values are alive at a time. Among the steps whose needs are met, the next is the one after
/// which the fewest values are alive; the first in the given order wins a tie. A processor has 16 or 32 registers, and
/// further values are spilled to memory.
pub(super) fn schedule(steps: &[Step]) -> Vec<usize> {
    let mut users: FxHashMap<usize, Vec<usize>> = FxHashMap::default();
    for (n, step) in steps.iter().enumerate() {
        for &need in &step.needs {
            users.entry(need).or_default().push(n);
        }
    }
    let mut waiting_users: Vec<usize> = (0..steps.len()).map(|n| users.get(&n).map_or(0, Vec::len)).collect();
    let mut unmet: Vec<usize> = steps.iter().map(|step| step.needs.len()).collect();
    let mut ready: BTreeSet<usize> = (0..steps.len()).filter(|&n| unmet[n] == 0).collect();
    let mut order = Vec::with_capacity(steps.len());
    while let Some(next) = ready.iter().copied().min_by_key(|&n| {
        let (step, count) = (&steps[n], |n: usize| steps[n].defines as isize);
        let ending: isize = step
            .needs
            .iter()
            .filter(|&&need| waiting_users[need] == 1)
            .map(|&need| count(need))
            .sum();
        let starting = if step.is_result { 0 } else { count(n) };
        (starting - ending, n)
    }) {
        ready.remove(&next);
        order.push(next);
        for &need in &steps[next].needs {
            waiting_users[need] -= 1;
        }
        for &user in users.get(&next).map_or(&[][..], Vec::as_slice) {
            unmet[user] -= 1;
            if unmet[user] == 0 {
                ready.insert(user);
            }
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::{Step, schedule};

    fn step(needs: &[usize]) -> Step {
        Step {
            defines: 1,
            needs: needs.iter().copied().collect(),
            is_result: false,
        }
    }

    /// Maximum number of values alive at a time.
    fn most_alive(steps: &[Step], order: &[usize]) -> usize {
        let place = |n: usize| order.iter().position(|&m| m == n).expect("every step is done");
        let alive = |now: usize| {
            let waits = |n: usize| {
                let last = (0..steps.len())
                    .filter(|&m| steps[m].needs.contains(&n))
                    .map(place)
                    .max();
                place(n) <= now && last.is_some_and(|last| last > now)
            };
            (0..steps.len()).filter(|&n| waits(n)).count()
        };
        (0..steps.len()).map(alive).max().unwrap_or(0)
    }

    #[test]
    fn values_are_used_up_before_new_ones_are_made() {
        // four values, then their sum one by one
        let steps = [
            step(&[]),
            step(&[]),
            step(&[]),
            step(&[]),
            step(&[0, 1]),
            step(&[4, 2]),
            step(&[5, 3]),
        ];
        let order = schedule(&steps);
        for (n, step) in steps.iter().enumerate() {
            let place = |n: usize| order.iter().position(|&m| m == n);
            assert!(step.needs.iter().all(|&need| place(need) < place(n)), "{order:?}");
        }
        let given: Vec<usize> = (0..steps.len()).collect();
        assert_eq!((most_alive(&steps, &given), most_alive(&steps, &order)), (4, 2));
    }
}

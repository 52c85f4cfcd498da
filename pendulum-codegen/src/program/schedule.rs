//! Order of statements.

use std::cmp::Reverse;
use std::collections::BTreeSet;

use super::block::{Let, Term};
use super::dependence::Dependence;
use crate::expr::CostKind;
use crate::pass::cost::{waiting, work};

/// Latency of an addition: four cycles, in which eight independent ones take place.
const LATENCY: usize = 8;
/// Number of operations that a processor looks ahead, whatever their order.
const LOOK_AHEAD: usize = 256;

/// Number of values defined by a statement, the statements it depends on, and its time.
#[derive(Debug, Default)]
pub(super) struct Step {
    /// Number of values that the step defines.
    pub(super) defines: usize,
    /// Indices of the steps whose values it needs, all before its own.
    pub(super) needs: BTreeSet<usize>,
    /// True if its values are results, which need not stay alive.
    pub(super) is_result: bool,
    /// Time of the step.
    pub(super) time: Time,
}

/// Estimated time of a computation, in multiples of one addition among many independent ones.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Time {
    /// Time of its operations among many independent ones.
    work: usize,
    /// Time of its longest chain of dependent operations.
    chain: usize,
}

impl Time {
    /// Time of a statement.
    pub(super) fn of(code: &Let) -> Self {
        match code {
            Let::Value(_, term) => Self::of_term(term),
            Let::SinCos(pairs) => pairs.iter().fold(Self::default(), |time, pair| {
                time.beside(Self::of_term(&pair.angle).then(CostKind::Sincos))
            }),
        }
    }

    fn of_term(term: &Term) -> Self {
        match term {
            Term::Number(_) | Term::Local(_) | Term::Read(_) => Self::default(),
            Term::Unary(op, a) => Self::of_term(a).then(op.cost()),
            Term::Binary(op, a, b) => Self::of_term(a).beside(Self::of_term(b)).then(op.cost()),
            Term::Sqrt(a) => Self::of_term(a).then(CostKind::Division),
            Term::Power(a, _) => Self::of_term(a).then(CostKind::Function),
        }
    }

    fn beside(self, other: Self) -> Self {
        Self {
            work: self.work + other.work,
            chain: self.chain.max(other.chain),
        }
    }

    fn then(self, kind: CostKind) -> Self {
        Self {
            work: self.work + work(kind),
            chain: self.chain + LATENCY * waiting(kind),
        }
    }
}

/// Orders steps so that few values are alive at a time. Among the steps whose needs are met, the next is the one after
/// which the fewest values are alive: a processor has 16 or 32 registers, and further values are spilled to memory. Of
/// several it is the first in the given order, unless the longest chain takes more time than all work side by side,
/// and the work exceeds the window of the processor: then the one with the longest chain to the end goes first.
pub(super) fn schedule(steps: &[Step]) -> Vec<usize> {
    let mut dependence = Dependence::new(steps.iter().map(|step| &step.needs));
    let mut chains = dependence.chains(|n| steps[n].time.chain);
    let all_work: usize = steps.iter().map(|step| step.time.work).sum();
    if all_work <= LOOK_AHEAD || chains.iter().all(|&chain| chain <= all_work) {
        chains.fill(0);
    }
    let mut waiting_users: Vec<usize> = (0..steps.len()).map(|n| dependence.users(n).len()).collect();
    let mut ready: BTreeSet<usize> = dependence.ready().collect();
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
        (starting - ending, Reverse(chains[n]), n)
    }) {
        ready.remove(&next);
        order.push(next);
        for &need in &steps[next].needs {
            waiting_users[need] -= 1;
        }
        ready.extend(dependence.finish(next));
    }
    order
}

#[cfg(test)]
mod tests {
    use super::{LATENCY, Step, Time, schedule};

    fn step(needs: &[usize]) -> Step {
        Step {
            defines: 1,
            needs: needs.iter().copied().collect(),
            is_result: false,
            time: Time {
                work: 1,
                chain: LATENCY,
            },
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

    #[test]
    fn a_chain_that_cannot_hide_starts_first() {
        let divided = |needs: &[usize]| Step {
            time: Time {
                work: 6,
                chain: 4 * LATENCY,
            },
            ..step(needs)
        };
        // independent steps, then twelve divisions, each of the one before it
        let order = |count: usize| {
            let chain = (1..12).map(|n| divided(&[count + n - 1]));
            let steps: Vec<Step> = (0..count)
                .map(|_| step(&[]))
                .chain([divided(&[])])
                .chain(chain)
                .collect();
            schedule(&steps)
        };
        let chain_first: Vec<usize> = (250..262).chain(0..250).collect();
        assert_eq!(order(250), chain_first);
        // a few steps fit into the processor's window, and many hide the chain
        for count in [100, 1000] {
            let given: Vec<usize> = (0..count + 12).collect();
            assert_eq!(order(count), given);
        }
    }
}

//! Which steps wait for which.

use std::collections::BTreeSet;

/// Steps that wait for the results of others, while steps are done one after the other.
#[derive(Debug)]
pub(crate) struct Dependence {
    /// Steps that need the result of each one.
    users: Vec<Vec<usize>>,
    /// Number of steps that each one still waits for.
    unmet: Vec<usize>,
}

impl Dependence {
    /// Dependence of steps that need others before them.
    pub(crate) fn new<'a>(needs: impl IntoIterator<Item = &'a BTreeSet<usize>>) -> Self {
        let needs: Vec<&BTreeSet<usize>> = needs.into_iter().collect();
        let mut users = vec![Vec::new(); needs.len()];
        for (n, needs) in needs.iter().enumerate() {
            needs.iter().for_each(|&need| users[need].push(n));
        }
        Self {
            users,
            unmet: needs.iter().map(|needs| needs.len()).collect(),
        }
    }

    /// Steps that need the result of one.
    pub(crate) fn users(&self, n: usize) -> &[usize] {
        &self.users[n]
    }

    /// Steps that wait for no other one.
    pub(crate) fn ready(&self) -> impl Iterator<Item = usize> {
        (0..self.unmet.len()).filter(|&n| self.unmet[n] == 0)
    }

    /// Marks a step as done, and returns the steps that waited for it alone.
    pub(crate) fn finish(&mut self, n: usize) -> impl Iterator<Item = usize> {
        let Self { users, unmet } = self;
        users[n].iter().copied().filter(|&user| {
            unmet[user] -= 1;
            unmet[user] == 0
        })
    }

    /// Length of the longest chain from each step to the end, given the length of a step.
    pub(crate) fn chains(&self, length: impl Fn(usize) -> usize) -> Vec<usize> {
        let mut chains = vec![0; self.users.len()];
        for n in (0..chains.len()).rev() {
            chains[n] = length(n) + self.users[n].iter().map(|&user| chains[user]).max().unwrap_or(0);
        }
        chains
    }
}

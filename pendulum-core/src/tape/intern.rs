//! Names and lists that live as long as the program: layouts, constraints and errors lend them.
//!
//! Equal ones are stored once, so memory grows only with the names that differ.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// Names.
static NAMES: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
/// Rates of constraints.
static RATES: Mutex<BTreeSet<&'static [(usize, i8)]>> = Mutex::new(BTreeSet::new());

/// Stored copy of a name.
pub(super) fn name(name: &str) -> &'static str {
    intern(&NAMES, name)
}

/// Stored copy of a rate.
pub(super) fn rate(rate: &[(usize, i8)]) -> &'static [(usize, i8)] {
    intern(&RATES, rate)
}

fn intern<T: Ord + ?Sized>(stored: &Mutex<BTreeSet<&'static T>>, value: &T) -> &'static T
where
    for<'a> Box<T>: From<&'a T>,
{
    let mut stored = stored.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(own) = stored.get(value) {
        return own;
    }
    let own: &'static T = Box::leak(Box::from(value));
    stored.insert(own);
    own
}

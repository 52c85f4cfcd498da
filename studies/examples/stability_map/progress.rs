//! Parallel work with a progress bar.

use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

/// Maps `work` over the items on all cores, in order, and returns the results or one of the errors. The progress bar is
/// drawn on standard error if that is a terminal.
pub(crate) fn on_all_cores<I: Sync, T: Send, E: Send>(
    name: &'static str,
    items: &[I],
    work: impl Fn(&I) -> Result<T, E> + Sync,
) -> Result<Vec<T>, E> {
    let style = ProgressStyle::with_template("{msg:26} {wide_bar} {pos:>7} of {len}, {eta} left");
    let bar = ProgressBar::new(items.len() as u64).with_message(name);
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let done = items.par_iter().map(|item| {
        let result = work(item);
        bar.inc(1);
        result
    });
    let results = done.collect();
    bar.finish_and_clear();
    results
}

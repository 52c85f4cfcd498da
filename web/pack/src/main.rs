//! Deflates the standard input: an order of magnitude slower than zlib, and about 4 % shorter.

use std::io::{stdin, stdout};
use std::num::NonZero;

use zopfli::{Format, Options};

/// Number of trials. More hardly shorten the result.
const TRIALS: NonZero<u64> = NonZero::new(5).expect("a number above zero");

fn main() -> std::io::Result<()> {
    let options = Options {
        iteration_count: TRIALS,
        ..Options::default()
    };
    zopfli::compress(options, Format::Deflate, stdin().lock(), stdout().lock())
}

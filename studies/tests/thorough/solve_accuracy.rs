//! Digits that accelerations lose if one body is much lighter or heavier than the others, compared with 50-digit
//! values.

use testbed::ratios::{Sample, generated, scenes};

/// Maximum error in units of the bound by the conditioning. The longest chain of operations from an input to an
/// acceleration has some twenty roundings of half a unit each, which add up like a random walk to about two units.
/// Twice that leaves room for a less favourable order of operations, but none for a cancellation, which costs
/// thousands.
const UNITS: f64 = 4.0;

/// Scenes with two coordinates. Each scene of the data is in one of the two lists.
const TWO_COORDINATES: [&str; 5] = ["points", "points_relative", "plates", "plates_slight", "cart"];
/// Scenes with three coordinates.
const THREE_COORDINATES: [&str; 3] = ["chain_last", "chain_middle", "arm"];

/// Asserts that no error exceeds `UNITS` times the `bound` of its sample.
fn assert_bounded(names: &[&str], bound: impl Fn(&Sample) -> f64) {
    let mut worst = (0.0, String::new());
    for scene in scenes().iter().filter(|scene| names.contains(&scene.name.as_str())) {
        for sample in &scene.samples {
            let error = sample.error_of(&generated(&scene.name, sample));
            let units = error / bound(sample);
            // NaN is the worst error of all
            if units.is_nan() || units > worst.0 {
                let (kappa, ratio, state) = (sample.kappa(), sample.ratio, &sample.state);
                let place = format!(
                    "{}, ratio {ratio:e}, state {state:?}, condition {kappa:.1e}",
                    scene.name
                );
                worst = (units, format!("{place}: error {error:.1e}, {units:.2} times the bound"));
            }
        }
    }
    println!("{}", worst.1);
    assert!(worst.0 <= UNITS, "{}", worst.1);
}

/// With two coordinates, all cancellations were done symbolically.
#[test]
fn two_coordinates_lose_no_more_than_their_condition() {
    assert_bounded(&TWO_COORDINATES, Sample::bound);
}

/// Three coordinates are eliminated numerically. A heavy body adds a term to a pivot that is subtracted later; its
/// rounding error remains, and is relative to a light mass as many units as the ratio of the two.
#[test]
fn three_coordinates_lose_no_more_than_the_ratio_of_masses() {
    let spread = |sample: &Sample| sample.ratio.max(sample.ratio.recip());
    assert_bounded(&THREE_COORDINATES, |sample| spread(sample) * sample.bound());
}

/// At equal masses there is no cancellation beyond the conditioning.
#[test]
fn equal_masses_lose_no_more_than_their_condition() {
    assert_bounded(&[&TWO_COORDINATES[..], &THREE_COORDINATES[..]].concat(), |sample| {
        if sample.ratio == 1.0 {
            sample.bound()
        } else {
            f64::INFINITY
        }
    });
}

#[test]
fn the_data_are_whole() {
    let scenes = scenes();
    let names: Vec<&str> = scenes.iter().map(|scene| scene.name.as_str()).collect();
    assert_eq!(names, [&TWO_COORDINATES[..], &THREE_COORDINATES[..]].concat());
    for scene in &scenes {
        let mut ratios: Vec<f64> = scene.samples.iter().map(|sample| sample.ratio).collect();
        ratios.dedup();
        let expected: Vec<f64> = (-8..=8).map(|k| format!("1e{k}").parse().expect("a number")).collect();
        assert_eq!(ratios, expected, "{}", scene.name);
        assert!(scene.samples.len() >= 5 * ratios.len(), "{}", scene.name);
    }
}

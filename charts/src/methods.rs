//! Line styles of the methods, in the charts of all examples.

use crate::chart::{Line, Marker};
use crate::page::{BLUE, GREEN, INK, ORANGE, PURPLE, RGBColor, SKY, VERMILION};

/// Legend of the line styles.
pub fn legend() -> Vec<(Line, String)> {
    [
        (Line::solid(INK), "explicit methods"),
        (Line::dashed(INK), "implicit methods, Auto"),
    ]
    .map(|(line, name)| (line, name.to_owned()))
    .into()
}

/// Line style of a method, in all charts: each has a colour of its own, and a mark of its own among the explicit or the
/// implicit ones.
pub fn line(name: &str) -> Line {
    let explicit = |color, marker| Line::solid(color).marked(marker);
    let implicit = |color, marker| Line::dashed(color).marked(marker);
    match name {
        "Rk4" => explicit(SILVER, Marker::Square),
        "Rk45" => explicit(VERMILION, Marker::Up),
        "Tsit5" => explicit(ORANGE, Marker::Diamond),
        "Vern7" => explicit(SKY, Marker::Down),
        "Vern9" => explicit(BLUE, Marker::Circle),
        "Taylor" => explicit(GREEN, Marker::Cross),
        "Rodas4" => implicit(OLIVE, Marker::Up),
        "Rodas5P" => implicit(VIOLET, Marker::Circle),
        "Radau5" => implicit(PURPLE, Marker::Square),
        "Radau9" => implicit(TEAL, Marker::Square),
        "Radau13" => implicit(NAVY, Marker::Up),
        "Gauss4" => implicit(BROWN, Marker::Down),
        "Gauss6" => implicit(WINE, Marker::Diamond),
        "Gauss16" => implicit(RUST, Marker::Square),
        _ => implicit(INK, Marker::Cross),
    }
}

const SILVER: RGBColor = RGBColor(130, 130, 130);
const OLIVE: RGBColor = RGBColor(128, 138, 0);
const VIOLET: RGBColor = RGBColor(96, 60, 190);
const BROWN: RGBColor = RGBColor(130, 80, 40);
const TEAL: RGBColor = RGBColor(0, 130, 140);
const NAVY: RGBColor = RGBColor(20, 50, 120);
const WINE: RGBColor = RGBColor(150, 0, 60);
const RUST: RGBColor = RGBColor(200, 70, 90);

//! Line styles of the methods, in the charts of all examples.

use crate::chart::Line;
use crate::page::{BLUE, GREEN, GREY, INK, ORANGE, PURPLE, SKY, VERMILION};

/// Legend of the line styles.
pub fn legend() -> Vec<(Line, String)> {
    [
        (Line::solid(INK), "explicit methods"),
        (Line::dashed(INK), "implicit methods, Auto"),
    ]
    .map(|(line, name)| (line, name.to_owned()))
    .into()
}

/// Line style of a method, in all charts.
pub fn line(name: &str) -> Line {
    match name {
        "Rk4" => Line::solid(GREY),
        "Rk45" => Line::solid(VERMILION),
        "Tsit5" => Line::solid(ORANGE),
        "Vern7" => Line::solid(SKY),
        "Vern9" => Line::solid(BLUE),
        "Taylor" => Line::solid(GREEN),
        "Gauss4" => Line::dashed(VERMILION),
        "Gauss6" => Line::dashed(ORANGE),
        "Rodas4" => Line::dashed(SKY),
        "Rodas5P" => Line::dashed(BLUE),
        "Radau5" => Line::dashed(PURPLE),
        _ => Line::dashed(INK),
    }
}

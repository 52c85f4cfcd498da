//! Contour lines of numbers on a grid.

use std::collections::HashMap;
use std::ops::Range;

/// Contour line as a list of points.
pub type Path = Vec<(f64, f64)>;

/// Edge of the grid: column and row of its lower left end, and true if it is vertical.
type Edge = (usize, usize, bool);

/// Zero contours of the values at the points of a grid, by marching squares (W. E. Lorensen, H. E. Cline, Computer
/// Graphics 21 (1987) 163-169, in two dimensions).
///
/// The values are in rows of `across` points from the bottom; the first and the last row and column lie at the ends of
/// the ranges. There is no contour beside values that are not finite.
pub fn zeros(values: &[f64], across: usize, x: &Range<f64>, y: &Range<f64>) -> Vec<Path> {
    let down = values.len() / across;
    let part = |range: &Range<f64>, n: f64, of: usize| range.start + (range.end - range.start) * n / (of - 1) as f64;
    let at = |i: usize, j: usize| values[j * across + i];
    let crossing = |(i, j, up): Edge| {
        let (k, l) = if up { (i, j + 1) } else { (i + 1, j) };
        let (a, b) = (at(i, j), at(k, l));
        ((a < 0.0) != (b < 0.0) && (a - b).is_finite()).then(|| {
            let along = a / (a - b);
            let (right, above) = if up { (0.0, along) } else { (along, 0.0) };
            (part(x, i as f64 + right, across), part(y, j as f64 + above, down))
        })
    };
    // Connections of crossings through the cells. If all four edges of a cell are crossed, they are paired in cyclic
    // order.
    let mut joined: HashMap<Edge, Vec<Edge>> = HashMap::new();
    for i in 0..across - 1 {
        for j in 0..down - 1 {
            let around = [(i, j, false), (i + 1, j, true), (i, j + 1, false), (i, j, true)];
            let crossed: Vec<Edge> = around.into_iter().filter(|&edge| crossing(edge).is_some()).collect();
            for pair in crossed.chunks_exact(2) {
                joined.entry(pair[0]).or_default().push(pair[1]);
                joined.entry(pair[1]).or_default().push(pair[0]);
            }
        }
    }
    // Open lines first, from their ends, then closed ones.
    let mut starts: Vec<Edge> = joined.keys().copied().collect();
    starts.sort_by_key(|edge| (joined[edge].len(), *edge));
    let mut paths = Vec::new();
    for start in starts {
        let mut path: Path = Vec::new();
        let mut edge = Some(start);
        while let Some(here) = edge {
            path.extend(crossing(here));
            edge = joined.get_mut(&here).and_then(Vec::pop);
            if let Some(next) = edge
                && let Some(back) = joined.get_mut(&next)
            {
                back.retain(|other| *other != here);
            }
        }
        if path.len() > 1 {
            paths.push(path);
        }
    }
    paths
}

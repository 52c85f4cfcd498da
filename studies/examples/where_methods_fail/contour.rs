//! Contour lines of functions of two variables.

use std::collections::HashMap;
use std::ops::Range;

/// Contour line as a list of points.
pub(crate) type Path = Vec<(f64, f64)>;

/// Edge of the grid: indices of its lower left end, and true if it is vertical.
type Edge = (usize, usize, bool);

/// Zero contours of `f` in a rectangle, by marching squares on a grid of `cells` by `cells` (W. E. Lorensen, H. E.
/// Cline, Computer Graphics 21 (1987) 163-169, in two dimensions).
pub(crate) fn zeros(f: impl Fn(f64, f64) -> f64, x: &Range<f64>, y: &Range<f64>, cells: usize) -> Vec<Path> {
    let at = |range: &Range<f64>, n: usize| range.start + (range.end - range.start) * n as f64 / cells as f64;
    let values: Vec<Vec<f64>> = (0..=cells)
        .map(|i| (0..=cells).map(|j| f(at(x, i), at(y, j))).collect())
        .collect();
    let crossing = |(i, j, up): Edge| {
        let (k, l) = if up { (i, j + 1) } else { (i + 1, j) };
        let (a, b) = (values[i][j], values[k][l]);
        ((a < 0.0) != (b < 0.0)).then(|| {
            let part = a / (a - b);
            let between = |from: f64, to: f64| from + part * (to - from);
            (between(at(x, i), at(x, k)), between(at(y, j), at(y, l)))
        })
    };
    // Connections of crossings through the cells. If all four edges of a cell are crossed, they are paired in cyclic
    // order.
    let mut joined: HashMap<Edge, Vec<Edge>> = HashMap::new();
    for i in 0..cells {
        for j in 0..cells {
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

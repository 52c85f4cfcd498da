//! Line wrapping.

/// Maximum width of a line, in bytes.
const WIDTH: usize = 120;

/// Separator before a continuation line.
const CONTINUED: &str = "\n    ";

/// Wraps a line before the signs of its sums and between arguments, within as few brackets as possible.
pub(super) fn wrapped(line: &str) -> String {
    let breaks = breaks(line);
    let (mut text, mut start, mut room) = (String::new(), 0, WIDTH);
    while line.len() - start > room {
        let Some(end) = best(&breaks, start, room) else { break };
        text.push_str(&line[start..end]);
        text.push_str(CONTINUED);
        // skip the space that the line break replaces
        (start, room) = (end + 1, WIDTH + 1 - CONTINUED.len());
    }
    text + &line[start..]
}

/// Best break for the line from `start`: within the fewest brackets, then as late as possible, but not in its first
/// third.
fn best(breaks: &[Break], start: usize, room: usize) -> Option<usize> {
    let among = |from: usize, to: usize| {
        let inside = breaks
            .iter()
            .filter(move |own| (start + from..=start + to).contains(&own.at));
        inside
            .min_by_key(|own| (own.depth, usize::MAX - own.at))
            .map(|own| own.at)
    };
    let late = among(room / 3, room).or_else(|| among(1, room));
    late.or_else(|| breaks.iter().map(|own| own.at).find(|&at| at > start + room))
}

/// Space where a line may end.
struct Break {
    at: usize,
    /// Number of brackets around the space.
    depth: usize,
}

fn breaks(line: &str) -> Vec<Break> {
    let (mut depth, mut breaks) = (0_usize, Vec::new());
    for (at, c) in line.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            ' ' if [" + ", " - "].iter().any(|sign| line[at..].starts_with(sign)) || line[..at].ends_with(',') => {
                breaks.push(Break { at, depth });
            }
            _ => {}
        }
    }
    breaks
}

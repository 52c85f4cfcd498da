//! Lines of text that are not too long to read.

/// The width of a line, in letters.
const WIDTH: usize = 120;

/// What a line starts with that continues the one before.
const CONTINUED: &str = "\n    ";

/// A line, broken before the signs of its sums and between arguments, within as few brackets as may be.
pub(super) fn wrapped(line: &str) -> String {
    let breaks = breaks(line);
    let (mut text, mut start, mut room) = (String::new(), 0, WIDTH);
    while line.len() - start > room {
        let Some(end) = best(&breaks, start, room) else { break };
        text.push_str(&line[start..end]);
        text.push_str(CONTINUED);
        // without the space in whose place the line ends
        (start, room) = (end + 1, WIDTH + 1 - CONTINUED.len());
    }
    text + &line[start..]
}

/// Where the line from `start` should end: within the fewest brackets, as late as may be, but not in its first third.
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

/// A space where a line may end.
struct Break {
    at: usize,
    /// Within how many brackets it is.
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

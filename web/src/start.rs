//! States from which mechanisms can move.

use pendulum_runtime::{Method, Model, Motion, Slot, SlotKind};

/// Values from which the page starts, in SI units.
const STARTS: [f64; 8] = [2.0, 1.0, -1.0, -0.5, 0.5, -0.2, 0.2, 0.1];
/// Part of [`STARTS`] for angles of what slides above walls: a block stands up again.
const TILTED: f64 = 0.2;

/// State in which the page starts: the first from which the mechanism moves, with a value of the first angle, or else
/// of all coordinates, or of all rates.
pub(crate) fn start(model: &Model) -> Vec<f64> {
    let rest = model.state(&[]).unwrap_or_default();
    let slots: Vec<_> = model
        .layout()
        .slots
        .iter()
        .filter(|slot| !slot.rates.is_empty())
        .collect();
    let single = slots.iter().filter(|slot| slot.positions.len() == 1);
    let is_angle = |slot: &Slot<'_>| slot.kind == SlotKind::Angle;
    let slides = single.clone().any(|slot| !is_angle(slot));
    let is_bounded = model.constraints().len() > 0;
    let place = |slot: &Slot<'_>| {
        let part = if is_bounded && slides && is_angle(slot) {
            TILTED
        } else {
            1.0
        };
        (slot.positions.start, part)
    };
    let places: Vec<(usize, f64)> = single.clone().map(|slot| place(slot)).collect();
    let first = places.iter().zip(single).find(|(_, slot)| is_angle(slot));
    let first = first.map(|(own, _)| *own).into_iter().collect();
    let rates = slots.iter().flat_map(|slot| slot.rates.clone()).map(|rate| (rate, 1.0));
    let (mut values, mut tries) = (STARTS, [first, places, rates.collect()]);
    if is_bounded {
        // near the stops and walls, and above them rather than tilted into them
        values.reverse();
        tries.swap(0, 1);
    }
    let tries = tries.iter().flat_map(|own| values.map(|value| (own, value)));
    let mut states = tries.filter_map(|(own, value)| {
        let mut x = rest.clone();
        own.iter().for_each(|&(place, part)| x[place] = part * value);
        let x = model.assemble(0.0, &x).ok()?;
        moves(model, &x).then_some(x)
    });
    let found = states.next();
    found.unwrap_or(rest)
}

/// Motion from a state for a short time, if the mechanism can move from there.
fn short_motion(model: &Model, t: f64, time: f64, x: &[f64]) -> Option<Motion> {
    let method = Method::new("Vern9").ok()?;
    model.solve(&method, [t, t + time], x).ok()
}

/// True if the mechanism moves from a state.
fn moves(model: &Model, x: &[f64]) -> bool {
    let differs = |(after, before): (&f64, &f64)| (after - before).abs() > 1e-6;
    short_motion(model, 0.0, 0.02, x).is_some_and(|motion| motion.end().1.iter().zip(x).any(differs))
}

/// True if the mechanism can move from a state: it lies within its stops and walls.
pub(crate) fn can_move(model: &Model, t: f64, x: &[f64]) -> bool {
    short_motion(model, t, 1e-6, x).is_some()
}

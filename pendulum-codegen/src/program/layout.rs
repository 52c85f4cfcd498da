//! What the components of a state are.

use std::ops::Range;

use crate::model::Model;

/// The parts of the state.
#[derive(Clone, Debug)]
pub struct StateLayout {
    /// The coordinates, in the order of their declaration.
    pub slots: Vec<Slot>,
}

/// A coordinate of the state.
#[derive(Clone, Debug)]
pub struct Slot {
    /// Its name.
    pub name: String,
    /// What it measures.
    pub kind: SlotKind,
    /// Where its positions stand in the state.
    pub positions: Range<usize>,
    /// Where its rates stand in the state.
    pub rates: Range<usize>,
}

/// What a coordinate measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlotKind {
    /// An angle in radians.
    Angle,
    /// A length in metres.
    Length,
}

impl StateLayout {
    /// The layout of the states of a scene.
    pub(super) fn new(model: &Model) -> Self {
        let dof = model.dof();
        let slot = |(k, name): (usize, &str)| Slot {
            name: name.to_owned(),
            kind: SlotKind::Angle,
            positions: k..k + 1,
            rates: dof + k..dof + k + 1,
        };
        Self {
            slots: model.coordinate_names().into_iter().enumerate().map(slot).collect(),
        }
    }

    /// The number of components of the state.
    pub fn len(&self) -> usize {
        self.slots
            .iter()
            .map(|slot| slot.positions.len() + slot.rates.len())
            .sum()
    }

    /// Whether the state has no components.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The number of degrees of freedom: of rates.
    pub fn dof(&self) -> usize {
        self.slots.iter().map(|slot| slot.rates.len()).sum()
    }
}

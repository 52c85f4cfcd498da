//! Models and states that are padded to one of few lengths.

use std::collections::BTreeMap;

use nalgebra::SVector;
use pendulum_core::inputs::TimeTable;
use pendulum_core::tape::{self, HybridModel};

/// A model with a state of `N` components, the last of which may be padding.
pub(crate) type Padded<T, const N: usize> = HybridModel<T, N>;

/// A model without dry friction, stops and walls, for ensembles in lanes.
pub(crate) type Smooth<const N: usize> = tape::Model<f64, N>;

/// Longest state.
pub(crate) const LONGEST: usize = if cfg!(feature = "full") { 64 } else { 32 };

/// State with padding.
pub(crate) fn padded<const N: usize>(x: &[f64]) -> SVector<f64, N> {
    SVector::from_fn(|n, _| x.get(n).copied().unwrap_or_default())
}

/// Components of a state without padding.
pub(crate) fn active<const N: usize>(x: SVector<f64, N>, length: usize) -> Vec<f64> {
    x.as_slice()[..length].to_vec()
}

/// Lets inputs of a model follow samples, in place of what they followed before.
pub(crate) fn follow<const N: usize>(
    model: &mut Padded<f64, N>,
    laws: impl IntoIterator<Item = (usize, TimeTable<1>)>,
) {
    let own = model.input_laws().map(|(input, law)| (input, law.clone()));
    let all: BTreeMap<_, _> = own.chain(laws).collect();
    model.set_laws(all.into_iter().collect());
}

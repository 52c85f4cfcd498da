//! Rooted trees, one for each order condition.

/// A rooted tree, made from a smaller one by adding a branch at its root: the Butcher product of two trees that precede
/// it in the list of [`trees`].
///
/// Hairer, Norsett, Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993), II.2.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tree {
    /// Number of nodes.
    pub(crate) order: usize,
    /// Density `gamma(t)`: the condition is `sum_i b_i Phi_i(t) = 1 / gamma(t)`.
    pub(crate) density: f64,
    /// Index of the tree without its last branch, and index of that branch; `None` for a single node.
    pub(crate) parts: Option<(usize, usize)>,
}

/// All rooted trees up to an order, smaller ones first.
pub(crate) fn trees(max_order: usize) -> Vec<Tree> {
    let mut trees = vec![Tree {
        order: 1,
        density: 1.0,
        parts: None,
    }];
    for order in 2..=max_order {
        let smaller = trees.clone();
        for (base, trunk) in smaller.iter().enumerate() {
            for (branch, bough) in smaller.iter().enumerate() {
                // The branches at a root are unordered: add them in the order of the list.
                let is_sorted = trunk.parts.is_none_or(|(_, last)| last <= branch);
                if trunk.order + bough.order == order && is_sorted {
                    // The density is the number of nodes times the densities of all branches; those of the trunk are
                    // already included.
                    let factor = order as f64 / trunk.order as f64;
                    trees.push(Tree {
                        order,
                        density: (factor * trunk.density * bough.density).round(),
                        parts: Some((base, branch)),
                    });
                }
            }
        }
    }
    trees
}

#[test]
fn every_tree_comes_once() {
    // Hairer, Norsett, Wanner I, II.2, Table 2.1.
    let counts = [1, 1, 2, 4, 9, 20, 48, 115, 286, 719];
    let trees = trees(counts.len());
    for (i, count) in counts.into_iter().enumerate() {
        let of_order = trees.iter().filter(|tree| tree.order == i + 1);
        assert_eq!(of_order.count(), count);
    }
    // Among the trees of an order, the one without forks has the largest density, and the bush the smallest.
    let of_order = |order| {
        trees
            .iter()
            .filter(move |tree| tree.order == order)
            .map(|tree| tree.density)
    };
    assert_eq!(of_order(10).fold(0.0, f64::max), 3_628_800.0);
    assert_eq!(of_order(10).fold(f64::INFINITY, f64::min), 10.0);
}

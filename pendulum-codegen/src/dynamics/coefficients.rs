//! A, B and C of the equations of motion in joint coordinates, by the corrected Eqs. 17 to 19 of Williams (2023).

use std::collections::BTreeMap;

use super::Kinematics;
use crate::expr::{ExprId, Graph, ratio};
use crate::model::Model;
use crate::screw::{Twist, Wrench, bracket, cross, scale};

/// `tau_i = sum_j A_ij qdd_j + sum_jk B_ijk qd_j qd_k + C_i`, where the indices run over the bodies of a model.
/// Entries of fixed joints, and of bodies that are not on one path from the ground, are zero and left out.
#[derive(Debug)]
pub struct Coefficients {
    /// `A_ij` for `i <= j`.
    pub a: BTreeMap<(usize, usize), ExprId>,
    /// `B_ijk` for `j <= k`.
    pub b: BTreeMap<(usize, usize, usize), ExprId>,
    /// `C_i`.
    pub c: BTreeMap<usize, ExprId>,
}

impl Coefficients {
    /// The coefficients of a model.
    pub fn new(model: &Model, kinematics: &mut Kinematics) -> Self {
        let (count, g) = (model.bodies.len(), &model.graph);
        let mut coefficients = Self {
            a: BTreeMap::new(),
            b: BTreeMap::new(),
            c: BTreeMap::new(),
        };
        for x in 0..count {
            // the joints on the path to x, and their screws in the station of x
            let path: Vec<usize> = (0..=x).filter(|&i| kinematics.carries(i, x)).collect();
            let path: Vec<(usize, Twist)> = path
                .into_iter()
                .filter_map(|i| Some((i, kinematics.screw(g, i, x)?)))
                .collect();
            if path.last().is_none_or(|(last, _)| *last != x) {
                continue;
            }
            coefficients.outermost(g, kinematics, x, &path);
        }
        coefficients
    }

    /// All entries whose outermost body is `x`.
    fn outermost(&mut self, g: &Graph, kinematics: &Kinematics, x: usize, path: &[(usize, Twist)]) {
        let inertia = *kinematics.composite(x);
        let momenta: Vec<Wrench> = path.iter().map(|(_, screw)| inertia.momentum(g, screw)).collect();
        let own = path.len() - 1;
        for (i, screw) in path {
            let entry = momenta[own].power(g, screw);
            self.a.insert((*i, x), entry);
        }
        let gravity = kinematics.gravity(g, x);
        let weight = Wrench {
            moment: cross(g, inertia.moment, gravity),
            force: scale(g, inertia.mass, gravity),
        };
        let work = weight.power(g, &path[own].1);
        let entry = g.neg(work);
        self.c.insert(x, entry);
        // brackets[i][k] = [s_i, s_k]
        let brackets: Vec<Vec<Twist>> = path
            .iter()
            .map(|(_, a)| path.iter().map(|(_, b)| bracket(g, a, b)).collect())
            .collect();
        let half = g.number(ratio(1, 2));
        for i in 0..=own {
            for j in 0..=own {
                for k in j..=own {
                    if i.max(k) != own {
                        continue;
                    }
                    let first = momenta[j].power(g, &brackets[i][k]);
                    let second = momenta[k].power(g, &brackets[i][j]);
                    let third = momenta[i].power(g, &brackets[k][j]);
                    let both = g.add(first, second);
                    let twice = g.sub(both, third);
                    let entry = g.mul(half, twice);
                    self.b.insert((path[i].0, path[j].0, path[k].0), entry);
                }
            }
        }
    }
}

//! Coefficients A, B and C of the equations of motion in joint coordinates, by the corrected Eqs. 17 to 19 of Williams
//! (2023).

use std::collections::BTreeMap;

use super::Kinematics;
use crate::expr::{Expr, ratio};
use crate::model::{BodyId, Model};
use crate::screw::{Twist, Wrench};

/// Coefficients of `tau_i = sum_j A_ij qdd_j + sum_jk B_ijk qd_j qd_k + C_i`, where the indices run over the bodies of
/// a model. Entries of fixed joints, and of bodies not on one path from the ground, are zero and left out.
#[derive(Debug, Default)]
pub(crate) struct Coefficients<'g> {
    /// `A_ij` for `i <= j`.
    pub a: BTreeMap<(BodyId, BodyId), Expr<'g>>,
    /// `B_ijk` for `j <= k`.
    pub b: BTreeMap<(BodyId, BodyId, BodyId), Expr<'g>>,
    /// `C_i`.
    pub c: BTreeMap<BodyId, Expr<'g>>,
}

impl<'g> Coefficients<'g> {
    /// Computes the coefficients of a model.
    pub(crate) fn new(model: &Model<'g>, kinematics: &mut Kinematics<'g>) -> Self {
        let mut coefficients = Self::default();
        for x in BodyId::all(model.bodies.len()) {
            if kinematics.screw(x, x).is_none() {
                continue;
            }
            // the joints on the path to x, and their screws in the station of x
            let path: Vec<(BodyId, Twist<'g>)> = BodyId::all(usize::from(x) + 1)
                .filter(|&i| kinematics.carries(i, x))
                .collect::<Vec<_>>()
                .into_iter()
                .filter_map(|i| Some((i, kinematics.screw(i, x)?)))
                .collect();
            coefficients.outermost(kinematics, x, &path);
        }
        coefficients
    }

    /// Computes all entries whose outermost body is `x`, in its station, where N is `N_x^+` and g gravity:
    ///
    /// ```text
    /// A_ix  = s_i^T N s_x    C_x = -s_x^T (N g)
    /// B_ijk = 1/2 (s_j^T N [s_i, s_k] + s_k^T N [s_i, s_j] - s_i^T N [s_k, s_j])
    /// ```
    fn outermost(&mut self, kinematics: &Kinematics<'g>, x: BodyId, path: &[(BodyId, Twist<'g>)]) {
        let n = kinematics.composite(x);
        let own = path.len() - 1;
        let s: Vec<Twist<'g>> = path.iter().map(|(_, screw)| *screw).collect();
        // N s_i
        let momenta: Vec<Wrench<'g>> = s.iter().map(|&screw| n * screw).collect();
        for (i, screw) in path {
            self.a.insert((*i, x), momenta[own].power(screw));
        }
        let gravity = kinematics.gravity(x);
        let weight = Wrench {
            moment: n.moment.cross(gravity),
            force: n.mass * gravity,
        };
        self.c.insert(x, -weight.power(&s[own]));
        let brackets: Vec<Vec<Twist<'g>>> = s.iter().map(|si| s.iter().map(|sk| si.bracket(sk)).collect()).collect();
        for i in 0..=own {
            for j in 0..=own {
                for k in j..=own {
                    if i.max(k) != own {
                        continue;
                    }
                    // 1/2 (s_j N [s_i, s_k] + s_k N [s_i, s_j] - s_i N [s_k, s_j])
                    let [first, second, third] =
                        [(j, i, k), (k, i, j), (i, k, j)].map(|(n, a, b)| momenta[n].power(&brackets[a][b]));
                    let entry = ratio(1, 2) * (first + second - third);
                    self.b.insert((path[i].0, path[j].0, path[k].0), entry);
                }
            }
        }
    }
}

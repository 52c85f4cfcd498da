//! Three of the [twelve problems](crate::problems) as equations by hand.

use nalgebra::SVector;
use pendulum_core::Real;
use pendulum_core::system::{Equations, EquationsSystem};

/// A star in the field of a galaxy: [`crate::problems::HenonHeiles`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HenonHeiles;

impl Equations<4> for HenonHeiles {
    fn rhs<T: Real>(&self, _t: T, state: &SVector<T, 4>) -> SVector<T, 4> {
        let [x, y, u, v] = state.data.0[0];
        let product = x * y;
        SVector::from([u, v, -x - (product + product), y * y - x * x - y])
    }
}

/// A satellite between the earth and the moon: [`crate::problems::Arenstorf`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arenstorf {
    /// Mass of the moon, as a part of both masses.
    pub moon: f64,
}

impl Equations<4> for Arenstorf {
    fn rhs<T: Real>(&self, _t: T, state: &SVector<T, 4>) -> SVector<T, 4> {
        let [x, y, u, v] = state.data.0[0];
        let [moon, earth, two] = [self.moon, 1.0 - self.moon, 2.0].map(T::from_f64);
        let pull = |mass: T, x: T| {
            let square = x * x + y * y;
            mass / (square * square.sqrt())
        };
        let [from_earth, from_moon] = [x + moon, x - earth];
        let [to_earth, to_moon] = [pull(earth, from_earth), pull(moon, from_moon)];
        SVector::from([
            u,
            v,
            x + two * v - to_earth * from_earth - to_moon * from_moon,
            y - two * u - (to_earth + to_moon) * y,
        ])
    }
}

/// Seven stars of masses 1 to 7 in a plane: [`crate::problems::Pleiades`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pleiades;

impl Equations<28> for Pleiades {
    fn rhs<T: Real>(&self, _t: T, state: &SVector<T, 28>) -> SVector<T, 28> {
        let mut rates = SVector::from([T::default(); 28]);
        for n in 0..14 {
            rates[n] = state[n + 14];
        }
        for star in 0..7 {
            for other in 0..star {
                let away = [0, 1].map(|axis| state[2 * other + axis] - state[2 * star + axis]);
                let square = away[0] * away[0] + away[1] * away[1];
                let over = T::from_f64(1.0) / (square * square.sqrt());
                for (axis, away) in away.into_iter().enumerate() {
                    let pull = over * away;
                    let [mass, others] = [star, other].map(|n| T::from_f64((n + 1) as f64));
                    rates[14 + 2 * star + axis] += others * pull;
                    rates[14 + 2 * other + axis] -= mass * pull;
                }
            }
        }
        rates
    }
}

/// The three, with the constants of the declared ones.
#[must_use]
pub fn three() -> (
    EquationsSystem<HenonHeiles>,
    EquationsSystem<Arenstorf>,
    EquationsSystem<Pleiades>,
) {
    let arenstorf = Arenstorf { moon: 0.012_277_471 };
    (
        EquationsSystem(HenonHeiles),
        EquationsSystem(arenstorf),
        EquationsSystem(Pleiades),
    )
}

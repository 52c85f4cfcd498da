//! Mechanisms of the paper (H. Williams, Forces in Mechanics 2023), of its references, and beyond: each declared in a few
//! lines, checked against something independent, and drawn.
#![forbid(unsafe_code)]

use std::error::Error;
use std::fmt;
use std::path::{Path, PathBuf};

use nalgebra::{Quaternion, Rotation3, SVector, UnitQuaternion};
use pendulum_core::dual::Dual;
use pendulum_core::prelude::*;
use pendulum_core::shapes::Shapes;
use pendulum_core::{Cast, Solution};
use pendulum_draw::Drawing;

pub mod arm;
pub mod asymmetric;
pub mod ball_pendulum;
pub mod bars_and_squares;
pub mod bennett;
pub mod bouncing_ball;
pub mod cart_pole;
pub mod coupled_pendulums;
pub mod cubic;
pub mod double_four_bar;
pub mod driven_pivot;
pub mod five_bar;
pub mod four_bar;
pub mod furuta;
pub mod kapitza;
pub mod leg;
pub mod magnets;
mod page;
pub mod point_masses;
pub mod quadruped;
pub mod rocking_block;
pub mod rods_and_wall;
pub mod slider_crank;
pub mod spring_suspended;
pub mod squeezer;
pub mod stick_slip;
pub mod triple;
pub mod tumbling_body;
pub mod two_bodies;

pub use page::page;

/// A system of the gallery.
#[derive(Clone, Copy, Debug)]
pub struct System {
    /// The name of its file.
    pub name: &'static str,
    /// Its file: the text, the declarations, the checks.
    pub source: &'static str,
    /// Integrates and checks it.
    pub run: fn() -> Result<Run, Box<dyn Error>>,
}

/// Lists the systems by the names of their modules.
macro_rules! systems {
    ($($name:ident),* $(,)?) => {
        &[$(System {
            name: stringify!($name),
            source: include_str!(concat!(stringify!($name), ".rs")),
            run: $name::run,
        }),*]
    };
}

/// All systems, in the order of the gallery.
pub const SYSTEMS: &[System] = systems![
    point_masses,
    asymmetric,
    bars_and_squares,
    two_bodies,
    triple,
    leg,
    spring_suspended,
    cubic,
    driven_pivot,
    kapitza,
    magnets,
    coupled_pendulums,
    cart_pole,
    furuta,
    arm,
    tumbling_body,
    ball_pendulum,
    quadruped,
    four_bar,
    slider_crank,
    five_bar,
    double_four_bar,
    squeezer,
    bennett,
    stick_slip,
    bouncing_ball,
    rocking_block,
    rods_and_wall,
];

/// What came out.
pub struct Run {
    /// What was compared.
    pub checks: Vec<Check>,
    draw: Draw,
}

/// Draws the motion into the files of a stem: a picture, and an animation if that is wanted.
type Draw = Box<dyn Fn(&Path, bool) -> Result<Vec<PathBuf>, Box<dyn Error>>>;

impl Run {
    /// The checks, and the balance of power along a motion of a model; `powers` are those of all that has no potential.
    fn new<M, const N: usize>(
        mut checks: Vec<Check>,
        model: M,
        solution: Solution<f64, N>,
        powers: impl Fn(f64, &SVector<f64, N>) -> Vec<f64>,
        view: impl Fn(Drawing<'_, M, N>) -> Drawing<'_, M, N> + 'static,
    ) -> Result<Self, Box<dyn Error>>
    where
        M: pendulum_core::System<f64, N> + Cast<N> + Shapes<N> + 'static,
        M::In<Dual<f64, 1>>: Energy<Dual<f64, 1>, N>,
    {
        let residual = balance(&model, &solution, powers)?;
        checks.push(Check::new("power balance, in its largest term", residual, 0.0, 1e-12));
        let draw = move |stem: &Path, animate: bool| -> Result<Vec<PathBuf>, Box<dyn Error>> {
            let drawing = || view(Drawing::new(&model, &solution));
            let mut files = drawing().picture(stem)?.to_vec();
            if animate {
                files.push(drawing().animation(stem)?);
            }
            Ok(files)
        };
        Ok(Self {
            checks,
            draw: Box::new(draw),
        })
    }

    /// Writes the picture to a stem, with the animation if that is wanted, and says where.
    pub fn draw(&self, stem: &Path, animate: bool) -> Result<Vec<PathBuf>, Box<dyn Error>> {
        (self.draw)(stem, animate)
    }
}

/// A number beside what is known of it.
#[derive(Clone, Debug)]
pub struct Check {
    what: String,
    found: f64,
    known: f64,
    within: f64,
}

impl Check {
    fn new(what: impl Into<String>, found: f64, known: f64, within: f64) -> Self {
        let what = what.into();
        Self {
            what,
            found,
            known,
            within,
        }
    }

    /// The largest difference of two lists.
    fn same(what: impl Into<String>, found: &[f64], known: &[f64], within: f64) -> Self {
        let pairs = found.iter().zip(known);
        let largest = pairs.fold(0.0, |largest, (found, known)| larger(largest, (found - known).abs()));
        let complete = if found.len() == known.len() { largest } else { f64::NAN };
        Self::new(what, complete, 0.0, within)
    }

    /// Whether the two agree.
    pub fn holds(&self) -> bool {
        (self.found - self.known).abs() <= self.within
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let verdict = if self.holds() { "ok" } else { "WRONG" };
        if self.known == 0.0 {
            return write!(
                f,
                "{}: {:.1e} (at most {:e}) {verdict}",
                self.what, self.found, self.within
            );
        }
        let (found, known) = (self.found, self.known);
        write!(
            f,
            "{}: {found:.6}, known {known:.6} (to {:.1e}) {verdict}",
            self.what, self.within
        )
    }
}

/// The larger of two numbers; NaN if one of them is.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// What is left of d(energy)/dt less the powers, at its largest along a motion, in the largest term of either: the share of each
/// component of the state in d(energy)/dt is one, so that a body which keeps its energy has terms as well.
fn balance<M, const N: usize>(
    model: &M,
    solution: &Solution<f64, N>,
    powers: impl Fn(f64, &SVector<f64, N>) -> Vec<f64>,
) -> Result<f64, Box<dyn Error>>
where
    M: pendulum_core::System<f64, N> + Cast<N>,
    M::In<Dual<f64, 1>>: Energy<Dual<f64, 1>, N>,
{
    /// Times at which it is taken.
    const SAMPLES: usize = 100;
    let dual = model.cast::<Dual<f64, 1>>();
    let (start, end) = (solution.t()[0], solution.last().0);
    let (mut residual, mut largest) = (0.0_f64, 0.0_f64);
    for n in 0..=SAMPLES {
        let part = n as f64 / SAMPLES as f64;
        let t = (1.0 - part) * start + part * end;
        let mut x = solution.at(t)?;
        // between the steps it is as far from there as the dense output is from the motion
        model.project(t, &mut x);
        let rate = model.rhs(t, &x);
        // that of the time is the last
        let share = |of: usize| {
            let along = |k: usize, value: f64, slope: f64| Dual {
                value,
                slopes: [if k == of { slope } else { 0.0 }],
            };
            let state = SVector::from_fn(|k, _| along(k, x[k], rate[k]));
            let t = along(N, t, 1.0);
            (dual.kinetic(t, &state) + dual.potential(t, &state)).slopes[0]
        };
        let shares: Vec<f64> = (0..=N).map(share).collect();
        let powers = powers(t, &x);
        let terms = shares.iter().chain(&powers);
        largest = terms.fold(largest, |largest, term| larger(largest, term.abs()));
        residual = larger(
            residual,
            (shares.iter().sum::<f64>() - powers.iter().sum::<f64>()).abs(),
        );
    }
    Ok(residual / largest)
}

/// The rotation from body to parent of the orientation at a place in a state.
fn orientation<const N: usize>(x: &SVector<f64, N>, at: usize) -> Rotation3<f64> {
    UnitQuaternion::from_quaternion(Quaternion::new(x[at], x[at + 1], x[at + 2], x[at + 3])).to_rotation_matrix()
}

/// The impacts of a motion: their times, and the states before and after.
fn impacts<const N: usize>(
    solution: &Solution<f64, N>,
) -> impl Iterator<Item = (f64, SVector<f64, N>, SVector<f64, N>)> {
    let pairs = solution.points().zip(solution.points().skip(1));
    let impacts = pairs.filter(|((before, _), (after, _))| before == after);
    impacts.map(|((t, before), (_, after))| (t, *before, *after))
}

/// The Jacobian against extrapolated differences.
fn jacobian_by_differences<M: Jacobian<f64, N>, const N: usize>(model: &M, t: f64, x: [f64; N]) -> Check {
    let x = SVector::from(x);
    let mut by_differences: SMatrix<f64, N, N> = SMatrix::zeros();
    for k in 0..N {
        let moved = |h: f64| {
            let mut x = x;
            x[k] += h;
            model.rhs(t, &x)
        };
        let slope = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
        by_differences.set_column(k, &((4.0 * slope(2e-4) - slope(4e-4)) / 3.0));
    }
    let ours = model.jacobian(t, &x);
    let error = (ours - by_differences).amax() / ours.amax();
    Check::new("Jacobian by differences, in its largest entry", error, 0.0, 1e-9)
}

/// Imaginary parts of eigenvalues: the angular frequencies of the modes about a state, from the lowest on.
fn frequencies<M: Jacobian<f64, N>, const N: usize>(model: &M, x: [f64; N]) -> Result<Vec<f64>, Box<dyn Error>> {
    let spectrum = pendulum_core::stability::Spectrum::of(&model.jacobian(0.0, &SVector::from(x)))?;
    let mut frequencies: Vec<f64> = spectrum
        .eigenvalues()
        .map(|value| value.im)
        .filter(|w| *w > 0.0)
        .collect();
    frequencies.sort_by(f64::total_cmp);
    Ok(frequencies)
}

/// The frequencies of `M x'' + K x = 0` for two coordinates, from the lower on.
fn two_modes([[m11, m12], [_, m22]]: [[f64; 2]; 2], [[k11, k12], [_, k22]]: [[f64; 2]; 2]) -> [f64; 2] {
    // det(K - w^2 M) = a w^4 - b w^2 + c
    let (a, b, c) = (
        m11 * m22 - m12 * m12,
        m11 * k22 + m22 * k11 - 2.0 * m12 * k12,
        k11 * k22 - k12 * k12,
    );
    let root = (b * b - 4.0 * a * c).sqrt();
    [(b - root) / (2.0 * a), (b + root) / (2.0 * a)].map(f64::sqrt)
}

/// Accelerations of a compound double pendulum without friction, in absolute angles: body 1 of inertia `i1` about its centre of mass,
/// which lies `c1` from its axle and `alpha1` ahead of its angle, and so body 2, whose axle lies `d` below the first along body 1.
fn double_pendulum(
    [m1, c1, i1, alpha1]: [f64; 4],
    [m2, c2, i2, alpha2]: [f64; 4],
    d: f64,
    g: f64,
    [a, b, da, db]: [f64; 4],
) -> [f64; 2] {
    let (sine, cosine) = (a - b - alpha2).sin_cos();
    let coupling = m2 * d * c2;
    let mass = [i1 + m1 * c1 * c1 + m2 * d * d, coupling * cosine, i2 + m2 * c2 * c2];
    let first = -coupling * sine * db * db - g * (m1 * c1 * (a + alpha1).sin() + m2 * d * a.sin());
    let second = coupling * sine * da * da - m2 * c2 * g * (b + alpha2).sin();
    solve_two(mass, [first, second])
}

/// The accelerations of two coordinates, from the entries `m11, m12, m22` of their mass matrix and the forces on them.
fn solve_two([m11, m12, m22]: [f64; 3], [first, second]: [f64; 2]) -> [f64; 2] {
    let determinant = m11 * m22 - m12 * m12;
    [
        (m22 * first - m12 * second) / determinant,
        (m11 * second - m12 * first) / determinant,
    ]
}

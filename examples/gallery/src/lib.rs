//! Mechanisms of the paper (H. Williams, Forces in Mechanics 2023), of its references, and beyond: each is declared in
//! a few lines, checked against independent results, and drawn.
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
pub mod motor;
mod page;
pub mod point_masses;
pub mod quadruped;
pub mod rocking_block;
pub mod rods_and_wall;
pub mod slider_crank;
pub mod spring_suspended;
pub mod squeezer;
pub mod stick_slip;
pub mod thrown_die;
pub mod triple;
pub mod tumbling_body;
pub mod two_bodies;

pub use page::page;

/// System of the gallery.
#[derive(Clone, Copy, Debug)]
pub struct System {
    /// Name of its file.
    pub name: &'static str,
    /// Contents of its file: the text, the declarations, the checks.
    pub source: &'static str,
    /// Integrates and checks the system.
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
    motor,
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
    thrown_die,
    rods_and_wall,
];

/// Result of a run.
pub struct Run {
    /// Comparisons with known results.
    pub checks: Vec<Check>,
    draw: Draw,
}

/// Draws the motion into files with a given stem: a picture, and optionally an animation.
type Draw = Box<dyn Fn(&Path, bool) -> Result<Vec<PathBuf>, Box<dyn Error>>>;

impl Run {
    /// Adds the power balance along a motion to the checks; `powers` lists the powers of all forces without a
    /// potential.
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

    /// Writes the picture to a stem, optionally with the animation, and returns the paths.
    pub fn draw(&self, stem: &Path, animate: bool) -> Result<Vec<PathBuf>, Box<dyn Error>> {
        (self.draw)(stem, animate)
    }
}

/// Number compared with its known value.
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

    /// Compares two lists by their largest difference.
    fn same(what: impl Into<String>, found: &[f64], known: &[f64], within: f64) -> Self {
        let pairs = found.iter().zip(known);
        let largest = pairs.fold(0.0, |largest, (found, known)| larger(largest, (found - known).abs()));
        let complete = if found.len() == known.len() { largest } else { f64::NAN };
        Self::new(what, complete, 0.0, within)
    }

    /// True if the two agree.
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

/// Largest residual of d(energy)/dt minus the powers along a motion, relative to the largest term. Each component of
/// the state contributes its own term to d(energy)/dt, so that there are terms even if the energy is conserved.
fn balance<M, const N: usize>(
    model: &M,
    solution: &Solution<f64, N>,
    powers: impl Fn(f64, &SVector<f64, N>) -> Vec<f64>,
) -> Result<f64, Box<dyn Error>>
where
    M: pendulum_core::System<f64, N> + Cast<N>,
    M::In<Dual<f64, 1>>: Energy<Dual<f64, 1>, N>,
{
    /// Number of sample times.
    const SAMPLES: usize = 100;
    let dual = model.cast::<Dual<f64, 1>>();
    let (start, end) = (solution.t()[0], solution.last().0);
    let (mut residual, mut largest) = (0.0_f64, 0.0_f64);
    for n in 0..=SAMPLES {
        let part = n as f64 / SAMPLES as f64;
        let t = (1.0 - part) * start + part * end;
        let mut x = solution.at(t)?;
        // between steps, the dense output satisfies the constraints only up to its error
        model.project(t, &mut x);
        let rate = model.rhs(t, &x);
        // the last share is the explicit dependence on time
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

/// Rotation from body to parent, given the index of the orientation in the state.
fn orientation<const N: usize>(x: &SVector<f64, N>, at: usize) -> Rotation3<f64> {
    UnitQuaternion::from_quaternion(Quaternion::new(x[at], x[at + 1], x[at + 2], x[at + 3])).to_rotation_matrix()
}

/// Impacts of a motion: their times, and the states before and after.
fn impacts<const N: usize>(
    solution: &Solution<f64, N>,
) -> impl Iterator<Item = (f64, SVector<f64, N>, SVector<f64, N>)> {
    let pairs = solution.points().zip(solution.points().skip(1));
    let impacts = pairs.filter(|((before, _), (after, _))| before == after);
    impacts.map(|((t, before), (_, after))| (t, *before, *after))
}

/// Compares the Jacobian with extrapolated differences.
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

/// Angular frequencies of the modes about a state (imaginary parts of eigenvalues), in ascending order.
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

/// Frequencies of `M x'' + K x = 0` for two coordinates, in ascending order.
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

/// Accelerations of a compound double pendulum without friction, in absolute angles. Body 1 has inertia `i1` about its
/// centre of mass, which lies `c1` from its joint and `alpha1` ahead of its angle; likewise body 2, whose joint lies
/// `d` below the first along body 1.
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

/// Accelerations of two coordinates, from the entries `m11, m12, m22` of their mass matrix and the forces on them.
fn solve_two([m11, m12, m22]: [f64; 3], [first, second]: [f64; 2]) -> [f64; 2] {
    let determinant = m11 * m22 - m12 * m12;
    [
        (m22 * first - m12 * second) / determinant,
        (m11 * second - m12 * first) / determinant,
    ]
}

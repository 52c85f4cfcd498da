//! Twelve problems on which methods are measured: three motions of the double pendulum, three of celestial mechanics,
//! three stiff ones of chemistry and electronics, and three mechanisms.
//!
//! E. Hairer, S. P. Norsett, G. Wanner, "Solving Ordinary Differential Equations I" (1993), II.0 and II.10, has the
//! orbits; E. Hairer, G. Wanner, "II" (1996), IV.1 and IV.10, the stiff problems; F. Mazzia, C. Magherini, "Test Set
//! for Initial Value Problem Solvers", release 2.4 (2008), the final states of most.

use std::error::Error;

use nalgebra::SVector;
use pendulum_core::accuracy::Reference;
use pendulum_core::{
    Canonical, Cast, CastJacobian, CastTaylor, Jacobian, Method, Radau9, Radau13, SolveError, Taylor, TaylorSeries,
    Vern9, mechanism,
};
use serde_json::Value;

use crate::counted::Counted;
use crate::linkages::{Andrews, AndrewsParams};
use crate::motions::motion;
use crate::scenes::double_pendulum;
use crate::trajectories;
use crate::work::Scene;

mechanism! {
    /// A star in the field of a galaxy (M. Henon, C. Heiles, Astron. J. 69 (1964) 73).
    pub HenonHeiles {
        units: none,
        generate: [rhs, jacobian, energy, taylor, canonical],
        potential: (x^2 + y^2)/2 + x^2*y - y^3/3,
        body slide on ground { joint: prismatic(x), coordinate: x }
        body star on slide { mass: 1, joint: prismatic(y), coordinate: y }
    }
}

mechanism! {
    /// A satellite between the earth and the moon, in coordinates that turn with them (R. F. Arenstorf, Amer. J. Math.
    /// 85 (1963) 27).
    pub Arenstorf {
        units: none,
        params { moon = 0.012277471 }
        generate: [rhs, jacobian, taylor],
        let earth = 1 - moon,
        let to_earth = ((x + moon)^2 + y^2)^(3/2),
        let to_moon = ((x - earth)^2 + y^2)^(3/2),
        state x { rate: u }
        state y { rate: v }
        state u { rate: x + 2*v - earth*(x + moon)/to_earth - moon*(x - earth)/to_moon }
        state v { rate: y - 2*u - earth*y/to_earth - moon*y/to_moon }
    }
}

mechanism! {
    /// Seven stars of masses 1 to 7 in a plane.
    pub Pleiades {
        units: none,
        generate: [rhs, jacobian, energy, taylor, canonical],
        body slide1 on ground { joint: prismatic(x), coordinate: x1 }
        body star1 on slide1 { mass: 1, joint: prismatic(y), coordinate: y1 }
        body slide2 on ground { joint: prismatic(x), coordinate: x2 }
        body star2 on slide2 { mass: 2, joint: prismatic(y), coordinate: y2 }
        body slide3 on ground { joint: prismatic(x), coordinate: x3 }
        body star3 on slide3 { mass: 3, joint: prismatic(y), coordinate: y3 }
        body slide4 on ground { joint: prismatic(x), coordinate: x4 }
        body star4 on slide4 { mass: 4, joint: prismatic(y), coordinate: y4 }
        body slide5 on ground { joint: prismatic(x), coordinate: x5 }
        body star5 on slide5 { mass: 5, joint: prismatic(y), coordinate: y5 }
        body slide6 on ground { joint: prismatic(x), coordinate: x6 }
        body star6 on slide6 { mass: 6, joint: prismatic(y), coordinate: y6 }
        body slide7 on ground { joint: prismatic(x), coordinate: x7 }
        body star7 on slide7 { mass: 7, joint: prismatic(y), coordinate: y7 }
        potential: -(2/sqrt((x1 - x2)^2 + (y1 - y2)^2) + 3/sqrt((x1 - x3)^2 + (y1 - y3)^2)
            + 4/sqrt((x1 - x4)^2 + (y1 - y4)^2) + 5/sqrt((x1 - x5)^2 + (y1 - y5)^2)
            + 6/sqrt((x1 - x6)^2 + (y1 - y6)^2) + 7/sqrt((x1 - x7)^2 + (y1 - y7)^2)
            + 6/sqrt((x2 - x3)^2 + (y2 - y3)^2) + 8/sqrt((x2 - x4)^2 + (y2 - y4)^2)
            + 10/sqrt((x2 - x5)^2 + (y2 - y5)^2) + 12/sqrt((x2 - x6)^2 + (y2 - y6)^2)
            + 14/sqrt((x2 - x7)^2 + (y2 - y7)^2) + 12/sqrt((x3 - x4)^2 + (y3 - y4)^2)
            + 15/sqrt((x3 - x5)^2 + (y3 - y5)^2) + 18/sqrt((x3 - x6)^2 + (y3 - y6)^2)
            + 21/sqrt((x3 - x7)^2 + (y3 - y7)^2) + 20/sqrt((x4 - x5)^2 + (y4 - y5)^2)
            + 24/sqrt((x4 - x6)^2 + (y4 - y6)^2) + 28/sqrt((x4 - x7)^2 + (y4 - y7)^2)
            + 30/sqrt((x5 - x6)^2 + (y5 - y6)^2) + 35/sqrt((x5 - x7)^2 + (y5 - y7)^2)
            + 42/sqrt((x6 - x7)^2 + (y6 - y7)^2)),
    }
}

mechanism! {
    /// Relaxation oscillations (B. van der Pol, Phil. Mag. 2 (1926) 978).
    pub VanDerPol {
        units: none,
        params { epsilon = 1e-6 }
        generate: [rhs, jacobian, taylor],
        state x { rate: v }
        state v { rate: ((1 - x^2)*v - x)/epsilon }
    }
}

mechanism! {
    /// Growth of a plant under light: eight reactions (E. Schaefer, J. Math. Biology 2 (1975) 41).
    pub Hires {
        units: none,
        generate: [rhs, jacobian, taylor],
        let bound = 280*f*h,
        state a { rate: -1.71*a + 0.43*b + 8.32*c + 0.0007 }
        state b { rate: 1.71*a - 8.75*b }
        state c { rate: -10.03*c + 0.43*d + 0.035*e }
        state d { rate: 8.32*b + 1.71*c - 1.12*d }
        state e { rate: -1.745*e + 0.43*f + 0.43*g }
        state f { rate: -bound + 0.69*d + 1.71*e - 0.43*f + 0.69*g }
        state g { rate: bound - 1.81*g }
        state h { rate: -bound + 1.81*g }
    }
}

mechanism! {
    /// Three reactions of very different speed (H. H. Robertson, 1966).
    pub Robertson {
        units: none,
        generate: [rhs, jacobian, taylor],
        let slow = 0.04*a,
        let fast = 1e4*b*c,
        let fastest = 3e7*b^2,
        state a { rate: fast - slow }
        state b { rate: slow - fast - fastest }
        state c { rate: fastest }
    }
}

mechanism! {
    /// A top of 15 kg, whose tip is fixed.
    pub HeavyTop {
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian, energy, taylor],
        body top on ground {
            mass: 15, com: [0, 0, 1], inertia: [0.234375, 0.234375, 0.46875], joint: ball, orientation: o,
        }
    }
}

mechanism! {
    /// A UR5 whose motors are off: it falls with friction in its joints.
    pub FallingUr5 {
        params { friction: N m s = 2 }
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian, energy, taylor],
        robot: urdf("data/urdf/ur5.urdf"),
        force shoulder_pan_joint: -friction*dot(shoulder_pan_joint),
        force shoulder_lift_joint: -friction*dot(shoulder_lift_joint),
        force elbow_joint: -friction*dot(elbow_joint),
        force wrist_1_joint: -friction/4*dot(wrist_1_joint),
        force wrist_2_joint: -friction/4*dot(wrist_2_joint),
        force wrist_3_joint: -friction/4*dot(wrist_3_joint),
    }
}

/// Receiver of problems, each of another type.
pub trait Visitor {
    /// Receives a problem, and whether explicit methods cannot solve it.
    fn visit<S, const N: usize>(&mut self, scene: Scene<S, N>, is_stiff: bool)
    where
        S: Cast<N, In<f64> = S> + CastJacobian<N> + CastTaylor<N> + Jacobian<f64, N> + TaylorSeries<f64, N> + 'static,
        S::In<Counted>: Jacobian<Counted, N> + TaylorSeries<Counted, N>;

    /// Receives a problem that keeps its energy and is not stiff: symplectic methods suit it.
    fn visit_conservative<S, const N: usize>(&mut self, scene: Scene<S, N>)
    where
        S: Cast<N, In<f64> = S>
            + CastJacobian<N>
            + CastTaylor<N>
            + Jacobian<f64, N>
            + TaylorSeries<f64, N>
            + Canonical<f64, N>
            + 'static,
        S::In<Counted>: Jacobian<Counted, N> + TaylorSeries<Counted, N> + Canonical<Counted, N>,
    {
        self.visit(scene, false);
    }
}

/// Passes the twelve problems to a visitor, with reference solutions.
///
/// # Errors
/// If a problem cannot be solved.
pub fn each(visitor: &mut impl Visitor) -> Result<(), Box<dyn Error>> {
    let known = |name: &str, t| (t, SVector::from(trajectories::scene(name).state(t)));
    let four = 4_f64.to_radians();
    let regular = problem(
        "regular",
        "double pendulum, small swing",
        double_pendulum(0.1),
        [0.0, four, 0.0, 0.0],
        20.0,
    );
    visitor.visit(regular.explicit()?.ends_at(known("paper_gamma_0.1", 20.0)), false);
    let chaotic = problem(
        "chaotic",
        "double pendulum, large swing",
        double_pendulum(0.0),
        [2.0, 2.5, 0.0, 0.0],
        10.0,
    );
    visitor.visit_conservative(chaotic.explicit()?.ends_at(known("large_swing", 10.0)));
    let stiff = problem(
        "stiff",
        "double pendulum, stiff axles",
        double_pendulum(1e4),
        [1.0, -1.0, 0.0, 0.0],
        5.0,
    );
    visitor.visit(stiff.implicit()?.ends_at(known("stiff_axles", 5.0)), true);

    let arenstorf = Arenstorf::new(ArenstorfParams::default())?;
    let start = [0.994, 0.0, 0.0, -2.001_585_106_379_082_4];
    let arenstorf = problem("arenstorf", "Arenstorf orbit", arenstorf, start, 17.065_216_560_157_964);
    visitor.visit(arenstorf.explicit()?, false);
    let pleiades = Pleiades::new(PleiadesParams {})?;
    visitor.visit_conservative(problem("pleiades", "Pleiades", pleiades, PLEIADES, 3.0).explicit()?);
    let henon_heiles = HenonHeiles::new(HenonHeilesParams {})?;
    let start = [0.3, 0.0, 0.0, 0.4];
    let henon_heiles = problem("henon_heiles", "Hénon and Heiles", henon_heiles, start, 100.0);
    visitor.visit_conservative(henon_heiles.explicit()?);

    let van_der_pol = VanDerPol::new(VanDerPolParams::default())?;
    visitor.visit(
        problem("van_der_pol", "van der Pol, 10⁶", van_der_pol, [2.0, 0.0], 2.0).implicit()?,
        true,
    );
    let hires = Hires::new(HiresParams {})?;
    let start = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0057];
    visitor.visit(problem("hires", "HIRES", hires, start, 321.8122).implicit()?, true);
    let robertson = Robertson::new(RobertsonParams {})?;
    visitor.visit(
        problem("robertson", "Robertson", robertson, [1.0, 0.0, 0.0], 1e11).implicit()?,
        true,
    );

    let andrews = Andrews::new(AndrewsParams::default())?;
    let (start, end) = andrews_ends();
    visitor.visit(
        problem("andrews", "Andrews' squeezer", andrews, start, 0.03)
            .explicit()?
            .ends_at(end),
        false,
    );
    let top = motion("heavy_top_kynema");
    let end = top.states.last().copied().ok_or("no end")?;
    let heavy_top = HeavyTop::new(HeavyTopParams {})?;
    let heavy_top = problem("heavy_top", "heavy top", heavy_top, top.x0.into(), end.0);
    visitor.visit(heavy_top.explicit()?.ends_at(end), false);
    let ur5 = FallingUr5::new(FallingUr5Params::default())?;
    let start = [0.0, -0.5, 0.8, 0.3, 0.2, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    visitor.visit(problem("ur5", "UR5 falling", ur5, start, 2.0).explicit()?, false);
    Ok(())
}

/// Start of [`Pleiades`]: positions and velocities, along both axes by turns.
pub const PLEIADES: [f64; 28] = {
    let x = [3.0, 3.0, -1.0, -3.0, 2.0, -2.0, 2.0];
    let y = [3.0, -3.0, 2.0, 0.0, 0.0, -4.0, 4.0];
    let (u, v) = (
        [0.0, 0.0, 0.0, 0.0, 0.0, 1.75, -1.5],
        [0.0, 0.0, 0.0, -1.25, 1.0, 0.0, 0.0],
    );
    let (mut start, mut n) = ([0.0; 28], 0);
    while n < 7 {
        (start[2 * n], start[2 * n + 1]) = (x[n], y[n]);
        (start[14 + 2 * n], start[15 + 2 * n]) = (u[n], v[n]);
        n += 1;
    }
    start
};

/// Start of Andrews' mechanism, and its published end.
fn andrews_ends() -> ([f64; 2], (f64, SVector<f64, 2>)) {
    let data: Value = serde_json::from_str(include_str!("../data/andrews.json")).expect("valid JSON");
    let motion = &data["motions"][0];
    let number = |value: &Value| value.as_str().and_then(|text| text.parse().ok()).expect("a number");
    let end = &motion["states"]
        .as_array()
        .and_then(|states| states.last())
        .expect("a state");
    let start = [0, 7].map(|n| number(&motion["x0"][n]));
    (start, (0.03, SVector::from([0, 7].map(|n| number(&end[n])))))
}

fn problem<S, const N: usize>(
    name: &'static str,
    title: &'static str,
    model: S,
    x0: [f64; N],
    t1: f64,
) -> Unsolved<S, N> {
    Unsolved {
        name,
        title,
        model,
        x0: x0.into(),
        t1,
    }
}

/// A scene without its reference solution.
struct Unsolved<S, const N: usize> {
    name: &'static str,
    title: &'static str,
    model: S,
    x0: SVector<f64, N>,
    t1: f64,
}

/// Tolerance of reference solutions.
const TIGHT: f64 = 1e-14;

impl<S: Jacobian<f64, N> + TaylorSeries<f64, N>, const N: usize> Unsolved<S, N> {
    fn explicit(self) -> Result<Scene<S, N>, SolveError<f64, N>> {
        self.solved(
            &Taylor::new().rtol(TIGHT).atol(TIGHT),
            &Vern9::new().rtol(TIGHT).atol(TIGHT),
        )
    }

    fn implicit(self) -> Result<Scene<S, N>, SolveError<f64, N>> {
        self.solved(
            &Radau13::new().rtol(TIGHT).atol(TIGHT),
            &Radau9::new().rtol(TIGHT).atol(TIGHT),
        )
    }

    fn solved(
        self,
        method: &impl Method<S, f64, N>,
        other: &impl Method<S, f64, N>,
    ) -> Result<Scene<S, N>, SolveError<f64, N>> {
        let Self {
            name,
            title,
            model,
            x0,
            t1,
        } = self;
        let best = method.solve(&model, 0.0, t1, x0)?;
        let other = other.solve(&model, 0.0, t1, x0)?;
        // the end is known better than steep parts of the curve
        let (end, difference) = (best.end(), (best.end() - other.end()).amax());
        let reference = Reference::solutions(best, &other).expect("both go to the end");
        let reference = reference.with_points([(t1, end)], difference);
        Ok(Scene {
            name,
            title,
            model,
            x0,
            t1,
            reference,
        })
    }
}

impl<S, const N: usize> Scene<S, N> {
    /// Adds the exact end.
    fn ends_at(mut self, (t, end): (f64, SVector<f64, N>)) -> Self {
        self.reference = self.reference.with_points([(t, end)], f64::EPSILON * end.amax());
        self
    }
}

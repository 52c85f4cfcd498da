//! Regions of stability, with the modes of the scene.

use std::ops::Range;

use pendulum_core::method::{Explicit, Fixed, Gauss, PowerSeries, RadauIIA, Rosenbrock};
use pendulum_core::stability::{Complex, Spectrum, StabilityError, StabilityFunction};
use pendulum_core::system::Jacobian;
use pendulum_core::tableau::{self, DormandPrince5, Kutta4, Tsitouras5, Verner7, Verner9};

use charts::chart::{Axis, Column, Curve, Figure, Line, Marker, Row};
use charts::contour;
use charts::methods::line;
use charts::page::INK;
use testbed::scenes::double_pendulum;

/// Step size, in s.
const H: f64 = 0.1;

/// Number of points of the grid on which contours are sought, along each side.
const POINTS: usize = 600;

/// Part of the plane of `h lambda`; the lower half-plane mirrors the upper one.
const PLANE: [Range<f64>; 2] = [-10.0..20.0, -1.3..14.7];
/// Friction of both axles at which the fastest mode is shown, in N m s.
const FRICTIONS: [f64; 5] = [0.0, 10.0, 20.0, 30.0, 50.0];

/// Factor of a mode in one step of a method.
type Factor = fn(Complex<f64>) -> Complex<f64>;

fn factor<F: Default>(z: Complex<f64>) -> Complex<f64>
where
    Fixed<F>: StabilityFunction,
{
    Fixed::<F>::new(H).stability_function(z)
}

pub(crate) fn figure() -> Result<Figure, StabilityError> {
    // Points near which the borders have their names.
    let methods: [(&str, Factor, (f64, f64)); 10] = [
        ("Rk4", factor::<Explicit<Kutta4, 5>>, (-1.5, 2.2)),
        ("Rk45", factor::<Explicit<DormandPrince5, 7>>, (-2.0, 2.8)),
        ("Tsit5", factor::<Explicit<Tsitouras5, 7>>, (-1.2, 3.2)),
        ("Vern7", factor::<Explicit<Verner7, 11>>, (-0.4, 4.8)),
        ("Vern9", factor::<Explicit<Verner9, 17>>, (-3.2, 3.4)),
        ("Taylor", factor::<PowerSeries>, (-4.5, 7.6)),
        ("Rodas4", factor::<Rosenbrock<tableau::HairerWanner4, 6>>, (12.0, 13.8)),
        ("Rodas5P", factor::<Rosenbrock<tableau::Steinebach5, 8>>, (2.0, 13.0)),
        ("Radau5", factor::<RadauIIA>, (9.0, 6.2)),
        ("Gauss4, Gauss6", factor::<Gauss<2>>, (0.0, 11.5)),
    ];
    let mut curves = Vec::new();
    for (name, factor, near) in methods {
        let line = Line {
            marker: None,
            ..line(name.split(',').next().unwrap_or(name))
        };
        let border = border(factor);
        let distance = |point: &&(f64, f64)| (point.0 - near.0).hypot(point.1 - near.1);
        let nearest = border.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        curves.extend(nearest.map(|&point| Curve::note(line.color, point, name)));
        curves.push(Curve {
            name: Some(name.to_owned()),
            ..Curve::new(line, border)
        });
    }
    curves.extend(modes()?);
    let axis = |label: &str, range: &Range<f64>| Axis {
        ticks: 8,
        ..Axis::linear(label, range.clone())
    };
    Ok(Figure {
        title: "Regions of stability, and the modes of the double pendulum".to_owned(),
        subtitle: format!(
            "Dots: fastest mode λ of the hanging pendulum, Eq. 22, with friction γ in N m s, for steps of h = {H} s"
        ),
        size: (1600, 1000),
        legend: vec![
            (Line::solid(INK), "explicit methods are stable inside".to_owned()),
            (
                Line::dashed(INK),
                "implicit methods are stable on the left, and outside".to_owned(),
            ),
        ],
        columns: vec![Column::new(
            "",
            axis("real part of h λ", &PLANE[0]),
            axis("imaginary part of h λ", &PLANE[1]),
        )],
        rows: vec![Row::new(vec![curves])],
    }
    .with_equal_scales())
}

/// The longest contour `|R| = 1`, without the islands right of the axis, which no decaying mode reaches.
fn border(factor: Factor) -> contour::Path {
    let [x, y] = &PLANE;
    let at = |range: &Range<f64>, n: usize| range.start + (range.end - range.start) * n as f64 / (POINTS - 1) as f64;
    let excess = |n: usize| factor(Complex::new(at(x, n % POINTS), at(y, n / POINTS))).norm().ln();
    let values: Vec<f64> = (0..POINTS * POINTS).map(excess).collect();
    let contours = contour::zeros(&values, POINTS, x, y);
    contours.into_iter().max_by_key(Vec::len).unwrap_or_default()
}

/// Fastest mode at each friction.
fn modes() -> Result<Vec<Curve>, StabilityError> {
    let fastest = |gamma: f64| {
        let hanging = [0.0; 4].into();
        let spectrum = Spectrum::of(&double_pendulum(gamma).jacobian(0.0, &hanging))?;
        let above = spectrum.eigenvalues().filter(|eigenvalue| eigenvalue.im >= 0.0);
        let fastest = above.max_by(|a, b| a.norm().total_cmp(&b.norm())).unwrap_or_default() * H;
        Ok(Curve {
            label: Some(format!("γ = {gamma}")),
            ..Curve::new(Line::solid(INK).marked(Marker::Circle), vec![(fastest.re, fastest.im)])
        })
    };
    FRICTIONS.into_iter().map(fastest).collect()
}

//! Regions of stability, with the modes of the scene.

use std::ops::Range;

use pendulum_core::method::{Explicit, Fixed, Gauss, PowerSeries, RadauIIA, Rosenbrock};
use pendulum_core::stability::{Complex, Spectrum, StabilityError, StabilityFunction};
use pendulum_core::system::Jacobian;
use pendulum_core::tableau::{self, DormandPrince5, Kutta4, Tsitouras5, Verner7, Verner9};

use crate::contour;
use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::methods::line;
use charts::page::INK;
use testbed::where_methods_fail::scenes::double_pendulum;

/// Step size, in s.
const H: f64 = 0.1;

/// Number of grid cells per side, enough for smooth lines.
const CELLS: usize = 300;

/// Parts of the plane of `h lambda`; the lower half-plane mirrors the upper one.
const EXPLICIT: [Range<f64>; 2] = [-9.5..2.5, -1.0..10.0];
const IMPLICIT: [Range<f64>; 2] = [-6.0..18.0, -2.0..20.0];

/// Factor of a mode in one step of a method.
type Factor = fn(Complex<f64>) -> Complex<f64>;

fn factor<F: Default>(z: Complex<f64>) -> Complex<f64>
where
    Fixed<F>: StabilityFunction,
{
    Fixed::<F>::new(H).stability_function(z)
}

pub(crate) fn figure() -> Result<Figure, StabilityError> {
    let explicit: [(&str, Factor); 6] = [
        ("Rk4", factor::<Explicit<Kutta4, 5>>),
        ("Rk45", factor::<Explicit<DormandPrince5, 7>>),
        ("Tsit5", factor::<Explicit<Tsitouras5, 7>>),
        ("Vern7", factor::<Explicit<Verner7, 11>>),
        ("Vern9", factor::<Explicit<Verner9, 17>>),
        ("Taylor", factor::<PowerSeries>),
    ];
    // The border of both Gauss methods is the imaginary axis.
    let implicit: [(&str, Factor); 4] = [
        ("Rodas4", factor::<Rosenbrock<tableau::HairerWanner4, 6>>),
        ("Rodas5P", factor::<Rosenbrock<tableau::Steinebach5, 8>>),
        ("Radau5", factor::<RadauIIA>),
        ("Gauss4", factor::<Gauss<2>>),
    ];
    let mut panels = [borders(&explicit, &EXPLICIT), borders(&implicit, &IMPLICIT)];
    panels[0].extend(modes(&[0.0, 10.0, 20.0, 30.0, 50.0])?);
    panels[1].extend(modes(&[10.0, 30.0])?);
    let legend = |methods: &[(&str, Factor)]| {
        let title = |name| {
            if name == "Gauss4" {
                "Gauss4, Gauss6 (imaginary axis)"
            } else {
                name
            }
        };
        methods
            .iter()
            .map(|&(name, _)| (line(name), title(name).to_owned()))
            .collect()
    };
    let column = |title: &str, [x, y]: &[Range<f64>; 2]| {
        Column::new(title, axis("real part of h λ", x), axis("imaginary part of h λ", y))
    };
    Ok(Figure {
        title: "Regions of stability, and the modes of the double pendulum".to_owned(),
        subtitle: format!(
            "Dots: fastest mode λ of the hanging pendulum, Eq. 22, with friction γ in N m s, for steps of h = {H} s"
        ),
        size: (1700, 1000),
        legend: legend(&explicit),
        columns: vec![
            column("Explicit methods, stable inside", &EXPLICIT),
            column("Implicit methods, stable to the left", &IMPLICIT),
        ],
        rows: vec![Row {
            caption: String::new(),
            legend: legend(&implicit),
            panels: panels.into(),
        }],
    }
    .with_equal_scales())
}

fn axis(label: &str, range: &Range<f64>) -> Axis {
    Axis {
        ticks: 7,
        ..Axis::linear(label, range.clone())
    }
}

/// Contours `|R| = 1`, without the islands right of the axis, which no decaying mode reaches.
fn borders(methods: &[(&str, Factor)], [x, y]: &[Range<f64>; 2]) -> Vec<Curve> {
    let border = |(name, factor): &(&str, Factor)| {
        let excess = |re: f64, im: f64| factor(Complex::new(re, im)).norm().ln();
        let lines = contour::zeros(excess, x, y, CELLS);
        Some(Curve::new(line(name), lines.into_iter().max_by_key(Vec::len)?))
    };
    methods.iter().filter_map(border).collect()
}

/// Fastest mode at each friction, in N m s.
fn modes(frictions: &[f64]) -> Result<Vec<Curve>, StabilityError> {
    let fastest = |&gamma: &f64| {
        let hanging = [0.0; 4].into();
        let spectrum = Spectrum::of(&double_pendulum(gamma).jacobian(0.0, &hanging))?;
        let above = spectrum.eigenvalues().filter(|eigenvalue| eigenvalue.im >= 0.0);
        let fastest = above.max_by(|a, b| a.norm().total_cmp(&b.norm())).unwrap_or_default() * H;
        Ok(Curve {
            line: Line::solid(INK),
            points: vec![(fastest.re, fastest.im)],
            label: Some(format!("γ = {gamma}")),
        })
    };
    frictions.iter().map(fastest).collect()
}

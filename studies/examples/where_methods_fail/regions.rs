//! Regions of stability, and where the scene lies in them.

use std::ops::Range;

use pendulum_core::method::{Explicit, Fixed, Gauss, PowerSeries, RadauIIA, Rosenbrock};
use pendulum_core::stability::{Complex, Spectrum, StabilityError, StabilityFunction};
use pendulum_core::system::Jacobian;
use pendulum_core::tableau::{self, DormandPrince5, Kutta4, Tsitouras5, Verner7, Verner9};

use crate::contour;
use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Scale};
use charts::methods::line;
use charts::page::INK;
use testbed::where_methods_fail::scenes::double_pendulum;

/// The length of the steps, in s.
const H: f64 = 0.1;

/// Enough for lines that look smooth.
const CELLS: usize = 300;

/// Parts of the plane of `h lambda`, the lower half of which mirrors the upper one.
const EXPLICIT: [Range<f64>; 2] = [-9.5..2.5, -1.0..10.0];
const IMPLICIT: [Range<f64>; 2] = [-6.0..18.0, -2.0..20.0];

/// What a method does to a mode in one step.
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
    let implicit: [(&str, Factor); 5] = [
        ("Rodas4", factor::<Rosenbrock<tableau::HairerWanner4, 6>>),
        ("Rodas5P", factor::<Rosenbrock<tableau::Steinebach5, 8>>),
        ("Radau5", factor::<RadauIIA>),
        ("Gauss4", factor::<Gauss<2>>),
        ("Gauss6", factor::<Gauss<3>>),
    ];
    let mut panels = [borders(&explicit, &EXPLICIT), borders(&implicit, &IMPLICIT)];
    panels[0].extend(modes(&[0.0, 10.0, 20.0, 30.0, 50.0])?);
    panels[1].extend(modes(&[10.0, 30.0])?);
    let legend = |methods: &[(&str, Factor)]| {
        methods
            .iter()
            .map(|(name, _)| (line(name), (*name).to_owned()))
            .collect()
    };
    let column = |[x, y]: &[Range<f64>; 2]| Column {
        x: axis("real part of h λ", x),
        y: axis("imaginary part of h λ", y),
    };
    Ok(Figure {
        title: "Regions of stability, and the modes of the double pendulum".to_owned(),
        subtitle: format!(
            "Stable: within the lines of explicit methods, and left of those of implicit ones. Dots: fastest mode of Eq. 22, hanging, γ in N m s, h = {H} s"
        ),
        size: (1700, 940),
        legend: legend(&explicit),
        columns: vec![column(&EXPLICIT), column(&IMPLICIT)],
        rows: vec![Row {
            caption: String::new(),
            legend: legend(&implicit),
            panels: panels.into(),
        }],
    })
}

fn axis(label: &str, range: &Range<f64>) -> Axis {
    Axis {
        label: label.to_owned(),
        scale: Scale::Linear,
        range: range.clone(),
        ticks: 7,
    }
}

/// Where `|R| = 1`.
fn borders(methods: &[(&str, Factor)], [x, y]: &[Range<f64>; 2]) -> Vec<Curve> {
    let border = |(name, factor): &(&str, Factor)| {
        let excess = |re: f64, im: f64| factor(Complex::new(re, im)).norm().ln();
        contour::zeros(excess, x, y, CELLS)
            .into_iter()
            .map(|points| Curve {
                line: line(name),
                points,
                label: None,
            })
            .collect::<Vec<_>>()
    };
    methods.iter().flat_map(border).collect()
}

/// The fastest mode at each friction, in N m s.
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

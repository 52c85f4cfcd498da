//! Scales of axes.

/// Axis between two values.
#[derive(Clone, Copy)]
pub(crate) enum Scale {
    /// Logarithmic between two values.
    Logarithmic(f64, f64),
    /// Linear from zero to this value.
    Linear(f64),
}

impl Scale {
    /// Logarithmic scale between the nearest powers of ten that include all values.
    pub(crate) fn around(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let (low, high) = (low.log10().floor(), high.log10().ceil());
        if low.is_finite() && high.is_finite() {
            Self::Logarithmic(10.0_f64.powf(low), 10.0_f64.powf(high.max(low + 1.0)))
        } else {
            Self::Logarithmic(1.0, 10.0)
        }
    }

    /// Position of a value: 0 at the low end, 1 at the high one.
    pub(crate) fn part(self, value: f64) -> f64 {
        match self {
            Self::Logarithmic(low, high) => (value / low).ln() / (high / low).ln(),
            Self::Linear(most) => value / most,
        }
    }

    /// Ends of the axis.
    pub(crate) fn ends(self) -> (f64, f64) {
        match self {
            Self::Logarithmic(low, high) => (low, high),
            Self::Linear(most) => (0.0, most),
        }
    }

    /// Marked values, and whether each has a label.
    pub(crate) fn ticks(self) -> Vec<(f64, bool)> {
        match self {
            Self::Logarithmic(low, high) => {
                let (first, last) = (low.log10().round() as i32, high.log10().round() as i32);
                (first..=last)
                    .flat_map(|power| {
                        let multiples = if power == last { 1..2 } else { 1..10 };
                        multiples.map(move |n| (f64::from(n) * 10.0_f64.powi(power), n == 1))
                    })
                    .collect()
            }
            Self::Linear(most) => {
                // Two to five round steps.
                let power = 10.0_f64.powf((most / 2.0).log10().floor());
                let step = [5.0, 2.0, 1.0].map(|n| n * power);
                let step = step.into_iter().find(|step| 2.0 * step <= most).unwrap_or(power);
                (0..=(most / step) as i32)
                    .map(|n| (step * f64::from(n), true))
                    .collect()
            }
        }
    }
}

/// Label of a number: in digits if they are easy to read, otherwise as a power of ten, which the number must be.
pub(crate) fn label(value: f64) -> String {
    let power = value.log10().round() as i32;
    if value == 0.0 || (-1..5).contains(&power) {
        return value.to_string();
    }
    power_of_ten(power)
}

/// 10 with an exponent.
pub(crate) fn power_of_ten(exponent: i32) -> String {
    let superscript = |c: char| match c.to_digit(10) {
        Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
        None => '⁻',
    };
    format!(
        "10{}",
        exponent.to_string().chars().map(superscript).collect::<String>()
    )
}

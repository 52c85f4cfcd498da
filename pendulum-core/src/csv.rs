//! Export of solutions as tables.

use std::{fmt, io};

use nalgebra::SVector;

use crate::layout::{StateLayout, WrongLength};
use crate::real::Float;
use crate::solution::Solution;

/// Not for dual numbers, which are more than one column.
impl<T: Float + fmt::Display, const N: usize> Solution<T, N> {
    /// Writes the accepted points as CSV: a header with `t` and the names of the [components](StateLayout::components),
    /// then a line for each point. Numbers are written with all digits, such that they read back as the same bits.
    ///
    /// Wrap a file in a [`BufWriter`](io::BufWriter).
    ///
    /// ```
    /// use pendulum_core::prelude::*;
    ///
    /// mechanism! {
    ///     pub Swing {
    ///         gravity: [0, -9.81, 0],
    ///         body bob on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: angle }
    ///     }
    /// }
    ///
    /// let swing = Swing::new(SwingParams {})?;
    /// let solution = Rk4::new(0.5).solve(&swing, 0.0, 1.0, [0.0, 0.0])?;
    /// let mut table = Vec::new();
    /// solution.write_csv(&mut table, &Swing::LAYOUT)?;
    /// assert_eq!(String::from_utf8(table)?, "t,angle,dot(angle)\n0.0,0.0,0.0\n0.5,0.0,0.0\n1.0,0.0,0.0\n");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Errors of `writer`, and [`WrongLength`] as [`io::ErrorKind::InvalidInput`] if `layout` does not match the state.
    pub fn write_csv(&self, writer: impl io::Write, layout: &StateLayout<'_>) -> io::Result<()> {
        write(writer, layout, self.points().map(|(t, x)| Ok((t, *x))))
    }

    /// Like [`write_csv`](Self::write_csv), but writes the states at `times`, in any order, by the dense output of the
    /// method.
    ///
    /// # Errors
    /// Errors of [`write_csv`](Self::write_csv), and [`OutsideSpan`](crate::OutsideSpan) as
    /// [`io::ErrorKind::InvalidInput`].
    pub fn write_csv_at(
        &self,
        writer: impl io::Write,
        layout: &StateLayout<'_>,
        times: impl IntoIterator<Item = T>,
    ) -> io::Result<()> {
        let point = |t| self.at(t).map(|x| (t, x)).map_err(invalid);
        write(writer, layout, times.into_iter().map(point))
    }
}

fn write<T: Float, const N: usize>(
    mut writer: impl io::Write,
    layout: &StateLayout<'_>,
    points: impl Iterator<Item = io::Result<(T, SVector<T, N>)>>,
) -> io::Result<()> {
    let names = layout.components();
    if names.len() != N {
        return Err(invalid(WrongLength { given: N, names }));
    }
    writeln!(writer, "t,{}", names.join(","))?;
    for point in points {
        let (t, x) = point?;
        write!(writer, "{t:?}")?;
        for component in &x {
            write!(writer, ",{component:?}")?;
        }
        writeln!(writer)?;
    }
    Ok(())
}

fn invalid(error: impl std::error::Error + Send + Sync + 'static) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, error)
}

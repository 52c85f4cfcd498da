//! Mass properties of bodies. A solid is replaced by point masses with the same mass, centre and second moments: a
//! quadrature that is exact for all quadratic functions.

use nalgebra::Vector3;
use pendulum_core::Real;

use super::{Oracle, dot, unit};
use crate::trees::{Body, Form, Matter, Solid, Triple};

/// Mass, centre of mass, and the rows of the inertia about it, in the frame of the body.
#[derive(Clone, Copy, Debug)]
pub(super) struct MassProperties<T> {
    pub(super) mass: T,
    pub(super) com: Vector3<T>,
    pub(super) inertia: [Vector3<T>; 3],
}

/// Point mass.
#[derive(Clone, Copy, Debug)]
struct Grain<T> {
    mass: T,
    at: Vector3<T>,
}

impl<T: Real> Oracle<'_, T> {
    pub(super) fn mass_properties(&self, body: &Body) -> MassProperties<T> {
        let none = Vector3::from([T::default(); 3]);
        match &body.matter {
            None => MassProperties {
                mass: T::default(),
                com: none,
                inertia: [none; 3],
            },
            Some(Matter::Lump { mass, com, inertia }) => MassProperties {
                mass: self.number(*mass),
                com: com.as_ref().map_or(none, |com| self.vector(com)),
                inertia: inertia.map_or([none; 3], |entries| {
                    let [xx, yy, zz, xy, xz, yz] = entries.map(|entry| self.number(entry));
                    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].map(Vector3::from)
                }),
            },
            Some(Matter::Solids(solids)) => {
                let grains: Vec<Grain<T>> = solids.iter().flat_map(|solid| self.grains(solid)).collect();
                properties(&grains)
            }
        }
    }

    fn grains(&self, solid: &Solid) -> Vec<Grain<T>> {
        let number = T::from_f64;
        let mass = self.number(solid.mass);
        // point masses as fractions of the mass
        let parts = |parts: Vec<(T, Vector3<T>)>| -> Vec<Grain<T>> {
            let grain = |(part, at)| Grain { mass: mass * part, at };
            parts.into_iter().map(grain).collect()
        };
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| Vector3::from(axis.map(number)));
        // two point masses on each of some axes through a point
        let crosses = |at: Vector3<T>, arms: &[Vector3<T>]| {
            let part = number(0.5 / arms.len() as f64);
            let both = arms.iter().flat_map(|&arm| [(part, at + arm), (part, at - arm)]);
            both.collect::<Vec<_>>()
        };
        match &solid.form {
            Form::Point(at) => parts(vec![(number(1.0), self.vector(at))]),
            Form::Rod(ends) => {
                // Simpson's rule
                let [from, middle, to] = self.line(ends);
                let part = |part: f64| number(part / 6.0);
                parts(vec![(part(1.0), from), (part(4.0), middle), (part(1.0), to)])
            }
            Form::Disk(radius, at) => {
                // the mean of x^2 is r^2/4
                let arm = self.number(*radius) * number(0.5_f64.sqrt());
                parts(crosses(self.vector(at), &[axes[0] * arm, axes[1] * arm]))
            }
            Form::Plate(corners) => {
                let corner = |[x, y]: &[_; 2]| Vector3::from([self.number(*x), self.number(*y), T::default()]);
                parts(polygon(&corners.iter().map(corner).collect::<Vec<_>>()))
            }
            Form::Cuboid(sides, at) => {
                // face centres: the mean of x^2 is d^2/12
                let sides = sides.map(|side| self.number(side) * number(0.5));
                let arms = [0, 1, 2].map(|n| axes[n] * sides[n]);
                parts(crosses(self.vector(at), &arms))
            }
            Form::Cylinder(radius, ends) => {
                // a rod as two point masses by Gauss quadrature, each of them expanded to a disk
                let [from, middle, to] = self.line(ends);
                let axis = to - from;
                let arm = self.number(*radius) * number(0.5_f64.sqrt());
                let aside = [0, 1, 2].map(|n| axis.cross(&axes[n]));
                let aside = aside.into_iter().find(|aside| dot(*aside, *aside) != T::default());
                let first = unit(aside.expect("a cylinder has a length"));
                let second = unit(axis.cross(&first));
                let apart = axis * number((1.0_f64 / 12.0).sqrt());
                let disks = [middle - apart, middle + apart];
                let disks = disks
                    .into_iter()
                    .flat_map(|at| crosses(at, &[first * arm, second * arm]));
                parts(disks.map(|(part, at)| (part * number(0.5), at)).collect())
            }
            Form::Sphere(radius, at) => {
                // the mean of x^2 is r^2/5
                let arm = self.number(*radius) * number(0.6_f64.sqrt());
                parts(crosses(self.vector(at), &axes.map(|axis| axis * arm)))
            }
        }
    }

    /// Ends and midpoint of a line.
    fn line(&self, [from, to]: &[Triple; 2]) -> [Vector3<T>; 3] {
        let (from, to) = (self.vector(from), self.vector(to));
        [from, (from + to) * T::from_f64(0.5), to]
    }
}

/// Quadrature of a polygon: it is divided into the triangles from its first corner, each with equal weights at the
/// midpoints of its sides; the weights of triangles outside the polygon are negative.
fn polygon<T: Real>(corners: &[Vector3<T>]) -> Vec<(T, Vector3<T>)> {
    let first = corners[0];
    let triangles: Vec<(T, [Vector3<T>; 2])> = corners[1..]
        .windows(2)
        .map(|pair| ((pair[0] - first).cross(&(pair[1] - first)).z, [pair[0], pair[1]]))
        .collect();
    let mut whole = T::default();
    for (area, _) in &triangles {
        whole += *area;
    }
    let mut parts = Vec::new();
    for (area, [a, b]) in triangles {
        let sides = [first + a, a + b, b + first];
        parts.extend(sides.map(|twice| (area / (whole * T::from_f64(3.0)), twice * T::from_f64(0.5))));
    }
    parts
}

fn properties<T: Real>(grains: &[Grain<T>]) -> MassProperties<T> {
    let none = Vector3::from([T::default(); 3]);
    let (mut mass, mut moment) = (T::default(), none);
    for grain in grains {
        mass += grain.mass;
        moment += grain.at * grain.mass;
    }
    let com = moment * (T::from_f64(1.0) / mass);
    let mut inertia = [none; 3];
    for grain in grains {
        let arm = grain.at - com;
        for (n, row) in inertia.iter_mut().enumerate() {
            row[n] += grain.mass * dot(arm, arm);
            *row -= arm * (arm[n] * grain.mass);
        }
    }
    MassProperties { mass, com, inertia }
}

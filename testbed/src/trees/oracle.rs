//! Newton-Euler equations, body by body (Featherstone, "Rigid Body Dynamics Algorithms" 2008, ch. 5), in the ground
//! frame; the mass matrix column by column from unit accelerations (Walker and Orin 1982).

mod matter;

use matter::MassProperties;
use nalgebra::Vector3;
use pendulum_core::Real;

use super::{Action, Joint, Law, Moves, Name, Number, Output, Torque, Tree, Triple};
use crate::dual::Dual;

/// Dynamics of a [`Tree`] in any number type: dual numbers yield derivatives, and series yield Taylor coefficients.
#[derive(Debug)]
pub struct Oracle<'a, T> {
    tree: &'a Tree,
    parameters: Vec<T>,
    inputs: Vec<T>,
    /// Mass properties of each body, in its own frame.
    matter: Vec<MassProperties<T>>,
}

/// A value and its first two time derivatives.
type Jet<T> = [T; 3];

/// Columns of a rotation matrix.
#[derive(Clone, Copy, Debug)]
struct Turn<T>([Vector3<T>; 3]);

/// Pose and motion of a frame.
#[derive(Clone, Copy, Debug)]
struct Frame<T> {
    turn: Turn<T>,
    at: Vector3<T>,
    /// Angular velocity.
    spin: Vector3<T>,
    /// Velocity of the origin.
    velocity: Vector3<T>,
    /// Angular acceleration.
    spin_rate: Vector3<T>,
    /// Acceleration of the origin.
    acceleration: Vector3<T>,
}

/// Joint in the ground frame: its screw about the origin of the joint frame, and the position of that origin.
#[derive(Clone, Copy, Debug)]
struct Hinge<T> {
    angular: Vector3<T>,
    linear: Vector3<T>,
    at: Vector3<T>,
}

/// Poses of all frames and joints at a time.
struct Pose<T> {
    frames: Vec<Frame<T>>,
    hinges: Vec<Hinge<T>>,
    /// Coordinate of each joint.
    joints: Vec<Jet<T>>,
}

/// Treatment of the driven joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Drives {
    /// They follow their laws.
    Move,
    /// They are frozen at their current positions.
    Stand,
    /// They are at rest, with accelerations equal to their actual rates.
    Start,
}

/// Coordinates of a tree, their rates and their accelerations.
pub type Motion<'a, T> = [&'a [T]; 3];

impl<'a, T: Real> Oracle<'a, T> {
    pub fn new(tree: &'a Tree, parameters: Vec<T>, inputs: Vec<T>) -> Self {
        let mut oracle = Self {
            tree,
            parameters,
            inputs,
            matter: Vec::new(),
        };
        let matter = tree.bodies.iter().map(|body| oracle.mass_properties(body));
        oracle.matter = matter.collect();
        oracle
    }

    /// Creates the oracle with the default parameters.
    pub fn with_defaults(tree: &'a Tree, inputs: &[f64]) -> Self {
        let numbers = |values: &[f64]| values.iter().map(|&value| T::from_f64(value)).collect();
        Self::new(tree, numbers(&tree.parameters), numbers(inputs))
    }

    fn number(&self, number: Number) -> T {
        match number.name {
            None => T::from_f64(number.value),
            Some(Name::Parameter(n)) => self.parameters[n],
            Some(Name::Input(n)) => self.inputs[n],
        }
    }

    fn vector(&self, triple: &Triple) -> Vector3<T> {
        Vector3::from(triple.map(|number| self.number(number)))
    }

    fn dof(&self) -> usize {
        self.tree.dof()
    }

    fn zeros(&self) -> Vec<T> {
        vec![T::default(); self.dof()]
    }

    /// Mass matrix, row by row.
    pub fn mass_matrix(&self, t: T, q: &[T]) -> Vec<Vec<T>> {
        let zeros = self.zeros();
        let columns = (0..self.dof()).map(|k| {
            let mut unit = self.zeros();
            unit[k] = T::from_f64(1.0);
            let pose = self.pose(t, [q, &zeros, &unit], Drives::Stand);
            self.along_coordinates(&self.inertial(&pose, Vector3::from([T::default(); 3])))
        });
        columns.collect()
    }

    /// Velocity terms, gravity and the inertia forces of the drives.
    pub fn bias(&self, t: T, q: &[T], qd: &[T]) -> Vec<T> {
        let pose = self.pose(t, [q, qd, &self.zeros()], Drives::Move);
        self.along_coordinates(&self.inertial(&pose, self.vector(&self.tree.gravity)))
    }

    /// Generalised forces of the declaration, without gravity.
    pub fn forces(&self, t: T, q: &[T], qd: &[T]) -> Vec<T> {
        let pose = self.pose(t, [q, qd, &self.zeros()], Drives::Move);
        let (wrenches, mut along) = (self.wrenches(&pose), self.given(q, qd));
        let mut of_joints = self.carried(&pose, &wrenches);
        for (n, force) in of_joints.iter_mut().enumerate() {
            *force += self.own_force(n, t, pose.joints[n]);
        }
        for (sum, force) in along.iter_mut().zip(self.along_coordinates(&of_joints)) {
            *sum += force;
        }
        along
    }

    /// Forces that the declaration applies to coordinates directly.
    fn given(&self, q: &[T], qd: &[T]) -> Vec<T> {
        let mut along = self.zeros();
        for action in &self.tree.actions {
            match *action {
                Action::Along { a, b, c } => along[a] -= self.number(c) * qd[b] * qd[b] * qd[b],
                Action::Potential { a, b, c } => {
                    let (sin, cos) = q[a].sin_cos();
                    along[a] += self.number(c) * sin * q[b];
                    along[b] -= self.number(c) * cos;
                }
                Action::Dissipation { a, b, c } => {
                    let force = self.number(c) * (qd[a] + qd[b]);
                    along[a] -= force;
                    along[b] -= force;
                }
                Action::Force { .. } | Action::Spring { .. } | Action::Damper { .. } => {}
            }
        }
        along
    }

    /// Generalised forces `A qdd + b - Q` for given accelerations.
    pub fn inverse_dynamics(&self, t: T, [q, qd, qdd]: Motion<'_, T>) -> Vec<T> {
        let pose = self.pose(t, [q, qd, qdd], Drives::Move);
        let needed = self.along_coordinates(&self.inertial(&pose, self.vector(&self.tree.gravity)));
        let forces = self.forces(t, q, qd);
        needed
            .into_iter()
            .zip(forces)
            .map(|(needed, force)| needed - force)
            .collect()
    }

    /// Accelerations of the coordinates.
    pub fn accelerations(&self, t: T, q: &[T], qd: &[T]) -> Vec<T> {
        let left = self.inverse_dynamics(t, [q, qd, &self.zeros()]);
        solve(self.mass_matrix(t, q), left.into_iter().map(|force| -force).collect())
    }

    /// Momenta: derivatives of the kinetic energy by the rates, computed as the forces for accelerations equal to the
    /// rates, from rest.
    pub fn momentum(&self, t: T, q: &[T], qd: &[T]) -> Vec<T> {
        let zeros = self.zeros();
        let pose = self.pose(t, [q, &zeros, qd], Drives::Start);
        self.along_coordinates(&self.inertial(&pose, Vector3::from([T::default(); 3])))
    }

    /// Time derivatives of the momenta along the motion.
    pub fn momentum_rates(&self, t: T, q: &[T], qd: &[T]) -> Vec<T> {
        let qdd = self.accelerations(t, q, qd);
        let moving = |x: &[T], rates: &[T]| -> Vec<Dual<T>> {
            x.iter().zip(rates).map(|(&x, &rate)| Dual::new(x, rate)).collect()
        };
        let constant = |&value: &T| Dual::new(value, T::default());
        let constants = |values: &[T]| values.iter().map(constant).collect();
        let oracle = Oracle::new(self.tree, constants(&self.parameters), constants(&self.inputs));
        let time = Dual::new(t, T::from_f64(1.0));
        let momentum = oracle.momentum(time, &moving(q, qd), &moving(qd, &qdd));
        momentum.into_iter().map(|momentum| momentum.slope).collect()
    }

    /// Kinetic and potential energy.
    pub fn energies(&self, t: T, q: &[T], qd: &[T]) -> [T; 2] {
        let pose = self.pose(t, [q, qd, &self.zeros()], Drives::Move);
        let (half, gravity) = (T::from_f64(0.5), self.vector(&self.tree.gravity));
        let [mut kinetic, mut potential] = [T::default(); 2];
        for (n, body) in self.tree.bodies.iter().enumerate() {
            let (frame, mass, arm) = (&pose.frames[n], self.matter[n].mass, self.arm(n, &pose));
            let velocity = frame.velocity + frame.spin.cross(&arm);
            kinetic += half * (mass * dot(velocity, velocity) + dot(frame.spin, self.inertia(n, &pose, frame.spin)));
            potential -= mass * dot(gravity, frame.at + arm);
            if let Some([stiffness, rest]) = body.spring {
                let stretch = pose.joints[n][0] - self.number(rest);
                potential += half * self.number(stiffness) * stretch * stretch;
            }
        }
        for action in &self.tree.actions {
            match *action {
                Action::Spring {
                    between,
                    stiffness,
                    length,
                } => {
                    let stretch = self.distance(between, &pose).0 - self.number(length);
                    potential += half * self.number(stiffness) * stretch * stretch;
                }
                Action::Potential { a, b, c } => potential += self.number(c) * q[a].sin_cos().1 * q[b],
                _ => {}
            }
        }
        [kinetic, potential]
    }

    /// Forces of the drives along a free motion.
    pub fn drive_forces(&self, t: T, q: &[T], qd: &[T]) -> Vec<T> {
        let qdd = self.accelerations(t, q, qd);
        let pose = self.pose(t, [q, qd, &qdd], Drives::Move);
        let needed = self.inertial(&pose, self.vector(&self.tree.gravity));
        let pushed = self.carried(&pose, &self.wrenches(&pose));
        let given = self.given(q, qd);
        let bodies = self.tree.bodies.iter().enumerate();
        let drives = bodies.filter(|(_, body)| body.is_driven());
        let supplied = drives.map(|(n, drive)| {
            let mut force = needed[n] - pushed[n];
            for (m, body) in self.tree.bodies.iter().enumerate() {
                // an absolute angle varies with every joint below it
                if let Moves::Absolutely(k) = body.moves
                    && self.tree.carries(n, m)
                {
                    force -= given[k] * T::from_f64(drive.turning() * body.turning());
                }
            }
            force
        });
        supplied.collect()
    }

    /// Components of each output; rotations column by column.
    pub fn outputs(&self, t: T, q: &[T], qd: &[T]) -> Vec<Vec<T>> {
        let pose = self.pose(t, [q, qd, &self.zeros()], Drives::Move);
        let value = |output: &Output| match *output {
            Output::Position(point) => self.point(point, &pose)[0].as_slice().to_vec(),
            Output::Rotation(body) => pose.frames[body].turn.0.iter().flatten().copied().collect(),
            Output::Velocity(point) => self.point(point, &pose)[1].as_slice().to_vec(),
            Output::Mixed {
                point,
                axes: [k, l, m],
                c,
            } => {
                let [at, velocity] = self.point(point, &pose);
                vec![self.number(c) * at[k] + at[l] * velocity[m]]
            }
        };
        self.tree.outputs.iter().map(value).collect()
    }

    /// Value of each event.
    pub fn events(&self, t: T, q: &[T], qd: &[T]) -> Vec<T> {
        let pose = self.pose(t, [q, qd, &self.zeros()], Drives::Move);
        let events = self.tree.events.iter();
        events
            .map(|event| self.point(event.point, &pose)[0][event.axis] - self.number(event.level))
            .collect()
    }

    /// Coordinates of all joints.
    fn joints(&self, t: T, motion: Motion<'_, T>, drives: Drives) -> Vec<Jet<T>> {
        let zero = T::default();
        let (mut joints, mut turns): (Vec<Jet<T>>, Vec<Jet<T>>) = (Vec::new(), Vec::new());
        for body in &self.tree.bodies {
            let below = body.parent.map_or([zero; 3], |parent| turns[parent]);
            let sense = T::from_f64(body.turning());
            let joint = match body.moves {
                Moves::Never => [zero; 3],
                Moves::Freely(k) => motion.map(|part| part[k]),
                Moves::Absolutely(k) => std::array::from_fn(|n| motion[n][k] - sense * below[n]),
                Moves::ByLaw(law) => {
                    let [place, rate, second] = law.jet(t);
                    match drives {
                        Drives::Move => [place, rate, second],
                        Drives::Stand => [place, zero, zero],
                        Drives::Start => [place, zero, rate],
                    }
                }
            };
            // a constant law is a fixed joint, which counts as no rotation
            let counts = !matches!(body.moves, Moves::ByLaw(Law::Still));
            turns.push(std::array::from_fn(|n| {
                if counts { below[n] + sense * joint[n] } else { below[n] }
            }));
            joints.push(joint);
        }
        joints
    }

    /// Generalised forces of the coordinates for given forces along the joints, by virtual work.
    fn along_coordinates(&self, forces: &[T]) -> Vec<T> {
        let (zero, zeros) = (T::default(), self.zeros());
        let of_coordinate = |k: usize| {
            let mut unit = self.zeros();
            unit[k] = T::from_f64(1.0);
            // the rates of the joints are linear in the rates of the coordinates
            let joints = self.joints(zero, [&zeros, &unit, &zeros], Drives::Stand);
            let mut sum = zero;
            for (joint, &force) in joints.iter().zip(forces) {
                sum += joint[1] * force;
            }
            sum
        };
        (0..self.dof()).map(of_coordinate).collect()
    }

    fn pose(&self, t: T, motion: Motion<'_, T>, drives: Drives) -> Pose<T> {
        let (zero, one) = (T::default(), T::from_f64(1.0));
        let origin = Vector3::from([zero; 3]);
        let ground = Frame {
            turn: Turn([[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(Vector3::from)),
            at: origin,
            spin: origin,
            velocity: origin,
            spin_rate: origin,
            acceleration: origin,
        };
        let joints = self.joints(t, motion, drives);
        let (mut frames, mut hinges): (Vec<Frame<T>>, Vec<Hinge<T>>) = (Vec::new(), Vec::new());
        for (body, &[place, rate, second]) in self.tree.bodies.iter().zip(&joints) {
            let below = body.parent.map_or(ground, |parent| frames[parent]);
            let at = body.at.as_ref().map_or(origin, |at| self.vector(at));
            let rpy = body.rpy.as_ref().map_or(ground.turn, |rpy| self.rpy(rpy));
            let turn = below.turn.then(&rpy);
            let (w, v) = self.screw(&body.joint);
            // exponential of the screw times its coordinate (Lynch and Park, "Modern Robotics" 2017, eq. 3.88)
            let (sin, cos) = place.sin_cos();
            let (first, twice) = (w.cross(&v), w.cross(&w.cross(&v)));
            let slid = v * place + first * (one - cos) + twice * (place - sin);
            let hinge = Hinge {
                angular: turn.of(w),
                linear: turn.of(v),
                at: below.at + below.turn.of(at),
            };
            let slid = turn.of(slid);
            // velocity of the body's origin in the joint frame, per unit of the rate and in total
            let unit = hinge.linear + hinge.angular.cross(&slid);
            let (spin, relative) = (hinge.angular * rate, unit * rate);
            let arm = hinge.at + slid - below.at;
            frames.push(Frame {
                turn: turn.then(&Turn::about(w, (sin, cos))),
                at: hinge.at + slid,
                spin: below.spin + spin,
                velocity: below.velocity + below.spin.cross(&arm) + relative,
                spin_rate: below.spin_rate + hinge.angular * second + below.spin.cross(&spin),
                acceleration: below.acceleration
                    + below.spin_rate.cross(&arm)
                    + below.spin.cross(&below.spin.cross(&arm))
                    + below.spin.cross(&relative) * T::from_f64(2.0)
                    + unit * second
                    + spin.cross(&relative),
            });
            hinges.push(hinge);
        }
        Pose { frames, hinges, joints }
    }

    fn rpy(&self, rpy: &Triple) -> Turn<T> {
        let (zero, one) = (T::default(), T::from_f64(1.0));
        let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(Vector3::from);
        let [roll, pitch, yaw] = [0, 1, 2].map(|n| Turn::about(axes[n], self.number(rpy[n]).sin_cos()));
        yaw.then(&pitch.then(&roll))
    }

    /// Normalised screw of a joint.
    fn screw(&self, joint: &Joint) -> (Vector3<T>, Vector3<T>) {
        let none = Vector3::from([T::default(); 3]);
        match joint {
            Joint::Fixed => (none, none),
            Joint::Revolute(axis) => (unit(self.vector(axis)), none),
            Joint::Prismatic(axis) => (none, unit(self.vector(axis))),
            Joint::Helical(axis, pitch) => {
                let axis = unit(self.vector(axis));
                (axis, axis * self.number(*pitch))
            }
            Joint::Screw(angular, linear) => {
                let turns = angular.iter().any(|number| number.value != 0.0);
                let (angular, linear) = (self.vector(angular), self.vector(linear));
                let direction = if turns { angular } else { linear };
                let over = T::from_f64(1.0) / dot(direction, direction).sqrt();
                (angular * over, linear * over)
            }
        }
    }

    /// Vector from the origin of a body to its centre of mass.
    fn arm(&self, body: usize, pose: &Pose<T>) -> Vector3<T> {
        pose.frames[body].turn.of(self.matter[body].com)
    }

    /// Product of the inertia of a body about its centre of mass with a vector.
    fn inertia(&self, body: usize, pose: &Pose<T>, by: Vector3<T>) -> Vector3<T> {
        let turn = &pose.frames[body].turn;
        let own = turn.back(by);
        turn.of(Vector3::from(self.matter[body].inertia.map(|row| dot(row, own))))
    }

    /// Forces along the joints that balance the inertia of all bodies and gravity.
    fn inertial(&self, pose: &Pose<T>, gravity: Vector3<T>) -> Vec<T> {
        let wrenches: Vec<[Vector3<T>; 2]> = (0..self.tree.bodies.len())
            .map(|n| {
                let (frame, arm) = (&pose.frames[n], self.arm(n, pose));
                let acceleration =
                    frame.acceleration + frame.spin_rate.cross(&arm) + frame.spin.cross(&frame.spin.cross(&arm));
                let force = (acceleration - gravity) * self.matter[n].mass;
                let moment = self.inertia(n, pose, frame.spin_rate)
                    + frame.spin.cross(&self.inertia(n, pose, frame.spin))
                    + arm.cross(&force);
                [moment, force]
            })
            .collect();
        self.carried(pose, &wrenches)
    }

    /// Sums wrenches on the bodies, about their origins, along the joints that carry them.
    fn carried(&self, pose: &Pose<T>, wrenches: &[[Vector3<T>; 2]]) -> Vec<T> {
        let mut sums = wrenches.to_vec();
        let mut along = vec![T::default(); sums.len()];
        for n in (0..sums.len()).rev() {
            let ([moment, force], hinge, at) = (sums[n], pose.hinges[n], pose.frames[n].at);
            let about_hinge = moment + (at - hinge.at).cross(&force);
            along[n] = dot(hinge.angular, about_hinge) + dot(hinge.linear, force);
            if let Some(parent) = self.tree.bodies[n].parent {
                let arm = at - pose.frames[parent].at;
                sums[parent][0] += moment + arm.cross(&force);
                sums[parent][1] += force;
            }
        }
        along
    }

    /// Friction, spring and torque of a joint.
    fn own_force(&self, body: usize, t: T, [place, rate, _]: Jet<T>) -> T {
        let body = &self.tree.bodies[body];
        let mut force = T::default();
        if let Some(friction) = body.friction {
            force -= self.number(friction) * rate;
        }
        if let Some([stiffness, rest]) = body.spring {
            force -= self.number(stiffness) * (place - self.number(rest));
        }
        force += match body.torque {
            None => T::default(),
            Some(Torque::Constant(c)) => self.number(c),
            Some(Torque::Sine(c)) => -(self.number(c) * place.sin_cos().0),
            Some(Torque::Cubic(c)) => -(self.number(c) * rate * rate * rate),
            Some(Torque::Pumped(c)) => self.number(c) * place * (T::from_f64(2.0) * t).sin_cos().1,
            Some(Torque::Cosine(c)) => self.number(c) * place.sin_cos().1,
        };
        force
    }

    /// Position and velocity of a point.
    fn point(&self, point: usize, pose: &Pose<T>) -> [Vector3<T>; 2] {
        let point = &self.tree.points[point];
        let at = self.vector(&point.at);
        let Some(body) = point.body else {
            return [at, Vector3::from([T::default(); 3])];
        };
        let frame = &pose.frames[body];
        let arm = frame.turn.of(at);
        [frame.at + arm, frame.velocity + frame.spin.cross(&arm)]
    }

    /// Distance of two points, its rate, and the direction from the first to the second.
    fn distance(&self, between: [usize; 2], pose: &Pose<T>) -> (T, T, Vector3<T>) {
        let [[a, va], [b, vb]] = between.map(|point| self.point(point, pose));
        let apart = b - a;
        let distance = dot(apart, apart).sqrt();
        let direction = apart * (T::from_f64(1.0) / distance);
        (distance, dot(vb - va, direction), direction)
    }

    /// Wrenches on the bodies, about their origins, due to forces on points.
    fn wrenches(&self, pose: &Pose<T>) -> Vec<[Vector3<T>; 2]> {
        let none = Vector3::from([T::default(); 3]);
        let mut wrenches = vec![[none; 2]; self.tree.bodies.len()];
        let mut push = |point: usize, force: Vector3<T>| {
            if let Some(body) = self.tree.points[point].body {
                let arm = self.point(point, pose)[0] - pose.frames[body].at;
                wrenches[body][0] += arm.cross(&force);
                wrenches[body][1] += force;
            }
        };
        for action in &self.tree.actions {
            match *action {
                Action::Force { point, force, within } => {
                    let force = self.vector(&force);
                    push(point, within.map_or(force, |body| pose.frames[body].turn.of(force)));
                }
                Action::Spring {
                    between,
                    stiffness,
                    length,
                } => {
                    let (distance, _, direction) = self.distance(between, pose);
                    let pull = direction * (self.number(stiffness) * (distance - self.number(length)));
                    push(between[0], pull);
                    push(between[1], -pull);
                }
                Action::Damper { between, coefficient } => {
                    let (_, rate, direction) = self.distance(between, pose);
                    let pull = direction * (self.number(coefficient) * rate);
                    push(between[0], pull);
                    push(between[1], -pull);
                }
                Action::Along { .. } | Action::Potential { .. } | Action::Dissipation { .. } => {}
            }
        }
        wrenches
    }
}

impl Law {
    fn jet<T: Real>(self, t: T) -> Jet<T> {
        let number = T::from_f64;
        match self {
            Self::Still => [number(0.375), T::default(), T::default()],
            Self::Swings => {
                let (sin, cos) = (number(1.5) * t).sin_cos();
                [number(0.5) * sin, number(0.75) * cos, number(-1.125) * sin]
            }
            Self::Drifts => [
                t * t * number(0.25) - t * number(0.125),
                t * number(0.5) - number(0.125),
                number(0.5),
            ],
        }
    }
}

impl<T: Real> Turn<T> {
    /// Rotation about a unit vector by an angle with this sine and cosine; the identity for the zero vector.
    fn about(axis: Vector3<T>, (sin, cos): (T, T)) -> Self {
        let (zero, one) = (T::default(), T::from_f64(1.0));
        let column = |e: Vector3<T>| {
            let (first, twice) = (axis.cross(&e), axis.cross(&axis.cross(&e)));
            e + first * sin + twice * (one - cos)
        };
        Self([[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(|e| column(Vector3::from(e))))
    }

    fn of(&self, v: Vector3<T>) -> Vector3<T> {
        self.0[0] * v.x + self.0[1] * v.y + self.0[2] * v.z
    }

    fn back(&self, v: Vector3<T>) -> Vector3<T> {
        Vector3::from(self.0.map(|column| dot(column, v)))
    }

    fn then(&self, inner: &Self) -> Self {
        Self(inner.0.map(|column| self.of(column)))
    }
}

fn dot<T: Real>(a: Vector3<T>, b: Vector3<T>) -> T {
    a.x * b.x + a.y * b.y + a.z * b.z
}

fn unit<T: Real>(v: Vector3<T>) -> Vector3<T> {
    v * (T::from_f64(1.0) / dot(v, v).sqrt())
}

/// Solves a symmetric positive definite system by elimination.
fn solve<T: Real>(mut a: Vec<Vec<T>>, mut b: Vec<T>) -> Vec<T> {
    let n = b.len();
    for k in 0..n {
        let pivot = a[k].clone();
        for i in k + 1..n {
            let factor = a[i][k] / pivot[k];
            for (entry, &above) in a[i].iter_mut().zip(&pivot) {
                *entry -= factor * above;
            }
            let change = factor * b[k];
            b[i] -= change;
        }
    }
    for k in (0..n).rev() {
        for j in k + 1..n {
            let change = a[k][j] * b[j];
            b[k] -= change;
        }
        b[k] /= a[k][k];
    }
    b
}

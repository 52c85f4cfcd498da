use nalgebra::SVector;
use pendulum_core::prelude::*;
use std::time::Instant;
use pendulum_core::Observer;
use pendulum_core::dense::Dense;
mechanism! {
    Rods {
        params { k: N m/rad, c: N m s/rad }
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        generate: [rhs, jacobian],
        body upper on ground: arm { joint: revolute(z), coordinate: theta1, friction: 0.02 }
        body lower on upper: arm { joint: revolute(z) at [0, -1, 0], coordinate: theta2, spring: (k, 0), friction: c, }
    }
}
struct Nothing(f64);
impl Observer<f64, 4> for Nothing {
    fn looks_into(&self, _t0: f64, _t1: f64) -> bool { false }
    fn step(&mut self, dense: &Dense<'_, f64, 4>) { self.0 += dense.step().t1; }
}
struct Looks(f64);
impl Observer<f64, 4> for Looks {
    fn step(&mut self, dense: &Dense<'_, f64, 4>) { self.0 += dense.step().t1; }
}
fn main() {
    let models: Vec<_> = (0..128).map(|n| Rods::new(RodsParams { k: 1.0 * n as f64, c: 0.0 }).unwrap()).collect();
    let starts: Vec<_> = (0..128).map(|n| SVector::from([3.0 * n as f64 / 128.0, 0.1, 0.0, 0.0])).collect();
    let method = Tsit5::new();
    let which = std::env::args().nth(1).unwrap_or_default();
    for _ in 0..20 {
        let a = Instant::now();
        match which.as_str() {
            "alone" => { for (m, x) in models.iter().zip(&starts) { std::hint::black_box(method.solve(m, 0.0, 10.0, *x).unwrap()); } }
            "ends" => { std::hint::black_box(method.ensemble(&models, 0.0, 10.0, &starts).unwrap()); }
            "nothing" => { let mut o: Vec<_> = (0..128).map(|_| Nothing(0.0)).collect(); std::hint::black_box(method.observe(&models, (0.0, 10.0), &starts, |_| &[], &mut o).unwrap()); }
            "looks" => { let mut o: Vec<_> = (0..128).map(|_| Looks(0.0)).collect(); std::hint::black_box(method.observe(&models, (0.0, 10.0), &starts, |_| &[], &mut o).unwrap()); }
            _ => { for (models, starts) in models.chunks(32).zip(starts.chunks(32)) { let mut o: Vec<_> = starts.iter().map(|&x| Solution::start(0.0, x)).collect(); std::hint::black_box(method.observe(&models, (0.0, 10.0), &starts, |_| &[], &mut o).unwrap());} }
        }
        print!("{:.2} ", a.elapsed().as_secs_f64() * 1e3);
    }
    println!("{which}");
}

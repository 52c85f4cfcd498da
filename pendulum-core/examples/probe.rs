use pendulum_core::TaylorSeries;
use pendulum_core::prelude::*;
use std::f64::consts::TAU;

struct Sys<F: Fn(f64) -> f64> {
    u: F,
    a: f64,
} // x' = u(t) * s - a x
impl<F: Fn(f64) -> f64> System<f64, 1> for Sys<F> {
    fn rhs(&self, t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
        SVector::from([(self.u)(t) - self.a * x[0]])
    }
}
impl<F: Fn(f64) -> f64> Jacobian<f64, 1> for Sys<F> {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
        SMatrix::from([[-self.a]])
    }
}
impl<F: Fn(f64) -> f64> TaylorSeries<f64, 1> for Sys<F> {
    type Workspace = ();
    fn workspace(&self) {}
    fn series(&self, t: f64, x: &mut [SVector<f64, 1>], _w: &mut ()) {
        for k in 0..x.len() - 1 {
            let u = if k == 0 { (self.u)(t) } else { 0.0 };
            x[k + 1][0] = (u - self.a * x[k][0]) / (k as f64 + 1.0);
        }
    }
}
/// exact: breakpoints
fn exact(u: &dyn Fn(f64) -> f64, a: f64, x0: f64, breaks: &[f64], ts: &[f64]) -> Vec<f64> {
    let mut out = vec![];
    for &t in ts {
        let mut x = x0;
        let mut s = 0.0;
        for &b in breaks.iter().chain(std::iter::once(&f64::INFINITY)) {
            let e = b.min(t);
            if e > s {
                let v = u(0.5 * (s + e));
                let h = e - s;
                x = if a == 0.0 {
                    x + v * h
                } else {
                    v / a + (x - v / a) * (-a * h).exp()
                };
                s = e;
            }
            if b >= t {
                break;
            }
        }
        out.push(x);
    }
    out
}
fn run<F: Fn(f64) -> f64>(name: &str, u: F, a: f64, breaks: &[f64]) {
    let sys = Sys { u, a };
    print!("{name:26}");
    macro_rules! m { ($($m:ident)*) => { $(
        let r = $m::new().solve(&sys, 0.0, 1.0, [0.0]);
        let (s, mark) = match r { Ok(s) => (s, ' '), Err(e) => (*e.solution, '!') };
        let t = s.last().0;
        let ts: Vec<f64> = vec![0.25 * t, 0.5 * t, 0.75 * t, t];
        let ex = exact(&sys.u, a, 0.0, breaks, &ts);
        let e = ts.iter().zip(&ex).map(|(&t, e)| (s.at(t).unwrap()[0] - e).abs()).fold(0.0, f64::max);
        print!(" {:7.0e}/{:<6}{mark}", e, s.statistics().evaluations);
    )* } }
    m!(Rk45 Tsit5 Vern7 Vern9 Rodas4 Rodas5P Radau5 Auto Taylor);
    println!();
}
fn main() {
    println!("{:26} Rk45 Tsit5 Vern7 Vern9 Rodas4 Rodas5P Radau5 Auto Taylor", "");
    for a in [0.0, 1.0] {
        for f in if std::env::args().count() > 1 {
            vec![1.0, 7.0, 20.0, 100.0]
        } else {
            vec![1.0, 10.0, 100.0, 1000.0]
        } {
            for phi in [0.0, 0.1, 0.3] {
                let u = move |t: f64| if (f * t + phi).rem_euclid(1.0) < 0.5 { 1.0 } else { -1.0 };
                let breaks: Vec<f64> = (0..)
                    .map(|k| (0.5 * k as f64 - phi) / f)
                    .skip_while(|&b| b <= 0.0)
                    .take_while(|&b| b < 1.0)
                    .collect();
                run(&format!("square a={a} f={f} phi={phi}"), u, a, &breaks);
            }
        }
        for w in [0.1, 0.01] {
            for t0 in [0.123, 0.3141, 0.777] {
                let u = move |t: f64| if t >= t0 && t < t0 + w { 1.0 / w } else { 0.0 };
                run(&format!("pulse a={a} w={w} t0={t0}"), u, a, &[t0, t0 + w]);
            }
        }
    }
    let _ = TAU;
}

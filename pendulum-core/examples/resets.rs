use pendulum_core::prelude::*;
use pendulum_core::{Canonical, TaylorSeries};
struct L<const N: usize> {
    a: SMatrix<f64, N, N>,
    u: SVector<f64, N>,
}
impl<const N: usize> System<f64, N> for L<N> {
    fn rhs(&self, _t: f64, x: &SVector<f64, N>) -> SVector<f64, N> {
        self.a * x + self.u
    }
}
impl<const N: usize> Jacobian<f64, N> for L<N> {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        self.a
    }
}
impl<const N: usize> TaylorSeries<f64, N> for L<N> {
    type Workspace = ();
    fn workspace(&self) {}
    fn series(&self, _t: f64, x: &mut [SVector<f64, N>], _: &mut ()) {
        for k in 0..x.len() - 1 {
            x[k + 1] = (self.a * x[k] + if k == 0 { self.u } else { SVector::zeros() }) / (k as f64 + 1.0);
        }
    }
}
impl<const N: usize> Canonical<f64, N> for L<N> {
    fn canonical(&self, t: f64, x: &SVector<f64, N>) -> (SVector<f64, N>, SVector<f64, N>) {
        (*x, self.rhs(t, x))
    }
    fn canonical_jacobian(&self, _t: f64, _x: &SVector<f64, N>) -> (SMatrix<f64, N, N>, SMatrix<f64, N, N>) {
        (SMatrix::identity(), self.a)
    }
}
fn show<M: Method<L<1>, f64, 1>>(name: &str, m: M, a: f64, back: f64) {
    let s = L {
        a: SMatrix::from([[-a]]),
        u: SVector::from([1.0 + a]),
    };
    let e = Event::new(|_t, x: &SVector<f64, 1>| x[0] - 0.7).reset(move |_t, x| x - SVector::from([back]));
    match m.solve_with(&s, 0.0, 2.0, [0.0], &[e]) {
        Ok(s) => print!(" {name}:Ok/{}", s.events().len()),
        Err(e) => {
            let r = format!("{}", e.reason);
            print!(
                " {name}:{}/{}@{:.4}",
                &r[..12.min(r.len())],
                e.solution.events().len(),
                e.t()
            )
        }
    }
}
fn main() {
    for a in [0.0, 1.0] {
        for back in [0.0, 1e-16, 1e-15, 4e-15, 1e-14, 3e-14, 1e-13, 1e-12, 1e-10, 1e-9, 1e-8] {
            println!("a={a} back={back:e}");
            macro_rules! m{($($m:ident)*)=>{$( show(stringify!($m), $m::new().max_steps(3000), a, back); )*}}
            m!(Rk45 Tsit5 Vern7 Vern9 Rodas4 Rodas5P Radau5 Auto Taylor);
            if back == 0.0 || back > 1e-4 {
                show("Rk4", Rk4::new(0.1), a, back);
                show("Gauss4", Gauss4::new(0.1), a, back);
                show("Gauss6", Gauss6::new(0.1), a, back);
            }
            println!();
        }
    }
}

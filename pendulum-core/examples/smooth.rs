use pendulum_core::prelude::*;
struct Vdp(f64);
impl System<f64, 2> for Vdp {
    fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        SVector::from([x[1], self.0 * (1.0 - x[0] * x[0]) * x[1] - x[0]])
    }
}
impl Jacobian<f64, 2> for Vdp {
    fn jacobian(&self, _t: f64, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        let (x, v) = (x[0], x[1]);
        SMatrix::from([[0.0, -2.0 * self.0 * x * v - 1.0], [1.0, self.0 * (1.0 - x * x)]])
    }
}
struct Kep(f64);
impl System<f64, 4> for Kep {
    fn rhs(&self, _t: f64, x: &SVector<f64, 4>) -> SVector<f64, 4> {
        let r = (x[0] * x[0] + x[1] * x[1]).powf(-1.5);
        SVector::from([x[2], x[3], -x[0] * r, -x[1] * r])
    }
}
impl Jacobian<f64, 4> for Kep {
    fn jacobian(&self, t: f64, x: &SVector<f64, 4>) -> SMatrix<f64, 4, 4> {
        let mut m = SMatrix::zeros();
        for j in 0..4 {
            let h = 1e-6;
            let (mut a, mut b) = (*x, *x);
            a[j] += h;
            b[j] -= h;
            let d = (self.rhs(t, &a) - self.rhs(t, &b)) / (2.0 * h);
            for i in 0..4 {
                m[(i, j)] = d[i];
            }
        }
        m
    }
}
struct P(f64);
impl System<f64, 1> for P {
    fn rhs(&self, t: f64, x: &SVector<f64, 1>) -> SVector<f64, 1> {
        SVector::from([-self.0 * (x[0] - t.cos()) - t.sin()])
    }
}
impl Jacobian<f64, 1> for P {
    fn jacobian(&self, _t: f64, _x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
        SMatrix::from([[-self.0]])
    }
}
fn go<S: Jacobian<f64, N>, const N: usize>(name: &str, s: &S, t1: f64, x0: [f64; N]) {
    for tol in [1e-3, 1e-6, 1e-9, 1e-12] {
        print!("{name:8} {tol:.0e}");
        macro_rules! m{($($m:ident)*)=>{$( let st=$m::new().rtol(tol).atol(tol).max_steps(100000).stepper(s,0.0,t1,x0).and_then(|mut s|{let r=s.run(); let st=s.statistics(); r.map(|_|st).or(Ok(st))}).unwrap(); print!(" {}={}({})",stringify!($m),st.evaluations,st.rejected); )*}}
        m!(Rk45 Tsit5 Vern7 Vern9 Auto Rodas5P);
        if tol > 1e-10 {
            m!(Rodas4 Radau5);
        }
        println!();
    }
}
fn main() {
    go("vdp2", &Vdp(2.0), 30.0, [2.0, 0.0]);
    go("vdp20", &Vdp(20.0), 50.0, [2.0, 0.0]);
    go("kep.5", &Kep(0.0), 30.0, [0.5, 0.0, 0.0, 3f64.sqrt()]);
    go("kep.9", &Kep(0.0), 30.0, [0.1, 0.0, 0.0, 19f64.sqrt()]);
    go("short", &Kep(0.0), 1.0, [0.5, 0.0, 0.0, 3f64.sqrt()]);
    go("p1", &P(1.0), 20.0, [1.5]);
    go("p1e4", &P(1e4), 2.0, [1.5]);
    go("zero", &P(1.0), 20.0, [0.0]);
    struct Swing;
    impl System<f64, 2> for Swing {
        fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
            SVector::from([x[1], -x[0].sin()])
        }
    }
    impl Jacobian<f64, 2> for Swing {
        fn jacobian(&self, _t: f64, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
            SMatrix::from([[0.0, -x[0].cos()], [1.0, 0.0]])
        }
    }
    go("swing", &Swing, 10.0, [2.0, 0.0]);
    go("swing100", &Swing, 100.0, [2.0, 0.0]);
}

use pendulum_core::prelude::*;
fn main() {
    let f = 10.0;
    struct S(f64);
    impl System<f64, 1> for S {
        fn rhs(&self, t: f64, _x: &SVector<f64, 1>) -> SVector<f64, 1> {
            SVector::from([if (self.0 * t).rem_euclid(1.0) < 0.5 { 1.0 } else { -1.0 }])
        }
    }
    impl Jacobian<f64, 1> for S {
        fn jacobian(&self, _t: f64, _x: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
            SMatrix::from([[0.0]])
        }
    }
    macro_rules! m {
        ($m:ident) => {{
            println!("{}", stringify!($m));
            let s = S(f);
            let mut st = $m::new().stepper(&s, 0.0, 1.0, [0.0]).unwrap();
            let mut bad = 0;
            let tri = |t: f64| {
                let p = (f * t).rem_euclid(1.0);
                (if p < 0.5 { p } else { 1.0 - p }) / f
            };
            while let Some(p) = st.step().unwrap() {
                let e = (p.x1[0] - p.x0[0]) - (tri(p.t1) - tri(p.t0));
                println!(
                    "{:.9} h={:.3e} {} err={e:.2e} rej={}",
                    p.t0 * f * 2.0,
                    p.h,
                    if e.abs() > 1e-4 {
                        bad += 1;
                        "BAD"
                    } else {
                        ""
                    },
                    st.statistics().rejected
                );
                if bad > 2 {
                    break;
                }
            }
        }};
    }
    m!(Tsit5);
    m!(Radau5);
}

//! Quaternions projected onto the unit sphere, with hand-written equations.

use nalgebra::SVector;
use pendulum_core::dense::Dense;
use pendulum_core::method::{Scheme, Stepper};
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::Isa;
use pendulum_core::system::Differences;
use pendulum_core::{EnsembleError, Observer, Reason};
use testbed::motions::{Top, motion};
use testbed::random::Random;

/// Reference motions, each with the attainable accuracy. The heavy top turns by 300 rad. The free body starts near its
/// middle axis and repeatedly leaves it by a factor of exp(5) each second.
const ALL: [(&str, Top, f64); 3] = [
    ("heavy_top_kynema", Top::HEAVY, 1e-12),
    ("spherical_pendulum_with_friction", Top::SPHERICAL, 1e-12),
    ("free_body", Top::FREE, 1e-11),
];

/// Largest error of a method at the times of a reference motion: of the quaternion, and of the rates relative to the
/// largest.
fn error(name: &str, solve: impl Fn(f64, SVector<f64, 7>) -> SVector<f64, 7>) -> f64 {
    let motion = motion(name);
    let errors = motion.states.iter().map(|(t, x)| {
        let error = solve(*t, motion.x0) - x;
        let (of_quaternion, of_rates) = (error.fixed_rows::<4>(0).amax(), error.fixed_rows::<3>(4).amax());
        of_quaternion.max(of_rates / x.fixed_rows::<3>(4).amax())
    });
    errors.fold(0.0, f64::max)
}

/// Length of the quaternion, minus 1.
fn beyond(x: &SVector<f64, 7>) -> f64 {
    x.fixed_rows::<4>(0).norm() - 1.0
}

#[test]
fn motions_with_balls_agree_with_their_reference() {
    for (name, top, most) in ALL {
        let worst = error(name, |t, x0| {
            let end = Vern9::new()
                .rtol(1e-14)
                .atol(1e-16)
                .stepper(&top, 0.0, t, x0)
                .and_then(|mut s| s.run());
            end.expect("it arrives")
        });
        println!("{name}: {worst:e}");
        assert!(worst < most, "{name}: {worst:e}");
    }
}

#[test]
fn every_method_stays_on_the_unit_sphere_and_keeps_its_order() {
    fn run<C, S>(stepper: Result<Stepper<'_, C, S, f64, 7>, Reason>) -> SVector<f64, 7>
    where
        C: Scheme<S, f64, 7>,
        S: System<f64, 7>,
    {
        let mut stepper = stepper.expect("it starts");
        while let Some(step) = stepper.step().expect("it goes on") {
            assert!(beyond(&step.x1).abs() < 3e-16, "{:e}", beyond(&step.x1));
        }
        stepper.x()
    }
    let (name, top, _) = ALL[1];
    let derived = Differences(top);
    // the promised accuracy is for one step, and errors of some hundred steps add up
    let (tolerance, most) = (1e-7, 3e-5);
    macro_rules! check {
        ($($method:ident of $system:expr;)*) => {$(
            let worst = error(name, |t, x0| run($method::new().rtol(tolerance).atol(tolerance).stepper($system, 0.0, t,
                x0)));
            println!("{}: {worst:e}", stringify!($method));
            assert!(worst < most, "{}: {worst:e}", stringify!($method));
        )*};
    }
    check! {
        Rk45 of &top;
        Tsit5 of &top;
        Vern7 of &top;
        Vern9 of &top;
        Rodas4 of &derived;
        Rodas5P of &derived;
        Radau5 of &derived;
        Auto of &derived;
    }
    let of = |h: f64| error(name, |t, x0| run(Rk4::new(h).stepper(&top, 0.0, t, x0)));
    let order = (of(0.02) / of(0.01)).log2();
    assert!((order - 4.0).abs() < 0.2, "of order {order}");
}

#[test]
fn a_start_off_the_sphere_is_put_back_where_it_is_close() {
    let (top, x0) = (Top::SPHERICAL, motion(ALL[1].0).x0);
    let mut rounded = x0;
    rounded[0] = 0.866;
    let solution = Tsit5::new().solve(&top, 0.0, 1.0, rounded).expect("it arrives");
    assert!(beyond(&solution.at(0.0).expect("the start")).abs() < 1e-15);
    assert!(beyond(&rounded).abs() > 1e-5);
    let mut far = x0;
    far[0] = 1.0;
    for bad in [far, SVector::zeros()] {
        let reason = Tsit5::new().stepper(&top, 0.0, 1.0, bad).err();
        assert!(
            matches!(
                reason,
                Some(Reason::InvalidInput {
                    what: "distance of x0 from the constraints",
                    ..
                })
            ),
            "{reason:?}"
        );
    }
    let mut stepper = Tsit5::new().stepper(&top, 0.0, 1.0, x0).expect("it starts");
    stepper.step().expect("it goes on");
    let at = stepper.x();
    stepper.restart(stepper.t(), far).expect_err("far off");
    assert_eq!(stepper.x(), at);
    stepper.restart(stepper.t(), rounded).expect("close");
    assert!(beyond(&stepper.x()).abs() < 1e-15);
}

/// States at the ends of steps.
#[derive(Clone, Default)]
struct Ends(Vec<SVector<f64, 7>>);

impl Observer<f64, 7> for Ends {
    fn step(&mut self, dense: &Dense<'_, f64, 7>) {
        self.0.push(dense.step().x1);
    }
}

#[test]
fn lanes_put_states_back_as_scalars_do() {
    /// Compares ensembles of a method with trajectories solved one by one.
    fn check<M>(method: &M)
    where
        M: Method<Top, f64, 7> + ObservedEnsemble<Top, f64, 7>,
    {
        let mut random = Random::new(3);
        let x0 = motion(ALL[1].0).x0;
        let mut starts: Vec<_> = (0..40)
            .map(|_| {
                let mut x = x0.map(|x| x + random.between(-1.0, 1.0));
                let norm = x.fixed_rows::<4>(0).norm();
                // off the sphere by rounding to a few digits
                x.fixed_rows_mut::<4>(0).apply(|q| *q = (*q / norm * 1e4).round() / 1e4);
                x
            })
            .collect();
        starts[7] *= 1.1;
        let models: Vec<Top> = (0..40)
            .map(|_| Top {
                friction: random.between(0.0, 0.1),
                ..Top::SPHERICAL
            })
            .collect();
        let alone: Vec<Ends> = models
            .iter()
            .zip(&starts)
            .map(|(top, x0)| {
                let mut ends = Ends::default();
                _ = method.follow(top, 0.0, 3.0, *x0, &[], &mut ends);
                ends
            })
            .collect();
        for isa in Isa::available() {
            let mut seen = vec![Ends::default(); starts.len()];
            let plain = method.ensemble_on(isa, &models, 0.0, 3.0, &starts);
            let observed = method.observe_on(isa, &models, (0.0, 3.0), &starts, |_| &[], &mut seen);
            for result in [plain, observed] {
                let Err(EnsembleError::Stopped { stopped, x }) = result else {
                    panic!("one start is far off")
                };
                assert!(matches!(stopped[..], [ref one] if one.index == 7 && one.t == 0.0));
                for (n, (x, alone)) in x.iter().zip(&alone).enumerate().filter(|(n, _)| *n != 7) {
                    assert_eq!(Some(x), alone.0.last(), "trajectory {n}");
                    assert!(beyond(x).abs() < 3e-16);
                }
            }
            for (seen, alone) in seen.iter().zip(&alone) {
                assert_eq!(seen.0, alone.0);
            }
        }
    }
    check(&Rk4::new(0.01));
    check(&Tsit5::new());
    check(&Vern9::new());
}

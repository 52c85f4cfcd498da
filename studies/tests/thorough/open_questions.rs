//! Answers to the ten questions of `docs/src/open-questions.md`, each against something independent.

#[path = "../../examples/open_questions/questions/mod.rs"]
mod questions;

use std::error::Error;

use approx::assert_abs_diff_eq;
use nalgebra::{DMatrix, DVector, SVector};
use pendulum_core::prelude::*;
use questions::*;

type Outcome = Result<(), Box<dyn Error>>;

/// The page has every answer as it is printed, and none takes long.
#[test]
fn the_page_has_the_answers() -> Outcome {
    let page = include_str!("../../../docs/src/open-questions.md");
    for (name, answer) in ALL {
        let answer = answer()?;
        let line = format!("{name}: {}", answer.text);
        assert!(page.contains(&line), "the page lacks\n{line}");
        assert!(answer.seconds.is_none_or(|seconds| seconds < 60.0), "{answer:?}");
    }
    Ok(())
}

#[test]
fn friction_holds_up_to_its_limit() -> Outcome {
    assert_eq!(creep::slip()?, 0.0);
    assert_abs_diff_eq!(creep::gives_way()?, 2.0 * 0.7 * 12.0, epsilon = 1e-9);
    Ok(())
}

/// Common end of two rods from two places, on the left of the line from the first to the second.
fn meet((p, r): ([f64; 2], f64), (q, s): ([f64; 2], f64)) -> [f64; 2] {
    let [x, y] = [q[0] - p[0], q[1] - p[1]];
    let apart = x.hypot(y);
    let along = (r * r - s * s + apart * apart) / (2.0 * apart);
    let across = (r * r - along * along).sqrt();
    [
        p[0] + (along * x - across * y) / apart,
        p[1] + (along * y + across * x) / apart,
    ]
}

/// The toe by circles alone, from the lengths of Jansen's leg.
#[test]
fn the_toe_is_where_circles_meet() -> Outcome {
    assert!(linkage::answer()?.figure < 1e-15);
    let leg = linkage::Leg::new(linkage::LegParams::default())?;
    let motion = Vern7::new().solve(&leg, 0.0, 2.0, [0.5, 0.0])?;
    let pivot = [-0.38, -0.078];
    let (d, e) = (0.0261_f64.hypot(0.4001), (0.415_f64 - 0.0261).hypot(0.4001));
    let (h, i) = ((0.367_f64 + 0.0775).hypot(0.4838), 0.0775_f64.hypot(0.4838));
    for (t, x) in motion.points() {
        let crank = [0.15 * x[0].cos(), 0.15 * x[0].sin()];
        let b = meet((pivot, 0.415), (crank, 0.5));
        let c = meet((crank, 0.619), (pivot, 0.393));
        let of_rocker = meet((pivot, d), (b, e));
        let ankle = meet((c, 0.367), (of_rocker, 0.394));
        let toe = meet((c, i), (ankle, h));
        assert_abs_diff_eq!(leg.toe(t, x), SVector::from(toe), epsilon = 1e-13);
    }
    Ok(())
}

#[test]
fn rebounds_end_when_their_sum_does() -> Outcome {
    // from the floor at -1 with the rate sqrt(1 + 2 g), each flight takes half of the one before
    let (g, e) = (9.8, 0.5);
    let rate = f64::sqrt(1.0 + 2.0 * g);
    let exact = (1.0 + rate) / g + 2.0 * rate * e / (g * (1.0 - e));
    assert_abs_diff_eq!(rebounds::answer()?.figure, exact, epsilon = 1e-8);
    let ball = rebounds::Ball::new(rebounds::BallParams {})?;
    let end = Tsit5::new().solve(&ball, 0.0, 2.0, rebounds::START)?.end();
    assert_eq!((end[1], end[3]), (-1.0, 0.0));
    Ok(())
}

/// By the closed form, and by motions from a little higher and with a little more restitution.
#[test]
fn derivatives_pass_impacts() -> Outcome {
    assert!(gradient::answer()?.figure < 1e-12);
    let height = |start: f64, e: f64| -> Result<f64, Box<dyn Error>> {
        let drop = gradient::Drop::new(gradient::DropParams { e })?;
        Ok(Vern9::new().solve(&drop, 0.0, gradient::FALL.1, [start, 0.0])?.end()[0])
    };
    let h = 1e-4;
    let [by_height, by_e] = gradient::derivatives()?;
    assert_abs_diff_eq!(
        by_height,
        (height(1.0 + h, 0.8)? - height(1.0 - h, 0.8)?) / (2.0 * h),
        epsilon = 1e-6
    );
    assert_abs_diff_eq!(
        by_e,
        (height(1.0, 0.8 + h)? - height(1.0, 0.8 - h)?) / (2.0 * h),
        epsilon = 1e-6
    );
    Ok(())
}

/// Accelerations by the equations of Gymnasium's acrobot, those of R. Sutton's book.
#[test]
fn the_acrobot_keeps_its_energy() -> Outcome {
    assert!(energy::answer()?.figure < 1e-11);
    let acrobot = energy::Acrobot::new(energy::AcrobotParams {})?;
    let [a, b, u, v] = [1.1, -0.7, 0.4, -2.3_f64];
    let (d1, d2) = (0.25 + (1.25 + b.cos()) + 2.0, 0.25 + 0.5 * b.cos() + 1.0);
    // with angles against the downward vertical
    let phi2 = 0.5 * 9.8 * (a + b).sin();
    let phi1 = -0.5 * v * v * b.sin() - v * u * b.sin() + 1.5 * 9.8 * a.sin() + phi2;
    let lower = (d2 / d1 * phi1 - 0.5 * u * u * b.sin() - phi2) / (0.25 + 1.0 - d2 * d2 / d1);
    let upper = -(d2 * lower + phi1) / d1;
    let rates = acrobot.rhs(0.0, &SVector::from([a, b, u, v]));
    assert_abs_diff_eq!(rates, SVector::from([u, v, upper, lower]), epsilon = 1e-13);
    Ok(())
}

#[test]
fn exponents_come_in_pairs() -> Outcome {
    let ([a, b, c, d], volume) = exponents::exponents()?;
    assert!(a > 0.3, "{a}");
    assert!((a + d).abs().max((b + c).abs()) < 0.01, "{a} {b} {c} {d}");
    assert_abs_diff_eq!(volume, 0.0, epsilon = 1e-6);
    Ok(())
}

#[test]
fn batches_have_the_bits_of_each_alone() -> Outcome {
    let digests = bits::digests()?;
    assert!(digests.len() > 4);
    assert!(digests.iter().all(|&digest| digest == digests[0]), "{digests:x?}");
    Ok(())
}

#[test]
fn samples_are_as_exact_as_the_plant() -> Outcome {
    assert_abs_diff_eq!(sampling::end()?, sampling::exact(), epsilon = 1e-14);
    Ok(())
}

/// Accelerations of the links by their mass matrix, in closed form for equal links and bobs.
#[test]
fn ten_links_move_as_they_should() -> Outcome {
    const N: usize = 11;
    let (m, l, g, push) = (0.1, 0.1, 9.81, 0.7);
    let links = generation::Links::new(generation::LinksParams::default())?;
    let x = SVector::<f64, 22>::from_fn(|n, _| (1.3 * n as f64 + 0.2).sin());
    // mass of all bobs from the one of link n outward
    let carried = |n: usize| m * (N - n) as f64;
    let mass = DMatrix::from_fn(N, N, |i, j| match (i, j) {
        (0, 0) => carried(0),
        (0, n) | (n, 0) => carried(n) * l * x[n].cos(),
        (i, j) => carried(i.max(j)) * l * l * (x[i] - x[j]).cos(),
    });
    let rate = |n: usize| x[N + n];
    let forces = DVector::from_fn(N, |i, _| match i {
        0 => {
            push + (1..N)
                .map(|n| carried(n) * l * x[n].sin() * rate(n).powi(2))
                .sum::<f64>()
        }
        i => {
            let turning = |j: usize| carried(i.max(j)) * l * l * (x[i] - x[j]).sin() * rate(j).powi(2);
            -carried(i) * g * l * x[i].sin() - (1..N).map(turning).sum::<f64>()
        }
    });
    let exact = mass.lu().solve(&forces).ok_or("a singular mass matrix")?;
    let rates = links.eval(0.0, &x, &generation::LinksInputs { push });
    for n in 0..N {
        assert_abs_diff_eq!(rates[N + n], exact[n], epsilon = 1e-9 * exact.amax());
    }
    Ok(())
}

#[test]
fn the_tip_moves_as_its_jacobian_says() -> Outcome {
    let arm = printed::Arm::new(printed::ArmParams::default())?;
    let x = SVector::from([0.4, -0.9, 1.7, 0.0, 0.0, 0.0_f64]);
    let (tip, jacobian) = arm.tip_and_jacobian(0.0, &x);
    let both = x[1] + x[2];
    let out = 0.4 * x[1].cos() + 0.4 * both.cos() + 0.2 * both.sin();
    let up = 0.2 * both.cos() - 0.4 * x[1].sin() - 0.4 * both.sin();
    assert_abs_diff_eq!(
        tip,
        SVector::from([out * x[0].cos(), out * x[0].sin(), up]),
        epsilon = 1e-15
    );
    let h = 1e-6;
    for n in 0..3 {
        let moved = |by: f64| arm.tip(0.0, &(x + by * SVector::ith(n, 1.0)));
        let slope: SVector<f64, 3> = (moved(h) - moved(-h)) / (2.0 * h);
        assert_abs_diff_eq!(jacobian.column(n).into_owned(), slope, epsilon = 1e-9);
    }
    Ok(())
}

//! Mechanisms of all kinds from random guesses: every accepted state is closed, with the declared orientation.
//!
//! Mechanisms of one kind share a declaration and differ in lengths.

use std::f64::consts::PI;

use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use testbed::random::Random;

use crate::closures::{Par, ParParams, Weld3, Weld3Params};
use crate::coupled_loops::{Bennett, BennettParams, Plate, PlateParams, Spatial, SpatialParams};
use crate::turns::{Bars, BarsParams, SixBar, SixBarParams, Slots, SlotsParams};

mechanism! {
    /// A four-bar of any lengths whose pin is welded, so that it has no closed form.
    pub Pinned {
        params { a: m = 0.2, b: m = 0.5, c: m = 0.4, d: m = 0.6 }
        body crank on ground { mass: 1, inertia: 0.01, joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank { mass: 1, inertia: 0.01, joint: revolute(z) at [a, 0, 0],
            coordinate: phi depends near -0.3 }
        body rocker on ground { mass: 1, inertia: 0.01, joint: revolute(z) at [d, 0, 0],
            coordinate: psi depends near 1.6 }
        body pin on rocker { joint: revolute(z) at [c, 0, 0], coordinate: chi depends near -1.1 }
        close coupler at [b, 0, 0] to pin at [0, 0, 0]: fixed,
        point o on coupler at [b, 0, 0], point p on pin at [0, 0, 0],
        output apart: [o.x - p.x, o.y - p.y],
        output of_coupler: rotation(coupler),
        output of_pin: rotation(pin),
        generate: [rhs],
    }
}

mechanism! {
    /// A slider-crank with its slider `high` above the crank.
    pub Offset {
        params { a: m = 0.2, b: m = 0.5, high: m = 0 }
        body crank on ground { mass: 1, inertia: 0.01, joint: revolute(z), coordinate: theta near 0.8 }
        body rod on crank { mass: 1, inertia: 0.01, joint: revolute(z) at [a, 0, 0], coordinate: phi depends near -0.8 }
        body piston on ground { mass: 1, joint: prismatic(x) at [0, high, 0], coordinate: s depends near 0.6 }
        close rod at [b, 0, 0] to piston at [0, 0, 0]: revolute(z),
        point o on rod at [b, 0, 0], point p on piston at [0, 0, 0],
        output apart: [o.x - p.x, o.y - p.y],
        generate: [rhs],
    }
}

mechanism! {
    /// A slider-crank like `Offset`, closed by the joint in which the piston slides.
    pub Guided {
        params { a: m = 0.2, b: m = 0.5, high: m = 0 }
        body crank on ground { mass: 1, inertia: 0.01, joint: revolute(z), coordinate: theta near 0.8 }
        body rod on crank { mass: 1, inertia: 0.01, joint: revolute(z) at [a, 0, 0], coordinate: phi depends near -1.1 }
        body piston on rod { mass: 1, joint: revolute(z) at [b, 0, 0], coordinate: chi depends near 0.3 }
        close piston at [0, 0, 0] to ground at [0, high, 0]: prismatic(x),
        point o on piston at [0, 0, 0],
        output off: o.y - high,
        output turned: rotation(piston),
        generate: [rhs],
    }
}

mechanism! {
    /// Two cranks that hold a point between them.
    pub Pair {
        params { a: m = 0.3, b: m = 0.5, d: m = 0.6 }
        body left on ground { mass: 1, inertia: 0.01, joint: revolute(z), coordinate: theta near 1.8 }
        body right on ground { mass: 1, inertia: 0.01, joint: revolute(z) at [d, 0, 0], coordinate: psi near 1.2 }
        body first on left { mass: 1, inertia: 0.01, joint: revolute(z) at [a, 0, 0], coordinate: phi depends near -1 }
        body second on right { mass: 1, inertia: 0.01, joint: revolute(z) at [a, 0, 0], coordinate: chi depends near 1 }
        close first at [b, 0, 0] to second at [b, 0, 0]: revolute(z),
        point o on first at [b, 0, 0], point p on second at [b, 0, 0],
        output apart: [o.x - p.x, o.y - p.y],
        generate: [rhs],
    }
}

mechanism! {
    /// A crank, a rod with a ball at its end, and a rocker that also slides along its axis.
    pub Rscr {
        body crank on ground { mass: 1, com: [0.1, 0, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(z),
            coordinate: theta near 0.4 }
        body rod on crank { mass: 1, com: [0.2, 0, 0], inertia: [0.01, 0.02, 0.02],
            joint: revolute([0, 0.6, 0.8]) at [0.2, 0, 0], coordinate: beta depends near 0.2 }
        body block on ground { mass: 0.1, joint: prismatic(y) at [0.6, 0, 0.1], coordinate: s depends near 0.1 }
        body rocker on block { mass: 1, com: [0, 0, 0.1], inertia: [0.01, 0.01, 0.01], joint: revolute(y),
            coordinate: gamma depends near 0.2 }
        close rod at [0.5, 0, 0.1] to rocker at [0, 0, 0.2]: ball,
        point o on rod at [0.5, 0, 0.1], point p on rocker at [0, 0, 0.2],
        output apart: [o.x - p.x, o.y - p.y, o.z - p.z],
        generate: [rhs],
    }
}

mechanism! {
    /// Two arms, an upright between them, and a tie rod.
    pub Wishbone {
        body lower on ground { mass: 1, com: [0, 0.2, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(x),
            coordinate: theta near 0 }
        body upper on ground { mass: 1, com: [0, 0.15, 0], inertia: [0.01, 0.01, 0.01],
            joint: revolute(x) at [0, 0.05, 0.25], coordinate: up depends near 0.1 }
        body u on lower { joint: revolute(z) at [0, 0.4, 0], coordinate: cz depends near 0.05 }
        body v on u { joint: revolute(y), coordinate: cy depends near 0.05 }
        body upright on v { mass: 2, com: [0, 0.05, 0.1], inertia: [0.02, 0.02, 0.02], joint: revolute(x),
            coordinate: cx depends near 0.05 }
        body yoke on ground { joint: revolute(z) at [0.12, 0.05, 0.08], coordinate: tz depends near 0.02 }
        body tie on yoke { mass: 0.3, com: [0, 0.2, 0], inertia: [0.01, 0.001, 0.01], joint: revolute(x),
            coordinate: tx depends near 0.02 }
        close upright at [0, -0.02, 0.25] to upper at [0, 0.33, 0]: ball,
        close upright at [0.12, 0, 0.08] to tie at [0, 0.36, 0]: ball,
        point o on upright at [0, -0.02, 0.25], point p on upper at [0, 0.33, 0],
        point e on upright at [0.12, 0, 0.08], point f on tie at [0, 0.36, 0],
        output apart: [o.x - p.x, o.y - p.y, o.z - p.z, e.x - f.x, e.y - f.y, e.z - f.z],
        generate: [rhs],
    }
}

mechanism! {
    /// Two of the three arms of a delta robot, and a platform that keeps its orientation.
    pub Delta {
        body first on ground { mass: 1, com: [0.1, 0, 0], inertia: [0.01, 0.01, 0.01],
            joint: revolute(y) at [0.2, 0, 0], coordinate: alpha near 0.3 }
        body second on ground { mass: 1, com: [0.1, 0, 0], inertia: [0.01, 0.01, 0.01],
            joint: revolute(y) at [-0.1, 0.17, 0] rpy [0, 0, 2], coordinate: beta near 0.3 }
        body yoke on first { joint: revolute(y) at [0.2, 0, 0], coordinate: fy depends near 1 }
        body rod on yoke { mass: 0.2, com: [0.2, 0, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(z),
            coordinate: fz depends near 0.1 }
        body along on ground { joint: prismatic(x), coordinate: x depends near 0.1 }
        body platform on along { mass: 1, joint: prismatic(z), coordinate: z depends near -0.5 }
        body fork on second { joint: revolute(y) at [0.2, 0, 0], coordinate: gy depends near 1 }
        body bar on fork { mass: 0.2, com: [0.2, 0, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(z),
            coordinate: gz depends near 0.1 }
        close rod at [0.5, 0, 0] to platform at [0.05, 0, 0]: ball,
        close bar at [0.5, 0, 0] to platform at [-0.03, 0.04, 0]: ball,
        point o on rod at [0.5, 0, 0], point p on platform at [0.05, 0, 0],
        point e on bar at [0.5, 0, 0], point f on platform at [-0.03, 0.04, 0],
        output apart: [o.x - p.x, o.y - p.y, o.z - p.z, e.x - f.x, e.y - f.y, e.z - f.z],
        generate: [rhs],
    }
}

mechanism! {
    /// A rod between an arm in a ball joint and a block: it closes only if the arm is turned.
    pub Arm {
        body arm on ground { mass: 1, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1], joint: ball,
            orientation: o near [0, 0, 1.2] }
        body yoke on arm { joint: revolute(z) at [0.5, 0, 0], coordinate: alpha depends near 0.3 }
        body rod on yoke { mass: 1, com: [0.2, 0, 0], inertia: [0.1, 0.1, 0.1], joint: revolute(y),
            coordinate: beta depends near 0.1 }
        body block on ground { mass: 1, joint: prismatic(x) at [0, 0.9, 0], coordinate: s depends near 0.4 }
        close rod at [0.5, 0, 0] to block at [0, 0, 0]: ball,
        point e on rod at [0.5, 0, 0], point f on block at [0, 0, 0],
        output apart: [e.x - f.x, e.y - f.y, e.z - f.z],
        generate: [rhs, energy],
    }
}

mechanism! {
    /// A stone on a telescope, which is singular where the stone is in its joint.
    pub Telescope {
        body stone on ground { mass: 1, inertia: [0.1, 0.1, 0.1], joint: free, orientation: o,
            position: p near [0.3, 0.4, 0.1] }
        body turret on ground { mass: 1, inertia: [0.1, 0.1, 0.1], joint: revolute(z), coordinate: a depends near 0.9 }
        body barrel on turret { mass: 1, inertia: [0.1, 0.1, 0.1], joint: revolute(y), coordinate: b depends near -0.2 }
        body rod on barrel { mass: 1, joint: prismatic(x), coordinate: s depends near 0.5 }
        close rod at [0, 0, 0] to stone at [0, 0, 0]: ball,
        point e on rod at [0, 0, 0], point f on stone at [0, 0, 0],
        output apart: [e.x - f.x, e.y - f.y, e.z - f.z],
        generate: [rhs],
    }
}

mechanism! {
    /// Four hinges whose axes meet in a point: five equations for two coordinates.
    pub Spherical {
        params { turned: rad = 1.2 }
        body first on ground { mass: 1, com: [0, 0.1, 0.2], inertia: [0.1, 0.1, 0.1], joint: revolute(z),
            coordinate: theta near 0.5 }
        body second on first { mass: 1, com: [0, 0.1, 0.2], inertia: [0.1, 0.1, 0.1],
            joint: revolute(z) rpy [0.5, 0, 0], coordinate: phi depends near 0.5 }
        body third on second { mass: 1, com: [0, 0.1, 0.2], inertia: [0.1, 0.1, 0.1], joint: revolute(z) rpy [1, 0, 0],
            coordinate: psi depends near -1 }
        close third at [0, 0, 0] rpy [0.9, 0, 0] to ground at [0, 0, 0] rpy [turned, 0, 0]: revolute(z),
        output third: rotation(third),
        generate: [rhs],
    }
}

/// Closure error: a distance, and the largest difference between the entries of the two rotations.
type Gap = (f64, f64);

/// Numbers of accepted guesses: of 100 near a closed state, and of 100 anywhere.
///
/// Guesses near the state are off by up to `by` in each coordinate, dependent or not.
fn accepted<const N: usize>(
    name: &str,
    (closed, positions, by): ([f64; N], usize, f64),
    assemble: impl Fn(SVector<f64, N>) -> Option<SVector<f64, N>>,
    gap: impl Fn(&SVector<f64, N>) -> Gap,
    size: f64,
) -> [usize; 2] {
    let mut random = Random::new(name.bytes().map(u64::from).sum());
    let mut count = |guess: &mut dyn FnMut(&mut Random, usize) -> f64| {
        let guesses = (0..100).filter(|_| {
            let x = SVector::from_fn(|n, _| if n < positions { guess(&mut random, n) } else { 0.1 });
            let Some(x) = assemble(x) else { return false };
            let (apart, turned) = gap(&x);
            assert!(
                apart <= 1e-12 * size && turned <= 1e-12,
                "{name} at {x}: {apart:e} m, {turned:e}"
            );
            true
        });
        guesses.count()
    };
    let near = count(&mut |random, n| closed[n] + by * random.between(-1.0, 1.0));
    let far = count(&mut |random, _| random.between(-PI, PI));
    [near, far]
}

/// The state itself, if a motion starts from it.
fn starts<M: System<f64, N>, const N: usize>(model: &M, x: SVector<f64, N>) -> Option<SVector<f64, N>> {
    let stepper = Rk45::new().stepper(model, 0.0, 1.0, x).ok()?;
    Some(stepper.x())
}

fn apart(a: SMatrix<f64, 3, 3>, b: SMatrix<f64, 3, 3>) -> f64 {
    (a - b).amax()
}

/// Four-bars of every kind in Grashof's rule, each with an angle of the crank. The shortest bar is the crank, the
/// ground, the coupler, the rocker; then a parallelogram, a kite, and two in which no bar turns all the way.
const FOUR_BARS: [([f64; 4], f64); 8] = [
    ([0.2, 0.5, 0.4, 0.6], 0.8),
    ([0.5, 0.45, 0.4, 0.15], 0.8),
    ([0.45, 0.2, 0.5, 0.6], 1.0),
    ([0.5, 0.5, 0.2, 0.6], 0.8),
    ([0.3, 0.6, 0.3, 0.6], 0.8),
    ([0.3, 0.6, 0.6, 0.3], 0.8),
    ([0.4, 0.3, 0.4, 0.8], 0.7),
    ([0.5, 0.5, 0.4, 0.9], 0.7),
];

#[test]
fn four_bars_in_closed_form() {
    let mut counts = Vec::new();
    for ([a, b, c, d], theta) in FOUR_BARS {
        let params = BarsParams {
            a,
            b,
            c,
            d,
            ..BarsParams::default()
        };
        let model = Bars::new(params).expect("the parameters are physical");
        let name = format!("four-bar {a} {b} {c} {d}");
        let start = |x| starts(&model, x);
        counts.push(accepted(
            &name,
            ([theta, 0.0], 1, 0.15),
            start,
            |x| (model.apart(0.0, x).amax(), 0.0),
            d,
        ));
    }
    assert_eq!(counts.len(), 8);
    println!("{counts:?}");
    assert!(counts.iter().all(|[near, _]| *near == 100), "{counts:?}");
    // those with fully rotating cranks start anywhere
    assert!([0, 1].iter().all(|&n| counts[n][1] == 100), "{counts:?}");
}

#[test]
fn four_bars_without_a_closed_form() {
    let mut counts = Vec::new();
    for ([a, b, c, d], theta) in FOUR_BARS {
        let model = Pinned::new(PinnedParams { a, b, c, d }).expect("the parameters are physical");
        let bars = Bars::new(BarsParams {
            a,
            b,
            c,
            d,
            ..BarsParams::default()
        })
        .expect("the parameters are physical");
        let [phi, psi] = bars.angles(0.0, &SVector::from([theta, 0.0])).into();
        let assemble = |x| model.assemble(0.0, x).ok().and_then(|x| starts(&model, x));
        let gap = |x: &_| {
            (
                model.apart(0.0, x).amax(),
                apart(model.of_coupler(0.0, x), model.of_pin(0.0, x)),
            )
        };
        let closed = [theta, phi, psi, theta + phi - psi, 0.0];
        counts.push(accepted(
            &format!("pinned {a} {b} {c} {d}"),
            (closed, 4, 0.15),
            assemble,
            gap,
            d,
        ));
    }
    println!("{counts:?}");
    assert!(counts.iter().all(|[near, _]| *near >= 95), "{counts:?}");
    assert!(counts.iter().all(|[_, far]| *far >= 10), "{counts:?}");
}

#[test]
fn sliders() {
    let mut counts = Vec::new();
    for high in [0.0, 0.1, -0.25] {
        let model = Offset::new(OffsetParams {
            high,
            ..OffsetParams::default()
        })
        .expect("the parameters are physical");
        let start = |x| starts(&model, x);
        counts.push(accepted(
            "offset",
            ([0.8, 0.0], 1, 0.15),
            start,
            |x| (model.apart(0.0, x).amax(), 0.0),
            0.5,
        ));
    }
    for high in [0.0, 0.1] {
        let model = Guided::new(GuidedParams {
            high,
            ..GuidedParams::default()
        })
        .expect("the parameters are physical");
        let assemble = |x| model.assemble(0.0, x).ok().and_then(|x| starts(&model, x));
        let gap = |x: &_| {
            (
                model.off(0.0, x).abs(),
                apart(model.turned(0.0, x), SMatrix::identity()),
            )
        };
        let phi = ((high - 0.2 * f64::sin(0.8)) / 0.5).asin() - 0.8;
        counts.push(accepted(
            "guided",
            ([0.8, phi, -0.8 - phi, 0.0], 3, 0.15),
            assemble,
            gap,
            0.5,
        ));
    }
    for (a, d) in [(0.2, 0.5), (0.5, 0.2)] {
        let model = Slots::new(SlotsParams {
            a,
            d,
            ..SlotsParams::default()
        })
        .expect("the parameters are physical");
        let start = |x| starts(&model, x);
        counts.push(accepted(
            "slot",
            ([0.8, 0.0], 1, 0.15),
            start,
            |x| (model.apart(0.0, x).amax(), 0.0),
            0.5,
        ));
    }
    assert_eq!(counts.len(), 7);
    println!("{counts:?}");
    assert!(counts.iter().all(|[near, _]| *near >= 95), "{counts:?}");
}

#[test]
fn linkages_of_more_bars() {
    let mut counts = Vec::new();
    for d in [0.6, 0.4] {
        let model = Pair::new(PairParams {
            d,
            ..PairParams::default()
        })
        .expect("the parameters are physical");
        let start = |x| starts(&model, x);
        counts.push(accepted(
            "pair",
            ([1.8, 1.2, 0.0, 0.0], 2, 0.15),
            start,
            |x| (model.apart(0.0, x).amax(), 0.0),
            0.6,
        ));
    }
    for far in [1.5, 1.3] {
        let model = SixBar::new(SixBarParams {
            far,
            ..SixBarParams::default()
        })
        .expect("the parameters are physical");
        let start = |x| starts(&model, x);
        counts.push(accepted(
            "six bars",
            ([0.8, 0.0], 1, 0.15),
            start,
            |x| (model.apart(0.0, x).amax(), 0.0),
            1.5,
        ));
    }
    let model = Plate::new(PlateParams {}).expect("the parameters are physical");
    let assemble = |x| model.assemble(0.0, x).ok().and_then(|x| starts(&model, x));
    let closed = [0.8, 0.2, 1.8, -1.7, 1.4, 0.5];
    counts.push(accepted(
        "plate",
        (closed, 5, 0.15),
        assemble,
        |x| (model.gaps(0.0, x).amax(), 0.0),
        1.5,
    ));
    println!("{counts:?}");
    assert!(counts.iter().all(|[near, _]| *near >= 90), "{counts:?}");
    // a redundant crank that fits, and one that does not
    for (f, least, most) in [(0.5, 100, 100), (0.6, 0, 0)] {
        let model = Par::new(ParParams {
            f,
            ..ParParams::default()
        })
        .expect("the parameters are physical");
        let assemble = |x| model.assemble(0.0, x).ok().and_then(|x| starts(&model, x));
        let [near, far] = accepted(
            "three cranks",
            ([0.7, 0.7, 0.0], 2, 0.15),
            assemble,
            |x| (model.apart(0.0, x).amax(), 0.0),
            0.8,
        );
        println!("{near} {far}");
        assert!((least..=most).contains(&near) && (f < 0.55 || far == 0), "{near} {far}");
    }
}

/// Seven mechanisms in space, and one that cannot close.
#[test]
fn mechanisms_in_space() {
    macro_rules! space {
        ($model:ident { $($of:ident: $value:expr),* }, $params:ident, $closed:expr, $positions:literal, $gap:expr) => {{
            #[allow(clippy::needless_update, reason = "some have no others")]
            let params = $params { $($of: $value,)* ..Default::default() };
            let model = $model::new(params).expect("the parameters are physical");
            let assemble = |x| model.assemble(0.0, x).ok().and_then(|x| starts(&model, x));
            let gap = $gap;
            let closed = model.assemble(0.0, $closed).map_or($closed, |x| x.into());
            let counts = accepted(stringify!($model), (closed, $positions, 0.1), assemble, |x| gap(&model, x), 1.0);
            println!("{}: {counts:?}", stringify!($model));
            counts
        }};
    }
    let identity = SMatrix::<f64, 3, 3>::identity();
    let counts = [
        space!(
            Spatial {},
            SpatialParams,
            [0.8, 0.1, -0.7, 0.6, 0.0],
            4,
            |m: &Spatial, x: &_| (m.gaps(0.0, x).amax(), 0.0)
        ),
        space!(Rscr {}, RscrParams, [0.4, 0.2, 0.1, 0.2, 0.0], 4, |m: &Rscr, x: &_| (
            m.apart(0.0, x).amax(),
            0.0
        )),
        space!(
            Wishbone {},
            WishboneParams,
            [0.0, 0.1, 0.05, 0.05, 0.05, 0.02, 0.02, 0.0],
            7,
            |m: &Wishbone, x: &_| (m.apart(0.0, x).amax(), 0.0)
        ),
        space!(
            Delta {},
            DeltaParams,
            [0.3, 0.3, 1.0, 0.1, 0.1, -0.5, 1.0, 0.1, 0.0, 0.0],
            8,
            |m: &Delta, x: &_| (m.apart(0.0, x).amax(), 0.0)
        ),
        space!(
            Bennett {},
            BennettParams,
            [2.0, 2.0, -2.0, 0.0],
            3,
            |m: &Bennett, x: &_| (m.gaps(0.0, x).amax(), (m.along(0.0, x) - 1.0).abs())
        ),
        space!(
            Weld3 {},
            Weld3Params,
            [0.3, 0.1, 0.1, 0.3, 0.0],
            4,
            |m: &Weld3, x: &_| (0.0, apart(m.of_a(0.0, x), m.of_w(0.0, x)))
        ),
        space!(
            Spherical {},
            SphericalParams,
            [0.5, 0.5, -1.0, 0.0],
            3,
            |m: &Spherical, x: &SVector<f64, 4>| {
                let end = |angle: f64, axes: SMatrix<f64, 3, 3>| axes * SVector::from([0.0, -angle.sin(), angle.cos()]);
                (0.0, (end(0.9, m.third(0.0, x)) - end(1.2, identity)).amax())
            }
        ),
    ];
    assert!(counts.iter().all(|[near, _]| *near >= 90), "{counts:?}");
    let open = space!(
        Bennett { other: 1.2 },
        BennettParams,
        [2.0, 2.0, -2.0, 0.0],
        3,
        |m: &Bennett, x: &_| (m.gaps(0.0, x).amax(), 0.0)
    );
    assert_eq!(open, [0, 0]);
}

/// A loop that requires another orientation of a ball joint, from quaternions near the closed one.
#[test]
fn loops_beyond_a_ball() {
    let model = Arm::new(ArmParams {}).expect("the parameters are physical");
    let mut random = Random::new(3);
    let mut count = 0;
    for _ in 0..100 {
        let half: [f64; 3] = std::array::from_fn(|n| 0.5 * [0.0, 0.0, 1.2][n] + random.between(-0.1, 0.1));
        let angle = SVector::from(half).norm();
        let [x, y, z] = half.map(|part| part * angle.sin() / angle);
        let mut guess = SVector::<f64, 10>::zeros();
        (guess[0], guess[1], guess[2], guess[3]) = (angle.cos(), x, y, z);
        for (n, near) in [0.3, 0.1, 0.4].into_iter().enumerate() {
            guess[4 + n] = near + random.between(-0.2, 0.2);
        }
        let Ok(x) = model.assemble(0.0, guess) else { continue };
        count += 1;
        assert!(model.apart(0.0, &x).amax() < 1e-12, "{x}");
        let end = Rk45::new()
            .rtol(1e-8)
            .atol(1e-8)
            .solve(&model, 0.0, 0.05, x)
            .expect("it moves")
            .end();
        assert!(model.apart(0.0, &end).amax() < 1e-12, "{end}");
    }
    assert!(count >= 95, "{count}");
}

/// A loop that requires another position of a free body.
#[test]
fn loops_beyond_a_free_body() {
    let model = Telescope::new(TelescopeParams {}).expect("the parameters are physical");
    let mut x = SVector::from_element(0.0);
    (x[0], x[1], x[2], x[3]) = (0.3, 0.4, 0.1, 1.0);
    (x[Telescope::A], x[Telescope::B], x[Telescope::S]) = (0.9, -0.2, 0.5);
    let x = model.assemble(0.0, x).expect("it closes");
    assert!(model.apart(0.0, &x).amax() < 1e-15);
    assert!((x[Telescope::S] - f64::sqrt(0.26)).abs() < 1e-15, "{x}");
}

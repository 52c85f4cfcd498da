//! Events with exactly known times.

use std::f64::consts::PI;

use approx::assert_abs_diff_eq;
use pendulum_core::dual::Dual;
use pendulum_core::method::{Adaptive, Estimates, Fixed, OneStep};
use pendulum_core::prelude::*;
use pendulum_core::{Missed, Occurrence, Real, Reason, SolveError};

use crate::methods::{Driven, each_adaptive, each_fixed};

/// A state equal to the time, up to rounding.
fn clock() -> impl System<f64, 1> {
    FnSystem(|_t: f64, _x: &SVector<f64, 1>| SVector::from([1.0]))
}

/// Times of sign changes of `g` between 0 and `t1`, found on steps of size `h`.
fn passages(g: impl Fn(f64) -> f64, h: f64, t1: f64) -> Vec<f64> {
    let event = Event::new(move |t, _x: &SVector<f64, 1>| g(t));
    let solution = Rk4::new(h).solve_with(&clock(), 0.0, t1, [0.0], &[event]);
    let solution = solution.expect("regular");
    assert_eq!(solution.last().0, t1);
    solution.events().iter().map(|event| event.t).collect()
}

#[test]
fn each_passage_is_found_once_wherever_it_lies() {
    // Within a step, at the end of one, at its start, and at the start and end of the span: accurate to the last bits.
    for zero in [0.3, 0.25, 0.0, 1.0, 0.75 + 1e-15, 0.5 - 1e-16] {
        for g in [
            |t: f64, zero: f64| t - zero,
            |t: f64, zero: f64| zero - t,
            |t: f64, zero: f64| (t - zero).powi(3),
        ] {
            let found = passages(|t| g(t, zero), 0.25, 1.0);
            assert_eq!(found.len(), 1, "{zero}: {found:?}");
            assert_abs_diff_eq!(found[0], zero, epsilon = 1e-15);
        }
    }
}

#[test]
fn two_in_one_step() {
    for (a, b) in [
        (0.3, 0.31),
        (0.3, 0.3001),
        (0.1, 0.9),
        (0.013, 0.05),
        (0.96, 0.985),
        (0.5, 1.0),
        (0.0, 0.5),
    ] {
        let found = passages(|t| (t - a) * (t - b), 1.0, 1.0);
        assert_eq!(found.len(), 2, "{a} {b}: {found:?}");
        assert_abs_diff_eq!(found[0], a, epsilon = 1e-12);
        assert_abs_diff_eq!(found[1], b, epsilon = 1e-12);
    }
}

#[test]
fn grazing_events_are_found_where_they_pass() {
    // 1e-10 deep or high: the roots lie 1e-5 to the sides of the extremum.
    let found = passages(|t| (t - 0.55) * (t - 0.55) - 1e-10, 1.0, 3.0);
    assert_eq!(found.len(), 2);
    assert_abs_diff_eq!(found[0], 0.55 - 1e-5, epsilon = 1e-10);
    assert_abs_diff_eq!(found[1], 0.55 + 1e-5, epsilon = 1e-10);
    assert!(passages(|t| (t - 0.55) * (t - 0.55) + 1e-10, 1.0, 3.0).is_empty());
    assert!(passages(|t| t + 1e-300, 1.0, 3.0).is_empty());
    // many roots, with a spacing equal to the step size
    let found = passages(|t| (PI * t).sin() * (1.0 + t), 1.0, 9.5);
    let integers: Vec<f64> = (0..10).map(f64::from).collect();
    assert_abs_diff_eq!(found[..], integers[..], epsilon = 1e-14);
}

#[test]
fn directions_are_those_of_the_integration() {
    let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0]]));
    let events = || {
        let zero = |_t, x: &SVector<f64, 2>| x[0];
        [Event::new(zero), Event::new(zero).rising(), Event::new(zero).falling()]
    };
    let method = Rk45::new().rtol(1e-12).atol(1e-12);
    for direction in [1.0, -1.0] {
        let solution = method.solve_with(&swing, 0.0, direction * 10.0, [1.0, 0.0], &events());
        let solution = solution.expect("regular");
        let times = |index| {
            let events = solution.events().iter().filter(move |event| event.index == index);
            events.map(|event| event.t * direction).collect::<Vec<_>>()
        };
        assert_abs_diff_eq!(times(0)[..], [0.5 * PI, 1.5 * PI, 2.5 * PI][..], epsilon = 1e-10);
        assert_abs_diff_eq!(times(1)[..], [1.5 * PI][..], epsilon = 1e-10);
        assert_abs_diff_eq!(times(2)[..], [0.5 * PI, 2.5 * PI][..], epsilon = 1e-10);
        for event in solution.events() {
            assert_abs_diff_eq!(event.x[0], 0.0, epsilon = 1e-15);
            assert_abs_diff_eq!(event.x, solution.at(event.t).expect("within"), epsilon = 1e-15);
        }
    }
    // the function increases at the start, so the falling event does not occur
    let solution = method
        .solve_with(&swing, 0.0, 1.0, [0.0, 1.0], &events())
        .expect("regular");
    let found: Vec<_> = solution.events().iter().map(|event| (event.index, event.t)).collect();
    assert_eq!(found, [(0, 0.0), (1, 0.0)]);
}

#[test]
fn a_terminal_event_is_the_end() {
    let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0]]));
    let end = |value: f64| Event::new(move |_t, x: &SVector<f64, 2>| x[0] - value).terminal();
    let method = Rk45::new().rtol(1e-12).atol(1e-12);
    let whole = method.solve(&swing, 0.0, 10.0, [1.0, 0.0]).expect("regular");
    let solution = method.solve_with(&swing, 0.0, 10.0, [1.0, 0.0], &[end(2.0), end(0.3)]);
    let solution = solution.expect("regular");
    let (t, x) = solution.last();
    assert_abs_diff_eq!(t, 0.3_f64.acos(), epsilon = 1e-11);
    assert_abs_diff_eq!(x[0], 0.3, epsilon = 1e-15);
    assert_eq!(solution.events(), [Occurrence { index: 1, t, x }]);
    // the truncated step has the same polynomial
    for theta in [0.1, 0.5, 0.9, 0.99] {
        let t = theta * t;
        assert_abs_diff_eq!(
            solution.at(t).expect("within"),
            whole.at(t).expect("within"),
            epsilon = 1e-15
        );
    }
    assert!(solution.at(t.next_up()).is_err());
    let solution = method
        .solve_with(&swing, 0.0, 10.0, [1.0, 0.0], &[end(1.0).at_start()])
        .expect("regular");
    assert_eq!(solution.t(), [0.0], "at the start");
    let event = Occurrence {
        index: 0,
        t: 0.0,
        x: solution.end(),
    };
    assert_eq!(solution.events(), [event]);
}

#[test]
fn a_motion_that_starts_where_a_terminal_event_is_zero_goes_on_to_the_next_zero() {
    let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0]]));
    let turns = || Event::new(|_t, x: &SVector<f64, 2>| x[1]);
    let method = Rk45::new().rtol(1e-12).atol(1e-12);
    // released at rest, until the first turning point; forward and backward in time
    for direction in [1.0, -1.0] {
        for events in [[turns().terminal(), turns()], [turns().terminal(), turns().rising()]] {
            let solution = method.solve_with(&swing, 0.0, 10.0 * direction, [1.0, 0.0], &events);
            let solution = solution.expect("regular");
            assert_abs_diff_eq!(solution.last().0, PI * direction, epsilon = 1e-10);
            assert_abs_diff_eq!(solution.end()[0], -1.0, epsilon = 1e-10);
            let terminal: Vec<_> = solution.events().iter().filter(|event| event.index == 0).collect();
            assert_eq!((terminal.len(), terminal[0].t), (1, solution.last().0));
        }
        // the motion ends at the start only if the direction matches
        let asked = |event: Event<'static, f64, 2>| {
            let event = event.terminal().at_start();
            let solution = method.solve_with(&swing, 0.0, 10.0 * direction, [1.0, 0.0], &[event]);
            solution.expect("regular").last().0
        };
        let falls = if direction > 0.0 {
            asked(turns().falling())
        } else {
            asked(turns().rising())
        };
        assert_eq!((asked(turns()), falls), (0.0, 0.0));
    }
    // a reset event that is zero at the start takes effect at its next root
    let back = || turns().reset(|_t, _x| SVector::from([0.25, 0.0]));
    let end = |event| {
        let solution = method.solve_with(&swing, 0.0, 10.0, [1.0, 0.0], &[event]);
        solution.expect("regular").last()
    };
    let (t, x) = end(back().terminal());
    assert_abs_diff_eq!(t, PI, epsilon = 1e-10);
    assert_eq!(x, SVector::from([0.25, 0.0]));
    assert_eq!(end(back().terminal().at_start()), (0.0, SVector::from([0.25, 0.0])));
    // nonterminal events that are zero at the start occur there
    let solution = method.solve_with(&swing, 0.0, 4.0, [1.0, 0.0], &[turns(), back()]);
    let solution = solution.expect("regular");
    assert_eq!(solution.events()[0].t, 0.0);
    assert_eq!(solution.events()[1].t, 0.0);
    assert_abs_diff_eq!(solution.end()[0], 0.25 * (4.0 - PI).cos(), epsilon = 1.0);
}

#[test]
fn zeros_that_are_faster_than_the_steps_are_found() {
    let fast = |rate: f64| Event::new(move |t: f64, _x: &SVector<f64, 1>| (rate * t + 0.3).sin());
    let zeros = |rate: f64, t1: f64| ((rate * t1 + 0.3) / PI).floor() as usize;
    // 318 roots in a few steps
    let solution = Rk45::new().solve_with(&clock(), 0.0, 10.0, [0.0], &[fast(100.0)]);
    let solution = solution.expect("regular");
    assert_eq!(
        (solution.events().len(), solution.missed()),
        (zeros(100.0, 10.0), &[][..])
    );
    for (n, event) in solution.events().iter().enumerate() {
        assert_abs_diff_eq!(event.t, (PI * (n + 1) as f64 - 0.3) / 100.0, epsilon = 1e-12);
    }
    // from slow to too fast frequencies: either all roots are found, or the event is reported as missed
    let (mut all, mut some) = (0, 0);
    for n in 0..160 {
        let rate = 1.1_f64.powi(n);
        for h in [1.0, 0.37] {
            let solution = Rk4::new(h).solve_with(&clock(), 0.0, 2.0, [0.0], &[fast(rate)]);
            let solution = solution.expect("regular");
            let is_complete = solution.events().len() == zeros(rate, 2.0);
            assert!(
                is_complete || !solution.missed().is_empty(),
                "{rate}: {}",
                solution.events().len()
            );
            assert!(
                solution.missed().is_empty() || rate * h > 1000.0,
                "{rate}: {:?}",
                solution.missed()
            );
            *(if is_complete { &mut all } else { &mut some }) += 1;
            if rate * h < 500.0 {
                assert!(is_complete, "{rate}");
            }
        }
    }
    assert!(all > 100 && some > 100, "{all} {some}");
}

#[test]
fn the_first_of_many_zeros_ends_a_motion() {
    let fast = || Event::new(|t: f64, _x: &SVector<f64, 1>| (100.0 * t + 0.3).sin());
    for (event, first) in [(fast(), PI), (fast().falling(), PI), (fast().rising(), 2.0 * PI)] {
        let solution = Rk4::new(5.0).solve_with(&clock(), 0.0, 10.0, [0.0], &[event.terminal()]);
        assert_abs_diff_eq!(
            solution.expect("regular").last().0,
            (first - 0.3) / 100.0,
            epsilon = 1e-14
        );
    }
    // each reset leads to the next event
    let counts = fast().rising().reset(|_t, x| x + SVector::from([1.0]));
    let solution = Rk4::new(5.0).solve_with(&clock(), 0.0, 10.0, [0.0], &[counts]);
    let solution = solution.expect("regular");
    assert_eq!((solution.events().len(), solution.missed()), (159, &[][..]));
}

#[test]
fn what_was_missed_is_told_by_event_and_time() {
    let fast = || Event::new(|t: f64, _x: &SVector<f64, 1>| (1e5 * t).sin() + if t > 6.0 { 3.0 } else { 0.0 });
    let slow = || Event::new(|t: f64, _x: &SVector<f64, 1>| t - 4.5);
    let missed = |events: &[Event<'_, f64, 1>]| {
        let solution = Rk4::new(1.0).solve_with(&clock(), 0.0, 10.0, [0.0], events);
        solution.expect("regular").missed().to_vec()
    };
    let one = |index, from, to| vec![Missed { index, from, to }];
    assert_eq!(missed(&[slow(), fast()]), one(1, 0.0, 6.0));
    // until the end of the motion
    assert_eq!(missed(&[fast(), slow().terminal()]), one(0, 0.0, 4.5));
    let text = missed(&[fast()])[0].to_string();
    assert!(
        text.starts_with("event 0 may have occurred more often than was found from t = 0.0 to 6.0"),
        "{text}"
    );
    assert!(text.contains("`h_max`"), "{text}");
}

#[test]
fn what_jumps_or_bends_or_is_noise_is_not_reported() {
    let square = |rate: f64| move |t: f64| (rate * t + 0.1).sin().signum();
    let functions: [&dyn Fn(f64) -> f64; 9] = [
        &square(3.0),
        &square(20.0),
        &|t| (t - 0.3).abs() - 0.1,
        &|t| (7.0 * t).sin().abs() - 0.5,
        // rounding errors around zero, and next to nonzero values
        &|t| (t + 1e3) - t - 1e3,
        &|t| (1.0 - t).max(0.0) + 1e-13 * (1e4 * t).sin(),
        &|t| 3.0 + (1e4 * t).sin(),
        &|t| (-t).exp() * (9.0 * t).cos(),
        &|t| if t < 1.0 { 1.0 } else { -1.0 },
    ];
    for (n, function) in functions.into_iter().enumerate() {
        for h in [0.05, 0.5, 2.0] {
            let event = Event::new(move |t: f64, _x: &SVector<f64, 1>| function(t));
            let solution = Rk4::new(h).solve_with(&clock(), 0.0, 4.0, [0.0], &[event]);
            let solution = solution.expect("regular");
            assert_eq!(solution.missed(), [], "{n} in steps of {h}");
        }
    }
}

/// Number of evaluations of an event function per step.
#[test]
fn a_function_is_looked_at_in_ten_places_but_where_it_goes_up_and_down() {
    let looks = |rate: f64| {
        let count = std::cell::Cell::new(0);
        let event = Event::new(|t: f64, _x: &SVector<f64, 1>| {
            count.set(count.get() + 1);
            2.0 - (rate * t).cos()
        });
        Rk4::new(1.0)
            .solve_with(&clock(), 0.0, 100.0, [0.0], &[event])
            .expect("regular");
        count.get()
    };
    // one more at the start, and thirteen in the first step
    assert_eq!(looks(2.0), 1014);
    assert!(looks(50.0) > 5000);
    // a thousand, plus the evaluations of root searches
    assert!(looks(1e5) < 300_000, "{}", looks(1e5));
}

/// A ball that falls from a height of 1 m.
fn ball() -> impl System<f64, 2> {
    FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -9.81]))
}

fn bounce<'e>(restitution: f64) -> Event<'e, f64, 2> {
    let floor = Event::new(|_t, x: &SVector<f64, 2>| x[0]).falling();
    floor.reset(move |_t, x| SVector::from([x[0], -restitution * x[1]]))
}

#[test]
fn a_ball_rebounds_at_the_times_of_its_parabolas() {
    let fall = (2.0_f64 / 9.81).sqrt();
    for h in [0.01, 0.3, 5.0] {
        let solution = Rk4::new(h).solve_with(&ball(), 0.0, 3.0, [1.0, 0.0], &[bounce(0.8)]);
        let solution = solution.expect("regular");
        let mut time = fall;
        let mut flight = 2.0 * fall;
        for event in solution.events() {
            // The rounding errors of the times accumulate.
            assert_abs_diff_eq!(event.t, time, epsilon = 1e-14);
            flight *= 0.8;
            time += flight;
        }
        assert!(
            time > 3.0 && solution.events().len() == 6,
            "{h}: {}",
            solution.events().len()
        );
        assert!(solution.x().iter().all(|x| x[0] > -1e-14), "never below the floor");
        // two points at a rebound, of which the later one counts
        let first = solution.events()[0];
        let after = solution.at(first.t).expect("within");
        assert_abs_diff_eq!(first.x[1], -9.81 * fall, epsilon = 1e-13);
        assert_eq!(after[1], -0.8 * first.x[1]);
        assert_eq!(solution.t().iter().filter(|&&t| t == first.t).count(), 2);
    }
}

#[test]
fn resets_are_as_accurate_as_the_ends_of_steps() {
    // parabolas, in steps of up to seconds, whose dense output has more rounding errors than their ends
    let fall = (2.0_f64 / 9.81).sqrt();
    let method = Vern9::new().rtol(1e-13).atol(1e-13);
    let solution = method.solve_with(&ball(), 0.0, 8.0, [1.0, 0.0], &[bounce(0.9)]);
    let solution = solution.expect("regular");
    let (mut time, mut flight) = (fall, 2.0 * fall);
    for event in &solution.events()[..22] {
        assert_abs_diff_eq!(event.t, time, epsilon = 1e-13);
        flight *= 0.9;
        time += flight;
    }
    // a pendulum against a wall, in steps whose dense output is wrong by 1e-4: they are retaken up to the wall
    let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -9.81 * x[0].sin()]));
    let wall = || {
        let wall = Event::new(|_t, x: &SVector<f64, 2>| x[0] + 0.3).falling();
        wall.reset(|_t, x| SVector::from([x[0], -0.9 * x[1]]))
    };
    let method = Rk4::new(0.2);
    for (t1, wall) in [(2.0, wall()), (-2.0, wall()), (2.0, wall().terminal())] {
        let solution = method
            .solve_with(&swing, 0.0, t1, [1.0, 0.0], &[wall])
            .expect("regular");
        let first = solution.events()[0];
        assert_abs_diff_eq!(first.x[0], -0.3, epsilon = 1e-15);
        let (t0, x0) = solution
            .points()
            .rfind(|(t, _)| t.abs() < first.t.abs())
            .expect("a start");
        let alone = method
            .stepper(&swing, t0, first.t, *x0)
            .and_then(|mut stepper| stepper.run());
        assert_abs_diff_eq!(first.x, alone.expect("regular"), epsilon = 1e-14);
        // the steps go on to the times of the grid
        let after = solution.t().iter().find(|t| t.abs() > first.t.abs());
        assert!(
            after.is_none_or(|t| (t / 0.2 - (t / 0.2).round()).abs() < 1e-14),
            "{after:?}"
        );
    }
    // an event of time, between the wall in the retaken step and on the dense output, comes on the right side of it
    let first = |events: &[Event<'_, f64, 2>]| {
        let solution = method
            .solve_with(&swing, 0.0, 1.0, [1.0, 0.0], events)
            .expect("regular");
        (solution.events()[0].index, solution.events()[0].t)
    };
    let noted = first(&[Event::new(|_t, x: &SVector<f64, 2>| x[0] + 0.3)]).1;
    let reached = first(&[wall()]).1;
    assert!((noted - reached).abs() > 1e-6);
    let between = 0.5 * (noted + reached);
    let kick = Event::new(move |t, _x: &SVector<f64, 2>| t - between).reset(|_t, x| *x);
    let expected = if reached < between { (0, reached) } else { (1, between) };
    let (index, t) = first(&[wall(), kick]);
    assert_eq!(index, expected.0);
    assert_abs_diff_eq!(t, expected.1, epsilon = 1e-14);
}

#[test]
fn steps_are_retaken_to_finite_times_alone() {
    let clock = FnSystem(|t: f64, _x: &SVector<f64, 1>| {
        assert!(t.is_finite());
        SVector::from([1.0])
    });
    let times = |events: &[Event<'_, f64, 1>]| -> Vec<f64> {
        let solution = Tsit5::new().solve_with(&clock, 0.0, 2.0, [0.0], events);
        solution
            .expect("regular")
            .events()
            .iter()
            .map(|event| event.t)
            .collect()
    };
    // so shortly after a reset that differences of the function are zero, or rounding errors
    for ulps in (1..3000).step_by(7) {
        let soon = 1.0 + f64::from(ulps) * f64::EPSILON;
        let reset = || Event::new(|t, _x: &SVector<f64, 1>| t - 1.0).reset(|_t, x| *x);
        let second = || Event::new(move |_t, x: &SVector<f64, 1>| x[0] - soon);
        for second in [second().reset(|_t, x| *x), second().restart()] {
            let [first, second] = times(&[reset(), second])[..] else {
                panic!("{ulps}")
            };
            assert_abs_diff_eq!(first, 1.0, epsilon = 1e-15);
            assert_abs_diff_eq!(second, soon, epsilon = 1e-15);
        }
    }
    // without a slope at the zero, on one side or on both
    let flat: [fn(f64) -> f64; 5] = [
        |y| y.min(0.0),
        |y| if y < 0.0 { -1.0 } else { 0.0 },
        f64::signum,
        |y| y.powi(3),
        f64::cbrt,
    ];
    for (n, function) in flat.into_iter().enumerate() {
        let event = || Event::new(move |_t, x: &SVector<f64, 1>| function(x[0] - 0.7));
        for event in [event().reset(|_t, x| *x), event().restart()] {
            let [time] = times(&[event])[..] else { panic!("{n}") };
            assert!((0.699..0.8).contains(&time), "{n}: {time}");
        }
    }
}

#[test]
fn events_at_the_ends_of_steps_have_derivatives() {
    // after half a unit of distance at a speed of one, whose time changes by -0.5 per unit of speed
    type Number = Dual<f64, 1>;
    let (speed, half) = (Number::variable(1.0, 0), Number::from_f64(0.5));
    let motion = FnSystem(move |_t: Number, _x: &SVector<Number, 2>| SVector::from([speed, Number::from_f64(1.0)]));
    let at_half = || Event::new(move |t, _x: &SVector<Number, 2>| speed * t - half);
    for event in [at_half(), at_half().terminal(), at_half().reset(|_t, x| *x)] {
        let [t0, t1] = [0.0, 1.0].map(Number::from_f64);
        let solution = Rk4::new(0.5).solve_with(&motion, t0, t1, [t0, t0], &[event]);
        let solution = solution.expect("regular");
        let [event] = solution.events()[..] else {
            panic!("one event")
        };
        let mut points = vec![(event.t, event.x)];
        let last = (solution.t()[solution.t().len() - 1], solution.end());
        points.extend((last.0 == event.t).then_some(last));
        for (t, x) in points {
            for (number, slope) in [(t, -0.5), (x[0], 0.0), (x[1], -0.5)] {
                assert_abs_diff_eq!(number.value, 0.5, epsilon = 1e-15);
                assert_abs_diff_eq!(number.slopes[0], slope, epsilon = 1e-12);
            }
        }
    }
}

#[test]
fn rebounds_that_accumulate_are_an_error_at_that_time() {
    // fall (1 + 2 (r + r^2 + ..)) = fall (1 + r) / (1 - r)
    let end = (2.0_f64 / 9.81).sqrt() * 1.5 / 0.5;
    for method in [Rk45::new(), Rk45::new().h_max(0.01)] {
        let error = method.solve_with(&ball(), 0.0, 3.0, [1.0, 0.0], &[bounce(0.5)]);
        let error = error.expect_err("it comes to rest");
        assert_eq!(error.reason, Reason::EventsAccumulate { event: 0 });
        // Rebounds lower than the rounding error of the height, 1e-16, are not detected; they take 1e-8 s.
        assert_abs_diff_eq!(error.t(), end, epsilon = 2e-8);
        assert_abs_diff_eq!(error.x(), SVector::zeros(), epsilon = 1e-7);
    }
}

#[test]
fn simultaneous_events_see_each_other() {
    // a ball in a corner: it hits both walls at once, and each reverses one velocity component
    let flight = FnSystem(|_t: f64, x: &SVector<f64, 4>| SVector::from([x[2], x[3], 0.0, 0.0]));
    let wall = |i: usize| {
        Event::new(move |_t, x: &SVector<f64, 4>| 1.0 - x[i])
            .falling()
            .reset(move |_t, x| {
                let mut x = *x;
                x[i + 2] = -x[i + 2];
                x
            })
    };
    let solution = Rk45::new().solve_with(&flight, 0.0, 2.0, [0.5, 0.5, 1.0, 1.0], &[wall(0), wall(1)]);
    let solution = solution.expect("regular");
    assert_eq!(solution.events().len(), 2);
    assert_abs_diff_eq!(solution.end(), SVector::from([-0.5, -0.5, -1.0, -1.0]), epsilon = 1e-14);
}

#[test]
fn undefined_events_are_errors_with_what_was_reached() {
    let root = Event::new(|_t, x: &SVector<f64, 1>| (2.0 - x[0]).sqrt() - 0.1);
    let error = Rk4::new(0.25).solve_with(&clock(), 0.0, 5.0, [0.0], &[root]);
    let error = error.expect_err("undefined beyond 2");
    assert!(matches!(error.reason, Reason::EventNotFinite { event: 0, t } if t > 2.0 && t < 2.01));
    assert_eq!((error.t(), error.solution.events().len()), (2.0, 1));
    let undefined = Event::new(|_t, _x: &SVector<f64, 1>| f64::NAN);
    let error = Rk45::new().solve_with(&clock(), 0.0, 5.0, [0.0], &[undefined]);
    let error = error.expect_err("undefined");
    assert_eq!(error.reason, Reason::EventNotFinite { event: 0, t: 0.0 });
    // no error if the integration ends before
    let root = Event::new(|_t, x: &SVector<f64, 1>| (2.0 - x[0]).sqrt() - 0.1).terminal();
    let solution = Rk4::new(0.25).solve_with(&clock(), 0.0, 5.0, [0.0], &[root]);
    assert_abs_diff_eq!(solution.expect("ends").last().0, 1.99, epsilon = 1e-14);
    let nonsense = Event::new(|_t, x: &SVector<f64, 1>| x[0] - 1.0).reset(|_t, _x| SVector::from([f64::NAN]));
    let error = Rk45::new().solve_with(&clock(), 0.0, 5.0, [0.0], &[nonsense]);
    let error = error.expect_err("a bad reset");
    assert!(matches!(error.reason, Reason::BadReset { event: 0, .. }));
    assert_abs_diff_eq!(error.t(), 1.0, epsilon = 1e-15);
    let said = "event 0 resets the state at t = 1.0 to an invalid one: a component is NaN; the state must be finite";
    assert_eq!(error.to_string(), said);
}

/// A point on a circle of radius 1.
struct Round;

impl System<f64, 2> for Round {
    fn rhs(&self, _t: f64, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        SVector::from([-x[1], x[0]])
    }

    fn project(&self, _t: f64, x: &mut SVector<f64, 2>) {
        *x /= x.norm();
    }
}

#[test]
fn a_reset_stays_on_the_constraints() {
    let half = |size: f64| {
        Event::new(|_t, x: &SVector<f64, 2>| x[1])
            .falling()
            .reset(move |_t, _x| SVector::from([0.0, -size]))
    };
    // small deviations are projected onto the constraint, also in the recorded state
    let solution = Rk45::new().solve_with(&Round, 0.0, 4.0, [1.0, 0.0], &[half(1.0005)]);
    let solution = solution.expect("near");
    let after = solution.at(solution.events()[0].t).expect("within");
    assert_eq!(after, SVector::from([0.0, -1.0]));
    for terminal in [false, true] {
        let far = half(1.25);
        let far = if terminal { far.terminal() } else { far };
        // states of the dense output satisfy the constraint to the accuracy of the method
        let method = Vern9::new().rtol(1e-12).atol(1e-12);
        let error = method.solve_with(&Round, 0.0, 4.0, [1.0, 0.0], &[far]);
        let error = error.expect_err("far off");
        let Reason::BadReset { event: 0, t, value, .. } = error.reason else {
            panic!("{error}");
        };
        assert_abs_diff_eq!(t, PI, epsilon = 1e-9);
        assert_eq!(value, 0.25);
        // the error holds the state before the reset
        assert_eq!(error.t(), t);
        assert_abs_diff_eq!(error.x().norm(), 1.0, epsilon = 1e-9);
        assert!(error.x()[0] < -0.9, "{}", error.x());
        assert!(
            error
                .to_string()
                .contains("its distance from the constraints is 0.25; it must be"),
            "{error}"
        );
    }
}

#[test]
fn the_period_of_a_pendulum() {
    // 4 K(sin(a / 2)) = 2 pi / agm(1, cos(a / 2))
    let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]));
    let amplitude: f64 = 2.5;
    let (mut a, mut b) = (1.0, (0.5 * amplitude).cos());
    for _ in 0..6 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    let period = 2.0 * PI / a;
    let top = Event::new(|_t, x: &SVector<f64, 2>| x[1]).falling();
    let solution = Rk45::new()
        .rtol(1e-12)
        .atol(1e-12)
        .solve_with(&swing, 0.0, 45.0, [amplitude, 0.0], &[top]);
    let solution = solution.expect("regular");
    for (n, event) in solution.events().iter().enumerate() {
        assert_abs_diff_eq!(event.t, period * n as f64, epsilon = 1e-9);
    }
    assert_eq!(solution.events().len(), 1 + (45.0 / period) as usize);
}

#[test]
fn jumps_of_an_event_function_are_passages_too() {
    let square = |t: f64| (std::f64::consts::TAU * t).sin().signum();
    let event = Event::new(move |t, _x: &SVector<f64, 1>| square(t)).reset(|_t, x| *x);
    let solution = Rk4::new(0.07).solve_with(&clock(), 0.1, 10.1, [0.0], &[event]);
    let solution = solution.expect("regular");
    let halves: Vec<f64> = (1..=20).map(|n| 0.5 * f64::from(n)).collect();
    let found: Vec<f64> = solution.events().iter().map(|event| event.t).collect();
    assert_abs_diff_eq!(found[..], halves[..], epsilon = 1e-13);
}

#[test]
fn rebounds_may_accumulate_at_the_time_zero() {
    let end = (2.0_f64 / 9.81).sqrt() * 1.5 / 0.5;
    let error = Rk45::new().solve_with(&ball(), -end, 2.0, [1.0, 0.0], &[bounce(0.5)]);
    assert_eq!(
        error.expect_err("it comes to rest").reason,
        Reason::EventsAccumulate { event: 0 }
    );
}

/// A clock that an event sets back by `back` at each occurrence.
fn set_back<M: Method<Driven<Constant, 1>, f64, 1>>(
    method: &M,
    (t0, t1): (f64, f64),
    back: f64,
) -> Result<Solution<f64, 1>, SolveError<f64, 1>> {
    let clock: Driven<Constant, 1> = Driven::new(SMatrix::zeros(), |_t, _x| SVector::from([1.0]));
    let event = Event::new(|_t, x: &SVector<f64, 1>| x[0] - 0.7)
        .rising()
        .reset(move |_t, x| x - SVector::from([back]));
    method.solve_with(&clock, t0, t1, [0.7 - 1e-7], &[event])
}

type Constant = fn(f64, &SVector<f64, 1>) -> SVector<f64, 1>;

/// Setbacks: at the level of rounding errors, slightly above, and far above but negligible against the span.
const BACK: [f64; 3] = [1e-15, 1e-14, 1e-9];

fn check_that_it_accumulates(name: &str, ended: impl Fn(f64) -> Result<Solution<f64, 1>, SolveError<f64, 1>>) {
    for back in BACK {
        let error = ended(back).expect_err("it never ends");
        assert_eq!(error.reason, Reason::EventsAccumulate { event: 0 }, "{name} {back:e}");
        let count = error.solution.events().len();
        assert!(count <= 1002, "{name} {back:e}: {count}");
        assert!(
            (error.x()[0] - 0.7).abs() <= 2.0 * back,
            "{name} {back:e}: {}",
            error.x()[0]
        );
    }
}

#[test]
fn a_reset_that_leads_nowhere_is_an_error_with_every_method() {
    fn adaptive<F>(name: &str)
    where
        F: OneStep<Driven<Constant, 1>, f64, 1> + Estimates + Default,
    {
        check_that_it_accumulates(name, |back| set_back(&Adaptive::<F>::new(), (1.0, 3.0), back));
    }
    fn fixed<F>(name: &str)
    where
        F: OneStep<Driven<Constant, 1>, f64, 1> + Default,
    {
        check_that_it_accumulates(name, |back| set_back(&Fixed::<F>::new(0.1), (1.0, 3.0), back));
    }
    each_adaptive!(adaptive());
    each_fixed!(fixed());
}

#[test]
fn a_thousand_resets_in_a_moment_that_get_somewhere_are_none() {
    // A sawtooth of 5 GHz over a microsecond: the spacing of events is far above the resolution of time.
    fn adaptive<F>(name: &str)
    where
        F: OneStep<Driven<Constant, 1>, f64, 1> + Estimates + Default,
    {
        let solution = set_back(&Adaptive::<F>::new(), (1.0, 1.0 + 1.1e-6), 2e-10);
        let solution = solution.expect("it ends");
        let count = solution.events().len();
        assert!((4999..=5001).contains(&count), "{name}: {count}");
    }
    each_adaptive!(adaptive());
}

/// A clock from 0 after one step of size `h` with events at `times`. The first event is terminal or adds 100 to the
/// state.
fn clock_with_events(h: f64, times: &[f64], first_ends: bool) -> Solution<f64, 1> {
    let event = |(index, &time): (usize, &f64)| {
        let event = Event::new(move |t, _x: &SVector<f64, 1>| t - time);
        match (index, first_ends) {
            (0, true) => event.terminal(),
            (0, false) => event.reset(|_t, x| x + SVector::from([100.0])),
            _ => event,
        }
    };
    let events: Vec<_> = times.iter().enumerate().map(event).collect();
    Rk4::new(h)
        .solve_with(&clock(), 0.0, h, [0.0], &events)
        .expect("regular")
}

#[test]
fn what_is_later_than_the_end_does_not_occur() {
    // Events are simultaneous within 4 ulps of the time, or of the step size if that is larger: 8.9e-16 s per second.
    for (h, end) in [(1.0, 0.3), (16.0, 0.3), (0.125, 0.03)] {
        let apart = 4.0 * f64::EPSILON * h;
        let occurred = |later: f64| {
            let solution = clock_with_events(h, &[end, end + later], true);
            assert_abs_diff_eq!(solution.last().0, end, epsilon = 0.5 * apart);
            let events: Vec<_> = solution.events().iter().map(|event| event.index).collect();
            events
        };
        assert_eq!(occurred(0.0), [0, 1]);
        assert_eq!(occurred(0.3 * apart), [0, 1], "{h}");
        assert_eq!(occurred(2.0 * apart), [0], "{h}");
        assert_eq!(occurred(0.01 * h), [0], "{h}");
        // earlier events occur
        assert_eq!(occurred(-0.3 * apart), [1, 0], "{h}");
        assert_eq!(occurred(-0.01 * h), [1, 0], "{h}");
    }
}

#[test]
fn what_is_noted_sees_what_was_done_before_and_not_after() {
    let states = |others: [f64; 2]| {
        let solution = clock_with_events(1.0, &[0.5, others[0], others[1]], false);
        let mut states = [0.0; 3];
        for event in solution.events() {
            states[event.index] = event.x[0];
        }
        assert_eq!(solution.events().len(), 3);
        assert_abs_diff_eq!(solution.end()[0], 101.0, epsilon = 1e-13);
        states
    };
    assert_abs_diff_eq!(states([0.5, 0.25])[..], [0.5, 100.5, 0.25][..], epsilon = 1e-13);
    // An earlier event and a later one, both simultaneous with the reset.
    assert_abs_diff_eq!(
        states([0.5 - 4e-16, 0.5 + 4e-16])[..],
        [0.5, 0.5, 100.5][..],
        epsilon = 1e-13
    );
    assert_abs_diff_eq!(states([0.75, 0.875])[..], [0.5, 100.75, 100.875][..], epsilon = 1e-13);
}

#[test]
fn events_that_only_record_leave_the_steps_as_they_are() {
    let swing = FnSystem(|_t: f64, x: &SVector<f64, 2>| SVector::from([x[1], -x[0].sin()]));
    let zero = Event::new(|_t, x: &SVector<f64, 2>| x[0]);
    let without = Rk45::new().solve(&swing, 0.0, 20.0, [1.0, 0.0]).expect("regular");
    let with = Rk45::new()
        .solve_with(&swing, 0.0, 20.0, [1.0, 0.0], &[zero])
        .expect("regular");
    assert_eq!((with.t(), with.x()), (without.t(), without.x()));
    assert_eq!((with.events().len(), with.statistics()), (6, without.statistics()));
}

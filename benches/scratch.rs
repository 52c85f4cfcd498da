use nalgebra::SVector;
use pendulum_core::prelude::*;
mechanism! {
    Rods {
        params { k: N m/rad, c: N m s/rad }
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        generate: [rhs, jacobian, taylor],
        body upper on ground: arm { joint: revolute(z), coordinate: theta1, friction: 0.02 }
        body lower on upper: arm { joint: revolute(z) at [0, -1, 0], coordinate: theta2, spring: (k, 0), friction: c, }
    }
}
mechanism! {
    Chain {
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body a on ground: arm { joint: revolute(z), coordinate: q1, friction: 0.02 }
        body b on a: arm { joint: revolute(z) at [0, -1, 0], coordinate: q2, friction: 0.02 }
        body c on b: arm { joint: revolute(z) at [0, -1, 0], coordinate: q3, friction: 0.02 }
        body d on c: arm { joint: revolute(z) at [0, -1, 0], coordinate: q4, friction: 0.02 }
    }
}
mechanism! {
    Dry {
        gravity: [0, -9.81, 0],
        shape arm { solids: [rod(1, [0, 0, 0], [0, -1, 0])] }
        body upper on ground: arm { joint: revolute(z), coordinate: theta1, dry_friction: 1.5, friction: 0.02 }
        body lower on upper: arm { joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute, dry_friction: 0.6, friction: 0.02, }
    }
}
mechanism! {
    Cart {
        params { m: kg = 0.2, l: m = 0.8 }
        input push: N,
        gravity: [0, -9.81, 0],
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push }
        body rod on cart { solids: [rod(m, [0, 0, 0], [0, l, 0])], joint: revolute(z), coordinate: angle }
    }
}
#[derive(Clone, PartialEq)]
struct Law;
impl pendulum_core::InputLaw<4, 1> for Law {
    fn inputs<T: pendulum_core::Real>(&self, _t: T, x: &SVector<T, 4>) -> [T; 1] {
        [T::from_f64(0.1) * x[0] + T::from_f64(0.2) * x[2] + T::from_f64(30.0) * x[1] + T::from_f64(5.0) * x[3]]
    }
}
fn main() {
    let models: Vec<_> = (0..128)
        .map(|n| {
            Rods::new(RodsParams {
                k: 1e3 * n as f64,
                c: 10.0,
            })
            .unwrap()
        })
        .collect();
    let starts: Vec<_> = (0..128)
        .map(|n| SVector::from([3.0 * n as f64 / 128.0, 0.1, 0.0, 0.0]))
        .collect();
    let which = std::env::args().nth(1).unwrap_or_default();
    macro_rules! alone {
        ($m:expr) => {
            for (m, x) in models.iter().zip(&starts) {
                std::hint::black_box($m.stepper(m, 0.0, 10.0, *x).unwrap().run().unwrap());
            }
        };
    }
    macro_rules! chain {
        ($m:expr) => {
            let chain = Chain::new(ChainParams {}).unwrap();
            for n in 0..30 {
                std::hint::black_box(
                    $m.stepper(
                        &chain,
                        0.0,
                        5.0,
                        [0.1 * n as f64, 0.1, 0.2, 0.3, 0.0, 0.0, 0.0, 0.0],
                    )
                    .unwrap()
                    .run()
                    .unwrap(),
                );
            }
        };
    }
    macro_rules! solve {
        ($m:expr) => {
            for (m, x) in models.iter().zip(&starts) {
                std::hint::black_box($m.solve(m, 0.0, 10.0, *x).unwrap());
            }
        };
    }
    macro_rules! event {
        ($m:expr) => {
            for (m, x) in models.iter().zip(&starts) {
                let e = Event::new(|_, x: &SVector<f64, 4>| x[0] + x[1]);
                std::hint::black_box($m.solve_with(m, 0.0, 10.0, *x, &[e]).unwrap());
            }
        };
    }
    macro_rules! lanes {
        ($m:expr) => {
            std::hint::black_box($m.ensemble(&models, 0.0, 10.0, &starts).unwrap());
        };
    }
    let carts: Vec<_> = (0..128)
        .map(|n| {
            Cart::new(CartParams {
                m: 0.2,
                l: 0.5 + 0.01 * n as f64,
            })
            .unwrap()
            .with_law(Law)
        })
        .collect();
    let starts4: Vec<SVector<f64, 4>> = (0..128)
        .map(|n| SVector::from([0.0, 0.002 * n as f64, 0.0, 0.0]))
        .collect();
    match which.as_str() {
        "law_alone" => {
            for (m, x) in carts.iter().zip(&starts4) {
                std::hint::black_box(Tsit5::new().stepper(m, 0.0, 10.0, *x).unwrap().run().unwrap());
            }
        }
        "law_lanes" => {
            std::hint::black_box(Tsit5::new().ensemble(&carts, 0.0, 10.0, &starts4).unwrap());
        }
        "law_alone_rodas" => {
            for (m, x) in carts.iter().zip(&starts4) {
                std::hint::black_box(Rodas5P::new().stepper(m, 0.0, 10.0, *x).unwrap().run().unwrap());
            }
        }
        "law_lanes_rodas" => {
            std::hint::black_box(Rodas5P::new().ensemble(&carts, 0.0, 10.0, &starts4).unwrap());
        }
        "rodas5p" => alone!(Rodas5P::new()),
        "rodas4" => alone!(Rodas4::new()),
        "radau" => alone!(Radau5::new()),
        "auto" => alone!(Auto::new()),
        "tsit5" => alone!(Tsit5::new()),
        "chain_rodas5p" => {
            chain!(Rodas5P::new());
        }
        "chain_radau" => {
            chain!(Radau5::new());
        }
        "chain_auto" => {
            chain!(Auto::new());
        }
        "solve_tsit5" => solve!(Tsit5::new()),
        "solve_vern9" => solve!(Vern9::new()),
        "solve_taylor" => solve!(Taylor::new()),
        "solve_rodas" => solve!(Rodas5P::new()),
        "event_tsit5" => event!(Tsit5::new()),
        "event_vern7" => event!(Vern7::new()),
        "lanes_tsit5" => {
            lanes!(Tsit5::new());
        }
        "lanes_vern9" => {
            lanes!(Vern9::new());
        }
        "lanes_taylor" => {
            lanes!(Taylor::new());
        }
        "lanes_rk4" => {
            lanes!(Rk4::new(0.001));
        }
        "dry_alone" | "dry_lanes" | "dry_vern9" | "dry_rodas" => {
            let dry = Dry::new(DryParams {}).unwrap();
            let starts = &starts[..];
            match which.as_str() {
                "dry_alone" => {
                    for x in starts {
                        std::hint::black_box(Tsit5::new().solve(&dry, 0.0, 20.0, *x).unwrap());
                    }
                }
                "dry_lanes" => {
                    std::hint::black_box(Tsit5::new().ensemble(&[dry], 0.0, 20.0, starts).unwrap());
                }
                "dry_vern9" => {
                    std::hint::black_box(Vern9::new().ensemble(&[dry], 0.0, 20.0, starts).unwrap());
                }
                _ => {
                    for x in starts {
                        std::hint::black_box(Rodas5P::new().solve(&dry, 0.0, 20.0, *x).unwrap());
                    }
                }
            }
        }
        _ => println!(
            "rodas5p rodas4 radau auto tsit5 chain_rodas5p chain_radau chain_auto solve_tsit5 solve_vern9 solve_taylor solve_rodas event_tsit5 event_vern7 lanes_tsit5 lanes_vern9 lanes_taylor lanes_rk4 dry_alone dry_lanes dry_vern9 dry_rodas"
        ),
    }
}

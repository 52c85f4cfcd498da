//! Programs of the README and of the book, which `cargo test` compiles and runs.
#![forbid(unsafe_code)]
#![cfg(doctest)]

macro_rules! pages {
    ($($name:ident: $path:literal,)*) => { $(
        #[doc = include_str!($path)]
        mod $name {}
    )* };
}

pages! {
    readme: "../README.md",
    accuracy_and_speed: "src/accuracy-and-speed.md",
    embedded: "src/embedded.md",
    getting_started: "src/getting-started.md",
    stability: "src/stability.md",
    error_and_method: "src/recipes/error-and-method.md",
    driven_pivot: "src/recipes/driven-pivot.md",
    dry_friction: "src/recipes/dry-friction.md",
    cart_pole: "src/recipes/cart-pole.md",
    clock: "src/recipes/clock.md",
    controller_in_c: "src/recipes/controller-in-c.md",
    computed_torque: "src/recipes/computed-torque.md",
    flip_map: "src/recipes/flip-map.md",
    experiment_design: "src/recipes/experiment-design.md",
    identification: "src/recipes/identification.md",
    kalman_filter: "src/recipes/kalman-filter.md",
    linkages: "src/recipes/linkages.md",
    quadrotor: "src/recipes/quadrotor.md",
    model_predictive_control: "src/recipes/model-predictive-control.md",
    magnets: "src/recipes/magnets.md",
    pictures: "src/recipes/pictures.md",
    poincare_section: "src/recipes/poincare-section.md",
    points: "src/recipes/points.md",
    sampled_pid: "src/recipes/sampled-pid.md",
    saturation: "src/recipes/saturation.md",
    stiff_friction: "src/recipes/stiff-friction.md",
    run_time: "src/recipes/run-time.md",
    sweep: "src/recipes/sweep.md",
    swing_up: "src/recipes/swing-up.md",
    throw: "src/recipes/throw.md",
    units: "src/recipes/units.md",
    urdf: "src/recipes/urdf.md",
}

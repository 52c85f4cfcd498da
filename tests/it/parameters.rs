//! Rules for parameters, and expressions that depend on parameters.

use approx::assert_relative_eq;
use nalgebra::SVector;
use pendulum_core::prelude::*;

mechanism! {
    pub Body {
        params {
            ixx: kg m^2 = 1, iyy: kg m^2 = 1, izz: kg m^2 = 1,
            ixy: kg m^2 = 0, ixz: kg m^2 = 0, iyz: kg m^2 = 0,
        }
        body b on ground {
            mass: 1, inertia: [ixx, iyy, izz, ixy, ixz, iyz],
            joint: revolute([1, 2, 3]),
            coordinate: angle,
        }
    }
}

#[test]
fn an_inertia_must_be_that_of_some_mass() {
    let good = BodyParams::default();
    let rule = |params: BodyParams| Body::new(params).err().map(|error| error.rule);
    assert_eq!(rule(good), None);
    // a thin plate is at the limit
    assert_eq!(
        rule(BodyParams {
            ixx: 0.1,
            iyy: 0.2,
            izz: 0.1 + 0.2,
            ..good
        }),
        None
    );
    for (params, triangle) in [
        (BodyParams { ixx: 2.001, ..good }, "iyy + izz >= ixx"),
        (BodyParams { iyy: 2.001, ..good }, "ixx + izz >= iyy"),
        (BodyParams { izz: 2.001, ..good }, "ixx + iyy >= izz"),
    ] {
        let rule = rule(params).expect("refused");
        assert!(rule.contains(triangle), "{rule}");
    }
    // each product alone may be 0.5, where the body becomes flat; all three together may not
    for params in [
        BodyParams { ixy: 0.501, ..good },
        BodyParams { ixz: -0.501, ..good },
        BodyParams { iyz: 0.501, ..good },
    ] {
        assert!(rule(params).is_some(), "{params:?}");
    }
    let flat = BodyParams { ixy: 0.4999, ..good };
    assert_eq!(rule(flat), None);
    assert!(
        rule(BodyParams {
            ixy: 0.3,
            ixz: 0.3,
            iyz: 0.3,
            ..good
        })
        .is_some()
    );
    // with the other sign all three together are valid
    assert_eq!(
        rule(BodyParams {
            ixy: -0.3,
            ixz: -0.3,
            iyz: -0.3,
            ..good
        }),
        None
    );
}

mechanism! {
    pub AboutJoint {
        params { m: kg = 1, l: m = 1, inertia: kg m^2 = 1.5, g: m/s^2 = 10 }
        gravity: [0, -g, 0],
        body b on ground { mass: m, com: [0, -l, 0], inertia: inertia about joint, joint: revolute(z),
            coordinate: angle }
    }
}

#[test]
fn an_inertia_about_the_joint_is_at_least_that_of_its_mass() {
    let model = AboutJoint::new(AboutJointParams::default()).expect("physical");
    assert_relative_eq!(model.kinetic(0.0, &SVector::from([0.3, 2.0])), 3.0);
    assert!(
        AboutJoint::new(AboutJointParams {
            inertia: 1.0,
            ..Default::default()
        })
        .is_ok()
    );
    let error = AboutJoint::new(AboutJointParams {
        inertia: 0.9,
        ..Default::default()
    })
    .expect_err("too small");
    assert!(error.rule.contains("about its joint"), "{error}");
    let text = "the inertia of `b` about its joint must not be less than that of its mass at the centre of mass; \
                the parameters are m = 1, l = 1, inertia = 0.9";
    assert_eq!(error.to_string(), text);
}

mechanism! {
    /// The second axis is parallel to the first, opposite to it, or zero, depending on the parameter.
    pub Axis {
        params { p: 1 }
        gravity: [0, -9.8, 0],
        body a on ground { mass: 1, com: [0, -1, 0.1], inertia: [0.1, 0.2, 0.3], joint: revolute(z), coordinate: u }
        body b on a {
            mass: 1, com: [0.3, -1, 0.2], inertia: [0.1, 0.2, 0.3],
            joint: revolute([0, 0, p - 1]) at [0, -1, 0],
            coordinate: w,
        }
    }
}

mechanism! {
    pub Along {
        gravity: [0, -9.8, 0],
        body a on ground { mass: 1, com: [0, -1, 0.1], inertia: [0.1, 0.2, 0.3], joint: revolute(z), coordinate: u }
        body b on a {
            mass: 1, com: [0.3, -1, 0.2], inertia: [0.1, 0.2, 0.3],
            joint: revolute(z) at [0, -1, 0],
            coordinate: w,
        }
    }
}

mechanism! {
    pub Against {
        gravity: [0, -9.8, 0],
        body a on ground { mass: 1, com: [0, -1, 0.1], inertia: [0.1, 0.2, 0.3], joint: revolute(z), coordinate: u }
        body b on a {
            mass: 1, com: [0.3, -1, 0.2], inertia: [0.1, 0.2, 0.3],
            joint: revolute(-z) at [0, -1, 0],
            coordinate: w,
        }
    }
}

#[test]
fn an_axis_of_parameters_may_point_either_way() {
    let x = SVector::from([0.4, -1.1, 0.7, 1.9]);
    let along = Along::new(AlongParams {}).expect("physical").rhs(0.0, &x);
    let against = Against::new(AgainstParams {}).expect("physical").rhs(0.0, &x);
    let axis = |p: f64| Axis::new(AxisParams { p }).map(|model| model.rhs(0.0, &x));
    assert_relative_eq!(axis(2.0).expect("physical"), along, epsilon = 1e-12);
    assert_relative_eq!(axis(-0.5).expect("physical"), against, epsilon = 1e-12);
    assert!(axis(1.0).expect_err("no axis").rule.contains("must not be zero"));
}

mechanism! {
    /// The second angle is measured from ground about an axis opposite to the first.
    pub Absolute {
        gravity: [0, -9.8, 0],
        body a on ground { mass: 1, com: [0, -1, 0], inertia: 0.3, joint: revolute(z), coordinate: u }
        body b on a { mass: 1, com: [0.3, -1, 0], inertia: 0.3, joint: revolute(-z) at [0, -1, 0],
            coordinate: w absolute }
    }
}

mechanism! {
    pub Relative {
        gravity: [0, -9.8, 0],
        body a on ground { mass: 1, com: [0, -1, 0], inertia: 0.3, joint: revolute(z), coordinate: u }
        body b on a { mass: 1, com: [0.3, -1, 0], inertia: 0.3, joint: revolute(-z) at [0, -1, 0], coordinate: w }
    }
}

#[test]
fn an_absolute_angle_is_seen_along_its_own_axis() {
    let absolute = Absolute::new(AbsoluteParams {}).expect("physical");
    let relative = Relative::new(RelativeParams {}).expect("physical");
    // the body has turned by u - q about z, which is w = q - u about -z
    let x = SVector::from([0.4, -1.1, 0.7, 1.9]);
    let joint = SVector::from([0.4, -1.1 + 0.4, 0.7, 1.9 + 0.7]);
    let (ours, theirs) = (absolute.rhs(0.0, &x), relative.rhs(0.0, &joint));
    assert_relative_eq!(ours[2], theirs[2], epsilon = 1e-12);
    assert_relative_eq!(ours[3], theirs[3] - theirs[2], epsilon = 1e-12);
    assert_relative_eq!(absolute.energy(0.0, &x), relative.energy(0.0, &joint), epsilon = 1e-12);
}

mechanism! {
    /// Names that are Rust keywords, and tiny masses beside large ones.
    Raw {
        params { r#type: kg = 1e-9, r#in: kg m^2 = 1e-21 }
        input r#loop: N,
        body cart on ground { mass: 1e3, joint: prismatic(x), coordinate: r#move, torque: r#loop }
        body rotor on cart { mass: r#type, inertia: r#in, joint: revolute(z), coordinate: r#fn }
    }
}

#[test]
fn raw_names_and_small_inertias_are_taken() {
    let model = Raw::new(RawParams::default()).expect("physical");
    let rhs = model.eval(0.0, &SVector::from([0.0, 0.0, 1.0, 2.0]), &RawInputs { r#loop: 1.0 });
    assert_relative_eq!(rhs[2], 1e-3, max_relative = 1e-9);
    assert_eq!(Raw::COORDINATES, ["move", "fn"]);
}

mechanism! {
    /// Inertial parameters, lengths, friction and a stiffness, under an input.
    pub Driven {
        params {
            m1: kg = 1.2, m2: kg = 0.7, l: m = 0.8, c: m = 0.4, j: kg m^2 = 0.05,
            g: m/s^2 = 9.8, gamma: N m s = 0.3, k: N m = 2, rest: rad = 0.2,
        }
        gravity: [0, -g, 0],
        generate: [rhs, parameter_jacobian],
        input u: N m,
        body upper on ground {
            mass: m1, com: [0, -c, 0], inertia: [j, j/3, j],
            joint: revolute(z), coordinate: q1, friction: gamma, torque: u,
        }
        body lower on upper {
            mass: m2, com: [c/4, -c, 0.1], inertia: [j, 2*j, j],
            joint: revolute([0, 1, 2]) at [0, -l, 0], coordinate: q2, spring: (k, rest),
        }
    }
}

/// Compares the derivative with respect to a parameter with differences, extrapolated to order four.
#[test]
fn the_right_hand_side_is_derived_by_every_parameter() {
    let params = DrivenParams::default();
    let model = Driven::new(params).expect("physical");
    let (x, u) = (SVector::from([0.7, -0.4, 1.3, 2.1]), DrivenInputs { u: 0.6 });
    let derivatives = model.parameter_jacobian(0.0, &x, &u);
    let fields: [fn(&mut DrivenParams) -> &mut f64; 9] = [
        |p| &mut p.m1,
        |p| &mut p.m2,
        |p| &mut p.l,
        |p| &mut p.c,
        |p| &mut p.j,
        |p| &mut p.g,
        |p| &mut p.gamma,
        |p| &mut p.k,
        |p| &mut p.rest,
    ];
    let h = 1e-3;
    for (column, field) in fields.into_iter().enumerate() {
        let moved = |step: f64| {
            let mut params = params;
            *field(&mut params) += step;
            Driven::new(params).expect("physical").eval(0.0, &x, &u)
        };
        let central = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
        let slope = (4.0 * central(0.5 * h) - central(h)) / 3.0;
        assert!(slope.amax() > 1e-2, "parameter {column} does something");
        assert_relative_eq!(
            derivatives.column(column).into_owned(),
            slope,
            epsilon = 1e-12,
            max_relative = 1e-8
        );
    }
}

mechanism! {
    /// Powers of a parameter with fractional exponents.
    pub Powers {
        units: none,
        params { w: 1 = 4.0 }
        generate: [rhs, parameter_jacobian],
        body a on ground { mass: w^(3/2), joint: prismatic(x), coordinate: s, torque: w^(5/2)*s - sqrt(w)*w^(-3/2) }
    }
}

#[test]
fn half_powers_of_parameters_are_constants() {
    let model = Powers::new(PowersParams::default()).expect("physical");
    // 8 s'' = 32 s - 2/8
    let rhs = model.rhs(0.0, &SVector::from([0.5, 0.0]));
    assert_relative_eq!(rhs[1], (32.0 * 0.5 - 0.25) / 8.0, epsilon = 1e-14);
    // s'' = w s - w^(-5/2)
    let slope = model.parameter_jacobian(0.0, &SVector::from([0.5, 0.0]));
    assert_relative_eq!(slope[(1, 0)], 0.5 + 2.5 * 4.0_f64.powf(-3.5), epsilon = 1e-14);
}

mechanism! {
    pub Quadrilateral {
        params { x: m = 1, y: m = 1 }
        gravity: [0, -9.81, 0],
        body plate on ground {
            solids: [plate(1, [[0, 0], [1, 0], [x, y], [0, 1]])],
            joint: revolute(z),
            coordinate: swing,
        }
    }
}

#[test]
fn the_sides_of_a_plate_must_not_cross() {
    let rule = |x, y| {
        Quadrilateral::new(QuadrilateralParams { x, y })
            .err()
            .map(|error| error.rule)
    };
    // convex, and with a reflex corner
    for (x, y) in [(1.0, 1.0), (0.4, 0.4), (3.0, -1.0)] {
        assert_eq!(rule(x, y), None, "({x}, {y})");
    }
    // below the first side, or left of the last one
    for (x, y) in [(0.4, -0.5), (-0.5, 0.4)] {
        assert_eq!(
            rule(x, y),
            Some("the sides of a plate of `plate` must not cross"),
            "({x}, {y})"
        );
    }
}

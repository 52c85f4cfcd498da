mechanism! {
    pub Followers {
        shape bar { mass: 1, com: [0.1, 0, 0], inertia: 0.1 }
        body crank on ground: bar { joint: revolute(z), coordinate: theta near 0.8 }
        body coupler on crank: bar { joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3 }
        body rocker on ground: bar { joint: revolute(z) at [0.6, 0, 0], coordinate: psi depends near 1.6 }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
        body half on ground: bar { joint: revolute(z), motion: 0.5*psi }
        body part on ground: bar { joint: revolute(z), motion: theta/3 - 2*phi/3 }
        body twice on ground: bar { joint: revolute(z), motion: theta/3 - 2*phi }
    }
}

mechanism! {
    pub Arm {
        point tip on arm at [0, -1, 0],
        point nail on ground at [1, 0, 0],
        point lost on amr,
        point free at [1, 0, 0],
        point odd on arm to [1, 0, 0],
        point theta on arm,
        point idle on arm,
        let a = tipp.x,
        let b = tip.w,
        let c = tip,
        let d = theta.x,
        let e = dot(nail.x),
        let f = distance(tip, tip),
        let g = distance(tip),
        let h = distance(tip, nial),
        let i = dot(tip),
        let j = dot(dot(tip.x)),
        let k = dot(2),
        let l = sqrt(tip.y),
        let m = distance(tip, nail, nail),
        let n = distance(tip, ground),
        let o = distance(tip, arm),
        point far on arm [1, 0, 0],
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}
mechanism! {
    pub Unused {
        point tip on arm,
        body arm on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }
    }
}

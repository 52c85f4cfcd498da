"""The falling ball in MuJoCo: derivatives of its final height by the initial one, through two impacts.

The contact is a damped spring, as its documentation proposes for restitution; the rate it keeps is measured.
"""

import mujoco as mj
import numpy as np

SCENE = """
<mujoco>
  <option timestep="{step}" integrator="Euler" tolerance="0"><flag eulerdamp="disable"/></option>
  <worldbody>
    <geom type="plane" size="1 1 1" solref="-{stiffness} -{damping}" solimp="0.99 0.99 0.01"/>
    <body><joint type="slide" axis="0 0 1"/><geom type="sphere" size="0.1" mass="1"/></body>
  </worldbody>
</mujoco>
"""
FALL, END, RESTITUTION, GRAVITY = 1.0, 1.5, 0.8, 9.81


def closed_form(restitution):
    """Derivative of the height after two impacts of a rigid ball."""
    fall = np.sqrt(2.0 * FALL / GRAVITY)
    flown = END - fall * (1 + 2 * restitution)
    by_height = 0.5 * fall / FALL
    rate = restitution**2 * GRAVITY
    return rate * by_height * flown - (rate * fall - GRAVITY * flown) * by_height * (1 + 2 * restitution)


def rollout(model, height, chained=False):
    """Final height, its derivative by the product of those of the steps, and the largest rate upwards before the end."""
    data = mj.MjData(model)
    data.qpos[0] = height + 0.1
    product, fastest = np.eye(2), []
    step = np.zeros((2, 2))
    for _ in range(round(END / model.opt.timestep)):
        if chained:
            mj.mjd_transitionFD(model, data, 1e-6, True, step, None, None, None)
            product = step @ product
        mj.mj_step(model, data)
        fastest.append(data.qvel[0])
    return data.qpos[0] - 0.1, product[0, 0], max(fastest)


def answers():
    found = []
    # the ratio of damping for which an oscillation keeps that much of its rate in half a turn, of 31 ms
    decay = -np.log(RESTITUTION)
    ratio, stiffness = decay / np.hypot(np.pi, decay), 1e4
    for step in (1e-3, 1e-4):
        scene = SCENE.format(step=step, stiffness=stiffness, damping=2 * ratio * np.sqrt(stiffness))
        model = mj.MjModel.from_xml_string(scene)
        height, chained, fastest = rollout(model, FALL, chained=True)
        kept = fastest / np.sqrt(2 * GRAVITY * FALL)
        h = 1e-2
        apart = (rollout(model, FALL + h)[0] - rollout(model, FALL - h)[0]) / (2 * h)
        exact = closed_form(kept)
        text = (
            f"{chained:.2f} by the derivatives of its steps, {apart:.2f} by two motions {2 * h} m apart; "
            f"{exact:.2f} for a rigid ball that keeps {kept:.2f} of its rate"
        )
        found.append((f"MuJoCo {mj.__version__}, steps of {step:g} s", abs(chained - exact), text))
    return found

"""The capsule between two pads in MuJoCo: the settings of the thread, with pads of our own."""

import mujoco as mj
import numpy as np

SCENE = """
<mujoco>
  <option timestep="0.002" {option}/>
  <default><geom friction="0.7 0.005 0.0001"/></default>
  <worldbody>
    <body pos="-0.024 0 0">
      <joint name="left" type="slide" axis="1 0 0" damping="20"/><geom type="box" size="0.02 0.02 0.02" mass="0.1"/>
    </body>
    <body pos="0.024 0 0">
      <joint name="right" type="slide" axis="-1 0 0" damping="20"/><geom type="box" size="0.02 0.02 0.02" mass="0.1"/>
    </body>
    <body name="capsule">
      <freejoint/><geom type="capsule" size="0.004 0.015" euler="90 0 0" mass="0.045"/>
    </body>
  </worldbody>
  <actuator><position joint="left" kp="30000"/><position joint="right" kp="30000"/></actuator>
</mujoco>
"""

OPTIONS = [
    ("documented for grasping", 'cone="elliptic" impratio="10"'),
    ("impratio 100", 'cone="elliptic" impratio="100"'),
    ("with ten passes of NoSlip", 'cone="elliptic" impratio="10" noslip_iterations="10"'),
]


def press(model, data):
    """Mean normal force of a pad."""
    total, force = 0.0, np.zeros(6)
    for contact in range(data.ncon):
        mj.mj_contactForce(model, data, contact, force)
        total += force[0]
    return total / 2


def answers():
    found = []
    for name, option in OPTIONS:
        model = mj.MjModel.from_xml_string(SCENE.format(option=option))
        data = mj.MjData(model)
        data.ctrl[:] = 0.002
        mj.mj_step(model, data, 2500)
        early = data.body("capsule").xpos[2]
        mj.mj_step(model, data, 2500)
        speed = (early - data.body("capsule").xpos[2]) / 5.0
        text = f"slips at {1e6 * speed:.1f} um/s under pads that press with {press(model, data):.1f} N"
        found.append((f"MuJoCo {mj.__version__}, {name}", speed, text))
    return found

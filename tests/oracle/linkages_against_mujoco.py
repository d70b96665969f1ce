#!/usr/bin/env python3
"""Compares half a second of flight of robots with linkages with that of MuJoCo: a four-bar, closed by a point and by a weld, and
an ankle with two cranks and rods.

Usage: linkages_against_mujoco.py <dump_trajectory>
Exit: 0 all agree, 1 some differ, 77 MuJoCo is not installed (test is skipped).

MuJoCo holds a loop by a soft constraint, made here as stiff as its steps of 20 us allow. Ours is of first order: half the
step must halve the difference, and what is extrapolated from two steps, 2 x(h/2) - x(h), must come much closer.
"""
import pathlib
import sys
import tempfile

try:
    import mujoco
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; pip install mujoco")
    sys.exit(77)

from comparison import Worst, run
from random_models import State

ROWS, ROW_TIME, STEP = 50, 0.01, 2e-5  # [1], [s], [s]
COARSE, FINE = 2000, 4000  # [Hz]
# [m], [rad]
TOLERANCES = {"at 2 kHz": 4e-3, "share left, minus 0.5": 0.05, "extrapolated": 5e-4, "gap of MuJoCo": 5e-5}

HEAD = """<mujoco model="linkage"><compiler angle="radian"/>
<default><equality solref="4e-5 1" solimp="0.9999 0.9999 0.001"/><joint armature="1e-4" damping="0.002"/></default>
<worldbody><body name="base" pos="0 0 1"><freejoint/><inertial pos="0.01 0 0.02" mass="2" diaginertia="0.02 0.03 0.025"/>
"""


def bar(mass, end):
    """Of a thin rod from the body's origin to its end."""
    end = np.array(end, float)
    moment = max(mass * end @ end / 12, 1e-6)
    middle = " ".join(map(repr, map(float, end / 2)))
    return f'<inertial pos="{middle}" mass="{mass}" diaginertia="{moment} {moment} {moment}"/>'


def four_bar(loop):
    return HEAD + f"""<body name="crank" pos="0.1 0 0"><joint name="crank" axis="0 1 0"/>{bar(0.2, (0.02, 0, 0.1))}
<body name="coupler" pos="0.02 0 0.1"><joint name="coupler" axis="0 1 0"/>{bar(0.3, (0.25, 0, 0.03))}</body></body>
<body name="rocker" pos="0.4 0 0"><joint name="rocker" axis="0 1 0"/>{bar(0.25, (-0.03, 0, 0.13))}
<body name="pin" pos="-0.03 0 0.13"><joint name="pin" axis="0 1 0"/>{bar(0.05, (0.01, 0, 0.02))}</body></body>
</body></worldbody><actuator><position joint="crank" kp="8" kv="0.4"/></actuator>
<equality>{loop}</equality></mujoco>"""


POINT = '<connect body1="coupler" body2="pin" anchor="0.25 0 0.03"/>'
WELD = '<weld body1="coupler" body2="pin" anchor="0 0 0"/>'


def ankle():
    """Two cranks at the shank move the foot through rods, each on a universal joint and a point at the foot."""
    sides = loops = ""
    for name, y in (("left", 0.04), ("right", -0.04)):
        sides += f"""<body name="{name}_crank" pos="0.01 {y} -0.1"><joint name="{name}_crank" axis="0 1 0"/>
{bar(0.05, (-0.04, 0, 0))}
<body name="{name}_rod" pos="-0.04 0 0"><joint name="{name}_pitch" axis="0 1 0"/><joint name="{name}_roll" axis="1 0 0"/>
{bar(0.08, (0, 0, -0.18))}</body></body>"""
        loops += f'<connect body1="{name}_rod" body2="foot" anchor="0 0 -0.18"/>'
    return HEAD + f"""{sides}<body name="foot" pos="0 0 -0.3"><joint name="pitch" axis="0 1 0"/><joint name="roll" axis="1 0 0"/>
<inertial pos="0.03 0 -0.03" mass="0.4" diaginertia="0.0006 0.0012 0.0014"/></body></body></worldbody>
<actuator><position joint="left_crank" kp="6" kv="0.3"/><position joint="right_crank" kp="6" kv="0.3"/></actuator>
<equality>{loops}</equality></mujoco>"""


ROBOTS = {
    "four-bar, point": (four_bar(POINT), {"crank": 0.6}),
    "four-bar, weld": (four_bar(WELD), {"crank": -0.4}),
    "ankle": (ankle(), {"left_crank": 0.3, "right_crank": -0.2}),
}


def start(model, targets):
    joints = model.njnt - 1
    names = [model.joint(i + 1).name for i in range(joints)]
    goals = np.array([targets.get(name, 0.0) for name in names])
    still = np.zeros(joints)
    return names, State(np.array([0.0, 0, 1]), np.array([1.0, 0, 0, 0]), np.array([0.3, -0.2, 0.1]), np.array([1.0, 2, -1.5]),
                        still, still, goals, np.zeros((0, 6)), np.zeros(6 + joints))


def reference(model, state, targets):
    """MuJoCo's rows, base position and quaternion and joint positions, and the largest gap of its loops [m]."""
    model.opt.timestep = STEP
    data = mujoco.MjData(model)
    data.qvel[:6] = [*state.velocity, *state.rate]
    data.ctrl[:] = [targets[model.joint(int(joint)).name] for joint in model.actuator_trnid[:, 0]]
    rows, gap = [], 0.0
    for _ in range(ROWS):
        mujoco.mj_step(model, data, nstep=round(ROW_TIME / STEP))
        gap = max(gap, np.abs(data.efc_pos[data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY]).max())
        rows.append(data.qpos.copy())
    return np.array(rows), gap


def difference(ours, theirs):
    """The largest of base position [m], twice the quaternion's and joint positions [rad]."""
    change = np.abs(ours - theirs)
    change[:, 3:7] *= 2
    return change.max()


def main():
    worst = Worst(TOLERANCES)
    with tempfile.TemporaryDirectory() as folder:
        file, states = pathlib.Path(folder) / "robot.xml", pathlib.Path(folder) / "states"
        for name, (text, targets) in ROBOTS.items():
            file.write_text(text)
            model = mujoco.MjModel.from_xml_string(text)
            names, state = start(model, targets)
            states.write_text(" ".join(names) + "\n\n" + state.line() + "\n")
            theirs, gap = reference(model, state, targets)
            coarse, fine = (np.array(run(sys.argv[1], file, states, rate)[0]) for rate in (COARSE, FINE))
            one, half = difference(coarse, theirs), difference(fine, theirs)
            worst.note("at 2 kHz", name, one)
            worst.note("share left, minus 0.5", name, abs(half / one - 0.5))
            worst.note("extrapolated", name, difference(2 * fine - coarse, theirs))
            worst.note("gap of MuJoCo", name, gap)
    return worst.report()


if __name__ == "__main__":
    sys.exit(main())

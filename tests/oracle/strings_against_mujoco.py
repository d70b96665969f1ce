#!/usr/bin/env python3
"""Compares lengths of random spatial tendons, and their rates, with MuJoCo: a tree of hinges and slides with sites, spheres and
cylinders, which moves to random targets at full_dynamics, where the slider of a tendon is exactly as long as the tendon.

Usage: strings_against_mujoco.py <murosimf>
Exit: 0 all agree, 1 some differ, 77 MuJoCo is not installed (test is skipped).
"""
import sys
import tempfile
from pathlib import Path

try:
    import mujoco
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; pip install mujoco")
    sys.exit(77)

import joint_motion
from comparison import Worst

# Logs have about nine digits. Where a string just touches an obstacle, the last digit says whether it does.
TOLERANCES = {"length": 1e-6, "rate": 1e-5}
ROBOTS = 30
BODIES = 5
STRINGS = 6
END = 1.2  # [s]


def vector(numbers):
    return " ".join(f"{number:.4f}" for number in numbers)


def random_body(rng, k):
    kind = "slide" if rng.random() < 0.25 else "hinge"
    shape = "sphere" if rng.random() < 0.5 else "cylinder"
    size = f"{rng.uniform(0.02, 0.1):.4f}" + (" .1" if shape == "cylinder" else "")
    # sides are beside the obstacle or inside of it
    reach = rng.choice([0.02, 0.3])
    return f"""<body name="b{k}" pos="{vector(rng.uniform(-0.15, 0.15, 3))}" euler="{vector(rng.uniform(-2, 2, 3))}">
<joint name="j{k}" type="{kind}" axis="{vector(rng.normal(size=3))}" pos="{vector(rng.uniform(-0.1, 0.1, 3))}"/>
<inertial pos="0 0 0" mass="1" diaginertia=".01 .01 .01"/><site name="s{k}" pos="{vector(rng.uniform(-0.2, 0.2, 3))}"/>
<geom name="g{k}" type="{shape}" size="{size}" pos="{vector(place := rng.uniform(-0.1, 0.1, 3))}"
euler="{vector(rng.uniform(-2, 2, 3))}"/><site name="side{k}" pos="{vector(place + rng.uniform(-reach, reach, 3))}"/>"""


def random_string(rng, k):
    last = rng.integers(BODIES)
    words = f'<site site="s{last}"/>'
    for _ in range(rng.integers(1, 4)):
        body = rng.integers(BODIES)
        side = f' sidesite="side{body}"' if rng.random() < 0.5 else ""
        if rng.random() < 0.7:
            words += f'<geom geom="g{body}"{side}/>'
        last = (last + rng.integers(1, BODIES)) % BODIES  # never the same twice
        words += f'<site site="s{last}"/>'
        if rng.random() < 0.2:
            first, last = rng.choice(BODIES, 2, replace=False)
            words += f'<pulley divisor="{rng.integers(1, 4)}"/><site site="s{first}"/><site site="s{last}"/>'
    return f'<spatial name="t{k}" stiffness="1e-6" springlength="0">{words}</spatial>'


def random_robot(rng):
    trunk = "".join(random_body(rng, k) for k in range(3)) + "</body>" * 3
    arm = "".join(random_body(rng, k) for k in range(3, BODIES)) + "</body>" * (BODIES - 3)
    strings = "".join(random_string(rng, k) for k in range(STRINGS))
    return f"""<mujoco><compiler angle="radian"/><default><geom contype="0" conaffinity="0"/></default><worldbody><body name="b">
<geom size=".1"/>{trunk}{arm}</body></worldbody><tendon>{strings}</tendon></mujoco>"""


def compare(program, folder, seed, worst):
    rng = np.random.default_rng(seed)
    text = random_robot(rng)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    joints, sliders = [f"j{k}" for k in range(BODIES)], [f"t{k}" for k in range(STRINGS)]
    events = [(at, f"a.{name}.joint_target=[{rng.uniform(-2, 2):.3f}]") for at in (0, 0.4, 0.8) for name in joints]
    properties = [f"{name}.joint_{what}" for what in ("position", "velocity") for name in joints + sliders]
    _, rows = joint_motion.logged(program, folder, text, properties, END, "", events, "full_dynamics")
    for row in rows[::7]:
        positions, rates = np.split(row, 2)
        data.qpos[:], data.qvel[:] = positions[:BODIES], rates[:BODIES]
        mujoco.mj_forward(model, data)
        for k in range(STRINGS):
            case = f"robot {seed}, t{k} at {vector(data.qpos)}"
            worst.note("length", case, abs(positions[BODIES + k] - data.ten_length[k]))
            worst.note("rate", case, abs(rates[BODIES + k] - data.ten_velocity[k]) / max(1, np.abs(data.qvel).max()))


def main(program):
    worst = Worst(TOLERANCES)
    with tempfile.TemporaryDirectory() as name:
        for seed in range(ROBOTS):
            compare(program, Path(name), seed, worst)
    return worst.report()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))

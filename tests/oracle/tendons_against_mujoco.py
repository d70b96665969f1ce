#!/usr/bin/env python3
"""Compares robots with fixed tendons over several joints with MuJoCo: where their joints are after a while, and what
`murosimf convert` writes of them.

Usage: tendons_against_mujoco.py <murosimf>
Exit: 0 all agree, 1 some differ, 77 MuJoCo is not installed (test is skipped).
"""
import csv
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import mujoco
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; pip install mujoco")
    sys.exit(77)

from comparison import Worst

# Steps of 1 ms here and of 0.1 ms there; joints swing by 1 rad in 0.1 s, so a millisecond is 10 mrad at the worst. Limits and
# friction of MuJoCo give way by some of a mrad themselves.
TOLERANCES = {"joint position": 0.012, "converted": 1e-9}
TIMES = [0.05, 0.2, 0.5, 1.0]  # [s]
JOINTS = ["i", "j", "s"]

# Two pendulums beside each other, the second with a slide along it.
ROBOT = """<mujoco><compiler angle="radian"/><worldbody><body name="b" pos="0 0 1"><geom size=".1"/>
<body name="l" pos="0 .3 0"><joint name="i" axis="0 1 0" damping=".02" {i}/>
<inertial pos=".1 0 -.2" mass="1" diaginertia=".02 .02 .02"/></body>
<body name="m" pos="0 -.3 0"><joint name="j" axis="0 1 0" damping=".02" {j}/>
<inertial pos="-.05 0 -.15" mass=".7" diaginertia=".01 .01 .01"/>
<body name="n"><joint name="s" type="slide" axis="0 0 1" damping="3" stiffness="80"/>
<inertial pos="0 0 -.1" mass=".3" diaginertia=".001 .001 .001"/></body></body></body></worldbody>
<tendon><fixed name="t" {tendon}>{parts}</fixed>{more}</tendon>{after}</mujoco>"""

TWO = '<joint joint="i" coef="1.5"/><joint joint="j" coef="-.8"/>'
THREE = TWO + '<joint joint="s" coef="4"/>'
CHAIN = '<joint joint="j" coef="-.8"/><joint joint="s" coef="4"/>'  # rotors of others are no part of MuJoCo's sparse inertia
HARD = 'solreflimit=".002 1" solreffriction=".002 1"'
# name: tendon, parts, joints i and j, other tendons, sections, control and target of the actuator
CASES = {
    "spring": {"tendon": 'stiffness="6"', "i": 'ref=".4"'},
    "spring at rest elsewhere": {"tendon": 'stiffness="6" springlength=".5"'},
    "spring slack where the joints' springs are": {"tendon": 'stiffness="6"', "i": 'springref=".5"', "j": 'springref="-.3"'},
    "spring and damper": {"tendon": 'stiffness="6" damping=".4"', "parts": THREE},
    "damper": {"tendon": 'damping="2"'},
    "rotor": {"tendon": 'armature=".03"', "parts": CHAIN},
    "friction": {"tendon": f'frictionloss=".6" {HARD}'},
    "limit": {"tendon": f'range="-.1 .3" {HARD}', "i": 'ref=".1"'},
    "two tendons": {"tendon": 'stiffness="6"', "more": '<fixed name="u" damping=".5" stiffness="3">'
                    '<joint joint="i" coef="1"/><joint joint="j" coef="1"/></fixed>'},
    "actuator": {"after": '<actuator><position name="a" tendon="t" kp="12" kv="1"/></actuator>', "control": 0.6},
    "actuator with gear and force": {"parts": THREE, "control": -0.5, "after":
                                     '<actuator><position tendon="t" kp="12" kv="1" gear="2" forcerange="-1 1.5"/></actuator>'},
    "one joint that does not begin at zero": {"tendon": 'stiffness="6"', "i": 'ref=".4"',
                                              "parts": '<joint joint="i" coef="1.5"/>'},
}
SCENE = """duration = {end}
rate = 1000
[field]
goals = false
[[robots]]
name = "a"
model = "robot.xml"
level = "articulated_dynamics"
controller = "none"
position = [0, 0, 1]
"""


def text_of(case):
    return ROBOT.format(**{"i": "", "j": "", "tendon": "", "parts": TWO, "more": "", "after": ""} | case)


def expected(text, control):
    """Positions of the joints at TIMES in MuJoCo."""
    model = mujoco.MjModel.from_xml_string(text)
    model.opt.timestep = 1e-4
    data = mujoco.MjData(model)
    data.ctrl[:] = control
    rows = []
    for time in TIMES:
        while data.time < time - 0.5e-4:
            mujoco.mj_step(model, data)
        rows.append([data.joint(name).qpos[0] for name in JOINTS])
    return np.array(rows)


def found(program, folder, text, target):
    """The same here; an actuator has the name of its tendon."""
    scene, log = folder / "scene.toml", folder / "log.csv"
    (folder / "robot.xml").write_text(text, encoding="utf-8")
    words = SCENE.format(end=TIMES[-1] + 0.01)
    if "<actuator>" in text:
        words += f'[[events]]\ntime = 0\nset = ["a.t.joint_target=[{target}]"]\n'
    scene.write_text(words, encoding="utf-8")
    logged = [word for name in JOINTS for word in ("--log", f"a.{name}.joint_position")]
    done = subprocess.run([program, "run", str(scene), *logged, "--out", str(log)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stderr)
    if "does not act" in done.stdout + done.stderr:
        sys.exit(f"something does not act: {done.stdout}{done.stderr}")
    rows = list(csv.reader(log.read_text(encoding="utf-8").splitlines()))[1:]
    table = np.array([[float(cell) for cell in row] for row in rows])
    return np.array([np.interp(TIMES, table[:, 0], table[:, 1 + k]) for k in range(len(JOINTS))]).T


def compare_conversion(program, folder, name, text, control, worst):
    """What is written moves in MuJoCo as the file does; its control is the target here."""
    source, out = folder / "source.xml", folder / "converted.xml"
    source.write_text(text, encoding="utf-8")
    done = subprocess.run([program, "convert", str(source), "--out", str(out), "--force"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stderr)
    written = mujoco.MjModel.from_xml_path(str(out))
    read = mujoco.MjModel.from_xml_string(text)
    read.tendon_solref_lim[:] = written.tendon_solref_lim
    if read.ntendon != written.ntendon:
        sys.exit(f"{name}: {written.ntendon} tendons are written, not {read.ntendon}")
    lengths = []
    for model in (read, written):
        data = mujoco.MjData(model)
        for k, joint in enumerate(JOINTS):
            data.joint(joint).qpos[0] = 0.1 + 0.2 * k
            data.joint(joint).qvel[0] = 0.3 - 0.2 * k
        mujoco.mj_forward(model, data)
        lengths.append(np.concatenate([data.ten_length, data.ten_velocity, data.qfrc_passive[:3]]))
    worst.note("converted", name, float(np.max(np.abs(lengths[0] - lengths[1]))))


def main(program):
    worst = Worst(TOLERANCES)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for case, parts in CASES.items():
            parts = dict(parts)
            control = parts.pop("control", 0)
            text = text_of(parts)
            target = control / (2 if 'gear="2"' in text else 1)
            here, there = found(program, folder, text, target), expected(text, control)
            for time, ours, theirs in zip(TIMES, here, there, strict=True):
                for joint, x, y in zip(JOINTS, ours, theirs, strict=True):
                    worst.note("joint position", f"{case}, {joint} at {time} s: {x:.4f}, not {y:.4f}", abs(x - y))
            compare_conversion(program, folder, case, text, control, worst)
    return worst.report()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))

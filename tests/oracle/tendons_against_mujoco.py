#!/usr/bin/env python3
"""Compares robots with tendons over several joints, through sites and around geoms, and tied to each other, with MuJoCo: where
their joints are after a while, and what `murosimf convert` writes of them.

Usage: tendons_against_mujoco.py <murosimf>
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

# Steps of 1 ms here and of 0.1 ms there; joints swing by 1 rad in 0.1 s, so a millisecond is 10 mrad at the worst. Limits and
# friction of MuJoCo give way by some of a mrad themselves.
TOLERANCES = {"joint position": 0.012, "converted": 1e-9}
TIMES = [0.05, 0.2, 0.5, 1.0]  # [s]
JOINTS = ["i", "j", "s"]

# Two pendulums beside each other, the second with a slide along it; a drum beside the first one, a ball on the second.
ROBOT = """<mujoco><compiler angle="radian"/><default><geom contype="0" conaffinity="0"/></default><worldbody>
<body name="b" pos="0 0 1"><geom size=".1"/><site name="p" pos=".15 .3 .1"/><site name="q" pos=".02 0 .2"/>
<geom name="drum" type="cylinder" size=".06 .1" pos=".02 .32 .01" euler="1.4 .2 0"/>
<site name="behind" pos="-.3 .3 .03"/>
<body name="l" pos="0 .3 0"><joint name="i" axis="0 1 0" damping=".02" {i}/><site name="r" pos=".12 .02 -.1"/>
<inertial pos=".1 0 -.2" mass="1" diaginertia=".02 .02 .02"/></body>
<body name="m" pos="0 -.3 0"><joint name="j" axis="0 1 0" damping=".02" {j}/><site name="u" pos="-.06 .05 -.2"/>
<inertial pos="-.05 0 -.15" mass=".7" diaginertia=".01 .01 .01"/>
<geom name="ball" size=".05" pos="-.03 .03 -.03"/><site name="middle" pos="-.03 .04 -.03"/>
<body name="n"><joint name="s" type="slide" axis="0 0 1" damping="3" stiffness="80"/><site name="v" pos=".02 .03 -.12"/>
<inertial pos="0 0 -.1" mass=".3" diaginertia=".001 .001 .001"/></body></body></body></worldbody>
<tendon><{kind} name="t" {tendon}>{parts}</{kind}>{more}</tendon>{after}</mujoco>"""

TWO = '<joint joint="i" coef="1.5"/><joint joint="j" coef="-.8"/>'
THREE = TWO + '<joint joint="s" coef="4"/>'
CHAIN = '<joint joint="j" coef="-.8"/><joint joint="s" coef="4"/>'  # rotors of others are no part of MuJoCo's sparse inertia
OTHER = '<fixed name="u"><joint joint="i" coef="1"/></fixed>'
HARD = 'solreflimit=".002 1" solreffriction=".002 1"'


def tie(ends, polynomial):
    return f'<equality><tendon {ends} polycoef="{polynomial}" solref=".002 1"/></equality>'


# name: tendon, parts, joints i and j, other tendons, sections, control and target of the actuator;
# of a string its path: sites, pulleys, geoms with their side
CASES = {
    "spring": {"tendon": 'stiffness="6"', "i": 'ref=".4"'},
    "spring at rest elsewhere": {"tendon": 'stiffness="6" springlength=".5"'},
    "spring slack where the joints' springs are": {"tendon": 'stiffness="6"', "i": 'springref=".5"', "j": 'springref="-.3"'},
    "spring and damper": {"tendon": 'stiffness="6" damping=".4"', "parts": THREE},
    "spring with a dead band": {"tendon": 'stiffness="20" springlength="0 .3"'},
    "damper": {"tendon": 'damping="2"'},
    "rotor": {"tendon": 'armature=".03"', "parts": CHAIN},
    "friction": {"tendon": f'frictionloss=".6" {HARD}'},
    "limit": {"tendon": f'range="-.1 .3" {HARD}', "i": 'ref=".1"'},
    "two tendons": {"tendon": 'stiffness="6"', "more": '<fixed name="u" damping=".5" stiffness="3">'
                    '<joint joint="i" coef="1"/><joint joint="j" coef="1"/></fixed>'},
    "actuator": {"after": '<actuator><position name="a" tendon="t" kp="12" kv="1"/></actuator>', "control": 0.6},
    "actuator with gear and force": {"parts": THREE, "control": -0.5, "after":
                                     '<actuator><position tendon="t" kp="12" kv="1" gear="2" forcerange="-1 1.5"/></actuator>'},
    "one tendon at its length": {"after": tie('tendon1="t"', "0"), "i": 'ref=".1"'},
    "two tendons, one as long as the other": {"parts": CHAIN, "more": OTHER, "after": tie('tendon1="t" tendon2="u"', "0 .7")},
    "two tendons by a curve": {"parts": CHAIN, "more": OTHER, "after": tie('tendon1="t" tendon2="u"', "0 .4 -.5 .2 .1")},
    "one joint's tendon and another one": {"parts": '<joint joint="i" coef="1.5"/>', "more": OTHER,
                                           "after": tie('tendon1="u" tendon2="t"', "0 -.5")},
    "string": {"tendon": 'stiffness="60" springlength=".4"', "path": ["r", "u"]},
    "string, slack in the pose of the file": {"tendon": 'stiffness="60"', "path": ["r", "v"], "i": 'ref=".4"'},
    "string, slack where the joints' springs are": {"tendon": 'stiffness="60"', "path": ["r", "q", "v"],
                                                    "i": 'springref=".5"', "j": 'springref="-.3"'},
    "string that hangs loose": {"tendon": 'stiffness="400" springlength="0 .68"', "path": ["r", "v"]},
    "string with pulley": {"tendon": 'stiffness="90" damping="5" springlength=".3"', "path": ["p", "r", 2, "r", "q", "v"]},
    "string with friction": {"tendon": f'frictionloss="3" {HARD}', "path": ["p", "r", "v"]},
    "string that ends": {"tendon": f'range="0 .65" {HARD}', "path": ["r", "v"]},
    "string with a rotor": {"tendon": 'armature="2"', "path": ["q", "v"]},
    "string over a drum": {"tendon": 'stiffness="60" springlength=".1"', "path": ["p", ("drum", ""), "r"]},
    "string behind a drum": {"tendon": 'stiffness="60" springlength=".1"', "path": ["p", ("drum", "behind"), "r"]},
    "string over a ball": {"tendon": 'stiffness="60" springlength=".1"', "path": ["q", ("ball", ""), "u", "r"]},
    "string through a ring": {"tendon": 'stiffness="60" springlength=".1"', "path": ["q", ("ball", "middle"), "u"]},
    "string with an actuator": {"path": ["p", ("drum", ""), "r", "v"], "control": 0.6, "after":
                                '<actuator><position tendon="t" kp="150" kv="8" forcerange="-40 40"/></actuator>'},
    "string and joints": {"path": ["p", "r"], "more": OTHER, "after": tie('tendon1="t" tendon2="u"', "0 .1")},
    "one joint that does not begin at zero": {"tendon": 'stiffness="6"', "i": 'ref=".4"',
                                              "parts": '<joint joint="i" coef="1.5"/>'},
}


def element(part):
    if isinstance(part, int):
        return f'<pulley divisor="{part}"/>'
    if isinstance(part, str):
        return f'<site site="{part}"/>'
    geom, side = part
    return f'<geom geom="{geom}"' + (f' sidesite="{side}"/>' if side else "/>")


def text_of(case):
    words = {"i": "", "j": "", "tendon": "", "kind": "fixed", "parts": TWO, "more": "", "after": ""} | case
    if "path" in case:
        words |= {"kind": "spatial", "parts": "".join(element(part) for part in case["path"])}
    return ROBOT.format(**words)


def compare_conversion(program, folder, name, text, control, worst):
    """What is written moves in MuJoCo as the file does; its control is the target here."""
    source, out = folder / "source.xml", folder / "converted.xml"
    source.write_text(text, encoding="utf-8")
    joint_motion.convert(program, source, out)
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
            # an actuator has the name of its tendon
            target = f"a.t.joint_target=[{control / (2 if 'gear' in text else 1)}]" if "<actuator>" in text else None
            here = joint_motion.here(program, folder, text, JOINTS, TIMES, target=target)
            there = joint_motion.in_mujoco(text, JOINTS, TIMES, control)
            for time, ours, theirs in zip(TIMES, here, there, strict=True):
                for joint, x, y in zip(JOINTS, ours, theirs, strict=True):
                    worst.note("joint position", f"{case}, {joint} at {time} s: {x:.4f}, not {y:.4f}", abs(x - y))
            compare_conversion(program, folder, case, text, control, worst)
    return worst.report()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))

#!/usr/bin/env python3
"""Compares what words of MJCF files do here with what they do in MuJoCo: control ranges, forces, filters, references and
keys, by where a joint is after a while; copies and attached models, by masses and places of what `murosimf convert` writes.

Usage: mjcf_words_against_mujoco.py <murosimf>
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

# [rad] Steps of 1 ms here and of 0.1 ms there; joints swing by 1 rad in 0.1 s, so a millisecond is 10 mrad at the worst.
TOLERANCES = {"joint position": 0.012, "mass": 1e-9, "place": 1e-9, "spring": 1e-6, "damper": 1e-6, "length": 1e-9}
TIMES = [0.05, 0.2, 1.0]  # [s]

ARM = """<mujoco><compiler angle="radian"/>{before}<worldbody><body name="b" pos="0 0 1">{free}<geom size=".1"/>
<body name="l" pos="0 0 .3"><joint name="j" axis="0 1 0" damping=".05" {joint}/><inertial pos="0 0 -.1" mass="1"
diaginertia=".02 .02 .02"/></body></body></worldbody>{after}</mujoco>"""


def actuator(words):
    return f"<actuator>{words}</actuator>"


WIDE = "range='-2 2'"
PD = "joint='j' kp='30' kv='3'"
# name: attributes of the joint, sections, control in MuJoCo, target here (None: none is set)
CASES = {
    "ctrlrange": (WIDE, actuator(f"<position {PD} ctrlrange='-.2 .3'/>"), 0.9, 0.9),
    "ctrlrange below": (WIDE, actuator(f"<position {PD} ctrlrange='-.2 .3'/>"), -0.9, -0.9),
    "gear": (WIDE, actuator("<position joint='j' kp='10' kv='1' ctrlrange='-.2 .6' gear='-2'/>"), 0.9, -0.45),
    "inheritrange": ("range='-.5 .3'", actuator(f"<position {PD} inheritrange='.5'/>"), 0.9, 0.9),
    "inheritrange of an integral": ("range='-.5 .3'", actuator(f"<intvelocity {PD} inheritrange='.5' ctrlrange='-9 9'/>"), 9,
                                    0.9),
    "affine": (WIDE, actuator("<general joint='j' gainprm='60' biastype='affine' biasprm='3 -30 -3' ctrlrange='-1 .2'/>"),
               0.9, (60 * 0.9 + 3) / 30),
    "rate": ("", actuator("<velocity joint='j' kv='5' ctrlrange='-1 .5'/>"), 3, 3),
    "force": (WIDE, actuator(f"<position {PD} forcerange='-.4 .6'/>"), 1.2, 1.2),
    "force of joint": (f"{WIDE} actuatorfrcrange='-.4 .6'", actuator(f"<position {PD}/>"), -1.2, -1.2),
    "filter": (WIDE, actuator(f"<position {PD} timeconst='.2'/>"), 0.8, 0.8),
    "damping ratio": (WIDE, actuator("<position joint='j' kp='30' dampratio='1'/>"), 0.8, 0.8),
    "tendon": ("", "<tendon><fixed name='t' stiffness='4' damping='.3' springlength='.2' armature='.002'>"
               "<joint joint='j' coef='2'/></fixed></tendon>"
               + actuator("<position tendon='t' kp='8' kv='.6' forcerange='-3 3'/>"), 0.8, 0.4),
    "reference": ("range='.2 2' ref='.8'", actuator(f"<position {PD}/>"), 0.8, None),
    "reference and spring": ("ref='.8' springref='-.3' stiffness='6'", actuator("<motor joint='j'/>"), 0, None),
    "key": (WIDE, actuator(f"<position {PD}/>") + "<keyframe><key name='k' qpos='{base}.7' ctrl='-.4'/></keyframe>", None, None),
}
def found(program, folder, text, target):
    """Positions at TIMES here, with a base that the scene bolts to the world if it has a free joint, else by the file itself."""
    keys = "fixed_base = true\n" if "<freejoint/>" in text else ""
    if "<key " in text:
        keys += 'keyframe = "k"\n'
    wanted = "joint_velocity_target" if "<velocity" in text else "joint_target"
    setting = None if target is None else f"a.j.{wanted}=[{target}]"
    return joint_motion.here(program, folder, text, ["j"], TIMES, keys, setting)[:, 0]


def compare_motion(program, folder, worst):
    """Where the joint is."""
    for case, (joint, sections, control, target) in CASES.items():
        theirs = ARM.format(before="", free="", joint=joint, after=sections.replace("{base}", ""))
        freed = ARM.format(before="", free="<freejoint/>", joint=joint, after=sections.replace("{base}", "0 0 1 1 0 0 0 "))
        there = joint_motion.in_mujoco(theirs, ["j"], TIMES, control)[:, 0]  # with a fixed base
        for kind, ours in (("bolted by the scene", freed), ("bolted by the file", theirs)):
            for time, x, y in zip(TIMES, found(program, folder, ours, target), there, strict=True):
                worst.note("joint position", f"{case}, {kind}, at {time} s: {x:.4f}, not {y:.4f}", abs(x - y))


COPIES = {
    "replicate": """<mujoco><worldbody><body name="b"><freejoint/><geom size=".1"/>
<replicate count="2" offset="0 1 0" euler="40 0 0"><replicate count="3" sep="-" offset="1 0 0" euler="0 50 0">
<body name="l" pos="0 0 .3"><joint name="j" axis="0 1 0"/><geom type="box" size=".1 .2 .3" pos=".1 0 0"/></body>
</replicate></replicate></body></worldbody></mujoco>""",
    "replicate with tendons": """<mujoco><worldbody><body name="b"><freejoint/><geom size=".1"/><site name="o"/>
<replicate count="3" offset="0 1 0" euler="40 0 0"><body name="l" pos="0 0 .3"><joint name="j" axis="0 1 0"/><geom size=".1"/>
<site name="e" pos=".2 0 0"/></body></replicate></body></worldbody><tendon><spatial name="t" stiffness="3"><site site="o"/>
<site site="e"/></spatial></tendon><actuator><motor name="m" tendon="t" forcerange="-1 1"/></actuator></mujoco>""",
    "attach": """<mujoco><compiler angle="radian"/><asset><model name="arm" file="arm.xml"/></asset><worldbody><body name="b">
<freejoint/><geom size=".1"/><frame pos="0 .1 0" euler="0 0 1"><attach model="arm" body="up" prefix="l_"/></frame>
<attach model="arm" body="up" prefix="r_"/></body></worldbody></mujoco>""",
    "bolted": """<mujoco><compiler inertiagrouprange="0 2"/><worldbody><frame pos="0 .5 0" euler="30 0 0">
<body name="stand" pos="0 0 1"><geom type="box" size=".1 .2 .3"/><body name="l" pos="0 0 .3"><joint name="j" axis="0 1 0"/>
<joint name="s" type="slide" axis="1 0 0"/><geom type="box" size=".1 .2 .3" pos=".1 0 0"/><geom size=".2" group="3"/></body>
</body></frame><body name="spinner" pos="1 0 0"><joint name="k" axis="0 0 1" springdamper=".2 .7"/>
<geom type="capsule" fromto="0 0 0 .3 0 .1" size=".02"/><body name="m" pos=".3 0 0">
<joint name="n" axis="0 0 1" springdamper=".1 1"/><geom size=".05"/></body></body></worldbody></mujoco>""",
    "frame": """<mujoco><worldbody><body name="b"><freejoint/><geom size=".1"/><frame euler="0 0 90"><body name="l">
<frame pos="1 0 0" euler="0 0 90"><joint name="j" axis="1 0 0" pos="0 0 1"/><geom type="box" size=".1 .2 .3"/></frame>
</body></frame></body></worldbody></mujoco>""",
}
ATTACHED = """<mujoco><compiler angle="degree"/><default><geom density="500"/></default><worldbody>
<body name="up" pos="0 0 1" euler="0 30 0"><joint name="j" axis="0 1 0" range="-90 90"/><geom size=".1"/>
<body name="low" pos="0 0 -.2" euler="0 0 45"><joint name="k" axis="1 0 0"/><geom type="box" size=".05 .1 .2" pos=".1 0 0"/>
<site name="e" pos="0 .2 -.3"/></body><geom name="ball" size=".1" pos="0 .1 -.2"/><site name="s" pos=".2 0 0"/></body></worldbody>
<tendon><spatial name="t" stiffness="3"><site site="s"/><geom geom="ball" sidesite="s"/><site site="e"/></spatial>
<fixed name="u"><joint joint="j" coef="1"/><joint joint="k" coef="2"/></fixed></tendon>
<equality><tendon tendon1="t" tendon2="u"/></equality></mujoco>"""


def joint_names(model):
    return [model.joint(i).name for i in range(model.njnt) if model.jnt_type[i] != mujoco.mjtJoint.mjJNT_FREE]


def compare_tendons(case, theirs, ours, worst):
    """Their names, lengths and equalities; of pairs of a model and its state."""
    (one, there), (other, here) = theirs, ours
    if (one.ntendon, one.neq, one.nu) != (other.ntendon, other.neq, other.nu):
        sys.exit(f"{case}: {other.ntendon} tendons, {other.neq} equalities, {other.nu} actuators; "
                 f"not {one.ntendon}, {one.neq}, {one.nu}")
    for i in range(one.ntendon):
        name = one.tendon(i).name
        worst.note("length", f"{case} {name}", abs(there.ten_length[i] - here.ten_length[other.tendon(name).id]))


def compare_copies(program, folder, worst):
    """Masses and places of bodies with turned joints, of the file and of what is made of it."""
    (folder / "arm.xml").write_text(ATTACHED, encoding="utf-8")
    for case, text in COPIES.items():
        source, out = folder / f"{case}.xml", folder / f"{case}_converted.xml"
        source.write_text(text, encoding="utf-8")
        joint_motion.convert(program, source, out)
        theirs, ours = (mujoco.MjModel.from_xml_path(str(file)) for file in (source, out))
        if joint_names(theirs) != joint_names(ours):
            sys.exit(f"{case}: the joints are others: {joint_names(ours)}, not {joint_names(theirs)}")
        there, here = mujoco.MjData(theirs), mujoco.MjData(ours)
        for model, state in ((theirs, there), (ours, here)):
            first = model.jnt_qposadr[0] + 7 if model.jnt_type[0] == mujoco.mjtJoint.mjJNT_FREE else 0
            state.qpos[first:] = [0.3 * (i + 1) for i in range(model.nq - first)]
            mujoco.mj_forward(model, state)
        worst.note("mass", case, abs(theirs.body_subtreemass[0] - ours.body_subtreemass[0]))
        worst.note("spring", case, np.max(np.abs(theirs.jnt_stiffness - ours.jnt_stiffness), initial=0))
        worst.note("damper", case, np.max(np.abs(theirs.dof_damping - ours.dof_damping), initial=0))
        compare_tendons(case, (theirs, there), (ours, here), worst)
        free = theirs.jnt_type[0] == mujoco.mjtJoint.mjJNT_FREE  # then it is placed by scenes
        origins = [state.xpos[1] if free else np.zeros(3) for state in (there, here)]
        for i in range(1, theirs.nbody):
            name = theirs.body(i).name
            if name == "stand":
                continue  # a part of the fixed base there
            k = ours.body(name).id
            apart = (there.xipos[i] - origins[0]) - (here.xipos[k] - origins[1])
            worst.note("place", f"{case} {name}", np.max(np.abs(apart)))


def main(program):
    worst = Worst(TOLERANCES)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        compare_motion(program, folder, worst)
        compare_copies(program, folder, worst)
    return worst.report()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))

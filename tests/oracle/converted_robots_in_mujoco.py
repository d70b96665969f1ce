#!/usr/bin/env python3
"""Loads converted robots in MuJoCo and compares them with what MuJoCo makes of the files they were made from.

MJCF files: ranges, dampings and dry friction of joints, number of actuators, total mass, and inertia and center of mass
of every body in random joint positions. URDF files: their total mass, summed in the file. With meshes as they are and
fitted.

Usage: converted_robots_in_mujoco.py <murosimf> <folder of models> <folder of data>
Exit: 0 all agree, 1 some differ, 77 MuJoCo is not installed (test is skipped).
"""
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

try:
    import mujoco
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; pip install mujoco")
    sys.exit(77)

from comparison import Worst

STATES = 20
OWN = ["kid21", "quadruped", "car", "spark_nao0", "spark_nao4", "booster_k1"]
TEAMS = ["booster_k1/K1_22dof.urdf", "booster_k1/K1_22dof.xml", "wolfgang_op/wolfgang_description/urdf/robot.urdf"]
TOLERANCES = {
    "total mass": 1e-9,  # [kg]
    "joint numbers": 1e-9,  # [1] ranges, dampings, friction, armature
    "center": 1e-9,  # [m] of mass of a body
    "inertia": 1e-7,  # [kg m^2] trace; MuJoCo finds principal axes to about 1e-8
}


def convert(program, source, folder, fit):
    out = Path(folder) / f"{source.stem}{'_' + fit if fit else ''}{source.suffix.replace('.', '_')}.xml"
    command = [program, "convert", str(source), "--out", str(out), "--force"] + (["--fit", fit] if fit else [])
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{source}: {done.stderr}")
    return mujoco.MjModel.from_xml_path(str(out))


def names(model, kind, count):
    return {mujoco.mj_id2name(model, kind, i): i for i in range(count) if mujoco.mj_id2name(model, kind, i)}


def compare_joints(worst, found, expected):
    mine, theirs = (names(m, mujoco.mjtObj.mjOBJ_JOINT, m.njnt) for m in (found, expected))
    for name, j in theirs.items():
        i = mine[name]
        a, b = found.jnt_dofadr[i], expected.jnt_dofadr[j]
        if found.jnt_limited[i] != expected.jnt_limited[j]:
            sys.exit(f"joint {name}: one has a range, the other has none")
        pairs = [(found.jnt_range[i], expected.jnt_range[j])]
        for key in ("dof_damping", "dof_frictionloss", "dof_armature"):
            pairs.append((getattr(found, key)[a], getattr(expected, key)[b]))
        for x, y in pairs:
            worst.note("joint numbers", name, np.max(np.abs(np.asarray(x) - y)))


def random_positions(random, found, expected):
    """The same position of every joint in both models."""
    states = [mujoco.MjData(m) for m in (found, expected)]
    for j in range(expected.njnt):
        name = mujoco.mj_id2name(expected, mujoco.mjtObj.mjOBJ_JOINT, j)
        free = expected.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE
        i = [k for k in range(found.njnt) if found.jnt_type[k] == expected.jnt_type[j]][0] if free else \
            mujoco.mj_name2id(found, mujoco.mjtObj.mjOBJ_JOINT, name)
        value = np.array([0, 0, 1, 1, 0, 0, 0]) if free else random.uniform(-1, 1, 1)
        for model, data, k in ((found, states[0], i), (expected, states[1], j)):
            data.qpos[model.jnt_qposadr[k]:model.jnt_qposadr[k] + len(value)] = value
    for model, data in zip((found, expected), states, strict=True):
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
    return states


def compare_bodies(worst, found, expected, random):
    mine, theirs = (names(m, mujoco.mjtObj.mjOBJ_BODY, m.nbody) for m in (found, expected))
    for _ in range(STATES):
        a, b = random_positions(random, found, expected)
        for name, j in theirs.items():
            if name != "world" and expected.body_mass[j] > 0:
                worst.note("center", name, np.max(np.abs(a.xipos[mine[name]] - b.xipos[j])))
                worst.note("inertia", name, abs(found.body_inertia[mine[name]].sum() - expected.body_inertia[j].sum()))


def urdf_mass(path):
    return sum(float(mass.get("value")) for mass in xml.parse(path).getroot().iter("mass"))


def check(worst, program, source, folder, random):
    for fit in ("", "best", "capsule"):
        found = convert(program, source, folder, fit)
        if source.suffix == ".urdf":
            worst.note("total mass", source.name, abs(found.body_mass.sum() - urdf_mass(source)))
            continue
        expected = mujoco.MjModel.from_xml_path(str(source))
        worst.note("total mass", source.name, abs(found.body_mass.sum() - expected.body_mass.sum()))
        if found.nu != expected.nu:
            sys.exit(f"{source}: {found.nu} actuators, not {expected.nu}")
        compare_joints(worst, found, expected)
        compare_bodies(worst, found, expected, random)


def main():
    program, models, data = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    sources = [models / f"{name}.xml" for name in OWN] + [data / "robots" / name for name in TEAMS]
    sources = [path for path in sources if path.exists()]
    worst, random = Worst(TOLERANCES), np.random.default_rng(1)
    with tempfile.TemporaryDirectory() as folder:
        for source in sources:
            check(worst, program, source, folder, random)
            print(f"{source.name}: loads in MuJoCo, as it is and fitted")
    return worst.report()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Compares robot files of teams, as they are read here, with what MuJoCo makes of the same files.

Total mass; mass, center and inertia of every body with all that is welded to it; axes and ranges of joints; poses of
all bodies and links in 1,000 random joint positions, the first all zero; the common center of mass. K1 is there as URDF
and as MJCF: what both files say is compared here, too. MuJoCo reads URDF files without meshes, which have no mass
there.

Usage: robots_against_mujoco.py <dump_robot> <folder of robots>
Exit: 0 all agree, 1 some differ, 77 MuJoCo or the files are not there (test is skipped).
"""
import os
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

try:
    import mujoco
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; pip install mujoco")
    sys.exit(77)

from comparison import Worst, run

STATES = 1000
FILES = ["booster_k1/K1_22dof.urdf", "wolfgang_op/wolfgang_description/urdf/robot.urdf", "booster_k1/K1_22dof.xml"]
TOLERANCES = {
    "total mass": 1e-6,  # [kg]
    "mass": 1e-6,  # [kg] of a body
    "center": 1e-6,  # [m]
    "inertia": 1e-6,  # [1] of the largest component
    "axis": 1e-6,  # [1]
    "range": 1e-6,  # [rad]
    "position": 1e-6,  # [m]
    "orientation": 1e-6,  # [1]
    "center of mass": 1e-6,  # [m]
    # the two files of K1 are rounded for themselves: 5e-7 in each angle, along chains of up to 7 bodies
    "K1 files: mass": 1e-6,
    "K1 files: axis": 1e-6,
    "K1 files: range": 1e-6,
    "K1 files: position": 1e-5,
    "K1 files: orientation": 1e-5,
    "K1 files: center": 1e-6,
    "K1 files: inertia": 1e-5,  # [1] of the largest component; one file has it in body axes, one in principal ones
}


def urdf_for_mujoco(path, fuse):
    """The text of a URDF file without meshes. With `fuse`, its root floats and what is fixed is part of what moves."""
    robot = xml.parse(path).getroot()
    for link in robot.findall("link"):
        for part in link.findall("visual") + link.findall("collision"):
            if part.find("geometry/mesh") is not None:
                link.remove(part)
    options = {"fusestatic": "true" if fuse else "false", "balanceinertia": "false"}
    xml.SubElement(xml.SubElement(robot, "mujoco"), "compiler", options)
    if fuse:
        add_floating_joint(robot)
    return xml.tostring(robot).decode()


def add_floating_joint(robot):
    children = {joint.find("child").get("link") for joint in robot.findall("joint")}
    root = next(link.get("name") for link in robot.findall("link") if link.get("name") not in children)
    xml.SubElement(robot, "link", {"name": "the_world"})
    joint = xml.SubElement(robot, "joint", {"name": "the_root", "type": "floating"})
    xml.SubElement(joint, "parent", {"link": "the_world"})
    xml.SubElement(joint, "child", {"link": root})


def load(path, fuse):
    if path.suffix == ".xml":
        return mujoco.MjModel.from_xml_path(str(path))
    return mujoco.MjModel.from_xml_string(urdf_for_mujoco(path, fuse))


def matrix(quaternion):
    flat = np.zeros(9)
    mujoco.mju_quat2Mat(flat, quaternion)
    return flat.reshape(3, 3)


def symmetric(six):
    xx, yy, zz, xy, xz, yz = six
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def compare_bodies(worst, name, model, ours):
    """Bodies that move, of a model whose fixed bodies are fused."""
    if model.nbody - 1 != len(ours["bodies"]):
        sys.exit(f"{name}: {len(ours['bodies'])} bodies here, {model.nbody - 1} in MuJoCo")
    worst.note("total mass", name, abs(model.body_subtreemass[0] - ours["total_mass"]))
    for body, solid in ours["bodies"].items():
        theirs = model.body(body)
        case = f"{name}, {body}"
        axes = matrix(theirs.iquat)
        worst.note("mass", case, abs(theirs.mass[0] - solid["mass"]))
        worst.note("center", case, np.abs(theirs.ipos - solid["center"]).max())
        worst.add("inertia", case, symmetric(solid["inertia"]), axes @ np.diag(theirs.inertia) @ axes.T)


def compare_joints(worst, name, model, ours):
    count = np.count_nonzero(model.jnt_type != mujoco.mjtJoint.mjJNT_FREE)
    if count != len(ours["joints"]):
        sys.exit(f"{name}: {len(ours['joints'])} joints here, {count} in MuJoCo")
    for joint, said in ours["joints"].items():
        theirs = model.joint(joint)
        case = f"{name}, {joint}"
        worst.note("axis", case, np.abs(theirs.axis - np.array(said["axis"]) / np.linalg.norm(said["axis"])).max())
        limited = bool(model.jnt_limited[theirs.id])
        if limited != (said["range"] is not None):
            sys.exit(f"{case}: limited is {limited} in MuJoCo, its range is {said['range']} here")
        if limited:
            worst.note("range", case, np.abs(theirs.range - said["range"]).max())


def compare_state(worst, case, model, data, state):
    if model.jnt_type[0] == mujoco.mjtJoint.mjJNT_FREE:
        data.qpos[:7] = [0, 0, 0, 1, 0, 0, 0]
    for joint, value in state["q"].items():
        data.qpos[model.joint(joint).qposadr[0]] = value
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    for frame, (position, orientation) in state["frames"].items():
        body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, frame)
        site = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, frame)
        if body < 0 and site < 0:
            sys.exit(f"{case}: MuJoCo knows no body or site '{frame}'")
        there = (data.xpos[body], data.xmat[body]) if body >= 0 else (data.site_xpos[site], data.site_xmat[site])
        worst.note("position", f"{case}, {frame}", np.abs(there[0] - position).max())
        worst.note("orientation", f"{case}, {frame}", np.abs(there[1] - np.ravel(orientation)).max())
    worst.note("center of mass", case, np.abs(data.subtree_com[0] - state["center_of_mass"]).max())


def compare_files(worst, urdf, mjcf):
    """What K1's URDF and its MJCF file both say, as read here."""
    if urdf["joints"].keys() != mjcf["joints"].keys() or urdf["bodies"].keys() != mjcf["bodies"].keys():
        sys.exit("the two files of K1 have different joints or bodies")
    for name, solid in urdf["bodies"].items():
        worst.note("K1 files: mass", name, abs(solid["mass"] - mjcf["bodies"][name]["mass"]))
        other = mjcf["bodies"][name]
        worst.note("K1 files: center", name, np.abs(np.subtract(solid["center"], other["center"])).max())
        worst.add("K1 files: inertia", name, solid["inertia"], other["inertia"])
    for name, joint in urdf["joints"].items():
        other = mjcf["joints"][name]
        worst.note("K1 files: axis", name, np.abs(np.subtract(joint["axis"], other["axis"])).max())
        worst.note("K1 files: range", name, np.abs(np.subtract(joint["range"], other["range"])).max())
    for name in urdf["bodies"]:
        for what, ours, others in zip(("position", "orientation"), urdf["states"][0]["frames"][name],
                                      mjcf["states"][0]["frames"][name], strict=True):
            worst.note(f"K1 files: {what}", name, np.abs(np.subtract(ours, others)).max())


def main():
    folder = Path(os.environ.get("MUROSIMF_TEST_DATA", sys.argv[2])) / "robots"
    if not folder.is_dir():
        print(f"skipped: no robots in {folder}; MUROSIMF_TEST_DATA names another folder")
        return 77
    worst = Worst(TOLERANCES)
    dumps = {}
    for name in FILES:
        ours = dumps[name] = run(sys.argv[1], folder / name, STATES)
        compare_bodies(worst, name, load(folder / name, True), ours)
        model = load(folder / name, False)
        compare_joints(worst, name, model, ours)
        data = mujoco.MjData(model)
        for number, state in enumerate(ours["states"]):
            compare_state(worst, f"{name}, state {number}", model, data, state)
    compare_files(worst, dumps[FILES[0]], dumps[FILES[2]])
    return worst.report()


if __name__ == "__main__":
    sys.exit(main())

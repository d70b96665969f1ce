"""What MuJoCo and Pinocchio find in a robot file: masses and joints, to be compared with ours."""

import collections

try:
    import mujoco
except ImportError:
    mujoco = None
try:
    import pinocchio
except ImportError:
    pinocchio = None


def of_mjcf(file, base):
    """{mass_kg, joints} of the tree of body `base` ("": the one of most joints) by MuJoCo; None without it; joints 0: no robot.
    A ball joint counts as the three hinges that it becomes here, a free joint of the base not at all."""
    if mujoco is None:
        return None
    try:
        model = mujoco.MjModel.from_xml_path(str(file))
    except ValueError as error:
        return {"refused": str(error).splitlines()[0]}
    counts = {int(mujoco.mjtJoint.mjJNT_FREE): 0, int(mujoco.mjtJoint.mjJNT_BALL): 3}
    joints = collections.Counter()
    for joint in range(model.njnt):
        joints[int(model.body_rootid[model.jnt_bodyid[joint]])] += counts.get(int(model.jnt_type[joint]), 1)
    body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, base) if base else -1
    root = int(model.body_rootid[body]) if body > 0 else max(joints, key=joints.get, default=0)
    return {"mass_kg": float(model.body_subtreemass[root]), "joints": joints[root]}


def of_urdf(file):
    """The same by Pinocchio, with all that its joints carry; the base is free."""
    if pinocchio is None:
        return None
    try:
        model = pinocchio.buildModelFromUrdf(str(file), pinocchio.JointModelFreeFlyer())
    except Exception as error:  # noqa: BLE001, whatever its parser throws
        return {"refused": str(error).splitlines()[0]}
    return {"mass_kg": float(sum(inertia.mass for inertia in model.inertias)), "joints": model.njoints - 2}


def of(kind, file, base):
    return of_mjcf(file, base) if kind == "mjcf" else of_urdf(file)


def runs_in_mujoco(file):
    """"" if MuJoCo reads and steps this file and has actuators, else what is wrong; None without MuJoCo."""
    if mujoco is None:
        return None
    try:
        model = mujoco.MjModel.from_xml_path(str(file))
    except ValueError as error:
        return str(error).splitlines()[0]
    data = mujoco.MjData(model)
    for _ in range(200):
        mujoco.mj_step(model, data)
    if any(warning.number for warning in data.warning):
        return "a warning of its simulation"
    return "" if model.nu > 0 or model.njnt <= 1 else "no actuators"


def reads_in_pinocchio(file):
    if pinocchio is None:
        return None
    return of_urdf(file).get("refused", "")

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
    """{mass_kg, joints} of the tree of body `base` by MuJoCo; None without it; joints 0: no robot. "" is the tree of most joints,
    "world" all trees that neither float nor are moved by software. A ball joint counts as the three hinges that it becomes here,
    a free joint of the base not at all."""
    if mujoco is None:
        return None
    try:
        model = mujoco.MjModel.from_xml_path(str(file))
    except ValueError as error:
        return {"refused": str(error).splitlines()[0]}
    free, ball = int(mujoco.mjtJoint.mjJNT_FREE), int(mujoco.mjtJoint.mjJNT_BALL)
    joints = collections.Counter()
    floating = set()
    for joint in range(model.njnt):
        root, kind = int(model.body_rootid[model.jnt_bodyid[joint]]), int(model.jnt_type[joint])
        joints[root] += {free: 0, ball: 3}.get(kind, 1)
        floating |= {root} if kind == free else set()
    if base == "world":
        roots = [body for body in range(1, model.nbody) if model.body_parentid[body] == 0 and body not in floating
                 and model.body_mocapid[body] < 0]
    else:
        body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, base) if base else -1
        roots = [int(model.body_rootid[body])] if body > 0 else [max(joints, key=joints.get, default=0)]
    return {"mass_kg": float(sum(model.body_subtreemass[root] for root in roots)), "joints": sum(joints[root] for root in roots)}


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
    if kind == "sdf":  # Pinocchio's wheels are built without SDF
        return None
    return of_mjcf(file, base) if kind == "mjcf" else of_urdf(file)


def runs_in_mujoco(file, servos):
    """"" if MuJoCo reads and steps this file and has actuators for a robot with `servos` of them, else what is wrong; None
    without MuJoCo."""
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
    return "" if model.nu > 0 or servos == 0 else "no actuators"


def reads_in_pinocchio(file, _):
    if pinocchio is None:
        return None
    return of_urdf(file).get("refused", "")

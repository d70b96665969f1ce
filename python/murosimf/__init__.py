"""MuRoSimF: teams of humanoid robots at exchangeable levels of physical detail.

    import murosimf as ms

    s = ms.Scene("walk", set={"walker.level": "simplified_dynamics"})
    s.run(5.0)
    print(s["walker"].position)

Lengths are in meters, angles in radians, times in simulated seconds, forces in newtons; frames are right-handed, x forward, y
left, z up; quaternions have w first.
"""

from ._arguments import check_arguments
from ._core import version as _version
from .batch import Batch
from .contacts import RayHit
from .demo import demo
from .entity import Entity, Object, Objects, Pose, Velocity
from .errors import ArgumentError, Error, InputError, SetupError, SimulationError, StateError, UnknownName
from .experiment import Experiment
from .joints import Joint, JointArray, Joints
from .kinematics import Frames, Kinematics
from .page import Page
from .picture import Picture
from .recording import Recorder, Recording, Series
from .robot import Controller, Level, Robot
from .scene import Scene
from .sensors import ByName, Camera, Sensor
from .studies import check, compare, fit_servo, replay_servo, sweep
from .tables import columns, write_parquet

__version__: str = _version()

for _each in (Batch, Camera, Entity, Experiment, Kinematics, Object, Objects, Picture, Recorder, Recording, Robot, Scene,
              Sensor, ByName):
    check_arguments(_each)

__all__ = ["ArgumentError", "Batch", "Camera", "Controller", "Entity", "Error", "Experiment", "Frames", "InputError", "Joint",
           "JointArray", "Joints", "Kinematics", "Level", "Object", "Objects", "Page", "Picture", "Pose", "RayHit",
           "Recorder", "Recording", "Robot", "Scene", "Sensor", "Series", "SetupError", "SimulationError", "StateError",
           "UnknownName", "Velocity", "check", "columns", "compare", "demo", "fit_servo", "replay_servo", "sweep",
           "write_parquet"]

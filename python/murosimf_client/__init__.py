"""Control software of robots that MuRoSimF simulates, over TCP (docs/tcp.md), and supervision of runs (docs/supervise.md)."""

from .connection import SimulatorError
from .messages import CIRCLE, LINE, POINTS, POLYGON, SPHERE, TEXT, Shape
from .robot import Command, Cycle, Picture, Robot, RobotError, RobotInfo, Signal, TeamMessage
from .supervisor import RequestRefused, Supervisor

__all__ = ["CIRCLE", "LINE", "POINTS", "POLYGON", "SPHERE", "TEXT", "Command", "Cycle", "Picture", "RequestRefused", "Robot",
           "RobotError", "RobotInfo", "Shape", "Signal", "SimulatorError", "Supervisor", "TeamMessage"]

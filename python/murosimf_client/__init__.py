"""Control software of robots that MuRoSimF simulates, over TCP (docs/tcp.md)."""

from .robot import Command, Cycle, Robot, RobotError, RobotInfo, Signal

__all__ = ["Command", "Cycle", "Robot", "RobotError", "RobotInfo", "Signal"]

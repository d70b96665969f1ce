"""Tasks by name."""

from __future__ import annotations

from typing import Any

from ..errors import InputError
from .moves import GetUp, Kick
from .standing import PushRecovery, Stand
from .task import Task
from .walking import WalkVelocity

tasks: dict[str, type[Task]] = {task.__name__: task for task in (Stand, WalkVelocity, GetUp, Kick, PushRecovery)}


def make_task(name: str, settings: dict[str, Any]) -> Task:
    """Raises InputError."""
    if name not in tasks:
        raise InputError(f"unknown task '{name}'; known: {', '.join(tasks)}")
    return tasks[name](**settings)

"""The messages of murosimf/network/supervision.proto: what a supervisor sends as bytes, what the simulator sends as values."""

from dataclasses import dataclass, field

from .reader import EACH, message_reader, one_of, text
from .wire import doubles, field_bytes, field_double, field_varint, signed

VERSION = 1

STATUS, PAUSE, GO_ON, DESCRIBE, BRANCHES, SAVE, FINISH = 2, 3, 4, 10, 14, 15, 16


def hello(token, name):
    return field_bytes(1, field_varint(1, VERSION) + field_bytes(2, token) + field_bytes(3, name))


def plain(request):
    """One of those that say nothing else."""
    return field_bytes(request, b"")


def step(count):
    return field_bytes(5, field_varint(1, count))


def speed(factor):
    return field_bytes(6, field_double(1, factor))


def advance(duration):
    return field_bytes(7, field_varint(1, duration))


def change(changes):
    return field_bytes(8, b"".join(field_bytes(1, one) for one in changes))


def read(patterns):
    return field_bytes(9, b"".join(field_bytes(1, one) for one in patterns))


def events(first):
    return field_bytes(11, field_varint(1, first))


def reset(seed):
    return field_bytes(12, b"" if seed is None else field_varint(1, seed))


def seek(time, branch):
    return field_bytes(13, field_varint(1, time) + (b"" if branch is None else field_varint(2, branch)))


def run_until(end):
    return field_bytes(17, field_varint(1, end))


def load(content, last):
    return field_bytes(19, field_bytes(1, content) + field_varint(2, int(last)))


def load_scene(scene, overrides, seed, paused):
    content = field_bytes(1, scene.encode()) + b"".join(field_bytes(2, change.encode()) for change in overrides)
    content += b"" if seed is None else field_varint(3, seed)
    return field_bytes(20, content + field_varint(4, int(paused)))


def record(on):
    return field_bytes(18, field_varint(1, int(on)))


@dataclass
class Status:
    """Of the run, between two steps. Times are in nanoseconds of simulated time."""

    time: int = 0
    end: int = 0  # where it pauses by itself
    paused: bool = False
    speed: float = 0.0  # simulated seconds per wall second, wanted; 0: as fast as possible
    factor: float = 0.0  # the same, measured over the last second
    jumps: int = 0  # how often time has jumped: resets, seeks, loaded states
    branch: int = 0  # of the timeline
    first: int = 0  # where one can seek in the present branch, from
    last: int = 0  # to
    events: int = 0  # so far
    warnings: int = 0  # so far
    recorded: bool | None = None  # whether it is requested; None: it cannot be
    diagnostic: str = ""  # since the last jump: what will not go on as it was there before, and why; empty: everything will


@dataclass
class Welcome:
    scene: str = ""
    seed: int = 0
    tick: int = 0  # [ns] of a step
    status: Status = field(default_factory=Status)


@dataclass
class Refused:
    reason: str = ""


@dataclass
class Numbers:
    """All at the same instant."""

    time: int = 0  # [ns] of simulated time
    names: list[str] = field(default_factory=list)  # "blue1.imu.gyroscope.x [rad/s]"
    values: list[float] = field(default_factory=list)  # NaN: nothing there


@dataclass
class Entity:
    name: str = ""
    model: str = ""
    level: str = ""
    contact: str = ""
    controller: str = ""
    team: str = ""
    present: bool = False
    objects: list[str] = field(default_factory=list)


@dataclass
class Scene:
    entities: list[Entity] = field(default_factory=list)


@dataclass
class Event:
    time: int = 0  # [ns] of simulated time
    text: str = ""


@dataclass
class Events:
    events: list[Event] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)


@dataclass
class Branch:
    number: int = 0
    parent: int | None = None  # of which it went on; None: it began with a reset or a loaded state
    begin: int = 0  # [ns]
    end: int = 0  # [ns]
    commands: list[Event] = field(default_factory=list)  # of its own


@dataclass
class Branches:
    branches: list[Branch] = field(default_factory=list)


@dataclass
class SavedState:
    time: int = 0  # [ns] of simulated time
    content: bytes = b""  # for murosimf run --from


@dataclass
class Goodbye:
    pass


_STATUS = (Status, {1: ("time", signed), 2: ("end", signed), 3: ("paused", bool), 4: ("speed", float),
                    5: ("factor", float), 6: ("jumps", int), 7: ("branch", signed), 8: ("first", signed),
                    9: ("last", signed), 10: ("events", int), 11: ("warnings", int), 12: ("recorded", bool),
                    13: ("diagnostic", text)})
_entity = message_reader(Entity, {1: ("name", text), 2: ("model", text), 3: ("level", text), 4: ("contact", text),
                                  5: ("controller", text), 6: ("team", text), 7: ("present", bool),
                                  8: ("objects", text, EACH)})
_event = message_reader(Event, {1: ("time", signed), 2: ("text", text)})
_branch = message_reader(Branch, {1: ("number", signed), 2: ("parent", signed), 3: ("begin", signed),
                                  4: ("end", signed), 5: ("commands", _event, EACH)})

_READERS = {
    1: (Welcome, {1: ("scene", text), 2: ("seed", int), 3: ("tick", signed), 4: ("status", message_reader(*_STATUS))}),
    2: (Refused, {1: ("reason", text)}),
    3: _STATUS,
    4: (Numbers, {1: ("time", signed), 2: ("names", text, EACH), 3: ("values", doubles)}),
    5: (Scene, {1: ("entities", _entity, EACH)}),
    6: (Events, {1: ("events", _event, EACH), 2: ("warnings", text, EACH)}),
    7: (Branches, {1: ("branches", _branch, EACH)}),
    8: (SavedState, {1: ("time", signed), 2: ("content", bytes)}),
    9: (Goodbye, {}),
}


def from_simulator(content):
    """Throws WireError if it is no message of the simulator."""
    return one_of(_READERS, content)

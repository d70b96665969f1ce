"""The messages of murosimf/network/robot_protocol.proto: what a client sends as bytes, what the simulator sends as values."""

from dataclasses import dataclass, field

from .reader import EACH, message_reader, one_of, text
from .wire import doubles, field_bytes, field_double, field_doubles, field_varint, signed

VERSION = 1


def hello(robot, rate, software):
    inner = field_varint(1, VERSION) + field_bytes(2, robot) + field_double(3, rate) + field_bytes(4, software)
    return field_bytes(1, inner)


def ask_signal(name):
    return field_bytes(2, field_bytes(1, name))


def ask_command(name):
    return field_bytes(2, field_bytes(2, name))


def ask_messages():
    return field_bytes(2, field_varint(3, 1))


def ask_picture(name):
    return field_bytes(2, field_bytes(4, name))


def ready():
    return field_bytes(3, b"")


CIRCLE, LINE, POINTS, SPHERE, POLYGON, TEXT = range(6)


@dataclass
class Shape:
    """Something to be drawn for people who watch."""

    kind: int  # CIRCLE around the first point, LINE through all, POINTS: a dot at each, SPHERE, POLYGON: filled, TEXT
    points: list[tuple[float, float, float]]  # [m]
    size: float = 0.0  # [m] radius of circles and spheres, width of lines and dots, height of texts; 0: as small as can be seen
    color: tuple[float, ...] = (1.0, 1.0, 1.0)  # red, green, blue and, if given, opacity, from 0 to 1
    text: str = ""


def drawing(group, shapes, of_robot):
    inner = field_bytes(1, group) + (field_varint(2, 1) if of_robot else b"")
    for shape in shapes:
        one = field_varint(1, shape.kind) + field_doubles(2, [x for point in shape.points for x in point])
        one += field_double(3, shape.size) + field_doubles(4, shape.color) + field_bytes(5, shape.text)
        inner += field_bytes(3, one)
    return inner


def commands(cycle, rows, says, sends=(), draws=()):
    inner = field_varint(1, cycle)
    inner += b"".join(field_bytes(2, field_doubles(1, row)) for row in rows)
    inner += b"".join(field_bytes(3, line) for line in says)
    inner += b"".join(field_bytes(4, message) for message in sends)
    inner += b"".join(field_bytes(5, one) for one in draws)
    return field_bytes(4, inner)


@dataclass
class Welcome:
    robot: str = ""
    team: str = ""
    model: str = ""
    period: float = 0.0
    seed: int = 0
    lock_step: bool = False


@dataclass
class Refusal:
    reason: str = ""


@dataclass
class PictureFormat:
    width: int = 0  # [px]
    height: int = 0  # [px]
    format: str = ""  # of pixels: rgb8, bayer_rggb8, ..., 32FC1 [m], 16UC1
    period: float = 0.0  # [s] of simulated time from one picture to the next


@dataclass
class Description:
    labels: list[str] = field(default_factory=list)
    values: list[float] = field(default_factory=list)
    picture: PictureFormat = field(default_factory=PictureFormat)


@dataclass
class Sample:
    time: int = 0
    samples: int = 0
    values: list[float] = field(default_factory=list)


@dataclass
class TeamMessage:
    """What a robot of the team has sent."""

    content: bytes = b""
    sender: str = ""  # empty: it comes from outside of the simulation
    sent: int = 0  # [ns] of simulated time


@dataclass
class ComePicture:
    picture: int = 0
    time: int = 0
    number: int = 0
    content: bytes = b""


@dataclass
class Cycle:
    cycle: int = 0
    start: bool = False
    now: int = 0
    samples: list[Sample] = field(default_factory=list)
    messages: list[TeamMessage] = field(default_factory=list)
    pictures: list[ComePicture] = field(default_factory=list)


@dataclass
class Goodbye:
    pass


_sample = message_reader(Sample, {1: ("time", signed), 2: ("samples", int), 3: ("values", doubles)})
_format = message_reader(PictureFormat, {1: ("width", int), 2: ("height", int), 3: ("format", text), 4: ("period", float)})
_message = message_reader(TeamMessage, {1: ("content", bytes), 2: ("sender", text), 3: ("sent", signed)})
_picture = message_reader(ComePicture, {1: ("picture", int), 2: ("time", signed), 3: ("number", int), 4: ("content", bytes)})

_READERS = {
    1: (Welcome, {1: ("robot", text), 2: ("team", text), 3: ("model", text), 4: ("period", float), 5: ("seed", int),
                  6: ("lock_step", bool)}),
    2: (Refusal, {1: ("reason", text)}),
    3: (Description, {1: ("labels", text, EACH), 2: ("values", doubles), 3: ("picture", _format)}),
    4: (Cycle, {1: ("cycle", int), 2: ("start", bool), 3: ("now", signed), 4: ("samples", _sample, EACH),
                5: ("messages", _message, EACH), 6: ("pictures", _picture, EACH)}),
    5: (Goodbye, {}),
}


def from_simulator(content):
    """Throws WireError if it is no message of the simulator."""
    return one_of(_READERS, content)

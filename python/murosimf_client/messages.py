"""The messages of murosimf/wire/robot_protocol.proto: what a client sends as bytes, what the simulator sends as values."""

from dataclasses import dataclass, field

from .wire import WireError, doubles, field_bytes, field_double, field_doubles, field_varint, fields, signed

VERSION = 1


def hello(robot, rate, software):
    inner = field_varint(1, VERSION) + field_bytes(2, robot) + field_double(3, rate) + field_bytes(4, software)
    return field_bytes(1, inner)


def ask(name, for_signal):
    return field_bytes(2, field_bytes(1 if for_signal else 2, name))


def ready():
    return field_bytes(3, b"")


def commands(cycle, rows, says):
    inner = field_varint(1, cycle)
    inner += b"".join(field_bytes(2, field_doubles(1, row)) for row in rows)
    inner += b"".join(field_bytes(3, line) for line in says)
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
class Description:
    labels: list[str] = field(default_factory=list)
    values: list[float] = field(default_factory=list)


@dataclass
class Sample:
    time: int = 0
    samples: int = 0
    values: list[float] = field(default_factory=list)


@dataclass
class Cycle:
    cycle: int = 0
    start: bool = False
    now: int = 0
    samples: list[Sample] = field(default_factory=list)


@dataclass
class Goodbye:
    pass


def _text(content):
    return content.decode(errors="replace")


def _sample(content):
    sample = Sample()
    for number, value in fields(content):
        if number == 1:
            sample.time = signed(value)
        elif number == 2:
            sample.samples = value
        elif number == 3:
            sample.values = doubles(value)
    return sample


# How each field is read; lists take one value per field, others the last.
_READERS = {
    1: (Welcome, {1: ("robot", _text), 2: ("team", _text), 3: ("model", _text), 4: ("period", float), 5: ("seed", int),
                  6: ("lock_step", bool)}),
    2: (Refusal, {1: ("reason", _text)}),
    3: (Description, {1: ("labels", _text), 2: ("values", doubles)}),
    4: (Cycle, {1: ("cycle", int), 2: ("start", bool), 3: ("now", signed), 4: ("samples", _sample)}),
    5: (Goodbye, {}),
}


def from_simulator(content):
    """Throws WireError if it is no message of the simulator."""
    message = None
    for kind, inner in fields(content):
        if kind not in _READERS or not isinstance(inner, bytes):
            continue
        make, readers = _READERS[kind]
        message = make()
        for number, value in fields(inner):
            if number not in readers:
                continue
            name, read = readers[number]
            if name in ("labels", "samples"):
                getattr(message, name).append(read(value))
            else:
                setattr(message, name, read(value))
    if message is None:
        raise WireError("the simulator sends an empty message")
    return message

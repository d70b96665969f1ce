"""Messages of protocol buffers as values of dataclasses."""

from .wire import WireError, fields

EACH = True  # a repeated field: a list that takes one value per field; others take the last


def text(content):
    return content.decode(errors="replace")


def read_message(make, readers, content):
    """`readers`: number of a field -> (name, reader), or (name, reader, EACH); other fields are skipped."""
    message = make()
    for number, value in fields(content):
        if number not in readers:
            continue
        name, read, *repeated = readers[number]
        if repeated:
            getattr(message, name).append(read(value))
        else:
            setattr(message, name, read(value))
    return message


def message_reader(make, readers):
    return lambda content: read_message(make, readers, content)


def one_of(kinds, content):
    """The message of a oneof. `kinds`: number of a field -> (make, readers). Throws WireError if there is none."""
    message = None
    for kind, inner in fields(content):
        if kind in kinds and isinstance(inner, bytes):
            message = read_message(*kinds[kind], inner)
    if message is None:
        raise WireError("the simulator sends an empty message")
    return message

"""As much of the encoding of protocol buffers as murosimf/network/robot_protocol.proto needs.

Code that protoc generates hangs on the version of a library; these lines hang on nothing.
Source: the specification of the encoding, protobuf.dev/programming-guides/encoding.
"""

import struct

VARINT, FIXED64, BYTES, FIXED32 = 0, 1, 2, 5


class WireError(ValueError):
    """These bytes are no message."""


def varint(number):
    """An unsigned number of at most 64 bits; negative ones as their complement of two."""
    number &= 0xFFFFFFFFFFFFFFFF
    encoded = bytearray()
    while number > 0x7F:
        encoded.append(number & 0x7F | 0x80)
        number >>= 7
    encoded.append(number)
    return bytes(encoded)


def field_varint(field, number):
    return varint(field << 3 | VARINT) + varint(number)


def field_double(field, number):
    return varint(field << 3 | FIXED64) + struct.pack("<d", number)


def field_bytes(field, content):
    """Bytes, a text or an inner message."""
    content = content.encode() if isinstance(content, str) else content
    return varint(field << 3 | BYTES) + varint(len(content)) + content


def field_doubles(field, numbers):
    """Repeated doubles, packed."""
    return field_bytes(field, struct.pack(f"<{len(numbers)}d", *numbers)) if len(numbers) else b""


def read_varint(message, at):
    """The number, and where the next byte is."""
    number = shift = 0
    while True:
        if at >= len(message) or shift > 63:
            raise WireError("a number does not end")
        byte = message[at]
        at += 1
        number |= (byte & 0x7F) << shift
        if byte < 0x80:
            return number & 0xFFFFFFFFFFFFFFFF, at
        shift += 7


def fields(message):
    """Yields (field, value) of a message: int, float, or bytes of what has a length."""
    at = 0
    while at < len(message):
        key, at = read_varint(message, at)
        kind = key & 7
        if kind == VARINT:
            value, at = read_varint(message, at)
        elif kind in (FIXED64, FIXED32):
            end = at + (8 if kind == FIXED64 else 4)
            if end > len(message):
                raise WireError("a message ends early")
            value = struct.unpack_from("<d" if kind == FIXED64 else "<f", message, at)[0]
            at = end
        elif kind == BYTES:
            length, at = read_varint(message, at)
            if length > len(message) - at:
                raise WireError("a message ends early")
            value = bytes(message[at : at + length])
            at += length
        else:
            raise WireError(f"unknown encoding {kind}")
        yield key >> 3, value


def doubles(content):
    """What field_doubles packs."""
    if len(content) % 8:
        raise WireError("a row of numbers ends early")
    return list(struct.unpack(f"<{len(content) // 8}d", content))


def signed(number):
    """A varint as int64."""
    return number - (1 << 64) if number >> 63 else number

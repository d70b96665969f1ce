"""Contacts and rays as Python has them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._values import Array


class RayHit(NamedTuple):
    """What a ray meets first."""

    entity: str
    object: str
    distance: float  #: [m] from the ray's origin
    position: Array  #: (3,) [m] world
    normal: Array  #: (3,) unit, outwards, world


def hit_of(found: tuple[str, str, float, tuple[float, float, float], tuple[float, float, float]] | None) -> RayHit | None:
    if found is None:
        return None
    entity, thing, distance, position, normal = found
    return RayHit(entity, thing, distance, np.array(position), np.array(normal))


def contact_table(names: list[tuple[str, str, str, str]], numbers: Array) -> NDArray[np.void]:
    width = max((len(name) for row in names for name in row), default=1)
    text = f"U{width}"
    table = np.empty(len(names), dtype=[("a", text), ("a_object", text), ("b", text), ("b_object", text), ("position", "f8", 3),
                                        ("normal", "f8", 3), ("force", "f8", 3), ("depth", "f8")])
    for place, name in enumerate(("a", "a_object", "b", "b_object")):
        table[name] = [row[place] for row in names]
    for place, name in enumerate(("position", "normal", "force")):
        table[name] = numbers[:, 3 * place : 3 * place + 3]
    table["depth"] = numbers[:, 9]
    return table

"""Pictures without a graphics driver: a ray for each pixel, which shows the shapes that collide."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import Scene as CoreScene
from ._values import Array, triple
from .picture import Picture

SKY = (214, 226, 240)
FIELD = (86, 140, 74)
GOAL = np.array([235.0, 235.0, 235.0])
COLORS = ((64, 110, 200), (205, 70, 60), (235, 160, 50), (130, 90, 170), (80, 170, 170))  #: of groups: blue1 and blue2 are one
LIGHT = np.array([0.3, -0.5, 0.81])


def _directions(eye: Array, look_at: Array, field_of_view: float, width: int, height: int) -> Array:
    """(height, width, 3), of any length"""
    ahead = (look_at - eye) / np.linalg.norm(look_at - eye)
    right = np.array((ahead[1], -ahead[0], 0.0)) / np.hypot(ahead[0], ahead[1])
    reach = np.tan(field_of_view / 2)
    x = reach * (np.linspace(1, 2 * width - 1, width) / width - 1)
    y = reach * (np.linspace(1, 2 * height - 1, height) - height) / width
    rays: Array = ahead + x[None, :, None] * right + y[:, None, None] * np.cross(ahead, right)
    return rays


def _colors(entities: list[str]) -> dict[str, NDArray[np.float64]]:
    groups = list(dict.fromkeys(name.rstrip("0123456789") for name in entities if name not in ("field", "ball")))
    colors = {name: COLORS[groups.index(name.rstrip("0123456789")) % len(COLORS)]
              for name in entities if name not in ("field", "ball")}
    return {name: np.array(color, dtype=float) for name, color in {**colors, "field": FIELD, "ball": (250, 250, 250)}.items()}


def ray_picture(core: CoreScene, eye: ArrayLike, look_at: ArrayLike, field_of_view: float, width: int, height: int) -> Picture:
    """As Scene.picture, 20 us a pixel."""
    place, goal = triple(eye, "an eye"), triple(look_at, "look_at")
    rays = _directions(np.array(place), np.array(goal), field_of_view, width, height)
    colors = _colors(core.entities())
    rgb = np.empty((height, width, 3), np.uint8)
    rgb[:] = SKY
    for row, column in np.ndindex(height, width):
        x, y, z = rays[row, column].tolist()
        hit = core.cast(place, (x, y, z), float("inf"), "")
        if hit is not None:
            light = 0.45 + 0.55 * max(0.0, float(LIGHT @ hit[4]))
            is_plain = hit[0] != "field" or hit[4][2] > 0.9
            rgb[row, column] = light * (colors[hit[0]] if is_plain else GOAL)
    return Picture(rgb, None, None, None)

"""Pictures as arrays, and as PNG files."""

from __future__ import annotations

import struct
import zlib
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import InputError


def png(rgb: NDArray[np.uint8]) -> bytes:
    """(height, width, 3) as a PNG file (W3C Recommendation Portable Network Graphics, 2003): one IDAT chunk, no filters."""
    height, width, _ = rgb.shape

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = np.zeros((height, 1 + 3 * width), np.uint8)
    rows[:, 1:] = rgb.reshape(height, 3 * width)
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)) + chunk(b"IEND", b"")


class Picture:
    """Layers are None where the camera is without them. NumPy and notebooks take a picture as it is."""

    def __init__(self, rgb: NDArray[np.uint8] | None, mosaic: NDArray[np.uint8] | None, depth: NDArray[np.float32] | None,
                 labels: NDArray[np.uint16] | None, names: list[str] | None = None) -> None:
        self._rgb = rgb
        self.mosaic = mosaic  #: (height, width) behind a Bayer filter
        self.depth = depth  #: (height, width) [m] along the optical axis, infinite where nothing is
        self.labels = labels  #: (height, width) what is seen, numbers of `names`
        self.names = names or []  #: what the numbers of `labels` mean

    @property
    def rgb(self) -> NDArray[np.uint8]:
        """(height, width, 3) sRGB, from the top left. Raises InputError if there are no colors."""
        if self._rgb is None:
            raise InputError("this picture is without colors")
        return self._rgb

    @property
    def height(self) -> int:
        """[px]"""
        return self._size()[0]

    @property
    def width(self) -> int:
        """[px]"""
        return self._size()[1]

    def save(self, file: str | PathLike[str]) -> None:
        """Colors as a PNG file."""
        Path(file).write_bytes(self._repr_png_())

    def _size(self) -> tuple[int, int]:
        for layer in (self._rgb, self.mosaic, self.depth, self.labels):
            if layer is not None:
                return layer.shape[0], layer.shape[1]
        return 0, 0

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.rgb, dtype=dtype, copy=copy) if copy is not None else np.asarray(self.rgb, dtype=dtype)

    def _repr_png_(self) -> bytes:
        return png(self.rgb)

    def __repr__(self) -> str:
        layers = {"rgb": self._rgb, "mosaic": self.mosaic, "depth": self.depth, "labels": self.labels}
        there = [name for name, layer in layers.items() if layer is not None]
        return f"picture of {self.width} x {self.height} pixels: {', '.join(there) or 'empty'}"

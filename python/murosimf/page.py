"""The page on which browsers see a scene, and steer it between the calls of a script."""

from __future__ import annotations

from html import escape

from ._core import Scene as CoreScene


class Page:
    """Of `scene.show()`. A notebook shows its link."""

    def __init__(self, core: CoreScene, address: str) -> None:
        self._core = core
        self.address = address  #: "http://127.0.0.1:40123/"; this computer alone is let in

    def close(self) -> None:
        """The scene goes on without it."""
        self._core.hide()

    def __repr__(self) -> str:
        return self.address

    def _repr_html_(self) -> str:
        return f'<a href="{escape(self.address)}" target="_blank">{escape(self.address)}</a>'

"""Packages that only some calls need."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from .errors import StateError


def optional(module: str, extra: str) -> Any:
    """Raises StateError, which says how it is installed."""
    try:
        return import_module(module)
    except ImportError as error:
        raise StateError(f"this needs {module.partition('.')[0]}: pip install 'murosimf[{extra}]'") from error

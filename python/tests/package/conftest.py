"""Tests of the package `murosimf`, installed or of PYTHONPATH=build/release/python: python -m pytest python/tests/package."""

from pathlib import Path

import pytest

import murosimf as ms


@pytest.fixture
def scene() -> ms.Scene:
    """A robot without controller."""
    return ms.Scene.of_robot("kid21")


@pytest.fixture
def root() -> Path:
    """Of the source tree."""
    return Path(__file__).resolve().parents[3]

"""What users give as the core takes it: triples, rows of joints, assignments of `--set`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import InputError, UnknownName

Array: TypeAlias = NDArray[np.float64]
Triple: TypeAlias = tuple[float, float, float]
Quadruple: TypeAlias = tuple[float, float, float, float]
#: PATH=VALUE texts, or {"PATH": value}
Assignments: TypeAlias = Mapping[str, Any] | Iterable[str]


def numbers(values: ArrayLike) -> Array:
    """As one array of double precision, one after the other."""
    try:
        return np.ascontiguousarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"numbers are needed, not {str(values)[:60]!r}") from None


def triple(values: ArrayLike, what: str) -> Triple:
    row = numbers(values)
    if row.shape != (3,):
        raise InputError(f"{what} takes 3 numbers, not an array of shape {row.shape}")
    return float(row[0]), float(row[1]), float(row[2])


def quadruple(values: ArrayLike, what: str) -> Quadruple:
    row = numbers(values)
    if row.shape != (4,):
        raise InputError(f"{what} takes 4 numbers, not an array of shape {row.shape}")
    return float(row[0]), float(row[1]), float(row[2]), float(row[3])


def value_text(value: Any) -> str:
    """As it stands behind the = of `--set`."""
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, np.ndarray):
        return value_text(value.tolist())
    if isinstance(value, Sequence):
        return "[" + ", ".join(value_text(item) for item in value) + "]"
    if isinstance(value, np.generic):
        return repr(value.item())
    return repr(value)


def texts(given: str | Iterable[str], what: str) -> list[str]:
    """One, or several."""
    if isinstance(given, str):
        return [given]
    several = list(given) if isinstance(given, Iterable) else [given]
    for each in several:
        if not isinstance(each, str):
            raise InputError(f"{what}, not {each!r}")
    return several


def assignments(given: Assignments) -> list[str]:
    if isinstance(given, Mapping):
        return [f"{path}={value_text(value)}" for path, value in given.items()]
    return texts(given, "a setting is 'PATH=VALUE' or {'PATH': value}")


def timed_assignments(given: Mapping[float, Assignments] | Iterable[str]) -> list[str]:
    """TIME:PATH=VALUE of texts, or of {time: assignments}."""
    if isinstance(given, Mapping):
        return [f"{float(time)!r}:{each}" for time, several in given.items() for each in assignments(several)]
    return texts(given, "an event is 'TIME:PATH=VALUE' or {time: {'PATH': value}}")


def nearest(name: str, known: list[str], what: str) -> UnknownName:
    """Says what was meant, as the library does."""
    import difflib  # it takes milliseconds to import

    close = difflib.get_close_matches(name, known, 1)
    hint = f"; did you mean '{close[0]}'?" if close else f"; known: {', '.join(known[:12])}{', ...' if len(known) > 12 else ''}"
    return UnknownName(f"unknown {what} '{name}'{hint}")

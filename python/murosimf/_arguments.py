"""Wrong arguments of public calls as one line that names the argument: InputError, which is a ValueError, and a TypeError, too.

The core refuses them with a text of several lines about its own signatures. What is wrong is looked for only after a call has
failed.
"""

from __future__ import annotations

import functools
import operator
import os
from collections.abc import Callable, Iterable
from typing import Any, ParamSpec, TypeVar

import numpy as np

from .errors import ArgumentError, Error

P = ParamSpec("P")
R = TypeVar("R")
#: beside public names
ALSO = ("__init__", "__getitem__", "__setitem__")


def _shown(value: object) -> str:
    text = repr(value).split("\n")[0]
    return text if len(text) <= 60 else text[:57] + "..."


def _is_whole(value: object) -> bool:
    try:
        operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        return False
    return True


def _is_number(value: object) -> bool:
    try:
        float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        return False
    return not isinstance(value, str)


def _is_array(value: object) -> bool:
    try:
        np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        return False
    return True


_is_text = (lambda value: isinstance(value, str), "a text")
#: by annotation: whether a value is one, and what it should be
KINDS: dict[str, tuple[Callable[[object], bool], str]] = {
    "int": (_is_whole, "a whole number"),
    "float": (_is_number, "a number"),
    "str": _is_text,
    "Level": _is_text,
    "bool": (lambda value: isinstance(value, bool), "True or False"),
    "bytes": (lambda value: isinstance(value, bytes), "bytes"),
    "ArrayLike": (_is_array, "numbers"),
    "Iterable[str]": (lambda value: isinstance(value, Iterable), "texts"),
    "Iterable[int]": (lambda value: isinstance(value, Iterable), "whole numbers"),
    "PathLike[str]": (lambda value: isinstance(value, os.PathLike), "a file"),
    "None": (lambda value: value is None, "None"),
}


def _kinds(annotation: str) -> list[str]:
    """Empty: something else is allowed, too."""
    kinds = [part.strip() for part in annotation.split("|")]
    return kinds if all(kind in KINDS for kind in kinds) else []


def _wrong_value(name: str, value: object, kinds: list[str], refused: bool) -> str:
    if kinds and not any(KINDS[kind][0](value) for kind in kinds):
        wanted = dict.fromkeys(KINDS[kind][1] for kind in kinds if kind != "None")
        return f"{name} takes {' or '.join(wanted)}, not {_shown(value)}"
    if "int" in kinds and _is_whole(value):
        lowest, highest = (0, 2**64) if name == "seed" else (0 if refused else -(2**31), 2**31)
        if not lowest <= operator.index(value) < highest:  # type: ignore[arg-type]
            return f"{name} is out of range: {_shown(value)}"
    return ""


def _trouble(function: Callable[..., Any], arguments: tuple[Any, ...], named: dict[str, Any], refused: bool) -> str:
    """What is wrong with them, in words; empty: nothing that their kinds tell."""
    import inspect  # it takes milliseconds to import

    signature = inspect.signature(function)
    try:
        given = signature.bind(*arguments, **named).arguments
    except TypeError as error:
        return str(error)
    for name, value in given.items():
        wrong = _wrong_value(name, value, _kinds(str(signature.parameters[name].annotation)), refused)
        if wrong:
            return wrong
    return ""


def checked(function: Callable[P, R]) -> Callable[P, R]:
    """The same function, whose annotations say what is wrong with arguments."""

    @functools.wraps(function)
    def call(*arguments: P.args, **named: P.kwargs) -> R:
        try:
            return function(*arguments, **named)
        except Error:
            raise
        except (TypeError, ValueError, OverflowError) as error:
            refused = "incompatible function arguments" in str(error)  # by the core
            text = _trouble(function, arguments, named, refused)
            if not text and refused:
                text = "takes no " + ", ".join(_shown(value) for value in [*arguments[1:], *named.values()])
            if not text:
                raise
        raise ArgumentError(f"{function.__qualname__}: {text}")

    return call


def check_arguments(cls: type) -> None:
    """All public methods of a class, and what is set by properties."""
    for name, member in list(vars(cls).items()):
        if name.startswith("_") and name not in ALSO:
            continue
        if isinstance(member, property) and member.fset:
            setattr(cls, name, property(member.fget, checked(member.fset), doc=member.__doc__))
        elif isinstance(member, classmethod):
            setattr(cls, name, classmethod(checked(member.__func__)))
        elif callable(member) and hasattr(member, "__qualname__"):
            setattr(cls, name, checked(member))

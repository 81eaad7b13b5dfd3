"""Checks of arguments: their types and ranges, and the messages of what is wrong."""

from __future__ import annotations

import math
import operator
import re
from typing import Any, Dict, Iterable, List, Optional

import numpy as np

_largest = 2**31 - 1


def whole(name: str, value: Any, least: int = 0, largest: int = _largest) -> int:
    try:
        if isinstance(value, bool):
            raise TypeError
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be a whole number, not {value!r}") from None
    if not least <= number <= largest:
        raise ValueError(f"{name} cannot be {number}: it must be from {least} to {largest}")
    return number


def wholes(name: str, values: Any, least: int = 0) -> List[int]:
    """Several of them, or one alone."""
    several: Iterable[Any] = values if np.iterable(values) else [values]
    return [whole(name, value, least) for value in several]


def vertices(name: str, values: Any) -> List[int]:
    """Numbers of vertices; whether the mesh has so many is checked where the mesh is known."""
    return wholes(name, values, -_largest)


def vertex_or_none(name: str, value: Any) -> Optional[int]:
    return None if value is None else whole(name, value, -_largest)


def threads_of(threads: Any) -> int:
    """0 and None mean one thread for each core."""
    return 0 if threads is None else whole("threads", threads)


def real_or_none(name: str, value: Any) -> Optional[float]:
    """A number that is 0 or larger."""
    if value is None:
        return None
    try:
        if isinstance(value, (str, bytes, bool)):
            raise TypeError
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, not {value!r}") from None
    if math.isnan(number) or number < 0:
        raise ValueError(f"{name} cannot be {number}: it must be 0 or larger")
    return number


def length_or_none(name: str, value: Any, diagonal: float = 1.0) -> Optional[float]:
    """A length, or a text: a percentage of the diagonal of the bounding box."""
    if not isinstance(value, str):
        return real_or_none(name, value)
    try:
        share = float(value[:-1]) / 100 if value.endswith("%") else math.nan
    except ValueError:
        share = math.nan
    if not 0 < share < math.inf:
        raise ValueError(
            f"{name} must be a length, such as 0.25, or a percentage of the diagonal of the bounding box, "
            f'such as "3%", not {value!r}'
        )
    if share > 1:
        raise ValueError(
            f"{name} cannot be {value}: it must be at most 100% of the diagonal of the bounding box"
        )
    return share * diagonal


def word(name: str, value: Any, words: Iterable[str] = ()) -> str:
    """One of the words, or any text if there are none."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a string, not {value!r}")
    if words and value not in words:
        *others, last = map(repr, words)
        raise ValueError(f"{name} must be {', '.join(others)} or {last}, not {value!r}")
    return value


_kinds: Dict[str, str] = {"real numbers": "fiu", "integers": "iu"}


def numbers(name: str, values: Any, what: str = "real numbers") -> np.ndarray:
    """An array of them; arrays are not copied."""
    if np.ma.is_masked(values):
        raise TypeError(f"{name} has masked values: fill them, or leave out their rows")
    try:
        array = np.asarray(values)
    except ValueError as reason:  # of lists of different lengths
        raise ValueError(f"{name} is not an array: {reason}") from None
    if array.size > 0 and array.dtype.kind not in _kinds[what]:
        error = ValueError if array.dtype.kind == "f" else TypeError
        raise error(f"{name} must be an array of {what}, not of {array.dtype}")
    return array


def in_words_of_python(line: str) -> str:
    """What the tool says, with the names of parameters."""
    line = re.sub(r"--channels (\S+%)", r'channels="\1"', line)
    line = re.sub(r"(--noise-below) (\S+%)", r'\1 "\2"', line)
    line = re.sub(r"Did you mean (\S+%)", r'Did you mean "\1"', line)
    line = re.sub(r"--noise-below (?=[\"\d])", "noise_below=", line)
    for option, name in (("--noise-below", "noise_below"), ("--genus", "genus"), ("--yes", "force=True")):
        line = line.replace(option, name)
    return line

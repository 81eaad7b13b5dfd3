"""The records of the compiled part, and results made from them, which are compared by content."""

from __future__ import annotations

from typing import Any, Dict

import numpy as np


class Record(Dict[str, Any]):
    """A record with an error that names a missing part, for example after it was changed by hand."""

    def __init__(self, name: str, parts: Dict[str, Any]):
        super().__init__(
            (key, Record(f"{key} of {name}", part) if isinstance(part, dict) else part)
            for key, part in parts.items()
        )
        self._name = name

    def __missing__(self, key: str) -> Any:
        raise ValueError(f"the record of {self._name} is incomplete: it has no {key!r}")


class Comparable:
    """Results are equal if everything in them is: arrays number by number, where NaN equals NaN.

    Results that can be changed have no hash, as usual in Python; the others define one.
    """

    def __eq__(self, other: object) -> Any:
        if type(self) is not type(other):
            return NotImplemented
        return _are_same(self._content(), other._content())  # type: ignore[attr-defined]

    def _content(self) -> Dict[str, Any]:
        return dict(vars(self))


def _are_same(a: Any, b: Any) -> bool:
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return _are_same_arrays(np.asarray(a), np.asarray(b))
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(_are_same(part, b[key]) for key, part in a.items())
    if isinstance(a, (list, tuple)) and type(a) is type(b):
        return len(a) == len(b) and all(map(_are_same, a, b))
    return bool(a == b) or (a != a and b != b)


def _are_same_arrays(a: np.ndarray, b: np.ndarray) -> bool:
    has_nan = a.dtype.kind == b.dtype.kind == "f"
    return a.dtype == b.dtype and np.array_equal(a, b, equal_nan=has_nan)

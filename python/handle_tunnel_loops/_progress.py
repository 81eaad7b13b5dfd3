"""What can be passed as ``progress``."""

from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional


@contextmanager
def told(progress: Any, what: str) -> Iterator[Optional[Callable[[float], Any]]]:
    """The callable that gets a fraction: the given one, or the bar of tqdm for ``True``."""
    if progress is None or progress is False:
        yield None
    elif progress is not True:
        if not callable(progress):
            raise TypeError("progress must be True, None or a callable that takes a number from 0 to 1")
        yield progress
    else:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            yield None
            return
        with tqdm(total=100, desc=what, unit="%", leave=False) as bar:
            yield lambda fraction: _advance(bar, fraction)


def _advance(bar: Any, fraction: float) -> None:
    bar.update(max(0.0, 100 * fraction - bar.n))


def part(callback: Any, begin: float, end: float) -> Any:
    """A callable for a part of a computation that reports to ``callback``."""
    if callback is None:
        return None
    return lambda fraction: callback(begin + (end - begin) * fraction)

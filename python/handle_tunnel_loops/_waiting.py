"""Computations in other threads, so that this one sees Ctrl-C and tells how far they are."""

from __future__ import annotations

import atexit
import os
import threading
from concurrent.futures import Future, wait
from queue import SimpleQueue
from typing import Any, Callable, Dict, List

from . import _core
from ._progress import told

# Threads are kept for what comes next: the allocator of TBB loses some memory with each one that ends.
# What is done with these two is done at once, as Python's own lock has it.
_idle: "List[SimpleQueue[Callable[[], None]]]" = []
_running: "Dict[Future[Any], _core.Watch]" = {}
_is_ending = False

_seconds_between_looks = 0.05
_seconds_to_obey = 1.0
_seconds_to_end = 10.0


def computed(what: str, progress: Any, function: Callable[..., Any], *arguments: Any) -> Any:
    """What a function of the compiled part returns for these arguments and a `Watch`.

    What ``progress`` raises, or Ctrl-C, is raised here, and so is `Interrupted` if it returns False. The
    computation is asked to end then; one that never asks back ends when it is done.
    """
    future: "Future[Any]" = Future()
    watch = _core.Watch()
    with told(progress, what) as callback:
        _begin(lambda: _compute(future, watch, function, *arguments))
        try:
            while not wait([future], _seconds_between_looks).done:
                if callback is not None:
                    _go_on_or_raise(callback(watch.fraction))
        except BaseException:
            watch.stop()
            wait([future], _seconds_to_obey)
            raise
        try:
            answer = future.result()
        finally:
            del future  # an error would know it, and it the error
        if callback is not None:
            callback(1.0)
        return answer


def _go_on_or_raise(answer: Any) -> None:
    if answer is not None and not answer:
        raise _core.Interrupted("interrupted")


def _compute(
    future: "Future[Any]", watch: _core.Watch, function: Callable[..., Any], *arguments: Any
) -> None:
    _running[future] = watch
    try:
        if _is_ending:
            raise _core.Interrupted("Python is about to end")
        answer = function(*arguments, watch)
    except BaseException as error:
        del _running[future]
        future.set_exception(error)
        del future
    else:
        del _running[future]
        future.set_result(answer)


def _begin(compute: Callable[[], None]) -> None:
    try:
        tasks = _idle.pop()
    except IndexError:
        tasks = SimpleQueue()
        try:
            threading.Thread(target=_work, args=(tasks,), daemon=True).start()
        except RuntimeError as error:  # what a thread lacks is memory
            raise MemoryError("there is no memory for a thread") from error
    tasks.put(compute)


def _work(tasks: "SimpleQueue[Callable[[], None]]") -> None:
    while True:
        compute = tasks.get()
        compute()
        del compute  # and with it the arrays
        _idle.append(tasks)


@atexit.register
def _end() -> None:
    """No thread should come back to an interpreter that has ended. Some wait for a file, for ever."""
    global _is_ending
    _is_ending = True
    running = dict(_running)
    for watch in running.values():
        watch.stop()
    wait(running, _seconds_to_end)


def _forget() -> None:
    """In a process that was forked: the threads are not there."""
    _idle.clear()
    _running.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)

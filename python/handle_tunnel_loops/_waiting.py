"""Computations in other threads, so that this thread sees Ctrl-C and can report the progress."""

from __future__ import annotations

import atexit
import os
import threading
from concurrent.futures import Future, wait
from queue import SimpleQueue
from typing import Any, Callable, Dict, List, Tuple

from . import _core
from ._progress import told

# Threads are kept for the next computation: the allocator of TBB loses some memory with each that ends.
# Each operation on these two is atomic, thanks to Python's own lock.
_Task = Tuple["Future[Any]", _core.Watch, Callable[..., Any], Tuple[Any, ...]]
_idle: "List[SimpleQueue[_Task]]" = []
_running: "Dict[Future[Any], _core.Watch]" = {}
_is_ending = False

_seconds_between_looks = 0.05
_seconds_to_obey = 1.0
_seconds_to_end = 10.0


def computed(what: str, progress: Any, function: Callable[..., Any], *arguments: Any) -> Any:
    """Calls a function of the compiled part with these arguments and a `Watch`, and returns its result.

    Raises what ``progress`` raises, or Ctrl-C, and `Interrupted` if it returns False. The computation is then
    asked to stop; one that does not check for that ends when it is done.
    """
    future: "Future[Any]" = Future()
    watch = _core.Watch()
    with told(progress, what) as callback:
        _begin((future, watch, function, arguments))
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
            del future  # as below
        if callback is not None:
            callback(1.0)
        return answer


def _go_on_or_raise(answer: Any) -> None:
    if answer is not None and not answer:
        raise _core.Interrupted("interrupted")


def _begin(task: "_Task") -> None:
    try:
        tasks = _idle.pop()
    except IndexError:
        tasks = SimpleQueue()
        try:
            threading.Thread(target=_work, args=(tasks,), daemon=True).start()
        except RuntimeError as error:  # the usual reason is memory
            raise MemoryError("not enough memory to start a thread") from error
    tasks.put(task)


def _work(tasks: "SimpleQueue[_Task]") -> None:
    while True:
        _compute(tasks, *tasks.get())


def _compute(
    tasks: "SimpleQueue[_Task]",
    future: "Future[Any]",
    watch: _core.Watch,
    function: Callable[..., Any],
    arguments: Tuple[Any, ...],
) -> None:
    _running[future] = watch
    try:
        if _is_ending:
            raise _core.Interrupted("Python is about to exit")
        answer = function(*arguments, watch)
    except BaseException as error:
        _finish(tasks, future)
        future.set_exception(error)
    else:
        _finish(tasks, future)
        future.set_result(answer)
    finally:
        del future  # it and the error would refer to each other


def _finish(tasks: "SimpleQueue[_Task]", future: "Future[Any]") -> None:
    """Before the result is set, so that the next call finds this thread idle."""
    del _running[future]
    _idle.append(tasks)


@atexit.register
def _end() -> None:
    """No thread may return to an interpreter that has ended. Some wait for a file forever."""
    global _is_ending
    _is_ending = True
    running = dict(_running)
    for watch in running.values():
        watch.stop()
    wait(running, _seconds_to_end)


def _forget() -> None:
    """In a forked process, which does not have the threads."""
    _idle.clear()
    _running.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)

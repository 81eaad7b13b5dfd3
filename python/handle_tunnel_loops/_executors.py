"""Who computes the rows of a survey."""

from __future__ import annotations

import concurrent.futures as futures_of_python
import itertools
import os
import sys
from typing import Any, Callable, Dict, Generator, Iterator, List, Set

from ._table import COLUMNS, Row

Compute = Callable[[str], Row]
Rows = Generator[Row, None, None]

# Enough to keep any cluster busy, few enough to keep in mind.
_most_in_flight = 1000


def check(executor: Any, has_memory_limit: bool) -> None:
    """Whether there is a way to ask it, and none of its workers shares a limit with another one."""
    if executor is None:
        return
    if isinstance(executor, int) and not isinstance(executor, bool):
        if executor < 1:
            raise ValueError(f"executor cannot be {executor}: it is a number of processes")
        return
    distributed = sys.modules.get("distributed")
    client: Any = executor  # of Dask, perhaps
    is_of_dask = distributed is not None and isinstance(executor, distributed.Client)
    if not is_of_dask and not isinstance(executor, futures_of_python.Executor):
        raise TypeError(
            "executor is a number of processes, a concurrent.futures.Executor "
            "or a dask.distributed.Client"
        )
    has_threads = (
        any(number > 1 for number in client.nthreads().values())
        if is_of_dask
        else isinstance(executor, futures_of_python.ThreadPoolExecutor)
    )
    if has_memory_limit and has_threads:
        raise ValueError(
            "memory is what a whole process may have: executor has to be of processes "
            "that do one mesh at a time, not of threads"
        )


def rows_of(paths: List[str], compute: Compute, executor: Any) -> Rows:
    if executor is None:
        return (compute(path) for path in paths)
    if isinstance(executor, int):
        return _rows_of_processes(iter(paths), compute, executor)
    return _rows_of_executor(iter(paths), compute, executor)


def _rows_of_executor(paths: Iterator[str], compute: Compute, executor: Any) -> Rows:
    try:
        yield from _rows(paths, compute, executor, {}, _most_in_flight)
    except futures_of_python.BrokenExecutor as error:
        raise futures_of_python.BrokenExecutor(
            "a worker of the executor was killed, perhaps for want of memory, and the executor does "
            "nothing more. The rows that are in the file are kept: call survey() again, with a new "
            "executor, to go on. With a number of processes as executor, survey() replaces them itself."
        ) from error


def _rows_of_processes(paths: Iterator[str], compute: Compute, number: int) -> Rows:
    """By processes of our own. What is done when one of them is killed is done again, alone."""
    is_first = True
    while True:
        in_flight: Dict[Any, str] = {}
        with _processes(number) as pool:
            try:
                if is_first:
                    _try_out(pool)
                yield from _rows(paths, compute, pool, in_flight, 2 * number)
                return
            except futures_of_python.BrokenExecutor:
                is_first = False
        for path in in_flight.values():
            with _processes(1) as pool:
                future = pool.submit(compute, path)
                yield _failed(path, future) if future.exception() else future.result()


def _processes(number: int) -> futures_of_python.ProcessPoolExecutor:
    # Here, as programs that run Python within them, as Blender does, may not stand that it is imported.
    import multiprocessing

    # A fork would lack the threads that compute.
    context = multiprocessing.get_context("spawn")
    return futures_of_python.ProcessPoolExecutor(number, mp_context=context)


def _try_out(pool: futures_of_python.ProcessPoolExecutor) -> None:
    try:
        pool.submit(os.getpid).result()
    except futures_of_python.BrokenExecutor as error:
        raise RuntimeError(
            "no process begins to work; the part of a script that calls survey() "
            'has to be under  if __name__ == "__main__":'
        ) from error


def _rows(
    paths: Iterator[str], compute: Compute, executor: Any, in_flight: Dict[Any, str], most: int
) -> Rows:
    """What is in flight when nothing more can be asked of the executor is left there."""
    try:
        while True:
            for path in itertools.islice(paths, most - len(in_flight)):
                in_flight[_submitted(executor, compute, path)] = path
            if not in_flight:
                return
            # What is there is kept, even if something else has gone wrong.
            done = _first_done(executor, set(in_flight))
            for future in sorted(done, key=lambda future: future.exception() is not None):
                error = future.exception()
                if isinstance(error, futures_of_python.BrokenExecutor):
                    raise error
                path = in_flight.pop(future)
                yield _failed(path, future) if error else future.result()
    finally:
        for future in in_flight:
            future.cancel()


def _submitted(executor: Any, compute: Compute, path: str) -> Any:
    try:
        if isinstance(executor, futures_of_python.Executor):
            return executor.submit(compute, path)
        # Dask gives a task whose worker has ended to another one.
        return executor.submit(compute, path, pure=False)
    except futures_of_python.BrokenExecutor as error:
        future: "futures_of_python.Future[Row]" = futures_of_python.Future()
        future.set_exception(error)
        return future


def _first_done(executor: Any, futures: Set[Any]) -> Set[Any]:
    if isinstance(executor, futures_of_python.Executor):
        return futures_of_python.wait(futures, return_when="FIRST_COMPLETED").done
    return set(sys.modules["distributed"].wait(futures, return_when="FIRST_COMPLETED").done)


def _failed(path: str, future: Any) -> Row:
    row: Row = dict.fromkeys(COLUMNS)
    row["mesh"] = path
    row["error"] = f"its worker ended: {future.exception()}"
    return row

"""The executors that compute the rows of a survey."""

from __future__ import annotations

import concurrent.futures as futures_of_python
import itertools
import os
import sys
from typing import Any, Callable, Dict, Generator, Iterator, List, Set

from ._table import COLUMNS, Row

Compute = Callable[[str], Row]
Rows = Generator[Row, None, None]

# Enough to keep any cluster busy, few enough for the memory.
_most_in_flight = 1000


def check(executor: Any, has_memory_limit: bool) -> None:
    """Refuses what cannot run tasks, and workers that would share a memory limit."""
    if executor is None:
        return
    if isinstance(executor, int) and not isinstance(executor, bool):
        if executor < 1:
            raise ValueError(f"executor cannot be {executor}: the number of processes must be at least 1")
        return
    distributed = sys.modules.get("distributed")
    client: Any = executor  # of Dask, perhaps
    is_of_dask = distributed is not None and isinstance(executor, distributed.Client)
    if not is_of_dask and not isinstance(executor, futures_of_python.Executor):
        raise TypeError(
            "executor must be a number of processes, a concurrent.futures.Executor "
            "or a dask.distributed.Client"
        )
    has_threads = (
        any(number > 1 for number in client.nthreads().values())
        if is_of_dask
        else isinstance(executor, futures_of_python.ThreadPoolExecutor)
    )
    if has_memory_limit and has_threads:
        raise ValueError(
            "memory limits a whole process, so the executor must use processes "
            "that compute one mesh at a time, not threads"
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
            "a worker of the executor was killed, perhaps because memory ran out, and the executor cannot "
            "continue. The rows in the file are kept: to continue, call survey() again with a new executor. "
            "If executor is a number of processes, survey() replaces killed processes itself."
        ) from error


def _rows_of_processes(paths: Iterator[str], compute: Compute, number: int) -> Rows:
    """In processes of our own. If one is killed, the meshes in flight are computed again, one at a time."""
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
    # Here, because programs that embed Python, such as Blender, may fail when it is imported.
    import multiprocessing

    # A fork would lack the threads that compute.
    context = multiprocessing.get_context("spawn")
    return futures_of_python.ProcessPoolExecutor(number, mp_context=context)


def _try_out(pool: futures_of_python.ProcessPoolExecutor) -> None:
    try:
        pool.submit(os.getpid).result()
    except futures_of_python.BrokenExecutor as error:
        raise RuntimeError(
            "the processes do not start; in a script, the call of survey() "
            'must be under  if __name__ == "__main__":'
        ) from error


def _rows(
    paths: Iterator[str], compute: Compute, executor: Any, in_flight: Dict[Any, str], most: int
) -> Rows:
    """If the executor breaks, what is in flight remains in the dictionary."""
    try:
        while True:
            for path in itertools.islice(paths, most - len(in_flight)):
                in_flight[_submitted(executor, compute, path)] = path
            if not in_flight:
                return
            # Rows that are done are kept, even if another task failed.
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
        # If a worker of Dask ends, Dask gives its task to another one.
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
    row["error"] = f"its worker process ended: {future.exception()}"
    return row
